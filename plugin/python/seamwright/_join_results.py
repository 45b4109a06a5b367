# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of joins, splines and fills."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional, Tuple, Union

from ._result import Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._core import BezierCurve, BezierPatch, BezierSpline, BezierTriangle, BSplineSurface

    Array = npt.NDArray[np.float64]


# Joins


class G1Connection(Result):
    """Bernstein coefficients of the functions of a G1 join: Q_s = alpha P_s + beta P_t.

    An argument ``connection`` of others.
    """

    alpha: Array
    beta: Array


class Connection(G1Connection):
    """Bernstein coefficients of the functions of a join of order 1 to 3; see ``join_rows``."""

    p: Array
    q: Array
    h: Array
    k: Array
    e0: Array
    e1: Array
    e2: Array
    e3: Array


class NearestJoin(Connection):
    """The smallest move of poles that joins two surfaces; an argument ``connection`` of others.

    a, b             the surfaces
    status           "joined", "unchanged", "infeasible" or "not converged"
    alpha, ..., e3   the functions that connect them
    largest_move_mm  of a pole
    cost_mm2         sum of weight times squared move; item "cost"
    residual         of the equations, without unit
    stationarity     how far the move is from the smallest one, without unit
    iterations       steps of the search
    raised_degree_a, raised_degree_b
                     by how much the degree along the seam was raised
    added_knots_a, added_knots_b
                     knots that the surface got along the seam besides, in its parameter
    moved_knots_a, moved_knots_b
                     largest change of a knot that became one of the other side, as a share of
                     the range
    parameter        None, or of sides that run along the seam at different speeds the map of the
                     parameter of b as in JoinCondition
    """

    _keys = {"cost_mm2": "cost"}

    a: Union[BezierPatch, BSplineSurface]
    b: Union[BezierPatch, BSplineSurface]
    status: str
    largest_move_mm: float
    cost_mm2: float
    residual: float
    stationarity: float
    iterations: int
    raised_degree_a: int
    raised_degree_b: int
    added_knots_a: List[float]
    added_knots_b: List[float]
    moved_knots_a: float
    moved_knots_b: float
    parameter: Optional[dict]

    @property
    def connection(self) -> Connection:
        """The functions alone."""
        keys = ("alpha", "beta", "p", "q", "h", "k", "e0", "e1", "e2", "e3")
        return Connection({key: self[key] for key in keys})


class JoinResidual(Result):
    """What is left of a condition.

    holds         it holds
    relative      largest coefficient relative to its terms
    noise         what rounding makes of 0
    at            0..1 along the seam
    coefficients  Bernstein coefficients
    """

    holds: bool
    relative: float
    noise: float
    at: float
    coefficients: Array


class JoinCondition(Result):
    """Whether two surfaces join.

    verdict           "G1", "fold", "not G1" or "singular"
    g2, g3            they join G2, G3; g3 is None where the degrees are too high to tell
    parametric_order  n of C^n
    gap_bound_mm      bound of the gap
    angle_bound_rad   bound of the angle
    singular_at       0..1, where a side has no tangent plane; or None
    position, first, second, tangent_plane, curvature, curvature_change
                      JoinResiduals; None: not judged
    parameter         None, or of sides that run along the seam at different speeds the map of
                      one parameter: a dict of "of" ("a" or "b"), "numerator", "denominator"
    """

    _kinds = {
        "position": JoinResidual,
        "first": JoinResidual,
        "second": JoinResidual,
        "tangent_plane": JoinResidual,
        "curvature": JoinResidual,
        "curvature_change": JoinResidual,
    }

    verdict: str
    g2: bool
    g3: Optional[bool]
    parametric_order: int
    gap_bound_mm: float
    angle_bound_rad: Optional[float]
    singular_at: Optional[float]
    position: JoinResidual
    first: JoinResidual
    second: JoinResidual
    tangent_plane: Optional[JoinResidual]
    curvature: Optional[JoinResidual]
    curvature_change: Optional[JoinResidual]
    parameter: Optional[dict]


class ConnectionFit(Result):
    """The functions that connect two surfaces; an argument ``connection`` of others.

    found       the residual is within the tolerance
    connection  the functions
    residual    relative
    noise       what rounding makes of 0
    condition   of the equations
    note        why it is not found, or ""
    parameter   None, or the map of one parameter as in JoinCondition
    """

    _kinds = {"connection": Connection}

    found: bool
    connection: Connection
    residual: float
    noise: float
    condition: float
    note: str
    parameter: Optional[dict]


# Splines


class InterpolatingSpline(Result):
    """A nu- or beta-spline; an argument ``curve`` of others.

    curve        a BezierSpline
    derivatives  (count, 3), by the parameter, in mm
    stationary   indices of points without a derivative
    """

    curve: BezierSpline
    derivatives: Array
    stationary: List[int]


class AlphaOptimum(Result):
    """The shape of least energy; an argument ``a`` of others.

    a       within the bounds
    free_a  without the bounds
    energy  the integral, in mm^2
    any     the shape makes no difference
    """

    a: float
    free_a: float
    energy: float
    any: bool


class AlphaSeamCondition(Result):
    """Which alpha-surfaces can continue another one.

    any_net     every net has a continuation of order 2
    order       largest n <= 2 of C^n, and of G^n with constant betas; -1: none
    g1          a G1 continuation exists
    defects_mm  of the rows 3, 2, 1
    noise_mm    what rounding makes of 0
    first_rows  all (alpha, beta(0), beta(1)) of G1 joins, as rows of a basis (r, 3)
    singular    singular values of the equations
    rank_noise  those below it count as 0
    """

    any_net: bool
    order: int
    g1: bool
    defects_mm: List[float]
    noise_mm: float
    first_rows: Array
    singular: Array
    rank_noise: float


class AlphaSeamFit(Result):
    """How two alpha-surfaces meet with constant betas.

    parametric_order, geometric_order  n of C^n and of G^n
    beta1, beta2                       of the best fit
    gap_mm                             largest gap
    first, second, c_first, c_second   relative residuals of G1, G2, C1, C2
    noise                              up to these three, gap_mm, first and second count as rounding
    """

    parametric_order: int
    geometric_order: int
    beta1: float
    beta2: float
    gap_mm: float
    first: float
    second: float
    c_first: float
    c_second: float
    noise: List[float]


class AlphaNearestJoin(Result):
    """The nearest nets of two alpha-surfaces that join.

    net, next_net             (4, 4, 3)
    beta1, beta2              of the join
    cost_mm2, next_cost_mm2   sums of squared moves; items "cost" and "next_cost"
    """

    _keys = {"cost_mm2": "cost", "next_cost_mm2": "next_cost"}

    net: Array
    next_net: Array
    beta1: float
    beta2: float
    cost_mm2: float
    next_cost_mm2: float


# Fills


class FillCorner(Result):
    """A corner of a fill.

    angle_rad        of the hole
    plane_angle_rad  between the tangent planes of both sides
    twist_defect_mm  how far the mixed derivatives of the neighbours differ
    exact            the tangent planes are met
    angle_bound_rad  the fill leaves them by at most this
    """

    angle_rad: float
    plane_angle_rad: Optional[float]
    twist_defect_mm: float
    exact: bool
    angle_bound_rad: float


class RingFill(Result):
    """A fill of four sides: see ``ring_fill``.

    patches                BezierPatches
    corners                FillCorners
    fairness_mm2           sum of the squared differences
    regular                it is proved that no normal vanishes or turns back
    spoke_scale            length of the ends of spokes
    curvature_jump_per_mm  largest jump of normal curvature, or None
    spoke_jump_per_mm      None, or of law "g2" the largest left on spokes, beside corners
    """

    _kinds = {"corners": FillCorner}

    patches: List[BezierPatch]
    corners: List[FillCorner]
    fairness_mm2: float
    regular: bool
    spoke_scale: Optional[float]
    curvature_jump_per_mm: Optional[float]
    spoke_jump_per_mm: Optional[float]


class NSidedFill(Result):
    """A fill of 3 to 12 sides: see ``n_sided_fill``.

    patches, corners, fairness_mm2, regular, spoke_scale, curvature_jump_per_mm  as of a RingFill
    spoke  the G1Connection of patch k + 1 to patch k
    sides  for each side None, or the connections of the fill to the neighbour on both halves
    """

    _kinds = {"corners": FillCorner, "spoke": G1Connection}

    patches: List[BezierPatch]
    corners: List[FillCorner]
    fairness_mm2: float
    regular: bool
    spoke_scale: Optional[float]
    curvature_jump_per_mm: Optional[float]
    spoke: G1Connection
    sides: List[Optional[Tuple[G1Connection, G1Connection]]]


class ThreeSidedFill(Result):
    """A fill of three sides: see ``three_sided_fill``.

    triangles     BezierTriangles
    sides         for each side None, or the G1Connection of the fill to the neighbour
    corners       FillCorners
    fairness_mm2  sum of the squared derivatives
    regular       it is proved that no normal vanishes or turns back
    """

    _kinds = {"corners": FillCorner, "sides": G1Connection}

    triangles: List[BezierTriangle]
    sides: List[Optional[G1Connection]]
    corners: List[FillCorner]
    fairness_mm2: float
    regular: bool


class Umbrella(Result):
    """Patches and triangles around a point; an argument ``members`` of ``umbrella``.

    members           BezierPatches and BezierTriangles
    spokes            BezierCurves
    connections       of each spoke a G1Connection, None on the boundary; of a rational umbrella
                      with the item "e1"
    normal            of the vertex, unit vector (3,)
    angles_rad        between neighbouring spokes
    condition         of the equations at the vertex
    regular_vertex    four spokes, opposite ones continue each other; item "crossing"
    regular           the same: an earlier name. ``regular`` of a fill is about its normals
    spoke_move_mm     largest move of a pole of a spoke
    second_change_mm  largest change of a second derivative of a spoke
    slope_change      largest change of a slope, without unit
    member_move_mm    largest move of a pole of a member
    free_vectors      how many poles might have been chosen otherwise
    """

    _keys = {"regular": "crossing", "regular_vertex": "crossing"}  # repr() shows the last name
    _kinds = {"connections": G1Connection}

    members: List[Union[BezierPatch, BezierTriangle]]
    spokes: List[BezierCurve]
    connections: List[Optional[G1Connection]]
    normal: Array
    angles_rad: Array
    condition: float
    regular_vertex: bool
    regular: bool
    spoke_move_mm: float
    second_change_mm: float
    slope_change: float
    member_move_mm: float
    free_vectors: int


class G2Connection(G1Connection):
    """Bernstein coefficients of the functions of a join of order 2; see ``join_rows``.

    An argument ``connection`` of others.
    """

    p: Array
    q: Array


class G2Umbrella(Result):
    """Patches around a point that join G2; an argument ``members`` of ``umbrella``.

    members                BezierPatches
    spokes                 BezierCurves
    connections            of each spoke a G2Connection, None on the boundary
    normal                 of the vertex, unit vector (3,)
    angles_rad             between neighbouring spokes
    form                   (3, 3), the second fundamental form of all members, in 1/mm
    third_order_condition  of the equations of the third derivatives at the vertex
    regular_vertex         four spokes, opposite ones continue each other
    spoke_move_mm          largest move of a pole of a spoke
    second_change_mm       largest change of a second derivative of a spoke
    third_change_mm        largest change of a third derivative of a spoke
    member_move_mm         largest move of a pole of a member
    free_vectors           how many poles might have been chosen otherwise
    """

    _kinds = {"connections": G2Connection}

    members: List[BezierPatch]
    spokes: List[BezierCurve]
    connections: List[Optional[G2Connection]]
    normal: Array
    angles_rad: Array
    form: Array
    third_order_condition: float
    regular_vertex: bool
    spoke_move_mm: float
    second_change_mm: float
    third_change_mm: float
    member_move_mm: float
    free_vectors: int


class UmbrellaTwists(Result):
    """The mixed second derivatives of members around a point.

    twists              (members, 3), those of the least sum of |X_i|^2 / S_i^2, S_i the area of
                        the tangents of a sector
    direction           (members,): twists + direction x are others for any vector x; None: unique
    closing_defect_mm   (3,), the alternating sum of the given values
    second_derivatives  (spokes, 3), of the spokes, with which the fan closes
    slopes              a' of each spoke at the point, with which it closes
    cross_slopes        b' of each spoke
    alpha, beta         a and b of each spoke at the point; 0 on the boundary
    form                (3, 3), the second fundamental form nearest to the spokes' curvatures
    """

    twists: Array
    direction: Optional[Array]
    closing_defect_mm: Array
    second_derivatives: Array
    slopes: Array
    cross_slopes: Array
    alpha: Array
    beta: Array
    form: Array
