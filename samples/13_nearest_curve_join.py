# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two curves with a kink, made to join with G1, G2 and G3 by the smallest moves of poles.

    python3 13_nearest_curve_join.py OUT.svg

The curves are of degree 5 and meet in the origin at an angle. The picture shows them and their
combs of curvature before and after. The arrows are the moves of the poles, enlarged five times.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

a = seamwright.BezierCurve(
    [[-50, 4, 0], [-40, 10, 0], [-30, 13, 0], [-20, 12.5, 0], [-10, 8, 0], [0, 0, 0]]
)
b = seamwright.BezierCurve(
    [[0, 0, 0], [11, -4, 0], [21, -7, 0], [31, -8, 0], [41, -4, 0], [52, 4, 0]]
)
DOWN = np.array([0, -42, 0])


def lowered(curve, steps):
    return seamwright.BezierCurve(curve.poles + steps * DOWN)


angle = seamwright.measure_joint(a, b, 1)["angle_rad"]
print(f"given: a kink of {np.degrees(angle):.1f} degrees")
picture = Picture("The smallest moves that make two curves join")
picture.curve(a, "#888888", "given, with a kink", comb=250)
picture.curve(b, "#888888", comb=250)
for order, color in ((1, "#0072b2"), (2, "#009e73"), (3, "#cc79a7")):
    join = seamwright.curve_nearest_join(a, b, order=order)
    worst = max(seamwright.fit_beta(join["a"], join["b"], order)["defects"])
    exponent = max(-13, int(np.ceil(np.log10(max(worst, 1e-300)))))
    print(
        f"G{order}: {join['status']}, largest move {join['largest_move_mm']:.2f} mm, defects below "
        f"1e{exponent}"
    )
    assert worst < 1e-11
    for given, name in ((a, "a"), (b, "b")):
        picture.polygon(lowered(given, order).poles, color="#bbbbbb")
        label = (
            f"G{order}, moves of up to {join['largest_move_mm']:.1f} mm" if name == "a" else None
        )
        picture.curve(lowered(join[name], order), color, label, comb=250)
        moves = "moves of poles, five times" if order == 3 and name == "b" else None
        picture.arrows(lowered(given, order).poles, 5 * (join[name].poles - given.poles), moves)
picture.write(sys.argv[1])
