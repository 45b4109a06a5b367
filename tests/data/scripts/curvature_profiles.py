#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The derivative of the curvature of a planar Bezier curve as a Bernstein polynomial; its roots.

Source: docs/theory/planar.md.
"""

import sys

from mpmath import mp, mpf

from oracle import derivative, elevated, main, real, scaled, times, total, value


def roots_inside(f):
    """Simple roots in (0, 1) of a polynomial in Bernstein form, in double the precision."""
    with mp.workdps(120):
        n = len(f) - 1
        nodes = [mpf(k) / n for k in range(n + 1)]
        matrix = mp.matrix([[x**k for k in range(n + 1)] for x in nodes])
        values = mp.matrix([value([real(c) for c in f], x) for x in nodes])
        a = list(mp.lu_solve(matrix, values))
        while a and abs(a[-1]) < mpf(10) ** -80 * max(abs(x) for x in a):
            a.pop()
        roots = mp.polyroots(a[::-1], maxsteps=2000, extraprec=800) if len(a) > 1 else []
        return sorted(
            mp.re(r) for r in roots if abs(mp.im(r)) < mpf(10) ** -40 and 0 < mp.re(r) < 1
        )


def crossed(a, b):
    return total(
        times([p[0] for p in a], [p[1] for p in b]),
        scaled(-1, times([p[1] for p in a], [p[0] for p in b])),
    )


def dotted(a, b):
    return total(
        times([p[0] for p in a], [p[0] for p in b]), times([p[1] for p in a], [p[1] for p in b])
    )


def lowered(f, degree):
    """The coefficients in a lower degree, of a polynomial that has it."""
    while len(f) - 1 > degree:
        n = len(f) - 1
        lower = [f[0]]
        for k in range(1, n):
            lower.append((n * f[k] - k * lower[k - 1]) / (n - k))
        f = lower
    return f


def expected(case):
    poles = [list(p) for p in case["in"]["P"]]
    n = len(poles) - 1
    r1 = derivative(poles)
    r2 = derivative(r1)
    r3 = derivative(r2)
    speed2, turn = dotted(r1, r1), crossed(r1, r2)
    slope = total(
        times(speed2, crossed(r1, r3)), scaled(-3, times(dotted(r1, r2), turn))
    )
    stationary = roots_inside(derivative(speed2)) if len(speed2) > 2 else []
    exact = [real(c) for c in speed2]
    return {
        "speed2": elevated(speed2, 2 * n - 2),
        "min_speed2": min([exact[0], exact[-1], *(value(exact, t) for t in stationary)]),
        "crossb": lowered(turn, 2 * n - 4),
        "N": lowered(slope, 4 * n - 7),
        "extrema": roots_inside(slope),
        "inflections": roots_inside(turn),
        "monotone": not roots_inside(slope),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected, 25))
