# SPDX-License-Identifier: LGPL-2.1-or-later
"""A track of lines and arcs with clothoids between them, as a road or a robot needs it.

    python3 30_clothoid_transitions.py OUT.svg

Left: the track with its curvature comb, which jumps where a line meets an arc. Right: the
clothoids near it. The lines stay; arcs beside lines become smaller by the shift of the clothoids,
which is less than the tolerance.
"""

import math
import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)


def track(start):
    """Lines, arcs and an S, end to end: curvature and length of each."""
    arcs, point, direction = [], start, 0.0
    for radius, length in ((0, 30), (20, 35), (0, 12), (-15, 22), (15, 26), (30, 20), (0, 25)):
        curvature = 1 / radius if radius else 0
        arcs.append(seamwright.PlanarArc(point, direction, curvature, length))
        point, direction = arcs[-1].end, arcs[-1].end_direction_rad
    return seamwright.ArcChain(arcs)


def shape(curvatures):
    """Extrema and inflections of a sequence of curvatures."""
    steps = np.sign(np.diff(curvatures))
    steps, sides = steps[steps != 0], np.sign(curvatures)[np.abs(curvatures) > 1e-12]
    return np.count_nonzero(np.diff(steps)), np.count_nonzero(np.diff(sides))


tolerance = 0.2
given = track([0, 0])
fit = seamwright.fit_clothoids(given.bezier_spline(), tolerance)
pieces = fit.chain.pieces
before = shape([arc.curvature_per_mm for arc in given.arcs])
ends = [(piece.curvature_per_mm, piece.end_curvature_per_mm) for piece in pieces]
after = shape(np.ravel(ends))
jump = max(abs(left[1] - right[0]) for left, right in zip(ends, ends[1:]))
constant = sum(math.isclose(*pair, abs_tol=1e-12) for pair in ends)
print(f"{len(given.arcs)} arcs and lines: {before[0]} extrema, {before[1]} inflections")
print(f"{constant} arcs and lines, {len(pieces) - constant} clothoids: {after[0]} extrema,")
print(f"{after[1]} inflections, within {fit.distance_mm:.3f} m, jumps below 1e-12: {jump < 1e-12}")

beside = seamwright.fit_clothoids(track([100, 0]).bezier_spline(), tolerance).chain
picture = Picture("A track of lines and arcs, and clothoids near it")
picture.curve(given.bezier_spline(), "#0072b2", "lines and arcs", comb=True)
picture.curve(beside.bezier_spline(1e-3).curve, "#d55e00", "with clothoids between", comb=True)
picture.write(sys.argv[1])
