#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Angle, normal curvature across the seam, the difference of the curvature tensors and the change
of curvature, of patches that meet along u = 1 and u = 0.

Source: docs/theory/surfaces.md.
"""

import sys

from mpmath import mp
from oracle import add, cross, derivative, dot, main, minus, norm, real, scaled, value


def jet(net, s, t, order):
    """Derivatives X[i][j] = d^(i+j) X / ds^i dt^j up to the order."""
    rows, found = net, []
    for i in range(order + 1):
        columns = value(list(rows), s)
        found.append([])
        for _ in range(order + 1 - i):
            found[i].append([real(x) for x in value(list(columns), t)])
            columns = derivative(columns)
        rows = derivative(rows)
    return found


def normal(x):
    n = cross(x[1][0], x[0][1])
    return scaled(1 / norm(n), n)


def direction(x, wanted):
    """The parameter direction whose image is the part of a vector in the tangent plane."""
    e, f, g = dot(x[1][0], x[1][0]), dot(x[1][0], x[0][1]), dot(x[0][1], x[0][1])
    a, b = dot(x[1][0], wanted), dot(x[0][1], wanted)
    w = e * g - f * f
    return (g * a - f * b) / w, (e * b - f * a) / w


def second(x, a, b):
    """The second derivative, as a bilinear map of parameter directions."""
    return add(
        scaled(a[0] * b[0], x[2][0]),
        scaled(a[0] * b[1] + a[1] * b[0], x[1][1]),
        scaled(a[1] * b[1], x[0][2]),
    )


def third(x, a):
    return add(
        scaled(a[0] ** 3, x[3][0]),
        scaled(3 * a[0] ** 2 * a[1], x[2][1]),
        scaled(3 * a[0] * a[1] ** 2, x[1][2]),
        scaled(a[1] ** 3, x[0][3]),
    )


def tensor(x, n, tangent, across):
    """Entries (T, T), (T, B), (B, B) of the second fundamental form."""
    t, b = direction(x, tangent), direction(x, across)
    return [dot(n, second(x, *pair)) for pair in ((t, t), (t, b), (b, b))]


def spectral_norm(xx, xy, yy):
    mean, half = (xx + yy) / 2, mp.sqrt(((xx - yy) / 2) ** 2 + xy**2)
    return max(abs(mean + half), abs(mean - half))


def change(x, n, across):
    """How the curvature of the normal section along across changes by arc length."""
    v = direction(x, across)
    bend = second(x, v, v)
    w = direction(x, scaled(-1, minus(bend, scaled(dot(bend, n), n))))
    return dot(n, add(third(x, v), scaled(3, second(x, v, w))))


def expected(case):
    given, samples = case["input"], []
    for sample in case["expected"]["samples"]:
        t = sample["t"]
        p, q = jet(given["P"], 1, t, 3), jet(given["Q"], 0, t, 3)
        n, m = normal(p), normal(q)
        tangent = scaled(1 / norm(p[0][1]), p[0][1])
        across, other = cross(n, tangent), cross(m, tangent)
        before, after = tensor(p, n, tangent, across), tensor(q, m, tangent, other)
        samples.append(
            {
                "angle": mp.atan2(norm(cross(n, m)), dot(n, m)),
                "kappa_perp_P": before[2],
                "delta_kappa_perp": after[2] - before[2],
                "spectral": spectral_norm(*minus(after, before)),
                "delta_fbbb": change(q, m, other) - change(p, n, across),
            }
        )
    return {"samples": samples}


if __name__ == "__main__":
    sys.exit(main(__file__, expected))
