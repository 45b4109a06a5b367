# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines through points and of polygons; alpha-curves and alpha-surfaces."""

from ._core import (
    BSplineCurve,
    BezierSpline,
    MatrixCurve,
    alpha_basis,
    alpha_curve,
    alpha_spline,
    alpha_surface,
    beta_spline,
    direct_g2_spline,
    energy_optimal_alpha,
    gamma_spline,
    nu_spline,
    spline_knots,
)
from .results import AlphaOptimum, InterpolatingSpline

__all__ = [
    "AlphaOptimum",
    "BSplineCurve",
    "BezierSpline",
    "InterpolatingSpline",
    "MatrixCurve",
    "alpha_basis",
    "alpha_curve",
    "alpha_spline",
    "alpha_surface",
    "beta_spline",
    "direct_g2_spline",
    "energy_optimal_alpha",
    "gamma_spline",
    "nu_spline",
    "spline_knots",
]
