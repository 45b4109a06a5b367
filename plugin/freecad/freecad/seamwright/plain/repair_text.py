# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about a repair: the table of the seams that were to be repaired, and the summary.

The report is a dict with these keys:

* ``target``: "G1" or "G2"
* ``tolerance``
* ``chosen``: whether the user named the seams
* ``seams``: the seams that were to be repaired, each a dict of before, after, repaired and reason
* ``moves``: dicts of face and largest_move_mm
* ``edges_led``: number of edges that got new pcurves
* ``sewn``: number of seams that were sewn
* ``total``: number of all seams
* ``defects``, ``gap_mm``, ``angle_deg``: [before, after] of the whole model

Values after the repair are None where nothing was repaired yet.
"""

import math
import re
from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, rows, summary
from freecad.seamwright.plain.language import mark, tr

ARROW = " \u2192 "

REPAIRED, NOT_REPAIRED, WAITING = mark("repaired"), "not repaired", "waiting"

EMPTY_REPORT = {
    "target": "G1",
    "tolerance": {},
    "chosen": False,
    "seams": [],
    "moves": [],
    "edges_led": 0,
    "sewn": 0,
    "total": 0,
    **{name: [None, None] for name in ("defects", "gap_mm", "angle_deg")},
}


@dataclass(frozen=True)
class Row:
    """One seam that was to be repaired, ready to be shown."""

    seam: int
    edges: tuple
    state: str  # REPAIRED, NOT_REPAIRED or WAITING
    cells: tuple  # texts, one for each of COLUMNS
    detail: str


#: heading, tool tip
COLUMNS = (
    (mark("Edge"), mark("The edge or edges of the seam")),
    (mark("Faces"), mark("Numbers of the two faces that meet")),
    (
        mark("Angle \u00b0"),
        mark("Largest angle between the tangent planes, before and after, in degrees"),
    ),
    (
        mark("Gap {unit}"),
        mark("Largest distance between the two sides, before and after, in {unit}"),
    ),
    (mark("Curvature %"), mark("Largest relative difference of curvature, before and after, in %")),
    (mark("Result"), mark("Repaired, or why not")),
)

#: The column that is shown only for the target G2.
CURVATURE_COLUMN = 4


def build_report(before, after, seams, moves, target, chosen, edges_led=0):
    """Build the report from the result of the kernel.

    ``before``, ``after``: reports of the analysis; ``after`` is None before the repair. ``seams``:
    a dict for each seam of the model: before, after, treated, repaired, reason, and sewn where the
    kernel tells it. ``edges_led``: the number of edges that got new pcurves.
    """
    wanted = [
        {name: seam[name] for name in ("before", "after", "repaired", "reason")}
        for seam in seams
        if seam["treated"] or seam["reason"]
    ]
    both = (before, after)
    return {
        "target": target,
        "tolerance": before["tolerance"],
        "chosen": chosen,
        "seams": wanted,
        "moves": moves,
        "edges_led": edges_led,
        "sewn": sum(seam.get("sewn", False) for seam in seams),
        "total": len(before["seams"]),
        "defects": [
            None if each is None else summary.class_counts(each)["defect"] for each in both
        ],
        **{name: [_largest(each, name) for each in both] for name in ("gap_mm", "angle_deg")},
    }


def _largest(report, name):
    return None if report is None else summary.largest(report, name)


def waiting(before, target, edges):
    """Return the seams that a repair would treat, as ``build_report`` takes them.

    ``before``: the report of an analysis at the level ``target``. ``edges``: the numbers of the
    edges that the user named; empty means all defects.
    """

    def is_wanted(seam):
        if not edges:
            return seam["class"] == "defect"
        short = rows.LEVELS.index(seam["level"]) < rows.LEVELS.index(target)
        return short and not edges.isdisjoint(seam["edges"])

    return [
        {"before": seam, "after": None, "treated": is_wanted(seam), "repaired": False, "reason": ""}
        for seam in before["seams"]
    ]


def is_done(report):
    """Return whether a repair was computed, not only its candidates."""
    return report["defects"][1] is not None


def repaired_count(report):
    """Return the number of repaired seams."""
    return sum(seam["repaired"] for seam in report["seams"])


def has_changed(report):
    """Return whether the shape of the result differs from the source."""
    return bool(report["moves"] or report["edges_led"] or report["sewn"])


def largest_move_mm(report):
    """Return the largest move of a pole, beyond which no point moved; 0 when no face moved."""
    return max((move["largest_move_mm"] for move in report["moves"]), default=0.0)


def summary_text(report):
    """Return one line: how many seams were repaired, what moved, and how many defects remain."""
    wanted, target = len(report["seams"]), report["target"]
    if not wanted and not has_changed(report):
        return _nothing_text(report)
    if not is_done(report):
        return tr("{wanted} to repair to {target}.").format(
            wanted=summary.counted(wanted, "seam"), target=target
        )
    done = repaired_count(report)
    parts = [tr("{done} of {wanted} repaired to {target}").format(
        done=done, wanted=summary.counted(wanted, "seam"), target=target
    )]
    if report["moves"]:
        moved = summary.counted(len(report["moves"]), "face")
        parts.append(tr("{moved} moved, poles by up to {largest_move_mm} mm").format(
            moved=moved, largest_move_mm=enclosure.number(largest_move_mm(report))
        ))
    if report["edges_led"]:
        parts.append(tr("{edges_led} got new curves on their faces").format(
            edges_led=summary.counted(report["edges_led"], "edge")
        ))
    if report["sewn"]:
        parts.append(tr("{sewn} sewn").format(sewn=summary.counted(report["sewn"], "seam")))
    if not has_changed(report):
        parts.append(tr("nothing moved"))
    before, after = report["defects"]
    parts.append(tr("defects before {before}, after {after}").format(before=before, after=after))
    return "; ".join(parts) + "."


def _nothing_text(report):
    if not report["total"]:
        return tr("Nothing to repair: no two faces share an edge, and none are matched.")
    if report["chosen"]:
        text = tr("Nothing to repair: the chosen seams meet {target}; the model is unchanged.")
    else:
        text = tr("Nothing to repair: no seam falls short of {target}; the model is unchanged.")
    return text.format(target=report["target"])


def build_rows(report):
    """Return the rows of the table; the seam that was worst before the repair comes first."""
    tolerance, target = report["tolerance"], report["target"]
    ranked = sorted(
        report["seams"],
        key=lambda seam: (-_severity(seam["before"], tolerance, target), seam["before"]["id"]),
    )
    return [_row(seam, tolerance, is_done(report)) for seam in ranked]


def _severity(seam, tolerance, target):
    severity = rows.severity(seam, tolerance, target)
    return math.inf if math.isnan(severity) else severity


def _row(seam, tolerance, done):
    before, after = seam["before"], seam["after"]
    state = WAITING if not done else REPAIRED if seam["repaired"] else NOT_REPAIRED
    figures = (
        _change_text(before, after, name, tolerance)
        for name in ("angle_deg", "gap_mm", "curvature_rel")
    )
    reason = named(seam["reason"])
    result = {WAITING: "", REPAIRED: tr(REPAIRED), NOT_REPAIRED: reason}[state]
    faces = ", ".join(str(number) for number in before["faces"])
    return Row(
        seam=before["id"],
        edges=tuple(before["edges"]),
        state=state,
        cells=(edges_text(before), faces, *figures, result),
        detail=_detail(before, after, reason, tolerance),
    )


def edges_text(seam):
    """ "Edge39", or "Edge3, Edge7" for a seam of two edges."""
    return ", ".join("Edge%d" % number for number in seam["edges"])


def named(text):
    """Return a sentence of the kernel with elements as the user reads them: "Face3"."""
    text = re.sub(
        r"\bedges (\d+(?:(?:, | and )\d+)+)\b",
        lambda found: re.sub(r"\d+", lambda number: "Edge" + number.group(), found.group(1)),
        text,
    )
    return re.sub(
        r"\b(face|edge|vertex) (\d+)\b",
        lambda found: found.group(1).capitalize() + found.group(2),
        text,
    )


def _change_text(before, after, name, tolerance):
    """ "0.62 \u2192 \u22641e-9", or the figure before alone where there is none after."""
    texts = [
        rows.shown_text(seam, name, tolerance) for seam in (before, after) if seam is not None
    ]
    return ARROW.join(texts)


def _detail(before, after, reason, tolerance):
    parts = [(tr("Before"), before)] + ([(tr("After"), after)] if after is not None else [])
    texts = ["%s: %s" % (when, rows.detail_text(seam, tolerance)) for when, seam in parts]
    return "\n\n".join(texts + ([reason] if reason else []))
