# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the seam table: the texts of cells, sorting and filtering.

Rows have gaps and lengths in mm, angles in degrees, and curvature differences as ratios. Cells show
lengths in the unit of the user, and ratios in %. A figure is the report's {lower, upper, at};
``upper`` is None where no bound is known.
"""

import math
from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, lengths, palette
from freecad.seamwright.plain.language import mark, tr

LEVELS = ("none", "G0", "G1", "G2", "G3")

#: The figures that decide whether a seam meets a level.
DECIDING = {
    "G0": ("gap_mm",),
    "G1": ("gap_mm", "angle_deg"),
    "G2": ("gap_mm", "angle_deg", "curvature_rel"),
    "G3": ("gap_mm", "angle_deg", "curvature_rel", "curvature_change_rel"),
}

#: The tolerance with which a figure is compared, where its name differs from that of the figure.
TOLERANCE_OF = {"curvature_change_rel": "curvature_rel"}


#: The kernel's words for kinds of seams: of two faces, of one closed face, of two free edges.
KINDS = (mark("shared"), mark("closed"), mark("matched"))


@dataclass(frozen=True)
class Quantity:
    """How a figure of the report is shown: label, unit and the factor to that unit."""

    label: str
    unit: str
    factor: float = 1.0


QUANTITIES = {
    "gap_mm": Quantity(mark("Gap"), " mm"),
    "angle_deg": Quantity(mark("Angle"), "\u00b0"),
    "curvature_per_mm": Quantity(mark("Difference of curvature"), " /mm"),
    "curvature_rel": Quantity(mark("Relative difference of curvature"), " %", 100.0),
    "curvature_change_per_mm2": Quantity(
        mark("Difference of the change of curvature"), " /mm\u00b2"
    ),
    "curvature_change_rel": Quantity(
        mark("Relative difference of the change of curvature"), " %", 100.0
    ),
}

#: The labels of figures in percent.
PERCENTS = {
    "curvature_rel": mark("curvature {figure}"),
    "curvature_change_rel": mark("change of curvature {figure}"),
}

#: The figure behind each word of the report's "worst".
WORST_FIGURE = {
    "gap": "gap_mm",
    "angle": "angle_deg",
    "curvature": "curvature_rel",
    "curvature_change": "curvature_change_rel",
}


class Row:
    """One seam of a report, ready to be shown.

    Texts are made when they are asked for, since a table shows few rows at a time.
    """

    def __init__(self, report, seam, level):
        self._report, self._seam = report, seam
        self.seam = seam["id"]
        self.edges = tuple(seam["edges"])
        self.seam_class = seam["class"]
        self.level = seam["level"]
        self.certain = seam["certified"]
        self.gap_mm, self.angle_deg, self.curvature_rel, self.curvature_change_rel = (
            figure_value(seam.get(name)) for name in SHOWN
        )
        self.length_mm = seam.get("length_mm")
        self.severity = severity(seam, report["tolerance"], level)

    @property
    def edge_text(self):
        """The names of the edges."""
        return self._names("edges")

    @property
    def face_text(self):
        """The names of the faces."""
        return self._names("faces")

    @property
    def detail(self):
        """The tool tip."""
        return detail_text(self._seam, self._report["tolerance"])

    def figure_text(self, name):
        """Return a figure as a cell shows it."""
        return shown_text(self._seam, name, self._report["tolerance"])

    def _names(self, kind):
        qualified = len(self._report.get("freecad", {}).get("objects", ())) > 1
        return ", ".join(
            element_text(self._report, kind, number, qualified) for number in self._seam[kind]
        )


@dataclass(frozen=True)
class Column:
    """One column: the Row field it shows, its heading, and a sentence for the tool tip."""

    field: str
    title: str
    tip: str
    numeric: bool = True


#: The figures for which the table has a column.
SHOWN = ("gap_mm", "angle_deg", "curvature_rel", "curvature_change_rel")

COLUMNS = (
    Column("seam", mark("Seam"), mark("Number of the seam in the report")),
    Column("seam_class", mark("Class"), mark("Defect, crease or smooth"), numeric=False),
    Column("angle_deg", mark("Angle \u00b0"),
           mark("Largest angle between the tangent planes, in degrees")),
    Column("gap_mm", mark("Gap {unit}"), mark("Largest distance between the two sides, in {unit}")),
    Column("curvature_rel", mark("Curv. %"),
           mark("Largest relative difference of curvature, in %")),
    Column("curvature_change_rel", mark("Change %"),
           mark("Largest relative difference of the change of curvature, in % (measured for G3)")),
    Column("level", mark("Level"), mark("Highest level of continuity the seam meets"),
           numeric=False),
    Column("certain", mark("Certain"),
           mark("Whether class and level are the same for every value within the bounds"),
           numeric=False),
    Column("edge_text", mark("Edge"), mark("The edge or edges of the seam"), numeric=False),
    Column("face_text", mark("Faces"), mark("The two faces that meet"), numeric=False),
    Column("length_mm", mark("Length {unit}"), mark("Length of the seam, in {unit}")),
)  # fmt: skip


def figure_value(figure):
    """Return the number to show for a figure; None if it was not measured.

    This is its upper bound or, where that is unknown, the largest value seen.
    """
    if figure is None:
        return None
    upper = figure.get("upper")
    return figure["lower"] if upper is None else upper


def figure_text(seam, name, tolerance):
    """Return a figure of a seam without its unit, lengths in mm; a dash if it was not measured."""
    return _text(seam, name, tolerance, QUANTITIES[name].factor)


def shown_text(seam, name, tolerance):
    """Return a figure of a seam as a cell shows it: lengths are in the unit of the user."""
    factor = QUANTITIES[name].factor
    return _text(seam, name, tolerance, lengths.shown(factor) if name == "gap_mm" else factor)


def _shown_unit(name):
    return " " + lengths.unit().name if name == "gap_mm" else QUANTITIES[name].unit


def _text(seam, name, tolerance, factor):
    figure = seam.get(name)
    if figure is None:
        return "\u2013"
    limit = tolerance.get(TOLERANCE_OF.get(name, name))
    return enclosure.text(figure, factor, None if limit is None else factor * limit)


def element_text(report, kind, number, qualified):
    """Return the name of face or edge ``number``: "Edge5", or "Box.Edge5" when ``qualified``.

    ``kind`` is "faces" or "edges". A number without owner gives the name that the element has in
    the analysed shape.
    """
    owner = owner_of(report, kind, number)
    if owner is None:
        return "%s%d" % ({"faces": "Face", "edges": "Edge"}[kind], number)
    return "%s.%s" % tuple(owner) if qualified else owner[1]


def owner_of(report, kind, number):
    """Return the [object name, sub-element name] of a face or edge, or None."""
    return report.get("freecad", {}).get(kind, {}).get(str(number))


def located(seams, tolerance, name):
    """Return what the view needs of a report.

    Each face and edge of the seams is an element of the object ``name``.
    """
    seams = list(seams)
    return {
        "tolerance": tolerance,
        "freecad": {
            kind: {str(n): [name, prefix + str(n)] for seam in seams for n in seam[kind]}
            for kind, prefix in (("faces", "Face"), ("edges", "Edge"))
        },
    }


def edge_numbers_by_name(report, analysis):
    """Return {(object name, "Edge3"): number in the report} of the edges of all seams.

    ``analysis`` is the name of the analysis object, whose edges are those of the seams in order.
    """
    numbers = edge_numbers(report)
    found = {(analysis, "Edge%d" % place): number for place, number in enumerate(numbers, 1)}
    owners = report.get("freecad", {}).get("edges", {})
    found.update({tuple(owner): int(number) for number, owner in owners.items()})
    return found


def edge_numbers(report):
    """Return the edges of all seams in the order of the report, each once."""
    return list(
        dict.fromkeys(number for seam in report.get("seams", ()) for number in seam["edges"])
    )


def build_rows(report):
    """Return all rows of a report (a dict with the keys of the JSON file), the worst first."""
    level = report.get("freecad", {}).get("level", "G1")
    rows = [Row(report, seam, level) for seam in report.get("seams", ())]
    return sorted(rows, key=lambda row: _worst_first(row, level))


def _worst_first(row, level):
    """Sort defects by how much they exceed the tolerances, and others as a column shows it.

    That is the column of the level: the angle for G1. A figure that was not measured comes first.
    """
    if row.seam_class == palette.DEFECT.key:
        figures = [row.severity]
    else:
        figures = [getattr(row, name) for name in reversed(DECIDING[level])]
    figures = [math.inf if figure is None else figure for figure in figures]
    return (palette.rank(row.seam_class), [-figure for figure in figures], row.seam)


def severity(seam, tolerance, level):
    """Return the largest ratio of a figure that decides the level to its tolerance.

    The ratio is infinite where gap or angle was not measured.
    """
    if seam["gap_mm"] is None or seam["angle_deg"] is None:
        return math.inf
    return max(
        _ratio(figure_value(seam.get(name)), tolerance[TOLERANCE_OF.get(name, name)])
        for name in DECIDING[level]
    )


def _ratio(value, limit):
    if not value:
        return 0.0
    return value / limit if limit > 0 else math.inf


def detail_text(seam, tolerance):
    """Return the tool tip of a row.

    It has each figure with its position, the certainty of the verdict, and the note of the kernel.
    """
    lines = [tr("Seam {id} ({kind})").format(id=seam["id"], kind=tr(seam["kind"]))]
    for name, quantity in QUANTITIES.items():
        if seam.get(name) is not None or name in DECIDING["G2"]:
            lines.append("%s: %s" % (tr(quantity.label), _placed_text(seam, name, tolerance)))
    if seam["certified"]:
        lines.append(tr("The verdict is certain: it is the same for every value within the bounds"))
    else:
        lines.append(tr("The verdict is not certain"))
    if seam.get("note"):
        lines.append(seam["note"])
    return "\n".join(lines)


def _placed_text(seam, name, tolerance):
    figure = seam.get(name)
    if figure is None:
        return tr("not measured")
    text = shown_text(seam, name, tolerance) + _shown_unit(name)
    if figure.get("at") is not None:
        text += tr(", largest at {at:.3g} of the edge").format(at=figure["at"])
    # Results of earlier versions have no left_out.
    intervals = seam.get("left_out", {}).get(name, [])
    if intervals:
        text += tr(", excluding {intervals} of it").format(intervals=_intervals_text(intervals))
    return text


def _intervals_text(intervals):
    most = 4  # a choice: the tool tip stays short
    shown = intervals if len(intervals) <= most else intervals[: most - 1]
    text = ", ".join(_interval_text(*interval) for interval in shown)
    if len(shown) < len(intervals):
        text += tr(" and {intervals} more intervals").format(intervals=len(intervals) - len(shown))
    return text


def _interval_text(first, last):
    if first <= 0:
        return tr("the first {last:.3g}").format(last=last)
    if last >= 1:
        return tr("the last {first:.3g}").format(first=1 - first)
    if "%.6g" % first == "%.6g" % last:
        return tr("{last:.3g} at {first:.6g}").format(last=last - first, first=first)
    return tr("{first:.6g} to {last:.6g}").format(first=first, last=last)


def worst_label(seam, tolerance):
    """Return the figure at the worst point of a seam with its unit; "" without such a point.

    Percents are named, since a table may not have their column.
    """
    worst = seam.get("worst")
    if worst is None:
        return ""
    name = WORST_FIGURE[worst["quantity"]]
    if seam.get(name) is None:
        return ""
    text = shown_text(seam, name, tolerance) + _shown_unit(name)
    return tr(PERCENTS[name]).format(figure=text) if name in PERCENTS else text


def sort_rows(rows, field, descending=False):
    """Return the rows sorted by one field of Row; rows without a value always come last."""
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


#: Columns that are left out where they tell nothing, and when they do, as a function of all rows.
NEEDLESS = {
    "curvature_change_rel": lambda rows: all(row.curvature_change_rel is None for row in rows),
    "certain": lambda rows: all(row.certain for row in rows),
}


# These take the place of a class in filters.
NOT_SMOOTH, UNCERTAIN = "not smooth", "uncertain"


def is_wanted(wanted, seam_class, certain):
    """Return whether a filter lets a seam pass.

    ``wanted``: a class, ``NOT_SMOOTH``, ``UNCERTAIN`` for seams whose verdict is not certain, or
    None for all.
    """
    if wanted == UNCERTAIN:
        return not certain
    if wanted == NOT_SMOOTH:
        return seam_class != palette.SMOOTH.key
    return wanted is None or seam_class == wanted


def filter_rows(rows, wanted):
    """Return the rows that a filter lets pass (see ``is_wanted``)."""
    return [row for row in rows if is_wanted(wanted, row.seam_class, row.certain)]


def shown_edges(report, wanted):
    """Return the set of the edges of the seams that a filter lets pass."""
    return {
        number
        for seam in report.get("seams", ())
        if is_wanted(wanted, seam["class"], seam["certified"])
        for number in seam["edges"]
    }


def cells(rows):
    """Return the rows as a table of text: headings and rows, cells separated by tabs."""
    lines = [[lengths.titled(column.title) for column in COLUMNS]]
    lines += [[cell_text(row, column) for column in COLUMNS] for row in rows]
    return "\n".join("\t".join(line) for line in lines)


def cell_text(row, column):
    """Return the text of a cell; the headings say what numbers of edges and faces are."""
    value = getattr(row, column.field)
    if column.field in ("edge_text", "face_text") and "." not in value:
        return value.replace("Edge", "").replace("Face", "")
    if column.field == "seam_class":
        return tr(palette.BY_KEY[value].name) + ("" if row.certain else "?")
    if column.field == "seam":
        return str(value)
    if column.field == "certain":
        return tr("yes") if value else tr("no")
    if column.field in SHOWN:
        return row.figure_text(column.field)
    if column.field == "length_mm":
        return "\u2013" if value is None else "%.4g" % lengths.shown(value)
    return value
