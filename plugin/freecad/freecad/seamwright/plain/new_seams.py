# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of new faces, one in each row of a table: the faces, the figures, and the verdict.

A seam is a dict of the kernel's report with the additional key ``between``: what it separates.
Where the new faces were not kept, ``edges`` and ``faces`` are empty, since the model to which the
numbers refer does not exist any more. Then ``source_edges`` has the numbers in the source.
"""

import math
from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, repair_text, rows, summary
from freecad.seamwright.plain.language import mark, tr

#: heading, tool tip
COLUMNS = (
    (
        mark("Edge"),
        mark("The edge of the seam in the result, or in the model where nothing was kept"),
    ),
    (mark("Between"), mark("The faces that meet at the seam")),
    (mark("Angle \u00b0"), mark("Largest angle between the tangent planes, in degrees")),
    (mark("Gap {unit}"), mark("Largest distance between the two sides, in {unit}")),
    (mark("Curvature %"), mark("Largest relative difference of curvature, in %")),
    (mark("Result"), mark("Whether the seam certainly meets the target")),
)


#: In a report, what stands before the name of the face beside a new one.
BESIDE = "fill, "

#: What is said about the largest of each figure, and where it is unknown.
LARGEST = {
    "gap_mm": (mark("gap at most {figure} mm"), mark("gap unknown")),
    "angle_deg": (mark("angle at most {figure}\u00b0"), mark("angle unknown")),
    "curvature_rel": (mark("curvature at most {figure} %"), mark("curvature unknown")),
}


@dataclass(frozen=True)
class Row:
    """One seam, ready to be shown; ``index`` is that in the list of seams, from 0."""

    index: int
    state: str  # REPAIRED or NOT_REPAIRED, see repair_text
    cells: tuple  # texts, one for each of COLUMNS
    detail: str


def certainly_meets(seam, tolerance, target):
    """Return whether the seam certainly meets the target.

    The upper bounds of all figures that decide the target have to be within the tolerance.
    """
    figures = [
        (seam.get(name), tolerance[rows.TOLERANCE_OF.get(name, name)])
        for name in rows.DECIDING[target]
    ]
    return all(
        figure and figure["upper"] is not None and figure["upper"] <= limit
        for figure, limit in figures
    )


def build_rows(seams, tolerance, target):
    """Return the rows of the seams.

    Seams that fall short of the target come first, then those with the largest share of the
    tolerance.
    """
    every = [_row(index, seam, tolerance, target) for index, seam in enumerate(seams)]
    return sorted(
        every,
        key=lambda row: (
            row.state != repair_text.NOT_REPAIRED,
            -rows.severity(seams[row.index], tolerance, target),
        ),
    )


def _row(index, seam, tolerance, target):
    met = certainly_meets(seam, tolerance, target)
    figures = (
        rows.shown_text(seam, name, tolerance) for name in ("angle_deg", "gap_mm", "curvature_rel")
    )
    return Row(
        index=index,
        state=repair_text.REPAIRED if met else repair_text.NOT_REPAIRED,
        cells=(
            _edges_text(seam),
            _between_text(seam["between"]),
            *figures,
            _verdict(seam, tolerance, target),
        ),
        detail=rows.detail_text(seam, tolerance),
    )


def _edges_text(seam):
    if seam.get("source_edges"):
        return tr("{edges} (model)").format(
            edges=repair_text.edges_text({"edges": seam["source_edges"]})
        )
    return repair_text.edges_text(seam) or "\u2013"


def _between_text(between):
    if between.startswith(BESIDE):
        return tr("fill, {face}").format(face=between[len(BESIDE) :])
    return tr(between)


def certainly_misses(seam, tolerance, target):
    """Return whether the seam certainly misses the target.

    The lower bound of a figure that decides the target has to be beyond the tolerance.
    """
    figures = [
        (seam.get(name), tolerance[rows.TOLERANCE_OF.get(name, name)])
        for name in rows.DECIDING[target]
    ]
    return any(figure and figure["lower"] > limit for figure, limit in figures)


def _verdict(seam, tolerance, target):
    if certainly_meets(seam, tolerance, target):
        return tr("meets {target}").format(target=target)
    misses = certainly_misses(seam, tolerance, target)
    return (tr("misses {target}") if misses else tr("{target} uncertain")).format(target=target)


def largest(seams, name):
    """Return the largest figure of the seams as an enclosure; None where no seam has the figure."""
    figures = [seam[name] for seam in seams if seam.get(name)]
    if not figures:
        return None
    uppers = [figure["upper"] for figure in figures]
    lower = max(figure["lower"] for figure in figures)
    return {"lower": lower, "upper": None if None in uppers else max(uppers)}


def bound(seams, name):
    """Return an upper bound of the figure over all seams.

    Where no upper bound is known, returns the largest value seen; without seams, returns 0.
    """
    return rows.figure_value(largest(seams, name)) or 0.0


def largest_text(seams, tolerance):
    """ "12 seams, gap at most 1.4e-4 mm, angle at most 0.0028°, curvature unknown".

    A figure is unknown where a seam lacks it or has no upper bound.
    """
    parts = [summary.counted(len(seams), "seam")]
    for name, (known, unknown) in LARGEST.items():
        figure = largest(seams, name)
        if figure is None:
            continue
        if figure["upper"] is None or not all(seam.get(name) for seam in seams):
            parts.append(tr(unknown))
        else:
            quantity = rows.QUANTITIES[name]
            text = enclosure.number(quantity.factor * figure["upper"], rounding=math.ceil)
            parts.append(tr(known).format(figure=text))
    return ", ".join(parts)


def deciding(seam, target):
    """Return the seam, without its worst point where that belongs to a figure beyond the target."""
    worst = seam.get("worst")
    if worst and rows.WORST_FIGURE[worst["quantity"]] not in rows.DECIDING[target]:
        return {**seam, "worst": None}
    return seam
