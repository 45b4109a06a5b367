#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extrema of the curvature of a conic: roots of its derivative, found by sign changes.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main, real
from plane import point
from conics import cross


def expected(case):
    given = case["in"]
    poles, w = [point(given[key]) for key in ("R0", "R1", "R2")], real(given["w"])

    def size(t):
        """Curvature at a parameter, from derivatives of the quotient."""
        weights = [1, w, 1]
        basis = [(1 - t) ** 2, 2 * t * (1 - t), t**2]
        first = [-2 * (1 - t), 2 - 4 * t, 2 * t]
        second = [2, -4, 2]

        def total(b, values):
            return sum(x * y * z for x, y, z in zip(b, weights, values))

        ones = [1, 1, 1]
        d0, d1, d2 = total(basis, ones), total(first, ones), total(second, ones)
        p = total(basis, poles) / d0
        p1 = (total(first, poles) - d1 * p) / d0
        p2 = (total(second, poles) - 2 * d1 * p1 - d2 * p) / d0
        return abs(cross(p1, p2)) / abs(p1) ** 3

    # size^(-2/3) is a quotient of quartics: its derivative is a quartic over positive factors.
    d = [2 * w * (poles[1] - poles[0]), poles[2] - poles[0], 2 * w * (poles[2] - poles[1])]

    def slope(t):
        velocity = (1 - t) ** 2 * d[0] + 2 * t * (1 - t) * d[1] + t**2 * d[2]
        change = 2 * (1 - t) * (d[1] - d[0]) + 2 * t * (d[2] - d[1])
        weight = (1 - t) ** 2 + 2 * w * t * (1 - t) + t**2
        return 2 * (velocity.conjugate() * change).real * weight - 2 * abs(velocity) ** 2 * (
            2 * (w - 1) * (1 - 2 * t)
        )

    # A quartic is known by five values.
    nodes = [mpf(k) / 4 for k in range(5)]
    matrix = mp.matrix([[x**k for k in range(5)] for x in nodes])
    a = mp.lu_solve(matrix, mp.matrix([slope(x) for x in nodes]))
    roots = mp.polyroots([a[4 - k] for k in range(5)], maxsteps=500, extraprec=400)
    inside = sorted(
        mp.re(r) for r in roots if abs(mp.im(r)) < mpf(10) ** -30 and 0 < mp.re(r) < 1
    )
    maxima = [slope(r + mpf(10) ** -12) > 0 for r in inside]
    kinds = {(): "monotone", (True,): "one_max", (False,): "one_min"}
    radius = abs(poles[2] - poles[0]) / (4 * w**2)
    unit = (poles[2] - poles[0]) / abs(poles[2] - poles[0])
    return {
        "class": kinds.get(tuple(maxima), "max_and_min"),
        "in_circle0": bool(abs(poles[1] - poles[0] - radius * unit) < radius),
        "in_circle1": bool(abs(poles[1] - poles[2] + radius * unit) < radius),
        "extrema": inside,
        "kappa_extrema": [size(t) for t in inside],
        "kappa0": size(mpf(0)),
        "kappa1": size(mpf(1)),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
