# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the small models for the samples, the documentation and the tests of the project.

    /usr/bin/python3 samples/models/make_models.py FOLDER

The files are made with FreeCAD's Part module. Two runs give the same bytes.
"""

import math
import re
import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: F401  (Part needs it)
import Part

BLOCK = (40.0, 30.0, 20.0)  # mm
ROUNDING = 4.0  # mm
BROKEN_ANGLE = math.radians(2)


def rounded_block():
    """Return a block with every edge rounded: all seams are tangent, none is G2."""
    block = Part.makeBox(*BLOCK)
    return block.makeFillet(ROUNDING, block.Edges)


def broken_block():
    """Return the rounded block with one broken seam.

    In the middle of one side of the top the angle is 2 degrees. The top becomes a Bezier patch of
    degree (3, 5). Lifting the poles (2, 2) and (2, 3) by h keeps the boundary, and it keeps the
    tangent planes along three sides. Along the fourth side, with inner length l, the slope is 3 h
    (B2 + B3) / l, at most 1.875 h / l in the middle.
    """
    block = rounded_block()
    top = max(block.Faces, key=lambda face: face.CenterOfMass.z)
    low, high = top.BoundBox.XMin, top.BoundBox.XMax
    front, back, z = top.BoundBox.YMin, top.BoundBox.YMax, top.BoundBox.ZMax
    length = high - low
    lift = length * math.tan(BROKEN_ANGLE) / 1.875
    patch = Part.BezierSurface()
    patch.increase(3, 5)
    for i in range(4):
        for j in range(6):
            up = lift if i == 2 and j in (2, 3) else 0.0
            pole = FreeCAD.Vector(low + length * i / 3, front + (back - front) * j / 5, z + up)
            patch.setPole(i + 1, j + 1, pole)
    others = [face for face in block.Faces if not face.isSame(top)]
    shell = Part.makeShell(others + [patch.toShape()])
    shell.sewShape()
    return Part.Solid(Part.Shell(shell.Faces))


def open_block():
    """Return the broken block without one rounded corner: a shell with a hole of three sides."""
    faces = broken_block().Faces
    balls = [face for face in faces if face.Surface.TypeId == "Part::GeomSphere"]
    corner = max(balls, key=lambda face: face.CenterOfMass.dot(FreeCAD.Vector(1, -1, 1)))
    shell = Part.makeShell([face for face in faces if not face.isSame(corner)])
    shell.sewShape()
    return shell


def sheet():
    """Return a wavy bicubic sheet of 120 by 80 mm, cut into 3 by 2 faces that share their edges.

    All seams are G2.
    """
    count_x, count_y = 9, 6
    poles = [
        [
            FreeCAD.Vector(15.0 * i, 16.0 * j, 8 * math.sin(0.9 * i) * math.cos(0.7 * j))
            for j in range(count_y)
        ]
        for i in range(count_x)
    ]

    def knots(count):
        inner = count - 4
        return [4, *[1] * inner, 4], [k / (inner + 1) for k in range(inner + 2)]

    (u_counts, u_knots), (v_counts, v_knots) = knots(count_x), knots(count_y)
    whole = Part.BSplineSurface()
    whole.buildFromPolesMultsKnots(poles, u_counts, v_counts, u_knots, v_knots, False, False, 3, 3)
    faces = []
    for i in range(3):
        for j in range(2):
            part = whole.copy()
            part.segment(i / 3, (i + 1) / 3, j / 2, (j + 1) / 2)
            faces.append(part.toShape())
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


MODELS = {
    "rounded_block.step": rounded_block,
    "broken_block.step": broken_block,
    "open_block.step": open_block,
    "sheet.step": sheet,
}


def write_step(shape, path):
    """Write a shape without the time of day, so that the same shape gives the same bytes."""
    shape.exportStep(str(path))
    text = path.read_text()
    path.write_text(
        re.sub(r"'\d{4}-\d\d-\d\dT[\d:]+[^']*'", "'2000-01-01T00:00:00'", text, count=1)
    )


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit("usage: make_models.py FOLDER")
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in MODELS.items():
        write_step(make(), folder / name)
        print(folder / name)


if __name__ == "__main__":
    main()
