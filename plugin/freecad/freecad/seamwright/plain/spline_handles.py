# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the handles of a spline are, what their places mean, and its comb: numbers only."""

from typing import NamedTuple

import numpy

#: The first place of a handle of a tension and the unit of its way, by the size of the points and
#: by the distance of neighbours: whichever is smaller.
REST, UNIT = (0.06, 0.45), (0.04, 0.3)

#: Parts of the size of points below which their polygon is straight.
STRAIGHT = 1e-6


class Slides(NamedTuple):
    """Lines along which tensions are dragged, one for each point.

    ``origins``, ``directions`` (count, 3); ``rest_mm``, ``unit_mm``, ``scale`` (count,): a tension
    v is at rest + unit asinh(v / scale).
    """

    origins: numpy.ndarray
    directions: numpy.ndarray
    rest_mm: numpy.ndarray
    unit_mm: numpy.ndarray
    scale: numpy.ndarray

    def places(self, tension):
        """Return the points (count, 3) of tensions."""
        along = self.rest_mm + self.unit_mm * numpy.arcsinh(tension / self.scale)
        return self.origins + along[:, None] * self.directions

    def tension(self, place, along_mm):
        """Return the tension of one point whose handle is at a distance from it."""
        way = (along_mm - self.rest_mm[place]) / self.unit_mm[place]
        return float(self.scale[place] * numpy.sinh(way))


def slides(points, closed, by_length):
    """Return the Slides of points; they go out of the bends of the polygon.

    ``by_length``: tensions are in 1/mm and count by the distance of the points; else they have no
    unit, and the spline is tighter for smaller ones.
    """
    before, after = _neighbours(points, closed)
    chords = [numpy.linalg.norm(each - points, axis=1) for each in (before, after)]
    chord = numpy.where(
        numpy.minimum(*chords) > 0, (chords[0] + chords[1]) / 2, numpy.maximum(*chords)
    )
    size = numpy.linalg.norm(numpy.ptp(points, axis=0))
    triangle = numpy.linalg.qr(points - points.mean(axis=0), mode="r")
    normal = numpy.linalg.svd(triangle, full_matrices=True)[2][2]
    normal = normal * (1 if normal[numpy.argmax(abs(normal))] > 0 else -1)
    out = points - (before + after) / 2
    along = after - before
    length = numpy.linalg.norm(along, axis=1)  # 0 where the polygon goes back the way it came
    along = along / numpy.where(length > 0, length, 1.0)[:, None]
    out = out - (out * along).sum(axis=1)[:, None] * along
    flat = numpy.linalg.norm(out, axis=1) <= STRAIGHT * size
    out[flat] = numpy.cross(normal, along[flat])
    still = numpy.linalg.norm(out, axis=1) <= STRAIGHT
    out[still] = numpy.cross(along[still], numpy.eye(3)[numpy.argmin(abs(along[still]), axis=1)])
    out = out / numpy.linalg.norm(out, axis=1)[:, None]
    rest, unit = (numpy.minimum(share[0] * size, share[1] * chord) for share in (REST, UNIT))
    scale = 1 / chord if by_length else -numpy.ones(len(points))
    return Slides(points, out, rest, unit, scale)


def _neighbours(points, closed):
    before, after = numpy.roll(points, 1, axis=0), numpy.roll(points, -1, axis=0)
    if not closed:
        before[0], after[-1] = points[0], points[-1]
    return before, after


def nearest(pixels, at, reach):
    """Return the index of the pixel nearest to another one, or None where none is within reach.

    Of equally near ones the last is taken.
    """
    if len(pixels) == 0:
        return None
    distances = numpy.linalg.norm(numpy.asarray(pixels) - at, axis=1)
    distances = numpy.where(numpy.isnan(distances), numpy.inf, distances)
    index = len(distances) - 1 - int(numpy.argmin(distances[::-1]))
    return index if distances[index] <= reach else None


def nearest_on_lines(pixels, at, reach):
    """Return (line, place, share) of the point of lines that is nearest to a pixel, or None.

    ``pixels`` (lines, points, 2). The point lies that share of the way from the point of that place
    to the next one. None where no line is within reach.
    """
    if len(pixels) == 0:
        return None
    starts, steps = pixels[:, :-1], numpy.diff(pixels, axis=1)
    squares = numpy.maximum((steps**2).sum(axis=2), 1e-12)
    shares = numpy.clip(((at - starts) * steps).sum(axis=2) / squares, 0.0, 1.0)
    distances = numpy.linalg.norm(starts + shares[..., None] * steps - at, axis=2)
    distances = numpy.where(numpy.isnan(distances), numpy.inf, distances)
    line, place = numpy.unravel_index(int(numpy.argmin(distances)), distances.shape)
    if distances[line, place] > reach:
        return None
    return int(line), int(place), float(shares[line, place])


def curvature_vectors(first, second):
    """Return vectors to the centres of curvature, as long as the curvature, of derivatives."""
    square = (first * first).sum(axis=1)[:, None]
    along = (second * first).sum(axis=1)[:, None]
    safe = numpy.where(square > 0, square, 1.0)
    return numpy.where(square > 0, (second - first * (along / safe)) / safe, 0.0)


def comb_factor(points, vectors, longest, scale):
    """Return the length in mm of the line of a comb for the curvature 1; 0 for a straight curve."""
    size = numpy.linalg.norm(numpy.ptp(points, axis=0))
    largest = numpy.linalg.norm(vectors, axis=1).max()
    if largest == 0 or largest <= 1e-9 / size:
        return 0.0
    return scale * longest * size / largest


def rounded(point, axis, grid_mm):
    """Return a point with coordinates on a grid, besides that along an axis; 0: no grid."""
    if not grid_mm:
        return numpy.asarray(point, float)
    near = numpy.round(numpy.asarray(point, float) / grid_mm) * grid_mm
    return numpy.where(axis == 0, near, point)


def fair_step(length):
    """Return 1, 2 or 5 times a power of ten, not less than a length."""
    power = 10.0 ** numpy.floor(numpy.log10(length))
    least = length * (1 - 1e-9)
    return float(next(step * power for step in (1, 2, 5, 10) if step * power >= least))
