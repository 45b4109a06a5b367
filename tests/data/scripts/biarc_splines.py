#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tangents of biarc splines: the minimum of a quadratic form of all directions, as one dense system
of its gradient.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from biarcs import expected as biarc_of
from oracle import main, real, solve
from plane import point, wrapped


def expected(case):
    given = case["in"]
    points = [point(p) for p in given["P"]]
    n = len(points)
    closed = given["closed"]
    segments = [(s, (s + 1) % n) for s in range(n if closed else n - 1)]
    chords = [points[b] - points[a] for a, b in segments]
    psi = [mp.arg(c) for c in chords]
    # Directions are theta_i = base_i + x_i, where base follows the chords without jumps.
    base = [psi[0]]
    for s in range(1, len(segments)):
        base.append(base[-1] + wrapped(psi[s] - psi[s - 1]))
    if not closed:
        base.append(base[-1])
    energy = given["algorithm"] == "energy"
    factor = real(given["lambda"]) if energy else mpf(1)
    matrix = [[mpf(0)] * n for _ in range(n)]
    right = [[mpf(0)] for _ in range(n)]

    def add_square(weight, terms, constant):
        """Adds weight (sum of c x_i + constant)^2 / 2 to the form."""
        for i, c in terms:
            for j, d in terms:
                matrix[i][j] += weight * c * d
            right[i][0] -= weight * c * constant

    for s, (a, b) in enumerate(segments):
        alpha = [(a, mpf(-1))]
        turn = wrapped(base[b] - base[a]) if closed else base[b] - base[a]
        beta = [(b, mpf(1))]
        length = abs(chords[s])
        if energy:
            add_square(1 / length, alpha, mpf(0))
            add_square(1 / length, beta, turn)
        add_square(factor / (length if energy else 1), alpha + [(b, mpf(-1))], -turn)
    if not closed:
        for i, name in ((0, "theta0"), (n - 1, "thetan")):
            matrix[i] = [mpf(i == j) for j in range(n)]
            right[i] = [wrapped(real(given[name]) - base[i])]
    x = [row[0] for row in solve(matrix, right)]
    theta = [b + y for b, y in zip(base, x)]
    alpha = [wrapped(psi[s] - theta[a]) for s, (a, _) in enumerate(segments)]
    beta = [wrapped(theta[b] - psi[s]) for s, (_, b) in enumerate(segments)]
    biarcs = []
    for s, (a, b) in enumerate(segments):
        ends = {
            "P0": given["P"][a],
            "theta0": theta[a],
            "P1": given["P"][b],
            "theta1": theta[b],
            "rule": "equal_chord",
        }
        found = biarc_of({"in": ends})
        biarcs.append({key: found[key] for key in ("joint", "k1", "k2")})
    return {"alpha": alpha, "beta": beta, "biarcs": biarcs}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
