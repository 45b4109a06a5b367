#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cubic G2 splines straight from a polygon: on each edge two inner poles, and joints that divide
the legs between two edges by the square root of the product of their ratios.

Source: docs/theory/curves.md.
"""

import sys

from mpmath import mp
from oracle import add, main, real, scaled


def between(a, b, share):
    return add(scaled(1 - share, a), scaled(share, b))


def direct_spline(d, closed, alpha, omega, ratios=None):
    """Segments, and the ratio r of each joint. ratios are r / (1 - r), if they are known."""
    count = len(d)
    edges = list(range(count)) if closed else list(range(1, count - 2))
    x = {e: between(d[e], d[(e + 1) % count], alpha[e]) for e in edges}
    y = {e: between(d[e], d[(e + 1) % count], omega[e]) for e in edges}
    joints, r = {}, []
    for k, e in enumerate(edges if closed else edges[:-1]):
        f = edges[(k + 1) % len(edges)]
        if ratios:
            root = ratios[k]
        else:
            before = (omega[e] - alpha[e]) / (1 - omega[e])
            root = mp.sqrt(real(before * alpha[f] / (omega[f] - alpha[f])))
        r.append(root / (1 + root))
        joints[e] = between(y[e], x[f], r[-1])
    segments = []
    for k, e in enumerate(edges):
        first = joints[edges[k - 1]] if closed or k else d[0]
        last = joints[e] if e in joints else d[-1]
        segments.append([first, x[e], y[e], last])
    return segments, r


def expected(case):
    given = case["in"]
    segments, r = direct_spline(given["d"], given["closed"], given["alpha"], given["omega"])
    return {"segments": segments, "r": r}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
