# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about a corner of several fillets.

The report is a dict with the keys ``tolerance``, ``met``, ``reason`` (why the target is not met),
``filled_by`` ("patches" or "opencascade"), ``patches_reason`` (why not by patches), ``faces`` (the
new ones), ``edges`` and ``seams`` (see new_seams). ``edges`` has a dict for each edge: edge,
rounded, convex, angle_deg, radius_mm, contact_mm, setback_mm (None where OpenCASCADE fills). The
numbers of edges are those of the source.
"""

import math

from freecad.seamwright.plain import new_seams, repair_text, summary
from freecad.seamwright.plain.language import mark, tr

TARGET = "G1"

EMPTY_REPORT = {
    "tolerance": {},
    "met": False,
    "reason": "",
    "filled_by": "patches",
    "patches_reason": "",
    "faces": [],
    "edges": [],
    "seams": [],
}

#: The faces that meet at a new seam, by the kernel's word for the seam.
BETWEEN = {
    "spoke": mark("two patches"),
    "section": mark("patch, fillet"),
    "spring": mark("patch, face"),
    "contact": mark("fillet, face"),
    "fillets": mark("two fillets"),
}

#: A suggested radius is this part of the length of the shortest edge, rounded down to one digit.
SUGGESTED = 0.1


def build_report(found, tolerance):
    """Build the report from the result of the kernel."""
    seams = [
        new_seams.deciding({**seam, "between": BETWEEN[seam["between"]]}, TARGET)
        for seam in found["seams"]
    ]
    if not found["met"]:
        seams = [{**seam, "edges": [], "faces": [], "worst": None} for seam in seams]
    return {
        "tolerance": tolerance,
        "met": found["met"],
        "reason": repair_text.named(found["shortfall"]),
        "filled_by": found["filled_by"],
        "patches_reason": repair_text.named(found["patches_shortfall"]),
        "faces": found["faces"] if found["met"] else [],
        "edges": found["edges"],
        "seams": seams,
    }


def summary_text(report):
    """Return one line: the radii and the new seams, or the reason why nothing was rounded."""
    if not report["met"]:
        return tr("Not rounded: {reason}.").format(reason=report["reason"].rstrip("."))
    radii = ", ".join("%g" % edge["radius_mm"] for edge in report["edges"])
    seams = new_seams.largest_text(report["seams"], report["tolerance"])
    rounded = summary.counted(len(report["edges"]), "edge")
    made = tr(
        "Corner of {rounded} rounded with radii {radii} mm; {seams}; {target} is met."
    ).format(rounded=rounded, radii=radii, seams=seams, target=TARGET)
    return made + filled_text(report)


def filled_text(report):
    """Say that OpenCASCADE filled the corner, and why patches did not; "" where patches did.

    Reports of documents that older versions saved do not say who filled: it was patches.
    """
    if report.get("filled_by", "patches") == "patches":
        return ""
    return tr(" Filled by OpenCASCADE; not by patches: {patches_reason}.").format(
        patches_reason=report["patches_reason"].rstrip(".")
    )


def waiting_text(edges):
    """Say how many edges a computation would round."""
    return tr("{edges} to round.").format(edges=summary.counted(len(edges), "edge"))


def new_faces(report):
    """Return the numbers of the patches and of the fillets.

    Reports of documents that older versions saved have them in their seams alone.
    """
    return set(report.get("faces", ())) or _faces(report, "spoke", "section")


def patches(report):
    """Return the numbers of the patches of the corner."""
    return _faces(report, "spoke")


def _faces(report, *words):
    kinds = [BETWEEN[word] for word in words]
    return {
        number for seam in report["seams"] if seam["between"] in kinds for number in seam["faces"]
    }


def edge_text(edge):
    """ "convex, 90°": the kind of an edge of the report and the angle between its faces."""
    return "%s, %.4g\u00b0" % (tr("convex") if edge["convex"] else tr("concave"), edge["angle_deg"])


def suggested_radius_mm(lengths_mm):
    """Return a radius that usually fits a corner whose edges have these lengths."""
    wanted = SUGGESTED * min(lengths_mm)
    unit = 10.0 ** math.floor(math.log10(wanted))
    return float("%.12g" % (unit * math.floor(wanted / unit + 1e-9)))


def by_edge(numbers, edges, name):
    """Return {edge: number} for one number for each edge, or one number for all edges.

    Raises ValueError for any other count of numbers.
    """
    if len(numbers) == 1:
        numbers = list(numbers) * len(edges)
    if len(numbers) != len(edges):
        raise ValueError(
            tr(
                "{name} has {numbers} for the {edges} edges of the corner ({names}): give one for "
                "each, or one for all"
            ).format(
                name=name,
                numbers=summary.counted(len(numbers), "number"),
                edges=len(edges),
                names=repair_text.edges_text({"edges": edges}),
            )
        )
    return dict(zip(edges, numbers))
