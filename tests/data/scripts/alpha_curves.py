#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alpha-curves and alpha-surfaces: values by the basis as powers, their quintic form and what it
has for derivatives.

Source: docs/theory/curves.md.
"""

import sys
from fractions import Fraction

from oracle import add, jet, main, minus, scaled


def basis(a, t):
    s = 1 - t
    return [
        s**5 + 5 * (1 - a) * s**4 * t,
        5 * a * s**4 * t + 5 * s**2 * t**2,
        5 * s**2 * t**2 + 5 * a * s * t**4,
        5 * (1 - a) * s * t**4 + t**5,
    ]


def quintic(p, a):
    middle = scaled(Fraction(1, 2), add(p[1], p[2]))
    return [
        p[0],
        add(scaled(1 - a, p[0]), scaled(a, p[1])),
        middle,
        middle,
        add(scaled(a, p[2]), scaled(1 - a, p[3])),
        p[3],
    ]


def at(p, weights):
    return add(*(scaled(w, x) for w, x in zip(weights, p)))


def expected(case):
    given = case["in"]
    p = given["P"]
    if given["kind"] == "surface":
        rows = [quintic(row, given["alpha_v"]) for row in p]
        along = basis(given["alpha_v"], given["v"])
        return {
            "biquintic": quintic(rows, given["alpha_u"]),
            "value": at([at(row, along) for row in p], basis(given["alpha_u"], given["u"])),
        }
    a, t = given["alpha"], given["t"]
    poles = quintic(p, a)
    s = 1 - t
    first, last = minus(p[1], p[0]), minus(p[2], p[3])
    return {
        "quintic": poles,
        "value": at(p, basis(a, t)),
        "d0": jet(poles, 0, 3)[1:],
        "d1": jet(poles, 1, 3)[1:],
        "dr_dalpha": scaled(5 * s * t, add(scaled(s**3, first), scaled(t**3, last))),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
