#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Derivatives of interpolating beta-splines, from the equations of their joints as one linear
system, and the nu-splines that the open ones are.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from oracle import add, main, minus, scaled, solve


def expected(case):
    given = case["in"]
    points, ends, n = given["Q"], given["bc"], len(given["Q"]) - 1
    bias, tension = list(given["b1"]), given["b2"]
    if ends != "periodic":
        bias[n] = Fraction(1)
    count = n if ends == "periodic" else n + 1
    matrix = [[Fraction(0)] * count for _ in range(count)]
    right = [scaled(Fraction(0), points[0]) for _ in range(count)]

    # Segment k has the derivatives m[k] and bias[k+1] m[k+1] at its ends, and the chord q.
    def second_after(i, k, factor):
        matrix[i][k % count] += factor * -4
        matrix[i][(k + 1) % count] += factor * -2 * bias[k + 1]
        right[i] = minus(right[i], scaled(factor * 6, minus(points[k + 1], points[k])))

    def second_before(i, k, factor):
        matrix[i][k % count] += factor * 2
        matrix[i][(k + 1) % count] += factor * 4 * bias[k + 1]
        right[i] = add(right[i], scaled(factor * 6, minus(points[k + 1], points[k])))

    # P''(left) = bias^2 P''(right) + tension P'(right).
    for j in range(1, n):
        second_before(j, j - 1, Fraction(1))
        second_after(j, j, -bias[j] ** 2)
        matrix[j][j] -= tension[j]
    if ends == "periodic":
        second_before(0, n - 1, Fraction(1))
        second_after(0, 0, -bias[n] ** 2)
        matrix[0][0] -= tension[n]
    elif ends == "natural":
        second_after(0, 0, Fraction(1))
        matrix[0][0] -= given["nu0"]
        second_before(n, n - 1, Fraction(1))
        matrix[n][n] += given["nun"]
    else:
        matrix[0][0] = matrix[n][n] = Fraction(1)
        right[0], right[n] = given["m0"], given["mn"]
    m = solve(matrix, right)
    if ends == "periodic":
        return {"m": [*m, m[0]]}
    h = [Fraction(1)]
    for j in range(1, n):
        h.append(h[-1] / bias[j])
    nu = [-tension[j] / (bias[j] * h[j - 1]) for j in range(1, n)]
    first, last = given.get("nu0", 0), given.get("nun", 0)
    return {"m": m, "nu_h": h, "nu_nu": [first / h[0], *nu, last / h[-1]]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
