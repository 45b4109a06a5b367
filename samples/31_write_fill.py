# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hole of five sides is filled, sewn to its surroundings and written, without FreeCAD.

    python3 31_write_fill.py OUT.step

The patches around the hole are parts of one surface, so their corners are compatible. The file is
read back and judged.
"""

import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

SIDES = 5
ANGLES = 2 * np.pi * (np.arange(SIDES) + 0.25) / SIDES


def lifted(corners):
    """Return the patch of a paraboloid above a quadrilateral, corners (u, v) = 00, 01, 10, 11."""
    t = np.arange(4) / 3
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=-1)
    u, v = np.meshgrid(t, t, indexing="ij")
    shares = np.stack([(1 - u) * (1 - v), (1 - u) * v, u * (1 - v), u * v], axis=-1)
    xy = shares @ np.asarray(corners)
    height = 14 - 0.012 * xy[..., :1] ** 2 - 0.008 * xy[..., 1:] ** 2
    inverse = np.linalg.inv(basis)
    points = np.concatenate([xy, height], axis=-1)
    return seamwright.BezierPatch(np.einsum("ai,bj,ijc->abc", inverse, inverse, points))


inner = 30 * np.stack([np.cos(ANGLES), np.sin(ANGLES)], axis=-1)
outer = 1.6 * inner
around = [
    lifted([inner[k], inner[(k + 1) % SIDES], outer[k], outer[(k + 1) % SIDES]])
    for k in range(SIDES)
]
fill = seamwright.n_sided_fill([(patch, "u0") for patch in around])

names = [f"side {k}" for k in range(SIDES)] + ["fill"]
model = seamwright.Model.from_patches([*around, fill], names, sew_mm=1e-4)
written = model.write(sys.argv[1], overwrite=True)
print(f"{model.face_count} faces, {model.edge_count} edges, written as {written.format}")

report = seamwright.read(sys.argv[1]).analyze(level="G1")
levels = [seam.level for seam in report.seams]
print(f"read back: {len(report)} seams, {levels.count('none') + levels.count('G0')} of them not G1")
assert report.passed
