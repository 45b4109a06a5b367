# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curvature comb of edges: lines across a curve, as long as its curvature is large."""

import FreeCAD as App
from pivy import coin

from freecad.seamwright.document import preferences
from freecad.seamwright.gui.scene.halo import nearer
from freecad.seamwright.gui.scene.overlay import outside_bounding_box, unlit_unpickable
from freecad.seamwright.plain.preferences import COMB_LINES

#: Colours of the lines and of the curve through their ends.
COLOURS = (0.84, 0.37, 0.0), (0.55, 0.2, 0.0)
INPUT_COLOURS = (0.62, 0.66, 0.7), (0.35, 0.4, 0.45)

#: Places of the comb, for all edges together and at least for each edge; every fourth has a line.
QUILLS, LEAST_QUILLS, EVERY = 480, 12, 4

#: The length of the longest line of the comb, as a part of the size of the edges.
LONGEST = 0.15

#: The amount by which the comb is drawn nearer than the model, see halo.
LIFT = 0.002


class Comb:
    """Scene nodes of a comb; add ``node`` to the root of a view provider."""

    def __init__(self, colours=COLOURS):
        lines = coin.SoSeparator()
        self._points, self._quills = coin.SoCoordinate3(), coin.SoLineSet()
        self._hull_points, self._hull = coin.SoCoordinate3(), coin.SoLineSet()
        colour, hull_colour = coin.SoBaseColor(), coin.SoBaseColor()
        colour.rgb, hull_colour.rgb = colours
        style = coin.SoDrawStyle()
        style.lineWidth = 1.0
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

    def show(self, edges, scale=1.0, measure=()):
        """Draw the comb of edges; no edges remove it. ``scale``, ``measure``: as for ``quills``."""
        self.draw(quills(edges, scale, measure), EVERY)

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


def quills(edges, scale=1.0, measure=()):
    """Return for each edge [(point on it, end of the line of the comb there), ...].

    The lines point away from the centre of curvature. With a ``scale`` of 1, the longest one has
    the part LONGEST of the size of the edges; with edges to ``measure``, the longest one of these.
    """
    combs = _all_curvatures(edges)
    factor = scale * _unit_length(measure or edges, _all_curvatures(measure) or combs)
    if factor == 0:
        return []
    return [
        [(tuple(point), tuple(point - vector * factor)) for point, vector in comb]
        for comb in combs
    ]


def _unit_length(edges, combs):
    """Return the length of the line of a comb for the curvature 1; 0 for straight edges."""
    largest = max((vector.Length for comb in combs for _, vector in comb), default=0.0)
    box = App.BoundBox()
    for edge in edges:
        box.add(edge.BoundBox)
    if largest == 0 or largest <= 1e-9 / box.DiagonalLength:
        return 0.0
    return LONGEST * box.DiagonalLength / largest


def quill_count():
    """Return the number of places of a comb that has as many lines as the user wants."""
    standard = COMB_LINES.default
    return max(LEAST_QUILLS, QUILLS * preferences.comb_lines() // standard)


def _all_curvatures(edges):
    count = max(LEAST_QUILLS, quill_count() // len(edges)) if edges else 0
    return [_curvatures(edge, count) for edge in edges]


def _curvatures(edge, count):
    """Return [(point, vector to the centre of curvature, as long as the curvature), ...]."""
    first, last = edge.ParameterRange
    found = []
    for place in range(count + 1):
        at = first + (last - first) * place / count
        tangent, second = edge.derivative1At(at), edge.derivative2At(at)
        square = tangent.dot(tangent)
        vector = App.Vector()
        if square > 0:
            vector = (second - tangent * (second.dot(tangent) / square)) / square
        found.append((edge.valueAt(at), vector))
    return found
