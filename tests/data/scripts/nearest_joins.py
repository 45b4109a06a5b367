#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest moves of rows 1 and 2 of a patch that make it continue another one: row after row
by least squares, or both at once by Newton's method. The other kinds are those of networks.py.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction

import networks
from mpmath import mp
from oracle import add, derivative, dot, main, minus, real, scaled, solve, times
from rational_surface_joins import edge_fields, first, second


def flat(row):
    return [x for pole in row for x in pole]


def least_squares(terms, wanted):
    """Factors of the terms with which their sum is nearest to what is wanted."""
    terms, wanted = [flat(term) for term in terms], flat(wanted)
    matrix = [[dot(a, b) for b in terms] for a in terms]
    return [x for (x,) in solve(matrix, [[dot(a, wanted)] for a in terms])]


class Rows:
    """Rows 1 and 2 by alpha, beta_0, beta_1, p, q_0, q_1."""

    def __init__(self, given):
        self.p, self.p_s, self.p_ss = edge_fields(given["P"])
        self.across = len(given["Q"]) - 1
        self.wanted = given["Q"][1], given["Q"][2]

    def row1(self, x):
        field = first(self.p, self.p_s, [x[0]], list(x[1:3]))
        return add(self.p, scaled(Fraction(1, self.across), field))

    def row2(self, x):
        field = second(self.p, self.p_s, self.p_ss, [x[0]], list(x[1:3]), [x[3]], list(x[4:6]))
        bend = scaled(Fraction(1, self.across * (self.across - 1)), field)
        return add(scaled(2, self.row1(x)), scaled(-1, self.p), bend)

    def one_after_the_other(self):
        zero, one = Fraction(0), Fraction(1)
        units = [[one, zero], [zero, one]]
        along = [times(unit, derivative(self.p)) for unit in units]
        wanted = scaled(self.across, minus(self.wanted[0], self.p))
        x = least_squares([self.p_s, *along], wanted)
        rest = minus(self.wanted[1], self.row2([*x, zero, zero, zero]))
        scale = self.across * (self.across - 1)
        return x + least_squares([self.p_s, *along], scaled(scale, rest))

    def cost(self, x, weights):
        moves = [minus(a, b) for a, b in zip((self.row1(x), self.row2(x)), self.wanted)]
        return sum(w * dot(flat(move), flat(move)) for w, move in zip(weights, moves))


def outputs(rows, x):
    return {
        "alpha": x[:1],
        "beta": x[1:3],
        "p": x[3:4],
        "q": x[4:],
        "row1": rows.row1(x),
        "row2": rows.row2(x),
    }


def min_change(given):
    rows = Rows(given)
    return outputs(rows, rows.one_after_the_other())


def min_change_joint(given):
    rows, weights = Rows(given), (given["w1"], given["w2"])
    x = rows.one_after_the_other()
    start = rows.cost(x, weights)
    unit = [[Fraction(i == k) for i in range(6)] for k in range(6)]
    for _ in range(5):
        # The cost is a polynomial of degree 4: differences of second order over steps of 1 and 2,
        # combined, give its derivatives exactly.
        x = [Fraction(int(mp.nint(real(v) * 2**160)), 2**160) for v in x]

        def at(*moves):
            return rows.cost(add(x, *(scaled(s, unit[k]) for k, s in moves)), weights)

        middle = at()
        gradient, matrix = [], [[None] * 6 for _ in range(6)]
        for k in range(6):
            f = {s: at((k, s)) for s in (-2, -1, 1, 2)}
            gradient.append((8 * (f[1] - f[-1]) - (f[2] - f[-2])) / 12)
            matrix[k][k] = (16 * (f[1] + f[-1]) - (f[2] + f[-2]) - 30 * middle) / 12
        for i in range(6):
            for j in range(i):

                def mixed(s):
                    corners = at((i, s), (j, s)) + at((i, -s), (j, -s))
                    corners -= at((i, s), (j, -s)) + at((i, -s), (j, s))
                    return corners / (4 * s * s)

                matrix[i][j] = matrix[j][i] = (4 * mixed(1) - mixed(2)) / 3
        x = add(x, [d for (d,) in solve(matrix, [[-g] for g in gradient])])
    return {**outputs(rows, x), "cost": rows.cost(x, weights), "cost_lexicographic_start": start}


def expected(case):
    if case["kind"] in networks.KINDS:
        return networks.expected(case)
    return {"min_change": min_change, "min_change_joint": min_change_joint}[case["kind"]](
        case["input"]
    )


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
