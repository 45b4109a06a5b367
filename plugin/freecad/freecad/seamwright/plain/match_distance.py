# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distance within which to match free edges, found from the gaps of edges side by side."""

import math

#: Of a seam with a gap of at least this part of the distance that was tried, the edges may go on to
#: diverge.
CUT_OFF = 0.9

#: Gaps that differ by at least this factor are of two kinds: those of edges that were meant to
#: meet, and those of edges that only pass each other.
STEP = 30.0

#: The proposal is this much larger than the gaps.
ROOM = 2.0


def proposed(seams, tried_mm, least_mm):
    """Return the distance in mm to propose, or None where no edges lie side by side.

    ``seams``: matched seams of the report of a model without shared edges, found within
    ``tried_mm``. ``least_mm``: the proposal is not smaller; gaps below it are not told apart.
    """
    gaps = sorted(max(seam["gap_mm"]["lower"], least_mm) for seam in seams if seam["gap_mm"])
    gaps = [gap for gap in gaps if gap < CUT_OFF * tried_mm]
    if not gaps:
        return None
    meant = gaps[0]
    for gap in gaps:
        if gap > STEP * meant:
            break
        meant = gap
    return min(_rounded_up(ROOM * meant), tried_mm)


def _rounded_up(value):
    """Return the next of 1, 2, 5, 10, 20, 50... that is not smaller."""
    power = 10.0 ** math.floor(math.log10(value))
    step = next(step for step in (1, 2, 5, 10) if step * power >= value * (1 - 1e-9))
    return float("%g" % (step * power))
