# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of texts that can be read on the light and on the dark styles of FreeCAD."""

from freecad.seamwright.gui.widgets.qt import QtGui

GOOD, BAD, WRONG = "good", "bad", "wrong"

#: (on light ground, on dark ground) of what is reached, of what is not, and of a bad input.
INKS = {
    GOOD: ((0, 120, 88), (80, 200, 160)),
    BAD: ((190, 80, 0), (245, 150, 80)),
    WRONG: ((176, 48, 32), (255, 130, 110)),
}

#: Texts that are lighter than this, 0 to 255, stand on dark ground.
LIGHT = 115


def ink(kind, widget):
    """Return the QColor of a kind of text in a widget."""
    widget.ensurePolished()
    text = widget.palette().color(QtGui.QPalette.Text)
    return QtGui.QColor(*INKS[kind][text.lightness() > LIGHT])


def style(kind, widget):
    """Return the style sheet that gives a widget the colour of a kind of text."""
    return "color: %s" % ink(kind, widget).name()
