# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for the mean curvature of a surface.

White means mean curvature 0, orange concave, and blue convex. Both colours grow darker with the
curvature in the same way. So readers with any colour vision can tell flat from curved and concave
from convex.
"""

import math
from dataclasses import dataclass

import numpy

from freecad.seamwright.plain import enclosure
from freecad.seamwright.plain.language import mark, tr

#: (share of the limit, colour); a colour is (red, green, blue), each 0..255. Colours between the
#: entries are interpolated.
RAMP = (
    (-1.0, (5, 48, 97)),
    (-0.8, (33, 102, 172)),
    (-0.6, (67, 147, 195)),
    (-0.4, (146, 197, 222)),
    (-0.2, (209, 229, 240)),
    (0.0, (250, 250, 250)),
    (0.2, (254, 224, 182)),
    (0.4, (253, 184, 99)),
    (0.6, (224, 130, 20)),
    (0.8, (179, 88, 6)),
    (1.0, (127, 59, 8)),
)

#: Colour of points where the curvature is undefined, such as the tip of a cone.
UNDEFINED = (128, 128, 128)

#: At each end, this share of the area may lie beyond the limit.
TAIL = 0.02

#: Smaller curvatures count as flat, in 1/mm. The radius of this one is 10 km.
FLAT = 1e-7

#: The leading digits that a limit may have, and the relative amount by which a limit may lie below
#: the value that it was rounded from.
ROUND, ROUNDED_DOWN = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10), 1e-3

#: The shares of the limit for which the legend has a line.
LEGEND_SHARES = (1.0, 0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75, -1.0)

TITLE = mark("Mean curvature")
MINUS = "\u2212"


@dataclass(frozen=True)
class Sample:
    """One colour of the legend; ``apart``: it is not on the continuous scale."""

    rgb: tuple
    apart: bool = False


def areas(points, triangles):
    """Return the area of each point: a third of the area of the triangles around it."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    each = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 6
    return numpy.bincount(triangles.ravel(), numpy.repeat(each, 3), len(points))


def quantiles(values, weights, shares):
    """For each share, return the least value up to which that share of the weight lies.

    Returns zeros where the total weight is zero.
    """
    order = numpy.argsort(values)
    sums = numpy.cumsum(weights[order])
    if not len(values) or sums[-1] <= 0:
        return numpy.zeros(len(shares))
    indices = numpy.searchsorted(sums, numpy.asarray(shares) * sums[-1])
    return values[order][numpy.minimum(indices, len(values) - 1)]


def limit(values, weights):
    """Return the curvature, in 1/mm, that gets the end colour: a round number.

    All of the area except ``TAIL`` at each end has a smaller absolute curvature. Where this
    curvature is flat, the largest absolute curvature is taken instead. The limit is 0 where that is
    flat too.
    """
    known = numpy.isfinite(values)
    values, weights = values[known], weights[known]
    found = float(abs(quantiles(values, weights, (TAIL, 1 - TAIL))).max())
    if found < FLAT:
        found = float(abs(values).max(initial=0.0))
    return round_up(found) if found >= FLAT else 0.0


def round_up(value):
    """Return the least round number that is not smaller than a positive value, up to 0.1 %."""
    power = 10.0 ** math.floor(math.log10(value))
    return power * next(digits for digits in ROUND if digits * power * (1 + ROUNDED_DOWN) >= value)


def colours(values, limit_per_mm):
    """Return the colour of each curvature as rows of numbers 0..1.

    Curvatures beyond the limit get the colours of the ends.
    """
    known = numpy.isfinite(values)
    shares = (
        numpy.where(known, values, 0.0) / limit_per_mm
        if limit_per_mm > 0
        else numpy.zeros(len(values))
    )
    stops, rgb = [share for share, _ in RAMP], numpy.array([colour for _, colour in RAMP], float)
    found = numpy.stack([numpy.interp(shares, stops, channel) for channel in rgb.T], axis=1)
    found[~known] = UNDEFINED
    return found / 255


def legend(limit_per_mm):
    """Return title, entries and footer."""
    return tr(TITLE), legend_entries(limit_per_mm), legend_footer(limit_per_mm)


def legend_entries(limit_per_mm):
    """Return [(Sample, "0.02 1/mm", "as a sphere of radius 50 mm")], the most concave first.

    Has one line where the whole surface is flat.
    """
    if limit_per_mm <= 0:
        return [_entry(0.0, 1.0)]
    return [_entry(share * limit_per_mm, limit_per_mm) for share in LEGEND_SHARES]


def _entry(value, limit_per_mm):
    rgb = colours(numpy.array([value]), limit_per_mm)[0] * 255
    meaning = (
        tr("as a sphere of radius {radius} mm").format(radius=enclosure.number(1 / abs(value)))
        if value
        else tr("flat, or a saddle")
    )
    return Sample(tuple(int(round(channel)) for channel in rgb)), "%s 1/mm" % signed(value), meaning


def signed(value):
    """Return a curvature as text with its sign, to three digits."""
    sign = MINUS if value < 0 else "+" if value > 0 else ""
    return sign + enclosure.number(abs(value))


def legend_footer(limit_per_mm):
    """Say what the signs mean and which colours curvatures beyond the limit have."""
    signs = tr("+ concave, {minus} convex, seen from the side of the normals").format(minus=MINUS)
    if limit_per_mm <= 0:
        return signs
    return tr("{signs}\nvalues beyond \u00b1{limit_per_mm} 1/mm have the end colours").format(
        signs=signs, limit_per_mm=enclosure.number(limit_per_mm)
    )
