#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first poles of a rational curve that continues another one: homogeneous derivatives that
agree after a change of parameter and multiplication by a function. And what they join: the
tangent, the curvature, its change and the torsion at the end of the given curve.

Source: docs/theory/curves.md.
"""

import sys
from math import comb

from oracle import (
    add,
    bell,
    cross,
    divided,
    dot,
    first_poles,
    jet,
    main,
    norm,
    real,
    scaled,
    solve,
)


def expected(case):
    given = case["input"]
    n, e = int(given["order"]), given["e"]
    ends = jet(given["Q_hom"], 1, 3)
    scaled_ends = [
        add(*(scaled(comb(k, j) * e[k - j], ends[j]) for j in range(k + 1))) for k in range(n + 1)
    ]
    derivatives = solve(bell(given["dt"]), scaled_ends)
    _, d1, d2, d3 = ([real(x) for x in d] for d in divided(ends))
    speed, c = norm(d1), cross(d1, d2)
    change = dot(c, cross(d1, d3)) / norm(c) * speed**2 - 3 * norm(c) * dot(d1, d2)
    return {
        "control_points_hom": first_poles(derivatives, int(given["degree_bar"])),
        "tangent": scaled(1 / speed, d1),
        "curvature": norm(c) / speed**3,
        "dcurvature_ds": change / speed**6,
        "torsion": dot(c, d3) / dot(c, c),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
