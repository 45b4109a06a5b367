# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature Comb: lines across edges and iso-curves, as long as their curvature is large.

The class path is written into documents: neither rename nor move it.
"""

from typing import Any, NamedTuple

import numpy

from freecad.seamwright.document import sources
from freecad.seamwright.document.maps.tool import Tool, element_shape
from freecad.seamwright.plain import map_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, COUNT, FLOAT, Option

EDGES, U_LINES = mark("Edges"), mark("U lines")
V_LINES, BOTH = mark("V lines"), mark("U and V lines")

#: The length of the longest line with the scale 1, as a part of the size of all curves.
LONGEST = 0.15

#: Halvings that find where an iso-curve leaves its face: a part of 2e-6 of the distance of lines.
HALVINGS = 19

#: Smaller curvatures are those of straight lines, as a part of 1 / size.
STRAIGHT = 1e-9


class Comb(NamedTuple):
    """``points`` (n, 3) of a curve; ``curvatures`` (n, 3): vectors to the centre of curvature,
    as long as the curvature in 1/mm."""

    points: Any
    curvatures: Any


class CurvatureComb(Tool):
    """Proxy of curvature combs; ``found`` is a list of Comb."""

    Type = "CurvatureComb"
    LABEL = "Curvature Comb"
    ICON = "seamwright-comb"
    TIP = (
        "Draw a curvature comb on the selected edges and wires, and on iso-curves of the selected "
        "faces. The lines of the comb are as long as the curvature is large: a jump is a step of "
        "curvature, a kink of the comb a step of its change."
    )
    NEEDS = "select edges, wires or faces"
    LINKS = (("Sources", "Drawn on", "Edges, wires or faces"),)
    OPTIONS = (
        Option("Lines", "lines", CHOICE, BOTH, "On faces",
               "Which iso-curves of a face have a comb, or its edges. Selected edges always have "
               "one", choices=(BOTH, U_LINES, V_LINES, EDGES)),
        Option("Count", "count", COUNT, 5, "Number of lines",
               "Iso-curves of a face in each direction", least=1,
               used=lambda values: values["lines"] != EDGES),
        Option("Density", "density", COUNT, 40, "Density",
               "Lines of the comb on each curve", least=2),
        Option("Scale", "scale", FLOAT, 1.0, "Scale",
               "Length of the lines; 1: the longest is 15 % of the size of all curves", least=1e-3),
    )  # fmt: skip
    RESULTS = (
        ("Curves", "App::PropertyInteger", "Number of curves with a comb", "lines"),
        ("Largest", "App::PropertyFloat", "Largest curvature, in 1/mm", "largest_per_mm"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where there is no curve."""
        if not chosen:
            raise ValueError(tr("nothing is selected: {needs}").format(needs=tr(cls.NEEDS)))
        for obj, element in chosen:
            if not sources.has_shape(obj) or not sources.placed_shape(obj).Edges:
                raise sources.SourceError(tr("{label} has no edges: {needs}").format(
                    label=obj.Label, needs=tr(cls.NEEDS)
                ))
            if element.startswith("Vertex"):
                raise ValueError(tr("{label}.{element} is a point: {needs}").format(
                    label=obj.Label, element=element, needs=tr(cls.NEEDS)
                ))

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Comb]."""
        # Copies, since FreeCAD may draw or change the shapes meanwhile.
        shapes = [element_shape(each).copy() for each in inputs["Sources"]]
        return lambda progress: _combs(shapes, values, progress)

    @classmethod
    def report(cls, found, values):
        """Return the number of curves, and the largest curvature with its place."""
        if not found:
            raise ValueError(tr("there are no curves: {needs}").format(needs=tr(cls.NEEDS)))
        points = numpy.concatenate([each.points for each in found])
        sizes = numpy.linalg.norm(numpy.concatenate([each.curvatures for each in found]), axis=1)
        at = sizes.argmax()
        largest = float(sizes[at]) if sizes[at] > straight(points) else 0.0
        return {
            "lines": len(found),
            "largest_per_mm": largest,
            "largest_at": points[at].tolist() if largest else None,
        }

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return map_text.comb_text(report)


def straight(points):
    """Return the curvature below which curves through these points are straight."""
    return STRAIGHT / (numpy.linalg.norm(numpy.ptp(points, axis=0)) or 1.0)


def segments(found, scale=1.0):
    """Return [(points (n, 3), ends (n, 3) of the lines of the comb), ...] of a list of Comb.

    The lines point away from the centre of curvature. With a scale of 1 the longest one has the
    part LONGEST of the size of all curves.
    """
    if not found:
        return []
    points = numpy.concatenate([each.points for each in found])
    largest = max(numpy.linalg.norm(each.curvatures, axis=1).max() for each in found)
    if largest <= straight(points):
        return [(each.points, each.points) for each in found]
    factor = scale * LONGEST * numpy.linalg.norm(numpy.ptp(points, axis=0)) / largest
    return [(each.points, each.points - factor * each.curvatures) for each in found]


def _combs(shapes, values, progress):
    jobs = []
    for shape in shapes:
        if shape.Faces and values["lines"] != EDGES:
            jobs += [
                (face, direction, (line + 1) / (values["count"] + 1))
                for face in shape.Faces
                for direction in (0, 1)
                if values["lines"] in (BOTH, (U_LINES, V_LINES)[direction])
                for line in range(values["count"])
            ]
        else:
            jobs += [(edge, None, 0.0) for edge in shape.Edges if not edge.Degenerated]
    found = []
    for index, (part, direction, share) in enumerate(jobs):
        if progress is not None and not progress(index / len(jobs)):
            return None
        if direction is None:
            found.append(_of_edge(part, values["density"]))
        else:
            found += _of_face(part, direction, share, values["density"])
    return found


def _of_edge(edge, density):
    first, last = edge.ParameterRange
    places = numpy.linspace(first, last, density)
    return _comb(
        [edge.valueAt(at) for at in places],
        [edge.derivative1At(at) for at in places],
        [edge.derivative2At(at) for at in places],
    )


def _of_face(face, direction, share, density):
    """Return the Combs of a line along u (0) or v (1) in the inside of a face.

    ``share``: where it lies between the ends of the face in the other direction.
    """
    ranges = face.ParameterRange[:2], face.ParameterRange[2:]
    across = ranges[1 - direction]
    at = across[0] + (across[1] - across[0]) * share
    return [
        _iso(face.Surface, direction, at, numpy.linspace(first, last, density))
        for first, last in _inside(face, direction, at, ranges[direction], density)
    ]


def _pair(direction, along, at):
    return (along, at) if direction == 0 else (at, along)


def _inside(face, direction, at, ends, density):
    """Return [(first, last)] of the parts of an iso-curve that lie on a face."""

    def lies(along):
        return face.isPartOfDomain(*_pair(direction, float(along), at))

    def border(inner, outer):
        for _ in range(HALVINGS):
            middle = (inner + outer) / 2
            inner, outer = (middle, outer) if lies(middle) else (inner, middle)
        return float(inner)

    places = numpy.linspace(*ends, max(4 * density, 100))
    known = [lies(place) for place in places]
    found, begin = [], None
    for k, inside in enumerate(known):
        if inside and begin is None:
            begin = border(places[k], places[k - 1]) if k else places[0]
        if begin is not None and (not inside or k + 1 == len(known)):
            end = places[k] if inside else border(places[k - 1], places[k])
            if end > begin:
                found.append((float(begin), float(end)))
            begin = None
    return found


def _iso(surface, direction, at, places):
    orders = ((1, 0), (2, 0)) if direction == 0 else ((0, 1), (0, 2))
    pairs = [_pair(direction, float(along), at) for along in places]
    return _comb(
        [surface.getD0(*pair) for pair in pairs],
        [surface.getDN(*pair, *orders[0]) for pair in pairs],
        [surface.getDN(*pair, *orders[1]) for pair in pairs],
    )


def _comb(points, first, second):
    points, first, second = (
        numpy.array([tuple(each) for each in vectors]) for vectors in (points, first, second)
    )
    squares = (first * first).sum(axis=1)
    safe = numpy.where(squares > 0, squares, 1.0)
    across = second - first * ((second * first).sum(axis=1) / safe)[:, None]
    curvatures = numpy.where(squares[:, None] > 0, across / safe[:, None], 0.0)
    return Comb(points, curvatures)
