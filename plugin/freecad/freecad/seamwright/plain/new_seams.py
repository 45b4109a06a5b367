# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of faces that were made again, a row of a table each: what meets there, how, and whether
that was asked for.

A seam is a dict of the kernel's report with ``between``, what it separates. Where its faces were
not kept it has no ``edges`` and no ``faces``: the model that they are numbers of is gone.
"""

from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, repair_text, rows, summary

#: heading, tool tip
COLUMNS = (
    ("Edge", "The edge of the seam in the result"),
    ("Between", "What meets there"),
    ("Angle \u00b0", "Largest angle between the tangent planes, in degrees"),
    ("Gap mm", "Largest distance between the two sides, in mm"),
    ("Curvature %", "Largest relative difference of curvature, in %"),
    ("Result", "Whether the seam surely meets the target"),
)


@dataclass(frozen=True)
class Row:
    """One seam, ready to be shown; ``place`` is its number in the list of seams, from 0."""

    place: int
    state: str  # REPAIRED or LEFT, as of a repair
    cells: tuple  # texts, one for each of COLUMNS
    detail: str


def surely_meets(seam, tolerance, target):
    """Whether the figures that decide at the target are within the tolerance for every value that
    they may have."""
    figures = [
        (seam.get(name), tolerance[rows.TOLERANCE_OF.get(name, name)])
        for name in rows.DECIDING[target]
    ]
    return all(
        figure and figure["upper"] is not None and figure["upper"] <= limit
        for figure, limit in figures
    )


def build_rows(seams, tolerance, target):
    """The rows of seams: those that fall short come first, then the largest share of the
    tolerance."""
    every = [_row(place, seam, tolerance, target) for place, seam in enumerate(seams)]
    return sorted(
        every,
        key=lambda row: (
            row.state != repair_text.LEFT,
            -rows.severity(seams[row.place], tolerance, target),
        ),
    )


def _row(place, seam, tolerance, target):
    met = surely_meets(seam, tolerance, target)
    figures = (
        rows.figure_text(seam, name, tolerance) for name in ("angle_deg", "gap_mm", "curvature_rel")
    )
    return Row(
        place=place,
        state=repair_text.REPAIRED if met else repair_text.LEFT,
        cells=(
            repair_text.edges_text(seam) or "\u2013",
            seam["between"],
            *figures,
            _verdict(seam, tolerance, target),
        ),
        detail=rows.detail_text(seam, tolerance),
    )


def surely_misses(seam, tolerance, target):
    """Whether a figure that decides at the target is beyond the tolerance for every value that it
    may have."""
    figures = [
        (seam.get(name), tolerance[rows.TOLERANCE_OF.get(name, name)])
        for name in rows.DECIDING[target]
    ]
    return any(figure and figure["lower"] > limit for figure, limit in figures)


def _verdict(seam, tolerance, target):
    if surely_meets(seam, tolerance, target):
        return "meets %s" % target
    return ("not %s" if surely_misses(seam, tolerance, target) else "not surely %s") % target


def largest(seams, name):
    """The largest figure of seams as an enclosure; None where there is none."""
    figures = [seam[name] for seam in seams if seam.get(name)]
    if not figures:
        return None
    uppers = [figure["upper"] for figure in figures]
    lower = max(figure["lower"] for figure in figures)
    return {"lower": lower, "upper": None if None in uppers else max(uppers)}


def bound(seams, name):
    """No figure is larger; where no bound is known, the largest seen; 0 without seams."""
    return rows.figure_value(largest(seams, name)) or 0.0


def largest_text(seams, tolerance):
    """ "12 seams, gap at most 1.4e-4 mm, angle at most 0.0028°, curvature unknown": unknown where
    some have none."""
    parts = [summary.counted(len(seams), "seam")]
    for name, word in (("gap_mm", "gap"), ("angle_deg", "angle"), ("curvature_rel", "curvature")):
        figure = largest(seams, name)
        if figure is None:
            continue
        if figure["upper"] is None or not all(seam.get(name) for seam in seams):
            parts.append("%s unknown" % word)
        else:
            quantity = rows.QUANTITIES[name]
            text = enclosure.number(quantity.factor * figure["upper"])
            parts.append("%s at most %s%s" % (word, text, quantity.unit))
    return ", ".join(parts)


def deciding(seam, target):
    """The seam without a worst point that says nothing about the target."""
    worst = seam.get("worst")
    if worst and rows.WORST_FIGURE[worst["quantity"]] not in rows.DECIDING[target]:
        return {**seam, "worst": None}
    return seam
