#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoids between two ends: Newton's method for the difference of the curvatures, with integrals
by adaptive quadrature.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import main, real
from plane import Ends, pair, unit, wrapped


def root(f0, change, guess):
    """a with integral of sin(a t^2 + (change - a) t + f0) = 0 near the guess."""

    def height(a):
        return mp.quad(lambda t: mp.sin(a * t * t + (change - a) * t + f0), [0, 0.25, 0.5, 0.75, 1])

    return mp.findroot(height, (guess, guess + mpf("0.01")), tol=mpf(10) ** -50)


def expected(case):
    with mp.workdps(45):  # quadrature with more digits takes long
        return computed(case)


def computed(case):
    given, out = case["in"], case["out"]
    ends = Ends(given)
    f0, f1 = -ends.alpha, ends.beta
    change = f1 - f0
    # The file tells which root is meant; it is computed again from five of its digits.
    guess = mp.nint(real(out["A"]) * 10**5) / 10**5
    a = root(f0, change, guess) if abs(f0 + f1) > mpf(10) ** -20 else mpf(0)
    pieces = [0, 0.25, 0.5, 0.75, 1]
    width = mp.quad(lambda t: mp.cos(a * t * t + (change - a) * t + f0), pieces)
    length = ends.chord / width
    k0, gamma = (change - a) / length, 2 * a / length**2

    def end(s):
        return ends.start + mp.quad(
            lambda u: unit(ends.first + k0 * u + gamma * u * u / 2), [s * p for p in pieces]
        )

    def bound(count):
        h = length / count
        largest = max(abs(k0), abs(k0 + gamma * length))
        # The first or the last piece has the largest curvature.
        k = largest
        sixth = k**5 + 10 * k**3 * abs(gamma) + 15 * k * gamma**2
        return sixth * h**6 / 46080

    found = {
        "phi0": wrapped(f0),
        "phi1": wrapped(f1),
        "L": length,
        "k0": k0,
        "k1": k0 + gamma * length,
        "mid": pair(end(length / 2)),
        "bound": bound(int(out["pieces"])),
    }
    if abs(f0 + f1) > mpf(10) ** -20:
        found |= {"A": a, "gamma": gamma}
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected, 20))
