# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_picture.py SEAM_PICTURE ADDON OUT: what seam-picture writes, and how it fails."""

import os
import shutil
import struct
import subprocess
import sys
import tempfile

STEP = "/usr/share/opencascade/data/step/linkrods.step"
BREP = "/usr/share/opencascade/data/occ/Pump_Nut.brep"


def run(program, *arguments):
    done = subprocess.run(
        [program, *arguments], capture_output=True, text=True, timeout=280, check=False
    )
    print(done.returncode, done.stdout, done.stderr)
    return done


def png_size(path):
    """Width and height of a PNG file."""
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", path
    return struct.unpack(">II", head[16:24])


def main():
    program, addon, out = sys.argv[1:]
    for name in ("freecad", "xvfb-run"):
        assert shutil.which(name), f"{name} is not installed"
    for path in (STEP, BREP):
        assert os.path.exists(path), f"{path} is missing: install Debian's package occt-misc"
    os.makedirs(out, exist_ok=True)
    target = os.path.join(out, "picture.png")
    good = run(program, STEP, target, "--mod", addon)
    assert good.returncode == 0 and "seams:" in good.stderr, "no picture"
    assert png_size(target) == (1600, 1000)
    striped = os.path.join(out, "picture-zebra.png")
    assert (
        run(program, BREP, striped, "--mod", addon, "--zebra", "--view", "front").returncode == 0
    ), "no stripes"
    assert png_size(striped) == (1600, 1000)
    both = os.path.join(out, "picture-pair.png")
    pair = run(program, "--pair", BREP, BREP, both, "--mod", addon, "--zebra")
    assert pair.returncode == 0 and pair.stderr.count("seams:") == 2, "no pair"
    assert png_size(both) == (1600, 800)
    bent = os.path.join(out, "picture-curvature.png")
    assert run(program, BREP, bent, "--mod", addon, "--curvature").returncode == 0, "no curvature"
    assert png_size(bent) == (1600, 1000)
    with tempfile.TemporaryDirectory() as folder:
        broken = os.path.join(folder, "broken.step")
        with open(broken, "w", encoding="utf-8") as file:
            file.write("this is not a model\n")
        nothing = os.path.join(folder, "nothing.png")
        assert run(program, broken, nothing, "--mod", addon).returncode == 1
        assert run(program, STEP, nothing).returncode == 2
        assert run(program, STEP, nothing, "--mod", addon, "--view", "left").returncode == 2
        assert run(program, "--pair", STEP, nothing, "--mod", addon).returncode == 2
        assert (
            run(program, os.path.join(folder, "absent.step"), nothing, "--mod", addon).returncode
            == 2
        )
        assert os.listdir(folder) == ["broken.step"], "something was left behind"
    return 0


if __name__ == "__main__":
    sys.exit(main())
