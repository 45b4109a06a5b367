# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection, as links of document objects: the rule that all commands follow."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.plain.language import tr


def picked():
    """Return [(object, "Edge3" or ""), ...] of the selection, in the order of picking.

    A group or part that is selected as a whole counts as its contents. Raises SourceError for a
    mesh, for what else has no shape, and for an object of another document beside others.
    """
    found = []
    for obj, name in _selected():
        whole = sources.expand([obj]) if not name else []
        found += [(each, "") for each in whole] or [(obj, name)]
    for obj, _ in found:
        sources.check_kind(obj)
    return list(dict.fromkeys(found))


def picked_objects():
    """Return the objects of the selection without repeats; a group or part stays what it is.

    Raises SourceError for an object of another document beside others.
    """
    return list(dict.fromkeys(obj for obj, _ in _selected()))


def picked_on(objects):
    """Return the names of the elements that are selected on some of the objects."""
    return [name for obj, name in _every() if name and obj in objects]


def _every():
    return [
        owner_of(each.Object, each.SubElementNames[0])
        for each in Gui.Selection.getCompleteSelection(0)
    ]


def _selected():
    """Return what is selected in the active document, where alone it is seen.

    Raises SourceError if objects of another document are selected beside it.
    """
    found = _every()
    own = [(obj, name) for obj, name in found if obj.Document == App.ActiveDocument]
    for obj, _ in found:
        if own and obj.Document != App.ActiveDocument:
            raise sources.SourceError(
                tr(
                    "{label} is in another document, {document}: select objects of one document."
                ).format(label=obj.Label, document=obj.Document.Label)
            )
    return own


def owner_of(top, path):
    """Return (object, "Edge3" or "") of what FreeCAD selects by a path such as "Part.Box.Edge3".

    What is picked in a link to a part belongs to the link, which has its own position. What is
    picked on the last step of a body belongs to the body, which goes on with later steps.
    """
    owner, names = top, path.split(".")
    for place, name in enumerate(names[:-1]):
        if owner.hasExtension("App::LinkBaseExtension"):
            rest = ".".join(names[place:])
            return owner, sources.element_of_link(owner, rest) if names[-1] else ""
        owner = owner.Document.getObject(name) or owner  # newer names of elements are no objects
    return _whole_body(owner), names[-1]


def _whole_body(obj):
    """Return the body of its last step, which has the same elements; else the object itself."""
    body = obj.getParentGeoFeatureGroup() if sources.in_body(obj) else None
    return body if body is not None and body.Tip == obj else obj
