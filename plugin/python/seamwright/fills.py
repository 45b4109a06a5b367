# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills of holes, and patches around a point."""

from ._core import (
    g2_umbrella,
    n_sided_fill,
    ring_fill,
    three_sided_fill,
    umbrella,
    umbrella_inside,
    umbrella_twists,
)
from .results import (
    FillCorner,
    G1Connection,
    G2Connection,
    G2Umbrella,
    NSidedFill,
    RingFill,
    ThreeSidedFill,
    Umbrella,
    UmbrellaTwists,
)

__all__ = [
    "FillCorner",
    "G1Connection",
    "G2Connection",
    "G2Umbrella",
    "NSidedFill",
    "RingFill",
    "ThreeSidedFill",
    "Umbrella",
    "UmbrellaTwists",
    "g2_umbrella",
    "n_sided_fill",
    "ring_fill",
    "three_sided_fill",
    "umbrella",
    "umbrella_inside",
    "umbrella_twists",
]
