# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that say how far faces moved, in bands of a factor of about three.

Light yellow stands for the smallest moves, dark purple for the largest: the lightness alone tells them apart, so they
do for every eye. Grey is a face that stays.
"""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Band:
    """Moves above ``lower_mm`` up to ``upper_mm``, and their colour (red, green, blue, each 0..255)."""

    lower_mm: float
    upper_mm: float
    rgb: tuple

    @property
    def name(self):
        """ "0.03..0.1 mm", or "stays"."""
        if self.upper_mm == 0:
            return "stays"
        lower = "up to " if self.lower_mm == 0 else "%g.." % self.lower_mm
        return "%s%g mm" % (lower, self.upper_mm)


#: Largest moves first.
COLOURS = ((68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37))
STAYS = Band(0.0, 0.0, (217, 220, 224))

#: Limits are these times a power of ten.
STEPS = (1.0, 3.0)


def bands(largest_mm):
    """The bands, largest moves first, the last one down to zero; none where nothing moved."""
    if largest_mm <= 0:
        return []
    place = _place_above(largest_mm)
    limits = [_limit(place - k) for k in range(len(COLOURS))] + [0.0]
    return [Band(lower, upper, rgb) for upper, lower, rgb in zip(limits, limits[1:], COLOURS)]


def _limit(place):
    return float("%ge%d" % (STEPS[place % len(STEPS)], place // len(STEPS)))


def _place_above(value):
    """The place of the first limit that is not below a value."""
    place = len(STEPS) * math.floor(math.log10(value))
    while _limit(place) < value:
        place += 1
    return place


def band_of(move_mm, among):
    """The band that a move lies in."""
    return next((band for band in among if band.lower_mm < move_mm <= band.upper_mm), STAYS)


def face_bands(count, moves):
    """The band of each of ``count`` faces; ``moves``: dicts of face, from 1, and largest_move_mm."""
    moved = {move["face"]: move["largest_move_mm"] for move in moves}
    among = bands(max(moved.values(), default=0.0))
    return [band_of(moved.get(face, 0.0), among) for face in range(1, count + 1)]


def legend_entries(of_faces):
    """[(Band, its name, "2 faces")] for the bands that faces lie in, largest moves first, what stays last."""
    used = sorted(set(of_faces), key=lambda band: -band.upper_mm)
    counted = ((band, sum(each == band for each in of_faces)) for band in used)
    return [(band, band.name, "%d face%s" % (number, "" if number == 1 else "s")) for band, number in counted]
