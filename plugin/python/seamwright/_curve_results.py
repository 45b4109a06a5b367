# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of seams and joints, curves and surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional, Tuple, Union

from ._model_results import Figure, LeftOut
from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._core import BezierCurve, BSplineCurve

    Array = npt.NDArray[np.float64]
    Number = Union[float, Array]  # an array if the parameter was an array


# Seams and joints


class PairMeasure(Result):
    """How two surface jets differ.

    gap_mm                        distance of the points
    angle_rad                     between the tangent planes, 0..pi/2
    curvature_per_mm              largest difference of normal curvature
    norm_a_per_mm, norm_b_per_mm  largest normal curvature of each side
    degenerate_a, degenerate_b    "none", or why a side has no tangent plane
    """

    gap_mm: float
    angle_rad: Optional[float]
    curvature_per_mm: Optional[float]
    norm_a_per_mm: Optional[float]
    norm_b_per_mm: Optional[float]
    degenerate_a: str
    degenerate_b: str


class DegeneratePoint(Result):
    """A point of a seam at which a side has no tangent plane: at 0..1, and why."""

    at: float
    side_a: str
    side_b: str


class EnclosedSeam(Result):
    """The seam of two surfaces, enclosed and judged: see Seam for the attributes.

    degenerate  points without a tangent plane
    """

    _keys = {"seam_class": "class"}
    _kinds = {
        "gap_mm": Figure,
        "angle_deg": Figure,
        "curvature_per_mm": Figure,
        "curvature_rel": Figure,
        "curvature_change_per_mm2": Figure,
        "curvature_change_rel": Figure,
        "left_out": LeftOut,
        "degenerate": DegeneratePoint,
    }

    gap_mm: Optional[Figure]
    angle_deg: Optional[Figure]
    curvature_per_mm: Optional[Figure]
    curvature_rel: Optional[Figure]
    curvature_change_per_mm2: Optional[Figure]
    curvature_change_rel: Optional[Figure]
    left_out: LeftOut
    level: str
    seam_class: str
    certified: bool
    degenerate: List[DegeneratePoint]
    note: str


class CurveJoint(Result):
    """How the end of a curve meets the beginning of another one.

    gap_mm         distance of the points
    angle_rad      between the tangents, 0..pi
    differences    of the derivatives by arc length, of order k in mm^(1-k); [] without a tangent
    sizes          the larger of both derivatives, in mm^(1-k)
    order_reached  n of G^n by the tolerances; -1: the points do not meet
    """

    gap_mm: Optional[float]
    angle_rad: Optional[float]
    differences: List[float]
    sizes: List[float]
    order_reached: int


# Curves


class FrenetFrame(Result):
    """Frenet frame, curvature and torsion of a curve at a parameter, with bounds of their errors.

    kind                           "regular", "inflection", "cusp" or "point"
    speed_mm                       |dX/dt|; item "speed"
    tangent, normal, binormal      unit vectors (3,)
    curvature_per_mm               1/mm
    torsion_per_mm                 1/mm
    curvature_change_per_mm2       by arc length, 1/mm^2
    speed_error_mm (item "speed_error"), tangent_error_rad, binormal_error_rad, ...
                                   bounds of the errors

    At an array of parameters each value is an array of its shape, with nan for what does not exist.
    """

    _keys = {"speed_mm": "speed", "speed_error_mm": "speed_error"}
    _shapes = {
        "kind": (),
        "speed": (),
        "speed_error": (),
        "tangent": (3,),
        "tangent_error_rad": (),
        "normal": (3,),
        "binormal": (3,),
        "binormal_error_rad": (),
        "curvature_per_mm": (),
        "curvature_error_per_mm": (),
        "torsion_per_mm": (),
        "torsion_error_per_mm": (),
        "curvature_change_per_mm2": (),
        "curvature_change_error_per_mm2": (),
    }

    kind: Union[str, npt.NDArray[np.str_]]
    speed_mm: Number
    speed_error_mm: Number
    tangent: Optional[Array]
    tangent_error_rad: Optional[Number]
    normal: Optional[Array]
    binormal: Optional[Array]
    binormal_error_rad: Optional[Number]
    curvature_per_mm: Optional[Number]
    curvature_error_per_mm: Optional[Number]
    torsion_per_mm: Optional[Number]
    torsion_error_per_mm: Optional[Number]
    curvature_change_per_mm2: Optional[Number]
    curvature_change_error_per_mm2: Optional[Number]


class CurveInterval(Result):
    """Parameters first..last at which a curve may have no Frenet frame.

    kind  "inflection", "cusp" or "point"
    """

    kind: str
    first: float
    last: float


class CurveDegeneracies(Result):
    """Where a curve has no Frenet frame.

    intervals       CurveIntervals in increasing order; item "places"
    straight        the whole curve is straight
    speed_lower_mm  a bound of |dX/dt|, 0 if there are cusps; item "speed_lower"
    """

    _keys = {"intervals": "places", "speed_lower_mm": "speed_lower"}
    _kinds = {"places": CurveInterval}

    intervals: List[CurveInterval]
    straight: bool
    speed_lower_mm: float


class ArcLength(Result):
    """The length of a curve.

    value_mm            the best estimate
    lower_mm, upper_mm  the length is certainly between them
    reached             they are as near as the tolerance

    For arrays of ends each value is an array.
    """

    _shapes = {"value_mm": (), "lower_mm": (), "upper_mm": (), "reached": ()}

    value_mm: Number
    lower_mm: Number
    upper_mm: Number
    reached: Union[bool, npt.NDArray[np.bool_]]


class MovingFrames(Result):
    """Frames along a curve that do not turn about its tangent.

    parameters                   (n,)
    points_mm                    (n, 3); item "points"
    tangents, normals, binormals (n, 3), unit vectors
    """

    _keys = {"points_mm": "points"}

    parameters: Array
    points_mm: Array
    tangents: Array
    normals: Array
    binormals: Array


class BetaFit(Result):
    """The betas of a joint of two curves, an argument ``beta`` of others.

    beta          (n,), beta_1 first; (0,) for a cusp or where a tangent is lost
    defects       |c_k of b - c_k of a| L^(k-1) for k = 0..n, without unit
    lower, upper  certain bounds of the defects
    length_mm     L
    """

    beta: Array
    defects: List[float]
    lower: List[float]
    upper: List[float]
    length_mm: float


class NearestCurveJoin(Result):
    """The smallest move of poles that joins two curves; an argument ``beta`` of others.

    a, b             the curves
    beta             (n,), beta_1 first
    status           "solved", "infeasible" or "not converged"
    cost_mm2         half the sum of cost times squared move; item "cost"
    largest_move_mm  of a pole
    residual         largest defect, without unit
    gradient         share of the move along other joins, without unit
    iterations       steps of the search
    reason           why it is not solved, or ""
    """

    _keys = {"cost_mm2": "cost"}

    a: Union[BezierCurve, BSplineCurve]
    b: Union[BezierCurve, BSplineCurve]
    beta: Array
    status: str
    cost_mm2: float
    largest_move_mm: float
    residual: float
    gradient: float
    iterations: int
    reason: str


# Surfaces


class SurfaceShape(Result):
    """Normal and curvature of a surface at a point, with bounds of their errors.

    degeneracy                   "none", "vanishing normal" or "not finite"
    normal                       unit vector (3,)
    normal_error_rad             bound
    tensor_per_mm                curvature tensor (3, 3); item "tensor"
    tensor_error_per_mm          bound of the error of any normal curvature
    principal_curvatures_per_mm  (k1, k2), k1 >= k2
    curvature_change_per_mm2     along the direction
    curvature_change_error_per_mm2

    At arrays of parameters each value is an array, with nan for what does not exist.
    """

    _keys = {"tensor_per_mm": "tensor"}
    _shapes = {
        "degeneracy": (),
        "normal": (3,),
        "normal_error_rad": (),
        "tensor": (3, 3),
        "tensor_error_per_mm": (),
        "principal_curvatures_per_mm": (2,),
        "curvature_change_per_mm2": (),
        "curvature_change_error_per_mm2": (),
    }

    degeneracy: Union[str, npt.NDArray[np.str_]]
    normal: Optional[Array]
    normal_error_rad: Optional[Number]
    tensor_per_mm: Optional[Array]
    tensor_error_per_mm: Optional[Number]
    principal_curvatures_per_mm: Union[None, Tuple[float, float], Array]
    curvature_change_per_mm2: Optional[Number]
    curvature_change_error_per_mm2: Optional[Number]
