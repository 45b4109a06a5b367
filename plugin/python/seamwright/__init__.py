# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and measures the seams of CAD models: how well neighbouring faces join.

>>> import seamwright
>>> report = seamwright.read("part.step").analyze(profile="class-a", angle_deg=0.05)
>>> print(report.to_table())

Lengths are in mm. Angles are in degrees if a name ends in ``_deg``, in radians if it ends in
``_rad``. Bad arguments raise ``ValueError``, bad models ``ModelError``; both state the offending
number. Long calls release the GIL and take ``progress``, a callable that gets the share done
(0..1). The call raises ``Cancelled`` if the callable returns a value that is false in Python
(``False``, ``0``, ``numpy.False_``), other than ``None``.
"""

try:
    from . import _core
except ImportError as error:
    import sys
    import sysconfig

    raise ImportError(
        "the compiled part of seamwright does not load in this Python "
        f"({sys.version.split()[0]}, {sysconfig.get_config_var('SOABI')}): {error}. "
        "Build Seamwright for this Python and its OpenCASCADE, or use the command 'seamwright' through files."
    ) from error

from . import bridge
from ._core import (
    OCCT_VERSION,
    PROFILES,
    BSplineCurve,
    BSplineSurface,
    BernsteinPolynomial,
    BezierCurve,
    BezierPatch,
    BezierSpline,
    BezierTriangle,
    Cancelled,
    CornerFillet,
    DisplayMesh,
    FillReport,
    MatchResult,
    Model,
    ModelError,
    RepairReport,
    Report,
    alpha_basis,
    alpha_curve,
    alpha_join_poles,
    alpha_join_rows,
    alpha_nearest_join,
    alpha_seam_condition,
    alpha_seam_fit,
    alpha_sliding_rows,
    alpha_spline,
    alpha_surface,
    arc_length,
    arc_length_derivatives,
    beta_matrix,
    beta_spline,
    blend,
    bridge_curve,
    composed_beta,
    continuation,
    curvature_tensor,
    direct_g2_spline,
    enclose_seam,
    energy_optimal_alpha,
    find_degeneracies,
    fit_beta,
    fit_connection,
    frenet_frame,
    gamma_spline,
    inverse_beta,
    join_condition,
    join_rows,
    joined,
    joined_curve,
    knots_of,
    measure_joint,
    measure_pair,
    n_sided_fill,
    nearest_curve_join,
    nearest_join,
    next_poles,
    nu_spline,
    orient,
    parameter_at_length,
    principal_curvatures,
    read,
    reversed_beta,
    ring_fill,
    rotation_minimizing_frames,
    surface_shape,
    three_sided_fill,
    triangle_continuation,
    umbrella,
    umbrella_inside,
)
from ._core import __version__


def _from_freecad(shape):
    """The model of a FreeCAD ``Part.Shape``.

    The shape is shared if the bridge allows it, and never changed.

    Raises ``TypeError`` for anything but a ``Part.Shape``, ``ModelError`` for a null shape or a
    shape without faces.
    """
    return bridge.model_from_freecad(shape)


def _to_freecad(self):
    """This model as a FreeCAD ``Part.Shape``; shared, not copied, if the bridge allows it."""
    return bridge.model_to_freecad(self)


def curve_to_freecad(curve):
    """A curve as a FreeCAD curve.

    A BezierCurve becomes a ``Part.BezierCurve``, a BSplineCurve a ``Part.BSplineCurve``, and a
    BezierSpline the ``Part.BSplineCurve`` of ``to_bspline(continuity())``. Poles, weights and knots
    are the same numbers.

    Raises ``ValueError`` for degrees above 25, ``TypeError`` for other arguments, ``RuntimeError``
    outside FreeCAD.
    """
    return bridge.curve_to_freecad(curve)


def curve_from_freecad(curve):
    """A ``Part.BezierCurve`` or ``Part.BSplineCurve`` as BezierCurve or BSplineCurve.

    The numbers are the same. If the curve is periodic or not clamped, knots are inserted at its
    ends. For an edge, pass ``edge.Curve``; trims are ignored.

    Raises ``TypeError`` for other arguments, ``RuntimeError`` outside FreeCAD.
    """
    return bridge.curve_from_freecad(curve)


def surface_to_freecad(patch):
    """A BezierPatch as ``Part.BezierSurface``: the same poles and weights.

    Raises ``ValueError`` for degrees above 25, ``TypeError`` for other arguments, ``RuntimeError``
    outside FreeCAD.
    """
    return bridge.surface_to_freecad(patch)


def surface_from_freecad(surface):
    """A ``Part.BezierSurface`` as BezierPatch: the same poles and weights.

    Raises ``TypeError`` for other arguments, ``RuntimeError`` outside FreeCAD.
    """
    return bridge.surface_from_freecad(surface)


Model.from_freecad = staticmethod(_from_freecad)
Model.to_freecad = _to_freecad

__all__ = [
    "OCCT_VERSION",
    "PROFILES",
    "BSplineCurve",
    "BSplineSurface",
    "BernsteinPolynomial",
    "BezierCurve",
    "BezierPatch",
    "BezierSpline",
    "BezierTriangle",
    "Cancelled",
    "CornerFillet",
    "DisplayMesh",
    "FillReport",
    "MatchResult",
    "Model",
    "ModelError",
    "RepairReport",
    "Report",
    "__version__",
    "alpha_basis",
    "alpha_curve",
    "alpha_join_poles",
    "alpha_join_rows",
    "alpha_nearest_join",
    "alpha_seam_condition",
    "alpha_seam_fit",
    "alpha_sliding_rows",
    "alpha_spline",
    "alpha_surface",
    "arc_length",
    "arc_length_derivatives",
    "beta_matrix",
    "beta_spline",
    "blend",
    "bridge",
    "bridge_curve",
    "composed_beta",
    "continuation",
    "curvature_tensor",
    "curve_from_freecad",
    "curve_to_freecad",
    "direct_g2_spline",
    "enclose_seam",
    "energy_optimal_alpha",
    "find_degeneracies",
    "fit_beta",
    "fit_connection",
    "frenet_frame",
    "gamma_spline",
    "inverse_beta",
    "join_condition",
    "join_rows",
    "joined",
    "joined_curve",
    "knots_of",
    "measure_joint",
    "measure_pair",
    "n_sided_fill",
    "nearest_curve_join",
    "nearest_join",
    "next_poles",
    "nu_spline",
    "orient",
    "parameter_at_length",
    "principal_curvatures",
    "read",
    "reversed_beta",
    "ring_fill",
    "rotation_minimizing_frames",
    "surface_from_freecad",
    "surface_shape",
    "surface_to_freecad",
    "three_sided_fill",
    "triangle_continuation",
    "umbrella",
    "umbrella_inside",
]
