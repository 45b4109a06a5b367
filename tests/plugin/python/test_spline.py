# SPDX-License-Identifier: LGPL-2.1-or-later
"""BSplineCurve, BezierSpline, direct_g2_spline, gamma_spline: shapes, keywords and errors; what
they are by closed forms."""

import math
import sys

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierSpline, BSplineCurve

POLYGON = np.array(
    [(0, 0, 0), (4, 0, 0), (5, 3, 1), (2, 5, 0), (-1, 3, 2), (-2, 1, 0)], dtype=float
)


def quarter(k):
    a, b = ((math.cos(x), math.sin(x), 0) for x in (k * math.pi / 2, (k + 1) * math.pi / 2))
    return BezierCurve([np.round(a), np.round(np.add(a, b)), np.round(b)], [1, math.sqrt(0.5), 1])


def test_a_bspline_curve_has_its_numbers():
    curve = BSplineCurve(2, [0, 0, 0, 1, 3, 3, 3], [(0, 0, 0), (1, 0, 0), (2, 1, 0), (6, 6, 0)])
    assert curve.degree == 2 and curve.knots == [0, 0, 0, 1, 3, 3, 3] and not curve.is_rational
    assert curve.poles.shape == (4, 3) and np.array_equal(curve.weights, np.ones(4))
    assert np.allclose(curve.derivatives(0, 2), [(0, 0, 0), (2, 0, 0), (2 * (1 / 3 - 1), 2 / 3, 0)])
    assert np.array_equal(curve.point(3), (6, 6, 0))
    assert curve == BSplineCurve(2, curve.knots, curve.poles, np.ones(4))
    assert curve != BSplineCurve(2, curve.knots, curve.poles, [1, 1, 2, 1])
    with pytest.raises(TypeError, match="unhashable"):
        hash(curve)


def test_bezier_curves_and_their_splines():
    curve = quarter(0)
    spline = BSplineCurve.from_bezier(curve)
    assert spline.is_rational and spline.knots == [0, 0, 0, 1, 1, 1]
    assert np.allclose(spline.derivatives(0.3, 4), curve.derivatives(0.3, 4), rtol=1e-12)
    assert spline.bezier_spline().segment(0) == curve


def test_segments_come_apart_and_together():
    circle = BezierSpline.from_segments(
        [quarter(k) for k in range(4)], [0, 1, 2, 3, 4], closed=True
    )
    assert circle.closed and circle.segments == 4 and circle.degree == 2
    assert [circle.segment(k) for k in range(4)] == [quarter(k) for k in range(4)]
    for t in np.linspace(0, 4, 41):
        assert np.linalg.norm(circle.point(t)) == pytest.approx(1, abs=1e-15)
    joints = circle.measure_joints(4)
    assert len(joints) == 4 and all(joint["order_reached"] == 4 for joint in joints)
    assert joints[0]["sizes"][2] == pytest.approx(1, abs=1e-14)
    assert circle == BezierSpline(2, circle.knots, circle.poles, circle.weights, True)
    curve = circle.to_bspline(0)
    assert curve.knots == [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    assert curve.bezier_spline(closed=True) == circle
    assert circle.continuity() == 0


def test_degrees_and_gaps():
    line = BezierCurve([(0, 0, 0), (1, 0, 0)])
    cubic = BezierCurve([(1, 0, 0.5**16), (2, 0, 0), (3, 1, 0), (4, 1, 0)])
    with pytest.raises(
        ValueError, match=r"joint 1: the ends are 1.52587890625e-05 mm apart, allowed 0"
    ):
        BezierSpline.from_segments([line, cubic], [0, 1, 2])
    spline = BezierSpline.from_segments([line, cubic], [0, 1, 2], gap_mm=1e-4)
    assert spline.degree == 3 and np.allclose(
        spline.poles[:3], [(0, 0, 0), (1 / 3, 0, 0), (2 / 3, 0, 0)]
    )
    assert np.array_equal(spline.poles[3], cubic.poles[0])


@pytest.mark.parametrize("closed", [False, True])
def test_direct_splines_are_g2(closed):
    edges = len(POLYGON) - (not closed)
    spline = seamwright.direct_g2_spline(
        POLYGON, np.linspace(0.1, 0.4, edges), np.linspace(0.6, 0.9, edges), closed
    )
    joints = spline.measure_joints(2)
    assert len(joints) == (6 if closed else 2)
    assert max(joint["differences"][2] for joint in joints) < 1e-13
    assert spline.continuity() == 1
    poles = np.array(spline.poles)
    poles[5] += (0, 0, 1e-5)
    moved = BezierSpline(3, spline.knots, poles, closed=closed)
    assert moved.measure_joints(2)[0]["differences"][2] > 1e-6
    if not closed:
        assert np.array_equal(spline.poles[[0, 1, -2, -1]], POLYGON[[0, 1, -2, -1]])
        assert seamwright.direct_g2_spline(POLYGON, 0.25, 0.75).segments == 3


def test_gamma_splines():
    spline = seamwright.gamma_spline(POLYGON)
    assert spline.knots == [0, 1, 2, 3]
    curve = spline.to_bspline(2)
    assert np.allclose(curve.poles, POLYGON, rtol=0, atol=1e-14)
    spline = seamwright.gamma_spline(POLYGON, [1, 2, 1.5], [1, 0.5, 3])
    for knot, (h, k), gamma in ((1, (1, 2), 0.5), (3, (2, 1.5), 3)):
        after, before = spline.derivatives(knot, 2), spline.derivatives(np.nextafter(knot, 0), 2)
        nu = 2 * (1 / h + 1 / k) * (1 / gamma - 1)
        assert np.allclose(after[1], before[1], atol=1e-12)
        assert np.allclose(after[2] - before[2], nu * after[1], atol=1e-11)
    closed = seamwright.gamma_spline(POLYGON, closed=True)
    assert np.allclose(closed.point(0), (POLYGON[-1] + 4 * POLYGON[0] + POLYGON[1]) / 6)
    assert closed.continuity(around=True) == 2 and spline.continuity(around=True) == -1


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: BSplineCurve(2, [0, 0, 0, 1, 1], np.zeros((3, 3))), "knots are 5"),
        (lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((4, 3))), "poles 4, knots for 3"),
        (
            lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 2))),
            r"poles have shape \(3, 2\)",
        ),
        (
            lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 3)), [1, 1]),
            r"weights have shape \(2\)",
        ),
        (
            lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 3)), [1, -1, 1]),
            "weight 1 is -1",
        ),
        (lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 3))).point(math.nan), "t is nan"),
        (
            lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 3))).derivatives(0, -1),
            "order -1",
        ),
        (
            lambda: BSplineCurve(2, [0, 0, 0, 1, 1, 1], np.zeros((3, 3))).derivatives(0, 1001),
            "order 1001",
        ),
        (lambda: BezierSpline(2, [0, 1, 1], np.zeros((5, 3))), "knot 2 is 1"),
        (
            lambda: BezierSpline(2, [0, 1], np.zeros((5, 3))),
            "poles 5: 1 segments of degree 2 have 3",
        ),
        (
            lambda: BezierSpline(1, [0, 1], [(0, 0, 0), (3, 4, 0)], closed=True),
            "the last pole, 1, is 5 mm from the first",
        ),
        (lambda: BezierSpline(1, [0, 1], np.zeros((2, 3))).segment(1), "segment 1: there are 1"),
        (lambda: BezierSpline(1, [0, 1], np.zeros((2, 3))).to_bspline(1), "order is 1"),
        (
            lambda: BezierSpline(2, [0, 1, 2], np.diag([0, 0, 0, 1, 2])[:, 2:]).to_bspline(1),
            "knot 1: the derivative of order 1 jumps",
        ),
        (lambda: BezierSpline(1, [0, 1], np.zeros((2, 3))).measure_joints("x"), "order is 'x'"),
        (
            lambda: BezierSpline(1, [0, 1], np.zeros((2, 3))).measure_joints(10**6),
            "order 1000000: it must be within 100",
        ),
        (lambda: BezierSpline(1, [0, 1], np.zeros((2, 3))).to_bspline(True), "continuity is True"),
        (lambda: BezierSpline(True, [0, 1], np.zeros((2, 3))), "degree is True"),
        (lambda: BSplineCurve(True, [0, 0, 1, 1], np.zeros((2, 3))), "degree is True"),
        (lambda: BezierSpline(1, [0, 1], np.zeros((2, 3)), [0, 1]), "weight 0 is 0: "),
        (lambda: BezierSpline.from_segments([], [0]), "no segments"),
        (lambda: seamwright.direct_g2_spline(POLYGON[:3], 0.3, 0.6), "vertices are 3"),
        (
            lambda: seamwright.direct_g2_spline(POLYGON, [0.3] * 6, 0.6),
            "alpha are 6: one for each of 5 edges",
        ),
        (lambda: seamwright.direct_g2_spline(POLYGON, "x", 0.6), "alpha is 'x'"),
        (lambda: seamwright.direct_g2_spline(POLYGON, 0.6, 0.3), "alpha must be the smaller one"),
        (lambda: seamwright.direct_g2_spline(POLYGON, 0.3, 1.0, True), "omega of edge 0 is 1"),
        (lambda: seamwright.gamma_spline(POLYGON, 1, -1), "gamma 1 is -1"),
        (lambda: seamwright.gamma_spline(POLYGON, [1, 0, 1]), "length 1 is 0"),
        (lambda: seamwright.gamma_spline(POLYGON * math.nan), "vertex 0 is not finite"),
    ],
)
def test_errors_name_index_and_value(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_the_bridge_needs_freecad(monkeypatch):
    monkeypatch.setitem(sys.modules, "Part", None)
    with pytest.raises(RuntimeError, match="run inside FreeCAD"):
        seamwright.curve_to_freecad(quarter(0))
    with pytest.raises(RuntimeError, match="run inside FreeCAD"):
        seamwright.curve_from_freecad(None)
