# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet whose seams are broken by noise, repaired by small moves of its poles.

    python3 17_repair_model.py sheet.step FOLDER

samples/models/make_models.py makes sheet.step. Writes broken.step, G1.step and G2.step to the
folder. The command does the same:

    seamwright repair FOLDER/broken.step -o FOLDER/G2.step --target G2
"""

import random
import sys
from pathlib import Path

sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD
import Part

import seamwright

if len(sys.argv) != 3 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

NOISE = 0.03  # mm


def broken(shape):
    """Add noise to the inner poles of every face: boundaries stay, tangent planes change."""
    noise = random.Random(17)
    faces = []
    for face in shape.Faces:
        surface = face.Surface.copy()
        for i in range(2, surface.NbUPoles):
            for j in range(2, surface.NbVPoles):
                away = FreeCAD.Vector(*(noise.uniform(-NOISE, NOISE) for _ in range(3)))
                surface.setPole(i, j, surface.getPole(i, j) + away)
        faces.append(surface.toShape())
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


def worst(report, figure):
    return max(seam[figure]["upper"] for seam in report.seams)


def main():
    model, folder = Path(sys.argv[1]), Path(sys.argv[2])
    if not model.is_file():
        sys.exit(f"{model}: there is no such file")
    if not folder.is_dir():
        sys.exit(f"{folder}: there is no such folder; make it first")
    broken(Part.read(str(model))).exportStep(str(folder / "broken.step"))
    given = seamwright.read(folder / "broken.step")
    for target in ("G1", "G2"):
        result = given.repair(target=target)
        if target == "G1":
            print("before: angles up to %.2g degrees" % worst(result.before, "angle_deg"))
        summary = result.summary
        print(
            "asked for %s: %d of %d seams repaired,"
            % (target, summary["repaired"], summary["treated"]),
            end=" ",
        )
        print("angles up to %.1g degrees," % worst(result.after, "angle_deg"), end=" ")
        print("poles moved by up to %.2f mm" % summary["largest_move_mm"])
        result.model.write(folder / (target + ".step"), overwrite=True)
        again = seamwright.read(folder / (target + ".step")).analyze(level=target)
        print("as written:", "all fine" if again.passed else "some fall short")


if __name__ == "__main__":
    main()
