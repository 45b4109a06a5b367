# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fair points and curves are, and fairer ones within a tolerance."""

from ._core import (
    curvature_profile,
    curve_fairness,
    fair_at_knot,
    fair_at_knots,
    fair_curve,
    fair_points,
    filter_curvature,
    isolated_inflections,
    point_curvatures,
    point_fairness,
    smoothing_spline,
)
from .results import (
    CurvatureExtremum,
    CurvatureProfile,
    CurveFairness,
    FairedCurve,
    FairedPoints,
    PointFairness,
)

__all__ = [
    "CurvatureExtremum",
    "CurvatureProfile",
    "CurveFairness",
    "FairedCurve",
    "FairedPoints",
    "PointFairness",
    "curvature_profile",
    "curve_fairness",
    "fair_at_knot",
    "fair_at_knots",
    "fair_curve",
    "fair_points",
    "filter_curvature",
    "isolated_inflections",
    "point_curvatures",
    "point_fairness",
    "smoothing_spline",
]
