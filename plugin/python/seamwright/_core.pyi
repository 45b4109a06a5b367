# SPDX-License-Identifier: LGPL-2.1-or-later
# The types of the compiled part. tests/plugin/python/test_stubs.py compares names and parameters.

import os
from typing import (
    Any,
    Callable,
    Dict,
    List,
    NoReturn,
    Optional,
    Sequence,
    SupportsIndex,
    Tuple,
    TypeVar,
    Union,
    overload,
)

import numpy as np
import numpy.typing as npt

from . import results as _r

Array = npt.NDArray[np.float64]
Numbers = npt.ArrayLike  # a sequence or an array of numbers
Number = Union[float, np.floating[Any], np.integer[Any]]
Whole = Union[int, np.integer[Any]]
Flag = Union[bool, np.bool_]
Parameter = npt.ArrayLike  # a number, or an array of them
Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
Progress = Optional[Callable[[float], Any]]
Curve = Union[
    BezierCurve,
    BSplineCurve,
    BezierSpline,
    MatrixCurve,
    _r.InterpolatingSpline,
    _r.BiarcSpline,
    _r.ArcFit,
    _r.SampledArcs,
    _r.SplineWithin,
    _r.G2Conics,
    _r.FairedCurve,
    _r.PolishedCurve,
    _r.FunctionSpline,
    _r.FairedFunction,
    _r.MatrixFit,
    _r.FairedHermite,
    _r.SplineFrame,
]
FunctionPoints = Union[Numbers, _r.FunctionSpline, _r.FairedFunction]
Arcs = Union[Sequence[PlanarArc], ArcChain, _r.Biarc, _r.BiarcSpline, _r.ArcFit, _r.SampledArcs]
Surface = Union[BezierPatch, BezierTriangle]
ModelItem = Union[
    Curve,
    BezierPatch,
    BezierTriangle,
    BSplineSurface,
    _r.Umbrella,
    _r.G2Umbrella,
    _r.RingFill,
    _r.ThreeSidedFill,
    _r.FrameLoft,
]
Betas = Union[Numbers, _r.BetaFit, _r.NearestCurveJoin, _r.BlendedJoint, _r.SplineJoint]
CurvePair = Sequence[Union[None, BezierCurve, Numbers]]
FramePair = Union[Tuple[Curve, Curve], List[Curve]]
Functions = Union[Dict[str, Any], _r.G1Connection, _r.ConnectionFit]
Shape = Union[Number, _r.AlphaOptimum]

__version__: str
OCCT_VERSION: str
PROFILES: Dict[str, Dict[str, float]]

class Cancelled(Exception): ...
class ModelError(Exception): ...

# Polynomials, curves and surfaces

class BernsteinPolynomial:
    __array_ufunc__: None
    def __init__(self, coefficients: Numbers, padding: Number = 0.0) -> None: ...
    @property
    def degree(self) -> int: ...
    @property
    def coefficients(self) -> Array: ...
    @property
    def padding(self) -> float: ...
    @overload
    def evaluate(self, t: float) -> Tuple[float, float]: ...
    @overload
    def evaluate(self, t: Parameter) -> Union[Tuple[float, float], Tuple[Array, Array]]: ...
    def derivative(self) -> BernsteinPolynomial: ...
    def elevated(self, by: Whole) -> BernsteinPolynomial: ...
    def split(self, t: Number) -> Tuple[BernsteinPolynomial, BernsteinPolynomial]: ...
    def restricted(self, lower: Number, upper: Number) -> BernsteinPolynomial: ...
    def range(self, tolerance: Optional[Number] = None) -> Tuple[float, float]: ...
    def __neg__(self) -> BernsteinPolynomial: ...
    def __add__(self, arg0: BernsteinPolynomial) -> BernsteinPolynomial: ...
    def __sub__(self, arg0: BernsteinPolynomial) -> BernsteinPolynomial: ...
    def __mul__(self, arg0: Union[BernsteinPolynomial, Number]) -> BernsteinPolynomial: ...
    def __rmul__(self, arg0: float) -> BernsteinPolynomial: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class SurfaceJet:
    p: Array
    u: Array
    v: Array
    uu: Array
    uv: Array
    vv: Array
    uuu: Array
    uuv: Array
    uvv: Array
    vvv: Array
    def __init__(self) -> None: ...
    def __getstate__(self) -> Array: ...
    def __setstate__(self, arg0: Array) -> None: ...

class BezierCurve:
    def __init__(self, poles: Numbers, weights: Optional[Numbers] = None) -> None: ...
    @property
    def degree(self) -> int: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    def point(self, t: Parameter) -> Array: ...
    def jet(self, t: Parameter) -> Array: ...
    def derivatives(self, t: Parameter, order: Whole) -> Array: ...
    def reversed(self) -> BezierCurve: ...
    def elevated(self) -> BezierCurve: ...
    def split(self, t: Number) -> Tuple[BezierCurve, BezierCurve]: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Array: ...
    def __setstate__(self, arg0: Array) -> None: ...

class BezierPatch:
    def __init__(self, poles: Numbers, weights: Optional[Numbers] = None) -> None: ...
    @property
    def degree_u(self) -> int: ...
    @property
    def degree_v(self) -> int: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    def point(self, u: Parameter, v: Parameter) -> Array: ...
    @overload
    def jet(self, u: float, v: float) -> SurfaceJet: ...
    @overload
    def jet(self, u: Parameter, v: Parameter) -> Any: ...
    def transposed(self) -> BezierPatch: ...
    def reversed_u(self) -> BezierPatch: ...
    def split_u(self, t: Number) -> Tuple[BezierPatch, BezierPatch]: ...
    def iso_curve_u(self, u: Number) -> BezierCurve: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class BezierTriangle:
    def __init__(self, poles: Numbers, weights: Optional[Numbers] = None) -> None: ...
    @property
    def degree(self) -> int: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    def point(self, l0: Parameter, l1: Parameter) -> Array: ...
    @overload
    def jet(self, l0: float, l1: float) -> SurfaceJet: ...
    @overload
    def jet(self, l0: Parameter, l1: Parameter) -> Any: ...
    def blossom(self, arguments: Numbers) -> Array: ...
    def edge_curve(self, edge: str) -> BezierCurve: ...
    def elevated(self) -> BezierTriangle: ...
    def permuted(self, corners: Sequence[Whole]) -> BezierTriangle: ...
    def subtriangle(self, corners: Numbers) -> BezierTriangle: ...
    def split_at(self, l0: Number, l1: Number) -> List[BezierTriangle]: ...
    def quartered(self) -> List[BezierTriangle]: ...
    def to_patch(self, apex: Whole = 0) -> BezierPatch: ...
    def to_patches(self) -> List[BezierPatch]: ...
    @staticmethod
    def from_patch(patch: BezierPatch, tolerance_mm: Optional[Number] = None) -> BezierTriangle: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Array: ...
    def __setstate__(self, arg0: Array) -> None: ...

class BSplineCurve:
    def __init__(
        self, degree: Whole, knots: Sequence[Number], poles: Numbers, weights: Optional[Numbers] = None
    ) -> None: ...
    @staticmethod
    def from_bezier(curve: BezierCurve) -> BSplineCurve: ...
    @property
    def degree(self) -> int: ...
    @property
    def knots(self) -> List[float]: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    def point(self, t: Parameter) -> Array: ...
    def derivatives(self, t: Parameter, order: Whole) -> Array: ...
    def bezier_spline(self, closed: Flag = False) -> BezierSpline: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class BezierSpline:
    def __init__(
        self,
        degree: Whole,
        knots: Sequence[Number],
        poles: Numbers,
        weights: Optional[Numbers] = None,
        closed: Flag = False,
    ) -> None: ...
    @staticmethod
    def from_segments(
        segments: Sequence[Curve], knots: Sequence[Number], closed: Flag = False, gap_mm: Number = 0.0
    ) -> BezierSpline: ...
    @property
    def degree(self) -> int: ...
    @property
    def knots(self) -> List[float]: ...
    @property
    def closed(self) -> bool: ...
    @property
    def is_rational(self) -> bool: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    @property
    def segments(self) -> int: ...
    def point(self, t: Parameter) -> Array: ...
    def derivatives(self, t: Parameter, order: Whole) -> Array: ...
    def segment(self, i: Whole) -> BezierCurve: ...
    def measure_joints(
        self,
        order: Whole = 3,
        *,
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
    ) -> List[_r.CurveJoint]: ...
    def continuity(self, around: Flag = False) -> int: ...
    def to_bspline(self, continuity: Optional[Whole] = None) -> BSplineCurve: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class MatrixCurve:
    def __init__(
        self,
        degree: Whole,
        knots: Sequence[Number],
        points: Numbers,
        tangents: Optional[Numbers] = None,
        weights: Union[Number, Numbers] = 1.0,
        stiffness: Union[Number, Numbers] = 0.0,
    ) -> None: ...
    @property
    def degree(self) -> int: ...
    @property
    def knots(self) -> List[float]: ...
    @property
    def points(self) -> Array: ...
    @property
    def tangents(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    @property
    def stiffness(self) -> Array: ...
    def point(self, t: Parameter) -> Array: ...
    def derivative(self, t: Parameter) -> Array: ...
    def bezier_spline(self) -> BezierSpline: ...
    def to_bspline(self) -> BSplineCurve: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class BSplineSurface:
    def __init__(
        self,
        poles: Numbers,
        knots_u: Sequence[Number],
        knots_v: Sequence[Number],
        degree_u: Whole,
        degree_v: Whole,
        weights: Optional[Numbers] = None,
    ) -> None: ...
    @staticmethod
    def from_patch(patch: BezierPatch) -> BSplineSurface: ...
    @property
    def degree_u(self) -> int: ...
    @property
    def degree_v(self) -> int: ...
    @property
    def knots_u(self) -> List[float]: ...
    @property
    def knots_v(self) -> List[float]: ...
    @property
    def poles(self) -> Array: ...
    @property
    def weights(self) -> Array: ...
    def point(self, u: Parameter, v: Parameter) -> Array: ...
    @overload
    def jet(self, u: float, v: float) -> SurfaceJet: ...
    @overload
    def jet(self, u: Parameter, v: Parameter) -> Any: ...
    def with_knot(self, direction: str, knot: Number) -> BSplineSurface: ...
    def with_raised_knots(self, direction: str, times: Whole = 1) -> BSplineSurface: ...
    def elevated(self, direction: str) -> BSplineSurface: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

# Curves of the plane

class PlanarArc:
    def __init__(
        self, start: Numbers, direction_rad: Number, curvature_per_mm: Number, length_mm: Number
    ) -> None: ...
    @property
    def start(self) -> Array: ...
    @property
    def end(self) -> Array: ...
    @property
    def direction_rad(self) -> float: ...
    @property
    def end_direction_rad(self) -> float: ...
    @property
    def curvature_per_mm(self) -> float: ...
    @property
    def length_mm(self) -> float: ...
    @property
    def sweep_rad(self) -> float: ...
    def point(self, s_mm: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, s_mm: float) -> float: ...
    @overload
    def direction_at_rad(self, s_mm: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, s_mm: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, s_mm: Parameter) -> Union[float, Array]: ...
    def reversed(self) -> PlanarArc: ...
    def offset(self, distance_mm: Number) -> PlanarArc: ...
    def bezier_spline(self) -> BezierSpline: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class ArcChain:
    def __init__(
        self,
        arcs: Arcs,
        closed: Flag = False,
        corners: Sequence[Whole] = (),
        gap_mm: Number = 1e-09,
    ) -> None: ...
    @property
    def arcs(self) -> List[PlanarArc]: ...
    @property
    def closed(self) -> bool: ...
    @property
    def corners(self) -> List[int]: ...
    @property
    def length_mm(self) -> float: ...
    @property
    def energy_per_mm(self) -> float: ...
    def point(self, s_mm: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, s_mm: float) -> float: ...
    @overload
    def direction_at_rad(self, s_mm: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, s_mm: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, s_mm: Parameter) -> Union[float, Array]: ...
    def offset(self, distance_mm: Number) -> ArcChain: ...
    def bezier_spline(self) -> BezierSpline: ...
    def __len__(self) -> int: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class Clothoid:
    def __init__(
        self,
        start: Numbers,
        direction_rad: Number,
        curvature_per_mm: Number,
        curvature_slope_per_mm2: Number,
        length_mm: Number,
    ) -> None: ...
    @property
    def start(self) -> Array: ...
    @property
    def end(self) -> Array: ...
    @property
    def direction_rad(self) -> float: ...
    @property
    def end_direction_rad(self) -> float: ...
    @property
    def curvature_per_mm(self) -> float: ...
    @property
    def end_curvature_per_mm(self) -> float: ...
    @property
    def curvature_slope_per_mm2(self) -> float: ...
    @property
    def length_mm(self) -> float: ...
    def point(self, s_mm: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, s_mm: float) -> float: ...
    @overload
    def direction_at_rad(self, s_mm: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, s_mm: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, s_mm: Parameter) -> Union[float, Array]: ...
    def reversed(self) -> Clothoid: ...
    def bezier_spline(self, tolerance_mm: Number) -> _r.SplineWithin: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class ClothoidChain:
    def __init__(
        self, pieces: Sequence[Clothoid], closed: Flag = False, gap_mm: Number = 1e-09
    ) -> None: ...
    @property
    def pieces(self) -> List[Clothoid]: ...
    @property
    def closed(self) -> bool: ...
    @property
    def length_mm(self) -> float: ...
    def point(self, s_mm: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, s_mm: float) -> float: ...
    @overload
    def direction_at_rad(self, s_mm: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, s_mm: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, s_mm: Parameter) -> Union[float, Array]: ...
    def bezier_spline(self, tolerance_mm: Number) -> _r.SplineWithin: ...
    def __len__(self) -> int: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class LogSpiral:
    def __init__(
        self,
        start: Numbers,
        direction_rad: Number,
        radius_mm: Number,
        growth: Number,
        turn_rad: Number,
    ) -> None: ...
    @property
    def start(self) -> Array: ...
    @property
    def end(self) -> Array: ...
    @property
    def pole(self) -> Array: ...
    @property
    def direction_rad(self) -> float: ...
    @property
    def end_direction_rad(self) -> float: ...
    @property
    def radius_mm(self) -> float: ...
    @property
    def growth(self) -> float: ...
    @property
    def turn_rad(self) -> float: ...
    @property
    def length_mm(self) -> float: ...
    def point(self, u_rad: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, u_rad: float) -> float: ...
    @overload
    def direction_at_rad(self, u_rad: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, u_rad: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, u_rad: Parameter) -> Union[float, Array]: ...
    def bezier_spline(self, tolerance_mm: Number) -> _r.SplineWithin: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class PlanarConic:
    def __init__(
        self, start: Numbers, corner: Numbers, end: Numbers, weight: Number = 1.0
    ) -> None: ...
    @staticmethod
    def from_arc(arc: PlanarArc) -> PlanarConic: ...
    @property
    def start(self) -> Array: ...
    @property
    def corner(self) -> Array: ...
    @property
    def end(self) -> Array: ...
    @property
    def weight(self) -> float: ...
    @property
    def turn_rad(self) -> float: ...
    @property
    def length_mm(self) -> float: ...
    @property
    def curvature_kind(self) -> str: ...
    def point(self, t: Parameter) -> Array: ...
    @overload
    def direction_at_rad(self, t: float) -> float: ...
    @overload
    def direction_at_rad(self, t: Parameter) -> Union[float, Array]: ...
    @overload
    def curvature_at_per_mm(self, t: float) -> float: ...
    @overload
    def curvature_at_per_mm(self, t: Parameter) -> Union[float, Array]: ...
    def reversed(self) -> PlanarConic: ...
    def halves(self) -> Tuple[PlanarConic, PlanarConic]: ...
    def bezier_curve(self) -> BezierCurve: ...
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

def arc_through(start: Numbers, direction_rad: Number, end: Numbers) -> PlanarArc: ...
def point_corners(
    points: Numbers, *, closed: bool = False, corner_rad: Number = 1.0471975511965976,
    error_mm: Number = 0.0
) -> List[int]: ...
def sampled_arcs(
    points: Numbers, *, closed: bool = False, tolerance_mm: Number = 0.01
) -> Optional[_r.SampledArcs]: ...
def fit_arcs(
    curve: Curve,
    tolerance_mm: Number = 0.01,
    *,
    corner_rad: Number = 0.001,
    progress: Progress = None,
) -> _r.ArcFit: ...
def biarc(
    start: Numbers,
    start_direction_rad: Number,
    end: Numbers,
    end_direction_rad: Number,
    *,
    rule: Optional[str] = None,
    x: Optional[Number] = None,
) -> _r.Biarc: ...
def planar_tangents(
    points: Numbers,
    *,
    closed: Flag = False,
    tangents: str = "linear energy",
    variation: Number = 1.0,
    start_direction_rad: Optional[Number] = None,
    end_direction_rad: Optional[Number] = None,
) -> _r.PlanarTangents: ...
def biarc_spline(
    points: Numbers,
    *,
    closed: Flag = False,
    tangents: str = "linear energy",
    variation: Number = 1.0,
    start_direction_rad: Optional[Number] = None,
    end_direction_rad: Optional[Number] = None,
    rule: str = "equal chords",
) -> _r.BiarcSpline: ...
def clothoid(
    start: Numbers,
    start_direction_rad: Number,
    end: Numbers,
    end_direction_rad: Number,
) -> Clothoid: ...
def clothoid_spline(
    points: Numbers,
    *,
    closed: Flag = False,
    start_direction_rad: Optional[Number] = None,
    end_direction_rad: Optional[Number] = None,
    start_curvature_per_mm: Optional[Number] = None,
    end_curvature_per_mm: Optional[Number] = None,
) -> _r.ClothoidSpline: ...
def fit_clothoids(
    curve: Curve,
    tolerance_mm: Number = 0.01,
    *,
    corner_rad: Number = 0.001,
    progress: Progress = None,
) -> _r.ClothoidFit: ...
def log_spiral(
    start: Numbers,
    start_direction_rad: Number,
    end: Numbers,
    end_direction_rad: Number,
) -> LogSpiral: ...
def euler_arcs(
    start: Numbers,
    start_direction_rad: Number,
    end: Numbers,
    end_direction_rad: Number,
    count: Whole,
) -> ArcChain: ...
def log_arcs(
    start: Numbers,
    start_direction_rad: Number,
    end: Numbers,
    end_direction_rad: Number,
    count: Optional[Whole] = None,
) -> ArcChain: ...
def spiral_certificate(
    start: Numbers,
    start_direction_rad: Number,
    start_curvature_per_mm: Number,
    end: Numbers,
    end_direction_rad: Number,
    end_curvature_per_mm: Number,
) -> _r.SpiralCertificate: ...
def bilens_rad(
    start: Numbers, start_direction_rad: Number, end: Numbers, end_direction_rad: Number
) -> Tuple[float, float]: ...
def turn_through_rad(start: Numbers, end: Numbers, points: Numbers) -> Union[float, Array]: ...
def two_conics(
    start: Numbers,
    apex: Numbers,
    end: Numbers,
    start_curvature_per_mm: Number,
    end_curvature_per_mm: Number,
    *,
    start_share: Number = 0.5,
    end_share: Number = 0.5,
) -> Tuple[PlanarConic, PlanarConic]: ...
def conics_of_arcs(arcs: Arcs) -> List[PlanarConic]: ...
def g2_conics(
    chain: Union[Sequence[PlanarConic], Arcs, _r.G2Conics],
    *,
    closed: Optional[Flag] = None,
    start_curvature_per_mm: Optional[Number] = None,
    gap_mm: Number = 1e-09,
    angle_rad: Number = 1e-09,
) -> _r.G2Conics: ...

# Fairing

def point_curvatures(points: Numbers, *, closed: Flag = False) -> Array: ...
def isolated_inflections(points: Numbers, *, closed: Flag = False) -> List[int]: ...
def point_fairness(points: Numbers, *, closed: Flag = False) -> _r.PointFairness: ...
def fair_points(
    points: Numbers,
    tolerance_mm: Union[Number, Numbers],
    *,
    closed: Flag = False,
    ends_fixed: Flag = True,
    max_steps: Whole = 200,
) -> _r.FairedPoints: ...
def filter_curvature(
    points: Numbers,
    tolerance_mm: Number,
    *,
    closed: Flag = False,
    strength: Number = 0.25,
    max_passes: Whole = 100,
) -> _r.FairedPoints: ...
def curvature_profile(curve: Curve) -> _r.CurvatureProfile: ...
def curve_fairness(curve: Curve) -> _r.CurveFairness: ...
def fair_curve(
    curve: Curve, tolerance_mm: Number, *, ends: str = "position"
) -> _r.FairedCurve: ...
def polish_curve(
    curve: Curve, tolerance_mm: Number, *, ends: str = "position"
) -> _r.PolishedCurve: ...
def fair_at_knots(
    curve: Curve, tolerance_mm: Number, *, ends: str = "position"
) -> _r.FairedCurve: ...
def fair_at_knot(
    curve: Curve, index: Whole, limit_mm: Optional[Number] = None
) -> BSplineCurve: ...
def smoothing_spline(
    points: Numbers,
    parameters: Numbers,
    knots: Sequence[Number],
    smoothing: Number,
    *,
    degree: Whole = 3,
    ends_fixed: Flag = False,
) -> BSplineCurve: ...
def function_spline(
    points: FunctionPoints, *, slopes: Optional[Numbers] = None
) -> _r.FunctionSpline: ...
def function_fairness(
    points: FunctionPoints, *, slopes: Optional[Numbers] = None
) -> _r.FunctionFairness: ...
def correct_function_at(
    points: FunctionPoints,
    index: Whole,
    limit_mm: Optional[Number] = None,
    *,
    slopes: Optional[Numbers] = None,
) -> _r.FunctionSpline: ...
def correct_function(
    points: FunctionPoints, tolerance_mm: Number, *, slopes: Optional[Numbers] = None
) -> _r.FairedFunction: ...
def rebounded(
    points: FunctionPoints, *, slopes: Optional[Numbers] = None
) -> _r.FunctionSpline: ...
def rebound_function(
    points: FunctionPoints,
    tolerance_mm: Number,
    *,
    slopes: Optional[Numbers] = None,
    most_rebounds: Whole = 3,
) -> _r.FairedFunction: ...
def polish_function(points: FunctionPoints, tolerance_mm: Number) -> _r.FairedFunction: ...
def polished_poles(ordinates_mm: Numbers, steps: Whole) -> Array: ...
def fit_hermite(
    points: Numbers, tangents: Numbers, *, degree: Whole = 3, stiffness: Number = 1.0
) -> _r.MatrixFit: ...
def fair_hermite(
    points: Numbers,
    tangents: Numbers,
    tolerance_mm: Number,
    *,
    most_passes: Whole = 10,
    fair_tangents: Flag = True,
    degree: Whole = 3,
    stiffness: Number = 1.0,
) -> _r.FairedHermite: ...
def matrix_pass(
    points: Numbers,
    tangents: Numbers,
    *,
    stiffness: Number = 1.0,
    fair_tangents: Flag = True,
) -> _r.HermitePoints: ...
def curvature_variation(curve: Curve) -> _r.CurvatureVariation: ...

# Measures

def measure_pair(a: SurfaceJet, b: SurfaceJet) -> _r.PairMeasure: ...
def curvature_tensor(jet: SurfaceJet) -> Array: ...
def principal_curvatures(jet: SurfaceJet) -> Tuple[float, float, Array, Array]: ...
def surface_shape(
    patch: Surface, u: Parameter, v: Parameter, direction: Optional[Numbers] = None
) -> _r.SurfaceShape: ...
def enclose_knot_lines(
    surface: Union[BSplineSurface, _r.FrameLoft],
    direction: str = "u",
    *,
    closed: Flag = False,
    level: str = "G2",
    profile: str = "default",
    gap_mm: Optional[Number] = None,
    angle_deg: Optional[Number] = None,
    curvature_rel: Optional[Number] = None,
    flat_radius_mm: Optional[Number] = None,
    crease_deg: Optional[Number] = None,
) -> List[_r.KnotLine]: ...
def enclose_seam(
    patch_a: Union[BezierPatch, BezierTriangle, BSplineSurface],
    edge_a: str,
    patch_b: Union[BezierPatch, BezierTriangle, BSplineSurface],
    edge_b: str,
    *,
    reversed: Flag = False,
    level: str = "G1",
    profile: str = "default",
    gap_mm: Optional[Number] = None,
    angle_deg: Optional[Number] = None,
    curvature_rel: Optional[Number] = None,
    flat_radius_mm: Optional[Number] = None,
    crease_deg: Optional[Number] = None,
) -> _r.EnclosedSeam: ...
def arc_length_derivatives(derivatives: Numbers, speed_noise: Number = 0.0) -> Optional[Array]: ...
def measure_joint(
    a: Curve,
    b: Curve,
    order: Whole = 3,
    *,
    profile: str = "default",
    gap_mm: Optional[Number] = None,
    angle_deg: Optional[Number] = None,
    curvature_rel: Optional[Number] = None,
    flat_radius_mm: Optional[Number] = None,
) -> _r.CurveJoint: ...
def frenet_frame(curve: Curve, t: Parameter) -> _r.FrenetFrame: ...
def find_degeneracies(curve: Curve, resolution: Number = 1e-09) -> _r.CurveDegeneracies: ...
def arc_length(
    curve: Curve,
    tolerance_mm: Number,
    first: Optional[Parameter] = None,
    last: Optional[Parameter] = None,
) -> _r.ArcLength: ...
@overload
def parameter_at_length(curve: Curve, length_mm: float, tolerance_mm: Number) -> float: ...
@overload
def parameter_at_length(
    curve: Curve, length_mm: Parameter, tolerance_mm: Number
) -> Union[float, Array]: ...
def rotation_minimizing_frames(
    curve: Curve, parameters: Numbers, normal: Optional[Numbers] = None
) -> _r.MovingFrames: ...

# Joins

def join_rows(
    surface: Surface,
    edge: str,
    *,
    alpha: Optional[Numbers] = None,
    beta: Optional[Numbers] = None,
    p: Optional[Numbers] = None,
    q: Optional[Numbers] = None,
    h: Optional[Numbers] = None,
    k: Optional[Numbers] = None,
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
    e3: Optional[Numbers] = None,
    connection: Optional[Functions] = None,
    order: Optional[Whole] = 1,
    degree_across: Optional[Whole] = None,
    degree: Optional[Whole] = None,
    reversed: Flag = False,
) -> Tuple[Array, Array]: ...
def continuation(
    surface: Surface,
    edge: str,
    *,
    alpha: Optional[Numbers] = None,
    beta: Optional[Numbers] = None,
    p: Optional[Numbers] = None,
    q: Optional[Numbers] = None,
    h: Optional[Numbers] = None,
    k: Optional[Numbers] = None,
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
    e3: Optional[Numbers] = None,
    connection: Optional[Functions] = None,
    order: Optional[Whole] = 1,
    degree_across: Optional[Whole] = None,
    degree: Optional[Whole] = None,
    reversed: Flag = False,
) -> BezierPatch: ...
def triangle_continuation(
    surface: Surface,
    edge: str,
    *,
    alpha: Optional[Numbers] = None,
    beta: Optional[Numbers] = None,
    p: Optional[Numbers] = None,
    q: Optional[Numbers] = None,
    h: Optional[Numbers] = None,
    k: Optional[Numbers] = None,
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
    e3: Optional[Numbers] = None,
    connection: Optional[Functions] = None,
    order: Optional[Whole] = 1,
    degree: Optional[Whole] = None,
    reversed: Flag = False,
) -> BezierTriangle: ...

_Surface = TypeVar("_Surface", BezierPatch, BezierTriangle)

def joined(
    surface: _Surface,
    edge: str,
    given: Surface,
    given_edge: str,
    *,
    alpha: Optional[Numbers] = None,
    beta: Optional[Numbers] = None,
    p: Optional[Numbers] = None,
    q: Optional[Numbers] = None,
    h: Optional[Numbers] = None,
    k: Optional[Numbers] = None,
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
    e3: Optional[Numbers] = None,
    connection: Optional[Functions] = None,
    order: Optional[Whole] = 1,
    reversed: Flag = False,
) -> _Surface: ...
def blend(
    a: Surface,
    edge_a: str,
    b: Surface,
    edge_b: str,
    order: Whole = 1,
    *,
    reversed: Flag = False,
    to_a: Functions = {},
    to_b: Functions = {},
) -> BezierPatch: ...
def orient(
    a: BezierPatch, edge_a: str, b: BezierPatch, edge_b: str
) -> Tuple[BezierPatch, BezierPatch, bool]: ...
def edge_patches(
    surface: Union[BezierPatch, BSplineSurface], edge: str, breaks: Numbers = ()
) -> List[BezierPatch]: ...
def edge_pairs(
    a: Union[BezierPatch, BSplineSurface],
    edge_a: str,
    b: Union[BezierPatch, BSplineSurface],
    edge_b: str,
    reversed: Flag = False,
) -> List[Tuple[BezierPatch, BezierPatch]]: ...
def join_condition(
    a: Surface,
    edge_a: str,
    b: Surface,
    edge_b: str,
    *,
    reversed: Flag = False,
    tolerance: Optional[Number] = None,
    connection: Optional[Functions] = None,
) -> _r.JoinCondition: ...
def fit_connection(
    a: Surface,
    edge_a: str,
    b: Surface,
    edge_b: str,
    *,
    reversed: Flag = False,
    order: Whole = 1,
    alpha_degree: Optional[Whole] = None,
    beta_degree: Optional[Whole] = None,
    p_degree: Optional[Whole] = None,
    q_degree: Optional[Whole] = None,
    h_degree: Optional[Whole] = None,
    k_degree: Optional[Whole] = None,
    tolerance: Optional[Number] = None,
) -> _r.ConnectionFit: ...
def nearest_join(
    a: Union[BezierPatch, BSplineSurface],
    edge_a: str,
    b: Union[BezierPatch, BSplineSurface],
    edge_b: str,
    order: Whole = 1,
    moves: str = "both",
    reversed: Flag = False,
    *,
    weights_a: Optional[Numbers] = None,
    weights_b: Optional[Numbers] = None,
    fixed_a: Optional[npt.ArrayLike] = None,
    fixed_b: Optional[npt.ArrayLike] = None,
    degree_alpha: Whole = 0,
    degree_beta: Whole = 1,
    degree_p: Whole = 0,
    degree_q: Whole = 1,
    degree_h: Whole = 0,
    degree_k: Whole = 1,
) -> _r.NearestJoin: ...
def beta_matrix(beta: Betas) -> Array: ...
def composed_beta(beta: Betas, first: Betas) -> Array: ...
def inverse_beta(beta: Betas) -> Array: ...
def reversed_beta(beta: Betas) -> Array: ...
def fit_beta(
    a: Curve, b: Curve, order: Whole = 2, *, length_mm: Optional[Number] = None
) -> _r.BetaFit: ...
def curve_join_poles(
    a: Curve,
    degree: Whole,
    beta: Betas,
    *,
    length: Number = 1.0,
    next_length: Number = 1.0,
    scale: Optional[Numbers] = None,
) -> Tuple[Array, Array]: ...
def curve_joined(
    a: Curve,
    b: Curve,
    beta: Betas,
    *,
    length: Number = 1.0,
    next_length: Number = 1.0,
    scale: Optional[Numbers] = None,
    keep_end: Flag = True,
) -> BezierCurve: ...
def curve_blend(a: Curve, b: Curve, beta: Betas, beta_end: Betas) -> BezierCurve: ...
def curve_nearest_join(
    a: Curve,
    b: Curve,
    order: Whole = 1,
    *,
    moves: str = "both",
    costs_a: Optional[Numbers] = None,
    costs_b: Optional[Numbers] = None,
    fixed_a: Optional[npt.ArrayLike] = None,
    fixed_b: Optional[npt.ArrayLike] = None,
    beta: Optional[Betas] = None,
    max_iterations: Whole = 100,
) -> _r.NearestCurveJoin: ...

# Splines

def direct_g2_spline(
    vertices: Numbers, alpha: Numbers, omega: Numbers, closed: Flag = False
) -> BezierSpline: ...
def gamma_spline(
    vertices: Numbers, lengths: Numbers = 1.0, gamma: Numbers = 1.0, closed: Flag = False
) -> BezierSpline: ...
def nu_spline(
    points: Numbers,
    knots: Optional[Numbers] = None,
    *,
    nu: Numbers = 0.0,
    ends: str = "natural",
    start_derivative: Optional[Numbers] = None,
    end_derivative: Optional[Numbers] = None,
) -> _r.InterpolatingSpline: ...
def beta_spline(
    points: Numbers,
    bias: Numbers = 1.0,
    tension: Numbers = 0.0,
    *,
    ends: str = "natural",
    start_nu: Optional[Number] = None,
    end_nu: Optional[Number] = None,
    start_derivative: Optional[Numbers] = None,
    end_derivative: Optional[Numbers] = None,
) -> _r.InterpolatingSpline: ...
def spline_knots(points: Numbers, exponent: Number = 0.5) -> List[float]: ...
def alpha_basis(a: Shape, t: Parameter) -> Array: ...
def alpha_curve(poles: Numbers, a: Shape = 1.0) -> BezierCurve: ...
def alpha_join_poles(
    poles: Numbers,
    a: Shape,
    *,
    next_a: Optional[Number] = None,
    order: Whole = 1,
    beta1: Number = 1.0,
    beta2: Number = 0.0,
    length: Number = 1.0,
    next_length: Number = 1.0,
) -> Array: ...
def energy_optimal_alpha(
    poles: Numbers, energy: str = "curvature", *, a_min: Number = 0.05, a_max: Number = 1.0
) -> _r.AlphaOptimum: ...
def alpha_spline(
    polygon: Numbers,
    a: Numbers,
    *,
    order: Whole = 2,
    lengths: Optional[Numbers] = None,
    beta1: Optional[Numbers] = None,
    beta2: Optional[Numbers] = None,
    closed: Flag = False,
) -> BezierSpline: ...
def alpha_surface(net: Numbers, a_u: Number = 1.0, a_v: Number = 1.0) -> BezierPatch: ...
def alpha_join_rows(
    net: Numbers,
    a_u: Number,
    a_v: Number,
    *,
    next_a_u: Optional[Number] = None,
    next_a_v: Optional[Number] = None,
    order: Whole = 1,
    beta1: Number = 1.0,
    beta2: Number = 0.0,
    length: Number = 1.0,
    next_length: Number = 1.0,
) -> Array: ...
def alpha_seam_condition(
    net: Numbers, a_u: Number, a_v: Number, next_a_v: Optional[Number] = None
) -> _r.AlphaSeamCondition: ...
def alpha_sliding_rows(
    net: Numbers,
    a_u: Number,
    a_v: Number,
    alpha: Number,
    beta0: Number,
    beta1: Number,
    *,
    next_a_u: Optional[Number] = None,
    next_a_v: Optional[Number] = None,
) -> Array: ...
def fit_alpha_seam(
    net: Numbers,
    a_u: Number,
    a_v: Number,
    next_net: Numbers,
    next_a_u: Number,
    next_a_v: Number,
    *,
    length: Number = 1.0,
    next_length: Number = 1.0,
) -> _r.AlphaSeamFit: ...
def alpha_nearest_join(
    net: Numbers,
    a_u: Number,
    a_v: Number,
    next_net: Numbers,
    next_a_u: Number,
    next_a_v: Number,
    *,
    order: Whole = 1,
    parametric: Flag = False,
    length: Number = 1.0,
    next_length: Number = 1.0,
) -> Optional[_r.AlphaNearestJoin]: ...

# Blends

class JointBlend:
    def __init__(
        self,
        first: FramePair,
        second: FramePair,
        *,
        order: Whole = 2,
        frame_tolerance: Number = 1e-6,
        most_defect: Number = 1e-11,
        max_degree: Whole = 20,
        least_tangent: Number = 0.05,
        most_departure: Number = 1.0,
        free_betas: Flag = False,
    ) -> None: ...
    def at(self, omega: Number) -> _r.BlendedJoint: ...
    @property
    def remedy(self) -> str: ...
    @property
    def degree_a(self) -> int: ...
    @property
    def degree_b(self) -> int: ...
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class SplineBlend:
    def __init__(
        self,
        keys: Sequence[Curve],
        omegas: Optional[Numbers] = None,
        *,
        order: Whole = 2,
        continuity: str = "C0",
        keep_lower_orders: Flag = False,
        frame_tolerance: Number = 1e-6,
        most_defect: Number = 1e-11,
        max_degree: Whole = 0,
        least_tangent: Number = 0.05,
        most_departure: Number = 1.0,
        free_betas: Flag = False,
    ) -> None: ...
    def frame_at(self, omega: Number) -> _r.SplineFrame: ...
    @property
    def omegas(self) -> List[float]: ...
    @property
    def degree(self) -> int: ...
    @property
    def orders(self) -> List[int]: ...
    @property
    def remedies(self) -> List[str]: ...
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

Frames = Union[SplineBlend, Callable[[float], Curve]]
SheetEnd = Union[None, _r.FrameRibbon, Tuple[_r.FrameRibbon, Whole]]

def match_pieces(
    keys: Sequence[Curve],
    *,
    by: str = "length",
    given: Optional[Sequence[Numbers]] = None,
    find_start: Flag = False,
    find_direction: Flag = False,
    closeness: Number = 0.01,
    corner_rad: Number = 0.17453292519943295,
    prominence: Number = 0.1,
    reach: Number = 0.2,
) -> _r.MatchedCurves: ...
def common_knots(
    keys: Sequence[Curve],
    *,
    tolerance_mm: Number = 0.001,
    by: str = "length",
    given: Optional[Sequence[Numbers]] = None,
    find_start: Flag = False,
    find_direction: Flag = False,
    corner_rad: Number = 0.17453292519943295,
    prominence: Number = 0.1,
    reach: Number = 0.2,
    joint_tolerance: Number = 1e-6,
    max_segments: Whole = 10000,
) -> _r.CommonKnots: ...
def blend_joint(
    first: FramePair,
    second: FramePair,
    omega: Number,
    *,
    order: Whole = 2,
    frame_tolerance: Number = 1e-6,
    most_defect: Number = 1e-11,
    max_degree: Whole = 20,
    least_tangent: Number = 0.05,
    most_departure: Number = 1.0,
    free_betas: Flag = False,
) -> _r.BlendedJoint: ...
def plain_blend(
    first: FramePair,
    second: FramePair,
    order: Whole = 2,
    *,
    tolerance: Number = 1e-11,
    omegas: Numbers = (),
) -> _r.PlainBlend: ...
def balance_ratios(beta: Betas, degree_a: Whole, degree_b: Whole) -> _r.BalanceRatios: ...
def balance_relations(beta: Betas, degree_a: Whole, degree_b: Whole) -> Array: ...
def auxiliary_points(
    poles: Numbers, beta: Betas, degree_a: Whole, degree_b: Whole
) -> _r.AuxiliaryPoints: ...
def balanced_poles(points: Numbers, beta: Betas, degree_a: Whole, degree_b: Whole) -> Array: ...
def frame_loft(
    frames: Frames,
    omegas: Optional[Numbers] = None,
    *,
    order: Whole = 2,
    tolerance_mm: Number = 1e-3,
    stations: Optional[Numbers] = None,
    kinks: Optional[Numbers] = None,
    closed: Flag = False,
    first_spans: Whole = 4,
    max_spans: Whole = 256,
    checks: Whole = 4,
    derivative_bound: Optional[Tuple[Whole, Number]] = None,
    progress: Progress = None,
) -> _r.FrameLoft: ...
def frame_sheet(
    frames: Frames,
    omegas: Optional[Numbers] = None,
    *,
    start: SheetEnd = None,
    end: SheetEnd = None,
    order: Whole = 2,
    tolerance_mm: Number = 1e-3,
    stations: Optional[Numbers] = None,
    kinks: Optional[Numbers] = None,
    first_spans: Whole = 4,
    max_spans: Whole = 256,
    checks: Whole = 4,
    derivative_bound: Optional[Tuple[Whole, Number]] = None,
    progress: Progress = None,
) -> _r.FrameLoft: ...
def edge_ribbon(
    surface: Union[BezierPatch, BSplineSurface, _r.FrameLoft],
    edge: str,
    side: str,
    rate: Number = 1.0,
    *,
    reversed: Flag = False,
    closed: Flag = False,
) -> _r.FrameRibbon: ...
def even_rate(
    frames: Frames,
    omegas: Optional[Numbers],
    ribbon: _r.FrameRibbon,
    side: str,
    share: Number = 0.125,
) -> float: ...

# Fills

Side = Union[Curve, Tuple[Any, ...], List[Any]]

def n_sided_fill(
    sides: Sequence[Side],
    *,
    law: str = "linear",
    fairness_order: Whole = 3,
    corner_tolerance_rad: Number = 0.0,
    curvature_degrees: Optional[Whole] = None,
) -> _r.NSidedFill: ...
def three_sided_fill(
    sides: Sequence[Side], *, fairness_order: Whole = 3, corner_tolerance_rad: Number = 0.0
) -> _r.ThreeSidedFill: ...
def ring_fill(
    sides: Sequence[Side],
    *,
    law: str = "linear",
    fairness_order: Whole = 2,
    corner_tolerance_rad: Number = 0.0,
    curvature_degrees: Optional[Whole] = None,
) -> _r.RingFill: ...
def umbrella(
    spokes: Sequence[Union[Curve, Numbers]],
    *,
    closed: Flag = True,
    kinds: Optional[Sequence[str]] = None,
    members: Union[None, Sequence[Surface], _r.Umbrella, _r.G2Umbrella] = None,
    degree: Optional[Whole] = None,
    slopes: Optional[Numbers] = None,
    cross_slopes: Optional[Numbers] = None,
    form: Optional[Numbers] = None,
    boundary: Optional[Sequence[Optional[CurvePair]]] = None,
    across: Optional[Sequence[Optional[CurvePair]]] = None,
    gap_mm: Number = ...,
    flat_rad: Number = ...,
) -> _r.Umbrella: ...
def g2_umbrella(
    spokes: Sequence[Union[Curve, Numbers]],
    *,
    closed: Flag = True,
    members: Union[None, Sequence[BezierPatch], _r.Umbrella, _r.G2Umbrella] = None,
    degree: Optional[Whole] = None,
    form: Optional[Numbers] = None,
    gap_mm: Number = ...,
    flat_rad: Number = ...,
) -> _r.G2Umbrella: ...
def umbrella_twists(
    tangents: Numbers,
    second_derivatives: Numbers,
    *,
    closed: Flag = True,
    slopes: Optional[Numbers] = None,
    cross_slopes: Optional[Numbers] = None,
    form: Optional[Numbers] = None,
    flat_rad: Number = ...,
) -> _r.UmbrellaTwists: ...
def umbrella_inside(
    sides: Sequence[Union[Curve, Numbers]],
    *,
    spoke_degree: Whole = ...,
    degree: Optional[Whole] = None,
    gap_mm: Number = ...,
) -> _r.Umbrella: ...

# Models

class Report:
    @property
    def passed(self) -> bool: ...
    @property
    def seams(self) -> List[_r.Seam]: ...
    def __len__(self) -> int: ...
    def __copy__(self) -> Report: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Report: ...
    def __getstate__(self) -> List[Any]: ...
    def __setstate__(self, arg0: List[Any]) -> None: ...
    def to_dict(self) -> Dict[str, Any]: ...
    def to_json(self) -> str: ...
    def to_csv(self) -> str: ...
    def to_table(self) -> str: ...

class Model:
    @property
    def path(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def length_unit(self) -> str: ...
    @property
    def notes(self) -> List[str]: ...
    @property
    def read_s(self) -> float: ...
    @property
    def face_count(self) -> int: ...
    @property
    def edge_count(self) -> int: ...
    @property
    def attributes(self) -> List[_r.ShapeAttribute]: ...
    @staticmethod
    def from_freecad(shape: Any) -> Model: ...
    def to_freecad(self) -> Any: ...
    @staticmethod
    def from_patches(
        items: Union[ModelItem, Sequence[ModelItem]],
        names: Optional[Sequence[Optional[str]]] = None,
        *,
        tolerance_mm: Number = 1e-07,
        sew_mm: Optional[Number] = None,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> Model: ...
    def surface(self, face: Whole) -> BSplineSurface: ...
    def curve(self, edge: Whole) -> BSplineCurve: ...
    def analyze(
        self,
        *,
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        level: str = "G1",
        match_mm: Optional[Number] = 0.0,
        verdict_only: Flag = False,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> Report: ...
    def write(
        self,
        path: Path,
        *,
        overwrite: Flag = False,
        overwrite_source: Flag = False,
        afresh: Flag = False,
        progress: Progress = None,
    ) -> _r.WriteResult: ...
    def display_mesh(
        self,
        *,
        curvatures: Flag = True,
        before: Optional[Model] = None,
        moved_faces: Sequence[Whole] = (),
        rough_mm: Number = 0.0,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> DisplayMesh: ...
    def blend_surface(
        self,
        start: Union[Whole, Sequence[Whole]],
        end: Union[Whole, Sequence[Whole]],
        *,
        start_faces: Union[Whole, Sequence[Whole]] = (),
        end_faces: Union[Whole, Sequence[Whole]] = (),
        start_order: str = "G2",
        end_order: str = "G2",
        start_tension: Number = 1.0,
        end_tension: Number = 1.0,
        flip: Flag = False,
        lateral: Union[Whole, Sequence[Whole]] = (),
        lateral_faces: Union[Whole, Sequence[Whole]] = (),
        lateral_order: str | dict[int, str] = "G0",
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        progress: Progress = None,
    ) -> BlendedSurface: ...
    def extend_surface(
        self,
        edges: Union[Whole, Sequence[Whole]],
        length_mm: Optional[Number] = None,
        *,
        to: Optional[Whole] = None,
        faces: Union[Whole, Sequence[Whole]] = (),
        order: str = "G2",
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        progress: Progress = None,
    ) -> BlendedSurface: ...
    def side_ribbon(
        self,
        edges: Union[Whole, Sequence[Whole]],
        depth_mm: Number,
        *,
        faces: Union[Whole, Sequence[Whole]] = (),
        order: str = "G2",
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        progress: Progress = None,
    ) -> _r.SideRibbon: ...
    def match_faces(
        self,
        first: Whole,
        second: Whole,
        *,
        target: str = "G1",
        moves: str = "second",
        max_move_mm: Optional[Number] = None,
        hold_sides: Flag = False,
        match_mm: Number = 0.1,
        edge: Whole = 0,
        depth_mm: Optional[Number] = None,
        convert: Flag = False,
        fairness: Number = 1.5,
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        progress: Progress = None,
    ) -> MatchResult: ...
    def match_sides(
        self,
        face: Whole,
        sides: Sequence[Union[Whole, Sequence[Whole], Dict[str, Any]]],
        *,
        target: str = "G1",
        depth_mm: Optional[Number] = None,
        hold: str = "none",
        average: Flag = False,
        convert: Flag = False,
        max_move_mm: Optional[Number] = None,
        match_mm: Number = 0.1,
        fairness: Number = 1.5,
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> SideMatchResult: ...
    def corner_edges(self, vertex: Whole) -> List[int]: ...
    def corner_fillet(
        self,
        vertex: Whole,
        radii_mm: Union[Number, Dict[int, float]],
        *,
        setbacks_mm: Union[None, Number, Dict[int, float]] = None,
        section_mm: Number = 1e-06,
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        patches_only: Flag = False,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> CornerFillet: ...
    def repair(
        self,
        *,
        target: str = "G1",
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        max_move_mm: Union[None, Number, str] = "auto",
        fairness: Number = ...,
        keep_curvature: Flag = False,
        max_time_s: Optional[Number] = None,
        edges: Optional[Sequence[Whole]] = None,
        fixed_faces: Sequence[Whole] = (),
        match_mm: Optional[Number] = 0.0,
        sew: Flag = True,
        convert_analytic: Flag = False,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> RepairReport: ...
    def holes(self, *, corner_deg: Number = 15.0, gap_mm: Number = ...) -> List[_r.Hole]: ...
    def fill(
        self,
        *,
        hole: Union[None, Whole, _r.Hole] = None,
        face: Union[None, Whole, Sequence[Whole]] = None,
        target: str = "G1",
        gap_mm: Number = ...,
        angle_deg: Number = 0.01,
        curvature_rel: Number = ...,
        corner_deg: Number = 15.0,
        keep_anyway: Flag = False,
        repair_first: Flag = False,
        jobs: Whole = 0,
        progress: Progress = None,
    ) -> FillReport: ...
    def __copy__(self) -> Model: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Model: ...
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class DisplayMesh:
    @property
    def points(self) -> Array: ...
    @property
    def normals(self) -> Array: ...
    @property
    def parameters(self) -> Array: ...
    @property
    def triangles(self) -> npt.NDArray[np.int32]: ...
    @property
    def first_nodes(self) -> npt.NDArray[np.uint64]: ...
    @property
    def first_triangles(self) -> npt.NDArray[np.uint64]: ...
    @property
    def principal_curvatures(self) -> Array: ...
    @property
    def mean_curvature(self) -> Array: ...
    @property
    def gaussian_curvature(self) -> Array: ...
    @property
    def moves_mm(self) -> Array: ...
    @property
    def faults(self) -> List[_r.MeshFault]: ...
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

class BlendedSurface:
    @property
    def reached(self) -> bool: ...
    @property
    def surface(self) -> BSplineSurface: ...
    @property
    def seams(self) -> List[_r.Seam]: ...
    @property
    def spans(self) -> int: ...
    @property
    def sides(self) -> List[Dict[str, Any]]: ...
    @property
    def laterals(self) -> List[Dict[str, Any]]: ...
    @property
    def fold(self) -> Optional[Dict[str, Any]]: ...
    @property
    def to(self) -> Optional[Dict[str, Any]]: ...
    @property
    def model(self) -> Model: ...
    def to_dict(self) -> Dict[str, Any]: ...
    def __copy__(self) -> BlendedSurface: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> BlendedSurface: ...

class MatchResult:
    @property
    def matched(self) -> bool: ...
    @property
    def reason(self) -> str: ...
    @property
    def reason_code(self) -> str: ...
    @property
    def remedy(self) -> str: ...
    @property
    def depth_mm(self) -> float: ...
    @property
    def moves(self) -> List[Dict[str, Any]]: ...
    @property
    def exact(self) -> bool: ...
    @property
    def model(self) -> Model: ...
    @property
    def before(self) -> Optional[_r.Seam]: ...
    @property
    def after(self) -> Optional[_r.Seam]: ...
    @property
    def largest_move_mm(self) -> float: ...
    def __copy__(self) -> MatchResult: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> MatchResult: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn: ...
    def to_dict(self) -> Dict[str, Any]: ...

class SideMatchResult:
    @property
    def matched(self) -> bool: ...
    @property
    def reason(self) -> str: ...
    @property
    def reason_code(self) -> str: ...
    @property
    def remedy(self) -> str: ...
    @property
    def depth_mm(self) -> float: ...
    @property
    def seams(self) -> List[Dict[str, Any]]: ...
    @property
    def moves(self) -> List[Dict[str, Any]]: ...
    @property
    def model(self) -> Model: ...
    def __copy__(self) -> SideMatchResult: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> SideMatchResult: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn: ...
    def to_dict(self) -> Dict[str, Any]: ...

class CornerFillet:
    @property
    def model(self) -> Model: ...
    @property
    def met(self) -> bool: ...
    @property
    def shortfall(self) -> str: ...
    @property
    def shortfall_code(self) -> str: ...
    @property
    def shortfall_facts(self) -> _r.ReasonFacts: ...
    @property
    def filled_by(self) -> str: ...
    @property
    def patches_shortfall(self) -> str: ...
    @property
    def patches(self) -> List[BezierPatch]: ...
    def __copy__(self) -> CornerFillet: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> CornerFillet: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn: ...
    def to_dict(self) -> Dict[str, Any]: ...
    def to_json(self) -> str: ...
    def to_table(self) -> str: ...
    def write(
        self,
        path: Path,
        *,
        overwrite: Flag = False,
        overwrite_source: Flag = False,
        keep_anyway: Flag = False,
        progress: Progress = None,
    ) -> _r.CheckedWriteResult: ...

class RepairReport:
    @property
    def model(self) -> Model: ...
    @property
    def before(self) -> Report: ...
    @property
    def after(self) -> Report: ...
    @property
    def changed(self) -> bool: ...
    @property
    def passed(self) -> bool: ...
    @property
    def seams(self) -> List[_r.SeamRepair]: ...
    @property
    def moves(self) -> List[_r.FaceMove]: ...
    @property
    def edge_moves(self) -> List[_r.EdgeMove]: ...
    @property
    def converted(self) -> List[_r.FaceConversion]: ...
    @property
    def summary(self) -> _r.RepairSummary: ...
    def __copy__(self) -> RepairReport: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> RepairReport: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn: ...
    def to_dict(self) -> Dict[str, Any]: ...
    def to_json(self) -> str: ...
    def to_table(self) -> str: ...
    def write(
        self,
        path: Path,
        *,
        overwrite: Flag = False,
        overwrite_source: Flag = False,
        progress: Progress = None,
    ) -> _r.CheckedWriteResult: ...

class FillReport:
    @property
    def model(self) -> Model: ...
    @property
    def filled(self) -> bool: ...
    @property
    def reached(self) -> bool: ...
    @property
    def reason(self) -> str: ...
    @property
    def reason_code(self) -> str: ...
    @property
    def method(self) -> str: ...
    @property
    def around(self) -> Optional[Dict[str, Any]]: ...
    @property
    def causes(self) -> List[Dict[str, Any]]: ...
    @property
    def largest_angle_deg(self) -> Optional[float]: ...
    @property
    def largest_gap_mm(self) -> Optional[float]: ...
    @property
    def largest_curvature_rel(self) -> Optional[float]: ...
    @property
    def curvature_per_mm(self) -> Optional[float]: ...
    @property
    def around_curvature_per_mm(self) -> Optional[float]: ...
    @property
    def both_ways_per_mm(self) -> Optional[float]: ...
    @property
    def waves(self) -> Optional[float]: ...
    @property
    def removed_curvature_per_mm(self) -> Optional[float]: ...
    @property
    def curvature_jump_per_mm(self) -> Optional[float]: ...
    def __copy__(self) -> FillReport: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> FillReport: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn: ...
    def to_dict(self) -> Dict[str, Any]: ...
    def to_json(self) -> str: ...
    def to_table(self) -> str: ...
    def write(
        self,
        path: Path,
        *,
        overwrite: Flag = False,
        overwrite_source: Flag = False,
        progress: Progress = None,
    ) -> _r.CheckedWriteResult: ...

def read(path: Path, progress: Progress = None) -> Model: ...

# For the bridge to FreeCAD

def _clamped_curve(
    degree: int,
    knots: Sequence[float],
    multiplicities: Sequence[int],
    poles: Numbers,
    weights: Optional[Numbers],
    periodic: bool,
) -> BSplineCurve: ...
def _model_from_binary(arg0: bytes) -> Model: ...
def _model_from_text(arg0: str) -> Model: ...
def _binary_from_model(arg0: Model) -> bytes: ...
def _text_from_model(arg0: Model) -> str: ...
def _ensure_shape_type() -> None: ...
def _model_from_pointer(arg0: object) -> Model: ...
def _pointer_from_model(arg0: Model) -> object: ...
