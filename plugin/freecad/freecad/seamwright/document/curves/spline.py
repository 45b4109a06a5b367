# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spline: a G2 spline through points or near their polygon, with tension and bias for each point.

The class path is written into documents: neither rename nor move it.
"""

import numpy

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import (
    CHOICE, COUNT, FLAG, NUMBERS, VECTOR, VECTORS, Option, one_for_each
)  # fmt: skip

NU, BETA = mark("Through points, tension"), mark("Through points, tension and bias")
GAMMA, DIRECT = mark("Polygon, gamma"), mark("Polygon, direct G2")
ALPHA = mark("Polygon, alpha curves")

#: The families whose spline passes through the points.
INTERPOLATING = (NU, BETA)

#: Points that a report has, so that the view can number them.
MOST_NUMBERED = 100

SAMPLES = Option(
    "Samples", "samples", COUNT, 4, "Points on curved edges",
    "Number of points taken between the ends of each edge that is not straight", least=0.0,
)  # fmt: skip

#: The tangent of a free end.
FREE = (0.0, 0.0, 0.0)


def of_family(*families):
    """Return a condition: whether the family is one of these."""
    return lambda values: values["family"] in families


class Spline(Curve):
    """Proxy of a Part::FeaturePython that holds a spline of points."""

    Type = "Spline"
    LABEL = "Spline"
    ICON = "seamwright-spline"
    TIP = (
        "Make a spline with continuous curvature through the selected points or the points of a "
        "wire, a sketch or edges, or near the polygon of these points. Tension and bias shape it "
        "at each point."
    )
    NEEDS = "select points, edges, a wire or a sketch"
    PICKS = True
    OPTIONS = (
        Option("Family", "family", CHOICE, NU, "Family", "How the spline is made of the points",
               choices=(NU, BETA, GAMMA, DIRECT, ALPHA)),
        Option("Closed", "closed", FLAG, False, "Closed",
               "Join the last point to the first; wires that are closed always are"),
        Option("Tension", "tension", NUMBERS, [0.0], "Tension",
               "One number for each point, or one for all. It tightens the spline: the larger the "
               "number without bias, the more negative with bias",
               used=of_family(NU, BETA)),
        Option("Bias", "bias", NUMBERS, [1.0], "Bias",
               "One number for each point, or one for all: the speed before the point by that "
               "after it", least=1e-9, used=of_family(BETA)),
        Option("Gamma", "gamma", NUMBERS, [1.0], "Gamma",
               "One number for each segment, or one for all: 1 is the B-spline, smaller ones draw "
               "the curve to the polygon", least=1e-9, used=of_family(GAMMA)),
        Option("FirstShare", "first_share", NUMBERS, [1.0 / 3], "First pole at",
               "Share of each side of the polygon at which its first inner pole lies; one number "
               "for each side, or one for all", least=0.0, used=of_family(DIRECT)),
        Option("SecondShare", "second_share", NUMBERS, [2.0 / 3], "Second pole at",
               "Share of each side of the polygon at which its second inner pole lies; one number "
               "for each side, or one for all", least=0.0, used=of_family(DIRECT)),
        Option("Alpha", "alpha", NUMBERS, [0.75], "Alpha",
               "One number above 0.5, up to 1, for each segment, or one for all: 1 is nearest to "
               "the polygon", least=0.0, used=of_family(ALPHA)),
        SAMPLES,
        Option("Points", "points_mm", VECTORS, [], "Own points",
               "Points of the spline that belong to no other object, in mm; where there are any, "
               "the sources are not used"),
        Option("Moves", "moves_mm", VECTORS, [], "Moves",
               "By how much the points of the sources were moved, in mm; one for each, or none"),
        Option("StartTangent", "start_tangent_mm", VECTOR, FREE, "Start tangent",
               "From the first point to the next pole, in mm; 0: the end is free",
               used=of_family(NU, BETA)),
        Option("EndTangent", "end_tangent_mm", VECTOR, FREE, "End tangent",
               "From the last pole but one to the last point, in mm; 0: the end is free",
               used=of_family(NU, BETA)),
    )  # fmt: skip
    RESULTS = (
        ("Extrema", "App::PropertyInteger", "Extrema of the curvature", "extrema"),
        ("Inflections", "App::PropertyInteger", "Inflections of a planar curve", "inflections"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def needs_sources(cls, values):
        """Return whether there is no spline without sources."""
        return not values["points_mm"]

    @classmethod
    def gather(cls, module, shapes, values):
        """Return (points, whether the spline is closed)."""
        points, closed = cls.points_before(shapes, values)
        if not values["points_mm"]:
            points, closed = _moved(points, closed, values["moves_mm"])
        closed = closed or values["closed"]
        least = _least(values["family"], closed)
        if len(points) < least:
            raise ValueError(
                tr("there are {points} points: {what} needs {least} or more").format(
                    points=len(points),
                    what=tr("a closed spline") if closed else tr("such a spline"),
                    least=least,
                )
            )
        return points, closed

    @classmethod
    def points_before(cls, shapes, values):
        """Return (points, whether they are closed) of shapes, or the own ones, without moves."""
        if values["points_mm"]:
            return inputs.checked_points(values["points_mm"], closed=False)
        return inputs.points_of(shapes, values["samples"])

    @classmethod
    def curve(cls, module, points, closed, values):
        """Return the spline of the kernel. Any thread may call it."""
        return MAKERS[values["family"]](module, points, closed, values)

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return (spline of the kernel, points)."""
        points, closed = gathered
        return cls.curve(module, points, closed, values), points

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wire)."""
        spline, points = found
        wire = results.wire_of(results.spline_edges(module, spline))
        report = {
            **results.figures(module, spline, wire.Length),
            "points": len(points),
            "points_mm": points[:MOST_NUMBERED].tolist(),
            "interpolates": values["family"] in INTERPOLATING,
        }
        return report, wire

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.spline_text(report)


def _least(family, closed):
    if closed:
        return 3
    return 2 if family in INTERPOLATING else 4


def _moved(points, closed, moves):
    if not moves:
        return points, closed
    if len(moves) != len(points):
        raise ValueError(
            tr(
                "{moves} points were moved, but the sources have {points}: empty the property Moves"
            ).format(moves=len(moves), points=len(points))
        )
    return inputs.checked_points(points + numpy.array(moves), closed)


def _ring(points):
    return numpy.vstack([points, points[:1]])


def _nu(module, points, closed, values):
    tension = one_for_each("Tension", values["tension"], len(points), mark("points"))
    if not closed:
        return _with_ends(lambda **ends: module.nu_spline(points, nu=tension, **ends).curve, values)
    # The tensions at both ends of a ring add up.
    found = module.nu_spline(_ring(points), nu=[*tension, 0.0], ends="periodic")
    return found.curve


def _beta(module, points, closed, values):
    count = len(points)
    tension = one_for_each("Tension", values["tension"], count, mark("points"))
    bias = one_for_each("Bias", values["bias"], count, mark("points"))
    if not closed:
        return _with_ends(
            lambda **ends: module.beta_spline(points, bias, tension, **ends).curve, values
        )
    # The first entry of a ring is not read: the last one is that of the same point.
    found = module.beta_spline(
        _ring(points), [*bias, bias[0]], [*tension, tension[0]], ends="periodic"
    )
    return found.curve


def _with_ends(make, values):
    """Return the spline that ``make`` makes with the tangents of its ends; others are free.

    ``make(ends=, start_derivative=, end_derivative=)`` returns a cubic spline.
    """
    free = make()
    given = [
        numpy.array(values[name]) if any(values[name]) else None
        for name in ("start_tangent_mm", "end_tangent_mm")
    ]
    if all(each is None for each in given):
        return free
    knots = numpy.asarray(free.knots)
    lengths = knots[1] - knots[0], knots[-1] - knots[-2]
    derivatives = [
        None if each is None else free.degree * each / length
        for each, length in zip(given, lengths)
    ]

    def clamped(start, end):
        return make(ends="clamped", start_derivative=start, end_derivative=end)

    if derivatives[0] is None:
        derivatives[0] = _free_derivative(free, 0, lambda each: clamped(each, derivatives[1]))
    elif derivatives[1] is None:
        derivatives[1] = _free_derivative(free, -1, lambda each: clamped(derivatives[0], each))
    return clamped(*derivatives)


def _free_derivative(free, end, make):
    """Return the derivative at an end (0 or -1) that makes this end as free as it is in ``free``.

    A free end has X'' = k X'. ``make(derivative)``: the spline with a derivative at this end; its
    X'' is linear in it, by the same factor in each coordinate.
    """
    _, first, second = _at_end(free, end)
    factor = second @ first / (first @ first)
    _, _, offset = _at_end(make(numpy.zeros(3)), end)
    _, _, one = _at_end(make(numpy.ones(3)), end)
    return -offset / (one - offset - factor)


def _at_end(spline, end):
    place = 0 if end == 0 else spline.segments - 1
    length = spline.knots[place + 1] - spline.knots[place]
    found = numpy.asarray(spline.segment(place).derivatives(0.0 if end == 0 else 1.0, 2))
    return found / numpy.array([1.0, length, length**2])[:, None]


def _segments(points, closed):
    return len(points) if closed else len(points) - 3


def _gamma(module, points, closed, values):
    gamma = one_for_each("Gamma", values["gamma"], _segments(points, closed), mark("segments"))
    return module.gamma_spline(points, gamma=gamma, closed=closed)


def _direct(module, points, closed, values):
    sides = len(points) if closed else len(points) - 1
    shares = [
        one_for_each(label, values[argument], sides, mark("sides"))
        for label, argument in (
            ("First pole at", "first_share"),
            ("Second pole at", "second_share"),
        )
    ]
    return module.direct_g2_spline(points, *shares, closed)


def _alpha(module, points, closed, values):
    shape = one_for_each("Alpha", values["alpha"], _segments(points, closed), mark("segments"))
    return module.alpha_spline(points, shape, closed=closed)


MAKERS = {NU: _nu, BETA: _beta, GAMMA: _gamma, DIRECT: _direct, ALPHA: _alpha}
