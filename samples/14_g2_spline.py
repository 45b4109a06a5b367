# SPDX-License-Identifier: LGPL-2.1-or-later
"""One polygon, two families of cubic splines that are G2 by construction.

    python3 14_g2_spline.py OUT.svg

Left: the direct G2 spline for several shares alpha, omega of the edges. Right: the gamma-spline for
gamma 1 (the C2 B-spline), 0.3, 0.05 and 5. Combs show the curvature; where it is continuous they
have no steps. Each spline is converted to a B-spline curve with the fewest knots that it allows.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

polygon = np.array([(0, 0), (8, 26), (34, 32), (46, 4), (74, 0), (86, 24), (70, 40)], dtype=float)
polygon = np.column_stack([polygon, np.zeros(len(polygon))])
RIGHT = np.array([116, 0, 0])


def described(name, spline):
    jump = max(joint["differences"][2] for joint in spline.measure_joints(2))
    smooth = spline.continuity()
    curve = spline.to_bspline(smooth)
    away = max(
        np.linalg.norm(curve.point(t) - spline.point(t))
        for t in np.linspace(spline.knots[0], spline.knots[-1], 201)
    )
    assert jump < 1e-12 and away < 1e-13 * np.abs(polygon).max()
    print(
        f"{name}: {spline.segments} segments, curvature jumps by less than 1e-12 / mm; "
        f"B-spline of {len(curve.poles)} poles, C{smooth} in its knots"
    )
    return spline


picture = Picture("Direct G2 splines (left) and gamma-splines (right) of one polygon", width=1000)
picture.polygon(polygon, "polygon")
for alpha, omega, comb in ((1 / 3, 2 / 3, True), (0.1, 0.9, None), (0.55, 0.65, None)):
    spline = described(
        f"alpha {alpha:.2f}, omega {omega:.2f}", seamwright.direct_g2_spline(polygon, alpha, omega)
    )
    picture.curve(spline, label=f"alpha {alpha:.2f}, omega {omega:.2f}", comb=comb)
picture.polygon(polygon + RIGHT)
for gamma, comb in ((1, True), (0.3, None), (0.05, None), (5, None)):
    described(f"gamma {gamma}", seamwright.gamma_spline(polygon, gamma=gamma))
    picture.curve(
        seamwright.gamma_spline(polygon + RIGHT, gamma=gamma), label=f"gamma {gamma}", comb=comb
    )
picture.write(sys.argv[1])
