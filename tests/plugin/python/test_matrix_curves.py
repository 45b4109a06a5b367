# SPDX-License-Identifier: LGPL-2.1-or-later
"""Matrix-weighted curves through Python: the sum that a point makes least, the rational B-spline,
and circles are the oracle."""

import math

import numpy as np
import pytest
import seamwright
from seamwright import BSplineCurve, MatrixCurve
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_matrix_curves.py"))
KNOTS = [0, 0, 0, 0, 0.4, 1, 1, 1, 1]
T = np.linspace(0, 1, 21)


def random_curve(flat=False):
    points, tangents = RANDOM.normal(size=(2, 5, 3)) * [1, 1, not flat]
    return MatrixCurve(
        3, KNOTS, points, tangents, RANDOM.uniform(0.5, 2, 5), RANDOM.uniform(0, 5, 5)
    )


def expected(curve, t):
    """The point with the least weighted sum, by numpy."""
    matrix, vector = np.zeros((3, 3)), np.zeros(3)
    for i in range(5):
        poles = np.zeros((5, 3))
        poles[i, 0] = 1
        basis = BSplineCurve(3, KNOTS, poles).point(t)[0]
        tangent = curve.tangents[i] / np.linalg.norm(curve.tangents[i])
        across = np.eye(3) - np.outer(tangent, tangent)
        m = basis * curve.weights[i] * (np.eye(3) + curve.stiffness[i] * across)
        matrix += m
        vector += m @ curve.points[i]
    return np.linalg.solve(matrix, vector)


def test_points_make_the_sum_least():
    for flat in (False, True):
        curve = random_curve(flat)
        for t in T[::5]:
            assert np.abs(curve.point(t) - expected(curve, t)).max() < 1e-12
        step = 1e-6
        difference = (curve.point(T[1:-1] + step) - curve.point(T[1:-1] - step)) / (2 * step)
        assert np.abs(curve.derivative(T[1:-1]) - difference).max() < 1e-6
        assert curve.point(T.reshape(3, 7)).shape == (3, 7, 3)


def test_without_stiffness_it_is_a_rational_spline():
    points, weights = RANDOM.normal(size=(5, 3)), RANDOM.uniform(0.5, 2, 5)
    curve = MatrixCurve(3, KNOTS, points, weights=weights)
    same = BSplineCurve(3, KNOTS, points, weights)
    assert np.abs(curve.point(T) - same.point(T)).max() < 1e-13
    assert np.array_equal(curve.tangents, np.zeros((5, 3))) and curve.knots == same.knots


@pytest.mark.parametrize("flat, factor", [(False, 3), (True, 2)])
def test_the_conversion_is_exact_and_has_positive_weights(flat, factor):
    curve = random_curve(flat)
    for spline in (curve.bezier_spline(), curve.to_bspline()):
        assert spline.degree == factor * 3 and np.all(spline.weights > 0)
        assert np.abs(spline.point(T) - curve.point(T)).max() < 1e-10


def test_it_is_accepted_as_a_curve():
    curve = random_curve()
    assert seamwright.arc_length(curve, 1e-6) == seamwright.arc_length(curve.to_bspline(), 1e-6)


def helix(count, noise=0.0):
    t = np.linspace(0, 4, count)
    points = np.stack([2 * np.cos(t), 2 * np.sin(t), t / 2], axis=1)
    points[1:-1] += RANDOM.normal(0, noise, (count - 2, 3)) if noise else 0
    return points, np.stack([-2 * np.sin(t), 2 * np.cos(t), np.full(count, 0.5)], axis=1)


def test_a_curve_through_points_with_tangents():
    points, tangents = helix(25)
    fit = seamwright.fit_hermite(points, tangents)
    found = fit.curve.point(fit.parameters)
    assert np.linalg.norm(found - points, axis=1).max() < 1e-10 and fit.missed_mm < 1e-10
    along = fit.curve.derivative(fit.parameters)
    cosine = (along * tangents).sum(axis=1) / np.linalg.norm(along, axis=1)
    cosine /= np.linalg.norm(tangents, axis=1)
    assert np.arccos(np.clip(cosine, -1, 1)).max() == pytest.approx(
        fit.missed_tangent_rad, abs=1e-6
    )
    assert np.array_equal(fit.curve.stiffness, np.ones(25)) and fit.curve.degree == 3


def test_points_with_tangents_are_faired_within_a_tolerance():
    points, tangents = helix(30, 0.01)
    fair = seamwright.fair_hermite(points, tangents, 0.05)
    moves = np.linalg.norm(fair.points_mm - points, axis=1)
    assert 0 < moves.max() <= 0.05 and fair.moved_mm == pytest.approx(moves.max())
    assert moves[0] == 0 == moves[-1] and fair.passes > 0
    assert fair.after.energy_per_mm3 < fair.before.energy_per_mm3
    again = seamwright.curvature_variation(fair)  # a result is a curve
    assert fair.after.energy_per_mm3 == pytest.approx(again.energy_per_mm3, rel=1e-10)
    assert fair.curve == fair.fit.curve
    same = seamwright.fair_hermite(points, tangents, 0)
    assert np.array_equal(same.points_mm, points) and np.array_equal(same.tangents, tangents)


def test_one_pass_without_a_tolerance():
    points, tangents = helix(30, 0.01)
    means = seamwright.matrix_pass(points, tangents, stiffness=0, fair_tangents=False)
    expected = points.copy()
    expected[1:-1] = (points[:-2] + 4 * points[1:-1] + points[2:]) / 6
    assert np.abs(means.points_mm - expected).max() < 1e-14
    assert np.array_equal(means.tangents, tangents)
    found = seamwright.matrix_pass(points, tangents)
    fair = seamwright.fair_hermite(points, tangents, 1, most_passes=1)
    assert np.array_equal(found.points_mm, fair.points_mm) and fair.passes == 1
    assert np.array_equal(found.tangents, fair.tangents)
    assert np.abs(np.linalg.norm(found.tangents[1:-1], axis=1) - 1).max() < 1e-15


def test_the_variation_of_known_curves():
    line = seamwright.BezierCurve([[0, 0, 0], [1, 1, 1], [3, 3, 3]])
    assert seamwright.curvature_variation(line).energy_per_mm3 < 1e-25
    clothoid = seamwright.Clothoid([0, 0], 0, 0.1, 0.05, 6)
    spline = clothoid.bezier_spline(1e-9)
    assert seamwright.curvature_variation(spline).energy_per_mm3 == pytest.approx(
        0.05**2 * 6, rel=1e-3
    )


POINTS, TANGENTS = helix(6)


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: MatrixCurve(3, KNOTS, POINTS), "pole|knot"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5], TANGENTS), "tangents are 6 for 5 points"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5], weights=[1, 2]), "weights has 2 numbers for 5"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5], weights=-1), "-1"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5], stiffness=1), "tangent"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5], TANGENTS[:5], stiffness=1e9), "is 1000000000"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5, :2]), r"points have shape \(5, 2\)"),
        (lambda: MatrixCurve(3, KNOTS, POINTS[:5]).point(math.nan), "t is nan"),
        (lambda: seamwright.fit_hermite(POINTS[:3], TANGENTS[:3]), "3"),
        (lambda: seamwright.fit_hermite(POINTS, TANGENTS[:5]), "5"),
        (lambda: seamwright.fit_hermite(POINTS, 0 * TANGENTS), "tangent"),
        (lambda: seamwright.fit_hermite(POINTS, TANGENTS, stiffness=-1), "-1"),
        (lambda: seamwright.fair_hermite(POINTS, TANGENTS, -1), "-1"),
        (lambda: seamwright.fair_hermite(POINTS, TANGENTS, 1, most_passes=-1), "-1"),
        (lambda: seamwright.fair_hermite(POINTS, TANGENTS, 1, fair_tangents=1), "fair_tangents"),
        (lambda: seamwright.matrix_pass(POINTS, TANGENTS[:5]), "5 tangents for 6 points"),
        (lambda: seamwright.matrix_pass(POINTS, 0 * TANGENTS), "point 0 is"),
        (lambda: seamwright.matrix_pass(POINTS, TANGENTS, stiffness=-1), "stiffness is -1"),
    ],
)
def test_bad_matrix_curves(call, text):
    with pytest.raises(ValueError, match=text):
        call()
