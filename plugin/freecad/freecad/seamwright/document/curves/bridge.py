# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bridge Curve: a curve between ends of two edges, with their tangents and curvatures.

The class path is written into documents: neither rename nor move it.
"""

import math

import numpy

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.options import CHOICE, FLAG, FLOAT, Option

ORDERS = ("G0", "G1", "G2", "G3")

#: The distance of a handle from its end for the tension 1, by the distance of the ends: that of the
#: inner poles of a cubic.
HANDLE_SHARE = 1.0 / 3


class BridgeCurve(Curve):
    """Proxy of a Part::FeaturePython that holds a curve between two edges."""

    Type = "BridgeCurve"
    LABEL = "Bridge Curve"
    ICON = "seamwright-bridge"
    TIP = (
        "Make a curve from an end of one selected edge to an end of another one. It continues each "
        "with its own order: position (G0), tangent (G1), curvature (G2) or its change (G3)."
    )
    NEEDS = "select two edges"
    OPTIONS = (
        Option("FirstOrder", "first_order", CHOICE, "G2", "Joins the first",
               "The continuity with the first edge", choices=ORDERS),
        Option("FirstTension", "first_tension", FLOAT, 1.0, "Tension at the first",
               "Length of the tangent at the first edge, by the distance of the ends", least=1e-3,
               used=lambda values: values["first_order"] != "G0"),
        Option("SecondOrder", "second_order", CHOICE, "G2", "Joins the second",
               "The continuity with the second edge", choices=ORDERS),
        Option("SecondTension", "second_tension", FLOAT, 1.0, "Tension at the second",
               "Length of the tangent at the second edge, by the distance of the ends",
               least=1e-3, used=lambda values: values["second_order"] != "G0"),
        Option("FlipFirst", "flip_first", FLAG, False, "Other end of the first",
               "Begin at the other end of the first edge"),
        Option("FlipSecond", "flip_second", FLAG, False, "Other end of the second",
               "End at the other end of the second edge"),
    )  # fmt: skip
    RESULTS = (
        ("Extrema", "App::PropertyInteger", "Extrema of the curvature", "extrema"),
        ("Inflections", "App::PropertyInteger", "Inflections of a planar curve", "inflections"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return (curve that arrives, curve that leaves, distance of these ends in mm)."""
        edges = inputs.edges_of(shapes)
        flips = values["flip_first"], values["flip_second"]
        at_first, at_second = inputs.ends_to_bridge(edges, flips)
        first, second = (inputs.ends_of(edge) for edge in edges)
        distance = first[at_first].distanceToPoint(second[at_second])
        one, other = (inputs.curve_of(module, edge).bezier_spline() for edge in edges)
        arriving, to_second = _out_of(one, at_first), _out_of(other, at_second)
        return arriving, to_second.reversed(), distance

    @classmethod
    def add_properties(cls, obj):
        """Add the properties that an object lacks; an older one has one order for both ends."""
        before = getattr(obj, "Order", None)
        super().add_properties(obj)
        if before is not None:
            obj.FirstOrder = obj.SecondOrder = before
            obj.removeProperty("Order")

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return (BezierCurve between, the handles of its tensions)."""
        arriving, leaving, distance = gathered
        orders = [ORDERS.index(values[name]) for name in ("first_order", "second_order")]
        before = numpy.asarray(arriving.derivatives(1.0, max(1, orders[0])))
        after = numpy.asarray(leaving.derivatives(0.0, max(1, orders[1])))
        speeds = numpy.linalg.norm(before[1]), numpy.linalg.norm(after[1])
        for order, speed in zip(orders, speeds):
            if order > 0 and speed == 0:
                raise ValueError(tr("an edge has no tangent at its end: choose another end"))
        back = before * (-1.0) ** numpy.arange(len(before))[:, None]
        sides = _from_derivatives(module, back).reversed(), _from_derivatives(module, after)
        betas, handles = ([], []), {}
        reach = distance * HANDLE_SHARE
        if orders[0]:
            first = values["first_tension"] * distance / speeds[0]
            betas[0].extend([first, *[0.0] * (orders[0] - 1)])
            step = before[1] * (reach / speeds[0])
            handles["first_tension"] = (before[0].tolist(), step.tolist())
        if orders[1]:
            second = speeds[1] / (values["second_tension"] * distance)
            betas[1].extend([second, *[0.0] * (orders[1] - 1)])
            step = after[1] * (-reach / speeds[1])
            handles["second_tension"] = (after[0].tolist(), step.tolist())
        return module.curve_blend(*sides, *betas), handles

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        curve, handles = found
        wire = results.wire_of([module.curve_to_freecad(curve).toShape()])
        report = {
            **results.figures(module, curve, wire.Length),
            "orders": [values["first_order"], values["second_order"]],
            "handles": handles,
        }
        return report, wire

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.bridge_text(report)


def _out_of(spline, at_end):
    """Return the segment that runs out of one end of a spline."""
    return spline.segment(spline.segments - 1) if at_end else spline.segment(0).reversed()


def _from_derivatives(module, derivatives):
    """Return the polynomial BezierCurve that has these derivatives where it begins."""
    degree = len(derivatives) - 1
    return module.BezierCurve(
        [
            sum(
                math.comb(k, j) * math.factorial(degree - j) / math.factorial(degree) * each
                for j, each in enumerate(derivatives[: k + 1])
            )
            for k in range(degree + 1)
        ]
    )
