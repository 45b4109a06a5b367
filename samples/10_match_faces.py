# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two sheets that meet at an angle, made to join G1 and G2 by the smallest move.

    python3 10_match_faces.py FOLDER

Writes before.brep, G1.brep and G2.brep to the folder. seam-picture draws them side by side with
zebra stripes:

    plugin/freecad/tools/seam-picture --zebra --pair FOLDER/before.brep FOLDER/G2.brep OUT.png
        --mod build/release/Mod/Seamwright
"""

import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD
import Part

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

WIDTH, DEPTH = 50.0, 60.0  # mm
ACROSS = (0.0, 10.0, 10.0, 0.0)  # heights of poles along the seam, mm


def sheet(sense, slope, bend):
    """Return a bicubic sheet from x = 0 to x = WIDTH sense.

    Its height is slope |x| + bend x^2 / 2 plus an arch along the seam.
    """
    rise, sag = slope * WIDTH, bend * WIDTH**2
    heights = [0, rise / 3, 2 * rise / 3 + sag / 6, rise + sag / 2]
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for i in range(4):
        for j in range(4):
            surface.setPole(
                i + 1,
                j + 1,
                FreeCAD.Vector(sense * WIDTH * i / 3, DEPTH * j / 3, heights[i] + ACROSS[j]),
            )
    return surface.toShape()


def figures(seam):
    return "%s, angle %.2g degrees, curvature %.2g %%" % (
        seam["level"],
        seam["angle_deg"]["upper"],
        100 * seam["curvature_rel"]["upper"],
    )


def main():
    folder = Path(sys.argv[1])
    pair = Part.Compound([sheet(-1, slope=0, bend=-0.01), sheet(1, slope=0.05, bend=0.004)])
    pair.exportBrep(str(folder / "before.brep"))
    model = seamwright.Model.from_freecad(pair)
    for target in ("G1", "G2"):
        result = model.match_faces(1, 2, target=target)
        if not result.matched:
            sys.exit(result.reason)
        if target == "G1":
            print("before:", figures(result.before))
        print(
            "asked for %s: %s, poles moved by up to %.2f mm"
            % (target, figures(result.after), result.largest_move_mm)
        )
        result.model.to_freecad().exportBrep(str(folder / (target + ".brep")))


if __name__ == "__main__":
    main()
