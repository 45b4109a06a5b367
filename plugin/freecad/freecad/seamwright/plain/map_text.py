# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summaries of the analysis tools."""

from freecad.seamwright.plain.ramps import figure
from freecad.seamwright.plain.summary import counted


def _at(point):
    return "at (%s)" % ", ".join(figure(round(each, 6)) for each in point)


def _range(report, unit):
    if report["undefined"]:
        return "No value is defined"
    return "%s to %s %s, the largest %s" % (
        figure(report["least"]),
        figure(report["largest"]),
        unit,
        _at(report["largest_at"]),
    )


def _mesh(report):
    faults = len(report["faults"])
    text = "%s, %s" % (counted(report["faces"], "face"), counted(report["points"], "point"))
    return text + (", %s not drawn correctly" % counted(faults, "face") if faults else "")


def curvature_text(report):
    """Return the summary of a Curvature Map."""
    if report["quantity"] == "Smallest radius" and not report["undefined"]:
        return "Smallest radius %s mm %s. %s." % (
            figure(report["least"]),
            _at(report["least_at"]),
            _mesh(report),
        )
    return "%s curvature %s. %s." % (
        report["quantity"],
        _range(report, report["unit"]),
        _mesh(report),
    )


def draft_text(report):
    """Return the summary of a Draft Angle."""
    shares = report["shares"]
    return "Of the area, %s %% drafts towards the pull, %s %% away, %s %% is too steep. %s." % (
        *(figure(round(100 * shares[key], 1)) for key in ("towards", "away", "steep")),
        _mesh(report),
    )


def reflection_text(report):
    """Return the summary of Reflection Lines."""
    return "%s. %s." % (report["lines"], _mesh(report))


def deviation_text(report):
    """Return the summary of a Deviation."""
    if report["undefined"]:
        return "No point lies over the other shape"
    parts = "Largest deviation %s mm %s; %s to %s mm" % (
        figure(report["furthest_mm"]),
        _at(report["furthest_at"]),
        figure(report["least"]),
        figure(report["largest"]),
    )
    if report["beyond"]:
        parts += "; %s beyond the edges of the other shape left out" % counted(
            report["beyond"], "point"
        )
    return "%s. Sampled at %s: between them it may be larger." % (
        parts,
        counted(report["points"], "point"),
    )


def comb_text(report):
    """Return the summary of a Curvature Comb."""
    if not report["largest_per_mm"]:
        return "%s; all are straight." % counted(report["lines"], "curve")
    return "%s; largest curvature %s 1/mm, radius %s mm, %s. Sampled." % (
        counted(report["lines"], "curve"),
        figure(report["largest_per_mm"]),
        figure(1 / report["largest_per_mm"]),
        _at(report["largest_at"]),
    )
