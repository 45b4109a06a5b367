# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and measures the seams of CAD models: how well neighbouring faces join.

>>> import seamwright
>>> report = seamwright.read("part.step").analyze(profile="class-a", angle_deg=0.05)
>>> print(report.to_table())

The modules ``models``, ``seams``, ``curves``, ``surfaces``, ``joins``, ``splines``, ``blends``,
``planar``, ``fairing`` and ``fills`` hold the same names by topic, ``results`` the classes of
results.

Lengths are in mm. Angles are in degrees if a name ends in ``_deg``, in radians if it ends in
``_rad``. Bad arguments raise ``ValueError``, bad models ``ModelError``; both state the offending
number. Long calls release the GIL and take ``progress``, a callable that gets the share done
(0..1). The call raises ``Cancelled`` if the callable returns a value that is false in Python
(``False``, ``0``, ``numpy.False_``), other than ``None``.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Union

try:
    from . import _core
except ImportError as error:
    import sys
    import sysconfig

    raise ImportError(
        "the compiled part of seamwright does not load in this Python "
        f"({sys.version.split()[0]}, {sysconfig.get_config_var('SOABI')}): {error}. "
        "Build Seamwright for this Python and its OpenCASCADE, or use the command 'seamwright' "
        "through files."
    ) from error

from . import bridge
from ._core import (
    OCCT_VERSION,
    ArcChain,
    BSplineCurve,
    BSplineSurface,
    BernsteinPolynomial,
    BezierCurve,
    BezierPatch,
    BezierSpline,
    BezierTriangle,
    BlendedSurface,
    Cancelled,
    Clothoid,
    ClothoidChain,
    CornerFillet,
    DisplayMesh,
    FillReport,
    JointBlend,
    LogSpiral,
    MatchResult,
    MatrixCurve,
    Model,
    ModelError,
    PlanarArc,
    PlanarConic,
    RepairReport,
    Report,
    SideMatchResult,
    SplineBlend,
    SurfaceJet,
    alpha_basis,
    alpha_curve,
    alpha_join_poles,
    alpha_join_rows,
    alpha_nearest_join,
    alpha_seam_condition,
    alpha_sliding_rows,
    alpha_spline,
    alpha_surface,
    arc_length,
    arc_length_derivatives,
    arc_through,
    auxiliary_points,
    balance_ratios,
    balance_relations,
    balanced_poles,
    beta_matrix,
    beta_spline,
    biarc,
    biarc_spline,
    bilens_rad,
    blend,
    blend_joint,
    clothoid,
    clothoid_spline,
    common_knots,
    composed_beta,
    conics_of_arcs,
    continuation,
    correct_function,
    correct_function_at,
    curvature_profile,
    curvature_tensor,
    curvature_variation,
    curve_blend,
    curve_fairness,
    curve_join_poles,
    curve_joined,
    curve_nearest_join,
    direct_g2_spline,
    edge_pairs,
    edge_patches,
    edge_ribbon,
    enclose_knot_lines,
    enclose_seam,
    energy_optimal_alpha,
    euler_arcs,
    even_rate,
    fair_at_knot,
    fair_at_knots,
    fair_curve,
    fair_hermite,
    fair_points,
    filter_curvature,
    find_degeneracies,
    fit_alpha_seam,
    fit_arcs,
    fit_clothoids,
    fit_beta,
    fit_connection,
    fit_hermite,
    frame_loft,
    frame_sheet,
    frenet_frame,
    function_fairness,
    g2_umbrella,
    function_spline,
    g2_conics,
    gamma_spline,
    inverse_beta,
    isolated_inflections,
    join_condition,
    join_rows,
    joined,
    log_arcs,
    log_spiral,
    match_pieces,
    matrix_pass,
    measure_joint,
    measure_pair,
    n_sided_fill,
    nearest_join,
    nu_spline,
    orient,
    parameter_at_length,
    plain_blend,
    planar_tangents,
    point_corners,
    point_curvatures,
    point_fairness,
    polish_curve,
    polish_function,
    polished_poles,
    principal_curvatures,
    read,
    rebound_function,
    rebounded,
    reversed_beta,
    ring_fill,
    rotation_minimizing_frames,
    sampled_arcs,
    smoothing_spline,
    spiral_certificate,
    spline_knots,
    surface_shape,
    three_sided_fill,
    triangle_continuation,
    turn_through_rad,
    two_conics,
    umbrella,
    umbrella_inside,
    umbrella_twists,
)
from ._core import __version__
from .results import Tolerances

#: The tolerances of each profile, by name.
PROFILES = MappingProxyType(
    {name: Tolerances(values) for name, values in _core.PROFILES.items()}
)

# Names of earlier versions.
alpha_seam_fit = fit_alpha_seam
bridge_curve = curve_blend
joined_curve = curve_joined
knots_of = spline_knots
nearest_curve_join = curve_nearest_join
next_poles = curve_join_poles


def _from_freecad(shape: Any) -> Model:
    """The model of a FreeCAD ``Part.Shape``.

    The shape is shared if the bridge allows it, and never changed.

    Raises ``TypeError`` for anything but a ``Part.Shape``, ``ModelError`` for a null shape or a
    shape without faces.
    """
    return bridge.model_from_freecad(shape)


def _to_freecad(self: Model) -> Any:
    """This model as a FreeCAD ``Part.Shape``; shared, not copied, if the bridge allows it."""
    return bridge.model_to_freecad(self)


def curve_to_freecad(curve: _core.Curve) -> Any:
    """A curve as a FreeCAD curve.

    A BezierCurve becomes a ``Part.BezierCurve``, a BSplineCurve a ``Part.BSplineCurve``, and a
    BezierSpline the ``Part.BSplineCurve`` of ``to_bspline(continuity())``. Poles, weights and knots
    are the same numbers.

    Raises ``ValueError`` for degrees above 25, ``TypeError`` for other arguments, ``RuntimeError``
    outside FreeCAD.
    """
    return bridge.curve_to_freecad(curve)


def curve_from_freecad(curve: Any) -> Union[BezierCurve, BSplineCurve]:
    """A ``Part.BezierCurve`` or ``Part.BSplineCurve`` as BezierCurve or BSplineCurve.

    The numbers are the same. If the curve is periodic or not clamped, knots are inserted at its
    ends. For an edge, pass ``edge.Curve``; trims are ignored.

    Raises ``TypeError`` for other arguments, ``RuntimeError`` outside FreeCAD.
    """
    return bridge.curve_from_freecad(curve)


def surface_to_freecad(patch: BezierPatch) -> Any:
    """A BezierPatch as ``Part.BezierSurface``: the same poles and weights.

    Raises ``ValueError`` for degrees above 25, ``TypeError`` for other arguments, ``RuntimeError``
    outside FreeCAD.
    """
    return bridge.surface_to_freecad(patch)


def surface_from_freecad(surface: Any) -> BezierPatch:
    """A ``Part.BezierSurface`` as BezierPatch: the same poles and weights.

    Raises ``TypeError`` for other arguments, ``RuntimeError`` outside FreeCAD.
    """
    return bridge.surface_from_freecad(surface)


# The stub of _core says that they are methods, so they are set by name.
setattr(Model, "from_freecad", staticmethod(_from_freecad))
setattr(Model, "to_freecad", _to_freecad)

from . import (  # noqa: E402
    blends,
    curves,
    fairing,
    fills,
    joins,
    models,
    planar,
    results,
    seams,
    splines,
    surfaces,
)

__all__ = [
    "ArcChain",
    "BSplineCurve",
    "BSplineSurface",
    "BernsteinPolynomial",
    "BezierCurve",
    "BezierPatch",
    "BezierSpline",
    "BezierTriangle",
    "BlendedSurface",
    "Cancelled",
    "Clothoid",
    "ClothoidChain",
    "CornerFillet",
    "DisplayMesh",
    "FillReport",
    "JointBlend",
    "LogSpiral",
    "MatchResult",
    "MatrixCurve",
    "Model",
    "ModelError",
    "OCCT_VERSION",
    "PROFILES",
    "PlanarArc",
    "PlanarConic",
    "RepairReport",
    "Report",
    "SideMatchResult",
    "SplineBlend",
    "SurfaceJet",
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
    "arc_through",
    "auxiliary_points",
    "balance_ratios",
    "balance_relations",
    "balanced_poles",
    "beta_matrix",
    "beta_spline",
    "biarc",
    "biarc_spline",
    "bilens_rad",
    "blend",
    "blend_joint",
    "blends",
    "bridge",
    "bridge_curve",
    "clothoid",
    "clothoid_spline",
    "common_knots",
    "composed_beta",
    "conics_of_arcs",
    "continuation",
    "correct_function",
    "correct_function_at",
    "curvature_profile",
    "curvature_tensor",
    "curvature_variation",
    "curve_blend",
    "curve_fairness",
    "curve_from_freecad",
    "curve_join_poles",
    "curve_joined",
    "curve_nearest_join",
    "curve_to_freecad",
    "curves",
    "direct_g2_spline",
    "edge_pairs",
    "edge_patches",
    "edge_ribbon",
    "enclose_knot_lines",
    "enclose_seam",
    "energy_optimal_alpha",
    "euler_arcs",
    "even_rate",
    "fair_at_knot",
    "fair_at_knots",
    "fair_curve",
    "fair_hermite",
    "fair_points",
    "fairing",
    "fills",
    "filter_curvature",
    "find_degeneracies",
    "fit_alpha_seam",
    "fit_arcs",
    "fit_clothoids",
    "fit_beta",
    "fit_connection",
    "fit_hermite",
    "frame_loft",
    "frame_sheet",
    "frenet_frame",
    "function_fairness",
    "g2_umbrella",
    "function_spline",
    "g2_conics",
    "gamma_spline",
    "inverse_beta",
    "isolated_inflections",
    "join_condition",
    "join_rows",
    "joined",
    "joined_curve",
    "joins",
    "knots_of",
    "log_arcs",
    "log_spiral",
    "match_pieces",
    "matrix_pass",
    "measure_joint",
    "measure_pair",
    "models",
    "n_sided_fill",
    "nearest_curve_join",
    "nearest_join",
    "next_poles",
    "nu_spline",
    "orient",
    "parameter_at_length",
    "plain_blend",
    "planar",
    "planar_tangents",
    "point_corners",
    "point_curvatures",
    "point_fairness",
    "polish_curve",
    "polish_function",
    "polished_poles",
    "principal_curvatures",
    "read",
    "rebound_function",
    "rebounded",
    "results",
    "reversed_beta",
    "ring_fill",
    "rotation_minimizing_frames",
    "sampled_arcs",
    "seams",
    "smoothing_spline",
    "spiral_certificate",
    "spline_knots",
    "splines",
    "surface_from_freecad",
    "surface_shape",
    "surface_to_freecad",
    "surfaces",
    "three_sided_fill",
    "triangle_continuation",
    "turn_through_rad",
    "two_conics",
    "umbrella",
    "umbrella_inside",
    "umbrella_twists",
]
