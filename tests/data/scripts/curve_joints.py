#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives by arc length on both sides of a joint, and how far they are apart.

Source: docs/theory/curves.md.
"""

import sys
from math import comb, factorial

from mpmath import mp
from oracle import bell, divided, dot, jet, main, minus, norm, real, scaled


def series_product(a, b):
    return [sum(a[i] * b[k - i] for i in range(k + 1)) for k in range(len(a))]


def by_arc_length(derivatives):
    """Derivatives by arc length: the power series of the speed, its integral, the inverse series of
    that, and the curve composed with it."""
    n = len(derivatives) - 1
    dimension = len(derivatives[0])
    taylor = [[real(x) / factorial(k) for x in d] for k, d in enumerate(derivatives)]
    velocity = [[(k + 1) * x for x in taylor[k + 1]] for k in range(n)]
    square = [sum(dot(velocity[i], velocity[k - i]) for i in range(k + 1)) for k in range(n)]
    speed = [mp.sqrt(square[0])]
    for k in range(1, n):
        rest = sum(speed[i] * speed[k - i] for i in range(1, k))
        speed.append((square[k] - rest) / (2 * speed[0]))
    # s(t) = sum s_k t^k and its powers; t(s) has the coefficients that make s(t(s)) = s.
    s = [mp.mpf(0)] + [speed[k] / (k + 1) for k in range(n)]
    t = [mp.mpf(0), 1 / s[1]] + [mp.mpf(0)] * (n - 1)
    for k in range(2, n + 1):
        power, error = list(t), s[1] * t[k]
        for j in range(2, k + 1):
            power = series_product(power, t)
            error += s[j] * power[k]
        t[k] = -error / s[1]
    found = [[x] + [mp.mpf(0)] * n for x in taylor[0]]
    power = [mp.mpf(1)] + [mp.mpf(0)] * n
    for j in range(1, n + 1):
        power = series_product(power, t)
        for axis in range(dimension):
            found[axis] = [f + taylor[j][axis] * p for f, p in zip(found[axis], power)]
    return [[factorial(k) * found[axis][k] for axis in range(dimension)] for k in range(n + 1)]


def side(poles, weights, t, n):
    if weights is None:
        return jet(poles, t, n)
    return divided(jet([[*scaled(w, p), w] for p, w in zip(poles, weights)], t, n))


def fitted_beta(a, b):
    """The beta for which B(beta) a is nearest to b along the tangent, order by order."""
    beta = []
    for k in range(1, len(a)):
        matrix = bell(beta + [0])
        rest = b[k]
        for j in range(2, k + 1):
            rest = minus(rest, scaled(matrix[k][j], a[j]))
        beta.append(dot(a[1], rest) / dot(a[1], a[1]))
    return beta


def expected(case):
    given = case["in"]
    n, size = int(given["nmax"]), given["L"]
    left = side(given["left"], given["left_weights"], 1, n)
    right = side(given["right"], given["right_weights"], 0, n)
    before, after = by_arc_length(left), by_arc_length(right)
    defects = [
        norm(minus(b, a)) * real(size) ** (k - 1) for k, (a, b) in enumerate(zip(before, after))
    ]
    order = next((k for k, d in enumerate(defects) if d > mp.mpf("1e-7")), n + 1) - 1
    return {
        "beta": fitted_beta(left, right),
        "cl": before,
        "cr": after,
        "defect": defects,
        "order_at_1e-7": order,
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
