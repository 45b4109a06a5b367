# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences about curves that were made."""

import math

from freecad.seamwright.plain.enclosure import number
from freecad.seamwright.plain.summary import counted


def bound(value):
    """Return an upper bound as text, rounded up."""
    return number(value, rounding=math.ceil)


def failure_text(reason):
    """Return one line that says why there is no curve."""
    return "Not made: %s." % reason.rstrip(".")


def figures_text(report):
    """ "78.3 mm long; curvature: 3 extrema, 1 inflection": the figures of a curve."""
    return "%s mm long; curvature: %s, %s" % (
        number(report["length_mm"]),
        counted_as(report["extrema"], "extremum", "extrema"),
        counted(report["inflections"], "inflection"),
    )


def counted_as(count, one, many):
    """ "1 extremum", "2 extrema": for words whose plural has no s."""
    return "%d %s" % (count, one if count == 1 else many)


def arcs_text(report):
    """Return one line about arcs and lines near curves."""
    chains = "" if report["curves"] == 1 else " for %d curves" % report["curves"]
    text = "%s and %s%s, %s mm long, at most %s mm from the input" % (
        counted(report["arcs"], "arc"),
        counted(report["lines"], "line"),
        chains,
        number(report["length_mm"]),
        bound(report["distance_mm"]),
    )
    if not report["least_arcs"]:
        return text + ": the points are samples of these."
    return text + " (proven); no chain has fewer than %s." % report["least_arcs"]


def fair_text(report):
    """Return one line about a curve that was made fair."""
    before, after = report["before"], report["after"]
    kept = report["kept"]
    return "Curvature extrema %d \u2192 %d, inflections %d \u2192 %d; moved at most %s mm%s." % (
        before["extrema"],
        after["extrema"],
        before["inflections"],
        after["inflections"],
        bound(report["moved_mm"]),
        "; %s kept as given" % counted(kept, "edge") if kept else "",
    )


def spline_text(report):
    """Return one line about a spline."""
    relation = "Through" if report["interpolates"] else "Near the polygon of"
    return "%s %d points, %s." % (relation, report["points"], figures_text(report))


def clothoid_text(report):
    """Return one line about clothoids."""
    radius = report["least_radius_mm"]
    sharpest = "straight" if radius is None else "smallest radius %s mm" % number(radius)
    return "%s, %s mm long, %s, at most %s mm from the input." % (
        counted(report["pieces"], "piece"),
        number(report["length_mm"]),
        sharpest,
        bound(report["distance_mm"]),
    )


def log_spiral_text(report):
    """Return one line about a logarithmic spiral."""
    near = ", as %s of one sweep" % counted(report["arcs"], "arc")
    if report["distance_mm"] is not None:
        near = ", at most %s mm from the spiral" % bound(report["distance_mm"])
    return "%s mm long, turns by %s\u00b0, radius %s to %s mm%s." % (
        number(report["length_mm"]),
        number(report["turn_deg"]),
        number(report["first_radius_mm"]),
        number(report["last_radius_mm"]),
        near,
    )


def conic_text(report):
    """Return one line about conics."""
    joints = report["g1_joints"]
    return "%s, %s mm long, weights %s to %s%s." % (
        counted(report["conics"], "conic"),
        number(report["length_mm"]),
        number(report["least_weight"]),
        number(report["largest_weight"]),
        "; %s with a jump of the curvature" % counted(joints, "joint") if joints else "",
    )


def blend_text(report):
    """Return one line about curves between curves."""
    made = counted(report["frames"], "curve")
    if report["surface"]:
        made = "Surface of %s" % counted(report["faces"], "face")
    return "%s between %d curves, within %s mm; joints keep up to G%d, %s matched." % (
        made,
        report["keys"],
        bound(report["distance_mm"]),
        report["order"],
        counted(report["features"], "feature"),
    )


def join_text(report):
    """Return one line about two curves that were joined."""
    return "Joined G%d; the ends were %s mm apart, no %s moved further than %s mm." % (
        report["order"],
        number(report["gap_mm"]),
        "point" if report.get("continued") else "pole",
        bound(report["moved_mm"]),
    )


def bridge_text(report):
    """Return one line about a curve that joins two others."""
    return "Joined G%d to both edges, %s." % (report["order"], figures_text(report))
