#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvatures of the circles through three points, by their centres.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main
from plane import point


def curvature(a, b, c):
    """1 / radius of the circle, from the centre as the intersection of two bisectors."""
    first, second = b - a, c - b
    turn = (mp.conj(first) * second).imag
    if turn == 0:
        return mpf(0)
    # The centre is on the bisector of b and c: their midpoint and a multiple of the normal.
    midpoint = (b + c) / 2
    normal = 1j * second
    share = ((a + b) / 2 - midpoint) * mp.conj(first)
    centre = midpoint + share.real / (normal * mp.conj(first)).real * normal
    return mp.sign(turn) / abs(centre - b)


def expected(case):
    points = [point(p) for p in case["in"]["P"]]
    values = [curvature(*points[i - 1 : i + 2]) for i in range(1, len(points) - 1)]
    bad = [
        i + 1
        for i in range(1, len(values) - 1)
        if values[i] * values[i - 1] < 0 and values[i] * values[i + 1] < 0
    ]
    return {"kappa": values, "bad": bad}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
