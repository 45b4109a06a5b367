#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest moves of poles that make two curves meet with G^n: for a given beta the poles of a
linear system, for the best beta a descent from the measured one.

Source: docs/theory/curves.md.
"""

import sys
from math import comb, factorial

from curve_joints import fitted_beta
from mpmath import mp
from oracle import add, bell, dot, jet, main, minus, real, scaled, solve


class Problem:
    def __init__(self, given):
        self.n, self.both = int(given["n"]), given["mode"] == "both"
        self.left = [[real(x) for x in p] for p in given["left"]]
        self.right = [[real(x) for x in p] for p in given["right"]]
        self.m, self.mr = len(self.left) - 1, len(self.right) - 1
        n = self.n
        # P_m, P_(m-1), .. and Q_0, Q_1, ..: the poles that the conditions hold.
        self.poles = [self.left[self.m - j] for j in range(n + 1)] + self.right[: n + 1]

    def conditions(self, beta):
        """Rows k: the k-th derivative of the right curve less that of the left by beta."""
        n, b = self.n, bell(beta)
        rows = []
        for k in range(n + 1):
            row = [mp.mpf(0)] * (2 * n + 2)
            for order in range(k + 1):
                factor = mp.mpf(factorial(self.m)) / factorial(self.m - order)
                for j in range(order + 1):
                    row[j] -= real(b[k][order]) * factor * (-1) ** j * comb(order, j)
            factor = mp.mpf(factorial(self.mr)) / factorial(self.mr - k)
            for j in range(k + 1):
                row[n + 1 + j] += factor * (-1) ** (k - j) * comb(k, j)
            rows.append([x / factor for x in row])
        return rows

    def solved(self, beta):
        """Half the sum of the squared moves, and the moved poles."""
        rows = self.conditions(beta)
        moving = [k > self.n or self.both for k in range(2 * self.n + 2)]
        gram = [
            [sum(x * y for x, y, free in zip(a, b, moving) if free) for b in rows] for a in rows
        ]
        defect = [add(*(scaled(x, p) for x, p in zip(row, self.poles))) for row in rows]
        forces = solve(gram, defect)
        poles = [
            minus(p, add(*(scaled(row[k], f) for row, f in zip(rows, forces)))) if free else p
            for k, (p, free) in enumerate(zip(self.poles, moving))
        ]
        return sum(dot(f, d) for f, d in zip(forces, defect)) / 2, poles

    def cost(self, x):
        return self.solved([mp.exp(x[0]), *x[1:]])[0]

    def slopes(self, x, step):
        """Gradient and Hessian by central differences."""
        n = len(x)

        def at(*moves):
            y = list(x)
            for k, move in moves:
                y[k] += move
            return self.cost(y)

        middle = at()
        ends = [(at((k, step)), at((k, -step))) for k in range(n)]
        gradient = [(up - down) / (2 * step) for up, down in ends]
        hessian = [[mp.mpf(0)] * n for _ in range(n)]
        for i, (up, down) in enumerate(ends):
            hessian[i][i] = (up - 2 * middle + down) / step**2
            for j in range(i):
                mixed = at((i, step), (j, step)) - at((i, step), (j, -step))
                mixed -= at((i, -step), (j, step)) - at((i, -step), (j, -step))
                hessian[i][j] = hessian[j][i] = mixed / (4 * step**2)
        return middle, gradient, hessian


def minimiser(problem, beta):
    """Newton's method, with a multiple of the unit matrix where the cost would rise."""
    x, damping = [mp.log(beta[0]), *beta[1:]], mp.mpf("1e-3")
    step = mp.mpf("1e-15")
    for _ in range(200):
        cost, gradient, hessian = problem.slopes(x, step)
        size = max(abs(h[k]) for k, h in enumerate(hessian))
        if max(map(abs, gradient)) < mp.mpf("1e-24") * (1 + cost):
            break
        while True:
            damped = [
                [
                    h + (damping * (abs(row[i]) + size * mp.mpf("1e-9")) if i == j else 0)
                    for j, h in enumerate(row)
                ]
                for i, row in enumerate(hessian)
            ]
            move = [d for (d,) in solve(damped, [[-g] for g in gradient])]
            trial = [a + b for a, b in zip(x, move)]
            if abs(move[0]) < 2 and problem.cost(trial) < cost:
                x, damping = trial, damping / 10
                break
            damping = max(damping * 10, mp.mpf("1e-12"))
            if damping > mp.mpf("1e20"):
                return [mp.exp(x[0]), *x[1:]]
    return [mp.exp(x[0]), *x[1:]]


def expected(case):
    problem = Problem(case["in"])
    n = problem.n
    a, b = jet(problem.left, 1, n), jet(problem.right, 0, n)
    beta = [real(x) for x in fitted_beta(a, b)]
    if beta[0] <= 0:
        beta[0] = mp.sqrt(dot(b[1], b[1]) / dot(a[1], a[1]))
    beta = minimiser(problem, beta)
    cost, poles = problem.solved(beta)
    left = problem.left[: problem.m - n] + poles[n::-1]
    return {
        "beta": beta,
        "objective": cost,
        "left_new": left,
        "right_new": poles[n + 1 :] + problem.right[n + 1 :],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
