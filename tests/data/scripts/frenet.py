#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speed, Frenet frame, curvature, torsion, change of curvature and length of a curve.

Source: docs/theory/curves.md.
"""

import sys

from mpmath import mp
from oracle import cross, divided, dot, jet, main, norm, real, scaled


def derivatives(poles, weights, t, order):
    if weights is None:
        return jet(poles, t, order)
    return divided(jet([[*scaled(w, p), w] for p, w in zip(poles, weights)], t, order))


def expected(case):
    given = case["in"]
    poles = [[real(x) for x in p] for p in given["points"]]
    weights = given["weights"] and [real(w) for w in given["weights"]]
    t = real(given["t"])
    _, d1, d2, d3 = derivatives(poles, weights, t, 3)
    speed, c = norm(d1), cross(d1, d2)
    tangent, binormal = scaled(1 / speed, d1), scaled(1 / norm(c), c)
    change = dot(c, cross(d1, d3)) / norm(c) * speed**2 - 3 * norm(c) * dot(d1, d2)
    length = mp.quad(
        lambda s: norm(derivatives(poles, weights, s, 1)[1]), mp.linspace(0, t, 5), maxdegree=8
    )
    return {
        "speed": speed,
        "T": tangent,
        "N": cross(binormal, tangent),
        "B": binormal,
        "kappa": norm(c) / speed**3,
        "tau": dot(c, d3) / dot(c, c),
        "dkappa_ds": change / speed**6,
        "arclength": length,
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
