# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of conics share. A conic has the weights 1, w, 1."""

from mpmath import mpc


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def curvature(at, corner, far, w):
    """At the end `at`, from the first two derivatives of the rational curve there."""
    first = 2 * w * (corner - at)
    second = 2 * (far - at) + 4 * w * (1 - 2 * w) * (corner - at)
    return cross(first, second) / abs(first) ** 3


def meeting(p, u, q, v):
    """Where the lines p + x u and q + y v meet."""
    return p + cross(q - p, v) / cross(u, v) * mpc(u)
