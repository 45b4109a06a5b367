# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of two surfaces and joints of two curves: measured, enclosed and judged."""

from ._core import arc_length_derivatives, enclose_seam, measure_joint, measure_pair
from .results import CurveJoint, DegeneratePoint, EnclosedSeam, Figure, LeftOut, PairMeasure

__all__ = [
    "CurveJoint",
    "DegeneratePoint",
    "EnclosedSeam",
    "Figure",
    "LeftOut",
    "PairMeasure",
    "arc_length_derivatives",
    "enclose_seam",
    "measure_joint",
    "measure_pair",
]
