#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives of nu-splines at their points: the jumps P''(u+) - P''(u-) = nu P'(u) and the end
conditions as one linear system.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from oracle import add, main, minus, scaled, solve


def slopes(points, knots, nu, ends, first=None, last=None):
    """P' at each point. A cubic of length h has P''(start) = (6 s - 4 m - 2 m') / h and
    P''(end) = (2 m + 4 m' - 6 s) / h, with the slope s of its chord."""
    n = len(points) - 1
    h = [b - a for a, b in zip(knots, knots[1:])]
    s = [scaled(1 / h[k], minus(points[k + 1], points[k])) for k in range(n)]
    count = n if ends == "periodic" else n + 1
    zero = scaled(Fraction(0), points[0])
    matrix = [[Fraction(0)] * count for _ in range(count)]
    right = [zero for _ in range(count)]

    def second_after(i, k, sign=1):
        """Adds P'' at the start of segment k to row i."""
        matrix[i][k % count] += sign * -4 / h[k]
        matrix[i][(k + 1) % count] += sign * -2 / h[k]
        right[i] = minus(right[i], scaled(sign * 6 / h[k], s[k]))

    def second_before(i, k, sign=1):
        """Adds P'' at the end of segment k to row i."""
        matrix[i][k % count] += sign * 2 / h[k]
        matrix[i][(k + 1) % count] += sign * 4 / h[k]
        right[i] = add(right[i], scaled(sign * 6 / h[k], s[k]))

    for i in range(1, n):
        second_after(i, i)
        second_before(i, i - 1, -1)
        matrix[i][i] -= nu[i]
    if ends == "periodic":
        second_after(0, 0)
        second_before(0, n - 1, -1)
        matrix[0][0] -= nu[0] + nu[n]
    elif ends == "natural":
        second_after(0, 0)
        matrix[0][0] -= nu[0]
        second_before(n, n - 1)
        matrix[n][n] += nu[n]
    else:
        matrix[0][0] = matrix[n][n] = Fraction(1)
        right[0], right[n] = first, last
    m = solve(matrix, right)
    return [*m, m[0]] if ends == "periodic" else m


def expected(case):
    given = case["in"]
    m = slopes(given["P"], given["u"], given["nu"], given["bc"], given.get("m0"), given.get("mn"))
    return {"m": m}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
