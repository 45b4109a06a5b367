#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing of cubic splines y(x), from cubics with the conditions of a spline as dense equations.

Source: docs/theory/planar.md.
"""

import sys
from fractions import Fraction

from oracle import main, solve


class Spline:
    """Cubics a + b d + c d^2 + e d^3 in d = x - x_i, exact."""

    def __init__(self, x, y, slopes):
        self.x, n = x, len(x) - 1
        rows, right = [], []

        def equation(value, *terms):
            row = [Fraction(0)] * (4 * n)
            for place, factor in terms:
                row[place] += factor
            rows.append(row)
            right.append([value])

        for i in range(n):
            h = x[i + 1] - x[i]
            equation(y[i], (4 * i, 1))
            equation(y[i + 1], *((4 * i + k, h**k) for k in range(4)))
            if i + 1 < n:
                equation(0, (4 * i + 5, -1), *((4 * i + k, k * h ** (k - 1)) for k in (1, 2, 3)))
                equation(0, (4 * i + 6, -1), (4 * i + 2, 1), (4 * i + 3, 3 * h))
        h, last = x[n] - x[n - 1], 4 * (n - 1)
        if slopes:
            equation(slopes[0], (1, 1))
            equation(slopes[1], *((last + k, k * h ** (k - 1)) for k in (1, 2, 3)))
        else:
            equation(0, (2, 1))
            equation(0, (last + 2, 1), (last + 3, 3 * h))
        found = [row[0] for row in solve(rows, right)]
        self.pieces = [found[4 * i : 4 * i + 4] for i in range(n)]

    def __call__(self, at):
        i = max(i for i in range(len(self.pieces)) if self.x[i] <= at)
        return sum(c * (at - self.x[i]) ** k for k, c in enumerate(self.pieces[i]))

    def second(self):
        h = self.x[-1] - self.x[-2]
        last = self.pieces[-1]
        return [2 * p[2] for p in self.pieces] + [2 * last[2] + 6 * h * last[3]]

    def third_jumps(self):
        return [6 * (b[3] - a[3]) for a, b in zip(self.pieces, self.pieces[1:])]


def mean(c, i):
    return (c[i - 1] + 4 * c[i] + c[i + 1]) / 6


def expected(case):
    given = case["in"]
    x, y = ([Fraction(v) for v in given[key]] for key in "xy")
    slopes = None
    if given["bc"] == "clamped":
        slopes = [Fraction(given["y0p"]), Fraction(given["ynp"])]
    spline, j, n = Spline(x, y, slopes), int(given["j"]), len(x) - 1
    middles = [x[0], *((a + b) / 2 for a, b in zip(x, x[1:])), x[-1]]
    half = [spline(at) for at in middles]
    poles = list(y)
    for _ in range(int(given["steps"])):
        inner = [poles[i] + y[i] - mean(poles, i) for i in range(1, n)]
        poles = [y[0], *inner, y[-1]]
    return {
        "M": spline.second(),
        "jump3": spline.third_jumps(),
        "y_j_faired": Spline(x[:j] + x[j + 1 :], y[:j] + y[j + 1 :], slopes)(x[j]),
        "rebound_half": half,
        "rebound_full": [Spline(middles, half, slopes)(at) for at in x],
        "polish": poles,
        "polish_nodes": [mean(poles, i) for i in range(1, n)],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
