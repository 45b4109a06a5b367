# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of the plane, and what tests measure of them."""

import math

import numpy as np


def wrapped(angle_rad):
    """The angle plus the multiple of 2 pi that brings it into [-pi, pi]."""
    return np.remainder(np.asarray(angle_rad) + math.pi, 2 * math.pi) - math.pi


def circle_points(count, radius=1.0):
    """Equally spaced, counter-clockwise."""
    angle = 2 * math.pi * np.arange(count) / count
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def turned(points, angle_rad):
    cosine, sine = math.cos(angle_rad), math.sin(angle_rad)
    return np.asarray(points) @ np.array([[cosine, sine], [-sine, cosine]])


def moved(points, angle_rad=0.7, shift=(5.0, -3.0)):
    """By a rotation and a shift."""
    return turned(points, angle_rad) + shift


def distances(points, others):
    """Of each point from the nearest of the others."""
    parts = [
        np.linalg.norm(part[:, None] - others[None], axis=-1).min(axis=1)
        for part in np.array_split(points, max(1, len(points) // 200))
    ]
    return np.concatenate(parts)


def ends_of(random):
    """Two random points with directions whose tangents do not both point against the chord."""
    start, end = random.uniform(-9, 9, 2), random.uniform(-9, 9, 2)
    chord = math.atan2(end[1] - start[1], end[0] - start[0])
    angles = random.uniform(-2, 2, 2)
    return start, chord + angles[0], end, chord + angles[1]


def quadrature(function, first, last, panels=200):
    """The integral of a function of an array, by Gauss's rule with 8 nodes in each panel."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    edges = np.linspace(first, last, panels + 1)
    half = np.diff(edges) / 2
    at = (edges[:-1] + half)[:, None] + half[:, None] * nodes
    return np.tensordot(half[:, None] * weights, function(at), axes=2)
