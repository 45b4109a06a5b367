# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values to draw on a surface, from its normals and principal curvatures, as arrays.

Points, normals and directions have the shape (n, 3). Principal curvatures are (n, 2), k1 >= k2, in
1/mm, positive where the surface bends towards its normal. Undefined values are nan.
"""

import numpy

from freecad.seamwright.plain.language import mark, tr

MEAN, GAUSSIAN = mark("Mean"), mark("Gaussian")
LARGEST, RADIUS = mark("Largest"), mark("Smallest radius")

QUANTITIES = (MEAN, GAUSSIAN, LARGEST, RADIUS)

#: The unit of each quantity, and of the numbers of a range.
UNITS = {MEAN: "1/mm", GAUSSIAN: "1/mm\u00b2", LARGEST: "1/mm", RADIUS: "mm"}


def curvature_values(quantity, principal_per_mm):
    """Return one value for each point: a quantity of QUANTITIES.

    Mean: (k1 + k2) / 2; Gaussian: k1 k2; Largest: the larger of the absolute values; Smallest
    radius: its reciprocal, infinite where the surface is flat.
    """
    k1, k2 = principal_per_mm.T
    if quantity == MEAN:
        return (k1 + k2) / 2
    if quantity == GAUSSIAN:
        return k1 * k2
    largest = numpy.maximum(abs(k1), abs(k2))
    if quantity == LARGEST:
        return largest
    with numpy.errstate(divide="ignore"):
        return 1 / largest


def unit(direction, what="direction"):
    """Return a direction of three numbers with the length 1. Raises ValueError."""
    found = numpy.asarray(direction, float)
    if found.shape != (3,) or not numpy.isfinite(found).all() or not found.any():
        raise ValueError(
            tr("{what} = {direction}: three numbers are needed, not all zero").format(
                what=what, direction="; ".join("%g" % each for each in found.ravel())
            )
        )
    return found / numpy.linalg.norm(found)


def draft_angles_deg(normals, pull):
    """Return the draft angle of each point in degrees, -90 to 90.

    It is the angle between the tangent plane and the direction of pull: positive where the normal
    points towards the pull, 0 on walls along it, negative on undercuts seen from the pull.
    """
    return numpy.degrees(numpy.arcsin(_cosines(normals, pull)))


def isophote_angles_deg(normals, direction):
    """Return the angle between normal and direction at each point in degrees, 0 to 180."""
    return numpy.degrees(numpy.arccos(_cosines(normals, direction)))


def _cosines(normals, direction):
    found = numpy.clip(normals @ unit(direction), -1.0, 1.0)
    return numpy.where(normals.any(axis=1), found, numpy.nan)


def highlight_positions(points, normals, along, towards, distance_mm, spacing_mm):
    """Return for each point the position of the light line that its normal meets, in spacings.

    The light lines are parallel to ``along``, in a plane at ``distance_mm`` from the origin in the
    direction ``towards``, ``spacing_mm`` apart; line 0 passes over the origin. Where the position
    is a whole number, the line through the point along the normal meets a light line: the point is
    on a highlight line. Undefined where the normal is parallel to the plane of the lights, or
    points along them. Source: [BeierChen1994].
    """
    along = unit(along, "along")
    towards = unit(towards, "towards")
    towards = towards - along * (towards @ along)
    if numpy.linalg.norm(towards) < 1e-9:
        raise ValueError(tr(
            "the lights run in the direction in which they lie: choose another one"
        ))
    towards = unit(towards)
    side = numpy.cross(towards, along)
    # The normal line P + s N reaches the plane of the lights where its height is the distance.
    rise = normals @ towards
    with numpy.errstate(divide="ignore", invalid="ignore"):
        reach = (distance_mm - points @ towards) / rise
        found = (points @ side + reach * (normals @ side)) / spacing_mm
    return numpy.where(numpy.isfinite(found) & (abs(rise) > 1e-9), found, numpy.nan)


def area_above(points, triangles, values, limit):
    """Return (area where linear values of triangles are at least a limit, area of all of them).

    ``points`` (n, 3), ``triangles`` (m, 3): indices of points, ``values`` (n,). Triangles with an
    unknown value are left out.
    """
    corners = numpy.sort(values[triangles], axis=1)
    known = numpy.isfinite(corners).all(axis=1)
    low, middle, high = corners[known].T
    a, b, c = (points[triangles[known, k]] for k in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
    with numpy.errstate(divide="ignore", invalid="ignore"):
        below = (limit - low) ** 2 / ((middle - low) * (high - low))
        above = (high - limit) ** 2 / ((high - low) * (high - middle))
    cases = [limit <= low, limit > high, limit <= middle]
    shares = numpy.select(cases, [1.0, 0.0, 1 - below], above)
    return float(areas @ shares), float(areas.sum())


def extremes(values, points):
    """Return {"least", "largest", "least_at", "largest_at"}; None without a finite value."""
    known = numpy.flatnonzero(numpy.isfinite(values))
    if not len(known):
        return {"least": None, "largest": None, "least_at": None, "largest_at": None}
    low, high = known[values[known].argmin()], known[values[known].argmax()]
    return {
        "least": float(values[low]),
        "largest": float(values[high]),
        "least_at": points[low].tolist(),
        "largest_at": points[high].tolist(),
    }


def given_range(report):
    """Return (low, high) to begin with for a range of the user: the values found, three digits.

    Zero stays in the middle where both signs occur. Returns () where all values are equal.
    """
    low, high = report["least"], report["largest"]
    if low < 0 < high:
        low, high = -max(-low, high), max(-low, high)
    low, high = (float("%.3g" % each) for each in (low, high))
    return (low, high) if low < high else ()
