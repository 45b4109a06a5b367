# SPDX-License-Identifier: LGPL-2.1-or-later
"""Digitised points made fair within a tolerance.

    python3 27_fair_points.py OUT.svg

Above: clothoids through points with errors of up to 0.02 mm, with their curvature comb. Below:
those through the points made fair. The lines at the points are the moves, 100 times as long.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

x = np.linspace(0, 120, 25)
errors = 0.02 * np.sin(np.arange(25) ** 2)  # of no pattern, and the same on each machine
read = np.column_stack([x, 30 * np.sqrt(x / 120) * (1 - x / 120) + errors])[1:]
fair = seamwright.fair_points(read, 0.02)

for name, state in (("as read", fair.before), ("fair", fair.after)):
    print(
        f"{name}: {len(state.extrema)} extrema of the curvature,"
        f" energy {state.energy_per_mm3:.2e} / mm^3"
    )
print(f"largest move {fair.moved_mm:.4f} mm")
assert fair.moved_mm <= 0.02


def through(points):
    """Clothoids through points, as a spline to draw."""
    return seamwright.clothoid_spline(points).chain.bezier_spline(1e-5).curve


shift = np.array([0, -30])
picture = Picture("Points as read, and made fair within 0.02 mm")
picture.curve(through(read), "#0072b2", "through the points as read", comb=True)
picture.curve(through(fair.points_mm + shift), "#d55e00", "through the fair points", comb=True)
picture.points(np.pad(fair.points_mm + shift, ((0, 0), (0, 1))), "fair points")
moves = np.pad(fair.points_mm - read, ((0, 0), (0, 1)))
picture.arrows(
    np.pad(fair.points_mm + shift, ((0, 0), (0, 1))), 100 * moves, "moves, 100 times", "#000000"
)
picture.write(sys.argv[1])
