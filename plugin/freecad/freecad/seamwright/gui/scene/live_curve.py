# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve that changes while the user drags it: line, comb and handles, without a shape."""

import numpy
from pivy import coin

from freecad.seamwright.gui.scene import markers
from freecad.seamwright.gui.scene.comb import COLOURS, CURVE_LIFT, LIFT
from freecad.seamwright.gui.scene.halo import nearer
from freecad.seamwright.gui.scene.overlay import (
    outside_bounding_box,
    pixel_ratio,
    unlit_unpickable,
)

LINE_COLOUR, LINE_WIDTH = (0.84, 0.1, 0.45), 2.5
STALK_COLOUR = (0.35, 0.4, 0.45)

#: The look of each kind of handle: marker, colour.
POINT, TENSION, TANGENT, SNAP = "point", "tension", "tangent", "snap"
LOOKS = {
    POINT: (markers.CIRCLE, (0.0, 0.32, 0.62)),
    TENSION: (markers.DIAMOND, (0.0, 0.62, 0.45)),
    TANGENT: (markers.SQUARE, (0.6, 0.25, 0.65)),
    SNAP: (markers.RING, (0.84, 0.1, 0.45)),
}


class LiveCurve:
    """Scene nodes; add ``node`` to the root of a view provider, before its placement."""

    def __init__(self):
        drawing, handles = coin.SoSeparator(), coin.SoAnnotation()
        for node in (*unlit_unpickable(), nearer(LIFT)):
            drawing.addChild(node)
        self._quills = _Lines(drawing, COLOURS[0], 1.0)
        self._hull = _Lines(drawing, COLOURS[1], 1.0)
        drawing.addChild(nearer(CURVE_LIFT))
        self._curve = _Lines(drawing, LINE_COLOUR, LINE_WIDTH)
        for node in unlit_unpickable():
            handles.addChild(node)
        self._stalks = _Lines(handles, STALK_COLOUR, 1.0)
        self._markers = {kind: _Markers(handles, *look) for kind, look in LOOKS.items()}
        self.node = coin.SoGroup()
        for part in (drawing, handles):
            self.node.addChild(outside_bounding_box(part))

    def show_curve(self, points):
        """Draw the line through points (count, 3); None removes it."""
        self._curve.show(*_one_line(points))

    def show_comb(self, feet, tips, every):
        """Draw lines between points, of which only every n-th, and one through all tips."""
        if feet is None:
            self._quills.show(*_one_line(None))
        else:
            pairs = numpy.stack([feet[::every], tips[::every]], axis=1).reshape(-1, 3)
            self._quills.show(pairs, [2] * (len(pairs) // 2))
        self._hull.show(*_one_line(tips))

    def show_handles(self, places, stalks=()):
        """Draw handles, {kind: points (count, 3)}, and lines, [(point, point), ...], to them."""
        for kind, markers in self._markers.items():
            if kind != SNAP:
                markers.show(places.get(kind, ()))
        self._stalks.show(numpy.array(stalks, float).reshape(-1, 3), [2] * len(stalks))

    def show_snap(self, point):
        """Draw a ring around the point that the mouse would take; None removes it."""
        self._markers[SNAP].show(() if point is None else [point])


def _one_line(points):
    return ((), ()) if points is None else (points, [len(points)])


class _Lines:
    def __init__(self, parent, rgb, width):
        colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        colour.rgb, style.lineWidth = rgb, width * pixel_ratio()
        self._points, self._set = coin.SoCoordinate3(), coin.SoLineSet()
        self._set.numVertices.setNum(0)
        for node in (colour, style, self._points, self._set):
            parent.addChild(node)

    def show(self, points, counts):
        _put(self._set.numVertices, ())
        _put(self._points.point, _tuples(points))
        _put(self._set.numVertices, counts)


class _Markers:
    def __init__(self, parent, marker, rgb):
        colour = coin.SoBaseColor()
        colour.rgb = rgb
        self._points, self._set = coin.SoCoordinate3(), coin.SoMarkerSet()
        self._set.markerIndex = markers.index(marker)
        self._set.numPoints = 0
        for node in (colour, self._points, self._set):
            parent.addChild(node)

    def show(self, points):
        self._set.numPoints = 0
        _put(self._points.point, _tuples(points))
        self._set.numPoints = len(points)


def _tuples(points):
    return list(map(tuple, numpy.asarray(points, float).reshape(-1, 3).tolist()))


def _put(field, values):
    field.setNum(len(values))
    if values:
        field.setValues(0, len(values), values)
