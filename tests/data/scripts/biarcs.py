#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Biarcs: the joint on its circle through both ends, and the arc from each end to it.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main, real
from plane import Ends, arc_end, arc_through, pair, unit


def parameter(ends, rule):
    alpha, beta = ends.alpha, ends.beta
    return {
        "equal_chord": mpf(1) / 2,
        "parallel": beta / (alpha + beta) if alpha + beta else None,
        "min_dr": (3 * beta - alpha) / (2 * (alpha + beta)) if alpha + beta else None,
    }[rule]


def beziers(start, direction, curvature, length):
    """Rational quadratics of equal sweeps of at most 120 degrees."""
    sweep = curvature * length
    count = max(1, int(mp.ceil(abs(sweep) / (2 * mp.pi / 3) - mpf(10) ** -30)))
    curves = []
    for k in range(count):
        first = arc_end(start, direction, curvature, length * k / count)
        last = arc_end(start, direction, curvature, length * (k + 1) / count)
        half = sweep / count / 2
        middle = first + abs(last - first) / (2 * mp.cos(half)) * unit(
            direction + sweep * k / count
        )
        curves.append(
            {"points": [pair(first), pair(middle), pair(last)], "weights": [1, mp.cos(half), 1]}
        )
    return curves


def expected(case):
    given = case["in"]
    ends = Ends(given)
    x = real(given["x"]) if "x" in given else parameter(ends, given["rule"])
    turn = ends.alpha - ends.beta + x * (ends.alpha + ends.beta)
    # The joint is seen from the start under the direction first + turn / 2, from the end under the
    # direction last - (rest of the turn) / 2: two lines meet in it, unless they are parallel.
    total = ends.alpha + ends.beta
    if total == 0:
        joint = ends.start + x * (ends.end - ends.start)
    else:
        u, v = unit(ends.first + turn / 2), unit(ends.last - (total - turn) / 2)
        chord = ends.end - ends.start
        det = u.real * v.imag - u.imag * v.real
        joint = ends.start + (chord.real * v.imag - chord.imag * v.real) / det * u
    k1, s1 = arc_through(ends.start, ends.first, joint)
    k2, s2 = arc_through(joint, ends.first + turn, ends.end)
    return {
        "alpha": ends.alpha,
        "beta": ends.beta,
        "l": ends.chord,
        "x": x,
        "t": turn,
        "joint": pair(joint),
        "joint_angle": ends.first + turn,
        "k1": k1,
        "k2": k2,
        "len1": s1,
        "sweep1": k1 * s1,
        "sweep2": k2 * s2,
        "len2": s2,
        "convex": bool(k1 * k2 > 0),
        "bezier": [
            *beziers(ends.start, ends.first, k1, s1),
            *beziers(joint, ends.first + turn, k2, s2),
        ],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
