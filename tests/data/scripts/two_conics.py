#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two conics that join G2: the joint from equal curvatures on both of its sides.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp

from conics import curvature
from oracle import main, real
from plane import pair, point


def expected(case):
    given = case["in"]
    start, apex, end = (point(given[key]) for key in ("P0", "d", "P4"))
    k0, k2 = real(given["k0"]), real(given["k2"])
    first = start + real(given["s"]) * (apex - start)
    last = end + real(given["q"]) * (apex - end)

    def weights(joint):
        """Those that give the curvatures at the ends."""
        return (
            mp.sqrt(abs(curvature(start, first, joint, 1)) / k0),
            mp.sqrt(abs(curvature(end, last, joint, 1)) / k2),
        )

    def jump(x):
        """Difference of the cube roots of the radii."""
        joint = first + x * (last - first)
        w1, w2 = weights(joint)
        radii = [
            1 / abs(curvature(joint, corner, far, w))
            for corner, far, w in ((first, start, w1), (last, end, w2))
        ]
        return mp.cbrt(radii[0]) - mp.cbrt(radii[1])

    x = mp.findroot(jump, (mp.mpf("0.3"), mp.mpf("0.6")), tol=mp.mpf(10) ** -100)
    joint = first + x * (last - first)
    w1, w2 = weights(joint)
    return {
        "P1": pair(first),
        "P2": pair(joint),
        "P3": pair(last),
        "w1": w1,
        "w2": w2,
        "kappa_mid": abs(curvature(joint, last, end, w2)),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
