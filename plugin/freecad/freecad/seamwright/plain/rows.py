# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the seam table: what each cell says, how rows are sorted and filtered.

Units: gaps and lengths in mm, angles in degrees, curvature as a ratio without unit.
A figure is the report's {lower, upper, at}; ``upper`` is None where only samples were taken.
"""

import math
from dataclasses import dataclass
from typing import Optional

from freecad.seamwright.plain import palette

LEVELS = ("none", "G0", "G1", "G2", "G3")

#: The figures that decide whether a seam meets a level.
DECIDING = {
    "G0": ("gap_mm",),
    "G1": ("gap_mm", "angle_deg"),
    "G2": ("gap_mm", "angle_deg", "curvature_rel"),
    "G3": ("gap_mm", "angle_deg", "curvature_rel"),
}

#: Below this a length (mm), an angle (deg) or a ratio is rounding noise, not worth digits.
NOISE = 1e-6


@dataclass(frozen=True)
class Row:
    """One seam of a report, ready to be shown."""

    seam: int
    edges: tuple
    edge_text: str
    face_text: str
    seam_class: str
    level: str
    gap_mm: Optional[float]
    angle_deg: Optional[float]
    curvature_rel: Optional[float]
    length_mm: Optional[float]
    severity: float
    detail: str


@dataclass(frozen=True)
class Column:
    """One column: the Row field it shows, its heading, and a sentence for the tool tip."""

    field: str
    title: str
    tip: str
    numeric: bool = True


COLUMNS = (
    Column("seam", "Seam", "Number of the seam in the report"),
    Column("seam_class", "Class", "Defect, crease or smooth", numeric=False),
    Column("angle_deg", "Angle \u00b0", "Largest angle between the tangent planes, in degrees"),
    Column("gap_mm", "Gap mm", "Largest distance between the two sides, in mm"),
    Column("curvature_rel", "Curvature", "Largest relative difference of curvature, without unit"),
    Column("level", "Level", "Highest level of continuity the seam meets", numeric=False),
    Column("edge_text", "Edge", "The edge or edges of the seam", numeric=False),
    Column("face_text", "Faces", "The two faces that meet", numeric=False),
    Column("length_mm", "Length mm", "Length of the seam, in mm"),
)


def figure_value(figure):
    """The number to show for a figure: its upper bound, else the largest seen; None if unmeasured."""
    if figure is None:
        return None
    upper = figure.get("upper")
    return figure["lower"] if upper is None else upper


def number_text(value):
    """Four significant digits; a dash for None; noise is written as less than 1e-6."""
    if value is None:
        return "\u2013"
    if value == 0:
        return "0"
    if abs(value) < NOISE:
        return "< 1e-6"
    return "%.4g" % value


def element_text(report, kind, number, qualified):
    """Name of face or edge ``number``: "Edge5", or "Box.Edge5" when ``qualified``.

    ``kind`` is "faces" or "edges". A number without owner is named after its place in the
    analysed shape.
    """
    owner = owner_of(report, kind, number)
    if owner is None:
        return "%s%d" % ({"faces": "Face", "edges": "Edge"}[kind], number)
    return "%s.%s" % tuple(owner) if qualified else owner[1]


def owner_of(report, kind, number):
    """[object name, sub-element name] that face or edge ``number`` belongs to, or None."""
    return report.get("freecad", {}).get(kind, {}).get(str(number))


def build_rows(report):
    """All rows of a report (a dict with the JSON's keys), worst first."""
    qualified = len(report.get("freecad", {}).get("objects", ())) > 1
    level = report.get("freecad", {}).get("level", "G1")
    rows = [_row(report, seam, level, qualified) for seam in report.get("seams", ())]
    return sorted(rows, key=_worst_first)


def _worst_first(row):
    return (palette.rank(row.seam_class), -row.severity, row.seam)


def _row(report, seam, level, qualified):
    names = {
        kind: ", ".join(element_text(report, kind, number, qualified) for number in seam[kind])
        for kind in ("edges", "faces")
    }
    return Row(
        seam=seam["id"],
        edges=tuple(seam["edges"]),
        edge_text=names["edges"],
        face_text=names["faces"],
        seam_class=seam["class"],
        level=seam["level"],
        gap_mm=figure_value(seam["gap_mm"]),
        angle_deg=figure_value(seam["angle_deg"]),
        curvature_rel=figure_value(seam["curvature_rel"]),
        length_mm=seam.get("length_mm"),
        severity=severity(seam, report["tolerance"], level),
        detail=detail_text(seam),
    )


def severity(seam, tolerance, level):
    """Largest ratio of a figure to its tolerance, of the figures that decide at the level.

    Infinite where gap or angle is unmeasured.
    """
    if seam["gap_mm"] is None or seam["angle_deg"] is None:
        return math.inf
    return max(_ratio(figure_value(seam[name]), tolerance[name]) for name in DECIDING[level])


def _ratio(value, limit):
    if not value:
        return 0.0
    return value / limit if limit > 0 else math.inf


def detail_text(seam):
    """Tool tip of a row: each figure with its bounds and place, then the kernel's note."""
    lines = ["Seam %d (%s)" % (seam["id"], seam["kind"])]
    for name, label, unit in (
        ("gap_mm", "Gap", " mm"),
        ("angle_deg", "Angle", "\u00b0"),
        ("curvature_per_mm", "Curvature difference", " /mm"),
        ("curvature_rel", "Relative difference of curvature", ""),
    ):
        lines.append("%s: %s" % (label, _figure_text(seam.get(name), unit)))
    if seam.get("note"):
        lines.append(seam["note"])
    return "\n".join(lines)


def _figure_text(figure, unit):
    if figure is None:
        return "not measured"
    lower = number_text(figure["lower"]) + unit
    place = "" if figure.get("at") is None else ", at %.3g of the edge" % figure["at"]
    if figure.get("upper") is None:
        return "%s is the largest seen%s" % (lower, place)
    return "between %s and %s%s%s" % (lower, number_text(figure["upper"]), unit, place)


def sort_rows(rows, field, descending=False):
    """Rows sorted by one Row field; rows without a value come last either way."""
    known = [row for row in rows if getattr(row, field) is not None]
    unknown = [row for row in rows if getattr(row, field) is None]
    return sorted(known, key=lambda row: _sort_key(row, field), reverse=descending) + unknown


def _sort_key(row, field):
    value = getattr(row, field)
    if field == "seam_class":
        return palette.rank(value)
    if field == "level":
        return LEVELS.index(value)
    if field == "edge_text":
        return row.edges
    return value


def filter_rows(rows, seam_class):
    """Rows of one class; all rows for None."""
    return [row for row in rows if seam_class is None or row.seam_class == seam_class]


def cell_text(row, column):
    """What the table shows in a cell."""
    value = getattr(row, column.field)
    if column.field == "seam_class":
        return palette.BY_KEY[value].name
    if column.field == "seam":
        return str(value)
    return number_text(value) if column.numeric else value
