#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams and vertices whose patches all move as little as possible to meet with one tangent plane,
and a seam of B-splines.

Source: docs/theory/surfaces.md.
"""

import sys
from fractions import Fraction

from least_moves import least_move, point
from oracle import add, derivative, main, minus, scaled, times, total

SURE = 21  # digits: the file has 23 and less where its system is singular


def at_seam(given):
    """Poles behind the seam, on it and beyond it, by name; and the same as forms."""
    rows = {"P_row_m1": given["P"][-2], "seam": given["P"][-1], "Q_row1": given["Q"][1]}
    points = {(key, j): p for key, row in rows.items() for j, p in enumerate(row)}
    forms = {key: [point((key, j)) for j in range(len(row))] for key, row in rows.items()}
    out = scaled(len(given["P"]) - 1, minus(forms["seam"], forms["P_row_m1"]))
    into = scaled(len(given["Q"]) - 1, minus(forms["Q_row1"], forms["seam"]))
    return points, out, into, derivative(forms["seam"])


def rows_of(points):
    found = {}
    for (key, _), p in points.items():
        found.setdefault(key, []).append(p)
    return found


def symmetric_g1(given):
    points, out, into, along = at_seam(given)
    law = minus_all(into, times(given["alpha"], out), times(given["beta"], along))
    weights = {name: int(given["weights"][name[0]]) for name in points}
    return rows_of(least_move(points, law, weights)[0])


def minus_all(first, *rest):
    return total(first, *(scaled(-1, f) for f in rest))


def seam_area_law(given):
    """c V + d U = e C' with the fields V and U into the patches."""
    points, out, into, along = at_seam(given)
    law = minus_all(times(given["c"], into), times(given["d"], out), times(given["e"], along))
    moved, _ = least_move(points, law)
    return {**rows_of(moved), "equations": len(law)}


def around(given):
    """Names of the poles of each member, those of a seam and of the vertex shared; and the fields
    of each seam: V of the member after it, U of the one before, the derivative along it."""
    nets = given["nets"]
    count, degree = len(nets), len(nets[0]) - 1

    def name(i, r, s):
        i %= count
        if r == 0:
            return ("seam", i, s) if s else "vertex"
        return (i, r, s) if s else ("seam", (i - 1) % count, r)

    points = {
        name(i, r, s): p
        for i, net in enumerate(nets)
        for r, row in enumerate(net)
        for s, p in enumerate(row)
    }
    fields = []
    for i in range(count):
        seam = [point(name(i, 0, s)) for s in range(degree + 1)]
        before = [point(name(i, 1, s)) for s in range(degree + 1)]
        after = [point(name(i + 1, r, 1)) for r in range(degree + 1)]
        fields.append(
            (
                scaled(degree, minus(after, seam)),
                scaled(degree, minus(before, seam)),
                derivative(seam),
            )
        )
    return name, points, fields


def moved_nets(given, name, points, conditions):
    moved, rank = least_move(points, conditions)
    nets = [
        [[moved[name(i, r, s)] for s in range(len(row))] for r, row in enumerate(net)]
        for i, net in enumerate(given["nets"])
    ]
    return {
        "nets": nets,
        "constraints": len(conditions),
        "rank": rank,
        "unknown_points": len(points),
    }


def network(given):
    name, points, fields = around(given)
    conditions = []
    for (after, before, along), a, b in zip(fields, given["a"], given["b"]):
        conditions += minus_all(after, times(a, along), times(b, before))
    return moved_nets(given, name, points, conditions)


def network_area_law(given):
    name, points, fields = around(given)
    conditions = []
    for (after, before, along), law in zip(fields, given["law"]):
        conditions += total(
            times(law["c"], after), times(law["d"], before), scaled(-1, times(law["e"], along))
        )
    return moved_nets(given, name, points, conditions)


def span_blossom(poles, knots, degree, span, places):
    """De Boor's algorithm on the span [knots[span], knots[span + 1]], a place for each step."""
    d = [poles[j] for j in range(span - degree, span + 1)]
    for r, t in enumerate(places, 1):
        steps = []
        for k, j in enumerate(range(span - degree + r, span + 1)):
            low, high = knots[j], knots[j + degree + 1 - r]
            share = Fraction(t - low) / (high - low)
            steps.append(add(scaled(1 - share, d[k]), scaled(share, d[k + 1])))
        d = steps
    return d[0]


def bspline_g1(given):
    """Q_u = alpha P_s + beta P_t span by span; its poles are blossoms at knots of one multiplicity
    more."""
    degree, knots, across = int(given["t_degree"]), given["t_knots"], given["l"]
    inner = sorted({t for t in knots if knots[0] < t < knots[-1]})
    refined = sorted([*knots, *inner])
    seam, behind = given["P"][-1], given["P"][-2]
    spans = [k for k in range(len(knots) - 1) if knots[k] < knots[k + 1]]

    def bezier(poles, span):
        a, b = knots[span], knots[span + 1]
        return [
            span_blossom(poles, knots, degree, span, [a] * (degree - j) + [b] * j)
            for j in range(degree + 1)
        ]

    pieces = {}
    for span in spans:
        h = knots[span + 1] - knots[span]
        c, back = bezier(seam, span), bezier(behind, span)
        out, along = scaled(given["m"], minus(c, back)), scaled(1 / h, derivative(c))
        into = total(times(given["alpha"], out), times(given["beta"], along))
        pieces[span] = c, add(c, scaled(1 / across, into))

    rows = [[], []]
    for i in range(len(refined) - degree - 1):
        places = refined[i + 1 : i + degree + 1]
        span = next(k for k in spans if refined[i] <= knots[k] < refined[i + degree + 1])
        a, h = knots[span], knots[span + 1] - knots[span]
        for row, poles in zip(rows, pieces[span]):
            for t in places:
                share = Fraction(t - a) / h
                poles = [
                    add(scaled(1 - share, x), scaled(share, y)) for x, y in zip(poles, poles[1:])
                ]
            row.append(poles[0])
    return {"t_knots_Q": refined, "row0": rows[0], "row1": rows[1]}


KINDS = {
    "symmetric_g1": symmetric_g1,
    "seam_area_law": seam_area_law,
    "network": network,
    "network_area_law": network_area_law,
    "bspline_g1": bspline_g1,
}


def expected(case):
    return KINDS[case["kind"]](case["input"])


if __name__ == "__main__":
    sys.exit(main(__file__, expected, SURE))
