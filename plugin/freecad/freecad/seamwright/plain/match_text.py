# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about two matched faces: the table before and after, and the summary.

The report is a dict with the result of the kernel: matched, reason, exact, largest_move_mm, before,
after. ``before`` and ``after`` are seams, or None where the faces have no common boundary. The
report also has the ``target``, the ``tolerance``, the names of the ``faces``, and their numbers of
``poles``: before and after for each, None for a surface without poles.
"""

import re

from freecad.seamwright.plain import enclosure, kernel_words, lengths, rows
from freecad.seamwright.plain.language import mark, tr

#: The figures for which the table has a row.
FIGURES = ("gap_mm", "angle_deg", "curvature_rel")
HEADINGS = {
    "gap_mm": mark("Gap {unit}"),
    "angle_deg": mark("Angle \u00b0"),
    "curvature_rel": mark("Curvature %"),
}
#: What the summary says about a figure.
PARTS = {
    "gap_mm": mark("gap {figure} mm"),
    "angle_deg": mark("angle {figure}\u00b0"),
    "curvature_rel": mark("curvature {figure} %"),
}
UNKNOWN = "\u2013"

EMPTY_REPORT = {
    "matched": False,
    "reason": "",
    "exact": False,
    "largest_move_mm": 0.0,
    "before": None,
    "after": None,
}


def table(report):
    """Return [(heading, before, after)] as the panel shows them."""
    sides = (report["before"], report["after"] if report["matched"] else None)
    lines = [
        (lengths.titled(HEADINGS[name]), *(_figure(seam, name, report) for seam in sides))
        for name in FIGURES
    ]
    lines.append((tr("Level"), *(UNKNOWN if seam is None else seam["level"] for seam in sides)))
    lines.append((tr("Certain"), *(_certain(seam) for seam in sides)))
    return lines


def _figure(seam, name, report):
    return UNKNOWN if seam is None else rows.shown_text(seam, name, report["tolerance"])


def _certain(seam):
    if seam is None:
        return UNKNOWN
    return tr("yes") if seam["certified"] else tr("no")


def summary(report):
    """Return one line: the seam and the largest move, or the reason why the faces do not match."""
    if not report["matched"]:
        return tr("Not matched: {reason}.").format(reason=report["reason"].rstrip("."))
    parts = [tr("{target} is met").format(target=report["target"])]
    for name in FIGURES:
        if report["after"].get(name) is not None:
            text = rows.figure_text(report["after"], name, report["tolerance"])
            parts.append(tr(PARTS[name]).format(figure=text))
    parts.append(tr("poles moved by up to {largest_move_mm} mm").format(
        largest_move_mm=enclosure.number(report["largest_move_mm"])
    ))
    parts += _changed_poles(report)
    return tr("Matched: {parts} ({reason}).").format(
        parts="; ".join(parts), reason=_in_words(report["reason"])
    )


def _changed_poles(report):
    """Return a text for each face that has other numbers of poles than before."""
    texts = []
    for face, (before, after) in zip(report["faces"], report.get("poles", [])):
        if after is not None and before != after:
            text = tr("{face} has {along} x {across} poles").format(
                face=face, along=after[0], across=after[1]
            )
            if before is not None:
                text += tr(" instead of {along} x {across}").format(
                    along=before[0], across=before[1]
                )
            texts.append(text)
    return texts


def _in_words(reason):
    """Return how the faces were joined, in the words of the panel."""
    exactly = tr("the seam is exact up to rounding")
    reason = re.sub(kernel_words.JOINED_IN_POLES, lambda found: exactly, reason)
    return re.sub(
        kernel_words.JOINED_NEAR_THE_SEAM,
        lambda found: tr(
            "within the tolerances; the shape changes up to {depth} mm away from the seam"
        ).format(depth=found[1]),
        reason,
    )


def advised(reason, code):
    """Return why faces do not match, with what helps where the kernel's text does not say it."""
    if code != "less_fair":
        return reason
    return tr("{reason}: allow a change over a larger Depth, or a larger Fairness").format(
        reason=reason.rstrip(".")
    )


def chain_reason(faces, depth_mm):
    """Return how a face was matched to several; ``faces``: the names, first that of the moved."""
    return tr(
        "{face} joins {others} to the tolerance; the shape changes up to {depth_mm} mm away from "
        "the seam"
    ).format(
        face=faces[0], others=", ".join(faces[1:]), depth_mm=enclosure.number(depth_mm)
    )


def worst(seams):
    """Return the seam of the lowest level with the worst figures of all; None without seams."""
    if not seams:
        return None
    found = dict(min(seams, key=lambda seam: rows.LEVELS.index(seam["level"])))
    for name in FIGURES:
        known = [seam[name] for seam in seams if seam.get(name) is not None]
        if known:
            found[name] = max(known, key=lambda figure: rows.figure_value(figure) or 0.0)
    found["certified"] = all(seam["certified"] for seam in seams)
    return found


def named(text, faces, edge_name):
    """Return a sentence of the kernel with the names of its edges, and of the faces from 1 on.

    ``edge_name`` is a callable(number).
    """
    names = {"face %d" % number: name for number, name in enumerate(faces, 1)}
    text = re.sub(r"\bface \d+\b", lambda found: names.get(found.group(), found.group()), text)
    text = re.sub(r"\bedge (\d+)\b", lambda found: edge_name(int(found.group(1))), text)
    listed = re.compile(r"(?<=these are: )\d+(?:, \d+)*")
    return listed.sub(
        lambda found: ", ".join(edge_name(int(n)) for n in found.group().split(", ")), text
    )


def value(seam, name):
    """Return the number for a figure of a seam.

    This is its upper bound, else the largest value seen, else 0.
    """
    return 0.0 if seam is None else rows.figure_value(seam.get(name)) or 0.0
