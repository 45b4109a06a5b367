#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A chain of conics made G2: at each joint the rotation of the tangent by equal curvatures.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from conics import curvature, meeting
from oracle import main, real
from plane import pair, point, unit


def expected(case):
    given, out = case["in"], case["out"]
    poles = [point(p) for p in given["P"]]
    weights = [real(w) for w in given["w"]]
    start = abs(real(given["k_start"]))
    rotations = []
    for i in range(len(weights) - 1):
        before, corner, joint, next_corner, after = poles[2 * i : 2 * i + 5]
        left, right = weights[i], weights[i + 1]
        direction = mp.arg(next_corner - corner)

        def rotated(theta):
            """Corners and weights that keep the curvatures at the far ends."""
            tangent = unit(direction + theta)
            a = meeting(before, corner - before, joint, tangent)
            b = meeting(after, next_corner - after, joint, tangent)
            end = abs(curvature(after, next_corner, joint, right))
            return (
                a,
                b,
                mp.sqrt(abs(curvature(before, a, joint, 1)) / start),
                mp.sqrt(abs(curvature(after, b, joint, 1)) / end),
            )

        def jump(theta):
            a, b, wa, wb = rotated(theta)
            return mp.log(
                abs(curvature(joint, a, before, wa)) / abs(curvature(joint, b, after, wb))
            )

        # The file tells which root is meant; it is computed again from five of its digits.
        guess = mp.nint(real(out["theta"][i]) * 10**5) / 10**5
        theta = mp.findroot(jump, (guess, guess + mpf("0.00001")), tol=mpf(10) ** -100)
        rotations.append(theta)
        a, b, wa, wb = rotated(theta)
        poles[2 * i + 1], poles[2 * i + 3], weights[i], weights[i + 1] = a, b, wa, wb
        start = abs(curvature(joint, b, after, wb))
    return {"P_new": [pair(p) for p in poles], "w_new": weights, "theta": rotations}


if __name__ == "__main__":
    sys.exit(main(__file__, expected, 30))
