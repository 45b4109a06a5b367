# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about new surfaces: the table of their seams, and the summary.

The report is a dict with the result of the kernel and these keys:

* ``tolerance``
* ``poles``: their numbers along and across the sides
* ``seams``: each a seam with the additional keys ``side``, ``name`` (of its edges) and ``target``
"""

from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, new_seams, rows
from freecad.seamwright.plain.curve_text import bound
from freecad.seamwright.plain.summary import counted

#: heading, tool tip
COLUMNS = (
    ("Side", "The side of the surface"),
    ("Edge", "The edge of the model along which the surface runs"),
    ("Gap mm", "Largest distance between the two sides, in mm"),
    ("Angle \u00b0", "Largest angle between the tangent planes, in degrees"),
    ("Curvature %", "Largest relative difference of curvature, in %"),
    ("Result", "Whether the seam certainly has its level"),
)

#: Poles that move by less are those of an edge that stays, up to rounding.
UNMOVED_MM = 1e-9

FIGURES = ("gap_mm", "angle_deg", "curvature_rel")


@dataclass(frozen=True)
class Row:
    """One seam, ready to be shown."""

    met: bool
    cells: tuple  # texts, one for each of COLUMNS
    detail: str


def build_rows(report):
    """Return a Row for each seam of a report."""
    return [_row(seam, report["tolerance"]) for seam in report.get("seams", [])]


def _row(seam, tolerance):
    met = new_seams.certainly_meets(seam, tolerance, seam["target"])
    figures = (rows.figure_text(seam, name, tolerance) for name in FIGURES)
    cells = (seam["side"], seam["name"], *figures, _verdict(seam, tolerance, met))
    return Row(met, cells, rows.detail_text(seam, tolerance))


def _verdict(seam, tolerance, met):
    if met:
        return "%s is met" % seam["target"]
    missed = new_seams.certainly_misses(seam, tolerance, seam["target"])
    return ("misses %s" if missed else "%s is uncertain") % seam["target"]


def largest(seams):
    """Return {figure: upper bound over the seams whose level it decides}."""
    return {
        name: new_seams.bound([s for s in seams if name in rows.DECIDING[s["target"]]], name)
        for name in FIGURES
    }


def summary(report):
    """Return one line: the seams, or what falls short."""
    poles = "%d x %d poles" % tuple(report["poles"])
    found = largest(report["seams"])
    figures = "gap at most %s mm, angle at most %s\u00b0, curvature at most %s %%" % (
        bound(found["gap_mm"]),
        bound(found["angle_deg"]),
        bound(100 * found["curvature_rel"]),
    )
    state = "Every seam has its level" if report["reached"] else _shortcomings(report)
    length = ""
    if report["to"]:
        length = "; %s to %s mm long" % (
            enclosure.number(report["to"]["least_mm"]),
            enclosure.number(report["to"]["most_mm"]),
        )
    return "%s: %s; %s%s." % (state, figures, poles, length)


def umbrella_summary(report):
    """Return one line about faces around a point."""
    state = "every seam is G1" if report["reached"] else "not every seam is certainly G1"
    return "%s around the point: %s, gap at most %s mm, angle at most %s\u00b0; %s." % (
        counted(report["members"], "face"),
        state,
        bound(report["gap_mm"]),
        bound(report["angle_deg"]),
        _followed(report),
    )


def _followed(report):
    moved, fit = report["moved_mm"], report["fit_mm"]
    text = "no edge moved"
    if moved > UNMOVED_MM:
        text = "edges moved by at most %s mm" % bound(moved)
    return text + (", curves within %s mm of them" % bound(fit) if fit else "")


def loft_summary(report):
    """Return one line about the surface through curves."""
    text = "%s through %d curves, within %s mm" % (
        counted(report["faces"], "face"),
        report["keys"],
        bound(report["distance_mm"]),
    )
    if not report["seams"]:
        return text + "."
    return "%s; across %s: angle at most %s\u00b0, curvature at most %s %%." % (
        text,
        counted(len(report["seams"]), "line") + " of joints",
        bound(report["angle_deg"]),
        bound(100 * report["curvature_rel"]),
    )


def _shortcomings(report):
    parts = [
        "%s, %s" % (each.get("side", "lateral boundary"), each["reason"].rstrip("."))
        for each in report["sides"] + report["laterals"]
        if each["reason"]
    ]
    if report["fold"]:
        parts.append(
            "the surface folds %s mm from the side"
            % enclosure.number(report["fold"]["distance_mm"])
        )
    missed = [
        "%s is not certain at %s" % (seam["target"], seam["name"])
        for seam in report["seams"]
        if not new_seams.certainly_meets(seam, report["tolerance"], seam["target"])
    ]
    return "Not reached (%s)" % "; ".join(missed + parts)
