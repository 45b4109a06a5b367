# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts in the user's language.

Texts in the source are English. ``tr`` translates one where it is shown. A text that is written in
a table, long before it is shown, is wrapped in ``mark``, so that it is found, and goes through
``tr`` later. Parts are filled in after the translation, by ``str.format`` with named fields.

Some texts are found by where they stand, without a mark: menu texts and tool tips of commands,
labels of options, and the descriptions of properties. FreeCAD translates menu texts and
descriptions itself, so it is given the English ones. ``tools/translations`` collects all texts.
"""

#: The context of the texts in the files of translations, and that of descriptions of properties.
CONTEXT, PROPERTIES = "Seamwright", "App::Property"


def _english(context, text):
    return text


#: Called with context and text. With FreeCAD it is FreeCAD's function, see ``document``.
translate = _english


def tr(text):
    """Return a text in the user's language, or as it is where it has no translation."""
    return translate(CONTEXT, text)


def mark(text):
    """Return the text as it is; it is translated later."""
    return text


def description(text):
    """Return the description of a property in the user's language."""
    return translate(PROPERTIES, text)


def inside(title):
    """Return a title as it is written inside a sentence; an English one in small letters."""
    shown = tr(title)
    return title.lower() if shown == title else shown
