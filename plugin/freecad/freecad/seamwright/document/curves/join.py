# SPDX-License-Identifier: LGPL-2.1-or-later
"""Join Curves: two edges moved as little as possible until they join smoothly.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.options import CHOICE, LENGTH, Option

BOTH, FIRST, SECOND = "Both", "First", "Second"
MOVES = {BOTH: "both", FIRST: "a", SECOND: "b"}
ORDERS = ("G1", "G2", "G3")


class JoinCurves(Curve):
    """Proxy of a Part::FeaturePython that holds two edges that join."""

    Type = "JoinCurves"
    LABEL = "Join Curves"
    ICON = "seamwright-join"
    TIP = (
        "Join two selected edges at their nearest ends with a common tangent (G1), curvature (G2) "
        "or change of the curvature (G3), by the smallest move of their poles there."
    )
    NEEDS = "select two edges"
    OPTIONS = (
        Option("Order", "order", CHOICE, "G2", "Continuity", "The continuity of the joint",
               choices=ORDERS),
        Option("Moves", "moves", CHOICE, BOTH, "Moves", "The edge that moves",
               choices=tuple(MOVES)),
        Option("LargestMove", "most_mm", LENGTH, 0.0, "Largest move",
               "A larger move of a pole is refused, in mm; 0: no limit", least=0.0),
    )  # fmt: skip
    RESULTS = (
        ("Gap", "App::PropertyLength", "Distance of the ends before, in mm", "gap_mm"),
        ("Moved", "App::PropertyLength", "No pole moved further, in mm", "moved_mm"),
    )
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
        """Return (NearestCurveJoin, distance of the ends before)."""
        one, other, gap = gathered
        order = 1 + ORDERS.index(values["order"])
        found = module.curve_nearest_join(one, other, order, moves=MOVES[values["moves"]])
        if found.status == "infeasible":
            raise ValueError("the edges cannot be joined so: %s" % found.reason)
        if 0 < values["most_mm"] < found.largest_move_mm:
            raise ValueError(
                "a pole would move by %.4g mm, further than the %g mm that are allowed"
                % (found.largest_move_mm, values["most_mm"])
            )
        return found, gap

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        join, gap = found
        edges = [module.curve_to_freecad(curve).toShape() for curve in (join.a, join.b)]
        report = {
            "order": 1 + ORDERS.index(values["order"]),
            "gap_mm": gap,
            "moved_mm": join.largest_move_mm,
        }
        return report, results.wire_of(edges)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.join_text(report)


def _curve(module, edge, backwards, order):
    """Return the BSplineCurve of an edge, with so many poles that its other end stays."""
    curve = inputs.nurbs_of(edge)
    if curve.NbPoles < 2 * (order + 1):
        raise_degree = getattr(curve, "increaseDegree", None) or curve.increase
        raise_degree(2 * order + 1)
    if backwards:
        curve.reverse()
    return inputs.kernel_curve(module, curve)
