# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fair Curve: edges with a fairer curvature within a tolerance, or a curve through faired points.

The class path is written into documents: neither rename nor move it.
"""

import math
from typing import NamedTuple

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.arcs import FLATNESS, SPLINE_SHARE, gather_points
from freecad.seamwright.document.curves.curve import Curve, each_asked
from freecad.seamwright.document.curves.plane import Plane
from freecad.seamwright.document.curves.samples import end_directions, runs_of
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, LENGTH, Option

ENERGY, VARIATION = mark("Least energy"), mark("Least variation of curvature")
NOTHING, POSITION, TANGENT = mark("Nothing"), mark("Position"), mark("Tangent")
CURVATURE = mark("Curvature")


#: Distance of the splines that hold clothoids, where the tolerance is 0.
LEAST_MM = 1e-6


class FairPoints(NamedTuple):
    """Faired points of a plane.

    ``parts``: of each run between corners (FairedPoints, SplineWithin through them); of two points
    there is no FairedPoints.
    """

    plane: Plane
    parts: list


class FairCurve(Curve):
    """Proxy of a Part::FeaturePython that holds a fairer curve."""

    Type = "FairCurve"
    LABEL = "Fair Curve"
    ICON = "seamwright-fair"
    TIP = (
        "Make the selected edges fair: splines whose curvature has few extrema and that move by "
        "no more than a tolerance. Points of a plane are moved, and a smooth curve goes through "
        "them."
    )
    NEEDS = "select edges, a wire or a sketch with splines, or points that lie in a plane"
    OPTIONS = (
        Option("Tolerance", "tolerance_mm", LENGTH, 0.1, "Tolerance",
               "No point moves further than this, in mm", least=0.0),
        Option("Method", "method", CHOICE, ENERGY, "Aim",
               "What is made least: the energy by the parameter, or the variation of the "
               "curvature by the length, which takes longer; of edges only",
               choices=(ENERGY, VARIATION)),
        Option("Ends", "ends", CHOICE, POSITION, "At the ends keep",
               "What stays at both ends of a curve; where edges meet, the tangent stays",
               choices=(NOTHING, POSITION, TANGENT, CURVATURE)),
        FLATNESS,
    )  # fmt: skip
    RESULTS = (
        ("ExtremaBefore", "App::PropertyInteger", "Extrema of the curvature before",
         "extrema_before"),
        ("ExtremaAfter", "App::PropertyInteger", "Extrema of the curvature now", "extrema_after"),
        ("Moved", "App::PropertyLength", "No point moved further, in mm", "moved_mm"),
    )  # fmt: skip
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return (closed, [(edge, curve), ...]) of each chain, or the Gathered of points.

        Edges that are all straight, as of a polyline, count as the points at their ends.
        """
        chains = inputs.chains_of(shapes)
        if all(inputs.is_straight(edge) for chain in chains for edge, _ in chain.edges):
            gathered = gather_points(shapes, values["flatness_mm"])
            if len(gathered.points) < 4:
                raise ValueError(
                    tr("there are {points} points: four or more can be made fair").format(
                        points=len(gathered.points)
                    )
                )
            return gathered
        curves = [
            [(edge, inputs.curve_of(module, edge)) for edge, _ in chain.edges] for chain in chains
        ]
        if not any(_can_be_faired(curve) for chain in curves for _, curve in chain):
            raise ValueError(
                tr(
                    "no edge is a polynomial spline of degree 2 or more: lines, arcs and rational "
                    "splines stay as they are"
                )
            )
        return [(chain.closed, edges) for chain, edges in zip(chains, curves)]

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return FairPoints, or for each chain [(edge, faired or None), ...]."""
        if not isinstance(gathered, list):
            return _fair_points(module, gathered, values)
        return [
            [
                (edge, _fair_edge(module, curve, values, _ends(values, closed, len(edges))))
                for edge, curve in each_asked(module, progress, edges)
            ]
            for closed, edges in gathered
        ]

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wires)."""
        if isinstance(found, FairPoints):
            return _of_points(module, found)
        wires = [
            results.wire_of(
                [
                    edge.copy() if _stays(fair) else module.curve_to_freecad(fair.curve).toShape()
                    for edge, fair in chain
                ]
            )
            for chain in found
        ]
        faired = [fair for chain in found for _, fair in chain if fair is not None]
        before = _counts([each.before for each in faired])
        after = _counts([each.before if _stays(each) else each.after for each in faired])
        kept = sum(_stays(fair) for chain in found for _, fair in chain)
        moved = max([0.0, *(each.moved_mm for each in faired if not _stays(each))])
        variations = _variations(module, [pair for chain in found for pair in chain])
        return _report(before, after, moved, kept, variations), results.together(wires)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.fair_text(report)


def _variations(module, pairs):
    """Return the integrals of the squared change of curvature before and after, in 1/mm^3.

    ``pairs``: of edges and what became of them; an edge that cannot be made fair does not count.
    Each is None where a curve may stop.
    """
    sums = [0.0, 0.0]
    for edge, fair in pairs:
        if fair is not None:
            given = inputs.curve_of(module, edge)
            for place, curve in enumerate((given, given if _stays(fair) else fair.curve)):
                sums[place] += module.curvature_variation(curve).energy_per_mm3
    return tuple(each if math.isfinite(each) else None for each in sums)


def _report(before, after, moved_mm, kept, variations):
    return {
        "variation_before_per_mm3": variations[0],
        "variation_after_per_mm3": variations[1],
        "before": before,
        "after": after,
        "extrema_before": before["extrema"],
        "extrema_after": after["extrema"],
        "moved_mm": moved_mm,
        "kept": kept,
    }


def _fair_edge(module, curve, values, ends):
    """Return the FairedCurve or PolishedCurve of a curve; None where it cannot be made fair."""
    if not _can_be_faired(curve):
        return None
    method = module.fair_curve if values["method"] == ENERGY else module.polish_curve
    return method(curve, values["tolerance_mm"], ends=ends)


def _stays(fair):
    """Return whether an edge stays as given: it cannot be made fair, or would not be fairer.

    It would get more inflections, or more extrema and inflections together.
    """
    if fair is None:
        return True
    before, after = _counts([fair.before]), _counts([fair.after])
    more = sum(after.values()) > sum(before.values())
    return more or after["inflections"] > before["inflections"]


def _counts(fairness):
    return {
        "extrema": sum(each.extrema + each.extrema_at_knots for each in fairness),
        "inflections": sum(each.inflections for each in fairness),
    }


def _can_be_faired(curve):
    return not curve.is_rational and curve.degree >= 2


def _ends(values, closed, count):
    """Return what stays at the ends of an edge: a closed curve stays smooth where it begins."""
    if count > 1:
        return "curvature" if values["ends"] == CURVATURE else "tangent"
    return "curvature" if closed else values["ends"].lower()


def _fair_points(module, gathered, values):
    tolerance = values["tolerance_mm"]
    runs = runs_of(module, gathered.points, gathered.closed, tolerance)
    fixed = values["ends"] != NOTHING or len(runs) > 1
    parts = []
    for points, closed in runs:
        faired = None
        if len(points) > 2:
            faired = module.fair_points(points, tolerance, closed=closed, ends_fixed=fixed)
            points = faired.points_mm
        ends = end_directions(points, closed)
        chain = module.clothoid_spline(points, closed=closed, **ends).chain
        parts.append((faired, chain.bezier_spline(SPLINE_SHARE * tolerance or LEAST_MM)))
    return FairPoints(gathered.plane, parts)


def _of_points(module, found):
    faired = [each for each, _ in found.parts if each is not None]
    before, after = (
        {
            "extrema": sum(len(each.extrema) for each in every),
            "inflections": sum(len(each.inflections) for each in every),
        }
        for every in ([each.before for each in faired], [each.after for each in faired])
    )
    splines = [results.raised(module, near.curve, found.plane) for _, near in found.parts]
    edges = [edge for spline in splines for edge in results.spline_edges(module, spline)]
    moved = max((each.moved_mm for each in faired), default=0.0)
    variations = [
        sum(each.energy_per_mm3 for each in every)
        for every in ([each.before for each in faired], [each.after for each in faired])
    ]
    return _report(before, after, moved, 0, variations), results.wire_of(edges)
