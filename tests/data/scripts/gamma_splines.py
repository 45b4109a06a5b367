#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gamma-splines: the inner poles of the polygon's edges from lengths of segments and gamma, and
the nu-spline that each of them is.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from g2_splines import direct_spline
from oracle import main


def expected(case):
    given = case["in"]
    d, closed, lengths, gamma = given["d"], given["closed"], given["Delta"], given["gamma"]
    count = len(lengths)

    def length(s):
        return lengths[s % count] if closed or 0 <= s < count else Fraction(0)

    def at(s):
        return gamma[s % count] if closed or 0 < s < count else Fraction(0)

    alpha, omega = [Fraction(0)] * len(d), [Fraction(0)] * len(d)
    for s in range(count):
        before, here, after = at(s) * length(s - 1), length(s), at(s + 1) * length(s + 1)
        e = s if closed else s + 1
        alpha[e] = before / (before + here + after)
        omega[e] = (before + here) / (before + here + after)
    joints = range(1, count + 1) if closed else range(1, count)
    segments, r = direct_spline(
        d, closed, alpha, omega, [length(s - 1) / length(s) for s in joints]
    )
    nu = [
        2 * (1 / length(s - 1) + 1 / length(s)) * (1 / at(s) - 1)
        for s in range(0 if closed else 1, count)
    ]
    return {"alpha": alpha, "omega": omega, "segments": segments, "r": r, "nu": nu}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
