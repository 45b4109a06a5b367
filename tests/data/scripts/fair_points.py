#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of least energy within tolerances: Newton's method on the moves that are not at a bound.

The curvatures are those of point_curvatures.py, by the centres of circles; the derivatives are
differences in 60 digits. What is at a bound stays there while the energy pushes it outwards.
Source: docs/theory/planar.md.
"""

import sys

from mpmath import matrix, mp, mpf

from oracle import main, real
from plane import pair, point
from point_curvatures import curvature

STEP = mpf(10) ** -20
# Differences with this step have twenty digits less than sixty.
SURE = 15


class Problem:
    def __init__(self, given):
        self.points = [point(p) for p in given["P"]]
        self.closed = bool(given["closed"])
        self.tolerances = [real(t) for t in given["tol"]]
        n = len(self.points)
        self.normals = []
        for i in range(n):
            ends = (i - 1, (i + 1) % n) if self.closed else (max(i - 1, 0), min(i + 1, n - 1))
            chord = self.points[ends[1]] - self.points[ends[0]]
            self.normals.append(1j * chord / abs(chord))
        self.movable = [i for i, t in enumerate(self.tolerances) if t > 0]

    def moved(self, shares):
        points = list(self.points)
        for i, share in zip(self.movable, shares):
            points[i] += share * self.tolerances[i] * self.normals[i]
        return points

    def energy(self, shares):
        points = self.moved(shares)
        n = len(points)
        at = range(n) if self.closed else range(1, n - 1)
        values = [curvature(points[i - 1], points[i], points[(i + 1) % n]) for i in at]
        pairs = list(zip(at, values, values[1:] + values[:1]))
        return sum(
            (after - before) ** 2 / abs(points[(i + 1) % n] - points[i])
            for i, before, after in (pairs if self.closed else pairs[:-1])
        )


def derivatives(energy, x, free):
    """Gradient, and the Hessian of the free unknowns, by central differences."""

    def at(*moves):
        y = list(x)
        for k, sign in moves:
            y[k] += sign * STEP
        return energy(y)

    middle = energy(x)
    ahead = [at((k, 1)) for k in range(len(x))]
    behind = [at((k, -1)) for k in range(len(x))]
    gradient = [(a - b) / (2 * STEP) for a, b in zip(ahead, behind)]
    hessian = matrix(len(free))
    for row, i in enumerate(free):
        for column, j in enumerate(free[: row + 1]):
            if i == j:
                value = ahead[i] + behind[i] - 2 * middle
            else:
                value = at((i, 1), (j, 1)) + middle - ahead[i] - ahead[j]
                value = value / 2 + (at((i, -1), (j, -1)) + middle - behind[i] - behind[j]) / 2
            hessian[row, column] = hessian[column, row] = value / STEP**2
    return gradient, hessian


def least(problem):
    x = [mpf(0)] * len(problem.movable)
    damping = mpf(0)
    for _ in range(200):
        value = problem.energy(x)
        held = [abs(share) == 1 for share in x]
        free = [k for k in range(len(x)) if not held[k]]
        gradient, hessian = derivatives(problem.energy, x, free)
        free = [k for k in range(len(x)) if not held[k] or gradient[k] * x[k] > 0]
        if len(free) != hessian.rows:
            gradient, hessian = derivatives(problem.energy, x, free)
        if not free or max(abs(gradient[k]) for k in free) < mpf(10) ** -18 * value:
            return x, value
        while True:
            damped = hessian + damping * mp.eye(len(free))
            change = mp.lu_solve(damped, matrix([-gradient[k] for k in free]))
            trial = list(x)
            for k, part in zip(free, change):
                trial[k] = min(max(x[k] + part, mpf(-1)), mpf(1))
            if problem.energy(trial) < value:
                x, damping = trial, damping / 10
                if damping < mpf(10) ** -8 * mp.mnorm(hessian, 1):
                    damping = mpf(0)
                break
            damping = max(damping * 10, mpf(10) ** -6 * mp.mnorm(hessian, 1))
    raise ValueError("no minimum after 200 steps")


def expected(case):
    problem = Problem(case["in"])
    shares, value = least(problem)
    return {"energy": value, "P_new": [pair(p) for p in problem.moved(shares)]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected, SURE))
