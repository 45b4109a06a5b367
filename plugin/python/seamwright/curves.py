# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves, and what is measured of one curve."""

from . import curve_from_freecad, curve_to_freecad
from ._core import (
    BSplineCurve,
    BernsteinPolynomial,
    BezierCurve,
    BezierSpline,
    arc_length,
    find_degeneracies,
    frenet_frame,
    parameter_at_length,
    rotation_minimizing_frames,
)
from .results import ArcLength, CurveDegeneracies, CurveInterval, FrenetFrame, MovingFrames

__all__ = [
    "ArcLength",
    "BSplineCurve",
    "BernsteinPolynomial",
    "BezierCurve",
    "BezierSpline",
    "CurveDegeneracies",
    "CurveInterval",
    "FrenetFrame",
    "MovingFrames",
    "arc_length",
    "curve_from_freecad",
    "curve_to_freecad",
    "find_degeneracies",
    "frenet_frame",
    "parameter_at_length",
    "rotation_minimizing_frames",
]
