# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that are samples of a curve: corners, by the rule of the command ``curve``, and ends."""

import math

import numpy

#: Smooth curves are sampled with smaller turns.
CORNER_RAD = math.radians(60)

#: How much more a corner turns than the points beside it; the larger number is for corners with
#: fewer than FEW points on each side.
TIMES, TIMES_OF_FEW, FEW = 5, 8, 5


def corners_of(points, closed):
    """Return the indices of the corners of points (count, 2) of a plane, ascending.

    There the polygon turns by more than CORNER_RAD, and TIMES as much as at the nearest points
    before and after that turn by less. Ends do not count. If all points turn by more, they are few
    points of a smooth curve.
    """
    count = len(points)
    if count < 3:
        return []
    turns = _turns(points, closed)
    found = []
    for place in numpy.flatnonzero(turns > CORNER_RAD):
        beside = _beside(turns, int(place), closed)
        if beside is not None and turns[place] > TIMES * beside:
            found.append((int(place), turns[place] > TIMES_OF_FEW * beside))
    sizes = [len(run) for run in runs_between(count, [place for place, _ in found], closed)]
    return [
        place
        for k, (place, is_clear) in enumerate(found)
        if is_clear or max(sizes[k - 1 if closed else k], sizes[k if closed else k + 1]) >= FEW
    ]


def _turns(points, closed):
    sides = numpy.roll(points, -1, axis=0) - points
    before = numpy.roll(sides, 1, axis=0)
    sines = before[:, 0] * sides[:, 1] - before[:, 1] * sides[:, 0]
    turns = abs(numpy.arctan2(sines, (before * sides).sum(axis=1)))
    if not closed:
        turns[[0, -1]] = 0
    return turns


def _beside(turns, place, closed):
    """Return the larger turn of the nearest points before and after that turn by less.

    Returns None where there is no such point on one side.
    """
    count = len(turns)
    around = turns if not closed else numpy.concatenate([turns, turns, turns])
    at = place if not closed else place + count
    smooth = numpy.flatnonzero(around <= CORNER_RAD)
    before, after = smooth[smooth < at], smooth[smooth > at]
    if not len(before) or not len(after):
        return None
    return max(around[before[-1]], around[after[0]])


def runs_between(count, corners, closed):
    """Return the indices of the points of each run from corner to corner, with both ends.

    A closed curve with corners begins at the first one. Without corners there is one run.
    """
    cuts = [0, *corners, count - 1]
    if closed:
        cuts = [*corners, corners[0] + count] if corners else [0, count - 1]
    return [[k % count for k in range(a, b + 1)] for a, b in zip(cuts, cuts[1:])]


def runs_of(points, closed):
    """Return [(points, whether they are closed), ...] of each run between corners."""
    corners = corners_of(points, closed)
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
