# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences about curves that were made."""

import math

from freecad.seamwright.plain.enclosure import number
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.summary import capital, counted


#: A weight that differs by less from 1, up to rounding, is that of a parabola.
PARABOLA = 1e-9


def bound(value):
    """Return an upper bound as text, rounded up."""
    return number(value, rounding=math.ceil)


def failure_text(reason):
    """Return one line that says why there is no curve."""
    return tr("Not made: {reason}.").format(reason=reason.rstrip("."))


def figures_text(report):
    """ "78.3 mm long; curvature: 3 extrema, 1 inflection": the figures of a curve."""
    return tr("{length_mm} mm long; curvature: {extrema}, {inflections}").format(
        length_mm=number(report["length_mm"]),
        extrema=counted(report["extrema"], "extremum"),
        inflections=counted(report["inflections"], "inflection"),
    )


def arcs_text(report):
    """Return one line about arcs and lines near curves."""
    chains = "" if report["curves"] == 1 else tr(" for {curves} curves").format(
        curves=report["curves"]
    )
    text = tr(
        "{arcs} and {lines}{chains}, {length_mm} mm long, at most {distance_mm} mm from the input"
    ).format(
        arcs=counted(report["arcs"], "arc"),
        lines=counted(report["lines"], "line"),
        chains=chains,
        length_mm=number(report["length_mm"]),
        distance_mm=bound(report["distance_mm"]),
    )
    text = capital(text)
    if not report["least_arcs"]:
        return text + tr(": the points are samples of these.")
    if not report["arcs"]:
        return text + tr(" (proven).")
    return text + tr(" (proven); no fewer than {least_arcs} will do.").format(
        least_arcs=counted(report["least_arcs"], "arc")
    )


def fair_text(report):
    """Return one line about a curve that was made fair."""
    before, after = report["before"], report["after"]
    kept = report["kept"]
    return tr(
        "Curvature extrema {extrema} \u2192 {extrema_after}, inflections {inflections} \u2192 "
        "{inflections_after}{variation}; moved at most {moved_mm} mm{kept}."
    ).format(
        variation=_variation_text(report),
        extrema=before["extrema"],
        extrema_after=after["extrema"],
        inflections=before["inflections"],
        inflections_after=after["inflections"],
        moved_mm=bound(report["moved_mm"]),
        kept=tr("; {kept} kept as given").format(kept=counted(kept, "edge")) if kept else "",
    )


def _variation_text(report):
    """ ", variation of curvature 1.2e-4 \u2192 3e-5 1/mm\u00b3 (75 % less)"."""
    before, after = (report["variation_%s_per_mm3" % when] for when in ("before", "after"))
    if not before or after is None:
        return ""
    text = tr(", variation of curvature {before} \u2192 {after} 1/mm\u00b3").format(
        before=number(before), after=number(after)
    )
    share = number(100 * abs(after - before) / before, 2)
    if after < before:
        text += tr(" ({share} % less)").format(share=share)
    elif after > before:
        text += tr(" ({share} % more)").format(share=share)
    return text


def spline_text(report):
    """Return one line about a spline."""
    text = tr("Near the polygon of {points} points, {figures}.")
    if report["interpolates"]:
        text = tr("Through {points} points, {figures}.")
    return text.format(points=report["points"], figures=figures_text(report))


def clothoid_text(report):
    """Return one or two sentences about clothoids."""
    radius = report["least_radius_mm"]
    sharpest = tr("straight") if radius is None else tr("smallest radius {radius} mm").format(
        radius=number(radius)
    )
    text = tr(
        "{pieces}, {length_mm} mm long, {sharpest}, at most {distance_mm} mm from the input."
    ).format(
        pieces=counted(report["pieces"], "piece"),
        length_mm=number(report["length_mm"]),
        sharpest=sharpest,
        distance_mm=bound(report["distance_mm"]),
    )
    if report.get("curves", 1) > 1:
        text += tr(
            " There are {curves} separate curves: edges that do not touch are not joined; Bridge "
            "Curve does that."
        ).format(curves=report["curves"])
    return text


def log_spiral_text(report):
    """Return one line about a logarithmic spiral."""
    near = tr(", as {arcs} of one sweep").format(arcs=counted(report["arcs"], "arc"))
    if report["distance_mm"] is not None:
        near = tr(", at most {distance_mm} mm from the spiral").format(
            distance_mm=bound(report["distance_mm"])
        )
    return tr(
        "{length_mm} mm long, turns by {turn_deg}\u00b0, radius {first_radius_mm} to "
        "{last_radius_mm} mm{near}."
    ).format(
        length_mm=number(report["length_mm"]),
        turn_deg=number(report["turn_deg"]),
        first_radius_mm=number(report["first_radius_mm"]),
        last_radius_mm=number(report["last_radius_mm"]),
        near=near,
    )


def conic_text(report):
    """Return one line about conics."""
    joints, distance_mm = report["g1_joints"], report.get("distance_mm")
    near = "" if distance_mm is None else tr("; seen up to {distance_mm} mm from the edges").format(
        distance_mm=bound(distance_mm)
    )
    return tr(
        "{conics}, {length_mm} mm long{jumps}{near}."
    ).format(
        near=near,
        conics=_kind_of_conics(report),
        length_mm=number(report["length_mm"]),
        jumps=tr("; {joints} with a jump of the curvature").format(joints=counted(joints, "joint"))
        if joints
        else "",
    )


def _kind_of_conics(report):
    """ "A parabola", "An ellipse of weight 0.7", "3 conics of weights 0.5 to 1"."""
    least, largest = report["least_weight"], report["largest_weight"]
    if report["conics"] != 1:
        return tr("{conics} of weights {least_weight} to {largest_weight}").format(
            conics=counted(report["conics"], "conic"),
            least_weight=number(least),
            largest_weight=number(largest),
        )
    if abs(least - 1) <= PARABOLA:
        return tr("A parabola")
    kind = mark("A hyperbola of weight {weight}")
    if least < 1:
        kind = mark("An ellipse of weight {weight}")
    return tr(kind).format(weight=number(least))


def blend_text(report):
    """Return one line about curves between curves."""
    made = counted(report["frames"], "curve")
    if report["surface"]:
        made = tr("Surface of {faces}").format(faces=counted(report["faces"], "face"))
    return tr(
        "{made} between {keys} curves, within {distance_mm} mm; joints keep up to G{order}, "
        "{features} paired."
    ).format(
        made=made,
        keys=report["keys"],
        distance_mm=bound(report["distance_mm"]),
        order=report["order"],
        features=counted(report["features"], "feature"),
    )


def join_text(report):
    """Return one line about two curves that were joined."""
    return tr(
        "Joined G{order}; the ends were {gap_mm} mm apart, no {what} moved further than "
        "{moved_mm} mm."
    ).format(
        order=report["order"],
        gap_mm=number(report["gap_mm"]),
        what=tr("point") if report.get("continued") else tr("pole"),
        moved_mm=bound(report["moved_mm"]),
    )


def bridge_text(report):
    """Return one line about a curve that joins two others."""
    first, second = report["orders"]
    return tr("Joins the first edge {first} and the second {second}, {figures}.").format(
        first=first, second=second, figures=figures_text(report)
    )
