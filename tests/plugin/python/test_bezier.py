# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves and patches against de Casteljau and exact derivatives written here, in numpy."""

import math

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierPatch
from seeds import seed_of_test


def bernstein(n, t):
    return np.array([math.comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])


def de_casteljau(poles, t):
    points = np.array(poles, dtype=float)
    while len(points) > 1:
        points = (1 - t) * points[:-1] + t * points[1:]
    return points[0]


def curve_polynomials(poles, weights):
    """Numerator (3 polynomials) and denominator in the power basis."""
    n = len(poles) - 1
    basis = []
    for i in range(n + 1):
        t_part = np.polynomial.Polynomial([0, 1]) ** i
        s_part = np.polynomial.Polynomial([1, -1]) ** (n - i)
        basis.append(math.comb(n, i) * t_part * s_part)
    numerator = [
        sum(float(w * p[k]) * b for p, w, b in zip(poles, weights, basis)) for k in range(3)
    ]
    return numerator, sum(float(w) * b for w, b in zip(weights, basis))


def exact_jet(poles, weights, t):
    """Derivatives of order 0..3 of N / D by Leibniz: N^(k) = sum binom(k, j) D^(j) X^(k-j)."""
    numerator, denominator = curve_polynomials(poles, weights)
    d = [denominator.deriv(k)(t) if k else denominator(t) for k in range(4)]
    rows = np.zeros((4, 3))
    for axis in range(3):
        values = [numerator[axis].deriv(k)(t) if k else numerator[axis](t) for k in range(4)]
        for k in range(4):
            rest = sum(math.comb(k, j) * d[j] * rows[k - j, axis] for j in range(1, k + 1))
            rows[k, axis] = (values[k] - rest) / d[0]
    return rows


@pytest.fixture
def random():
    return np.random.default_rng(seed_of_test())


@pytest.mark.parametrize("degree", range(0, 9))
def test_curve_points_and_derivatives(random, degree):
    for _ in range(10):
        poles = random.normal(size=(degree + 1, 3))
        weights = random.uniform(0.5, 2, degree + 1)
        for curve, w in (
            (BezierCurve(poles), np.ones(degree + 1)),
            (BezierCurve(poles, weights), weights),
        ):
            for t in (0, 0.3, 0.71, 1):
                homogeneous = de_casteljau(np.column_stack((poles * w[:, None], w)), t)
                assert curve.point(t) == pytest.approx(homogeneous[:3] / homogeneous[3], abs=1e-12)
                jet = curve.jet(t)
                assert jet.shape == (4, 3)
                assert jet == pytest.approx(exact_jet(poles, w, t), rel=1e-9, abs=1e-8)


def test_curve_attributes(random):
    poles, weights = random.normal(size=(5, 3)), random.uniform(1, 2, 5)
    curve = BezierCurve(poles)
    assert curve.degree == 4 and not curve.is_rational
    assert np.array_equal(curve.poles, poles) and np.array_equal(curve.weights, np.ones(5))
    rational = BezierCurve(poles, weights)
    assert rational.is_rational
    assert rational.poles == pytest.approx(poles, abs=1e-14) and np.array_equal(
        rational.weights, weights
    )
    assert BezierCurve(poles.tolist()) == curve
    assert BezierCurve(np.asfortranarray(poles)) == curve
    assert BezierCurve(poles[::-1][::-1]) == curve, "strided arrays as well"
    assert BezierCurve(np.arange(12).reshape(4, 3)).point(0) == pytest.approx(
        [0, 1, 2]
    ), "integers as well"


def test_curve_is_not_bound_to_the_array(random):
    poles = random.normal(size=(4, 3))
    curve = BezierCurve(poles)
    before = curve.point(0.5).copy()
    poles[:] = 0
    given = curve.poles
    given[:] = 7
    assert np.array_equal(curve.point(0.5), before)


def test_curve_operations(random):
    poles, weights = random.normal(size=(5, 3)), random.uniform(0.5, 2, 5)
    curve = BezierCurve(poles, weights)
    left, right = curve.split(0.35)
    for t in np.linspace(0, 1, 7):
        expected = curve.point(t)
        assert curve.elevated().point(t) == pytest.approx(expected, abs=1e-12)
        assert curve.reversed().point(1 - t) == pytest.approx(expected, abs=1e-12)
        assert left.point(t) == pytest.approx(curve.point(0.35 * t), abs=1e-12)
        assert right.point(t) == pytest.approx(curve.point(0.35 + 0.65 * t), abs=1e-12)
    assert curve.elevated().degree == 5


def tensor(poles, weights, u, v):
    """Homogeneous de Casteljau in v, then in u."""
    homogeneous = np.concatenate((poles * weights[..., None], weights[..., None]), axis=2)
    rows = [de_casteljau(row, v) for row in homogeneous]
    h = de_casteljau(rows, u)
    return h[:3] / h[3]


def basis_derivatives(n, t):
    """Values and derivatives to third order of the Bernstein polynomials, from their recursion."""
    table = [bernstein(n, t)]
    for k in range(1, 4):
        if k > n:
            table.append(np.zeros(n + 1))
            continue
        lower = bernstein(n - k, t)
        row = np.zeros(n + 1)
        for j in range(k + 1):
            row[j : j + n - k + 1] += (-1) ** (k - j) * math.comb(k, j) * lower
        table.append(math.perm(n, k) * row)
    return table


@pytest.mark.parametrize("m,n", [(1, 1), (2, 3), (3, 3), (5, 2), (4, 6)])
def test_patch_points_and_partials(random, m, n):
    poles = random.normal(size=(m + 1, n + 1, 3))
    patch = BezierPatch(poles)
    for u, v in random.uniform(0, 1, (10, 2)):
        assert patch.point(u, v) == pytest.approx(
            tensor(poles, np.ones((m + 1, n + 1)), u, v), abs=1e-12
        )
        bu, bv, jet = basis_derivatives(m, u), basis_derivatives(n, v), patch.jet(u, v)
        for name, (i, j) in {
            "p": (0, 0),
            "u": (1, 0),
            "v": (0, 1),
            "uu": (2, 0),
            "uv": (1, 1),
            "vv": (0, 2),
            "uuu": (3, 0),
            "uuv": (2, 1),
            "uvv": (1, 2),
            "vvv": (0, 3),
        }.items():
            expected = np.einsum("i,j,ijk->k", bu[i], bv[j], poles)
            assert getattr(jet, name) == pytest.approx(expected, rel=1e-10, abs=1e-9), name


def test_rational_patch_against_finite_differences(random):
    poles, weights = random.normal(size=(4, 3, 3)), random.uniform(0.5, 2, (4, 3))
    patch = BezierPatch(poles, weights)
    h = 1e-3

    def f(i, j):
        return tensor(poles, weights, u + i * h, v + j * h)

    for u, v in random.uniform(0.2, 0.8, (10, 2)):
        jet = patch.jet(u, v)
        assert jet.p == pytest.approx(f(0, 0), abs=1e-12)
        # Fourth-order central differences.
        first = [(1, -2), (-8, -1), (8, 1), (-1, 2)]
        second = [(-1, -2), (16, -1), (-30, 0), (16, 1), (-1, 2)]
        assert jet.u == pytest.approx(sum(c * f(i, 0) for c, i in first) / (12 * h), abs=1e-7)
        assert jet.v == pytest.approx(sum(c * f(0, i) for c, i in first) / (12 * h), abs=1e-7)
        assert jet.uu == pytest.approx(sum(c * f(i, 0) for c, i in second) / (12 * h * h), abs=1e-4)
        assert jet.vv == pytest.approx(sum(c * f(0, i) for c, i in second) / (12 * h * h), abs=1e-4)
        mixed = sum(c * d * f(i, j) for c, i in first for d, j in first) / (144 * h * h)
        assert jet.uv == pytest.approx(mixed, abs=1e-4)


def test_patch_operations(random):
    poles, weights = random.normal(size=(3, 5, 3)), random.uniform(0.5, 2, (3, 5))
    patch = BezierPatch(poles, weights)
    assert (patch.degree_u, patch.degree_v) == (2, 4)
    assert patch.poles.shape == (3, 5, 3) and patch.weights.shape == (3, 5)
    assert patch.poles == pytest.approx(poles, abs=1e-14) and np.array_equal(patch.weights, weights)
    left, right = patch.split_u(0.6)
    for u, v in random.uniform(0, 1, (8, 2)):
        expected = tensor(poles, weights, u, v)
        assert patch.transposed().point(v, u) == pytest.approx(expected, abs=1e-12)
        assert patch.reversed_u().point(1 - u, v) == pytest.approx(expected, abs=1e-12)
        assert patch.iso_curve_u(u).point(v) == pytest.approx(expected, abs=1e-12)
        assert left.point(u, v) == pytest.approx(tensor(poles, weights, 0.6 * u, v), abs=1e-12)
        assert right.point(u, v) == pytest.approx(
            tensor(poles, weights, 0.6 + 0.4 * u, v), abs=1e-12
        )


@pytest.mark.parametrize("shape", [(3,), (4, 2), (4, 4), (2, 2, 3), (0, 3), ()])
def test_curves_of_bad_shape(shape):
    with pytest.raises(ValueError) as error:
        BezierCurve(np.zeros(shape))
    if 0 not in shape:
        assert ", ".join(map(str, shape)) in str(error.value)


@pytest.mark.parametrize(
    "shape", [(3,), (4, 3), (2, 2, 2), (2, 2, 4), (2, 2, 2, 3), (0, 2, 3), (2, 0, 3)]
)
def test_patches_of_bad_shape(shape):
    with pytest.raises(ValueError) as error:
        BezierPatch(np.zeros(shape))
    if 0 not in shape:
        assert ", ".join(map(str, shape)) in str(error.value)


@pytest.mark.parametrize("bad", [0, -1.5, math.nan, math.inf])
def test_bad_weights_are_named(bad):
    weights = np.ones(4)
    weights[2] = bad
    with pytest.raises(ValueError, match="2"):
        BezierCurve(np.zeros((4, 3)), weights)
    with pytest.raises(ValueError):
        BezierCurve(np.zeros((4, 3)), np.ones(3))
    with pytest.raises(ValueError):
        BezierPatch(np.zeros((2, 3, 3)), np.ones((3, 2)))


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_poles_that_are_no_numbers_are_named(bad):
    poles = np.zeros((5, 3))
    poles[3, 1] = bad
    with pytest.raises(ValueError, match="3"):
        BezierCurve(poles)
    net = np.zeros((2, 3, 3))
    net[1, 2, 0] = bad
    with pytest.raises(ValueError, match="5"):
        BezierPatch(net)


def test_words_are_no_poles():
    with pytest.raises((TypeError, ValueError)):
        BezierCurve("poles")
    with pytest.raises((TypeError, ValueError)):
        BezierCurve(None)


def test_equality_and_hash():
    a = BezierCurve(np.eye(3))
    assert a == BezierCurve(np.eye(3)) and a != BezierCurve(2 * np.eye(3))
    with pytest.raises(TypeError):
        hash(a)


def test_version_is_reported():
    assert seamwright.__version__ and seamwright.OCCT_VERSION.count(".") == 2
