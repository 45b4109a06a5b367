# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where labels at nearly the same point are written, so that each can be read."""

import math

#: Points of a model are nearly the same within this part of its size: a few pixels where all of it
#: is seen.
NEAR = 0.01


def size(points):
    """Return the diagonal of the box around points; 0 without a point."""
    return math.dist(*zip(*((min(each), max(each)) for each in zip(*points)))) if points else 0.0


def lines_below(points, near_mm):
    """Return for each point the number of lines by which its label is lower than the point.

    Labels of points within ``near_mm`` have different lines, the first the uppermost.
    """
    found = []
    for index, point in enumerate(points):
        taken = {
            line
            for line, other in zip(found, points[:index])
            if math.dist(point, other) <= near_mm
        }
        found.append(next(line for line in range(index + 1) if line not in taken))
    return found
