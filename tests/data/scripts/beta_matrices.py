#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Matrices of derivatives under a change of parameter, and their inverses.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from oracle import bell, main, solve


def expected(case):
    b = bell(case["in"]["beta"])
    unit = [[Fraction(i == j) for j in range(len(b))] for i in range(len(b))]
    inverse = solve(b, unit)
    return {"B": b, "Binv": inverse, "beta_inv": [row[1] for row in inverse[1:]]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
