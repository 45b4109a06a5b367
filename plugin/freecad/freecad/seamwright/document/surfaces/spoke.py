# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges as single polynomial curves that begin at one of their ends."""

import numpy

from freecad.seamwright.document.curves import inputs
from freecad.seamwright.plain.language import tr

#: Degrees of curves that are tried, and points of the edge for each.
DEGREES, SAMPLES = (3, 5, 7, 9), 200


def fitted(module, edge, name, from_last, tolerance_mm, rational=False):
    """Return (BezierCurve, its distance from the edge in mm) of an edge from one of its ends.

    A polynomial Bezier curve stays as it is, and with ``rational`` a rational one, too. Otherwise a
    curve with the same ends and the same tangents there takes its place. Its distance is measured
    between points of equal parameters.
    Raises ValueError where it is larger than the tolerance; ``name``: that of the edge in a text.
    """
    spline = inputs.curve_of(module, edge).bezier_spline()
    if spline.segments == 1 and (rational or not spline.is_rational):
        curve = spline.segment(0)
        return (curve.reversed() if from_last else curve), 0.0
    places = numpy.linspace(0.0, 1.0, SAMPLES)
    points = _points(spline, places[::-1] if from_last else places)
    tangents = [numpy.array(edge.tangentAt(at)) for at in edge.ParameterRange]
    if from_last:
        tangents = [-each for each in tangents[::-1]]
    for degree in DEGREES:
        poles = _fit(points, places, tangents, degree)
        curve = module.BezierCurve(poles)
        distance = numpy.linalg.norm(curve.point(places) - points, axis=1).max()
        if distance <= tolerance_mm:
            return curve, float(distance)
    raise ValueError(
        tr(
            "a curve of degree {degree} is {distance:.3g} mm from {edge}, and {tolerance_mm:g} "
            "mm are allowed: divide the edge, or allow more"
        ).format(degree=DEGREES[-1], distance=distance, edge=name, tolerance_mm=tolerance_mm)
    )


def _points(spline, places):
    """Return points of a spline at shares of its length, nearly."""
    first, last = spline.knots[0], spline.knots[-1]
    fine = numpy.linspace(first, last, 20 * SAMPLES)
    along = numpy.asarray(spline.point(fine))
    lengths = numpy.append(0.0, numpy.cumsum(numpy.linalg.norm(numpy.diff(along, axis=0), axis=1)))
    return numpy.asarray(spline.point(numpy.interp(places * lengths[-1], lengths, fine)))


def _fit(points, places, tangents, degree):
    """Return the poles with given ends and tangents that are nearest to points at places."""
    basis = _bernstein(places, degree)
    inner = degree - 3
    known = (basis[:, 0] + basis[:, 1])[:, None] * points[0]
    known = known + (basis[:, -2] + basis[:, -1])[:, None] * points[-1]
    system = numpy.zeros((3 * len(places), 3 * inner + 2))
    system[:, 0] = numpy.outer(basis[:, 1], tangents[0]).ravel()
    system[:, 1] = -numpy.outer(basis[:, -2], tangents[1]).ravel()
    for place in range(inner):
        for axis in range(3):
            system[axis::3, 2 + 3 * place + axis] = basis[:, 2 + place]
    found = numpy.linalg.lstsq(system, (points - known).ravel(), rcond=None)[0]
    start, end = points[0] + found[0] * tangents[0], points[-1] - found[1] * tangents[1]
    return numpy.vstack([points[0], start, found[2:].reshape(-1, 3), end, points[-1]])


def _bernstein(places, degree):
    """Return the values (places, degree + 1) of the Bernstein polynomials."""
    values = numpy.ones((len(places), 1))
    for _ in range(degree):
        left = numpy.pad(values, ((0, 0), (0, 1))) * (1 - places)[:, None]
        values = left + numpy.pad(values, ((0, 0), (1, 0))) * places[:, None]
    return values
