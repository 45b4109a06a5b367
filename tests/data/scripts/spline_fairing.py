#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing of cubic B-spline curves, from the polynomials of the basis functions on each span: the
pole that makes the third derivative continuous, and the least energy by dense normal equations.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main, real, solve


def plus(a, b, factor=1):
    n = max(len(a), len(b))
    a, b = a + [mpf(0)] * (n - len(a)), b + [mpf(0)] * (n - len(b))
    return [x + factor * y for x, y in zip(a, b)]


def times(a, b):
    result = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def slope(a):
    return [k * x for k, x in enumerate(a)][1:] or [mpf(0)]


def value(a, t):
    return sum((x * t**k for k, x in enumerate(a)), mpf(0))


def basis(u, i, degree, span):
    """Coefficients of the basis function i on a span, by the recurrence of Cox and de Boor."""
    if degree == 0:
        return [mpf(i == span)]
    result = [mpf(0)]
    for k, low, high in ((i, u[i], u[i + degree]), (i + 1, u[i + degree + 1], u[i + 1])):
        if low != high:
            part = times(basis(u, k, degree - 1, span), [-low, mpf(1)])
            result = plus(result, part, 1 / (high - low))
    return result


class Cubic:
    def __init__(self, knots):
        self.u = [real(t) for t in knots]
        self.count = len(self.u) - 4

    def span(self, t):
        spans = [s for s in range(3, self.count) if self.u[s] < self.u[s + 1]]
        return max(s for s in spans if self.u[s] <= t)

    def functions(self, span, order=0):
        found = {}
        for i in range(span - 3, span + 1):
            found[i] = basis(self.u, i, 3, span)
            for _ in range(order):
                found[i] = slope(found[i])
        return found

    def at(self, poles, span, t, order):
        functions = self.functions(span, order)
        return [sum(value(f, t) * poles[i][k] for i, f in functions.items()) for k in (0, 1)]


def curvature_slope(first, second, third):
    def cross(a, b):
        return a[0] * b[1] - a[1] * b[0]

    square = first[0] ** 2 + first[1] ** 2
    along = first[0] * second[0] + first[1] * second[1]
    return (square * cross(first, third) - 3 * along * cross(first, second)) / square**3


def fair_at_knot(given):
    curve, j = Cubic(given["knots"]), int(given["j"])
    poles = [[real(x) for x in pole] for pole in given["d"]]
    t = curve.u[j]

    def slopes(poles, span):
        return curvature_slope(*(curve.at(poles, span, t, order) for order in (1, 2, 3)))

    left, right = curve.functions(j - 1, 3), curve.functions(j, 3)
    jump = {i: value(right.get(i, [mpf(0)]), t) - value(left.get(i, [mpf(0)]), t)
            for i in set(left) | set(right)}
    fair = [
        -sum(jump[i] * poles[i][k] for i in jump if i != j - 2) / jump[j - 2] for k in (0, 1)
    ]
    old = poles[j - 2]
    distance = mp.hypot(fair[0] - old[0], fair[1] - old[1])
    share = min(mpf(1), real(given["delta"]) / distance)
    limited = [a + share * (b - a) for a, b in zip(old, fair)]
    moved = poles[: j - 2] + [fair] + poles[j - 1 :]
    return {
        "dk_left": slopes(poles, j - 1),
        "dk_right": slopes(poles, j),
        "d_hat": fair,
        "d_limited": limited,
        "dk_after": slopes(moved, j),
    }


def least_energy(given):
    curve, weight = Cubic(given["knots"]), real(given["lambda"])
    n = curve.count
    points = [[real(x) for x in q] for q in given["Q"]]
    matrix = [[mpf(0)] * n for _ in range(n)]
    right = [[mpf(0)] * 2 for _ in range(n)]
    rows = []
    for t, q in zip((real(t) for t in given["t"]), points):
        row = {i: value(f, t) for i, f in curve.functions(curve.span(t)).items()}
        rows.append(row)
        for i, x in row.items():
            for j, y in row.items():
                matrix[i][j] += x * y
            for k in (0, 1):
                right[i][k] += x * q[k]
    energy = [[mpf(0)] * n for _ in range(n)]
    for span in range(3, n):
        length = curve.u[span + 1] - curve.u[span]
        thirds = {i: value(f, 0) for i, f in curve.functions(span, 3).items()}
        for i, x in thirds.items():
            for j, y in thirds.items():
                energy[i][j] += length * x * y
    system = [[matrix[i][j] + weight * energy[i][j] for j in range(n)] for i in range(n)]
    if given["fix_ends"]:
        for i, q in ((0, points[0]), (n - 1, points[-1])):
            system[i] = [mpf(i == j) for j in range(n)]
            right[i] = list(q)
    poles = solve(system, right)
    value_of = sum(
        (sum(x * poles[i][k] for i, x in row.items()) - q[k]) ** 2 / 2
        for row, q in zip(rows, points)
        for k in (0, 1)
    ) + weight / 2 * sum(
        energy[i][j] * poles[i][k] * poles[j][k]
        for i in range(n)
        for j in range(n)
        for k in (0, 1)
    )
    return {"d": poles, "energy": value_of}


def expected(case):
    given = case["in"]
    return fair_at_knot(given) if given["kind"] == "knot" else least_energy(given)


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
