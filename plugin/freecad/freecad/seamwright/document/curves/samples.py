# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that are samples of a curve: the runs between corners, and ends."""

import math

def runs_between(count, corners, closed):
    """Return the indices of the points of each run from corner to corner, with both ends.

    A closed curve with corners begins at the first one. Without corners there is one run.
    """
    cuts = [0, *corners, count - 1]
    if closed:
        cuts = [*corners, corners[0] + count] if corners else [0, count - 1]
    return [[k % count for k in range(a, b + 1)] for a, b in zip(cuts, cuts[1:])]


def runs_of(module, points, closed, error_mm=0.0):
    """Return [(points, whether they are closed), ...] of each run between corners.

    error_mm: by how much points may be off.
    """
    corners = []
    if len(points) > 2:
        corners = module.point_corners(points, closed=closed, error_mm=error_mm)
    if not corners:
        return [(points, closed)]
    return [(points[run], False) for run in runs_between(len(points), corners, closed)]


def end_directions(points, closed):
    """Return the directions at the ends of open points, as arguments of the kernel.

    They are those of the circles through the three outer points. Without an end, or of two points,
    there are none.
    """
    if closed or len(points) < 3:
        return {}
    outer = points[:3], points[:-4:-1]
    start, back = (_direction(*three) for three in outer)
    return {"start_direction_rad": start, "end_direction_rad": back + math.pi}


def _direction(first, second, third):
    """Return the direction at the first of three points, of the circle through them."""
    to_second, to_third, between = (
        math.atan2(*(b - a)[::-1]) for a, b in ((first, second), (first, third), (second, third))
    )
    return to_second + math.remainder(to_third - between, 2 * math.pi)
