#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bezier segments as one B-spline: its poles are the blossoms of the segments at its knots; and
arcs of circles as rational quadratics.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from mpmath import mp
from oracle import add, main, real, scaled, value

SMOOTHNESS = {"cubicC1": 1, "quinticC2": 2, "arcs": 0, "circle": 0}


def blossom(poles, places):
    for t in places:
        poles = [add(scaled(1 - t, a), scaled(t, b)) for a, b in zip(poles, poles[1:])]
    return poles[0]


def circle(given):
    """Homogeneous quadratics, one for each span."""
    centre = [real(x) for x in given["center"]]
    radius, start, count = real(given["radius"]), real(given["start"]), len(given["breaks"]) - 1
    half = real(given["sweep"]) / count / 2

    def pole(angle, away, weight):
        point = [centre[0] + away * mp.cos(angle), centre[1] + away * mp.sin(angle)]
        return [*scaled(weight, point), weight]

    return [
        [
            pole(start + 2 * k * half, radius, mp.mpf(1)),
            pole(start + (2 * k + 1) * half, radius / mp.cos(half), mp.cos(half)),
            pole(start + (2 * k + 2) * half, radius, mp.mpf(1)),
        ]
        for k in range(count)
    ]


def expected(case):
    given = case["in"]
    kind, breaks = given["kind"], given["breaks"]
    rational = kind in ("arcs", "circle")
    if kind == "circle":
        segments = circle(given)
    elif kind == "arcs":
        segments = [
            [[*scaled(w, p), w] for p, w in zip(piece["points"], piece["weights"])]
            for piece in given["pieces"]
        ]
    else:
        segments = given["segments"]
    degree = len(segments[0]) - 1
    inner = degree - SMOOTHNESS[kind]
    mults = [degree + 1] + [inner] * (len(breaks) - 2) + [degree + 1]
    knots = [u for u, times in zip(breaks, mults) for _ in range(times)]
    poles = []
    for i in range(len(knots) - degree - 1):
        # A segment whose span the pole acts on; the pole is its blossom at the knots inside.
        places = knots[i + 1 : i + degree + 1]
        k = next(k for k in range(len(segments)) if knots[i] <= breaks[k] < knots[i + degree + 1])
        h = breaks[k + 1] - breaks[k]
        poles.append(blossom(segments[k], [Fraction(u - breaks[k]) / h for u in places]))

    def point(t):
        k = max(k for k in range(len(segments)) if breaks[k] <= t)
        found = value(list(segments[k]), Fraction(t - breaks[k]) / (breaks[k + 1] - breaks[k]))
        return [x / found[-1] for x in found[:-1]] if rational else found

    return {
        "degree": degree,
        "poles": [[x / p[-1] for x in p[:-1]] for p in poles] if rational else poles,
        "weights": [p[-1] for p in poles] if rational else None,
        "knots": breaks,
        "mults": mults,
        "samples": [{"point": point(sample["t"])} for sample in case["out"]["samples"]],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
