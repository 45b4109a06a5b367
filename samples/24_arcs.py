# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve as arcs and lines for a machine that mills nothing else.

    python3 24_arcs.py OUT.svg

Above: a curve with its curvature comb. Below: the arcs within 0.1 mm of it, with theirs; the
curvature is constant on each arc and jumps at the joints.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

poles = np.array([[0, 0, 0], [20, 35, 0], [45, 45, 0], [70, -25, 0], [95, -10, 0], [120, 20, 0]])
curve = seamwright.BezierCurve(poles)

for tolerance in (0.1, 0.01, 0.001):
    fit = seamwright.fit_arcs(curve, tolerance)
    print(
        f"within {tolerance:g} mm: {len(fit.chain)} arcs,"
        f" distance at most {fit.distance_mm:.5f} mm"
    )
    assert fit.distance_mm <= tolerance

coarse = seamwright.fit_arcs(seamwright.BezierCurve(poles - [0, 50, 0]), 0.1)
joints = np.array([[*arc.start, 0] for arc in coarse.chain.arcs[1:]])

picture = Picture("A curve, and arcs within 0.1 mm of it")
picture.curve(curve, "#0072b2", "the curve", comb=True)
picture.curve(coarse.curve, "#d55e00", f"{len(coarse.chain)} arcs", comb=True)
picture.points(joints, "joints: G1", "#d55e00")
picture.write(sys.argv[1])
