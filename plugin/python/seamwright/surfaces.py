# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces, and what is measured at one point of a surface."""

from . import surface_from_freecad, surface_to_freecad
from ._core import (
    BSplineSurface,
    BezierPatch,
    BezierTriangle,
    SurfaceJet,
    curvature_tensor,
    principal_curvatures,
    surface_shape,
)
from .results import SurfaceShape

__all__ = [
    "BSplineSurface",
    "BezierPatch",
    "BezierTriangle",
    "SurfaceJet",
    "SurfaceShape",
    "curvature_tensor",
    "principal_curvatures",
    "surface_from_freecad",
    "surface_shape",
    "surface_to_freecad",
]
