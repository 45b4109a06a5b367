# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blend Curves: curves between curves that keep their joints smooth, or the surface through them.

The class path is written into documents: neither rename nor move it.
"""

from typing import Any, List, NamedTuple

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve, each_asked, share_of
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, COUNT, FLAG, LENGTH, Option

FEATURES, BY_LENGTH = mark("Corners and extrema"), mark("Equal lengths")
CURVES, SURFACE = mark("Curves"), mark("Surface")
BETWEEN = ("C1", "C2")
ORDERS = ("G1", "G2", "G3", "G4")


class Blended(NamedTuple):
    """Frames, or the lofts through their parts, with how the key curves were matched.

    ``keys_mm``: the largest distance of the splines that take the place of the key curves.
    """

    keys: int
    summary: Any
    keys_mm: float
    order: int
    frames: List[Any]
    lofts: List[Any]


class BlendCurves(Curve):
    """Proxy of a Part::FeaturePython that holds curves between curves."""

    Type = "BlendCurves"
    LABEL = "Blend Curves"
    ICON = "seamwright-blend"
    TIP = (
        "Make curves between two or more selected curves, or the surface through them. Every "
        "joint of a curve between is as smooth as those of the selected ones."
    )
    NEEDS = "select two or more edges, wires or sketches"
    OPTIONS = (
        Option("Result", "result", CHOICE, CURVES, "Make", "Single curves, or a surface",
               choices=(CURVES, SURFACE)),
        Option("Frames", "frames", COUNT, 5, "Number of curves",
               "Number of curves, with the first and the last of the selected ones", least=2.0,
               used=lambda values: values["result"] == CURVES),
        Option("Order", "order", CHOICE, "G2", "Joints keep",
               "The continuity that every joint keeps: tangents (G1), curvature (G2) or more",
               choices=ORDERS),
        Option("Match", "match", CHOICE, FEATURES, "Match by",
               "Which points of the curves correspond", choices=(FEATURES, BY_LENGTH)),
        Option("Exact", "exact", FLAG, False, "Divide the selected curves only",
               "Divide the selected curves into corresponding pieces; otherwise, splines near them "
               "take their place, so that the curves between are fairer"),
        Option("Between", "between", CHOICE, "C2", "Through inner curves",
               "How smoothly the curves between change at a selected curve that is neither the "
               "first nor the last", choices=BETWEEN),
        Option("Tolerance", "tolerance_mm", LENGTH, 1e-3, "Tolerance",
               "Largest distance of these splines and of the surface, in mm", least=0.0),
    )  # fmt: skip
    RESULTS = (
        ("Distance", "App::PropertyLength", "Distance from the curves, in mm", "distance_mm"),
        ("Faces", "App::PropertyInteger", "Number of faces of the surface", "faces"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return the splines of the key curves, in the order of the shapes."""
        splines = [
            inputs.spline_of(module, chain)
            for shape in shapes
            for chain in inputs.chains_of([shape])
        ]
        if any(not shape.Edges for shape in shapes):
            raise ValueError(tr("a point is chosen: choose edges, wires or sketches"))
        if len(splines) < 2:
            raise ValueError(tr("there is only one curve: choose two or more"))
        if len({spline.closed for spline in splines}) > 1:
            raise ValueError(tr(
                "some curves are closed and some are open: choose curves of one kind"
            ))
        return splines

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Blended."""
        how = {
            "by": "features" if values["match"] == FEATURES else "length",
            "find_start": gathered[0].closed,
            "find_direction": True,
        }
        tolerance = values["tolerance_mm"]
        if values["exact"]:
            matched, keys_mm = module.match_pieces(gathered, **how), 0.0
            if values["result"] == SURFACE and any(each.is_rational for each in matched.curves):
                raise ValueError(
                    tr(
                        "arcs and rational splines can only be divided for single curves: for a "
                        "surface, let splines take their place"
                    )
                )
        else:
            matched = module.common_knots(gathered, tolerance_mm=tolerance, **how)
            keys_mm = max(matched.distance_mm)
            if not matched.reached:
                raise ValueError(
                    tr(
                        "no splines within {tolerance:g} mm of the curves were found: take a "
                        "larger tolerance"
                    ).format(tolerance=tolerance)
                )
        order = 1 + ORDERS.index(values["order"])
        blend = module.SplineBlend(
            matched.curves, order=order, continuity=values["between"], keep_lower_orders=True
        )
        frames, lofts = [], []
        if values["result"] == SURFACE:
            lofts = _lofts(module, blend, order, tolerance, progress)
        else:
            last = values["frames"] - 1
            places = [k / last for k in range(values["frames"])]
            frames = [
                blend.frame_at(place).curve for place in each_asked(module, progress, places)
            ]
        return Blended(len(gathered), matched.summary, keys_mm, order, frames, lofts)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wires or surface)."""
        if found.lofts:
            distance = max(loft.distance_mm for loft in found.lofts)
            shape = results.surface_shape([loft.surface for loft in found.lofts], 2 * distance)
        else:
            wires = [
                results.wire_of(results.spline_edges(module, frame)) for frame in found.frames
            ]
            shape, distance = results.together(wires), 0.0
        report = {
            "keys": found.keys,
            "features": found.summary.matched_features,
            "order": found.order,
            "surface": bool(found.lofts),
            "frames": len(found.frames),
            "faces": len(shape.Faces),
            "distance_mm": found.keys_mm + distance,
        }
        return report, shape

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.blend_text(report)


def _lofts(module, blend, order, tolerance_mm, progress):
    """Return the FrameLofts of the parts of frames between joints of a lower order."""
    first = blend.frame_at(blend.omegas[0]).curve
    count = first.segments
    ends = [joint for joint, own in enumerate(blend.orders, 1) if own < order]
    whole = not ends
    if first.closed:
        ends = [*ends, ends[0] + count] if ends else [0, count]
    else:
        ends = [0, *ends, count]
    span, inner = (blend.omegas[0], blend.omegas[-1]), blend.omegas[1:-1]
    lofts = []
    for place, part in enumerate(zip(ends, ends[1:])):
        frames, given = (blend, {})
        if not whole:
            frames = _part(module, blend, *part)
            given = {"omegas": span, "stations": inner}
        share = share_of(progress, place, len(ends) - 1)
        lofts.append(
            module.frame_loft(
                frames, order=order, tolerance_mm=tolerance_mm, progress=share, **given
            )
        )
        if not lofts[-1].reached:
            raise ValueError(
                tr(
                    "the surface comes within {distance_mm:.3g} mm of the curves between, not "
                    "within {tolerance_mm:g} mm: take a tolerance above {distance_mm:.3g} mm"
                ).format(distance_mm=lofts[-1].distance_mm, tolerance_mm=tolerance_mm)
            )
    return lofts


def _part(module, blend, first, last):
    """Return a callable(omega) -> BezierSpline of the segments first to last of the frame.

    Segments of a closed frame go on after its end.
    """

    def frame(omega):
        curve = blend.frame_at(omega).curve
        count, period = curve.segments, curve.knots[-1] - curve.knots[0]
        segments = [curve.segment(place % count) for place in range(first, last)]
        knots = [
            curve.knots[place % count] + place // count * period
            for place in range(first, last + 1)
        ]
        return module.BezierSpline.from_segments(segments, knots)

    return frame
