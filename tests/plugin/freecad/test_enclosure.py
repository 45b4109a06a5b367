# SPDX-License-Identifier: LGPL-2.1-or-later
"""Enclosures as texts at the borders of their rules, as enclosure.py states them."""

import math

import pytest

from freecad.seamwright.plain import enclosure


@pytest.mark.parametrize(
    "lower, upper, limit, text",
    [
        (1.0, 1.009, None, "1.01"),  # enclosed to 1 %
        (1.0, 1.012, None, "1..1.02"),  # wider: rounded outward
        (0.01, 0.01005, 0.01, "0.01..0.0101"),  # contains the limit
        (0.0099, 0.00995, 0.01, "0.00995"),
        (0.009, 1.0, None, "\u22641"),  # below 1 % of the upper bound
        (0.012, 1.0, None, "0.012..1"),
        (0.009, 1.0, 0.005, "0.009..1"),  # but beyond the limit
        (8e-5, 1e-4, 0.01, "\u22641e-4"),  # far below the limit
        (1e-4, 1.2e-4, 0.01, "1e-4..1.2e-4"),
        (0.3, None, None, "\u22650.3"),
        (0.0, 0.0, None, "0"),
    ],
)
def test_rules_of_enclosures(lower, upper, limit, text):
    assert enclosure.text({"lower": lower, "upper": upper, "at": 0}, limit=limit) == text


@pytest.mark.parametrize(
    "value, text",
    [
        (1e-3, "0.001"), (9.99e-4, "1e-3"), (9.9e-4, "9.9e-4"), (99999.0, "99999"), (1e5, "1e5"),
        (123456.0, "1.2e5"), (1234.5, "1234"), (0, "0"),
    ],
)  # fmt: skip
def test_very_small_and_very_large_numbers_have_an_exponent(value, text):
    assert enclosure.number(value) == text


def test_outward_rounding_ignores_the_noise_of_the_last_digit():
    assert enclosure.number(2 - 1e-15, rounding=math.floor) == "2"
    assert enclosure.number(2 + 1e-15, rounding=math.ceil) == "2"
    assert enclosure.number(1.9999, rounding=math.floor) == "1.99"
    assert enclosure.number(2.0001, rounding=math.ceil) == "2.01"
