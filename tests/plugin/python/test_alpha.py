# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alpha-curves, alpha-splines and the condition for alpha-surfaces: shapes, keywords and errors;
figures by their equations."""

import numpy as np
import pytest

import seamwright

POLYGON = np.array([[0, 0, 0], [1, 2, 0], [3, 2, 1], [4, 0, 0]], float)


def net(balanced=0):
    """A net whose last rows have X_0 + X_3 = X_1 + X_2, so many of them."""
    x, y = np.meshgrid([0.0, 3, 6, 9], [0.0, 3, 6, 9], indexing="ij")
    poles = np.stack([x, y, 0.01 * x * y + np.sin(x + 2 * y)], axis=-1)
    for row in range(4 - balanced, 4):
        poles[row, 3] = poles[row, 1] + poles[row, 2] - poles[row, 0]
    return poles


def test_curve():
    curve = seamwright.alpha_curve(POLYGON, 0.4)
    assert curve.degree == 5 and not curve.is_rational
    for t in (0, 0.3, 1):
        basis = seamwright.alpha_basis(0.4, t)
        assert basis.sum() == pytest.approx(1, abs=1e-15)
        assert np.allclose(curve.point(t), basis @ POLYGON, atol=1e-14)
    assert seamwright.alpha_curve(POLYGON) == seamwright.alpha_curve(POLYGON, 1)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_join(order):
    poles = seamwright.alpha_join_poles(
        POLYGON, 0.4, next_a=0.9, order=order, beta1=1.2, length=1, next_length=2
    )
    assert poles.shape == (2 if order == 1 else 3, 3)
    following = np.vstack([poles, POLYGON[: 4 - len(poles)] + [7, 1, 2]])
    a, b = seamwright.alpha_curve(POLYGON, 0.4), seamwright.alpha_curve(following, 0.9)
    joint = seamwright.measure_joint(a, b, order)
    assert max(joint["differences"]) < 1e-11
    if order == 2:
        assert seamwright.measure_joint(a, b, 3)["differences"][3] > 1e-3, "G2 is not G3 by itself"


def test_energy():
    for energy, order in (("length", 1), ("curvature", 2), ("curvature variation", 3)):
        best = seamwright.energy_optimal_alpha(POLYGON, energy, a_min=0)

        def integral(a):
            t, w = np.polynomial.legendre.leggauss(6)
            values = [
                seamwright.alpha_curve(POLYGON, a).derivatives((1 + x) / 2, order)[order] for x in t
            ]
            return (w / 2) @ np.sum(np.square(values), axis=1)

        assert best["energy"] == pytest.approx(integral(best["a"]), rel=1e-12)
        assert all(integral(a) >= best["energy"] * (1 - 1e-12) for a in np.linspace(0, 1, 21))
        assert not best["any"] and best["a"] == np.clip(best["free_a"], 0, 1)
    assert seamwright.energy_optimal_alpha(POLYGON[[0, 0, 3, 3]])["any"]


def test_spline():
    points = np.array([[0, 0, 0], [1, 2, 0], [3, 2, 1], [5, -1, 1], [7, 1, 0], [8, 3, 0]], float)
    spline = seamwright.alpha_spline(points, [1, 0.6, 0.8], lengths=[1, 2, 1.5])
    assert (spline.degree, spline.segments) == (5, 3)
    assert spline.continuity() == 2
    assert list(spline.knots) == [0, 1, 3, 4.5]
    geometric = seamwright.alpha_spline(points, [1, 0.7, 0.8], order=3, beta1=[1.2, 0.9])
    for i in range(2):
        joint = seamwright.measure_joint(geometric.segment(i), geometric.segment(i + 1), 3)
        assert max(joint["differences"]) < 1e-10
    ring = seamwright.alpha_spline(points[:4], [0.9] * 4, closed=True)
    assert ring.closed and ring.segments == 4
    assert seamwright.alpha_spline(points, [0.3, 0.4], order=1).segments == 2


def test_seam_condition():
    same = seamwright.alpha_seam_condition(net(), 0.5, 0.7)
    assert same["any_net"] and same["order"] == 2 and same["g1"]
    assert same["first_rows"].shape == (1, 3)
    for balanced in range(4):
        other = seamwright.alpha_seam_condition(net(balanced), 0.5, 0.7, 0.9)
        assert other["order"] == balanced - 1
        assert other["g1"] == (balanced >= 2)
        assert len(other["defects_mm"]) == 3
    rows = seamwright.alpha_sliding_rows(net(2), 0.5, 0.7, 1.5, 0, 0, next_a_v=0.9)
    assert np.allclose(
        rows, seamwright.alpha_join_rows(net(2), 0.5, 0.7, beta1=1.5, next_a_v=0.9), atol=1e-13
    )
    with pytest.raises(ValueError, match="is not the derivative of an alpha-surface"):
        seamwright.alpha_sliding_rows(net(), 0.5, 0.7, 1, 0.5, 0)


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("parametric", [False, True])
def test_nearest(order, parametric):
    following = net() + [9.2, 0.1, 0.3]
    near = seamwright.alpha_nearest_join(
        net(), 0.5, 0.7, following, 0.6, 0.9, order=order, parametric=parametric
    )
    fit = seamwright.alpha_seam_fit(near["net"], 0.5, 0.7, near["next_net"], 0.6, 0.9)
    assert fit["parametric_order" if parametric else "geometric_order"] == order
    assert near["cost"] == pytest.approx(np.sum((near["net"] - net()) ** 2)) and near["cost"] > 0
    assert near["next_cost"] == pytest.approx(np.sum((near["next_net"] - following) ** 2))
    if order:
        a, b = seamwright.alpha_surface(near["net"], 0.5, 0.7), seamwright.alpha_surface(
            near["next_net"], 0.6, 0.9
        )
        condition = seamwright.join_condition(a, "u1", b, "u0")
        assert condition["verdict"] == "G1" and condition["g2"] == (order == 2)
    assert seamwright.alpha_nearest_join(net(), 0.5, 0.7, net()[::-1], 0.5, 0.7) is None


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: seamwright.alpha_basis("x", 0.5), "a is 'x': a number is needed"),
        (lambda: seamwright.alpha_curve(POLYGON[:3]), r"poles have shape \(3, 3\)"),
        (lambda: seamwright.alpha_curve(POLYGON, 1.5), "a is 1.5"),
        (lambda: seamwright.alpha_curve(POLYGON * np.nan), r"pole 0 is \(nan"),
        (lambda: seamwright.alpha_join_poles(POLYGON, 0.5, order=7), "order 7"),
        (lambda: seamwright.alpha_join_poles(POLYGON, 0.5, beta1=-1), "beta1 is -1"),
        (lambda: seamwright.energy_optimal_alpha(POLYGON, "bending"), "energy is 'bending'"),
        (lambda: seamwright.energy_optimal_alpha(POLYGON, a_min=2), "a_min is 2"),
        (
            lambda: seamwright.alpha_spline(POLYGON, [0.9, 0.9]),
            "the polygon has 4 poles: 5 are needed",
        ),
        (
            lambda: seamwright.alpha_spline(np.vstack([POLYGON, POLYGON[:1]]), [0.4, 0.4]),
            "joint 0: second",
        ),
        (lambda: seamwright.alpha_spline(POLYGON, [0.9], closed=1), "closed is 1"),
        (lambda: seamwright.alpha_seam_condition(net()[:3], 1, 1), r"net has shape \(3, 4, 3\)"),
        (lambda: seamwright.alpha_seam_condition(net(), 1, 1, 0), "next_a_v is 0"),
        (lambda: seamwright.alpha_seam_fit(net(), 1, 1, net(), 2, 1), "a_u is 2"),
        (lambda: seamwright.alpha_nearest_join(net(), 1, 1, net(), 1, 1, order=3), "order 3"),
        (lambda: seamwright.alpha_curve(POLYGON.astype(str)), "an array of real numbers is needed"),
        (lambda: seamwright.alpha_curve(POLYGON + 0j), "numbers of complex128"),
        (lambda: seamwright.alpha_curve(POLYGON > 1), "numbers of bool"),
        (lambda: seamwright.alpha_curve("abc"), "are 'abc'"),
        (lambda: seamwright.alpha_curve(None), r"poles have shape \(\)"),
        (lambda: seamwright.alpha_curve(POLYGON, np.array([[0.5]])), "a is array"),
        (lambda: seamwright.alpha_curve(POLYGON, 0.5 + 1j), "a is .*1j"),
        (lambda: seamwright.alpha_spline(POLYGON, [True]), "a is .True.: a sequence of numbers"),
        (lambda: seamwright.alpha_spline(POLYGON, "1"), "a is '1'"),
        (
            lambda: seamwright.alpha_join_poles(POLYGON, 0.5, order=2, beta1=1e200),
            "pole 2 of the next one comes out",
        ),
        (
            lambda: seamwright.alpha_spline(
                np.vstack([POLYGON] * 2)[:5], [0.9, 0.9], beta1=[1e200]
            ),
            r"second of joint\[0\]",
        ),
    ],
)
def test_bad_arguments(call, text):
    with pytest.raises(ValueError, match=text):
        call()
