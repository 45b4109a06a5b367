# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about holes and their fills.

The report is a dict with the keys ``target``, ``tolerance`` and ``fills``. ``fills`` has a dict for
each fill: ``hole`` (its number, or None), ``face`` (the number of the face that was replaced, or
None), ``filled``, ``reached``, ``reason``, ``faces`` (the new faces) and ``seams`` (see new_seams).
The numbers of faces and edges are those of the result; in reasons they are those of the source.
"""

from freecad.seamwright.plain import new_seams, repair_text, summary
from freecad.seamwright.plain.language import mark, tr

#: What a report says about the faces at a seam: two new ones, or a new one and a face by its name.
BESIDE, INSIDE = new_seams.BESIDE, mark("the fill itself")

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
    centre = ", ".join("%.4g" % (round(coordinate, 9) + 0.0) for coordinate in hole["centre_mm"])
    length = "%.4g mm" % hole["length_mm"]
    text = tr("Hole {id}: {sides}, length {length}, centre ({centre})").format(
        id=hole["id"], sides=sides, length=length, centre=centre
    )
    return text if hole in default_holes(holes) else text + tr(
        ", the longest loop: an outer boundary?"
    )


def hole_tip(hole):
    """Return the names of the edges of a hole."""
    return repair_text.edges_text({"edges": edges_of(hole)})


def entry(found, hole=None, face=None, sides=()):
    """Return the entry of a fill in the report.

    ``found``: the result of the kernel. The numbers are those of the filled model. ``sides``: of
    the hole in the source; where the fill was not kept, they give the edges of its seams.
    """
    new = set(found["faces"])
    seams = [
        new_seams.deciding({**seam, "between": _between(seam, new, face)}, found["target"])
        for seam in found["outer"] + found["inner"]
    ]
    if not found["filled"]:
        along = _edges_along(sides)
        seams = [
            {
                **seam,
                "edges": [],
                "faces": [],
                "worst": None,
                "along": along.get(seam["between"], []),
            }
            for seam in seams
        ]
    return {
        "hole": hole,
        "face": face,
        **{name: found[name] for name in ("filled", "reached")},
        "reason": repair_text.named(found["reason"]),
        "faces": found["faces"] if found["filled"] else [],
        "seams": seams,
    }


def _edges_along(sides):
    """Return {what a seam lies between: [numbers of the edges of the hole there]}."""
    found = {}
    for side in sides:
        for edge, face in zip(side["edges"], side["faces"]):
            found.setdefault("%sFace%d" % (BESIDE, face), []).append(edge)
    return found


def old_number(number, new, replaced):
    """Return the number in the source of a face of the filled model; None for a new face."""
    if number in new:
        return None
    number -= sum(other < number for other in new)
    return number + 1 if replaced is not None and number >= replaced else number


def _between(seam, new, replaced):
    old = [old_number(number, new, replaced) for number in seam["faces"]]
    kept = ["Face%d" % number for number in old if number is not None]
    return BESIDE + kept[0] if kept else INSIDE


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
    """Return a line for each fill that misses the target."""
    return ["%s: %s" % (name_of(fill), fill["reason"].rstrip(".") + ".") for fill in missed(report)]


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
    return tr("{holes} with {faces}; {seams}; {verdict}.").format(
        holes=text, faces=made, seams=seams, verdict=verdict.format(level=target)
    )
