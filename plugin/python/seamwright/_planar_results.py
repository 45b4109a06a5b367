# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of curves of the plane and of fairing."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Tuple

from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._core import ArcChain, BezierSpline, BSplineCurve, ClothoidChain, PlanarConic

    Array = npt.NDArray[np.float64]


# Curves of the plane


class Biarc(Result):
    """Two arcs with one tangent at their joint; an argument of ``conics_of_arcs`` and others.

    chain      an ArcChain of both arcs
    joint_mm   (2,)
    x          the parameter of the family of biarcs, 0..1
    is_convex  whether both arcs turn to one side
    """

    chain: ArcChain
    joint_mm: Array
    x: float
    is_convex: bool


class PlanarTangents(Result):
    """Directions of tangents at points.

    directions_rad  (count,), against the first axis
    steps           Gauss-Newton steps
    """

    directions_rad: Array
    steps: int


class BiarcSpline(Result):
    """A biarc spline through points; an argument ``curve`` and ``chain`` of others.

    chain           an ArcChain: two arcs for each segment
    curve           the same points as a BezierSpline
    directions_rad  (count,), of the tangents at the points
    energy_per_mm   integral of the squared curvature by arc length
    """

    chain: ArcChain
    curve: BezierSpline
    directions_rad: Array
    energy_per_mm: float


class ArcFit(Result):
    """Arcs and lines near a curve; an argument ``curve`` and ``chain`` of others.

    chain        an ArcChain
    curve        the same points as a BezierSpline
    distance_mm  bound of the distance in both directions
    """

    chain: ArcChain
    curve: BezierSpline
    distance_mm: float


class SplineWithin(Result):
    """A spline that approximates another curve; an argument ``curve`` of others.

    curve        a BezierSpline
    distance_mm  bound of the distance of points of the same parameter
    """

    curve: BezierSpline
    distance_mm: float


class ClothoidSpline(Result):
    """A G2 spline of clothoids through points.

    chain                  a ClothoidChain: one piece for each segment
    directions_rad         (count,), of the tangents at the points
    steps                  Newton steps
    curvature_jump_per_mm  the largest that is left: rounding
    """

    chain: ClothoidChain
    directions_rad: Array
    steps: int
    curvature_jump_per_mm: float


class G2Conics(Result):
    """Conics that join G2; an argument ``curve`` and ``chain`` of others.

    conics           PlanarConics
    curve            the same points as a BezierSpline
    g1_joints        joints that stay G1: joint i is the start of conics[i]
    divisions        how many segments were divided
    least_weight     of all conics
    largest_weight   of all conics
    largest_move_mm  of the corners, of segments that were not divided
    """

    conics: List[PlanarConic]
    curve: BezierSpline
    g1_joints: List[int]
    divisions: int
    least_weight: float
    largest_weight: float
    largest_move_mm: float


# Fairing


class PointFairness(Result):
    """How fair a sequence of points is.

    energy_per_mm3    approximates the integral of (dk/ds)^2
    rounding_per_mm3  energy that rounding of the coordinates can make
    extrema           indices of points where the curvature has a local extremum
    inflections       indices of points before which the curvature changes its sign
    """

    energy_per_mm3: float
    rounding_per_mm3: float
    extrema: List[int]
    inflections: List[int]


class FairedPoints(Result):
    """Points that were moved to make them fair.

    points_mm      (count, 2)
    before, after  PointFairness
    moved_mm       the largest move
    most_moved     index of the point with that move
    steps          of the method
    converged      whether the steps reached their end
    """

    _kinds = {"before": PointFairness, "after": PointFairness}

    points_mm: Array
    before: PointFairness
    after: PointFairness
    moved_mm: float
    most_moved: int
    steps: int
    converged: bool


class CurvatureExtremum(Result):
    """An extremum of the curvature of a curve.

    lower, upper      parameters between which it lies
    maximum           whether it is a maximum
    curvature_per_mm  in the middle of the interval
    """

    lower: float
    upper: float
    maximum: bool
    curvature_per_mm: float


class CurvatureProfile(Result):
    """Where the curvature of a curve grows, falls and changes its sign, with certainty.

    extrema                CurvatureExtremum inside of the segments, in the order of the parameter
    inflections            (lower, upper): the curvature changes its sign once between them
    undecided_extrema      (lower, upper): rounding hides the sign of the curvature's derivative
    undecided_inflections  (lower, upper): rounding hides the sign of the curvature
    monotone               whether the curvature of each segment is certainly strictly monotone
    signed                 whether the curve is planar and its curvature has a sign
    """

    _kinds = {"extrema": CurvatureExtremum}

    extrema: List[CurvatureExtremum]
    inflections: List[Tuple[float, float]]
    undecided_extrema: List[Tuple[float, float]]
    undecided_inflections: List[Tuple[float, float]]
    monotone: bool
    signed: bool


class CurveFairness(Result):
    """How fair a polynomial B-spline curve is.

    energy            integral of the squared derivative of order min(3, degree) by the parameter
    extrema           of the curvature, inside of the spans
    extrema_at_knots  where the slope of the curvature changes its sign
    inflections       of planar curves
    undecided_spans   in which rounding hides a sign, or the curve may stop
    """

    energy: float
    extrema: int
    extrema_at_knots: int
    inflections: int
    undecided_spans: int


class FairedCurve(Result):
    """A curve that was made fair; an argument ``curve`` of others.

    curve          a BSplineCurve with the knots of the given one
    moved_mm       bound of the distance of points of the same parameter
    smoothing      weight of the energy, of fair_curve()
    before, after  CurveFairness
    steps          of the method
    """

    _kinds = {"before": CurveFairness, "after": CurveFairness}

    curve: BSplineCurve
    moved_mm: float
    smoothing: float
    before: CurveFairness
    after: CurveFairness
    steps: int
