# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of blends of curves and of lofts through frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional

from ._curve_results import EnclosedSeam
from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._core import BezierCurve, BezierSpline, BSplineSurface

    Array = npt.NDArray[np.float64]


class BalanceFault(Result):
    """Why a step of the balanced construction has no result, or loses digits.

    kind   "no ratio", "far point", "lost tangent", "negative beta" or "weights"
    level  k of the ratio delta_kj
    index  j of it
    value  "no ratio": the denominator as a share of the largest; "far point": the ratio; "lost
           tangent": the distance of poles as a share; "negative beta": beta_1; "weights": what
           weights miss, or a weight
    """

    kind: str
    level: int
    index: int
    value: float


class BalanceRatios(Result):
    """The ratios by which auxiliary points are cut down to poles of a G^n joint.

    delta        (n, n), lower triangular
    faults       missing and far ratios
    least_pivot  the smallest denominator by the largest coefficient: distance to a missing ratio
    can_cut      all ratios exist
    can_solve    none is far: auxiliary points can be found from poles
    """

    _kinds = {"faults": BalanceFault}

    delta: Array
    faults: List[BalanceFault]
    least_pivot: float
    can_cut: bool
    can_solve: bool


class AuxiliaryPoints(Result):
    """The auxiliary points of a G^n joint.

    points       (n + 1, 3), in mm
    residual_mm  the joint's own defect: the largest distance between points of neighbouring levels
    """

    points: Array
    residual_mm: float


class ShortestBlend(Result):
    """Where linear blending makes a tangent shortest.

    omega        0..1
    length_mm    there
    rounding_mm  bound of its error
    vanishes     the length is 0 up to rounding
    """

    omega: float
    length_mm: float
    rounding_mm: float
    vanishes: bool


class PlainBlend(Result):
    """What linear blending of all poles does to a joint.

    kind                  "equal betas", "parallel tangents", "equal beta_1" or "straight": the
                          condition by which the joint is kept; "none"
    keeps                 the joint is kept for all omega
    betas_defect          of the second joint with the betas of the first, without unit
    beta1_defect          the same of order 1 only
    angle_rad             between the tangents of the joints, 0..pi
    ratio                 of the speed of a in the second joint to that in the first
    bend                  the largest curvature, in units of the joint's length
    tangent_a, tangent_b  the blended first derivatives where they are shortest
    betas                 (n,) at each of the omegas; fewer numbers where beta_1 is not positive
    """

    _kinds = {"tangent_a": ShortestBlend, "tangent_b": ShortestBlend}

    kind: str
    keeps: bool
    betas_defect: float
    beta1_defect: float
    angle_rad: float
    ratio: float
    bend: float
    tangent_a: ShortestBlend
    tangent_b: ShortestBlend
    betas: List[Array]


class BlendedJoint(Result):
    """A joint between two joints.

    a, b      the curve that arrives and the one that leaves
    order     n of the G^n of the joint
    beta      (order,), beta_1 first
    defects   of order 0 to n, measured, without unit
    remedy    "plain", "balanced", "smallest move", "intermediate frame" or "intrinsic"
    moved_mm  largest distance of a pole from that of linear blending
    faults    why the balanced construction was not taken
    """

    _kinds = {"faults": BalanceFault}

    a: BezierCurve
    b: BezierCurve
    order: int
    beta: Array
    defects: List[float]
    remedy: str
    moved_mm: float
    faults: List[BalanceFault]


class SplineJoint(Result):
    """A joint of a blended spline.

    knot      index of its knot; of the joint that closes a spline, the last one
    order     n of the G^n of the joint
    beta      (order,), by the segments' parameters 0..1
    defects   of order 0 to n, measured, without unit
    remedy    "plain", "balanced", "smallest move", "intermediate frame" or "intrinsic"
    moved_mm  largest distance of a pole from that of linear blending
    faults    why the balanced construction was not taken
    """

    _kinds = {"faults": BalanceFault}

    knot: int
    order: int
    beta: Array
    defects: List[float]
    remedy: str
    moved_mm: float
    faults: List[BalanceFault]


class SplineFrame(Result):
    """A curve between key curves; an argument ``curve`` of others.

    curve   a BezierSpline
    joints  in the order of its measure_joints()
    """

    _kinds = {"joints": SplineJoint}

    curve: BezierSpline
    joints: List[SplineJoint]


class MatchSummary(Result):
    """How curves were matched.

    pieces_before     of each curve
    pieces_after      of all curves
    merged            joints that belong to several curves because they are close
    features          found in each curve
    matched_features  matched in all curves; given parameters count, too, and the start of closed
                      curves if it is a feature of one kind
    lengths_fit_better  by="features": features were found, but equal shares of the length
                      between corners correspond: with them the tangents at corresponding
                      places differ less
    unknown_pieces    whose curvature has no certain profile: no features from them
    reversed          which curves run in the other direction
    start             of each curve: where it starts now, a share of its length in its new direction
    largest_ratio     the largest quotient of the shares of the length of a piece in two curves
    """

    pieces_before: List[int]
    pieces_after: int
    merged: int
    features: List[int]
    matched_features: int
    lengths_fit_better: bool
    unknown_pieces: int
    reversed: List[bool]
    start: List[float]
    largest_ratio: float


class MatchedCurves(Result):
    """The same curves in corresponding pieces.

    curves   BezierSplines of one degree and one number of segments
    summary  how they were matched
    """

    _kinds = {"summary": MatchSummary}

    curves: List[BezierSpline]
    summary: MatchSummary


class CommonKnots(Result):
    """Curves over common knots near the given ones.

    curves       BezierSplines of degree 5 with equal knots 0..1
    distance_mm  a bound of the distance of each from its given curve, in both directions
    reached      all distances are within the tolerance
    summary      how they were matched; without merged and largest_ratio
    """

    _kinds = {"summary": MatchSummary}

    curves: List[BezierSpline]
    distance_mm: List[float]
    reached: bool
    summary: MatchSummary


class FrameLoft(Result):
    """A surface through frames.

    surface          a BSplineSurface: u runs along the frames, v is omega
    smooth_frames    the frames are C^n by equal knots, and so is the surface in u
    spans            in omega
    frames           how many were evaluated
    distance_mm      the largest distance of a frame that was checked from its iso-curve
    distance_at      omega of that frame
    proven_mm        a bound of it over all omega; None without a derivative bound
    reached          the distance (the proven one, if there is one) is within the tolerance
    ratios_positive  proven: the surface does not fold at a line of joints
    """

    surface: BSplineSurface
    smooth_frames: bool
    spans: int
    frames: int
    distance_mm: float
    distance_at: float
    proven_mm: Optional[float]
    reached: bool
    ratios_positive: bool


class KnotLine(Result):
    """How the parts of a surface on both sides of a knot meet.

    knot  the parameter
    seam  an EnclosedSeam
    """

    _kinds = {"seam": EnclosedSeam}

    knot: float
    seam: EnclosedSeam


class FrameRibbon(Result):
    """What a sheet has to meet at an end; an argument ``start`` and ``end`` of frame_sheet.

    position  the profile, a BezierSpline
    first     its first derivative by omega: the "points" are vectors
    second    its second derivative by omega
    """

    position: BezierSpline
    first: BezierSpline
    second: BezierSpline
