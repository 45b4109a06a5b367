#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Theorems on spirals, on clothoids: Vogt, Kneser and the bilens.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpc

from oracle import main, real
from plane import pair, wrapped


def expected(case):
    given = case["in"]
    theta0, k0, gamma, length = (real(given[key]) for key in ("theta0", "k0", "gamma", "L"))

    def direction(s):
        return theta0 + k0 * s + gamma * s**2 / 2

    def point(s):
        return mp.quad(lambda u: mp.expj(direction(u)), [0, s / 2, s])

    end, k1 = point(length), k0 + gamma * length
    chord = mp.arg(end)
    a, b = wrapped(theta0 - chord), wrapped(direction(length) - chord)
    middle = point(length / 2)
    found = {
        "chord": pair(end),
        "a": a,
        "b": b,
        "k1": k1,
        "vogt": int(mp.sign(a + b)),
        "subtended": wrapped(mp.arg(end - middle) - mp.arg(middle)),
        "bilens_lo": min(-a, b),
        "bilens_hi": max(-a, b),
    }
    if "c0" in case["out"]:
        c0 = mpc(0, 1) * mp.expj(theta0) / k0
        c1 = end + mpc(0, 1) * mp.expj(direction(length)) / k1
        found |= {
            "c0": pair(c0),
            "c1": pair(c1),
            "r0": 1 / abs(k0),
            "r1": 1 / abs(k1),
            "centre_distance": abs(c0 - c1),
            "nested": bool(abs(c0 - c1) < abs(1 / abs(k0) - 1 / abs(k1))),
        }
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
