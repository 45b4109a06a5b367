# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of a spline by clicks in the view."""

import numpy

from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.scene.snap import Snapper
from freecad.seamwright.gui.widgets.qt import QtCore
from freecad.seamwright.plain.spline_handles import nearest

#: A button that is released further away than this was no click, in pixels.
CLICK_PX = 4

#: Pixels around the first point, a click within which closes the spline.
CLOSE_PX = 9

#: Points nearer to each other than this are one.
SAME_MM = 1e-7


class PointPicker:
    """Adds a point with each click; the editor draws the spline through them and the mouse.

    A click on the first of three points or more closes the spline. Backspace removes the last
    point, Enter ends, Esc takes everything back.
    """

    CURSOR = QtCore.Qt.CrossCursor

    def __init__(self, editor, points, links, ended):
        """``links``: for each point (object, "Vertex3"), or None where it is no vertex.

        ``ended(kept, points, links, closed)`` is called when the user ends.
        """
        self.points = [tuple(each) for each in points]
        self._links = list(links)
        self._editor, self._ended = editor, ended
        self._snapper = Snapper(editor.obj.Document, editor.obj)
        self._pressed = None
        self._removed = []
        self.show(None)

    def press(self, pixel):
        """Remember where the button went down."""
        self._pressed = pixel
        return True

    def move(self, pixel, held):
        """Draw the spline with the point at the mouse."""
        snap = self._at(pixel)
        self._editor.drawing.show_snap(snap.point)
        self.show(snap.point, snap.what)
        return held

    def release(self, pixel):
        """Add the point at which the button was clicked."""
        pressed, self._pressed = self._pressed, None
        if pressed is None or numpy.abs(numpy.subtract(pressed, pixel)).max() > CLICK_PX:
            return
        if self._closes(pixel):
            self.end(True, closed=True)
            return
        snap = self._at(pixel)
        if snap.point is None or (self.points and _same(snap.point, self.points[-1])):
            return
        self._add(tuple(map(float, snap.point)), self._usable(snap.link))
        self._removed = []
        self.show(None, snap.what)

    def key(self, name):
        """Change the points as a key says."""
        if name in ("backspace", "undo") and self.points:
            self._removed.append((self.points.pop(), self._links.pop()))
        elif name == "redo" and self._removed:
            self._add(*self._removed.pop())
        elif name in ("enter", "escape"):
            self.end(name == "enter")
            return
        self.show(None)

    def end(self, kept, closed=False):
        """End picking; ``kept``: the points are used."""
        self._editor.end_pick()
        self._ended(kept, self.points, self._links, closed)

    def show(self, hovered, what=""):
        """Draw the spline, and say what is picked."""
        points = list(self.points)
        if hovered is not None and not (points and _same(hovered, points[-1])):
            points.append(tuple(map(float, hovered)))
        panel = self._editor.panel
        try:
            values = panel.values_with(points)
        except ValueError:  # a text of the panel is no list of numbers
            return
        self._editor.drawing.show_picked(points, values)
        panel.box.say_picked(len(self.points), points[-1] if points else None, what)

    def _add(self, point, link):
        self.points.append(point)
        self._links.append(link)

    def _usable(self, link):
        """Return a link, or None where its object is made from the spline."""
        made = link is not None and self._editor.obj in link[0].OutListRecursive
        return None if made else link

    def _at(self, pixel):
        through = self.points[-1] if self.points else (0.0, 0.0, 0.0)
        projection = Projection(self._editor.view)
        return self._snapper.find(projection, pixel, through, self._editor.panel.box.grid_mm())

    def _closes(self, pixel):
        if len(self.points) < 3:
            return False
        first = Projection(self._editor.view).pixels(self.points[:1])
        return nearest(first, pixel, CLOSE_PX) is not None


def _same(one, other):
    return numpy.abs(numpy.subtract(one, other)).max() <= SAME_MM
