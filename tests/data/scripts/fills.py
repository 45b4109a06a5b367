#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""N-sided fills. Each one listed is one of many: poles that a fill may choose are taken from the
file; those along the outer edges, behind them, and on one side of each spoke follow from the
sides and from the chosen ones. The file has doubles of inputs that had 40 digits.

Source: docs/theory/fills.md.
"""

import sys
from fractions import Fraction

from mpmath import mp
from oracle import (
    add,
    cross,
    derivative,
    dot,
    elevated,
    jet,
    main,
    minus,
    norm,
    real,
    scaled,
    solve,
    times,
    total,
)

SURE = 12  # digits: inputs are rounded to doubles


def halves(f):
    """The left and the right half, by de Casteljau."""
    left, right, row = [], [], list(f)
    while row:
        left.append(row[0])
        right.insert(0, row[-1])
        row = [scaled(Fraction(1, 2), add(a, b)) for a, b in zip(row, row[1:])]
    return left, right


def in_plane(a, b, wanted):
    """x and y with which x a + y b is nearest to what is wanted."""
    matrix = [[dot(a, a), dot(a, b)], [dot(a, b), dot(b, b)]]
    return [x for (x,) in solve(matrix, [[dot(a, wanted)], [dot(b, wanted)]])]


class Hole:
    def __init__(self, case):
        self.edges = [[[real(x) for x in p] for p in e] for e in case["E"]]
        self.crosses = [[[real(x) for x in p] for p in t] for t in case["T"]]
        self.n = len(self.edges)
        self.linear = case.get("mode", 5) == 4
        self.alpha = 2 * mp.cos(2 * mp.pi / self.n)
        n = self.n
        self.first = [
            in_plane(self.crosses[k][0], self.d(k, 0), scaled(0.5, self.d(k - 1, 1)))
            for k in range(n)
        ]
        self.last = [
            in_plane(self.crosses[k][-1], self.d(k, 1), scaled(-0.5, self.d((k + 1) % n, 0)))
            for k in range(n)
        ]
        self.p = [self.factor_of_cross(k) for k in range(n)]
        self.slopes = [self.corner(k) for k in range(n)]

    def d(self, k, t, order=1):
        return jet(self.edges[k], t, order)[order]

    def factor_of_cross(self, k):
        """p on the two halves, linear on each."""
        a, b = self.first[k][0], self.last[k][0]
        middle = (a + b) / (2 - self.alpha) if self.linear else (a + b) / 2
        return [a, middle], [middle, b]

    def mixed(self, k, t):
        """The derivative of p T + q E' along the side, without that of q."""
        p, q = self.last[k] if t else self.first[k]
        half = self.p[k][t]
        slope = 2 * (half[1] - half[0])
        derivative = jet(self.crosses[k], t, 1)
        return add(
            scaled(p, derivative[1]), scaled(slope, derivative[0]), scaled(q, self.d(k, t, 2))
        )

    def corner(self, k):
        """q_k'(0) and q_(k-1)'(1)."""
        wanted = scaled(-1, add(self.mixed(k, 0), self.mixed(k - 1, 1)))
        return in_plane(self.d(k, 0), self.d(k - 1, 1), wanted)

    def twist_defect(self, k):
        n = cross(self.d(k - 1, 1), self.d(k, 0))
        plain = add(self.mixed(k, 0), self.mixed(k - 1, 1))
        defect = dot(plain, n) / norm(n)
        return defect if abs(defect) > 1e-13 else mp.mpf(0)  # what rounded inputs make of none

    def fields(self, k):
        """The cross derivative of the fill on the two halves of a side, out of the hole."""
        law = self.alpha if self.linear else mp.mpf(0)
        start, end = self.first[k][1], self.last[k][1]
        left = start + self.slopes[k][0] / 4
        right = end - self.slopes[(k + 1) % self.n][1] / 4
        middle = 2 * (left + right) / (4 - law)
        factors = ([start, left, middle], [middle, right, end])
        parts = zip(self.p[k], halves(self.crosses[k]), factors, halves(derivative(self.edges[k])))
        return [total(times(p, t), times(q, e)) for p, t, q, e in parts]


def expected(case):
    hole = Hole(case)
    found = {"twist_defects": [hole.twist_defect(k) for k in range(hole.n)]}
    if "patches" not in case:
        return found
    degree = int(case["mode"])
    patches = [[[list(pole) for pole in row] for row in patch] for patch in case["patches"]]
    alpha = hole.alpha
    law = [alpha, mp.mpf(0)] if hole.linear else [alpha, mp.mpf(0), mp.mpf(0)]
    share = mp.mpf(1) / degree
    for k, patch in enumerate(patches):
        right, field = halves(hole.edges[k - 1])[1], hole.fields(k - 1)[1]
        outer = elevated(right, degree)
        behind = minus(outer, scaled(share, elevated(field, degree)))
        left, field = halves(hole.edges[k])[0], hole.fields(k)[0]
        other = elevated(left, degree)[::-1]
        other_behind = minus(other, scaled(share, elevated(field, degree)[::-1]))
        for j in range(degree + 1):
            patch[degree - 1][j] = behind[j]
        for i in range(degree + 1):
            patch[i][degree - 1] = other_behind[i]
        patch[degree] = outer
        for i in range(degree + 1):
            patch[i][degree] = other[i]
    for k, patch in enumerate(case["patches"]):
        # At the spoke Q_k(0, v) = Q_(k+1)(u, 0) the two fields add up to the law times its
        # derivative.
        spoke = patch[0]
        drawn = elevated(times(law, derivative(lower(spoke))), degree)
        next_patch = patches[(k + 1) % hole.n]
        for s in range(degree - 1):
            next_patch[s][0] = spoke[s]
            sum_ = add(scaled(2, spoke[s]), scaled(share, drawn[s]))
            next_patch[s][1] = minus(sum_, patch[1][s])
    found["patches"] = patches
    return found


def lower(spoke):
    """Spokes are quartic, whatever the degree of the patches."""
    f = [[real(x) for x in p] for p in spoke]
    while len(f) > 5:
        n, found = len(f) - 1, [f[0]]
        for k in range(1, n):
            s = mp.mpf(k) / n
            found.append(scaled(1 / (1 - s), minus(f[k], scaled(s, found[-1]))))
        f = found
    return f


if __name__ == "__main__":
    sys.exit(main(__file__, expected, SURE))
