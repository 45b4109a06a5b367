# SPDX-License-Identifier: LGPL-2.1-or-later
"""Log Spiral: a logarithmic spiral between two directions of a plane, or arcs near it.

The class path is written into documents: neither rename nor move it.
"""

import math
from typing import Any, NamedTuple

import numpy

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.arcs import FLATNESS
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.document.curves.plane import Plane, plane_of
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, COUNT, FLAG, LENGTH, Option

SPIRAL, ARCS = mark("Spiral"), mark("Arcs of one sweep")


class Ends(NamedTuple):
    """Both ends in a plane; ``ends``: start, its direction in rad, end, its direction in rad."""

    plane: Plane
    ends: tuple


class Found(NamedTuple):
    """The spiral of a plane, and the SplineWithin or the ArcChain that is made of it."""

    plane: Plane
    spiral: Any
    near: Any


class LogSpiral(Curve):
    """Proxy of a Part::FeaturePython that holds a logarithmic spiral."""

    Type = "LogSpiral"
    LABEL = "Log Spiral"
    ICON = "seamwright-log-spiral"
    TIP = (
        "Make a logarithmic spiral, whose radius grows by the same factor with each degree of "
        "turn, from three selected points: start, corner of the tangents, end. Or let it continue "
        "two edges of a plane from end to end."
    )
    NEEDS = "select three points, a wire or a sketch of two lines, or two edges, in a plane"
    OPTIONS = (
        Option("Result", "result", CHOICE, SPIRAL, "Make",
               "Splines near the spiral, or tangent arcs of one sweep whose radii are a geometric "
               "progression", choices=(SPIRAL, ARCS)),
        Option("Tolerance", "tolerance_mm", LENGTH, 1e-3, "Tolerance",
               "Largest distance of the splines from the spiral, in mm", least=1e-9,
               used=lambda values: values["result"] == SPIRAL),
        Option("Count", "count", COUNT, 0, "Number of arcs",
               "Number of arcs; 0: as few as possible", least=0.0,
               used=lambda values: values["result"] == ARCS),
        Option("FlipFirst", "flip_first", FLAG, False, "Other end of the first",
               "Begin at the other end of the first of two edges"),
        Option("FlipSecond", "flip_second", FLAG, False, "Other end of the second",
               "End at the other end of the second of two edges"),
        FLATNESS,
    )  # fmt: skip
    RESULTS = (
        ("Turn", "App::PropertyAngle", "By how much the tangent turns, in degrees", "turn_deg"),
        ("FirstRadius", "App::PropertyLength", "Radius of curvature at the start, in mm",
         "first_radius_mm"),
        ("LastRadius", "App::PropertyLength", "Radius of curvature at the end, in mm",
         "last_radius_mm"),
    )  # fmt: skip
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return the Ends of three points or two edges."""
        edges, chains = inputs.edges_of(shapes), inputs.chains_of(shapes)
        flips = values["flip_first"], values["flip_second"]
        if len(edges) == 2 and (len(chains) == 2 or not all(map(inputs.is_straight, edges))):
            return _between(module, edges, flips, values["flatness_mm"])
        points, closed = inputs.points_of(shapes, samples=0)
        if len(points) != 3 or closed:
            raise ValueError(
                tr(
                    "there are {points} points: a spiral has three, its start, the corner of its "
                    "tangents and its end"
                ).format(points=len(points))
            )
        plane = plane_of(points, values["flatness_mm"])
        start, corner, end = plane.coordinates(points)[0]
        return Ends(plane, (start, _angle(corner - start), end, _angle(end - corner)))

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Found."""
        spiral = module.log_spiral(*gathered.ends)
        if values["result"] == ARCS:
            near = module.log_arcs(*gathered.ends, count=values["count"] or None)
        else:
            near = spiral.bezier_spline(values["tolerance_mm"])
        return Found(gathered.plane, spiral, near)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        if values["result"] == ARCS:
            edges = [results.arc_edge(arc, found.plane, 0.0) for arc in found.near.arcs]
            length, distance = found.near.length_mm, None
        else:
            spline = results.raised(module, found.near.curve, found.plane)
            edges = results.spline_edges(module, spline)
            length, distance = found.spiral.length_mm, found.near.distance_mm
        spiral = found.spiral
        report = {
            "length_mm": length,
            "turn_deg": math.degrees(spiral.turn_rad),
            "first_radius_mm": abs(spiral.radius_mm),
            "last_radius_mm": abs(spiral.radius_mm) * math.exp(spiral.growth * spiral.turn_rad),
            "distance_mm": distance,
            "arcs": len(edges) if values["result"] == ARCS else 0,
        }
        return report, results.wire_of(edges)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.log_spiral_text(report)


def _between(module, edges, flips, flatness_mm):
    """Return the Ends of a spiral from an end of one edge to an end of another one."""
    at_first, at_second = inputs.ends_to_bridge(edges, flips)
    curves = [inputs.curve_of(module, edge).bezier_spline() for edge in edges]
    plane = plane_of(numpy.vstack([curve.poles for curve in curves]), flatness_mm)
    first, second = (
        (inputs.ends_of(edge)[at_last], _outwards(edge, at_last))
        for edge, at_last in zip(edges, (at_first, at_second))
    )
    (start, end), _ = plane.coordinates([tuple(first[0]), tuple(second[0])])
    leaving, arriving = (plane.frame[:2] @ numpy.array(each[1]) for each in (first, second))
    return Ends(plane, (start, _angle(leaving), end, _angle(-arriving)))


def _outwards(edge, at_last):
    """Return the direction in which an edge would go on at its last or its first point."""
    if at_last:
        return tuple(edge.tangentAt(edge.LastParameter))
    return tuple(-edge.tangentAt(edge.FirstParameter))


def _angle(vector):
    return math.atan2(vector[1], vector[0])
