#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pass of the curvature filter: the filtered angle from the curvatures of the segments, and the
move from the direction that the chord is to have.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp

from oracle import main, real
from plane import pair, point, unit, wrapped


def expected(case):
    given = case["in"]
    points, original = ([point(p) for p in given[key]] for key in ("P", "P_orig"))
    theta = [real(t) for t in given["theta"]]
    mu, tolerance = real(given["mu"]), real(given["tol"])
    chords = [b - a for a, b in zip(points, points[1:])]
    alpha = [wrapped(mp.arg(c) - t) for c, t in zip(chords, theta)]
    beta = [wrapped(t - mp.arg(c)) for c, t in zip(chords, theta[1:])]
    found = {"alpha": alpha, "beta": beta, "alpha_bar": [], "dH0": [], "dH": []}
    moved = list(points)
    for s in range(1, len(chords) - 1):
        near = (s - 1, s, s + 1)
        if all(alpha[q] * beta[q] > 0 for q in near):
            factor = {q: (alpha[q] + beta[q]) / (abs(chords[q]) * beta[q]) for q in near}
        else:
            factor = {q: 2 / abs(chords[q]) for q in near}
        curvature = {q: factor[q] * alpha[q] for q in near}
        mean = curvature[s] + mu / 2 * (curvature[s - 1] + curvature[s + 1] - 2 * curvature[s])
        angle = mean / factor[s]
        normal = 1j * unit(theta[s])
        # The chord as seen from the tangent; its far end stays.
        seen = chords[s] * unit(-theta[s])
        move = seen.imag - seen.real * mp.tan(angle)
        apart = points[s] - original[s]
        along = (apart * mp.conj(normal)).real
        square = along**2 - abs(apart) ** 2 + tolerance**2
        root = mp.sqrt(square) if square > 0 else 0
        limited = min(max(move, -along - root), -along + root)
        found["alpha_bar"].append(angle)
        found["dH0"].append(move)
        found["dH"].append(limited)
        moved[s] = points[s] + limited * normal
    found["P_new"] = [pair(p) for p in moved]
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
