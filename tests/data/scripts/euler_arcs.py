#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Euler arc splines: arcs laid end to end; the difference of their curvatures by Newton's method.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main, real
from plane import Ends, arc_end, pair


def chain(start, direction, curvatures, length):
    """The joints of arcs of one length."""
    joints = [start]
    for k in curvatures:
        joints.append(arc_end(joints[-1], direction, k, length))
        direction += k * length
    return joints


def expected(case):
    given, out = case["in"], case["out"]
    ends = Ends(given)
    count = int(given["n"])
    change = ends.alpha + ends.beta
    half = mpf(count - 1) / 2

    def joints(x, length):
        curvatures = [(change + x * (j - half)) / length for j in range(count)]
        return curvatures, chain(ends.start, ends.first, curvatures, length / count)

    def height(x):
        """Distance of the end from the line of the chord, for arcs of length 1 in all."""
        last = joints(x, mpf(1))[1][-1] - ends.start
        return (last / mp.expj(ends.direction)).imag

    # The file tells which root is meant; it is computed again from five of its digits.
    guess = mp.nint(real(out["delta"]) * real(out["L"]) * 10**5) / 10**5
    x = mp.findroot(height, (guess, guess + mpf("0.001")), tol=mpf(10) ** -100)
    length = ends.chord / abs(joints(x, mpf(1))[1][-1] - ends.start)
    curvatures, found = joints(x, length)
    return {
        "k0": curvatures[0],
        "delta": curvatures[1] - curvatures[0],
        "L": length,
        "joints": [pair(z) for z in found],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected, 30))
