# SPDX-License-Identifier: LGPL-2.1-or-later
# The types of the compiled part. tests/plugin/python/test_stubs.py compares names and parameters.

import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, TypeVar, Union, overload

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
Curve = Union[BezierCurve, BSplineCurve, BezierSpline, _r.InterpolatingSpline]
Surface = Union[BezierPatch, BezierTriangle]
Betas = Union[Numbers, _r.BetaFit, _r.NearestCurveJoin]
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
    def __eq__(self, arg0: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, arg0: Tuple[Any, ...]) -> None: ...

# Measures

def measure_pair(a: SurfaceJet, b: SurfaceJet) -> _r.PairMeasure: ...
def curvature_tensor(jet: SurfaceJet) -> Array: ...
def principal_curvatures(jet: SurfaceJet) -> Tuple[float, float, Array, Array]: ...
def surface_shape(
    patch: Surface, u: Parameter, v: Parameter, direction: Optional[Numbers] = None
) -> _r.SurfaceShape: ...
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
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
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
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
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
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
    connection: Optional[Functions] = None,
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
    e0: Optional[Numbers] = None,
    e1: Optional[Numbers] = None,
    e2: Optional[Numbers] = None,
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
    fairness_order: Whole = 2,
    corner_tolerance_rad: Number = 0.0,
    curvature_degrees: Optional[Whole] = None,
) -> _r.RingFill: ...
def umbrella(
    spokes: Sequence[Union[Curve, Numbers]],
    *,
    closed: Flag = True,
    kinds: Optional[Sequence[str]] = None,
    members: Union[None, Sequence[Surface], _r.Umbrella] = None,
    degree: Optional[Whole] = None,
    slopes: Optional[Numbers] = None,
    cross_slopes: Optional[Numbers] = None,
    form: Optional[Numbers] = None,
    gap_mm: Number = ...,
    flat_rad: Number = ...,
) -> _r.Umbrella: ...
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
        profile: str = "default",
        gap_mm: Optional[Number] = None,
        angle_deg: Optional[Number] = None,
        curvature_rel: Optional[Number] = None,
        flat_radius_mm: Optional[Number] = None,
        crease_deg: Optional[Number] = None,
        progress: Progress = None,
    ) -> MatchResult: ...
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
        face: Optional[Whole] = None,
        target: str = "G1",
        gap_mm: Number = ...,
        angle_deg: Number = 0.01,
        curvature_rel: Number = ...,
        corner_deg: Number = 15.0,
        keep_anyway: Flag = False,
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

class MatchResult:
    @property
    def matched(self) -> bool: ...
    @property
    def reason(self) -> str: ...
    @property
    def reason_code(self) -> str: ...
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
    def patches(self) -> List[BezierPatch]: ...
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
    def largest_angle_deg(self) -> Optional[float]: ...
    @property
    def largest_gap_mm(self) -> Optional[float]: ...
    @property
    def largest_curvature_rel(self) -> Optional[float]: ...
    @property
    def curvature_jump_per_mm(self) -> Optional[float]: ...
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
