# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of the model and of a grid to which the mouse snaps."""

from typing import Any, NamedTuple

import FreeCAD as App
import numpy

from freecad.seamwright.document import sources
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.spline_handles import nearest, nearest_on_lines, rounded

#: Pixels within which the mouse snaps to a vertex or the middle of an edge, and to a curve.
REACH_PX, CURVE_PX = 10, 6

#: Points no further apart than this many pixels are seen at the same place.
SAME_PX = 1

#: Vertices and edges that are looked at; of more objects there is no snapping.
MOST_VERTICES, MOST_EDGES = 20000, 2000

#: Points of the polygon in place of an edge.
POLYGON = 33


class Snap(NamedTuple):
    """Where the mouse is: a point, or None for nowhere, and what it is.

    ``link``: (object, "Vertex3") where the point is that of a vertex.
    """

    point: Any
    what: str
    link: Any = None


NOWHERE = Snap(None, "")


class Snapper:
    """The vertices and edges of the visible objects of a document as they are now."""

    def __init__(self, doc, exclude):
        """``exclude``: an object whose own vertices and edges do not count."""
        self._points, self._names, self._links = [], [], []
        self._edges, middles, polygons = [], [], []
        for obj in doc.Objects:
            if obj != exclude and sources.has_shape(obj) and obj.ViewObject.Visibility:
                self._add(obj)
        for edge, name in self._edges:
            polygons.append([tuple(point) for point in edge.discretize(Number=POLYGON)])
            middles.append(tuple(edge.valueAt(edge.getParameterByLength(edge.Length / 2))))
            self._names.append(tr("middle of {edge}").format(edge=name))
        self._points = numpy.array(self._points + middles, float).reshape(-1, 3)
        self._polygons = numpy.array(polygons, float).reshape(-1, POLYGON, 3)

    def _add(self, obj):
        try:
            shape = sources.placed_shape(obj)
        except sources.SourceError:
            return
        vertices, edges = shape.Vertexes, shape.Edges
        if len(self._points) + len(vertices) <= MOST_VERTICES:
            self._points += [tuple(vertex.Point) for vertex in vertices]
            names = ["Vertex%d" % number for number in range(1, len(vertices) + 1)]
            self._names += ["%s.%s" % (obj.Label, name) for name in names]
            self._links += [(obj, name) for name in names]
        if len(self._edges) + len(edges) <= MOST_EDGES:
            self._edges += [
                (edge, "%s.Edge%d" % (obj.Label, number))
                for number, edge in enumerate(edges, 1)
                if not edge.Degenerated and edge.Length > 0
            ]

    def find(self, projection, pixel, through, grid_mm):
        """Return the Snap of the mouse.

        A vertex counts first, then the middle of an edge, then a point of an edge. Otherwise it is
        the point in the plane through a point, across the axis that is nearest to the direction of
        view; there it snaps to a grid, 0: none. Ctrl turns all snapping off.
        """
        free = bool(QtWidgets.QApplication.keyboardModifiers() & QtCore.Qt.ControlModifier)
        if not free:
            count = len(self._links)
            for part in (range(count), range(count, len(self._points))):
                found = self._on_point(projection, pixel, part)
                if found.point is not None:
                    return found
            found = self._on_edge(projection, pixel)
            if found.point is not None:
                return found
        axis = projection.facing_axis()
        point = projection.on_plane(pixel, through, axis)
        if point is None:
            return NOWHERE
        if free or not grid_mm:
            return Snap(point, "free")
        return Snap(rounded(point, axis, grid_mm), "grid")

    def _on_point(self, projection, pixel, part):
        """Return the Snap of the point at a pixel; ``part``: the range of places that count.

        Of points that are seen at the same pixel it is the one nearest to the viewer.
        """
        points = self._points[part.start : part.stop]
        pixels = projection.pixels(points)
        place = nearest(pixels, pixel, REACH_PX)
        if place is None:
            return NOWHERE
        alike = numpy.flatnonzero(numpy.linalg.norm(pixels - pixels[place], axis=1) <= SAME_PX)
        place = part[int(alike[numpy.argmax(projection.nearness(points[alike]))])]
        link = self._links[place] if place < len(self._links) else None
        return Snap(self._points[place], self._names[place], link)

    def _on_edge(self, projection, pixel):
        """Return the Snap of the edge at a pixel."""
        pixels = projection.pixels(self._polygons).reshape(-1, POLYGON, 2)
        found = nearest_on_lines(pixels, pixel, CURVE_PX)
        if found is None:
            return NOWHERE
        line, place, share = found
        one, other = self._polygons[line, place : place + 2]
        edge, name = self._edges[line]
        first, last = edge.ParameterRange
        at = edge.Curve.parameter(App.Vector(*(one + share * (other - one))))
        if not first <= at <= last:
            return NOWHERE
        return Snap(numpy.array(edge.valueAt(at)), tr("on {edge}").format(edge=name))
