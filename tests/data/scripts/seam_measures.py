#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Largest gap, angle and differences of curvature along seams of patches: the largest of some
samples, made sharp by parabolas or, at kinks, by halving steps. There the file has 24 digits.
Takes some twenty seconds.

Source: docs/theory/surfaces.md.
"""

import functools
import sys

from curvature_jumps import jet, spectral_norm, tensor
from mpmath import mp
from oracle import add, cross, derivative, dot, main, minus, norm, real, scaled, value

SURE = 24  # digits: the maxima at kinks have 24

SAMPLES = 40
ROUNDING = mp.mpf("1e-30")
KINK = mp.mpf("1e-4")  # second differences of smooth functions are smaller, relative to their step


def divided(h):
    """Derivatives to the second order of a rational surface, from those of its homogeneous one."""
    w, points = [[x[-1] for x in row] for row in h], [[x[:-1] for x in row] for row in h]
    x = [[None] * 3 for _ in range(3)]
    over = 1 / w[0][0]
    x[0][0] = scaled(over, points[0][0])
    for i, j in ((1, 0), (0, 1)):
        x[i][j] = scaled(over, minus(points[i][j], scaled(w[i][j], x[0][0])))
    for i, j in ((2, 0), (0, 2)):
        a, b = i // 2, j // 2
        terms = add(scaled(2 * w[a][b], x[a][b]), scaled(w[i][j], x[0][0]))
        x[i][j] = scaled(over, minus(points[i][j], terms))
    terms = add(scaled(w[1][0], x[0][1]), scaled(w[0][1], x[1][0]), scaled(w[1][1], x[0][0]))
    x[1][1] = scaled(over, minus(points[1][1], terms))
    return x


class Side:
    def __init__(self, given, name, end):
        self.net = [[[real(x) for x in pole] for pole in row] for row in given[name]]
        self.homogeneous = given["homogeneous"]
        path = given.get(f"pcurve_{name}", [[end, 0], [end, 1]])
        self.path = [[real(x) for x in point] for point in path]

    def at(self, t):
        """Derivatives, the unit normal, and the tangent of the seam."""
        x = jet(self.net, *value(list(self.path), t), 2)
        if self.homogeneous:
            x = divided(x)
        n = cross(x[1][0], x[0][1])
        a, b = value(derivative(self.path), t)
        return x, scaled(1 / norm(n), n), add(scaled(a, x[1][0]), scaled(b, x[0][1]))


def measures(p, q, size, t):
    (x, n, along), (y, m, _) = p.at(t), q.at(t)
    before = tensor(x, n, *frame(n, along))
    after = tensor(y, m, *frame(m, along))
    across = abs(after[2] - before[2])
    return {
        "max_gap": norm(minus(x[0][0], y[0][0])),
        "max_angle_rad": mp.atan2(norm(cross(n, m)), dot(n, m)),
        "max_abs_delta_kappa_perp": across,
        "max_spectral_II_difference": spectral_norm(*minus(after, before)),
        "max_relative_delta_kappa": across / max(abs(after[2]), abs(before[2]), 1 / size),
    }


def frame(n, along):
    """The direction of the seam in the tangent plane, and the one across it."""
    flat = minus(along, scaled(dot(along, n), n))
    tangent = scaled(1 / norm(flat), flat)
    return tangent, cross(n, tangent)


def sharpened(f, t):
    """The value of a maximum near t, or of one at the end of [0, 1]: by parabolas where the
    function is smooth, by halving steps where it has a kink."""
    for step in map(mp.mpf, ("1e-2", "1e-3", "1e-5", "1e-9", "1e-17")):
        if not step <= t <= 1 - step:
            break
        low, middle, high = f(t - step), f(t), f(t + step)
        bend = low - 2 * middle + high
        vertex = t + step / 2 * (low - high) / bend if bend < 0 else t
        if not 0 <= vertex <= 1 or f(vertex) < middle or abs(bend) > KINK * step:
            break
        t = vertex
    else:
        return f(t)
    step = mp.mpf(1) / SAMPLES
    while step > mp.mpf("1e-36"):
        step /= 2
        t = max((s for s in (t - step, t, t + step) if 0 <= s <= 1), key=f)
        if t in (0, 1) and step < mp.mpf("1e-6"):
            break
    return f(t)


def expected(case):
    given = case["input"]
    p, q, size = Side(given, "P", 1), Side(given, "Q", 0), real(given["length_scale"])
    places = [mp.mpf(k) / SAMPLES for k in range(SAMPLES + 1)]
    at = functools.cache(lambda t: measures(p, q, size, t))
    samples = [at(t) for t in places]
    found = {}
    for key in samples[0]:
        best = max(range(SAMPLES + 1), key=lambda k: samples[k][key])
        largest = mp.mpf(0)
        if samples[best][key] > ROUNDING:
            largest = sharpened(lambda t: at(t)[key], places[best])
        found[key] = {"value": largest}
    return found


if __name__ == "__main__":
    sys.exit(main(__file__, expected, SURE))
