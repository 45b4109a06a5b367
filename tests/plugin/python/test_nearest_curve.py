# SPDX-License-Identifier: LGPL-2.1-or-later
"""nearest_curve_join: shapes, keywords and errors; the figures by joints that are measured."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BSplineCurve
from seeds import seed_of_test


def kinked(degree=3, noise=0.05, weights=None):
    """Two curves along x, the second turned by 0.3 at the origin."""
    random = np.random.default_rng(seed_of_test(1))
    x = np.arange(degree + 1.0)
    a = np.stack([x - degree, 0.1 * (x - degree) ** 2, 0 * x], axis=-1)
    b = np.stack([x * np.cos(0.3), x * np.sin(0.3) - 0.05 * x**2, 0 * x], axis=-1)
    return [BezierCurve(p + random.normal(0, noise, p.shape), weights) for p in (a, b)]


def defects(join, order):
    return seamwright.fit_beta(join["a"], join["b"], order)["defects"]


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("moves", ["both", "a", "b"])
@pytest.mark.parametrize("weights", [None, [1, 2, 0.5, 1]])
def test_curves_join(order, moves, weights):
    a, b = kinked(weights=weights)
    join = seamwright.nearest_curve_join(a, b, order=order, moves=moves)
    assert join["status"] == "solved" and join["reason"] == ""
    # Derivatives by arc length divide roundings by powers of the speed, and one side may be slow.
    slowness = max(join["beta"][0], 1 / join["beta"][0])
    assert max(*defects(join, order), join["residual"]) < 1e-13 * slowness ** (2 * order - 1)
    assert join["gradient"] < 1e-8
    assert (join["a"] == a) == (moves == "b")
    assert (join["b"] == b) == (moves == "a")
    moved = [np.linalg.norm(join[k].poles - c.poles, axis=1) for k, c in (("a", a), ("b", b))]
    assert sum(np.sum(m**2) for m in moved) / 2 == pytest.approx(join["cost"], rel=1e-9)
    assert max(m.max() for m in moved) == pytest.approx(join["largest_move_mm"], rel=1e-9)
    again = seamwright.nearest_curve_join(join["a"], join["b"], order=order)
    assert again["status"] == "solved" and again["largest_move_mm"] < 1e-12


def test_poles_that_stay_or_are_dear():
    a, b = kinked(noise=0)
    join = seamwright.nearest_curve_join(a, b, order=2, fixed_a=[-1], fixed_b=[0])
    assert join["status"] == "solved"
    assert (join["a"].poles[-1] == a.poles[-1]).all() and (join["b"].poles[0] == b.poles[0]).all()
    join = seamwright.nearest_curve_join(a, b, costs_a=[1e8] * 4)
    assert np.abs(join["a"].poles - a.poles).max() < 1e-7
    join = seamwright.nearest_curve_join(a, b, fixed_a=[False, False, True, True], fixed_b=[0, 1])
    assert join["status"] == "infeasible"
    assert join["reason"] == "the poles that may move cannot make the join"
    assert join["a"] == a and join["b"] == b


@pytest.mark.parametrize("moves", ["a", "b", "both"])
def test_the_ends_are_one_point_bit_by_bit(moves):
    random = np.random.default_rng(seed_of_test())
    for _ in range(50):
        a = seamwright.BezierCurve(np.cumsum(random.uniform(0.5, 1.5, (4, 3)), axis=0))
        b = seamwright.BezierCurve(
            a.poles[-1] + np.cumsum(random.uniform(0.2, 1.5, (4, 3)), axis=0) - 0.4
        )
        join = seamwright.nearest_curve_join(a, b, order=1, moves=moves)
        assert join["status"] == "solved"
        assert (join["a"].poles[-1] == join["b"].poles[0]).all()
        seamwright.BezierSpline.from_segments([join["a"], join["b"]], [0, 1, 2])


def test_given_betas():
    a, b = kinked()
    join = seamwright.nearest_curve_join(a, b, order=2, beta=[1.25, -0.5])
    assert join["status"] == "solved"
    assert join["beta"] == pytest.approx([1.25, -0.5])
    assert seamwright.fit_beta(join["a"], join["b"], 2)["beta"] == pytest.approx([1.25, -0.5])
    assert join["cost"] > seamwright.nearest_curve_join(a, b, order=2)["cost"]


def test_splines():
    a, b = kinked()
    poles = np.vstack([b.poles, [[4, 1, 0], [5, 1, 1]]])
    spline = BSplineCurve(3, [0] * 4 + [0.4, 0.7] + [2] * 4, poles)
    join = seamwright.nearest_curve_join(a, spline, order=2)
    assert join["status"] == "solved"
    assert isinstance(join["a"], BSplineCurve) and join["b"].knots == spline.knots
    assert (join["b"].poles[3:] == poles[3:]).all()
    ends = [
        seamwright.arc_length_derivatives(c.derivatives(t, 3))
        for c, t in ((join["a"], 1), (join["b"], 0))
    ]
    differences = np.linalg.norm(ends[1] - ends[0], axis=1)
    assert max(differences[:3]) < 1e-11 < 1e-3 < differences[3]


@pytest.mark.parametrize(
    "keywords, words",
    [
        ({"order": 0}, "order is 0"),
        ({"order": 4}, "degree of a is 3, the order 4"),
        ({"order": 1.5}, "order is 1.5: a whole number is needed"),
        ({"moves": "c"}, "moves is 'c': 'both', 'a' or 'b' is needed"),
        ({"moves": 1}, "moves is 1: 'both', 'a' or 'b' is needed"),
        ({"moves": None}, "moves is None"),
        ({"moves": []}, r"moves is \[\]"),
        ({"beta": [True]}, r"beta is \[True\]: a sequence of numbers is needed"),
        ({"costs_a": np.ones((4, 1))}, "costs_a is array"),
        ({"costs_a": [1, 2]}, "costs_a has 2 numbers, the curve 4 poles"),
        ({"costs_b": [1, 1, 0, 1]}, r"costs_b\[2\] is 0"),
        ({"costs_b": "high"}, "costs_b is 'high': a sequence of numbers is needed"),
        ({"fixed_a": [4]}, r"fixed_a is \[4\]: no pole 4; the curve has 4 poles"),
        ({"fixed_b": [-5]}, r"fixed_b is \[-5\]: no pole -5; the curve has 4 poles"),
        ({"fixed_a": [True, False]}, r"fixed_a is \[True, False\]: 2 booleans"),
        ({"fixed_a": [0.0]}, "not whole numbers"),
        ({"fixed_a": "ends"}, "fixed_a is 'ends'"),
        (
            {"order": np.float32(2.7)},
            r"order is (2\.7|np\.float32\(2\.7\)): a whole number is needed",
        ),
        ({"order": np.array([[2]])}, "order is array"),
        ({"beta": [1, 0]}, "betas 2, order 1"),
        ({"beta": [-1]}, "beta_1 is -1"),
        ({"max_iterations": -1}, "max_iterations is -1"),
    ],
)
def test_errors_name_the_value(keywords, words):
    with pytest.raises(ValueError, match=words):
        seamwright.nearest_curve_join(*kinked(), **keywords)
