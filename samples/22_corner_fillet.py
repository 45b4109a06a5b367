# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corner of a wedge of a cylinder rounded, with a different radius at each edge.

    python3 22_corner_fillet.py FOLDER

One of the three edges is an arc, and one of the three faces is the cylinder. Writes rounded.step
and corner_fillet.svg to the folder. For a model in a file the command does the same:

    seamwright corner wedge.step -o rounded.step --vertex 2 --radius 1,2,3
"""

import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD
import numpy as np
import Part

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

folder = Path(sys.argv[1])
wedge = Part.makeCylinder(20, 30, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 86)
model = seamwright.Model.from_freecad(wedge)

CORNER = (20, 0, 0)
vertex = 1 + min(
    range(len(wedge.Vertexes)),
    key=lambda k: wedge.Vertexes[k].Point.distanceToPoint(FreeCAD.Vector(CORNER)),
)
edges = model.corner_edges(vertex)
result = model.corner_fillet(vertex, dict(zip(edges, (1, 2, 3))))
report = result.to_dict()
for edge in report["edges"]:
    print(
        "Edge%(edge)d: radius %(radius_mm).0f mm, ends %(setback_mm).2f mm from the vertex" % edge
    )
kinds = [seam["between"] for seam in report["seams"]]
print(
    "G1: %s; %s; angle below %.0e degrees"
    % (
        result.met,
        ", ".join(f"{kinds.count(kind)} of kind {kind}" for kind in sorted(set(kinds))),
        report["largest_angle_deg"],
    )
)
result.model.write(folder / "rounded.step", overwrite=True)
solid = Part.read(str(folder / "rounded.step"))
print(
    "read back: %d faces, valid: %s, %.1f mm3 less"
    % (len(solid.Faces), solid.isValid(), wedge.Volume - solid.Volume)
)


def near_corner(points, reach=9):
    """Return the part of a line near the corner; None where it has fewer than two points."""
    points = points[np.linalg.norm(points - CORNER, axis=1) < reach]
    return points if len(points) > 1 else None


KINDS = {
    "contact": ("#888888", "fillets"),
    "section": ("#d55e00", "sections"),
    "spring": ("#009e73", "spring curves"),
    "spoke": ("#000000", "patches"),
}
picture = Picture("Radii of 1, 2 and 3 mm at a corner with a curved face", view=(1, -0.9, -0.8))
places = np.linspace(0, 1, 21)
for patch in result.patches:
    for s in np.linspace(0, 1, 9):
        picture.line(np.array([patch.point(s, t) for t in places]), color="#8fbbdc")
        picture.line(np.array([patch.point(t, s) for t in places]), color="#8fbbdc")
all_edges = result.model.to_freecad().Edges
named = set()
for seam in report["seams"]:
    kind = seam["between"]
    line = near_corner(
        np.array([(p.x, p.y, p.z) for p in all_edges[seam["edges"][0] - 1].discretize(200)])
    )
    if line is not None:
        color, label = KINDS[kind]
        picture.line(line, None if kind in named else label, color)
        named.add(kind)
picture.write(folder / "corner_fillet.svg")
