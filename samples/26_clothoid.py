# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoids through points: a path that a car or a robot can follow.

    python3 26_clothoid.py OUT.svg

Above: the biarc spline of the points, with its curvature comb: at each joint the steering wheel
would have to jump. Below: the clothoids, whose curvature is linear in the length of the path.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

# The middle of a road, in m; the functions take any unit of length.
points = np.array([[0, 0], [40, 4], [75, 25], [110, 50], [150, 52], [190, 40]], float)
arcs = seamwright.biarc_spline(points)
path = seamwright.clothoid_spline(points)

for number, piece in enumerate(path.chain.pieces, 1):
    print(
        f"clothoid {number}: {piece.length_mm:.2f} m,"
        f" curvature {piece.curvature_per_mm:+.5f} / m, slope {piece.curvature_slope_per_mm2:+.2e}"
    )
sharpest = max(abs(piece.curvature_per_mm) for piece in path.chain.pieces)
even = path.curvature_jump_per_mm < 1e-12
print(f"smallest radius {1 / sharpest:.1f} m, jumps below 1e-12: {even}")

below = seamwright.clothoid_spline(points - [0, 80]).chain.bezier_spline(1e-3).curve
picture = Picture("A path of arcs, and one of clothoids")
picture.curve(arcs.curve, "#0072b2", "arcs", comb=True)
picture.points(np.pad(points, ((0, 0), (0, 1))), "the points")
picture.curve(below, "#d55e00", "clothoids", comb=True)
picture.points(np.pad(points - [0, 80], ((0, 0), (0, 1))))
picture.write(sys.argv[1])
