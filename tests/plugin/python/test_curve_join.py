# SPDX-License-Identifier: LGPL-2.1-or-later
"""Betas, fit_beta and joins of curves: shapes, keywords and errors; the figures by closed forms and
numpy."""

import math

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve

A = BezierCurve([[0, 0, 0], [1, 1, 0], [2, 1, 1], [3, 0, 0]])
B = BezierCurve([[3, 0, 0], [5, 1, 0], [6, 3, 1], [7, 3, 2], [9, 3, 0]])


def falling(n, k):
    return math.factorial(n) / math.factorial(n - k) if k <= n else 0


def test_betas():
    assert seamwright.beta_matrix([2, 3, 5]).tolist() == [
        [1, 0, 0, 0],
        [0, 2, 0, 0],
        [0, 3, 4, 0],
        [0, 5, 18, 8],
    ]
    assert seamwright.beta_matrix([]).tolist() == [[1]]
    assert seamwright.composed_beta([2, 3], [5, 7]).tolist() == [10, 43]
    assert seamwright.inverse_beta([1, 1, 1, 1]).tolist() == [
        1,
        -1,
        2,
        -6,
    ]  # exp(u) - 1 and ln(1 + t)
    assert seamwright.reversed_beta(np.ones(4)).tolist() == [1, 1, 2, 6]
    product = seamwright.beta_matrix([2, 3, 5]) @ seamwright.beta_matrix([1.5, -1, 4])
    assert seamwright.beta_matrix(
        seamwright.composed_beta([2, 3, 5], [1.5, -1, 4])
    ) == pytest.approx(product)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_next_poles_are_those_of_the_derivatives(order):
    beta, degree = [1.5, -0.5, 2][:order], 5
    poles, weights = seamwright.next_poles(A, degree, beta, length=2, next_length=0.5)
    assert poles.shape == (order + 1, 3) and weights.tolist() == [1] * (order + 1)
    arriving = A.derivatives(1, order) / 2.0 ** np.arange(order + 1)[:, None]
    leaving = seamwright.beta_matrix(beta) @ arriving
    differences = [np.diff(poles, k, axis=0)[0] for k in range(order + 1)]
    for k in range(order + 1):
        assert falling(degree, k) * differences[k] / 0.5**k == pytest.approx(
            leaving[k], abs=1e-12
        )


def test_a_joined_curve_fits():
    b = seamwright.joined_curve(A, B, [1.5, -0.5])
    assert b.degree == 5
    assert b.derivatives(1, 2) == pytest.approx(B.derivatives(1, 2), abs=1e-12)
    fit = seamwright.fit_beta(A, b, 3)
    assert fit["beta"][:2] == pytest.approx([1.5, -0.5], abs=1e-13)
    assert max(fit["defects"][:3]) < 1e-13 and fit["defects"][3] > 1e-3
    assert all(
        low <= d <= up
        for low, d, up in zip(fit["lower"], fit["defects"], fit["upper"], strict=True)
    )
    assert fit["lower"][3] > 0
    assert fit["length_mm"] == 3
    moved = b.poles
    moved[2, 1] += 1e-6
    missed = seamwright.fit_beta(A, BezierCurve(moved), 3)
    assert missed["lower"][2] > 1e-7 and missed["upper"][1] < 1e-12
    assert seamwright.joined_curve(A, B, [1.5, -0.5], keep_end=False).degree == 4
    short = seamwright.fit_beta(
        A, seamwright.joined_curve(A, B, [1.5, -0.5], length=2, next_length=0.5), length_mm=2
    )
    assert short["beta"] == pytest.approx([1.5 * 0.5 / 2, -0.5 * 0.25 / 2], abs=1e-13)
    assert short["length_mm"] == 2


def test_a_rational_curve_goes_on():
    arc = BezierCurve([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, math.sqrt(0.5), 1])
    for scale in (None, [2, 0.3, -0.2]):
        poles, weights = seamwright.next_poles(arc, 2, [1, 0], scale=scale)
        on = BezierCurve(poles, weights)
        assert on.is_rational
        fit = seamwright.fit_beta(arc, on, 2)
        assert fit["beta"] == pytest.approx([1, 0], abs=1e-12) and max(fit["defects"]) < 1e-12


def test_a_bridge_joins_both():
    later = BezierCurve(B.poles + [4, 2, 0])
    bridge = seamwright.bridge_curve(A, later, [1.2, 0.3], [0.8, -1, 2])
    assert bridge.degree == 6
    assert seamwright.fit_beta(A, bridge, 2)["beta"] == pytest.approx([1.2, 0.3], abs=1e-11)
    assert seamwright.fit_beta(bridge, later, 3)["beta"] == pytest.approx([0.8, -1, 2], abs=1e-10)
    assert max(seamwright.fit_beta(bridge, later, 3)["defects"]) < 1e-11


def test_a_cusp_has_no_beta():
    fit = seamwright.fit_beta(A, A.reversed(), 2)
    assert fit["beta"].shape == (0,) and fit["defects"][1] == pytest.approx(2)


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: seamwright.beta_matrix([-1, 0]), "beta_1 is -1: it must be positive"),
        (lambda: seamwright.beta_matrix([1, math.nan]), "beta_2 is nan"),
        (lambda: seamwright.beta_matrix(1.5), "beta is 1.5: a sequence of numbers is needed"),
        (lambda: seamwright.beta_matrix([[1, 2]]), "beta is .*: a sequence of numbers is needed"),
        (lambda: seamwright.beta_matrix(np.array([[1.0], [2.0]])), "beta is array"),
        (lambda: seamwright.beta_matrix(np.array(1.0)), "beta is array"),
        (lambda: seamwright.beta_matrix(np.array([1 + 1j])), "beta is array"),
        (
            lambda: seamwright.beta_matrix([1.0, np.complex64(1j)]),
            "beta is .*: a sequence of numbers is needed",
        ),
        (lambda: seamwright.beta_matrix([True]), r"beta is \[True\]"),
        (lambda: seamwright.beta_matrix(np.array([True])), "beta is array"),
        (
            lambda: seamwright.next_poles(A, 3, [1], scale=[]),
            r"scale is \[\]: n \+ 1 numbers are needed",
        ),
        (
            lambda: BezierCurve(A.poles + 1j),
            "numbers of complex128, but an array of real numbers is needed",
        ),
        (lambda: BezierCurve(A.poles, A.weights > 0), "numbers of bool"),
        (lambda: seamwright.composed_beta([1], [1, 2]), "betas 1 and 2"),
        (lambda: seamwright.inverse_beta([1] * 31), "31 betas"),
        (lambda: seamwright.reversed_beta([0]), "beta_1 is 0"),
        (lambda: seamwright.fit_beta(A, B, 31), "order 31"),
        (lambda: seamwright.fit_beta(A, B, 1.5), "order is 1.5: a whole number is needed"),
        (lambda: seamwright.fit_beta(A, B, length_mm=-1), "length_mm is -1"),
        (lambda: seamwright.fit_beta(A, B, length_mm="1"), "length_mm is '1'"),
        (lambda: seamwright.next_poles(A, 1, [1, 0]), "degree 1: it must be within 2 to 100"),
        (lambda: seamwright.next_poles(A, 3, [1], scale=[1]), "scale has 1 numbers: 2 are needed"),
        (lambda: seamwright.next_poles(A, 3, [1], scale=[1, -6]), "weight 1 comes out as -1"),
        (lambda: seamwright.next_poles(A, 3, [1], length=0), "length is 0"),
        (lambda: seamwright.joined_curve(A, B, [1], keep_end=1), "keep_end is 1: True or False"),
        (
            lambda: seamwright.joined_curve(BezierCurve([[0, 0, 0], [1, 0, 0], [1, 0, 0]]), B, [1]),
            "no tangent at its end",
        ),
        (
            lambda: seamwright.bridge_curve(A, BezierCurve(A.poles, [1, 2, 1, 1]), [1], [1]),
            "b is rational, weight 0 is 1, weight 1 is 2",
        ),
    ],
)
def test_bad_arguments(call, text):
    with pytest.raises(ValueError, match=text):
        call()
