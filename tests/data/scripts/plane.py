# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of planar curves share: points as complex numbers, ends, arcs."""

from mpmath import mp, mpc, mpf

from oracle import real


def point(value):
    return mpc(real(value[0]), real(value[1]))


def pair(z):
    return [z.real, z.imag]


def wrapped(angle):
    return angle - 2 * mp.pi * mp.nint(angle / (2 * mp.pi))


def unit(angle):
    return mp.expj(angle)


class Ends:
    """Two points with directions, and the angles of the tangents against the chord."""

    def __init__(self, given):
        self.start, self.end = point(given["P0"]), point(given["P1"])
        self.first, self.last = real(given["theta0"]), real(given["theta1"])
        chord = self.end - self.start
        self.chord, self.direction = abs(chord), mp.arg(chord)
        self.alpha = wrapped(self.direction - self.first)
        self.beta = wrapped(self.last - self.direction)


def arc_end(start, direction, curvature, length):
    """The end of an arc by its centre; of a line by its length."""
    if curvature == 0:
        return start + length * unit(direction)
    centre = start + unit(direction) * mpc(0, 1) / curvature
    return centre + (start - centre) * unit(curvature * length)


def arc_through(start, direction, end):
    """Curvature and length of the arc with this direction at its start."""
    chord = end - start
    angle = wrapped(mp.arg(chord) - direction)
    if angle == 0:
        return mpf(0), abs(chord)
    curvature = 2 * mp.sin(angle) / abs(chord)
    return curvature, 2 * angle / curvature
