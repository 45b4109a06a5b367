#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Matrix-weighted rational Bezier curves: the point by elimination, the rational curve by Cramer's
rule with Bernstein polynomials.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mpf

from oracle import add, dot, main, norm, real, scaled, solve, times, value


def determinant(rows):
    """The determinant of a matrix of polynomials, by its first row."""
    if len(rows) == 1:
        return rows[0][0]
    terms = []
    for k, entry in enumerate(rows[0]):
        minor = determinant([row[:k] + row[k + 1 :] for row in rows[1:]])
        terms.append(scaled((-1) ** k, times(entry, minor)))
    return add(*terms)


def expected(case):
    given = case["in"]
    points = [[real(x) for x in p] for p in given["P"]]
    n, t = len(points[0]), real(given["t"])
    matrices = []
    for tangent, omega, mu in zip(given["tangent"], given["omega"], given["mu"]):
        tangent, omega, mu = [real(x) for x in tangent], real(omega), real(mu)
        unit = scaled(1 / norm(tangent), tangent)
        matrices.append(
            [
                [omega * ((1 + mu) * mpf(i == j) - mu * unit[i] * unit[j]) for j in range(n)]
                for i in range(n)
            ]
        )
    right = [[dot(row, p) for row in m] for m, p in zip(matrices, points)]
    entries = [[[m[i][j] for m in matrices] for j in range(n)] for i in range(n)]
    sums = [[r[i] for r in right] for i in range(n)]
    at = [[value(entry, t) for entry in row] for row in entries]
    found = [row[0] for row in solve(at, [[value(f, t)] for f in sums])]
    weights = determinant(entries)
    # Cramer: column k of the matrix is replaced by the right side.
    numerators = [
        determinant([row[:k] + [sums[i]] + row[k + 1 :] for i, row in enumerate(entries)])
        for k in range(n)
    ]
    return {
        "M": matrices,
        "value": found,
        "points": [[f[i] / w for f in numerators] for i, w in enumerate(weights)],
        "weights": weights,
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
