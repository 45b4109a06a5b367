# SPDX-License-Identifier: LGPL-2.1-or-later
"""Join Curves: two edges that join smoothly, by the smallest move or by a continuation.

The class path is written into documents: neither rename nor move it.
"""

from typing import Any, List, NamedTuple

import numpy

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, LENGTH, Option

BOTH, FIRST, SECOND = mark("Both"), mark("First"), mark("Second")
MOVES = {BOTH: "both", FIRST: "a", SECOND: "b"}
ORDERS = ("G1", "G2", "G3")
SMALLEST, CONTINUATION = mark("Smallest move"), mark("Second continues the first")

#: Points at which a continued curve is compared with the edge.
COMPARED = 200


class Joined(NamedTuple):
    """The curves from end to end, and the largest move in mm."""

    curves: List[Any]
    moved_mm: float


def _moves(values):
    return values["method"] == SMALLEST


class JoinCurves(Curve):
    """Proxy of a Part::FeaturePython that holds two edges that join."""

    Type = "JoinCurves"
    LABEL = "Join Curves"
    ICON = "seamwright-join"
    TIP = (
        "Join two selected edges at their nearest ends with a common tangent (G1), curvature (G2) "
        "or change of the curvature (G3), by the smallest move of their poles there. Or let the "
        "second continue the first, which stays."
    )
    NEEDS = "select two edges"
    OPTIONS = (
        Option("Order", "order", CHOICE, "G2", "Continuity", "The continuity of the joint",
               choices=ORDERS),
        Option("Method", "method", CHOICE, SMALLEST, "By",
               "Poles at the joint move as little as possible, or the second edge begins as the "
               "continuation of the first says", choices=(SMALLEST, CONTINUATION)),
        Option("Moves", "moves", CHOICE, BOTH, "Moves", "The edge that moves",
               choices=tuple(MOVES), used=_moves),
        Option("LargestMove", "most_mm", LENGTH, 0.0, "Largest move",
               "A larger move is refused, in mm; 0: no limit", least=0.0, zero=mark("no limit")),
    )  # fmt: skip
    RESULTS = (
        ("Gap", "App::PropertyLength", "Distance of the ends before, in mm", "gap_mm"),
        ("Moved", "App::PropertyLength",
         "No pole, or no point of a continuation, moved further, in mm", "moved_mm"),
    )  # fmt: skip
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return (curve that ends at the joint, curve that begins there, distance of the ends)."""
        edges = inputs.edges_of(shapes)
        at_first, at_second = inputs.nearest_ends(edges)
        order = 1 + ORDERS.index(values["order"])
        one = _curve(module, edges[0], not at_first, order)
        other = _curve(module, edges[1], at_second, order)
        first, second = (inputs.ends_of(edge) for edge in edges)
        return one, other, first[at_first].distanceToPoint(second[at_second])

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return (Joined, distance of the ends before)."""
        one, other, gap = gathered
        order = 1 + ORDERS.index(values["order"])
        if values["method"] == CONTINUATION:
            found = _continued(module, one, other, order)
        else:
            join = module.curve_nearest_join(one, other, order, moves=MOVES[values["moves"]])
            if join.status == "infeasible":
                raise ValueError(tr("the edges cannot be joined so: {reason}").format(
                    reason=join.reason
                ))
            found = Joined([join.a, join.b], join.largest_move_mm)
        if 0 < values["most_mm"] < found.moved_mm:
            raise ValueError(
                tr(
                    "{what} would move by {moved_mm:.4g} mm, further than the {most_mm:g} mm that "
                    "are allowed"
                ).format(
                    what=tr("a pole") if _moves(values) else tr("a point"),
                    moved_mm=found.moved_mm,
                    most_mm=values["most_mm"],
                )
            )
        return found, gap

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        join, gap = found
        edges = [module.curve_to_freecad(curve).toShape() for curve in join.curves]
        report = {
            "order": 1 + ORDERS.index(values["order"]),
            "gap_mm": gap,
            "moved_mm": join.moved_mm,
            "continued": not _moves(values),
        }
        return report, results.wire_of(edges)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.join_text(report)


def _continued(module, one, other, order):
    """Return the Joined of a curve that stays and one whose first segment continues it.

    The end of that segment stays, with its derivatives to the order.
    """
    spline = other.bezier_spline()
    first = spline.segment(0)
    joined = module.curve_joined(one, first, _beta(module, one, first, order))
    places = numpy.linspace(0.0, 1.0, COMPARED)
    moved = numpy.linalg.norm(joined.point(places) - first.point(places), axis=1).max()
    curves = [one, joined]
    if spline.segments > 1:
        rest = [spline.segment(place) for place in range(1, spline.segments)]
        curves.append(module.BezierSpline.from_segments(rest, spline.knots[1:], False))
    return Joined(curves, float(moved))


def _beta(module, one, first, order):
    """Return the betas with which a curve goes on most like another one.

    Where this turns by more than 90 degrees, they are those of equal speed.
    """
    beta = list(module.fit_beta(one, first, order)["beta"])
    if len(beta) == order:
        return beta
    speeds = [
        numpy.linalg.norm(curve.derivatives(at, 1)[1])
        for curve, at in ((one, one.knots[-1]), (first, 0.0))
    ]
    return [speeds[1] / speeds[0], *[0.0] * (order - 1)]


def _curve(module, edge, backwards, order):
    """Return the BSplineCurve of an edge, with so many poles that its other end stays."""
    curve = inputs.nurbs_of(edge)
    if curve.NbPoles < 2 * (order + 1):
        raise_degree = getattr(curve, "increaseDegree", None) or curve.increase
        raise_degree(2 * order + 1)
    if backwards:
        curve.reverse()
    return inputs.kernel_curve(module, curve)
