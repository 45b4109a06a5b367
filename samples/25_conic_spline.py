# SPDX-License-Identifier: LGPL-2.1-or-later
"""A biarc spline made G2: conics through the same joints.

    python3 25_conic_spline.py OUT.svg

Above: the biarc spline of points of half a profile, with its curvature comb, which jumps. Below:
the conics, with theirs.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)


def largest_jump(spline):
    """The largest difference of curvatures at the joints of a BezierSpline, 1/mm."""
    pairs = [(spline.segment(i), spline.segment(i + 1)) for i in range(spline.segments - 1)]
    return max(
        seamwright.measure_joint(first, second, 2)["differences"][2] for first, second in pairs
    )


points = np.array([[0, 0], [8, 14], [30, 26], [62, 28], [95, 18], [120, 0]], float)
arcs = seamwright.biarc_spline(points)
conics = seamwright.g2_conics(arcs)

print(f"{len(arcs.chain)} arcs: the curvature jumps by up to {largest_jump(arcs.curve):.4f} / mm")
print(
    f"{len(conics.conics)} conics, {len(conics.g1_joints)} joints only G1:"
    f" jumps below 1e-12: {largest_jump(conics.curve) < 1e-12}"
)
print(
    f"weights {conics.least_weight:.3f} to {conics.largest_weight:.3f},"
    f" corners moved by up to {conics.largest_move_mm:.3f} mm"
)

below = seamwright.g2_conics(seamwright.biarc_spline(points - [0, 55]))
picture = Picture("Arcs, and conics with a continuous curvature")
picture.curve(arcs.curve, "#0072b2", "arcs: G1", comb=True)
picture.points(np.pad(points, ((0, 0), (0, 1))), "the points")
picture.curve(below.curve, "#d55e00", "conics: G2", comb=True)
picture.points(np.pad(points - [0, 55], ((0, 0), (0, 1))))
picture.write(sys.argv[1])
