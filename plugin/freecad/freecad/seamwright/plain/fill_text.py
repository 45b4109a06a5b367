# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said about holes and their fills.

The report is a dict: ``target``, ``tolerance``, and ``fills``, a dict each of ``hole`` (its number,
or None), ``face`` (the number of the face that was replaced, or None), ``filled``, ``reached``,
``reason``, ``faces`` (the new ones) and ``seams`` (see new_seams). Numbers of faces and edges are
those of the result, in reasons those of the source.
"""

from freecad.seamwright.plain import new_seams, repair_text, summary

INSIDE = "the fill itself"

EMPTY_REPORT = {"target": "G1", "tolerance": {}, "fills": []}


def edges_of(hole):
    """The numbers of the edges of a hole, in its order."""
    return [number for side in hole["sides"] for number in side["edges"]]


def default_holes(holes):
    """The holes that are filled when none is chosen: the longest loop of connected faces is mostly
    their rim.

    Where each is the longest, all of them.
    """
    return [hole for hole in holes if not hole["longest"]] or list(holes)


def chosen_holes(holes, edges):
    """The holes that the edges are of, one edge is enough. Raises ValueError for an edge that is of
    none."""
    owners = {number: hole for hole in holes for number in edges_of(hole)}
    for number in edges:
        if number not in owners:
            raise ValueError(
                "edge %d is no edge of a hole: it is not open, or part of no closed loop" % number
            )
    wanted = {owners[number]["id"] for number in edges}
    return [hole for hole in holes if hole["id"] in wanted]


def hole_text(hole, holes):
    """ "Hole 2: 4 sides, 63.1 mm around (5, 0, 2.5)", with a remark at one that is not filled unless
    it is chosen."""
    sides = summary.counted(len(hole["sides"]), "side") if hole["has_corners"] else "no corner"
    centre = ", ".join("%.4g" % (round(coordinate, 9) + 0.0) for coordinate in hole["centre_mm"])
    text = "Hole %d: %s, %.4g mm around (%s)" % (hole["id"], sides, hole["length_mm"], centre)
    return text if hole in default_holes(holes) else text + ", the longest loop: a rim?"


def hole_tip(hole):
    """The edges of a hole by their names."""
    return repair_text.edges_text({"edges": edges_of(hole)})


def entry(found, hole=None, face=None):
    """What is kept of a fill, ``found``: what the kernel says. Numbers are those of the filled
    model."""
    new = set(found["faces"])
    seams = [
        new_seams.deciding({**seam, "between": _between(seam, new, face)}, found["target"])
        for seam in found["outer"] + found["inner"]
    ]
    if not found["filled"]:
        seams = [{**seam, "edges": [], "faces": [], "worst": None} for seam in seams]
    return {
        "hole": hole,
        "face": face,
        **{name: found[name] for name in ("filled", "reached")},
        "reason": repair_text.named(found["reason"]),
        "faces": found["faces"] if found["filled"] else [],
        "seams": seams,
    }


def old_number(number, new, replaced):
    """The number in the source of a face of the filled model; None for a new one."""
    if number in new:
        return None
    number -= sum(other < number for other in new)
    return number + 1 if replaced is not None and number >= replaced else number


def _between(seam, new, replaced):
    old = [old_number(number, new, replaced) for number in seam["faces"]]
    kept = ["Face%d" % number for number in old if number is not None]
    return "fill, " + kept[0] if kept else INSIDE


def every_seam(report):
    """The seams of all fills."""
    return [seam for fill in report["fills"] for seam in fill["seams"]]


def kept(report):
    """The fills that are in the result."""
    return [fill for fill in report["fills"] if fill["filled"]]


def missed(report):
    """The fills that do not reach the target, kept or not."""
    return [fill for fill in report["fills"] if not fill["reached"]]


def new_faces(report):
    """(numbers of the new faces, number of the face that they replace or None)."""
    replaced = [fill["face"] for fill in kept(report)]
    return {number for fill in kept(report) for number in fill["faces"]}, replaced[
        0
    ] if replaced else None


def waiting_text(faces, holes):
    """What would be done: names of faces that are replaced, none or one, or numbers of holes."""
    return (
        "%s to replace." % faces[0]
        if faces
        else "%s to fill." % summary.counted(len(holes), "hole")
    )


def name_of(fill):
    """ "Hole 2" or "Face16"."""
    return "Hole %d" % fill["hole"] if fill["face"] is None else "Face%d" % fill["face"]


def reasons(report):
    """A line for each fill that misses the target."""
    return ["%s: %s" % (name_of(fill), fill["reason"].rstrip(".") + ".") for fill in missed(report)]


def summary_text(report):
    """One line: how many holes were filled to what; why not, where just one was wanted."""
    fills, done, target = report["fills"], kept(report), report["target"]
    if len(fills) == 1 and not done:
        return "Not filled: %s" % reasons(report)[0]
    replaced = fills[0]["face"] is not None if fills else False
    text = "%s replaced" % name_of(fills[0]) if replaced else "%d of %s filled" % (
        len(done), summary.counted(len(fills), "hole")
    )  # fmt: skip
    if not done:
        return "%s: %s" % (text, " ".join(reasons(report)))
    made = summary.counted(sum(len(fill["faces"]) for fill in done), "face")
    seams = new_seams.largest_text(
        [seam for fill in done for seam in fill["seams"]], report["tolerance"]
    )
    verdict = "%s is met" if all(fill["reached"] for fill in done) else "%s is missed, kept anyway"
    return "%s with %s; %s; %s." % (text, made, seams, verdict % target)
