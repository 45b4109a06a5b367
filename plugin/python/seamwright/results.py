# SPDX-License-Identifier: LGPL-2.1-or-later
"""The classes of results.

>>> joint = seamwright.measure_joint(line, parabola)
>>> joint.order_reached, joint["order_reached"], joint.to_dict()

Each value of a result is an attribute and an item. The key of the item is the name of the
attribute, unless the class says otherwise. A result is a ``dict`` of its items: it can be
unpacked, compared, copied, pickled and, if it holds no arrays, written as JSON. Attributes can't be
assigned.

Lengths end with ``_mm``, angles with ``_rad`` or ``_deg``, curvatures with ``_per_mm``. Arrays are
numpy arrays. A value that does not exist is ``None``.
"""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any, ClassVar, Dict, List, Optional, Tuple, Union

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._core import (
        BezierCurve,
        BezierPatch,
        BezierSpline,
        BezierTriangle,
        BSplineCurve,
        BSplineSurface,
    )

    Array = npt.NDArray[np.float64]
    Number = Union[float, Array]  # an array if the parameter was an array


class _Value:
    """An attribute that reads an item of a result."""

    def __init__(self, key):
        self.key = key
        self.__doc__ = f'The item "{key}".'

    def __set_name__(self, owner, name):
        self.name = name

    def __get__(self, result, owner=None):
        if result is None:
            return self
        try:
            return dict.__getitem__(result, self.key)
        except KeyError:
            raise AttributeError(f"this {type(result).__name__} has no {self.key}") from None

    def __set__(self, result, value):
        raise AttributeError(f"{self.name} of a {type(result).__name__} can't be assigned")


def _short(value):
    if isinstance(value, np.ndarray):
        if value.size > 12:
            return f"array{value.shape}"
        return " ".join(np.array2string(value, precision=6, separator=", ").split())
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple)):
        if len(value) > 4:
            return f"[{len(value)} values]"
        text = ", ".join(map(_short, value))
        return f"[{text}]" if isinstance(value, list) else f"({text})"
    if isinstance(value, dict) and not isinstance(value, Result):
        return f"{{{', '.join(f'{key!r}: {_short(item)}' for key, item in value.items())}}}"
    return repr(value)


def _same(a, b):
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        return a.shape == b.shape and bool(np.all(a == b))
    if isinstance(a, (list, tuple)) and isinstance(b, type(a)):
        return len(a) == len(b) and all(map(_same, a, b))
    return bool(a == b)


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return type(value)(_plain(item) for item in value)
    return value


class Result(Dict[str, Any]):
    """A result: its values are attributes, and items of a dict."""

    _keys: ClassVar[Dict[str, str]] = {}  # of attributes whose item has another name
    _kinds: ClassVar[Dict[str, type]] = {}  # of items that are results, or lists of results
    _shapes: ClassVar[Dict[str, Tuple[int, ...]]] = {}  # of items at one parameter

    def __init_subclass__(cls, **keywords):
        super().__init_subclass__(**keywords)
        for name in inspect.get_annotations(cls):
            if not name.startswith("_"):
                value = _Value(cls._keys.get(name, name))
                value.__set_name__(cls, name)
                setattr(cls, name, value)

    def __init__(self, *values: Any, **more: Any) -> None:
        super().__init__(*values, **more)
        for key, kind in self._kinds.items():
            value = self.get(key)
            if isinstance(value, list):
                self[key] = [item if item is None else kind(item) for item in value]
            elif value is not None:
                self[key] = kind(value)

    def __missing__(self, key: str) -> Any:
        if key in self._keys:
            return self[self._keys[key]]
        raise KeyError(key)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, dict):
            return NotImplemented
        return self.keys() == other.keys() and all(_same(self[key], other[key]) for key in self)

    def __ne__(self, other: object) -> bool:
        equal = self.__eq__(other)
        return equal if equal is NotImplemented else not equal

    def __repr__(self) -> str:
        names = {key: name for name, key in self._keys.items()}
        values = ", ".join(f"{names.get(key, key)}={_short(self[key])}" for key in self)
        return f"{type(self).__name__}({values})"

    def copy(self):
        """A result of the same class with the same values."""
        return type(self)(self)

    def to_dict(self) -> Dict[str, Any]:
        """The items as a plain dict; results within it are plain dicts too."""
        return _plain(self)

    @classmethod
    def _stacked(cls, results, shape):
        """One result whose items are arrays, from the results at an array of parameters.

        Numbers and vectors that do not exist are nan.
        """
        items = {}
        for key in cls._shapes:
            trailing = cls._shapes[key]
            values = [result[key] for result in results]
            if any(isinstance(value, str) for value in values):
                items[key] = np.array(values, dtype=str).reshape(shape)
                continue
            if any(isinstance(value, bool) for value in values):
                items[key] = np.array(values, dtype=bool).reshape(shape)
                continue
            missing = np.full(trailing, np.nan)
            rows = [missing if value is None else value for value in values]
            items[key] = np.array(rows, dtype=float).reshape(shape + trailing)
        return cls(items)


# Models


class Tolerances(Result):
    """The tolerances of a profile: arguments of ``Model.analyze`` and of all that judge.

    gap_mm          largest gap at which faces meet
    angle_deg       largest angle between their tangent planes
    curvature_rel   largest relative difference of curvature
    flat_radius_mm  surfaces of larger radii count as flat
    crease_deg      seams with a larger angle are creases
    """

    gap_mm: float
    angle_deg: float
    curvature_rel: float
    flat_radius_mm: float
    crease_deg: float


class Figure(Result):
    """The largest value of a quantity along a seam, in the unit of the figure.

    lower  a value that is reached at ``at``
    upper  no value is larger; ``None``: no bound is known
    at     0..1 along the seam
    """

    lower: float
    upper: Optional[float]
    at: float


class LeftOut(Result):
    """Intervals [first, last] in 0..1 along a seam that its figures leave out."""

    angle_deg: List[List[float]]
    curvature_per_mm: List[List[float]]
    curvature_rel: List[List[float]]


class WorstPoint(Result):
    """Where a seam is worst.

    quantity  "gap", "angle", "curvature" or "curvature_change"
    at        0..1 along the seam
    point_mm  [x, y, z]; item "point"
    """

    _keys = {"point_mm": "point"}

    quantity: str
    at: float
    point_mm: List[float]


class Seam(Result):
    """A seam of a model, as in the JSON (docs/analysis-1.schema.json).

    id, edges, faces   numbers from 1
    kind               "shared", "closed" or "matched"
    length_mm          of the seam
    gap_mm, angle_deg, curvature_per_mm, curvature_rel,
    curvature_change_per_mm2, curvature_change_rel
                       a Figure, or None
    left_out           intervals that the figures leave out
    level              "none", "G0", "G1", "G2" or "G3"
    seam_class         "smooth", "defect" or "crease"; item "class"
    certified          the verdict is certain
    worst              a WorstPoint, or None
    note               what a user should know, or ""
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
        "worst": WorstPoint,
    }

    id: int
    kind: str
    edges: List[int]
    faces: List[int]
    length_mm: float
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
    worst: Optional[WorstPoint]
    note: str


class SeamRepair(Result):
    """What a repair did with a seam.

    before, after     the seam as it was and as it is
    treated           the repair was to improve it
    repaired          it meets the target now
    reason            why it is left, or ""; reason_code: the code of the reason, see docs/repair.md
    wants_conversion  it can be treated if analytic faces may become splines
    sewn, not_sewn    its two edges became one; why they did not, or ""; not_sewn_code: the code of
                      that reason
    """

    _kinds = {"before": Seam, "after": Seam}

    before: Seam
    after: Seam
    treated: bool
    repaired: bool
    reason: str
    reason_code: str
    wants_conversion: bool
    sewn: bool
    not_sewn: str
    not_sewn_code: str


class Bounds(Result):
    """A value between ``lower`` and ``upper``."""

    lower: float
    upper: float


class Compared(Result):
    """A value ``before`` and ``after`` a change."""

    before: Optional[float]
    after: Optional[float]


class SurfaceChange(Result):
    """What became of the surface of a face that moved.

    move_mm                  Bounds of the largest move of a point
    normal_move_mm           largest part along the normal
    tangential_move_mm       largest part in the tangent plane
    turn_deg                 largest turn of the normal
    curvature_change_per_mm  largest change of normal curvature
    variation_per_mm         Compared: how much the mean curvature varies
    extrema, inflections     Compared: their number along the lines
    lines                    how many iso-lines were compared
    worse, reason            the face is less fair than before, and why
    """

    _kinds = {
        "move_mm": Bounds,
        "variation_per_mm": Compared,
        "extrema": Compared,
        "inflections": Compared,
    }

    move_mm: Bounds
    normal_move_mm: float
    tangential_move_mm: float
    turn_deg: float
    curvature_change_per_mm: float
    variation_per_mm: Compared
    extrema: Compared
    inflections: Compared
    lines: int
    worse: bool
    reason: str


class FaceMove(Result):
    """A face that moved.

    face             its number, from 1
    largest_move_mm  of a point
    surface          a SurfaceChange; None: it could not be measured
    """

    _kinds = {"surface": SurfaceChange}

    face: int
    largest_move_mm: float
    surface: Optional[SurfaceChange]


class EdgeMove(Result):
    """An edge with a new path on a face that stays: its number, and the largest move."""

    edge: int
    largest_move_mm: float


class FaceConversion(Result):
    """A face that became a spline.

    face      its number, from 1
    kind      what it was
    error_mm  largest distance from what it was
    """

    face: int
    kind: str
    error_mm: float


class RepairSummary(Result):
    """Counts of a repair.

    seams, treated, repaired, left   seams: all, those to be improved, those that were, the others
    wants_conversion                 seams that need analytic faces to become splines
    sewn, lowered                    seams sewn; seams at a lower level that the target allows
    defects_before, defects_after    defects
    largest_move_mm                  of a point
    worse_faces                      faces that are less fair than before
    changed, passed                  something moved; no seam is a defect
    """

    seams: int
    treated: int
    repaired: int
    left: int
    wants_conversion: int
    sewn: int
    lowered: int
    defects_before: int
    defects_after: int
    largest_move_mm: float
    worse_faces: int
    changed: bool
    passed: bool


class HoleSide(Result):
    """A side of a hole: numbers of its edges and of the faces beside them, and its length."""

    edges: List[int]
    faces: List[int]
    length_mm: float


class Hole(Result):
    """A closed loop of free edges.

    id           number from 1
    length_mm    around
    centre_mm    [x, y, z]
    has_corners  the tangent turns somewhere
    longest      the longest loop of its shell
    sides        HoleSides
    """

    _kinds = {"sides": HoleSide}

    id: int
    length_mm: float
    centre_mm: List[float]
    has_corners: bool
    longest: bool
    sides: List[HoleSide]


class ShapeAttribute(Result):
    """What a file says about a part of the shape.

    kind    "Face", "Solid", ...
    index   number from 1 among the parts of that kind
    name    "" if there is none
    color   red, green, blue in 0..1, linear; or None
    layers  names
    """

    kind: str
    index: int
    name: str
    color: Optional[List[float]]
    layers: List[str]


class MeshFault(Result):
    """A face whose triangles are missing or do not cover it: its number, and why."""

    face: int
    reason: str


class WriteResult(Result):
    """What came of writing a file.

    format                            of the file
    followed_source                   structure, names and colours of the source were kept
    changed_faces, changed_edges,
    changed_vertices                  how many differ from the source
    notes                             what a user should know
    """

    format: str
    followed_source: bool
    changed_faces: int
    changed_edges: int
    changed_vertices: int
    notes: List[str]


class WrittenFile(Result):
    """What was found in a file that was read back."""

    path: str
    format: str
    edges: int
    faces: int
    open_edges: int
    defects: int


class CheckedWriteResult(WriteResult):
    """What came of writing a file that was then read back and analysed.

    output       a WrittenFile
    differences  lines that say what is otherwise in the file than in the model
    """

    _kinds = {"output": WrittenFile}

    output: WrittenFile
    differences: List[str]


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
        "left_out": LeftOut,
        "degenerate": DegeneratePoint,
    }

    gap_mm: Optional[Figure]
    angle_deg: Optional[Figure]
    curvature_per_mm: Optional[Figure]
    curvature_rel: Optional[Figure]
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


# Joins


class G1Connection(Result):
    """Bernstein coefficients of the functions of a G1 join: Q_s = alpha P_s + beta P_t.

    An argument ``connection`` of others.
    """

    alpha: Array
    beta: Array


class Connection(G1Connection):
    """Bernstein coefficients of the functions of a G2 join; see ``join_rows``."""

    p: Array
    q: Array
    e0: Array
    e1: Array
    e2: Array


class NearestJoin(Connection):
    """The smallest move of poles that joins two surfaces; an argument ``connection`` of others.

    a, b             the surfaces
    status           "joined", "unchanged", "infeasible" or "not converged"
    alpha, ..., e2   the functions that connect them
    largest_move_mm  of a pole
    cost_mm2         sum of weight times squared move; item "cost"
    residual         of the equations, without unit
    stationarity     how far the move is from the smallest one, without unit
    iterations       steps of the search
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

    @property
    def connection(self) -> Connection:
        """The functions alone."""
        return Connection({key: self[key] for key in ("alpha", "beta", "p", "q", "e0", "e1", "e2")})


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
    g2                they join G2
    parametric_order  n of C^n
    gap_bound_mm      bound of the gap
    angle_bound_rad   bound of the angle
    singular_at       0..1, where a side has no tangent plane; or None
    position, first, second, tangent_plane, curvature
                      JoinResiduals; None: not judged
    """

    _kinds = {
        "position": JoinResidual,
        "first": JoinResidual,
        "second": JoinResidual,
        "tangent_plane": JoinResidual,
        "curvature": JoinResidual,
    }

    verdict: str
    g2: bool
    parametric_order: int
    gap_bound_mm: float
    angle_bound_rad: Optional[float]
    singular_at: Optional[float]
    position: JoinResidual
    first: JoinResidual
    second: JoinResidual
    tangent_plane: Optional[JoinResidual]
    curvature: Optional[JoinResidual]


class ConnectionFit(Result):
    """The functions that connect two surfaces; an argument ``connection`` of others.

    found       the residual is within the tolerance
    connection  the functions
    residual    relative
    noise       what rounding makes of 0
    condition   of the equations
    note        why it is not found, or ""
    """

    _kinds = {"connection": Connection}

    found: bool
    connection: Connection
    residual: float
    noise: float
    condition: float
    note: str


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
    defects_mm: Array
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
    noise                              what rounding makes of 0
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
    noise: float


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
    """

    _kinds = {"corners": FillCorner}

    patches: List[BezierPatch]
    corners: List[FillCorner]
    fairness_mm2: float
    regular: bool
    spoke_scale: Optional[float]
    curvature_jump_per_mm: Optional[float]


class NSidedFill(RingFill):
    """A fill of 3 to 12 sides: see ``n_sided_fill``.

    spoke  the G1Connection of patch k + 1 to patch k
    sides  for each side None, or the connections of the fill to the neighbour on both halves
    """

    _kinds = {"corners": FillCorner, "spoke": G1Connection}

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
    connections       of each spoke a G1Connection, None for rims
    normal            of the vertex, unit vector (3,)
    angles_rad        between neighbouring spokes
    condition         of the equations at the vertex
    regular           four spokes, opposite ones continue each other; item "crossing"
    spoke_move_mm     largest move of a pole of a spoke
    second_change_mm  largest change of a second derivative of a spoke
    slope_change      largest change of a slope, without unit
    member_move_mm    largest move of a pole of a member
    free_vectors      how many poles might have been chosen otherwise
    """

    _keys = {"regular": "crossing"}
    _kinds = {"connections": G1Connection}

    members: List[Union[BezierPatch, BezierTriangle]]
    spokes: List[BezierCurve]
    connections: List[Optional[G1Connection]]
    normal: Array
    angles_rad: Array
    condition: float
    regular: bool
    spoke_move_mm: float
    second_change_mm: float
    slope_change: float
    member_move_mm: float
    free_vectors: int


__all__ = sorted(
    name
    for name, value in list(globals().items())
    if isinstance(value, type) and issubclass(value, Result)
)
