# SPDX-License-Identifier: LGPL-2.1-or-later
"""A face at a corner of a block is taken out, and the hole is filled.

    python3 21_fill_hole.py rounded_block.step FOLDER

samples/models/make_models.py makes rounded_block.step. Writes filled.step and fill_hole.svg to the
folder. The command does the same:

    seamwright fill rounded_block.step -o FOLDER/filled.step --face N
"""

import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: F401 - Part needs it
import numpy as np
import Part

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 3 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

model, folder = Path(sys.argv[1]), Path(sys.argv[2])
block = Part.read(str(model))
sphere = 1 + next(k for k, face in enumerate(block.Faces) if isinstance(face.Surface, Part.Sphere))
print("Face%d is a sphere between three fillets" % sphere)
filled = seamwright.read(model).fill(face=sphere)
report = filled.to_dict()
print(
    "%d faces, %d seams to the neighbours and %d inside: reached G1: %s"
    % (len(report["faces"]), len(report["outer"]), len(report["inner"]), filled.reached)
)
print(
    "angle below %.0e degrees, gap below %.0e mm"
    % (filled.largest_angle_deg, filled.largest_gap_mm)
)
filled.model.write(folder / "filled.step", overwrite=True)

solid = Part.read(str(folder / "filled.step"))
print(
    "read back: %s of %d faces, volume %.1f mm3, was %.1f"
    % (
        "closed solid" if solid.isClosed() and solid.Solids else "open",
        len(solid.Faces),
        solid.Volume,
        block.Volume,
    )
)


def points_of(line, count=40):
    return np.array([(p.x, p.y, p.z) for p in line.discretize(count)])


def lines_of(face, count=9):
    """Yield parameter lines of a face that covers its whole surface."""
    u0, u1, v0, v1 = face.ParameterRange
    for s in np.linspace(0, 1, count):
        for line in (face.Surface.uIso(u0 + s * (u1 - u0)), face.Surface.vIso(v0 + s * (v1 - v0))):
            yield points_of(line)


new = [solid.Faces[k - 1] for k in report["faces"]]
centre = np.mean([np.array(face.CenterOfMass) for face in new], axis=0)
outward = np.sign(centre - np.array(solid.Solids[0].CenterOfMass))
picture = Picture("A corner filled with three faces", view=(outward * (0.8, 1, 0.9)).tolist())
label = "edges of the block"
for edge in (edge for edge in solid.Edges if not edge.Degenerated):
    line = points_of(edge, 200)
    line = line[np.linalg.norm(line - centre, axis=1) < 9]
    if len(line) > 1:
        picture.line(line, label, "#000000")
        label = None
for face, color in zip(new, ("#0072b2", "#d55e00", "#009e73")):
    for line in lines_of(face):
        picture.line(line, color=color)
picture.write(folder / "fill_hole.svg")
