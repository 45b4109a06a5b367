# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that say how a surface is bent: white where its mean curvature is 0, orange where it is
hollow, blue where it bulges.

They grow darker with the curvature, to both sides alike, so that every eye tells flat from bent and
hollow from bulging.
"""

import math
from dataclasses import dataclass

import numpy

from freecad.seamwright.plain import enclosure

#: Share of the limit, and its colour (red, green, blue, each 0..255); between them it is mixed.
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

#: Where a surface has no curvature, such as at the tip of a cone.
UNTOLD = (128, 128, 128)

#: So much of the area may lie beyond the limit at each end.
TAIL = 0.02

#: In 1/mm: what is bent less is flat; its radius is 10 km.
FLAT = 1e-7

#: The first digits of a limit, and how far a limit may lie below what it was rounded from.
ROUND, ROUNDED_DOWN = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10), 1e-3

#: Shares of the limit that the legend has a line for.
LEGEND_SHARES = (1.0, 0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75, -1.0)

TITLE = "Mean curvature"
MINUS = "\u2212"


@dataclass(frozen=True)
class Sample:
    """A colour of the legend."""

    rgb: tuple


def areas(points, triangles):
    """The share of the area of the triangles that belongs to each point: a third of those around
    it."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    each = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 6
    return numpy.bincount(triangles.ravel(), numpy.repeat(each, 3), len(points))


def quantiles(values, weights, shares):
    """For each share the least value up to which that share of the weight lies; zeros where there
    is no weight."""
    order = numpy.argsort(values)
    sums = numpy.cumsum(weights[order])
    if not len(values) or sums[-1] <= 0:
        return numpy.zeros(len(shares))
    places = numpy.searchsorted(sums, numpy.asarray(shares) * sums[-1])
    return values[order][numpy.minimum(places, len(values) - 1)]


def limit(values, weights):
    """The curvature, in 1/mm, that has the end colour: nearly all of the area lies within it, to
    both sides of 0.

    It is a round figure. Where nearly all is flat it is the largest curvature; 0 where nothing is
    bent.
    """
    told = numpy.isfinite(values)
    values, weights = values[told], weights[told]
    found = float(abs(quantiles(values, weights, (TAIL, 1 - TAIL))).max())
    if found < FLAT:
        found = float(abs(values).max(initial=0.0))
    return _round_up(found) if found >= FLAT else 0.0


def _round_up(value):
    power = 10.0 ** math.floor(math.log10(value))
    return power * next(digits for digits in ROUND if digits * power * (1 + ROUNDED_DOWN) >= value)


def colours(values, limit_per_mm):
    """The colour of each curvature, as rows of numbers 0..1; those beyond the limit have the
    colours of the ends."""
    told = numpy.isfinite(values)
    shares = (
        numpy.where(told, values, 0.0) / limit_per_mm
        if limit_per_mm > 0
        else numpy.zeros(len(values))
    )
    places, rgb = [share for share, _ in RAMP], numpy.array([colour for _, colour in RAMP], float)
    found = numpy.stack([numpy.interp(shares, places, channel) for channel in rgb.T], axis=1)
    found[~told] = UNTOLD
    return found / 255


def legend(limit_per_mm):
    """Title, entries and footer."""
    return TITLE, legend_entries(limit_per_mm), legend_footer(limit_per_mm)


def legend_entries(limit_per_mm):
    """[(Sample, "0.02 1/mm", "ball of radius 50 mm")], the most hollow first; one line where
    nothing is bent."""
    if limit_per_mm <= 0:
        return [_entry(0.0, 1.0)]
    return [_entry(share * limit_per_mm, limit_per_mm) for share in LEGEND_SHARES]


def _entry(value, limit_per_mm):
    rgb = colours(numpy.array([value]), limit_per_mm)[0] * 255
    meaning = (
        "as a ball of radius %s mm" % enclosure.number(1 / abs(value))
        if value
        else "flat, or a saddle"
    )
    return Sample(tuple(int(round(channel)) for channel in rgb)), "%s 1/mm" % signed(value), meaning


def signed(value):
    """A curvature with its sign, to three digits."""
    sign = MINUS if value < 0 else "+" if value > 0 else ""
    return sign + enclosure.number(abs(value))


def legend_footer(limit_per_mm):
    """What the signs mean, and what becomes of curvatures beyond the limit."""
    signs = "+ hollow, %s bulging, seen from where the normals point" % MINUS
    if limit_per_mm <= 0:
        return signs
    return "%s\nwhat is beyond \u00b1%s 1/mm has the end colours" % (
        signs,
        enclosure.number(limit_per_mm),
    )
