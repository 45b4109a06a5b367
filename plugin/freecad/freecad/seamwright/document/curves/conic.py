# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conic: one conic of three points, or a spline of conics through points of a plane.

The class path is written into documents: neither rename nor move it.
"""

from typing import Any, List, NamedTuple

import numpy
import Part

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.arcs import FLATNESS
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.document.curves.plane import Plane, plane_of
from freecad.seamwright.document.curves.samples import end_directions, runs_of
from freecad.seamwright.document.curves.spline import SAMPLES
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, FLOAT, Option

ONE, CHAIN = mark("Start, corner and end"), mark("Spline through points")


#: Points of each bent edge at which its distance from the conics is measured.
COMPARED = 50


class Conics(NamedTuple):
    """Conics in a plane, and how many joints between corners have a jump of the curvature.

    ``near``: the bent edges of which the points are samples.
    """

    plane: Plane
    conics: Any
    g1_joints: int
    near: List[Any]


class Conic(Curve):
    """Proxy of a Part::FeaturePython that holds conics."""

    Type = "Conic"
    LABEL = "Conic"
    ICON = "seamwright-conic"
    TIP = (
        "Make a conic from three selected points: start, corner of the tangents, end. Or lay a "
        "spline of conics with continuous curvature through points of a plane."
    )
    NEEDS = "select three points or more, a wire or a sketch, in a plane"
    OPTIONS = (
        Option("Meaning", "points", CHOICE, ONE, "Points are", "What the points mean",
               choices=(ONE, CHAIN)),
        Option("Weight", "weight", FLOAT, 1.0, "Weight",
               "Below 1 an ellipse, 1 a parabola, above 1 a hyperbola", least=1e-6,
               used=lambda values: values["points"] == ONE),
        SAMPLES,
        FLATNESS,
    )  # fmt: skip
    RESULTS = (
        ("Conics", "App::PropertyInteger", "Number of conics", "conics"),
        ("Jumps", "App::PropertyInteger", "Joints at which the curvature jumps", "g1_joints"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return (plane, points in it, whether they are closed, the bent edges through them)."""
        points, closed = inputs.points_of(shapes, values["samples"])
        if len(points) < 3:
            raise ValueError(tr("there are two points: a conic needs three or more"))
        plane = plane_of(points, values["flatness_mm"])
        bent = [edge for edge in inputs.edges_of(shapes) if not inputs.is_straight(edge)]
        return plane, plane.coordinates(points)[0], closed, bent

    @classmethod
    def suggested(cls, gathered):
        """Return that more than three points are those of a spline."""
        _, points, closed, _ = gathered
        return {"points": CHAIN} if closed or len(points) > 3 else {}

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Conics."""
        plane, points, closed, bent = gathered
        if values["points"] == CHAIN:
            runs = [
                module.g2_conics(
                    module.biarc_spline(run, closed=is_ring, **end_directions(run, is_ring))
                )
                for run, is_ring in runs_of(module, points, closed)
            ]
            conics = [conic for found in runs for conic in found.conics]
            return Conics(plane, conics, sum(len(found.g1_joints) for found in runs), bent)
        if len(points) != 3:
            raise ValueError(
                tr(
                    "there are {points} points: one conic has three, its start, the corner of its "
                    "tangents and its end"
                ).format(points=len(points))
            )
        sides = points[1] - points[0], points[2] - points[1]
        if abs(sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]) <= 1e-12 * numpy.prod(
            [numpy.linalg.norm(side) for side in sides]
        ):
            raise ValueError(tr("the three points are on a line: move the corner off it"))
        return Conics(plane, [module.PlanarConic(*points, values["weight"])], 0, [])

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        edges = [_edge(module, conic, found.plane) for conic in found.conics]
        weights = [conic.weight for conic in found.conics]
        report = {
            "conics": len(edges),
            "length_mm": sum(conic.length_mm for conic in found.conics),
            "least_weight": min(weights),
            "largest_weight": max(weights),
            "g1_joints": found.g1_joints,
        }
        wire = results.wire_of(edges)
        if found.near:
            report["distance_mm"] = max(_distance(edge, wire) for edge in found.near)
        return report, wire

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.conic_text(report)


def _distance(edge, wire):
    """Return the largest distance of points of an edge from a wire, in mm."""
    points = edge.discretize(COMPARED)
    return max(wire.distToShape(Part.Vertex(point))[0] for point in points)


def _edge(module, conic, plane):
    curve = conic.bezier_curve()
    poles = plane.space(numpy.asarray(curve.poles)[:, :2])
    return module.curve_to_freecad(module.BezierCurve(poles, curve.weights)).toShape()
