# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about new surfaces: the table of their seams, and the summary.

The report is a dict with the result of the kernel and these keys:

* ``tolerance``
* ``poles``: their numbers along and across the sides
* ``seams``: each a seam with the additional keys ``side``, ``name`` (of its edges) and ``target``
"""

from dataclasses import dataclass

from freecad.seamwright.plain import enclosure, new_seams, repair_text, rows
from freecad.seamwright.plain.curve_text import bound
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.summary import counted

#: heading, tool tip
COLUMNS = (
    (mark("Place"), mark("The side of the surface, or inside it")),
    (mark("Along"), mark("The edge of the model, or the lines inside the surface")),
    (mark("Gap {unit}"), mark("Largest distance between the two sides, in {unit}")),
    (mark("Angle \u00b0"), mark("Largest angle between the tangent planes, in degrees")),
    (mark("Curvature %"), mark("Largest relative difference of curvature, in %")),
    (
        mark("Change %"),
        mark("Largest relative difference of the change of curvature, in % (measured for G3)"),
    ),
    (mark("Result"), mark("Whether the seam certainly has its level")),
)

#: The column of the change of curvature, whose figures only seams with G3 have.
CHANGE = 5

#: The kind of a seam inside a surface.
LINE = "line of joints"

#: Poles that move by less are those of an edge that stays, up to rounding.
UNMOVED_MM = 1e-9

#: The kernel's words for sides of a surface.
SIDES = (mark("start"), mark("end"))

FIGURES = ("gap_mm", "angle_deg", "curvature_rel")


@dataclass(frozen=True)
class Row:
    """One seam, or several that are alike, ready to be shown.

    ``seams``: their places in the report.
    """

    seams: tuple
    met: bool
    cells: tuple  # texts, one for each of COLUMNS
    detail: str

    @property
    def state(self):
        """As repair_text has it: whether the level is met."""
        return repair_text.REPAIRED if self.met else repair_text.NOT_REPAIRED


def build_rows(report):
    """Return a Row for each seam of a report.

    Lines inside the surface that have their level have one row together.
    """
    found, alike = [], []
    for place, seam in enumerate(report.get("seams", [])):
        met = new_seams.certainly_meets(seam, report["tolerance"], seam["target"])
        if met and seam["kind"] == LINE:
            alike.append(place)
        else:
            found.append(_row((place,), seam, report["tolerance"], met))
    if len(alike) == 1:
        (place,) = alike
        found.append(_row((place,), report["seams"][place], report["tolerance"], True))
    elif alike:
        found.append(_together(alike, report))
    return found


def has_change(report):
    """Return whether the change of curvature was measured at a seam of a report."""
    return any(seam.get("curvature_change_rel") for seam in report.get("seams", []))


def _row(places, seam, tolerance, met):
    figures = (rows.shown_text(seam, name, tolerance) for name in rows.SHOWN)
    name = tr(seam["name"])
    if seam["kind"] == LINE:
        name = tr("line {number}").format(number=name)
    cells = (tr(seam["side"]), name, *figures, _verdict(seam, tolerance, met))
    return Row(places, met, cells, rows.detail_text(seam, tolerance))


def _together(places, report):
    """Return the Row of several lines that have their level, with the largest figures."""
    seams = [report["seams"][place] for place in places]
    whole = {name: new_seams.largest(seams, name) for name in rows.SHOWN}
    figures = (rows.shown_text(whole, name, report["tolerance"]) for name in rows.SHOWN)
    along = counted(len(seams), LINE)
    verdict = tr("{target} is met").format(target=seams[0]["target"])
    detail = tr("Lines inside the surface at which the curves have their joints")
    return Row(tuple(places), True, (tr(seams[0]["side"]), along, *figures, verdict), detail)


def _verdict(seam, tolerance, met):
    if met:
        return tr("{target} is met").format(target=seam["target"])
    missed = new_seams.certainly_misses(seam, tolerance, seam["target"])
    text = tr("misses {target}") if missed else tr("{target} is uncertain")
    return text.format(target=seam["target"])


def largest(seams):
    """Return {figure: upper bound over the seams whose level it decides}."""
    return {
        name: new_seams.bound([s for s in seams if name in rows.DECIDING[s["target"]]], name)
        for name in FIGURES
    }


def _decided(seams):
    """Return a text for each figure that decides the level of a seam."""
    decided = {name for seam in seams for name in rows.DECIDING[seam["target"]]}
    found = largest(seams)
    return [
        tr(known).format(figure=bound(rows.QUANTITIES[name].factor * found[name]))
        for name, (known, _) in new_seams.LARGEST.items()
        if name in decided
    ]


def summary(report):
    """Return one line: the seams, or what falls short."""
    along, across = report["poles"]
    poles = tr("{along} x {across} poles").format(along=along, across=across)
    figures = ", ".join(_decided(report["seams"]))
    state = tr("Every seam has its level") if report["reached"] else _shortcomings(report)
    if report["reached"] and folds(report):
        state += tr(", but the surface turns back {distance_mm} mm from the start; less tension "
                    "may help").format(distance_mm=enclosure.number(report["fold"]["distance_mm"]))
    length = ""
    if report["to"]:
        length = tr("; {least_mm} to {most_mm} mm long").format(
            least_mm=enclosure.number(report["to"]["least_mm"]),
            most_mm=enclosure.number(report["to"]["most_mm"]),
        )
    return "%s: %s; %s%s." % (state, figures, poles, length)


def folds(report):
    """Return whether the report of a surface says that it turns over somewhere."""
    return bool(report.get("fold"))


def umbrella_summary(report):
    """Return one line about faces around a point."""
    state = tr("every seam is {order}") if report["reached"] else tr(
        "not every seam is certainly {order}"
    )
    figures = tr("gap at most {gap_mm} mm, angle at most {angle_deg}\u00b0").format(
        gap_mm=bound(report["gap_mm"]), angle_deg=bound(report["angle_deg"])
    )
    if report["order"] != "G1":
        figures += tr(", curvature at most {curvature_rel} %").format(
            curvature_rel=bound(100 * report["curvature_rel"])
        )
    return tr("{members} around the point: {state}, {figures}; {followed}.").format(
        members=counted(report["members"], "face"),
        state=state.format(order=report["order"]),
        figures=figures,
        followed=_followed(report),
    )


def _followed(report):
    moved, fit = report["moved_mm"], report["fit_mm"]
    text = tr("no edge moved")
    if moved > UNMOVED_MM:
        text = tr("edges moved by at most {moved} mm, edge {number} most").format(
            moved=bound(moved), number=report["moved_most"]
        )
    if fit:
        text += tr(", curves within {fit} mm of them").format(fit=bound(fit))
    return text + (tr("; the outer boundary stays") if report["outer_edges"] else "")


def loft_summary(report):
    """Return one line about the surface through curves."""
    text = tr("{faces} through {keys} curves, within {distance_mm} mm").format(
        faces=counted(report["faces"], "face"),
        keys=report["keys"],
        distance_mm=bound(report["distance_mm"]),
    )
    if not report["seams"]:
        return text + "."
    return tr(
        "{surface}; across {seams}: angle at most {angle_deg}\u00b0, curvature at most "
        "{curvature_rel} %."
    ).format(
        surface=text,
        seams=counted(len(report["seams"]), "line of joints"),
        angle_deg=bound(report["angle_deg"]),
        curvature_rel=bound(100 * report["curvature_rel"]),
    )


def _shortcomings(report):
    parts = [
        "%s, %s" % (tr(each.get("side", mark("lateral boundary"))), each["reason"].rstrip("."))
        for each in report["sides"] + report["laterals"]
        if each["reason"]
    ]
    if report["fold"]:
        parts.append(
            tr("the surface folds {distance_mm} mm from the side").format(
                distance_mm=enclosure.number(report["fold"]["distance_mm"])
            )
        )
    missed = [
        tr("{target} is not certain at {name}").format(target=seam["target"], name=seam["name"])
        for seam in report["seams"]
        if not new_seams.certainly_meets(seam, report["tolerance"], seam["target"])
    ]
    return tr("Not reached ({missed})").format(missed="; ".join(missed + parts))
