# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curvature comb of edges: lines across a curve, as long as its curvature is large."""

import FreeCAD as App
import numpy
from pivy import coin

from freecad.seamwright.gui.scene.halo import nearer
from freecad.seamwright.gui.scene.overlay import (
    outside_bounding_box,
    pixel_ratio,
    unlit_unpickable,
)
from freecad.seamwright.plain.preferences import COMB_LINES

#: Colours of the lines and of the curve through their ends.
COLOURS = (0.84, 0.37, 0.0), (0.55, 0.2, 0.0)
INPUT_COLOURS = (0.34, 0.71, 0.91), (0.15, 0.5, 0.75)

#: Every fourth place of a comb has a line; the curve through the ends goes through all of them. An
#: edge has at least LEAST_PLACES.
EVERY, LEAST_PLACES = 4, 12

#: The part of the places that lie where the curve bends, and not evenly along its length; how many
#: times as many points measure both.
BENDS, SAMPLES = 1 / 3, 4

#: The length of the longest line of the comb, as a part of the size of the edges.
LONGEST = 0.15

#: For the comb of edges beside sharper bends, see _unit_length.
SEEN, MOST = 0.05, 0.6

#: The amounts by which a comb, and a curve that has one, are drawn nearer than the model, see halo.
#: The outline of the comb lies on the curve where the curvature is small.
LIFT, CURVE_LIFT = 0.002, 0.004


class Comb:
    """Scene nodes of a comb; add ``node`` to the root of a view provider."""

    def __init__(self, colours=COLOURS):
        lines = coin.SoSeparator()
        self._points, self._quills = coin.SoCoordinate3(), coin.SoLineSet()
        self._hull_points, self._hull = coin.SoCoordinate3(), coin.SoLineSet()
        colour, hull_colour = coin.SoBaseColor(), coin.SoBaseColor()
        colour.rgb, hull_colour.rgb = colours
        style = coin.SoDrawStyle()
        style.lineWidth = pixel_ratio()
        for node in (
            *unlit_unpickable(),
            nearer(LIFT),
            style,
            colour,
            self._points,
            self._quills,
            hull_colour,
            self._hull_points,
            self._hull,
        ):
            lines.addChild(node)
        self.node = outside_bounding_box(lines)
        self.show([])

    def show(self, edges, *look):
        """Draw the comb of edges; no edges remove it. ``look``: the arguments of ``quills``."""
        self.draw(quills(edges, *look), EVERY)

    def draw(self, combs, every):
        """Draw combs as ``quills`` returns them, with a line at each ``every``-th place."""
        feet = [each for comb in combs for pair in comb[::every] for each in pair]
        tips = [[tip for _, tip in comb] for comb in combs]
        for field, values in (
            (self._points.point, feet),
            (self._quills.numVertices, [2] * (len(feet) // 2)),
            (self._hull_points.point, [tip for comb in tips for tip in comb]),
            (self._hull.numVertices, [len(comb) for comb in tips]),
        ):
            field.setNum(0)
            field.setValues(0, len(values), values)


def quills(edges, lines=COMB_LINES.default, scale=1.0, measure=(), beside=()):
    """Return for each edge [(point on it, end of the line of the comb there), ...].

    The lines point away from the centre of curvature; so many ``lines`` of all edges are those of
    every EVERY-th place. With a ``scale`` of 1, the longest one has the part LONGEST of the size of
    the edges; with edges to ``measure``, the longest one of these. ``beside``: other edges whose
    comb is to be seen on the same scale.
    """
    if not edges:
        return []
    combs = _all_curvatures(edges, lines)
    measured = measure or edges
    factor = scale * _unit_length(
        [*measured, *beside],
        combs if measured is edges else _all_curvatures(measured, lines),
        _all_curvatures(beside, lines),
    )
    if factor == 0:
        return []
    return [
        [(tuple(point), tuple(point - vector * factor)) for point, vector in comb]
        for comb in combs
    ]


def _unit_length(edges, combs, others):
    """Return the length of the line of a comb for the curvature 1; 0 for straight edges.

    Beside sharper bends, the lines of ``others`` are at least SEEN of the size, if that leaves the
    longest line of all within MOST of it.
    """
    box = App.BoundBox()
    for edge in edges:
        box.add(edge.BoundBox)
    size, beside = box.DiagonalLength, _largest(others)
    largest = max(_largest(combs), beside)
    if largest == 0 or largest <= 1e-9 / size:
        return 0.0
    wanted = SEEN * size / beside if beside > 1e-9 / size else 0.0
    return min(max(LONGEST * size / largest, wanted), MOST * size / largest)


def _largest(combs):
    return max((vector.Length for comb in combs for _, vector in comb), default=0.0)


def _all_curvatures(edges, lines):
    whole = sum(edge.Length for edge in edges)
    return [
        _curvatures(edge, max(LEAST_PLACES, round(lines * EVERY * edge.Length / whole)))
        for edge in edges
    ]


def _curvatures(edge, count):
    """Return [(point, vector to the centre of curvature, as long as the curvature), ...]."""
    found = []
    for at in _places(edge, count):
        tangent, second = edge.derivative1At(at), edge.derivative2At(at)
        square = tangent.dot(tangent)
        vector = App.Vector()
        if square > 0:
            vector = (second - tangent * (second.dot(tangent) / square)) / square
        found.append((edge.valueAt(at), vector))
    return found


def _places(edge, count):
    """Return count + 1 parameters of an edge: along its length, and more of them in its bends."""
    at = numpy.linspace(*edge.ParameterRange, SAMPLES * count + 1)
    points = numpy.array([tuple(edge.valueAt(each)) for each in at.tolist()])
    steps = numpy.diff(points, axis=0)
    lengths = numpy.linalg.norm(steps, axis=1)
    along = steps / numpy.maximum(lengths, 1e-300)[:, None]
    turns = numpy.linalg.norm(numpy.diff(along, axis=0, prepend=along[:1]), axis=1)
    way = numpy.zeros(len(at))
    for each, share in ((lengths, 1 - BENDS), (turns, BENDS)):
        whole = each.sum()
        if whole > 0:
            way[1:] += share * numpy.cumsum(each) / whole
    return numpy.interp(numpy.linspace(0, way[-1], count + 1), way, at).tolist()
