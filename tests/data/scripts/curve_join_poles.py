#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first poles of a curve that continues another one: its derivatives are those of the other
one by the matrix of beta; homogeneous ones are also multiplied by a function with derivatives e.

Source: docs/theory/curves.md.
"""

import sys
from math import comb

from oracle import add, applied, bell, first_poles, jet, main, scaled


def expected(case):
    given = case["in"]
    n, rational = int(given["n"]), given["kind"] == "rational"
    poles = given["left"]
    if rational:
        poles = [[*scaled(w, p), w] for p, w in zip(poles, given["left_weights"])]
    left = [scaled(given["h1"] ** -k, d) for k, d in enumerate(jet(poles, 1, n))]
    right = applied(bell(given["beta"]), left)
    if rational:
        e = given["e"]
        right = [
            add(*(scaled(comb(k, j) * e[k - j], right[j]) for j in range(k + 1)))
            for k in range(n + 1)
        ]
    local = [scaled(given["h2"] ** k, d) for k, d in enumerate(right)]
    return {"Q_homogeneous" if rational else "Q": first_poles(local, int(given["right_degree"]))}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
