# SPDX-License-Identifier: LGPL-2.1-or-later
"""One set of points with growing tension, with tension at one point only, and with bias.

    python3 15_nu_spline.py OUT.svg
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

points = np.array(
    [[0, 0, 0], [10, 22, 0], [26, 18, 0], [34, 2, 0], [52, 6, 0], [60, 24, 0], [78, 20, 0]],
    dtype=float,
)
knots = seamwright.spline_knots(points, 1) / np.float64(20)


def from_polygon(curve):
    """Return the largest distance of the curve from its polygon."""
    worst = 0
    for i in range(curve.segments):
        x = np.array([curve.segment(i).point(t) for t in np.linspace(0, 1, 65)])
        chord = (x[-1] - x[0]) / np.linalg.norm(x[-1] - x[0])
        worst = max(
            worst, np.linalg.norm(x - x[0] - np.outer((x - x[0]) @ chord, chord), axis=1).max()
        )
    return worst


drawing = Picture("The same points: tension everywhere, at one point, bias")


def place(number):
    return np.array([92 * (number % 2), -46 * (number // 2), 0])


def draw(curve, number, label, comb=15):
    moved = seamwright.BezierSpline(3, curve.knots, curve.poles + place(number))
    drawing.curve(moved, label=label, comb=comb)
    drawing.points(points + place(number))


for number, nu in enumerate((0, 5, 50, 5000)):
    curve = seamwright.nu_spline(points, knots, nu=nu)["curve"]
    orders = {joint["order_reached"] for joint in curve.measure_joints(2)}
    print(
        f"nu = {nu}: at most {from_polygon(curve):.4f} mm from the polygon, joints G{min(orders)}"
    )
    draw(curve, number, f"nu = {nu}", comb=40 if nu < 50 else None)

one = seamwright.nu_spline(points, knots, nu=[0, 0, 0, 100, 0, 0, 0])["curve"]
draw(one, 4, "nu = 100 at the fourth point only", comb=None)
biased = seamwright.beta_spline(points, bias=[1, 1, 1, 3, 1, 1, 1])["curve"]
joint = biased.measure_joints(2)[2]
print(
    f"bias 3 at the fourth point: G{joint['order_reached']}, and the curve leaves it a third as "
    "fast"
)
draw(biased, 5, "bias = 3 at the fourth point", comb=40)
drawing.write(sys.argv[1])
