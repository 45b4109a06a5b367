#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The alpha of least energy: integrals of products of the k-th derivatives of f and g, where the
alpha-curve is f + alpha g.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from alpha_curves import quintic
from oracle import derivative, dot, main, minus, times


def integral(f, g):
    """Of f . g over [0, 1]: the mean of the product's Bernstein coefficients."""
    product = times(f, g, dot)
    return sum(product) / len(product)


def expected(case):
    p = case["in"]["P"]
    f = quintic(p, Fraction(0))
    g = minus(quintic(p, Fraction(1)), f)
    found = {}
    for k in (1, 2, 3):
        f, g = derivative(f), derivative(g)
        fg, gg, ff = integral(f, g), integral(g, g), integral(f, f)
        raw = -fg / gg
        alpha = min(max(raw, Fraction(0)), Fraction(1))
        energy = ff + 2 * alpha * fg + alpha**2 * gg
        found[str(k)] = {"fg": fg, "gg": gg, "alpha_raw": raw, "alpha": alpha, "E": energy}
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
