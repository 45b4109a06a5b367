# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines where Bézier curves are accepted. The oracles are closed forms, and one curve written
both as a BezierCurve and as a spline with other knots: its figures are the same, and derivatives by
the parameter follow from the chain rule."""

import math

import numpy as np
import pytest
import seamwright
from seamwright import BezierCurve, BezierSpline, BSplineCurve
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_any_curve.py"))
CURVE = BezierCurve(RANDOM.normal(size=(6, 3)), RANDOM.uniform(0.5, 2, 6))
KNOTS = [2.0, 3.0, 4.0]  # the parameter of the spline is 2 + 2 t


def divided(curve):
    """The curve in two halves, over KNOTS."""
    return BezierSpline.from_segments(curve.split(0.5), KNOTS, gap_mm=1e-12)


SPLINE = divided(CURVE)


def test_frames_of_a_spline_are_those_of_its_curve():
    t = np.linspace(0, 1, 9)
    one, two = seamwright.frenet_frame(CURVE, t), seamwright.frenet_frame(SPLINE, 2 + 2 * t)
    assert two.speed_mm == pytest.approx(one.speed_mm / 2)
    for key in one:
        if key not in ("kind", "speed", "speed_error") and "error" not in key:
            assert two[key] == pytest.approx(one[key], rel=1e-8, abs=1e-10), key
    off = np.abs(two.speed_mm - one.speed_mm / 2)
    assert np.all(off <= two.speed_error_mm + one.speed_error_mm)


def test_the_speed_of_a_spline_is_that_of_its_derivative():
    for curve in (SPLINE, SPLINE.to_bspline(1)):
        for t in (2.0, 2.3, 3.0, 3.9, 4.0):
            frame = seamwright.frenet_frame(curve, t)
            assert frame.speed_mm == pytest.approx(np.linalg.norm(curve.derivatives(t, 1)[1]))


def test_at_a_knot_the_frame_is_that_of_what_follows():
    corner = BezierSpline(1, [0, 1, 2], [[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    assert seamwright.frenet_frame(corner, 1).tangent == pytest.approx([0, 1, 0])
    assert seamwright.frenet_frame(corner, 2).tangent == pytest.approx([0, 1, 0])
    assert seamwright.frenet_frame(corner, np.nextafter(1, 0)).tangent == pytest.approx([1, 0, 0])


def half_circle(radius):
    w = math.sqrt(0.5)
    poles = np.array([[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0]]) * radius
    return BezierSpline(2, [0, 1, 5], poles, [1, w, 1, w, 1])


def test_the_length_of_a_half_circle_in_two_segments():
    circle = half_circle(3)
    length = seamwright.arc_length(circle, 1e-9)
    assert length.lower_mm <= 3 * math.pi <= length.upper_mm and length.reached
    assert length.upper_mm - length.lower_mm <= 1e-9
    assert seamwright.arc_length(circle, 1e-9, 0, 1).value_mm == pytest.approx(1.5 * math.pi)
    assert seamwright.arc_length(circle, 1e-9, 1).value_mm == pytest.approx(1.5 * math.pi)
    halves = seamwright.arc_length(circle, 1e-9, 0.5, 3)
    assert halves.value_mm == pytest.approx(1.5 * math.pi)  # each segment is symmetric
    assert seamwright.arc_length(circle, 1e-9, 2, 2).value_mm == 0


def test_the_parameter_at_a_length_of_a_spline():
    circle = half_circle(3)
    t = seamwright.parameter_at_length(circle, np.pi * np.array([0, 0.75, 1.5, 2.25, 3]), 1e-8)
    assert t == pytest.approx([0, 0.5, 1, 3, 5], abs=1e-7)
    for length in np.linspace(0, 3 * math.pi, 23)[:-1]:
        at = seamwright.parameter_at_length(circle, length, 1e-8)
        assert seamwright.arc_length(circle, 1e-9, 0, at).value_mm == pytest.approx(
            length, abs=1e-8
        )


def test_degeneracies_of_a_spline_are_those_of_its_curve():
    bend = BezierCurve([[0, 0, 0], [1, 1, 0], [2, -2, 0], [3, 0, 0]])
    one, two = seamwright.find_degeneracies(bend), seamwright.find_degeneracies(divided(bend))
    assert len(one.intervals) == len(two.intervals) == 1 and not two.straight
    assert two.intervals[0].kind == "inflection"
    assert two.intervals[0].first == pytest.approx(2 + 2 * one.intervals[0].first, abs=1e-6)
    assert 0 < two.speed_lower_mm <= seamwright.frenet_frame(
        divided(bend), np.linspace(2, 4, 99)
    ).speed_mm.min()


def test_a_spline_is_straight_if_all_of_it_is():
    straight = BezierSpline(1, [0, 1, 3], [[0, 0, 0], [1, 2, 3], [3, 6, 9]])
    found = seamwright.find_degeneracies(straight)
    assert found.straight and len(found.intervals) == 1
    assert (found.intervals[0].first, found.intervals[0].last) == (0, 3)
    corner = BezierSpline(1, [0, 1, 2], [[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    assert not seamwright.find_degeneracies(corner).straight


def test_frames_that_do_not_turn_go_on_through_joints():
    t = np.linspace(0, 1, 401)
    one = seamwright.rotation_minimizing_frames(CURVE, t, [0, 0, 1])
    two = seamwright.rotation_minimizing_frames(SPLINE, 2 + 2 * t, [0, 0, 1])
    for key in ("points", "tangents", "normals", "binormals"):
        assert two[key] == pytest.approx(one[key], abs=1e-6), key
    assert np.array_equal(two.parameters, 2 + 2 * t)


@pytest.mark.parametrize("t", [[2.1], [2.1, 2.9], [2.5, 3.0], [3.0, 3.5], [2.0, 4.0], [3.9, 4.0]])
def test_frames_at_any_parameters_of_a_planar_spline(t):
    flat = divided(BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [3, 0, 0]]))
    frames = seamwright.rotation_minimizing_frames(flat, t, [0, 0, 1])
    assert frames.normals == pytest.approx(np.tile([0, 0, 1], (len(t), 1)))
    assert frames.points_mm == pytest.approx(flat.point(t))


def test_joints_of_splines_are_those_of_their_ends():
    after = BezierCurve(RANDOM.normal(size=(4, 3)))
    for curve in (SPLINE, SPLINE.to_bspline(1)):
        for a, b in ((curve, after), (after, curve), (curve, curve)):
            plain = [CURVE if c is curve else c for c in (a, b)]
            one, two = seamwright.measure_joint(*plain), seamwright.measure_joint(a, b)
            assert two.gap_mm == pytest.approx(one.gap_mm)
            assert two.differences == pytest.approx(one.differences, rel=1e-6)
            one, two = seamwright.fit_beta(*plain, 3), seamwright.fit_beta(a, b, 3)
            assert two.length_mm == pytest.approx(one.length_mm)
            assert two.defects == pytest.approx(one.defects, rel=1e-6)


def joint_errors(a, b, beta, at_a, at_b):
    """b_k - sum_j B_kj a_j for the derivatives by the parameters of both curves."""
    n = len(beta)
    matrix = seamwright.beta_matrix(beta)
    return np.abs(b.derivatives(at_b, n) - matrix @ a.derivatives(at_a, n)).max()


def test_curves_that_go_on_after_a_spline_have_the_given_betas():
    free = BezierCurve(RANDOM.normal(size=(6, 3)))
    beta = [1.3, -0.4]
    for a in (SPLINE, SPLINE.to_bspline(1)):
        b = seamwright.curve_joined(a, free, beta)
        assert joint_errors(a, b, beta, 4.0, 0.0) < 1e-10
        assert seamwright.fit_beta(a, b).beta == pytest.approx(beta)
        poles, weights = seamwright.curve_join_poles(a, 5, beta)
        assert poles == pytest.approx(
            seamwright.curve_join_poles(CURVE, 5, beta, length=2.0)[0]
        )
        smooth = seamwright.curve_joined(a, free, [1, 0])
        assert smooth.derivatives(0, 2) == pytest.approx(a.derivatives(4.0, 2))


def test_a_bridge_between_splines_has_the_given_betas():
    a = divided(BezierCurve(RANDOM.normal(size=(4, 3))))
    b = BSplineCurve(3, [0, 0, 0, 0, 5, 7, 7, 7, 7], RANDOM.normal(size=(5, 3)))
    start, end = [1.2, 0.3], [0.8, -0.1]
    bridge = seamwright.curve_blend(a, b, start, end)
    assert joint_errors(a, bridge, start, 4.0, 0.0) < 1e-9
    assert joint_errors(bridge, b, end, 1.0, 0.0) < 1e-9


def test_betas_of_splines_obey_the_chain_rule():
    one = seamwright.fit_beta(CURVE, CURVE.reversed(), 3).beta
    assert one.size == 0  # it turns back: no beta
    a = BezierCurve(RANDOM.normal(size=(6, 3)))
    b = seamwright.curve_joined(a, BezierCurve(RANDOM.normal(size=(6, 3))), [1.5, 0.2])
    # t_a = 2 + 2 s_a and t_b = 2 + 2 s_b
    fit = seamwright.fit_beta(divided(a), divided(b))
    assert fit.beta == pytest.approx([1.5, 0.1])


def test_the_nearest_join_takes_splines():
    flat = BezierSpline(2, [0, 1, 2], [[0, 0, 0], [1, 1, 0], [2, 1, 0], [3, 1, 0], [4, 0, 0]])
    other = BezierCurve([[4, 0.1, 0], [5, -1, 0], [6, 0, 1], [7, 0, 0]])
    join = seamwright.curve_nearest_join(flat, other)
    assert join.status == "solved" and isinstance(join.a, BSplineCurve)
    assert seamwright.fit_beta(join.a, join.b, 1).defects == pytest.approx([0, 0], abs=1e-9)
    same = seamwright.curve_nearest_join(flat.to_bspline(flat.continuity()), other)
    assert join == same


def test_a_spline_of_one_segment_is_a_bezier_curve():
    b = BezierCurve(RANDOM.normal(size=(6, 3)))
    single = BSplineCurve.from_bezier(b)
    assert seamwright.curve_joined(CURVE, single, [1.0]) == seamwright.curve_joined(CURVE, b, [1.0])
    with pytest.raises(ValueError, match="b is a spline of 2 segments: a curve of one segment"):
        seamwright.curve_joined(CURVE, SPLINE, [1.0])


CALLS = {
    "curve": [
        lambda c: seamwright.frenet_frame(c, 0),
        lambda c: seamwright.find_degeneracies(c),
        lambda c: seamwright.arc_length(c, 1e-3),
        lambda c: seamwright.parameter_at_length(c, 0, 1e-3),
        lambda c: seamwright.rotation_minimizing_frames(c, [0, 1]),
    ],
    "a": [
        lambda c: seamwright.measure_joint(c, CURVE),
        lambda c: seamwright.fit_beta(c, CURVE),
        lambda c: seamwright.curve_join_poles(c, 3, [1]),
        lambda c: seamwright.curve_joined(c, CURVE, [1]),
        lambda c: seamwright.curve_blend(c, CURVE, [1], [1]),
        lambda c: seamwright.curve_nearest_join(c, CURVE),
    ],
    "b": [
        lambda c: seamwright.measure_joint(CURVE, c),
        lambda c: seamwright.fit_beta(CURVE, c),
        lambda c: seamwright.curve_joined(CURVE, c, [1]),
        lambda c: seamwright.curve_blend(CURVE, c, [1], [1]),
        lambda c: seamwright.curve_nearest_join(CURVE, c),
    ],
}


@pytest.mark.parametrize("bad", [3, None, "curve", [[0, 0, 0], [1, 0, 0]]])
@pytest.mark.parametrize("name", CALLS)
def test_other_arguments_are_named(name, bad):
    for call in CALLS[name]:
        kinds = "a BezierCurve, a BSplineCurve, a BezierSpline or a MatrixCurve"
        with pytest.raises(TypeError, match=f"^{name} is .*: {kinds}"):
            call(bad)


def test_ranges_outside_a_spline_are_refused():
    with pytest.raises(ValueError, match="range is 1.0 .. 4.0: 2.0 <= first <= last <= 4.0"):
        seamwright.arc_length(SPLINE, 1e-3, 1)
    with pytest.raises(ValueError, match="length_mm is 1000.0: the curve has 0 .. "):
        seamwright.parameter_at_length(SPLINE, 1000, 1e-3)
    with pytest.raises(ValueError, match="parameters 0 and 1 are 3.0 and 2.5: they must increase"):
        seamwright.rotation_minimizing_frames(SPLINE, [3, 2.5])
