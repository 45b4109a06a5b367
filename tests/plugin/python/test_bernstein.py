# SPDX-License-Identifier: LGPL-2.1-or-later
"""BernsteinPolynomial against exact rational arithmetic."""

import math
from fractions import Fraction

import numpy as np
import pytest

from seamwright import BernsteinPolynomial
from seeds import seed_of_test


def exact(coefficients, t):
    n = len(coefficients) - 1
    t = Fraction(t)
    return sum(
        Fraction(c) * math.comb(n, i) * t**i * (1 - t) ** (n - i)
        for i, c in enumerate(coefficients)
    )


PLACES = [0.0, 0.1, 0.3, 0.5, 0.77, 1.0]


@pytest.fixture
def random():
    return np.random.default_rng(seed_of_test())


def holds(polynomial, t, value, width=1e-12):
    lower, upper = polynomial.evaluate(t)
    return lower <= value <= upper and upper - lower <= width


@pytest.mark.parametrize("degree", [0, 1, 2, 5, 9])
def test_values_sums_products_and_derivatives(random, degree):
    a, b = (random.normal(size=degree + 1) for _ in range(2))
    p, q = BernsteinPolynomial(a), BernsteinPolynomial(b)
    assert p.degree == degree and p.padding == 0 and np.array_equal(p.coefficients, a)
    slope = [degree * (Fraction(y) - Fraction(x)) for x, y in zip(a, a[1:])] or [Fraction(0)]
    for t in PLACES:
        x, y = exact(a, t), exact(b, t)
        assert (
            holds(p, t, x)
            and holds(p + q, t, x + y)
            and holds(p - q, t, x - y)
            and holds(p * q, t, x * y)
        )
        assert holds(2 * p, t, 2 * x) and holds(p * 2, t, 2 * x) and holds(-p, t, -x)
        assert holds(p.derivative(), t, exact(slope, t)) and holds(p.elevated(3), t, x)
    assert (p * q).degree == 2 * degree and p.elevated(3).degree == degree + 3


def test_pieces(random):
    a = random.normal(size=6)
    p = BernsteinPolynomial(a)
    left, right = p.split(0.25)
    middle = p.restricted(0.25, 0.75)
    for s in PLACES:
        place = Fraction(s)
        assert holds(left, s, exact(a, place / 4)) and holds(
            right, s, exact(a, (1 + 3 * place) / 4)
        )
        assert holds(middle, s, exact(a, (1 + 2 * place) / 4))


def test_range():
    p = BernsteinPolynomial([0, 1, 0])  # 2 t (1 - t): 0 to 1/2
    assert p.range() == pytest.approx((0, 1), abs=1e-15)
    lower, upper = p.range(1e-6)
    assert -1e-6 <= lower <= 0 and 0.5 <= upper <= 0.5 + 1e-6


def test_comparison():
    assert BernsteinPolynomial([1, 2]) == BernsteinPolynomial([1, 2])
    assert BernsteinPolynomial([1, 2]) != BernsteinPolynomial([1, 2], padding=0.5)


@pytest.mark.parametrize(
    "call",
    [
        lambda: BernsteinPolynomial([]),
        lambda: BernsteinPolynomial([math.nan]),
        lambda: BernsteinPolynomial([1], padding=-1),
        lambda: BernsteinPolynomial([1, 2]).evaluate(1.5),
        lambda: BernsteinPolynomial([1, 2]).split(-0.1),
        lambda: BernsteinPolynomial([1, 2]).restricted(0.5, 0.25),
        lambda: BernsteinPolynomial([1, 2]).range(-1),
        lambda: BernsteinPolynomial([1, 2]).elevated(-1),
    ],
)
def test_bad_arguments(call):
    with pytest.raises(ValueError):
        call()
