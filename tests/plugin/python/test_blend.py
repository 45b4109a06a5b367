# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of joints and curves, lofts through frames. The oracles are closed forms and derivatives
of Bezier polynomials, written here with numpy."""

import copy
import math
import pickle

import numpy as np
import pytest
import seamwright
from seamwright import BezierCurve, BezierSpline, JointBlend, SplineBlend, results
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_blend.py"))


def at(poles, t, order=0):
    """The derivative of that order of a Bezier curve, by differences of poles."""
    poles = np.array(poles, float)
    for _ in range(order):
        poles = (len(poles) - 1) * np.diff(poles, axis=0)
    n = len(poles) - 1
    return sum(math.comb(n, k) * t**k * (1 - t) ** (n - k) * p for k, p in enumerate(poles))


def tangent_and_curvature(poles, t):
    """Unit tangent and curvature vector."""
    first, second = at(poles, t, 1), at(poles, t, 2)
    square = first @ first
    return first / math.sqrt(square), (second - (second @ first) / square * first) / square


def misfit(a, b):
    """Differences of point, tangent and curvature vector where a ends and b begins."""
    (u, k), (v, m) = tangent_and_curvature(a, 1), tangent_and_curvature(b, 0)
    return [np.abs(x).max() for x in (at(a, 1) - at(b, 0), u - v, k - m)]


def frame(beta, turn=0.0, degree=5):
    """A joint that is G2 with these betas, turned in the plane."""
    c, s = math.cos(turn), math.sin(turn)
    rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    poles = np.zeros((degree + 1, 3))
    poles[:, 0] = np.arange(-degree, 1)
    poles[:, 1] = 0.15 * poles[:, 0] ** 2
    poles[:, 2] = 0.02 * poles[:, 0] ** 3
    after = np.zeros((degree + 1, 3))
    after[:, 0] = 2 * np.arange(degree + 1)
    after[:, 1] = 0.3 * np.arange(degree + 1) ** 2
    a, b = BezierCurve(poles @ rotation.T), BezierCurve(after @ rotation.T)
    return a, seamwright.curve_joined(a, b, beta, keep_end=False)


FIRST, SECOND = frame([1.5, 0.4]), frame([0.6, -1.0], 0.7)


def test_the_frames_are_the_first_and_the_last_joint():
    blend = JointBlend(FIRST, SECOND)
    for omega, (a, b) in ((0, FIRST), (1, SECOND)):
        joint = blend.at(omega)
        assert isinstance(joint, results.BlendedJoint)
        for t in np.linspace(0, 1, 7):
            assert np.abs(at(joint.a.poles, t) - at(a.poles, t)).max() < 1e-13
            assert np.abs(at(joint.b.poles, t) - at(b.poles, t)).max() < 1e-13


@pytest.mark.parametrize("omega", [0.1, 0.5, 0.85])
def test_a_blended_joint_is_g2_where_the_plain_one_is_not(omega):
    joint = seamwright.blend_joint(FIRST, SECOND, omega)
    assert max(misfit(joint.a.poles, joint.b.poles)) < 1e-11
    assert joint.order == 2 and joint.remedy == "balanced" and joint.faults == []
    assert len(joint.defects) == 3 and max(joint.defects) < 1e-11
    plain = [(1 - omega) * x.poles + omega * y.poles for x, y in zip(FIRST, SECOND)]
    assert misfit(*plain)[1] > 1e-3
    # beta_1 is the ratio of the first derivatives.
    speeds = [np.linalg.norm(at(joint.b.poles, 0, 1)), np.linalg.norm(at(joint.a.poles, 1, 1))]
    assert joint.beta[0] == pytest.approx(speeds[0] / speeds[1], rel=1e-12)
    assert JointBlend(FIRST, SECOND).at(omega) == joint


def test_g1_moves_only_the_pole_at_the_joint():
    """The closed form of C11.1: P_0 = (m beta_1 P_(-1) + m' P_1) / (m' + m beta_1)."""
    omega = 0.3
    joint = seamwright.blend_joint(FIRST, SECOND, omega, order=1)
    plain_a, plain_b = [(1 - omega) * x.poles + omega * y.poles for x, y in zip(FIRST, SECOND)]
    speeds = [np.linalg.norm(a.poles[-1] - a.poles[-2]) for a in (FIRST[0], SECOND[0])]
    ratio = speeds[1] / speeds[0]
    weights = np.array([1 - omega, ratio * omega])
    beta_1 = weights @ [1.5, 0.6] / weights.sum()
    pole = (beta_1 * plain_a[-2] + plain_b[1]) / (1 + beta_1)  # both degrees are 5
    assert joint.beta[0] == pytest.approx(beta_1, rel=1e-12)
    assert np.abs(joint.a.poles[:-1] - plain_a[:-1]).max() < 1e-13
    assert np.abs(joint.b.poles[1:] - plain_b[1:]).max() < 1e-13
    assert np.abs(joint.a.poles[-1] - pole).max() < 1e-12
    assert joint.moved_mm == pytest.approx(np.linalg.norm(pole - plain_a[-1]), abs=1e-12)


def test_plain_blend_names_the_condition():
    same = seamwright.plain_blend(FIRST, frame([1.5, 0.4], 0.7), omegas=[0, 0.5, 1])
    assert same.keeps and same.kind == "equal betas" and same.betas_defect < 1e-12
    assert all(np.abs(beta - [1.5, 0.4]).max() < 1e-10 for beta in same.betas)
    none = seamwright.plain_blend(FIRST, SECOND)
    assert not none.keeps and none.kind == "none" and none.betas_defect > 1e-3
    u, v = (at(a.poles, 1, 1) for a in (FIRST[0], SECOND[0]))
    angle = math.atan2(np.linalg.norm(np.cross(u, v)), u @ v)
    assert none.betas == [] and none.angle_rad == pytest.approx(angle, abs=1e-12)
    assert none.ratio == pytest.approx(1, abs=1e-12)
    beta_1 = seamwright.plain_blend(frame([2, 1]), frame([2, -3]))
    assert beta_1.kind == "equal beta_1" and beta_1.keeps
    parallel = seamwright.plain_blend(frame([2, 1]), frame([0.5, 1]), order=1)
    assert parallel.kind == "parallel tangents"
    assert not seamwright.plain_blend(frame([2, 1]), frame([0.5, 1])).keeps


def test_the_shortest_tangent_of_plain_blending():
    """|u x v| / |u - v|, or a shorter end."""
    result = seamwright.plain_blend(FIRST, frame([1.5, 0.4], 2.5)).tangent_a
    u = at(FIRST[0].poles, 1, 1)
    v = at(frame([1.5, 0.4], 2.5)[0].poles, 1, 1)
    lengths = [np.linalg.norm((1 - w) * u + w * v) for w in np.linspace(0, 1, 200001)]
    assert result.length_mm == pytest.approx(min(lengths), rel=1e-8)
    assert result.omega == pytest.approx(np.argmin(lengths) / 200000, abs=1e-5)
    assert not result.vanishes
    mirrored = tuple(BezierCurve(-curve.poles) for curve in FIRST)
    opposite = seamwright.plain_blend(FIRST, mirrored)
    assert opposite.tangent_a.vanishes and not opposite.keeps


def test_balance_of_betas_and_degrees():
    """The closed forms of C11.4 for n = 2."""
    beta, m, k = [1.3, -0.8], 4, 5
    ratios = seamwright.balance_ratios(beta, m, k)
    big_m, big_n, q = m * (m - 1) * beta[0] ** 2, k * (k - 1), m * beta[1]
    e = big_n - big_m - q
    d00 = k / (k + m * beta[0])
    d10 = (big_m + q + e * (1 - d00)) / (2 * big_m + q + e * (1 - d00))
    d11 = big_n / (2 * big_n - e * d00)
    assert np.abs(ratios.delta - [[d00, 0], [d10, d11]]).max() < 1e-14
    assert ratios.can_cut and ratios.can_solve and ratios.faults == []
    points = RANDOM.normal(size=(3, 3))
    poles = seamwright.balanced_poles(points, beta, m, k)
    assert poles.shape == (5, 3)
    relations = seamwright.balance_relations(beta, m, k)
    assert relations.shape == (2, 5) and np.abs(relations.sum(axis=1)).max() < 1e-12
    assert np.abs(relations @ poles).max() < 1e-11
    found = seamwright.auxiliary_points(poles, beta, m, k)
    assert np.abs(found.points - points).max() < 1e-11 and found.residual_mm < 1e-12
    # By derivatives: v' = beta_1 u', v'' = beta_1^2 u'' + beta_2 u'.
    a = np.vstack([np.zeros((m - 2, 3)), poles[:3]])
    b = np.vstack([poles[2:], np.zeros((k - 2, 3))])
    assert np.abs(at(b, 0, 1) - beta[0] * at(a, 1, 1)).max() < 1e-11
    second = beta[0] ** 2 * at(a, 1, 2) + beta[1] * at(a, 1, 1)
    assert np.abs(at(b, 0, 2) - second).max() < 1e-10


def test_missing_ratios_are_named():
    ratios = seamwright.balance_ratios([-1, 0], 3, 3)
    assert ratios.faults[0].kind == "negative beta" and ratios.faults[0].value == -1
    assert not ratios.can_cut
    with pytest.raises(ValueError):
        seamwright.balanced_poles(np.zeros((3, 3)), [-1, 0], 3, 3)


# Whole curves

POLYGON = np.array([[0, 0, 0], [6, 9, 1], [14, 8, 0], [19, -2, 3], [28, 1, 0], [33, 9, 2.0]])
OTHER = np.array([[0, 20, 4], [8, 34, 0], [11, 21, 9], [25, 33, 0], [29, 20, 5], [40, 26, 0.0]])


def keys(closed=False):
    return [
        seamwright.direct_g2_spline(POLYGON, 0.3, 0.65, closed),
        seamwright.direct_g2_spline(OTHER, [0.2, 0.4] * 3 if closed else 0.45, 0.8, closed),
    ]


def joints_of(curve):
    segments = [curve.segment(i).poles for i in range(curve.segments)]
    pairs = list(zip(segments, segments[1:]))
    return pairs + ([(segments[-1], segments[0])] if curve.closed else [])


@pytest.mark.parametrize("closed", [False, True])
def test_frames_of_splines_are_g2(closed):
    blend = SplineBlend(keys(closed))
    assert blend.omegas == [0, 1] and blend.degree >= 5 and set(blend.orders) == {2}
    assert blend.remedies and set(blend.remedies) <= {"plain", "balanced", "smallest move"}
    for omega in (0, 0.2, 0.5, 0.9, 1):
        frame = blend.frame_at(omega)
        assert isinstance(frame.curve, BezierSpline) and frame.curve.closed == closed
        pairs = joints_of(frame.curve)
        assert len(pairs) == len(frame.joints) == len(blend.orders)
        for (a, b), joint in zip(pairs, frame.joints):
            assert max(misfit(a, b)) < 1e-9 and joint.order == 2 and max(joint.defects) < 1e-10
            speed = np.linalg.norm(at(b, 0, 1)) / np.linalg.norm(at(a, 1, 1))
            assert joint.beta[0] == pytest.approx(speed, rel=1e-9)


def test_keys_are_frames_and_the_plain_blend_is_not_smooth():
    first, second = keys()
    blend = SplineBlend([first, second], [2, 5])
    for omega, key in ((2, first), (5, second)):
        curve = blend.frame_at(omega).curve
        for t in np.linspace(key.knots[0], key.knots[-1], 23):
            assert np.abs(curve.point(t) - key.point(t)).max() < 1e-12
    plain = [(a + b) / 2 for a, b in zip(*([c.segment(i).poles for i in range(3)] for c in keys()))]
    assert max(misfit(a, b)[1] for a, b in zip(plain, plain[1:])) > 1e-2


@pytest.mark.parametrize("continuity", ["C0", "C1", "C2"])
def test_equal_betas_are_interpolated(continuity):
    """Affine images have the betas of the curve: poles are those of the interpolation."""
    first = keys()[0]
    images = []
    for scale, shift in ((1, 0), (1.5, 7), (0.8, 20)):
        images.append(BezierSpline(3, first.knots, scale * first.poles + [0, 0, shift]))
    blend = SplineBlend(images, [0, 1, 3], continuity=continuity)
    assert set(blend.remedies) == {"plain"}
    curve = blend.frame_at(0.4).curve
    if continuity == "C0":
        expected = 0.6 * images[0].point(1.1) + 0.4 * images[1].point(1.1)
        assert np.abs(curve.point(1.1) - expected).max() < 1e-12
    assert np.abs(blend.frame_at(1).curve.point(1.1) - images[1].point(1.1)).max() < 1e-12
    # From one side of an inner key to the other the derivative by omega jumps for C0 alone.
    h = 1e-5
    p = [blend.frame_at(1 + k * h).curve.point(1.1) for k in (-1, 0, 1)]
    jump = np.abs((p[2] - p[1]) / h - (p[1] - p[0]) / h).max()
    assert jump > 1 if continuity == "C0" else jump < 1e-2


def test_corners_of_all_keys_are_kept_on_demand():
    corner = BezierSpline(1, [0, 1, 2], [[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    other = BezierSpline(1, [0, 1, 2], [[0, 0, 0], [2, 1, 0], [1, 3, 0]])
    with pytest.raises(ValueError, match="joint|knot"):
        SplineBlend([corner, other])
    blend = SplineBlend([corner, other], keep_lower_orders=True)
    assert blend.orders == [0] and blend.frame_at(0.5).joints[0].order == 0


# Lofts

def test_a_loft_keeps_the_corners_of_its_frames():
    keys_with_corner = [
        BezierSpline(1, [0, 1, 2], [[0, 0, z], [1 + z, 0, z], [1, 1 + 2 * z, z]]) for z in (0, 1)
    ]
    blend = SplineBlend(keys_with_corner, keep_lower_orders=True)
    loft = seamwright.frame_loft(blend)
    assert loft.reached and loft.distance_mm < 1e-9
    for omega in (0.0, 0.3, 1.0):
        middle = blend.frame_at(omega).curve.point(1.0)
        assert np.abs(loft.surface.point(1.0, omega) - middle).max() < 1e-9


def test_a_loft_has_the_frames_as_iso_curves():
    blend = SplineBlend(keys())
    loft = seamwright.frame_loft(blend, tolerance_mm=1e-4)
    assert isinstance(loft.surface, seamwright.BSplineSurface) and loft.reached
    assert loft.ratios_positive and loft.distance_mm <= 1e-4 and loft.proven_mm is None
    assert not loft.smooth_frames and loft.frames > loft.spans > 0
    for omega in (0, 0.13, 0.5, 0.77, 1):
        curve = blend.frame_at(omega).curve
        for u in np.linspace(0, 1, 9):
            segment = 1
            local = curve.segment(segment).point(u)
            knots = sorted(set(loft.surface.knots_u))
            v = knots[segment] + u * (knots[segment + 1] - knots[segment])
            assert np.abs(loft.surface.point(v, omega) - local).max() < 2e-4
    lines = seamwright.enclose_knot_lines(loft)
    inner = sorted(set(loft.surface.knots_u))[1:-1]
    assert [line.knot for line in lines] == inner
    for line in lines:
        assert line.seam.level == "G2" and line.seam.certified
        assert line.seam.angle_deg.upper < 1e-5
    # By jets on both sides of a line.
    h = 1e-9
    for omega in (0.2, 0.6):
        a, b = (loft.surface.jet(inner[0] + sign * h, omega) for sign in (-1, 1))
        assert seamwright.measure_pair(a, b).angle_rad < 1e-6


def test_a_callable_gives_frames():
    """Parallel parabolas that rise with the square of omega: the surface is known."""
    asked = []

    def parabola(omega):
        asked.append(omega)
        return BezierCurve([[0, 0, omega**2], [1, 2, omega**2], [2, 0, omega**2]])

    loft = seamwright.frame_loft(parabola, (0, 2), order=1, tolerance_mm=1e-9)
    assert len(asked) == len(set(asked)) == loft.frames
    for u in (0, 0.3, 1):
        for v in (0, 0.7, 1.9):
            assert np.abs(loft.surface.point(u, v) - [2 * u, 4 * u * (1 - u), v**2]).max() < 1e-9
    bound = seamwright.frame_loft(parabola, (0, 2), derivative_bound=(4, 0.0))
    assert bound.proven_mm is not None and bound.proven_mm < 1e-9 and bound.reached
    assert seamwright.enclose_knot_lines(loft.surface) == []


def test_what_a_callable_raises_leaves_the_call():
    def stops(omega):
        raise KeyError("no frame")

    with pytest.raises(KeyError, match="no frame"):
        seamwright.frame_loft(stops, (0, 1))
    with pytest.raises(TypeError, match="the frame at omega 0.0 is 3: a BezierCurve"):
        seamwright.frame_loft(lambda omega: 3, (0, 1))
    shares = []
    seamwright.frame_loft(SplineBlend(keys()), progress=shares.append)
    assert shares and 0 <= min(shares) <= max(shares) <= 1
    with pytest.raises(seamwright.Cancelled):
        seamwright.frame_loft(SplineBlend(keys()), progress=lambda share: False)


def test_a_closed_loft():
    def ring(omega):
        circle = np.array([[1, 0, 0], [1, 1, 0], [-1, 1, 0], [-1, 0, 0]])
        turn = [math.cos(omega), math.sin(omega), 0]
        return BezierCurve(circle + 3 * np.array(turn))

    loft = seamwright.frame_loft(ring, (0, 2 * math.pi), closed=True, tolerance_mm=1e-3)
    assert loft.reached
    lines = seamwright.enclose_knot_lines(loft, "v", closed=True, level="G1")
    assert lines and all(line.seam.level in ("G2", "G3") for line in lines)


def test_a_sheet_meets_its_neighbour():
    """The neighbour is the surface z = s^2 continued: the sheet has its derivatives there."""
    x, y = np.meshgrid([0.0, 1, 2, 3], [0.0, 1, 2, 3], indexing="ij")
    patch = seamwright.BezierPatch(np.stack([x, y, 0.1 * x**2], axis=-1))
    rising = lambda omega: BezierCurve([[3 + omega, y, 0.9 + omega] for y in (0.0, 1, 2, 3)])
    ribbon = seamwright.edge_ribbon(patch, "u1", "start")
    assert isinstance(ribbon, results.FrameRibbon)
    rate = seamwright.even_rate(rising, (0, 1), ribbon, "start")
    # The frames move by sqrt(2), the patch by its derivative along u at the edge.
    assert 0 < rate < 1
    ribbon = seamwright.edge_ribbon(patch, "u1", "start", rate)
    sheet = seamwright.frame_sheet(rising, (0, 1), start=ribbon)
    assert sheet.reached
    for order, level in ((2, "G2"), (1, "G1")):
        sheet = seamwright.frame_sheet(rising, (0, 1), start=(ribbon, order))
        seam = seamwright.enclose_seam(patch, "u1", sheet.surface, "v0", level=level)
        assert seam.level in (level, "G3") and seam.certified and seam.angle_deg.upper < 1e-5
    with pytest.raises(ValueError):
        seamwright.frame_sheet(rising, (0, 1))


def test_frames_are_curves_of_other_functions():
    blended = SplineBlend(keys()).frame_at(0.5)
    assert seamwright.arc_length(blended, 1e-6) == seamwright.arc_length(blended.curve, 1e-6)
    again = SplineBlend([blended, SplineBlend(keys()).frame_at(0.25)])
    assert set(again.orders) == {2}


def pickled(value):
    return pickle.loads(pickle.dumps(value))


@pytest.mark.parametrize("make", [copy.copy, copy.deepcopy, pickled])
def test_copies_give_the_same_frames(make):
    spline = SplineBlend(keys(True), [1, 2], order=1, continuity="C2", free_betas=True)
    assert make(spline).frame_at(1.3) == spline.frame_at(1.3)
    joint = JointBlend(FIRST, SECOND, most_departure=2)
    assert make(joint).at(0.3) == joint.at(0.3)
    assert make(joint).remedy == joint.remedy == "balanced"


def test_results_and_blends_are_read_only():
    blend = SplineBlend(keys())
    frame = blend.frame_at(0.5)
    joint_blend = JointBlend(FIRST, SECOND)
    for value, name in (
        (frame, "curve"),
        (frame.joints[0], "order"),
        (joint_blend.at(0.5), "beta"),
        (seamwright.frame_loft(blend), "surface"),
        (blend, "degree"),
        (joint_blend, "remedy"),
    ):
        with pytest.raises(AttributeError):
            setattr(value, name, 1)
    assert (joint_blend.degree_a, joint_blend.degree_b) == (5, 5)
    assert repr(blend) == f"<SplineBlend of 2 curves of degree {blend.degree}>"
    assert repr(joint_blend) == "<JointBlend of order 2, balanced>"


LINE = BezierCurve([[0, 0, 0], [1, 0, 0]])
APART = BezierCurve([[5, 0, 0], [6, 0, 0]])
NAN = float("nan")


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: JointBlend(FIRST, SECOND).at(1.5), "1.5"),
        (lambda: JointBlend(FIRST, SECOND).at(NAN), "nan"),
        (lambda: JointBlend(FIRST, SECOND).at("half"), "omega is 'half'"),
        (lambda: JointBlend(LINE, SECOND), "first is <BezierCurve of degree 1>: a pair"),
        (lambda: JointBlend((LINE, APART), (LINE, APART)), "4"),
        (lambda: JointBlend(FIRST, SECOND, order=0), "order .*0"),
        (lambda: JointBlend(FIRST, SECOND, order=7), "order .*7"),
        (lambda: JointBlend(FIRST, SECOND, order=1.5), "order is 1.5"),
        (lambda: JointBlend(FIRST, SECOND, max_degree=40), "max_degree .*40"),
        (lambda: JointBlend(FIRST, SECOND, free_betas=1), "free_betas is 1"),
        (lambda: JointBlend(FIRST, SECOND, most_departure=-1), "most_departure .*-1"),
        (lambda: JointBlend(FIRST, SECOND, frame_tolerance=NAN), "frame_tolerance .*nan"),
        (lambda: JointBlend(FIRST, (LINE, BezierCurve([[1, 0, 0], [1, 1, 0]]))), "1"),
        (lambda: seamwright.plain_blend(FIRST, SECOND, order=3), "3"),
        (lambda: seamwright.plain_blend(FIRST, SECOND, tolerance=NAN), "nan"),
        (lambda: seamwright.plain_blend(FIRST, SECOND, omegas=[0, 2]), r"omegas\[1\] is 2.0"),
        (lambda: seamwright.balance_ratios([1, NAN], 3, 3), "nan"),
        (lambda: seamwright.balance_ratios([], 3, 3), "beta"),
        (lambda: seamwright.balance_ratios([1, 0], 1, 3), "1"),
        (lambda: seamwright.balanced_poles([[1, 2, 3]], [1, 0], 3, 3), "1"),
        (lambda: seamwright.balanced_poles([[1, 2]], [1, 0], 3, 3), r"points have shape \(1, 2\)"),
        (lambda: seamwright.auxiliary_points(np.full((5, 3), NAN), [1, 0], 3, 3), "pole 0"),
        (lambda: SplineBlend([LINE]), "1"),
        (lambda: SplineBlend([]), "0"),
        (lambda: SplineBlend(LINE), "keys is <BezierCurve"),
        (lambda: SplineBlend([keys()[0], LINE]), "1"),
        (lambda: SplineBlend([keys()[0], keys(True)[1]]), "segments"),
        (lambda: SplineBlend(keys(), [0, 0]), "omega.* 1 .*0"),
        (lambda: SplineBlend(keys(), [0, NAN]), "nan"),
        (lambda: SplineBlend(keys(), [0]), "1"),
        (lambda: SplineBlend(keys(), continuity="C3"), "continuity is 'C3': known are 'C0', 'C1'"),
        (lambda: SplineBlend(keys(), keep_lower_orders="no"), "keep_lower_orders is 'no'"),
        (lambda: SplineBlend(keys()).frame_at(-0.1), "-0.1"),
        (lambda: seamwright.frame_loft(SplineBlend(keys()), (1, 0)), "1.* 0|0.* 1"),
        (lambda: seamwright.frame_loft(SplineBlend(keys()), (0, 0.5, 1)), "omegas is"),
        (lambda: seamwright.frame_loft(lambda omega: LINE), "omegas is None"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, NAN)), "nan"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), tolerance_mm=0), "toleran"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), order=5), "order.*5"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), stations=[2]), "2"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), checks=0), "checks.*0"),
        (lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), closed="no"), "closed is 'no'"),
        (
            lambda: seamwright.frame_loft(lambda omega: LINE, (0, 1), derivative_bound=4),
            "derivative_bound is 4: a pair",
        ),
        (
            lambda: seamwright.frame_loft(
                lambda omega: LINE if omega < 0.4 else keys()[0], (0, 1)
            ),
            "omega",
        ),
        (lambda: seamwright.enclose_knot_lines(keys()[0].to_bspline(0)), "a BSplineSurface"),
    ],
)
def test_bad_arguments(call, message):
    with pytest.raises((ValueError, TypeError), match=message):
        call()
