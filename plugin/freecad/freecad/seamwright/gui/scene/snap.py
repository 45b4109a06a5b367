# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of the model and of a grid to which the mouse snaps."""

import numpy

from freecad.seamwright.document import sources
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.spline_handles import nearest, rounded

#: Pixels within which the mouse snaps to a vertex.
REACH_PX = 10

#: Vertices that are looked at; of more objects there is no snapping.
MOST_VERTICES = 20000


class Snapper:
    """The vertices of the visible objects of a document as they are now."""

    def __init__(self, doc, exclude):
        """``exclude``: an object whose own vertices do not count."""
        self._points, self._names = [], []
        for obj in doc.Objects:
            if obj != exclude and sources.has_shape(obj) and obj.ViewObject.Visibility:
                self._add(obj)
        self._points = numpy.array(self._points, float).reshape(-1, 3)

    def _add(self, obj):
        try:
            vertices = sources.placed_shape(obj).Vertexes
        except sources.SourceError:
            return
        if len(self._points) + len(vertices) <= MOST_VERTICES:
            self._points += [tuple(vertex.Point) for vertex in vertices]
            self._names += ["%s.Vertex%d" % (obj.Label, n + 1) for n in range(len(vertices))]

    def find(self, projection, pixel, through, grid_mm):
        """Return (point, what it is) of the mouse; (None, "") where it is nowhere.

        A vertex counts first. Then it is the point in the plane through a point, across the axis
        that is nearest to the direction of view; there it snaps to a grid, 0: none. Ctrl turns
        all snapping off.
        """
        free = bool(QtWidgets.QApplication.keyboardModifiers() & QtCore.Qt.ControlModifier)
        place = None if free else nearest(projection.pixels(self._points), pixel, REACH_PX)
        if place is not None:
            return self._points[place], self._names[place]
        axis = projection.facing_axis()
        point = projection.on_plane(pixel, through, axis)
        if point is None:
            return None, ""
        if free or not grid_mm:
            return point, "free"
        return rounded(point, axis, grid_mm), "grid"
