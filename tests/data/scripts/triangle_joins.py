#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bezier triangles and patches that meet with one tangent plane.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction

from oracle import add, cross, dot, elevated, main, minus, scaled, times, total
from rational_surface_joins import edge_fields, first
from tensor_joins import last_difference, lowered


def edge(triangle):
    """Row of the edge, differences along it and out of the triangle; by powers of l2."""
    n = len(triangle) - 1
    row = [triangle[0][n - k] for k in range(n + 1)]
    behind = [triangle[1][n - 1 - k] for k in range(n)]
    along = [minus(b, a) for a, b in zip(row, row[1:])]
    return row, along, minus(row[:-1], behind)


def tri_construct(given):
    row, along, out = edge(given["T1"])
    degree, ratio = int(given["degree0"]), Fraction(len(row) - 1, int(given["degree0"]))
    field = scaled(ratio, total(times(given["alpha"], along), times(given["beta"], out)))
    row0 = elevated(list(row), degree)
    return {"row0": row0, "row1": minus(row0[:-1], elevated(field, degree - 1))}


def tri_construct_same_degree(given):
    row, along, out = edge(given["T1"])
    alpha, beta = given["alpha"], given["beta"]
    defect = add(
        scaled(alpha[-1] - alpha[0], last_difference(along)),
        scaled(beta[-1] - beta[0], last_difference(out)),
    )
    found = {"defect": defect, "representable": not any(defect)}
    if found["representable"]:
        field = total(times(alpha, along), times(beta, out))
        while len(field) > len(along):
            field = lowered(field)
        found["row1"] = minus(row[:-1], elevated(field, len(along) - 1))
    return found


def tensor_from_tri(given):
    t, m = given["T"], int(given["m"])
    n = len(t) - 1
    out = minus(t[0][1:], t[1])
    along = minus(t[0][:-1], t[0][1:])
    field = scaled(Fraction(n, m), total(times(given["alpha"], out), times(given["beta"], along)))
    return {"P_row_m": t[0], "P_row_m1": minus(t[0], elevated(field, n))}


def tri_from_tensor(given):
    p, p_s, _ = edge_fields(given["P"])
    degree = int(given["tri_degree"])
    field = elevated(first(p, p_s, given["alpha_bar"], given["beta_bar"]), degree - 1)
    row = elevated(list(p), degree)
    return {"T0": row, "T1": minus(row[1:], scaled(Fraction(1, degree), field))}


def tri_test(given):
    _, along, out0 = edge(given["T0"])
    _, _, out1 = edge(given["T1"])
    coefficients = times(times(out0, along, cross), out1, dot)
    return {"triple_coeffs": coefficients, "degree": len(coefficients) - 1}


KINDS = {
    "tri_construct": tri_construct,
    "tri_construct_same_degree": tri_construct_same_degree,
    "tensor_from_tri": tensor_from_tri,
    "tri_from_tensor": tri_from_tensor,
    "tri_test": tri_test,
}


def expected(case):
    found = KINDS[case["kind"]](case["input"])
    return {key: value for key, value in found.items() if key in case["expected"]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
