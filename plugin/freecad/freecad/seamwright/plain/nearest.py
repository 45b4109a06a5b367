# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest points of triangles to many points, with numpy alone."""

from typing import Any, NamedTuple

import numpy

#: Points that are compared with the triangles together.
CHUNK = 128


class Nearest(NamedTuple):
    """For each point: the triangle, the barycentric weights of its nearest point, the distance."""

    triangles: Any
    weights: Any
    distances: Any


def nearest(points, corners, progress=None):
    """Return the Nearest of points (n, 3) on triangles with ``corners`` (m, 3, 3); m > 0.

    ``progress``: a callable(fraction) that returns False to stop; then the result is None.
    """
    middles = corners.mean(axis=1)
    radii = numpy.linalg.norm(corners - middles[:, None], axis=2).max(axis=1)
    count = len(points)
    triangles = numpy.zeros(count, numpy.int64)
    weights, distances = numpy.zeros((count, 3)), numpy.full(count, numpy.inf)
    order = _along_a_curve(points)
    for begin in range(0, count, CHUNK):
        if progress is not None and not progress(begin / count):
            return None
        some = order[begin : begin + CHUNK]
        found = _nearest_of(points[some], corners, middles, radii)
        triangles[some], weights[some], distances[some] = found
    return Nearest(triangles, weights, distances)


def _along_a_curve(points):
    """Return an order in which neighbours are near to each other: along a Morton curve."""
    if not len(points):
        return numpy.zeros(0, int)
    size = numpy.ptp(points, axis=0).max() or 1.0
    cells = ((points - points.min(axis=0)) / size * 1023).astype(numpy.int64)
    code = numpy.zeros(len(points), numpy.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return numpy.argsort(code)


def _nearest_of(points, corners, middles, radii):
    middle = points.mean(axis=0)
    radius = numpy.linalg.norm(points - middle, axis=1).max()
    away = numpy.linalg.norm(middles - middle, axis=1)
    # No point of the chunk is further than ``least`` from some triangle.
    least = (away + radii).min() + radius
    near = numpy.flatnonzero(away - radii - radius <= least)
    each = _apart(points - middle, middles[near] - middle)
    reach = radii[near]
    possible = each - reach <= (each + reach).min(axis=1)[:, None] * (1 + 1e-9)
    rows, columns = numpy.nonzero(possible)
    weights, squares = closest(points[rows], corners[near[columns]])
    best = numpy.lexsort((squares, rows))
    best = best[numpy.searchsorted(rows, numpy.arange(len(points)))]  # rows are sorted
    return near[columns[best]], weights[best], numpy.sqrt(squares[best])


def _apart(points, others):
    """Return the distances of all points (n, 3) from all others (m, 3), up to rounding."""
    squares = _dot(points, points)[:, None] + _dot(others, others) - 2 * points @ others.T
    return numpy.sqrt(numpy.maximum(squares, 0.0))


def closest(points, corners):
    """Return (weights, squared distances) of the nearest points of triangles; arrays broadcast."""
    a, b, c = corners[..., 0, :], corners[..., 1, :], corners[..., 2, :]
    ab, ac, ap = b - a, c - a, points - a
    d00, d01, d11 = _dot(ab, ab), _dot(ab, ac), _dot(ac, ac)
    d20, d21 = _dot(ap, ab), _dot(ap, ac)
    area = d00 * d11 - d01 * d01
    with numpy.errstate(divide="ignore", invalid="ignore"):
        v = (d11 * d20 - d01 * d21) / area
        w = (d00 * d21 - d01 * d20) / area
        inside = (v >= 0) & (w >= 0) & (v + w <= 1)
    v, w = numpy.where(inside, v, 0.0), numpy.where(inside, w, 0.0)
    square = numpy.where(inside, _square(ap, ab, ac, v, w), numpy.inf)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        along_ab = numpy.nan_to_num(numpy.clip(d20 / d00, 0, 1))
        along_ac = numpy.nan_to_num(numpy.clip(d21 / d11, 0, 1))
        along_bc = numpy.nan_to_num(
            numpy.clip((d21 - d20 - d01 + d00) / (d00 - 2 * d01 + d11), 0, 1)
        )
    zero = numpy.zeros_like(along_ab)
    for side in ((along_ab, zero), (zero, along_ac), (1 - along_bc, along_bc)):
        other = _square(ap, ab, ac, *side)
        better = other < square
        square = numpy.where(better, other, square)
        v, w = numpy.where(better, side[0], v), numpy.where(better, side[1], w)
    return numpy.stack([1 - v - w, v, w], axis=-1), square


def _square(ap, ab, ac, v, w):
    rest = ap - v[..., None] * ab - w[..., None] * ac
    return _dot(rest, rest)


def _dot(one, other):
    return numpy.einsum("...k,...k->...", one, other)
