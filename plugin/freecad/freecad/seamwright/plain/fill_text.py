# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about holes and their fills.

The report is a dict with the keys ``target``, ``tolerance`` and ``fills``. ``fills`` has a dict for
each fill: ``hole`` (its number, or None), ``face`` (the number of the face that was replaced, or
None), ``filled``, ``reached``, ``reason``, ``reason_code``, ``faces`` (the new faces) and ``seams``
(see new_seams).
The numbers of faces and edges are those of the result; in reasons they are those of the source.
"""

import math
import re

from freecad.seamwright.plain import (
    enclosure,
    kernel_words,
    lengths,
    new_seams,
    repair_text,
    rows,
    summary,
)
from freecad.seamwright.plain.language import mark, tr

#: What a report says about the faces at a seam: two new ones, or a new one and a face by its name.
BESIDE, INSIDE = new_seams.BESIDE, mark("the fill itself")


#: What has to be allowed for a fill that misses its target.
ALLOWED = {
    "gap_mm": mark("a gap tolerance of {figure} mm"),
    "angle_deg": mark("an angle tolerance of {figure}\u00b0"),
    "curvature_rel": mark("a curvature tolerance of {figure} %"),
}

EMPTY_REPORT = {"target": "G1", "tolerance": {}, "fills": []}


def edges_of(hole):
    """Return the numbers of the edges of a hole, in the order of the hole."""
    return [number for side in hole["sides"] for number in side["edges"]]


def default_holes(holes):
    """Return the holes that are filled when the user chooses none.

    These are all holes except the longest loop of each connected set of faces, since that is
    usually its outer boundary. Where every hole is such a loop, these are all holes.
    """
    return [hole for hole in holes if not hole["longest"]] or list(holes)


def chosen_holes(holes, edges):
    """Return the holes to which the edges belong; one edge of a hole is enough.

    Raises ValueError for an edge that belongs to no hole.
    """
    owners = {number: hole for hole in holes for number in edges_of(hole)}
    for number in edges:
        if number not in owners:
            raise ValueError(
                tr(
                    "edge {number} does not belong to a hole: it is not free, or not part of a "
                    "closed loop"
                ).format(number=number)
            )
    wanted = {owners[number]["id"] for number in edges}
    return [hole for hole in holes if hole["id"] in wanted]


def hole_text(hole, holes):
    """ "Hole 2: 4 sides, length 63.1 mm, centre (5, 0, 2.5)".

    A hole that is not filled by default has a remark.
    """
    sides = summary.counted(len(hole["sides"]), "side") if hole["has_corners"] else tr("no corner")
    place = (round(lengths.shown(coordinate), 9) + 0.0 for coordinate in hole["centre_mm"])
    centre = ", ".join("%.4g" % coordinate for coordinate in place)
    length = "%.4g %s" % (lengths.shown(hole["length_mm"]), lengths.unit().name)
    text = tr("Hole {id}: {sides}, length {length}, centre ({centre})").format(
        id=hole["id"], sides=sides, length=length, centre=centre
    )
    return text if hole in default_holes(holes) else text + tr(
        ", the longest loop: an outer boundary?"
    )


def hole_tip(hole):
    """Return the names of the edges of a hole."""
    return repair_text.edges_text({"edges": edges_of(hole)})


def entry(found, hole=None, face=None):
    """Return the entry of a fill in the report.

    ``found``: the result of the kernel. The numbers are those of the filled model; seams of a fill
    that was not kept have none. Each seam has a ``point`` on it, or None.
    """
    new = set(found["faces"])
    seams = [
        new_seams.deciding(
            {**seam, "between": _between(seam, new, face), "point": _worst_point(seam)},
            found["target"],
        )
        for seam in found["outer"] + found["inner"]
    ]
    if not found["filled"]:
        seams = [{**seam, "edges": [], "faces": [], "worst": None} for seam in seams]
    return {
        "hole": hole,
        "face": face,
        **{name: found[name] for name in ("filled", "reached", "reason_code")},
        "reason": _readable(found["reason"]),
        "faces": found["faces"] if found["filled"] else [],
        "seams": seams,
        "waves": found.get("waves"),
    }


def _worst_point(seam):
    return seam["worst"]["point"] if seam.get("worst") else None


def beside(name):
    """Return what a report says about a seam of a new face and one of the source."""
    return BESIDE + name


def face_beside(seam):
    """Return the number of the face of the source at a seam; None inside the fill."""
    found = re.fullmatch(re.escape(BESIDE) + r"Face(\d+)", seam["between"])
    return int(found.group(1)) if found else None


def _readable(text):
    """Return a sentence of the kernel with names of elements and numbers of three digits."""
    return re.sub(
        r"\b\d+\.(\d{4,}|\d+e-?\d+)\b", lambda found: enclosure.number(float(found.group())),
        kernel_words.with_degree_signs(repair_text.named(text)),
    )  # fmt: skip


def allowing(fill, target):
    """Return {argument: value} of the tolerances that the seams of a fill meet, rounded up.

    It is empty where the fill has other faults than a missed tolerance, or a figure has no bound.
    """
    if fill.get("reason_code") not in ("misses_target", "may_miss_target"):
        return {}
    found = {name: new_seams.largest(fill["seams"], name) for name in rows.DECIDING[target]}
    if not all(figure and figure["upper"] is not None for figure in found.values()):
        return {}
    return {name: _rounded_up(figure["upper"]) for name, figure in found.items()}


def _rounded_up(value):
    """Return a value with two digits that is not smaller."""
    if value <= 0:
        return 0.0
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float("%.12g" % (math.ceil(value / step) * step))


def allowing_text(fill, target, tolerance):
    """Return what would have to be allowed to keep a fill that misses its target, or ""."""
    wanted = [
        tr(ALLOWED[name]).format(figure=enclosure.number(rows.QUANTITIES[name].factor * value))
        for name, value in allowing(fill, target).items()
        if value > tolerance[name]
    ]
    if not wanted:
        return ""
    return tr("The best fill needs {tolerances}; Keep anyway keeps it.").format(
        tolerances=", ".join(wanted)
    )


def old_number(number, new, replaced):
    """Return the number in the source of a face of the filled model; None for a new face."""
    if number in new:
        return None
    number -= sum(other < number for other in new)
    return number + 1 if replaced is not None and number >= replaced else number


def _between(seam, new, replaced):
    old = [old_number(number, new, replaced) for number in seam["faces"]]
    kept = ["Face%d" % number for number in old if number is not None]
    return beside(kept[0]) if kept else INSIDE


def every_seam(report):
    """Return the seams of all fills."""
    return [seam for fill in report["fills"] for seam in fill["seams"]]


def kept(report):
    """Return the fills that are part of the result."""
    return [fill for fill in report["fills"] if fill["filled"]]


def missed(report):
    """Return the fills that do not reach the target, whether kept or not."""
    return [fill for fill in report["fills"] if not fill["reached"]]


def new_faces(report):
    """Return (numbers of the new faces, number of the face that they replace or None)."""
    replaced = [fill["face"] for fill in kept(report)]
    return {number for fill in kept(report) for number in fill["faces"]}, replaced[
        0
    ] if replaced else None


def waiting_text(faces, holes):
    """Say what a computation would fill or replace.

    ``faces``: the name of the face that is replaced, or none; ``holes``: the numbers of the holes.
    """
    return (
        tr("{faces} to replace.").format(faces=faces[0])
        if faces
        else tr("{holes} to fill.").format(holes=summary.counted(len(holes), "hole"))
    )


def name_of(fill):
    """ "Hole 2" or "Face16"."""
    return tr("Hole {hole}").format(
        hole=fill["hole"]
    ) if fill["face"] is None else "Face%d" % fill["face"]


def reasons(report):
    """Return a line for each fill that misses the target: why, and what it needs."""
    lines = []
    for fill in missed(report):
        line = "%s: %s." % (name_of(fill), fill["reason"].rstrip("."))
        if not fill["filled"]:
            line += " " + allowing_text(fill, report["target"], report["tolerance"])
        lines.append(line.rstrip())
    return lines


def summary_text(report):
    """Return one line: how many holes were filled and the seams of the fills.

    Where the only fill failed, the line gives the reason.
    """
    fills, done, target = report["fills"], kept(report), report["target"]
    if len(fills) == 1 and not done:
        return tr("Not filled: {reasons}").format(reasons=reasons(report)[0])
    replaced = fills[0]["face"] is not None if fills else False
    text = tr("{fills} replaced").format(
        fills=name_of(fills[0])
    ) if replaced else tr("{done} of {fills} filled").format(
        done=len(done), fills=summary.counted(len(fills), "hole")
    )  # fmt: skip
    if not done:
        return "%s: %s" % (text, " ".join(reasons(report)))
    made = summary.counted(sum(len(fill["faces"]) for fill in done), "face")
    seams = new_seams.largest_text(
        [seam for fill in done for seam in fill["seams"]], report["tolerance"]
    )
    met = all(fill["reached"] for fill in done)
    verdict = tr("{level} is met") if met else tr("{level} is not met, kept anyway")
    text = tr("{holes} with {faces}; {seams}; {verdict}.").format(
        holes=text, faces=made, seams=seams, verdict=verdict.format(level=target)
    )
    return " ".join([text, *filter(None, map(waves_text, done))])


def waves_text(fill):
    """Return a sentence about a fill with dents or waves, or ""."""
    if not fill.get("waves"):
        return ""
    return tr(
        "{name} bends both ways, {times} times as strongly as the faces around it: look at its "
        "stripes for dents or waves."
    ).format(name=name_of(fill), times="%.2g" % fill["waves"])
