# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which spirals join two ends, through Python: clothoids, logarithmic spirals, arcs and biarcs are
the oracle."""

import math

import numpy as np
import pytest
import seamwright
from planar_samples import moved
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_spiral_ends.py"))


def ends_of_clothoid(curve):
    return (
        curve.start,
        curve.direction_rad,
        curve.curvature_per_mm,
        curve.end,
        curve.end_direction_rad,
        curve.end_curvature_per_mm,
    )


def random_clothoid():
    """Short: it turns by less than pi / 2."""
    length = RANDOM.uniform(1, 5)
    return seamwright.Clothoid(
        RANDOM.uniform(-3, 3, 2),
        RANDOM.uniform(-3, 3),
        RANDOM.uniform(-0.7, 0.7) / length,
        RANDOM.choice([-1, 1]) * RANDOM.uniform(0.3, 1.2) / length**2,
        length,
    )


def test_clothoids_have_the_kind_of_their_curvature():
    for _ in range(100):
        curve = random_clothoid()
        found = seamwright.spiral_certificate(*ends_of_clothoid(curve))
        rising = curve.curvature_slope_per_mm2 > 0
        assert found.kind == ("rising" if rising else "falling")
        assert found.turn_rad.sign == (1 if rising else -1)
        assert found.turn_rad.value == pytest.approx(found.start_angle_rad + found.end_angle_rad)
        assert found.separation.value < 0 and found.separation.sign == -1
        assert 0 < found.turn_rad.rounding < 1e-12


def test_points_of_spirals_are_in_the_bilens():
    for _ in range(50):
        curve = random_clothoid()
        lower, upper = seamwright.bilens_rad(
            curve.start, curve.direction_rad, curve.end, curve.end_direction_rad
        )
        points = curve.point(np.linspace(0, curve.length_mm, 30)[1:-1])
        turns = seamwright.turn_through_rad(curve.start, curve.end, points)
        assert turns.shape == (28,) and np.all((turns >= lower - 1e-12) & (turns <= upper + 1e-12))
        assert seamwright.turn_through_rad(curve.start, curve.end, points[3]) == turns[3]


def test_arcs_and_ends_without_a_spiral():
    arc = seamwright.PlanarArc([1, 2], 0.3, 0.25, 3)
    ends = [1, 2], 0.3, 0.25, arc.end, arc.end_direction_rad, 0.25
    assert seamwright.spiral_certificate(*ends).kind in ("arc", "undecided")
    # The curvature should rise at these ends, but is 0 at both.
    found = seamwright.spiral_certificate([0, 0], -0.1, 0, [1, 0], 0.6, 0)
    assert found.kind == "nothing" and found.turn_rad.sign == 1


def test_a_motion_keeps_the_kind():
    curve = random_clothoid()
    start, a, k, end, b, last = ends_of_clothoid(curve)
    one = seamwright.spiral_certificate(start, a, k, end, b, last)
    two = seamwright.spiral_certificate(
        moved([start])[0], a + 0.7, k, moved([end])[0], b + 0.7, last
    )
    assert one.kind == two.kind
    assert two.separation.value == pytest.approx(one.separation.value, abs=1e-12)


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: seamwright.spiral_certificate([0, 0], 0, 1, [0, 0], 1, 2), "point"),
        (lambda: seamwright.spiral_certificate([0, 0], 0, math.nan, [1, 0], 1, 2), "curvature"),
        (lambda: seamwright.bilens_rad([0, 0, 0], 0, [1, 0], 1), "start is"),
        (lambda: seamwright.turn_through_rad([0, 0], [1, 0], [0, 0]), "differ from both ends"),
        (lambda: seamwright.turn_through_rad([0, 0], [1, 0], np.zeros((2, 3))), r"\(2, 3\)"),
    ],
)
def test_bad_ends(call, text):
    with pytest.raises(ValueError, match=text):
        call()
