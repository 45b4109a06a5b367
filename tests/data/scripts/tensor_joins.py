#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches that meet with one tangent plane: rows from alpha and beta, the coefficients of the
determinants that vanish there, and alpha and beta from the patches.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction
from math import comb

from oracle import (
    add,
    cross,
    det,
    derivative,
    dot,
    elevated,
    main,
    minus,
    norm,
    scaled,
    solve,
    times,
    total,
)
from rational_surface_joins import edge_fields, first, rows_of


def lowered(f):
    """The polynomial with one degree less, if it has it."""
    n, found = len(f) - 1, [f[0]]
    for k in range(1, n):
        share = Fraction(k, n)
        found.append(scaled(1 / (1 - share), minus(f[k], scaled(share, found[-1]))))
    return found


def last_difference(f):
    """The difference of the order that is the degree."""
    while len(f) > 1:
        f = [minus(b, a) for a, b in zip(f, f[1:])]
    return f[0]


def construct(given):
    net = given.get("P", given.get("P_hom"))
    p, p_s, _ = edge_fields(net)
    q_u = first(p, p_s, given["alpha"], given["beta"])
    if "gamma" in given:
        q_u = total(q_u, times(given["gamma"], p))
    degree, rows = rows_of([p, q_u], given["l"])
    return {"along_degree": degree, "Q_row0": rows[0], "Q_row1": rows[1]}


def construct_same_degree(given):
    p, p_s, _ = edge_fields(given["P"])
    alpha, q = given["alpha"], int(given["q"])
    difference = last_difference(minus(given["P"][-1], given["P"][-2]))
    defect = scaled(alpha[-1] - alpha[0], difference)
    found = {"defect": defect, "representable": not any(defect)}
    if found["representable"]:
        q_u = first(p, p_s, alpha, given["beta"])
        while len(q_u) - 1 > q:
            q_u = lowered(q_u)
        found["Q_row1"] = add(elevated(list(p), q), scaled(1 / given["l"], elevated(q_u, q)))
    return found


def tangent_plane(given):
    p, q = given["P"], given["Q"]
    inward = minus(p[-1], p[-2])
    along = [minus(b, a) for a, b in zip(p[-1], p[-1][1:])]
    return {"triple_coeffs": times(times(inward, along, cross), minus(q[1], q[0]), dot)}


def rational_tangent_plane(given):
    """det[X, Y, R, S], by the binomials."""
    p, s = given["P_hom"], given["Q_hom"][1]
    factors = [p[-1][:-1], p[-1][1:], p[-2], s]
    coefficients = [Fraction(0)] * (sum(len(f) - 1 for f in factors) + 1)

    def collect(chosen, index, weight):
        if len(chosen) == 4:
            coefficients[index] += weight * det([list(row) for row in chosen])
            return
        f = factors[len(chosen)]
        for i, row in enumerate(f):
            collect([*chosen, row], index + i, weight * comb(len(f) - 1, i))

    collect([], 0, 1)
    degree = len(coefficients) - 1
    return {
        "degree": degree,
        "det4_coeffs": [c / comb(degree, k) for k, c in enumerate(coefficients)],
    }


def fit(given):
    """Least squares of the poles of Q_u against those of the terms."""
    p, p_s, _ = edge_fields(given["P"])
    q = given["Q"]
    q_u = scaled(len(q) - 1, minus(q[1], q[0]))
    terms = []
    for degree, field in ((int(given["deg_alpha"]), p_s), (int(given["deg_beta"]), derivative(p))):
        for i in range(degree + 1):
            terms.append(times([Fraction(i == k) for k in range(degree + 1)], field))
    top = max(len(f) for f in [*terms, q_u]) - 1
    flat = [[x for pole in elevated(list(f), top) for x in pole] for f in [*terms, q_u]]
    matrix = [[dot(a, b) for b in flat[:-1]] for a in flat[:-1]]
    found = [x for (x,) in solve(matrix, [[dot(a, flat[-1])] for a in flat[:-1]])]
    split = int(given["deg_alpha"]) + 1
    return {"alpha": found[:split], "beta": found[split:]}


def with_edge(net, edge, last):
    """The net with that edge as its last row, or as its first."""
    if edge[0] == "v":
        net = [list(column) for column in zip(*net)]
    return net if (edge[1] == "1") == last else net[::-1]


def orient(given):
    """The edges as the last row of P and the first of Q, of one direction."""
    p, q = with_edge(given["A"], given["A_edge"], True), with_edge(
        given["B"], given["B_edge"], False
    )
    a, b = p[-1], q[0]
    straight = norm(minus(a[0], b[0])) + norm(minus(a[-1], b[-1]))
    turned = norm(minus(a[0], b[-1])) + norm(minus(a[-1], b[0]))
    if turned < straight:
        q = [row[::-1] for row in q]
    return {"P": p, "Q": q, "B_reversed": bool(turned < straight)}


KINDS = {
    "construct": construct,
    "rational_construct": construct,
    "construct_same_degree": construct_same_degree,
    "test": tangent_plane,
    "rational_test": rational_tangent_plane,
    "fit": fit,
    "orient": orient,
}


def expected(case):
    found = KINDS[case["kind"]](case["input"])
    return {key: value for key, value in found.items() if key in case["expected"]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
