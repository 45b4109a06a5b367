#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Bezier triangle as one patch with a collapsed edge, and as three regular patches: blossoms at
the corners of the quadrilaterals into which the middles of its edges divide it.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction
from math import comb

from oracle import add, elevated, main, scaled


def blossom(triangle, places):
    """Of the net T[i][j] at barycentric places (l0, l1, l2)."""
    for l0, l1, l2 in places:
        triangle = [
            [
                add(
                    scaled(l0, triangle[i + 1][j]),
                    scaled(l1, triangle[i][j + 1]),
                    scaled(l2, triangle[i][j]),
                )
                for j in range(len(triangle[i]) - 1)
            ]
            for i in range(len(triangle) - 1)
        ]
    return triangle[0][0]


def quad(triangle, a, b, c):
    """The patch at the vertex a; its edges run to the middles of ab and ac."""
    n = len(triangle) - 1
    corners = [
        a,
        scaled(Fraction(1, 2), add(a, b)),
        scaled(Fraction(1, 2), add(a, c)),
        scaled(Fraction(1, 3), add(a, b, c)),
    ]

    def pole(i, j):
        terms = []
        for d in range(max(0, i + j - n), min(i, j) + 1):
            times = [n - i - j + d, i - d, j - d, d]
            places = [corner for corner, count in zip(corners, times) for _ in range(count)]
            share = Fraction(comb(i, d) * comb(n - i, j - d), comb(n, j))
            terms.append(scaled(share, blossom(triangle, places)))
        return add(*terms)

    return [[pole(i, j) for j in range(n + 1)] for i in range(n + 1)]


def expected(case):
    triangle = case["input"]["T"]
    n = len(triangle) - 1
    vertices = [[Fraction(i == k) for k in range(3)] for i in range(3)]
    return {
        "degenerate": [
            elevated([triangle[n - r][r - c] for c in range(r + 1)], n) for r in range(n + 1)
        ],
        "quads": [quad(triangle, *(vertices[(k + i) % 3] for i in range(3))) for k in range(3)],
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
