# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of curves of the plane and of fairing."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional, Tuple

from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._core import (
        ArcChain,
        BezierSpline,
        BSplineCurve,
        ClothoidChain,
        MatrixCurve,
        PlanarConic,
    )

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
    least_arcs   no chain within the tolerance has fewer arcs
    """

    chain: ArcChain
    curve: BezierSpline
    distance_mm: float
    least_arcs: int


class SampledArcs(Result):
    """The lines and arcs of which points are samples; an argument ``curve``, ``chain`` of others.

    chain        an ArcChain
    curve        the same points as a BezierSpline
    distance_mm  no point is further from the chain
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


class ClothoidFit(Result):
    """Clothoids near a curve, G2 between corners.

    chain        a ClothoidChain
    corners      indices of pieces that begin at a corner; ends do not count
    distance_mm  bound of the distance in both directions
    """

    chain: ClothoidChain
    corners: Tuple[int, ...]
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


class SignedFigure(Result):
    """A computed number without a unit, or in rad, and a bound of its rounding.

    sign  1 or -1 if it is certain, otherwise 0
    """

    value: float
    rounding: float
    sign: int


class SpiralCertificate(Result):
    """Which short spirals join two ends, and the figures that decide.

    kind             "rising" or "falling": spirals exist, and the curvature of all of them grows
                     or falls; "arc" or "biarc": up to rounding it is the only one; "nothing": there
                     is none; "undecided": rounding hides a sign
    start_angle_rad  a, of the tangent against the chord, to the left above 0
    end_angle_rad    b, likewise
    turn_rad         a + b: SignedFigure; it has the sign of the change of the curvature (Vogt)
    start_excess     k l / 2 + sin a: SignedFigure, with the curvature k and the chord l
    end_excess       k l / 2 - sin b: SignedFigure
    separation       SignedFigure; below 0 the circles of curvature are nested, or apart (Kneser)
    """

    _kinds = {
        "turn_rad": SignedFigure,
        "start_excess": SignedFigure,
        "end_excess": SignedFigure,
        "separation": SignedFigure,
    }

    kind: str
    start_angle_rad: float
    end_angle_rad: float
    turn_rad: SignedFigure
    start_excess: SignedFigure
    end_excess: SignedFigure
    separation: SignedFigure


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
    status         "converged": no moves are left; "energy grows": filter_curvature() left out
                   passes that would make the energy grow; "not converged": the steps ran out
    converged      whether status is "converged"
    """

    _kinds = {"before": PointFairness, "after": PointFairness}

    points_mm: Array
    before: PointFairness
    after: PointFairness
    moved_mm: float
    most_moved: int
    steps: int
    status: str
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


class PolishedCurve(Result):
    """A curve whose curvature varies less; an argument ``curve`` of others.

    curve                     a BSplineCurve with the knots of the given one
    moved_mm                  bound of the distance of points of the same parameter
    before, after             CurveFairness
    variation_before_per_mm3  integral of (dk/ds)^2 + (k t)^2 by arc length, with the torsion t
    variation_after_per_mm3   likewise
    weight_per_mm5            of the squared distance against the variation
    steps                     of Gauss-Newton
    """

    _kinds = {"before": CurveFairness, "after": CurveFairness}

    curve: BSplineCurve
    moved_mm: float
    before: CurveFairness
    after: CurveFairness
    variation_before_per_mm3: float
    variation_after_per_mm3: float
    weight_per_mm5: float
    steps: int


class CurvatureVariation(Result):
    """How much the curvature of a curve varies.

    energy_per_mm3      integral of (dk/ds)^2 + (k t)^2 by arc length, with the torsion t;
                        infinite if the curve may stop
    extrema             of the curvature, inside of the segments
    extrema_at_joints   where the slope of the curvature changes its sign
    inflections         of planar curves
    undecided_segments  in which rounding hides a sign, or the curve may stop
    """

    energy_per_mm3: float
    extrema: int
    extrema_at_joints: int
    inflections: int
    undecided_segments: int


# Splines y(x)


class FunctionSpline(Result):
    """A cubic spline y(x); an argument ``points`` and ``curve`` of others.

    points_mm            (count, 2)
    slopes               dy/dx at both ends; None: natural ends, y'' = 0
    second_per_mm        (count,), y'' at the points
    third_jumps_per_mm2  (count - 2,), jumps of y''' at the points between the ends
    curve                a BSplineCurve (x, y, 0) with the parameter x
    """

    points_mm: Array
    slopes: Optional[Tuple[float, float]]
    second_per_mm: Array
    third_jumps_per_mm2: Array
    curve: BSplineCurve


class FunctionFairness(Result):
    """How fair a spline y(x) is.

    bending_per_mm  integral of y''^2
    jumps_per_mm2   sum of the sizes of the jumps of y'''
    curvature       CurveFairness: the integral of y'''^2, extrema and inflections
    """

    _kinds = {"curvature": CurveFairness}

    bending_per_mm: float
    jumps_per_mm2: float
    curvature: CurveFairness


class FairedFunction(Result):
    """A spline y(x) that was made fair; an argument ``points`` and ``curve`` of others.

    spline             FunctionSpline
    curve              a BSplineCurve (x, y, 0) with the parameter x
    moved_mm           bound of the change of y
    before, after      FunctionFairness
    steps              corrections that were tried; rebounds; iterations
    added_extrema      by how much the number of extrema of the curvature grew
    added_inflections  by how much the number of inflections grew
    """

    _kinds = {"spline": FunctionSpline, "before": FunctionFairness, "after": FunctionFairness}

    spline: FunctionSpline
    curve: BSplineCurve
    moved_mm: float
    before: FunctionFairness
    after: FunctionFairness
    steps: int
    added_extrema: int
    added_inflections: int


# Matrix weights


class MatrixFit(Result):
    """A matrix-weighted curve through points; an argument ``curve`` of others.

    curve               a MatrixCurve
    parameters          (count,), of the points
    missed_mm           the largest distance of a point from its point of the curve: rounding
    missed_tangent_rad  the largest angle between a tangent and that of the curve
    """

    curve: MatrixCurve
    parameters: Array
    missed_mm: float
    missed_tangent_rad: float


class HermitePoints(Result):
    """Points with tangents.

    points_mm, tangents  (count, 3)
    """

    points_mm: Array
    tangents: Array


class FairedHermite(Result):
    """Points with tangents that were made fair; an argument ``curve`` of others.

    points_mm, tangents  (count, 3)
    fit                  MatrixFit through them
    curve                the MatrixCurve of fit
    moved_mm             the largest move of a point
    before, after        CurvatureVariation of the curves through the points
    passes               that were made
    added_extrema        by how much the number of extrema grew, with those at joints
    added_inflections    by how much the number of inflections grew
    """

    _kinds = {"fit": MatrixFit, "before": CurvatureVariation, "after": CurvatureVariation}

    points_mm: Array
    tangents: Array
    fit: MatrixFit
    curve: MatrixCurve
    moved_mm: float
    before: CurvatureVariation
    after: CurvatureVariation
    passes: int
    added_extrema: int
    added_inflections: int
