# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines y(x) and their fairing, through Python: solutions of numpy and dense samples."""

import math

import numpy as np
import pytest
import seamwright
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_functions.py"))
X = np.linspace(0, 10, 21)
EXACT = np.stack([X, np.sin(X / 2)], axis=1)
ROUGH = EXACT + np.stack([0 * X, RANDOM.uniform(-0.02, 0.02, 21)], axis=1)


def seconds(points):
    """y'' at the points of the natural spline, by a dense system."""
    h, n = np.diff(points[:, 0]), len(points)
    matrix, right = np.eye(n), np.zeros(n)
    for i in range(1, n - 1):
        matrix[i, i - 1 : i + 2] = h[i - 1] / 6, (h[i - 1] + h[i]) / 3, h[i] / 6
        slope = np.diff(points[i - 1 : i + 2, 1]) / h[i - 1 : i + 1]
        right[i] = slope[1] - slope[0]
    return np.linalg.solve(matrix, right)


def bending(curve):
    x = np.linspace(X[0], X[-1], 20001)
    second = curve.derivatives((x[1:] + x[:-1]) / 2, 2)[:, 2, 1]
    return (second**2).sum() * (x[1] - x[0])


def test_the_natural_spline():
    points = ROUGH[[0, 1, 3, 4, 8, 9, 15, 20]]
    spline = seamwright.function_spline(points)
    assert np.abs(spline.second_per_mm - seconds(points)).max() < 1e-12
    assert spline.slopes is None and np.array_equal(spline.points_mm, points)
    at = spline.curve.derivatives(points[:, 0], 2)
    assert np.abs(at[:, 0, :2] - points).max() < 1e-13 and np.abs(at[:, 1, 0] - 1).max() < 1e-12
    assert np.abs(at[:, 2, 1] - spline.second_per_mm).max() < 1e-10
    third = np.diff(spline.second_per_mm) / np.diff(points[:, 0])
    assert np.abs(spline.third_jumps_per_mm2 - np.diff(third)).max() < 1e-11


def test_slopes_at_the_ends():
    spline = seamwright.function_spline(ROUGH, slopes=[0.5, np.float32(-1)])
    assert spline.slopes == (0.5, -1)
    ends = spline.curve.derivatives([0, 10], 1)[:, 1, 1]
    assert np.abs(ends - [0.5, -1]).max() < 1e-12
    again = seamwright.function_spline(spline)
    assert again == spline
    with pytest.raises(ValueError, match="slopes are .*has its own"):
        seamwright.function_spline(spline, slopes=(0, 0))


def test_how_fair_a_spline_is():
    spline = seamwright.function_spline(ROUGH)
    fairness = seamwright.function_fairness(spline)
    assert fairness == seamwright.function_fairness(ROUGH)
    assert fairness.bending_per_mm == pytest.approx(bending(spline.curve), rel=1e-5)
    assert fairness.jumps_per_mm2 == pytest.approx(np.abs(spline.third_jumps_per_mm2).sum())
    assert fairness.curvature == seamwright.curve_fairness(spline)


def test_a_correction_omits_a_point():
    corrected = seamwright.correct_function_at(ROUGH, 7)
    without = seamwright.function_spline(np.delete(ROUGH, 7, axis=0))
    assert corrected.points_mm[7, 1] == pytest.approx(without.curve.point(X[7])[1], abs=1e-12)
    assert abs(corrected.third_jumps_per_mm2[6]) < 1e-10
    limited = seamwright.correct_function_at(ROUGH, 7, 1e-4)
    assert abs(limited.points_mm[7, 1] - ROUGH[7, 1]) == pytest.approx(1e-4)


@pytest.mark.parametrize(
    "fair", [seamwright.correct_function, seamwright.rebound_function, seamwright.polish_function]
)
def test_functions_are_faired_within_a_tolerance(fair):
    x = np.linspace(0, 10, 4001)
    found = fair(ROUGH, 0.02)
    given = seamwright.function_spline(ROUGH).curve.point(x)
    moves = np.abs(found.curve.point(x) - given)[:, 1]
    assert 0 < moves.max() <= found.moved_mm <= 0.02 and found.steps >= 0
    assert found.after.bending_per_mm < found.before.bending_per_mm
    assert found.before == seamwright.function_fairness(ROUGH)
    assert found.after == seamwright.function_fairness(found)  # a result is a spline
    assert found.curve == found.spline.curve
    counts = [f.curvature.inflections for f in (found.before, found.after)]
    assert found.added_inflections == max(0, counts[1] - counts[0])
    same = fair(ROUGH, 0)
    assert np.array_equal(same.spline.points_mm, ROUGH) and same.moved_mm == 0


def test_polishing_is_the_power_of_the_operator():
    y, n = ROUGH[:, 1], 21
    means = np.eye(n)
    for i in range(1, n - 1):
        means[i, i - 1 : i + 2] = 1 / 6, 4 / 6, 1 / 6
    for steps in (0, 1, 5):
        poles = seamwright.polished_poles(y, steps)
        values = y - np.linalg.matrix_power(np.eye(n) - means, steps + 1) @ y
        assert np.abs(means @ poles - values).max() < 1e-13
    assert np.array_equal(seamwright.polished_poles(list(y), 0), y)


@pytest.mark.parametrize("slopes", [None, (0.5, 0.1)])
def test_a_rebound_takes_values_between_points(slopes):
    given = seamwright.function_spline(ROUGH, slopes=slopes)
    found = seamwright.rebounded(ROUGH, slopes=slopes)
    assert found == seamwright.rebounded(given)
    x = np.r_[X[0], (X[1:] + X[:-1]) / 2, X[-1]]
    half = seamwright.function_spline(given.curve.point(x)[:, :2], slopes=slopes)
    assert np.abs(found.points_mm[:, 1] - half.curve.point(X)[:, 1]).max() < 1e-12
    assert np.array_equal(found.points_mm[[0, -1]], ROUGH[[0, -1]]) and found.slopes == slopes


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: seamwright.function_spline(ROUGH[:1]), "1 point|point"),
        (lambda: seamwright.function_spline(ROUGH[::-1]), "1"),
        (lambda: seamwright.function_spline(np.zeros((3, 3))), r"points have shape \(3, 3\)"),
        (lambda: seamwright.function_spline(ROUGH, slopes=1), "slopes is 1"),
        (lambda: seamwright.correct_function_at(ROUGH, 0), "point 0 of 21"),
        (lambda: seamwright.correct_function_at(ROUGH, 1.5), "index is 1.5"),
        (lambda: seamwright.correct_function_at(ROUGH, 5, -1), "limit is -1"),
        (lambda: seamwright.correct_function(ROUGH, -1), "-1"),
        (lambda: seamwright.rebound_function(ROUGH, math.nan), "nan"),
        (lambda: seamwright.rebound_function(ROUGH, 1, most_rebounds=-1), "-1"),
        (lambda: seamwright.polish_function(ROUGH[[0, 1, 3, 4]], 1), "distance|equal"),
        (
            lambda: seamwright.polish_function(
                seamwright.function_spline(ROUGH, slopes=(0, 0)), 1
            ),
            "slope|natural",
        ),
        (lambda: seamwright.polished_poles(ROUGH[:, 1], -1), "-1 steps"),
        (lambda: seamwright.rebounded(ROUGH[:1]), "1 point"),
        (lambda: seamwright.rebounded(ROUGH, slopes=(0, math.inf)), "inf"),
        (lambda: seamwright.polished_poles(ROUGH, 1), "ordinates_mm is"),
    ],
)
def test_bad_functions(call, text):
    with pytest.raises(ValueError, match=text):
        call()
