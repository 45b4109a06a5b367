#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a rational patch that continues another one across its edge u = 1: the derivatives of
e(u, t) P(s(u, t), tau(u, t)), with s = alpha u + p u^2 / 2 and tau = t + beta u + q u^2 / 2.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction

from oracle import add, derivative, elevated, main, minus, scaled, times, total


def edge_fields(net):
    """P, P_s, P_ss at s = 1 as polynomials of t."""
    m = len(net) - 1
    p, p_s = net[m], scaled(m, minus(net[m], net[m - 1]))
    if m == 1:
        return p, p_s, scaled(0, p)
    second = add(net[m], scaled(-2, net[m - 1]), net[m - 2])
    return p, p_s, scaled(m * (m - 1), second)


def first(p, p_s, alpha, beta):
    return total(times(alpha, p_s), times(beta, derivative(p)))


def second(p, p_s, p_ss, alpha, beta, along_s, along_t):
    p_t, p_st = derivative(p), derivative(p_s)
    return total(
        times(times(alpha, alpha), p_ss),
        times(scaled(2, times(alpha, beta)), p_st),
        times(times(beta, beta), derivative(p_t)),
        times(along_s, p_s),
        times(along_t, p_t),
    )


def rows_of(fields, across):
    """The first rows of a patch of the degree across with these derivatives."""
    degree = max(len(f) for f in fields) - 1
    fields = [elevated(list(f), degree) for f in fields]
    rows = [fields[0], add(fields[0], scaled(Fraction(1, int(across)), fields[1]))]
    if len(fields) > 2:
        bend = scaled(Fraction(1, int(across * (across - 1))), fields[2])
        rows.append(add(scaled(2, rows[1]), scaled(-1, rows[0]), bend))
    return degree, rows


def expected(case):
    given = case["input"]
    p, p_s, p_ss = edge_fields(given["P_hom"])
    e0, e1, e2, alpha, beta = (given[key] for key in ("e0", "e1", "e2", "alpha", "beta"))
    y1 = first(p, p_s, alpha, beta)
    fields = [times(e0, p), total(times(e1, p), times(e0, y1))]
    if given["order"] > 1:
        y2 = second(p, p_s, p_ss, alpha, beta, given["p"], given["q"])
        fields.append(total(times(e2, p), scaled(2, times(e1, y1)), times(e0, y2)))
    degree, rows = rows_of(fields, given["l"])
    return {"along_degree": degree, "rows_hom": rows}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
