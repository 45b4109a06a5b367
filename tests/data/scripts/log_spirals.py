#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Logarithmic arc splines and spirals: arcs laid end to end, and the spiral in closed form, with
the growth of the radius by bisection and Newton's method.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpc, mpf

from oracle import main, real
from plane import Ends, pair, unit


def increasing_root(f):
    low, high = mpf(-1), mpf(1)
    while f(low) > 0:
        low *= 2
    while f(high) < 0:
        high *= 2
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return mp.findroot(f, (low, high), tol=mpf(10) ** -100)


def spiral(ends, alpha, turn, side):
    def end(growth):
        rate = mpc(growth, 1)
        return (mp.exp(rate * turn) - 1) / rate

    growth = increasing_root(lambda x: mp.arg(end(x)) - alpha)
    return {"lambda": growth, "R0": side * ends.chord / abs(end(growth))}


def arcs(ends, alpha, turn, side, count):
    sweep = turn / count

    def end(x):
        return mp.fsum(mp.exp(x * j) * unit(j * sweep) for j in range(count))

    x = increasing_root(lambda x: mp.arg(end(x)) - (alpha - sweep / 2))
    first = ends.chord / abs(end(x))
    joints = [ends.start]
    for j in range(count):
        chord = first * mp.exp(x * j) * unit(ends.first + side * (j + mpf(1) / 2) * sweep)
        joints.append(joints[-1] + chord)
    return {
        "rho": mp.exp(x),
        "l0": first,
        "R0": side * first / (2 * mp.sin(sweep / 2)),
        "joints": [pair(z) for z in joints],
    }


def expected(case):
    given = case["in"]
    ends = Ends(given)
    side = 1 if ends.alpha > 0 else -1
    alpha, turn = abs(ends.alpha), abs(ends.alpha + ends.beta)
    count = int(given["n"])
    return {
        "alpha": ends.alpha,
        "beta": ends.beta,
        "phi": ends.alpha + ends.beta,
        "feasible": bool(turn / count / 2 < min(alpha, abs(ends.beta))),
        "spiral": spiral(ends, alpha, turn, side),
        "arc": arcs(ends, alpha, turn, side, count),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected, 28))
