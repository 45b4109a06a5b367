# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills of holes, and patches around a point."""

from ._core import n_sided_fill, ring_fill, three_sided_fill, umbrella, umbrella_inside
from .results import FillCorner, G1Connection, NSidedFill, RingFill, ThreeSidedFill, Umbrella

__all__ = [
    "FillCorner",
    "G1Connection",
    "NSidedFill",
    "RingFill",
    "ThreeSidedFill",
    "Umbrella",
    "n_sided_fill",
    "ring_fill",
    "three_sided_fill",
    "umbrella",
    "umbrella_inside",
]
