# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of two surfaces and joints of two curves: measured, enclosed and judged."""

from ._core import (
    arc_length_derivatives,
    enclose_knot_lines,
    enclose_seam,
    measure_joint,
    measure_pair,
)
from .results import (
    CurveJoint,
    DegeneratePoint,
    EnclosedSeam,
    Figure,
    KnotLine,
    LeftOut,
    PairMeasure,
)

__all__ = [
    "CurveJoint",
    "DegeneratePoint",
    "EnclosedSeam",
    "Figure",
    "KnotLine",
    "LeftOut",
    "PairMeasure",
    "arc_length_derivatives",
    "enclose_knot_lines",
    "enclose_seam",
    "measure_joint",
    "measure_pair",
]
