# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for how far a point moved: from light grey, where it stays, over yellow to dark red.

The colours grow darker with the move. So readers with any colour vision can tell them apart by
lightness alone.
"""

from dataclasses import dataclass

from freecad.seamwright.plain import enclosure
from freecad.seamwright.plain.language import tr

#: (share of the largest move, colour); a colour is (red, green, blue), each 0..255. Colours between
#: the entries are interpolated.
RAMP = (
    (0.0, (228, 231, 235)),
    (0.15, (254, 217, 118)),
    (0.4, (253, 170, 72)),
    (0.7, (227, 74, 51)),
    (1.0, (127, 0, 38)),
)

#: The shares of the largest move for which the legend has a line.
LEGEND_SHARES = (1.0, 0.75, 0.5, 0.25, 0.1, 0.0)


@dataclass(frozen=True)
class Sample:
    """One colour of the legend."""

    rgb: tuple


def colour(share):
    """Return the colour of a share, 0..1, of the largest move as numbers 0..255.

    Shares outside 0..1 get the colour of the nearer end.
    """
    share = min(max(share, 0.0), 1.0)
    for (low, one), (high, other) in zip(RAMP, RAMP[1:]):
        if share <= high:
            part = (share - low) / (high - low)
            return tuple(a + part * (b - a) for a, b in zip(one, other))
    return RAMP[-1][1]


def colours(moves_mm, largest_mm):
    """Return the colour of each move as numbers 0..1."""
    scale = 1.0 / largest_mm if largest_mm > 0 else 0.0
    return [tuple(channel / 255 for channel in colour(move * scale)) for move in moves_mm]


def legend_entries(largest_mm):
    """Return [(Sample, "0.22 mm", "")], the largest move first; one line where nothing moved."""
    if largest_mm <= 0:
        return [(Sample(RAMP[0][1]), "0 mm", "")]
    return [
        (
            Sample(tuple(round(channel) for channel in colour(share))),
            "%s mm" % enclosure.number(share * largest_mm),
            "",
        )
        for share in LEGEND_SHARES
    ]


def legend_footer(moves, faces):
    """ "2 of 6 faces moved, poles by up to 0.3 mm".

    ``moves``: dicts of face and largest_move_mm.
    """
    if not moves:
        return tr("no face moved")
    largest = max(move["largest_move_mm"] for move in moves)
    return tr("{moves} of {faces} faces moved, poles by up to {largest} mm").format(
        moves=len(moves), faces=faces, largest=enclosure.number(largest)
    )
