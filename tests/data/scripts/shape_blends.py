#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of two joints of polynomial curves that stay G^n: ratios of the joint, auxiliary points
from both sides, the points blended and cut down.

Source: docs/theory/curves.md.
"""

import sys
from math import comb, factorial

from oracle import add, bell, main, minus, norm, real, scaled


def falling(m, k):
    return factorial(m) // factorial(m - k)


def relations(beta, m, mb):
    """Of level k: the coefficient of each pole -k..k, by its number."""
    b, rows = bell(beta), []
    for k in range(1, len(beta) + 1):
        row = {j: 0 for j in range(-k, k + 1)}
        for j in range(k + 1):
            row[j] += falling(mb, k) * (-1) ** (k - j) * comb(k, j)
        for order in range(1, k + 1):
            for j in range(order + 1):
                row[-j] -= falling(m, order) * (-1) ** j * comb(order, j) * b[k][order]
        rows.append(row)
    return rows


def ratios(beta, m, mb):
    """delta of the levels 0..n-1."""
    delta = []
    for k, g in enumerate(relations(beta, m, mb), 1):
        a = [g[0]]
        for level in range(1, k):
            d = delta[level - 1]
            inner = [d[j - 1] * a[j - 1] + (1 - d[j]) * a[j] for j in range(1, level)]
            a = [
                g[-level] + (1 - d[0]) * a[0],
                *inner,
                d[level - 1] * a[level - 1] + g[level],
            ]
        row = [1 + g[-k] / a[0]]
        for j in range(1, k):
            row.append(1 + row[j - 1] * a[j - 1] / a[j])
        delta.append(row)
    return delta


def auxiliary(delta, poles, middle):
    """The points of level n: those left of the middle from the left, the others from the right."""
    points = [poles[middle]]
    for k, row in enumerate(delta, 1):
        found = [None] * (k + 1)
        found[0], found[k] = poles[middle - k], poles[middle + k]
        for j in range(k // 2):
            rest = minus(points[j], scaled(1 - row[j], found[j]))
            found[j + 1] = scaled(1 / row[j], rest)
        for j in range(k - 1, k // 2, -1):
            rest = minus(points[j], scaled(row[j], found[j + 1]))
            found[j] = scaled(1 / (1 - row[j]), rest)
        points = found
    return points


def mixed(omega, x, y):
    return add(scaled(1 - omega, x), scaled(omega, y))


def blended_beta(frames, middle, omega):
    speeds = [norm(minus(f["P"][middle], f["P"][middle - 1])) for f in frames]
    shares = [real(1 - omega) * speeds[0], real(omega) * speeds[1]]
    first = sum(share * real(f["alpha"][0]) for share, f in zip(shares, frames)) / sum(shares)
    rest = [mixed(omega, x, y) for x, y in zip(frames[0]["alpha"][1:], frames[1]["alpha"][1:])]
    return [first, *map(real, rest)]


def cut(delta, points, poles, middle):
    """The poles with those of numbers -n..n from the points of level n."""
    poles = list(poles)
    for k in range(len(delta), -1, -1):
        poles[middle - k], poles[middle + k] = points[0], points[k]
        if k > 0:
            row = delta[k - 1]
            points = [mixed(row[j], points[j], points[j + 1]) for j in range(k)]
    return poles


def expected(case):
    given = case["in"]
    m, mb, omega, frames = (given[key] for key in ("m", "mb", "omega", "frames"))
    m, mb = int(m), int(mb)
    parts = []
    for frame in frames:
        delta = ratios(frame["alpha"], m, mb)
        parts.append({"delta": delta, "T": auxiliary(delta, frame["P"], m)})
    beta = blended_beta(frames, m, omega)
    delta = ratios(beta, m, mb)
    real_omega = real(omega)
    points = mixed(
        real_omega, *([[real(x) for x in p] for p in part["T"]] for part in parts)
    )
    plain = mixed(real_omega, *([[real(x) for x in p] for p in f["P"]] for f in frames))
    return {
        "frames": parts,
        "alpha_w": beta,
        "delta_w": delta,
        "T_w": points,
        "P_w": cut(delta, points, plain, m),
    }


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
