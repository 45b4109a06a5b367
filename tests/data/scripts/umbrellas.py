#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches around a vertex: alpha and beta from the tangents of the spokes, twists by the
recursion around the vertex, and the nets of members from one free field at each spoke.

Source: docs/theory/surfaces.md.
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
    main,
    minus,
    norm,
    real,
    scaled,
    solve,
    times,
    total,
)
from tensor_joins import lowered

SURE = 18  # digits: the file has 20


def ratios(before, here, after, area):
    """The alpha and beta of after = alpha here + beta before."""
    return area(before, after) / area(before, here), -area(here, after) / area(before, here)


def alpha_beta(given):
    r = given["r"]
    m = len(r)

    def area(a, b):
        return a[0] * b[1] - a[1] * b[0]

    areas = [area(r[i - 1], r[i]) for i in range(m)]
    angles = [mp.atan2(real(areas[i]), real(dot(r[i - 1], r[i]))) for i in range(m)]
    valid = all(a > 0 for a in areas) and abs(sum(angles) - 2 * mp.pi) < 1e-9
    pairs = [ratios(r[i - 1], r[i], r[(i + 1) % m], area) for i in range(m)] if valid else []
    return {
        "valid": valid,
        "sector_area": areas,
        "alpha": [a for a, _ in pairs],
        "beta": [b for _, b in pairs],
    }


def area_over(n):
    return lambda a, b: dot(n, cross(a, b))


def even_project(given):
    """The normal parts of the second derivatives are projected, and the slopes lambda change as
    little as possible, so that the recursion closes."""
    r, q, lam, mu = given["r"], given["Q02"], given["lam"], given["mu"]
    m = len(r)
    n = scaled(1 / norm(given["normal"]), given["normal"])
    area = area_over(n)
    areas = [area(r[i - 1], r[i]) for i in range(m)]
    pairs = [ratios(r[i - 1], r[i], r[(i + 1) % m], area) for i in range(m)]
    signs = [(-1) ** i for i in range(m)]
    g = [pairs[i][0] / areas[(i + 1) % m] for i in range(m)]
    rest = add(
        *(
            scaled(
                signs[i] / areas[(i + 1) % m],
                add(scaled(pairs[i][0], q[i]), scaled(lam[i], r[i]), scaled(mu[i], r[i - 1])),
            )
            for i in range(m)
        )
    )
    size = sum(x * x for x in g)
    high = dot(n, rest)
    if size:
        q = [minus(q[i], scaled(signs[i] * g[i] * high / size, n)) for i in range(m)]
    flat = minus(rest, scaled(high, n))
    # Two equations, by their parts along r_0 and r_1.
    columns = [scaled(signs[i] / areas[(i + 1) % m], r[i]) for i in range(m)]
    rows = [[dot(axis, c) for c in columns] for axis in r[:2]]
    gram = [[dot(a, b) for b in rows] for a in rows]
    forces = solve(gram, [[-dot(axis, flat)] for axis in r[:2]])
    lam = [x + sum(f * row[i] for (f,), row in zip(forces, rows)) for i, x in enumerate(lam)]
    twists = [given["twist0"]]
    for i in range(m - 1):
        twists.append(next_twist(pairs[i], q[i], lam[i], mu[i], r[i], r[i - 1], twists[-1]))
    return {
        "alpha": [a for a, _ in pairs],
        "beta": [b for _, b in pairs],
        "Q02_projected": q,
        "lam_corrected": lam,
        "twists": twists,
    }


def next_twist(pair, q, lam, mu, here, before, twist):
    return add(scaled(pair[0], q), scaled(pair[1], twist), scaled(lam, here), scaled(mu, before))


class Fan:
    """Member i lies between the curves around[i] and around[i + 1]; seam i is its second one."""

    def __init__(self, given, closed):
        self.given, self.closed = given, closed
        self.curves = [list(c) for c in given["curves"]]
        self.members = len(given["kinds"])
        self.seams = self.members if closed else self.members - 1
        self.lam = given["lam"]
        self.mu = given.get("mu") or [Fraction(0)] * self.seams
        r = self.tangents()
        normal = cross(r[0], r[1])
        self.pairs = [
            ratios(self.first(i - 1), self.first(i), self.first(i + 1), area_over(normal))
            for i in range(self.seams)
        ]
        self.areas = [
            dot(normal, cross(self.first(i - 1), self.first(i))) for i in range(self.members)
        ]
        self.solved = self.close() if "solve_C2_index" in given else None
        self.twists = self.all_twists()

    def tangents(self):
        return [scaled(len(c) - 1, minus(c[1], c[0])) for c in self.curves]

    def curve(self, i):
        """The curve of seam i; -1 is the first edge of member 0."""
        return self.curves[i % self.members if self.closed else i + 1]

    def first(self, i):
        c = self.curve(i)
        return scaled(len(c) - 1, minus(c[1], c[0]))

    def second(self, i):
        c = self.curve(i)
        d = len(c) - 1
        return scaled(d * (d - 1), add(c[2], scaled(-2, c[1]), c[0]))

    def forced(self, i, q):
        """What the recursion adds at seam i, over the area of the next sector."""
        inside = next_twist(
            (self.pairs[i][0], 0), q, self.lam[i], self.mu[i], self.first(i), self.first(i - 1), q
        )
        return scaled(1 / self.areas[(i + 1) % self.members], inside)

    def close(self):
        """The second derivative of one curve for which an even number of twists closes."""
        k = int(self.given["solve_C2_index"])
        rest = add(
            *(
                scaled((-1) ** i, self.forced(i, scaled(i != k, self.second(i))))
                for i in range(self.seams)
            )
        )
        factor = (-1) ** (k + 1) * self.areas[(k + 1) % self.members] / self.pairs[k][0]
        c = self.curves[k]
        d = len(c) - 1
        bend = scaled(factor / (d * (d - 1)), rest)
        c[2] = add(bend, scaled(2, c[1]), scaled(-1, c[0]))
        return c[2]

    def all_twists(self):
        if "twist0" in self.given:
            twist = self.given["twist0"]
        else:  # odd: half the alternating sum
            total_ = add(
                *(scaled((-1) ** i, self.forced(i, self.second(i))) for i in range(self.seams))
            )
            twist = scaled(self.areas[0] / 2, total_)
        twists = [twist]
        for i in range(self.members - 1):
            twists.append(
                next_twist(
                    self.pairs[i],
                    self.second(i),
                    self.lam[i],
                    self.mu[i],
                    self.first(i),
                    self.first(i - 1),
                    twists[-1],
                )
            )
        return twists

    def fields(self, i):
        """U of member i and V of member i + 1 along seam i."""
        master = self.given["master"][i]
        degree = int(master["degree"])
        start, slope = self.first(i - 1), self.twists[i]
        if master["side"] == "V":
            start, slope = self.first(i + 1), self.twists[(i + 1) % self.members]
        free = [start, add(start, scaled(Fraction(1, degree), slope)), *master["vec_index2plus"]]
        alpha, beta = self.pairs[i]
        along = times([alpha, alpha + self.lam[i]], derivative(self.curve(i)))
        if master["side"] == "V":
            return scaled(1 / beta, total(free, scaled(-1, along))), free
        return free, total(along, times([beta, beta + self.mu[i]], free))

    def nets(self):
        given, degree = self.given, int(self.given["degree"])
        nets = []
        for i, kind in enumerate(given["kinds"]):
            triangle = kind != "tensor"
            net = [[None] * (degree + 1 - (r if triangle else 0)) for r in range(degree + 1)]
            net[0] = elevated(list(self.curve(i)), degree)
            for r, p in enumerate(elevated(list(self.curve(i - 1)), degree)):
                net[r][0] = p
            share = Fraction(1, degree * (degree - 1 if triangle else degree))
            net[1][1] = add(
                scaled(share, self.twists[i]), net[1][0], net[0][1], scaled(-1, net[0][0])
            )
            nets.append(net)
        for i in range(self.seams):
            before, after = self.fields(i)
            for field, k, by_u in ((before, i, True), (after, (i + 1) % self.members, False)):
                top = degree - (given["kinds"][k] != "tensor")
                while len(field) - 1 > top:
                    field = lowered(field)
                field = elevated(list(field), top)
                for s in range(2, top + 1):
                    move = scaled(Fraction(1, degree), field[s])
                    if by_u:
                        nets[k][1][s] = add(nets[k][0][s], move)
                    else:
                        nets[k][s][1] = add(nets[k][s][0], move)
        for i, r, s, *p in given["free_points"]:
            nets[int(i)][int(r)][int(s)] = p
        return nets


def umbrella(given):
    fan = Fan(given, closed=True)
    found = {
        "alpha": [a for a, _ in fan.pairs],
        "beta": [b for _, b in fan.pairs],
        "twists": fan.twists,
        "nets": fan.nets(),
    }
    return {**found, "C2_solved": fan.solved} if fan.solved else found


def open_fan(given):
    fan = Fan(given, closed=False)
    return {
        "alpha": [a for a, _ in fan.pairs],
        "beta": [b for _, b in fan.pairs],
        "twists": fan.twists,
        "nets": fan.nets(),
    }


KINDS = {
    "alpha_beta": alpha_beta,
    "even_project": even_project,
    "umbrella": umbrella,
    "open_fan": open_fan,
}


def expected(case):
    found = KINDS[case["kind"]](case["input"])
    return {key: value for key, value in found.items() if key in case["expected"]}


if __name__ == "__main__":
    sys.exit(main(__file__, expected, SURE))
