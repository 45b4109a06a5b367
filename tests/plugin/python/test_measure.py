# SPDX-License-Identifier: LGPL-2.1-or-later
"""measure_pair, curvature_tensor and principal_curvatures against closed forms."""

import math

import numpy as np
import pytest

import seamwright
from seamwright import _core
from seeds import seed_of_test


def jet(**partials):
    made = _core.SurfaceJet()
    for name, value in partials.items():
        setattr(made, name, np.asarray(value, dtype=float))
    return made


def paraboloid(k1, k2, turn=0.0, at=(0, 0, 0)):
    """z = (k1 x'^2 + k2 y'^2) / 2 at its vertex, the axes x', y' turned about z."""
    c, s = math.cos(turn), math.sin(turn)
    return jet(p=at, u=(c, s, 0), v=(-s, c, 0), uu=(0, 0, k1), vv=(0, 0, k2))


def moved(j, rotation, scale=1.0):
    names = ("p", "u", "v", "uu", "uv", "vv")
    return jet(**{name: scale * rotation @ getattr(j, name) for name in names})


def random_rotation(random):
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q @ np.diag(np.sign(np.diag(r)))
    return q if np.linalg.det(q) > 0 else -q


@pytest.mark.parametrize("phi", [0, 1, 30, 45, 90])
def test_crossed_cylinders(phi):
    random = np.random.default_rng(seed_of_test())
    for _ in range(20):
        rotation = random_rotation(random)
        a, b = paraboloid(0, 0.1), paraboloid(0, 0.1, math.radians(phi))
        pair = seamwright.measure_pair(moved(a, rotation), moved(b, rotation))
        assert pair["gap_mm"] == pytest.approx(0, abs=1e-15)
        assert pair["angle_rad"] == pytest.approx(0, abs=1e-14)
        assert pair["curvature_per_mm"] == pytest.approx(
            0.1 * math.sin(math.radians(phi)), abs=1e-14
        )
        assert pair["norm_a_per_mm"] == pytest.approx(0.1) and pair[
            "norm_b_per_mm"
        ] == pytest.approx(0.1)


def test_gap_and_angle():
    a = jet(p=(0, 0, 0), u=(1, 0, 0), v=(0, 1, 0))
    for degrees in (0, 0.001, 10, 60, 90, 150):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        pair = seamwright.measure_pair(a, jet(p=(3, 4, 12), u=(1, 0, 0), v=(0, c, s)))
        assert pair["gap_mm"] == pytest.approx(13)
        expected = degrees if degrees <= 90 else 180 - degrees
        assert math.degrees(pair["angle_rad"]) == pytest.approx(expected, abs=1e-12)


def test_degenerate_sides_are_named():
    flat = jet(u=(1, 0, 0), v=(0, 1, 0))
    pair = seamwright.measure_pair(flat, jet(u=(1, 0, 0), v=(2, 0, 0)))
    assert (pair["degenerate_a"], pair["degenerate_b"]) == ("none", "vanishing normal")
    assert pair["angle_rad"] is None and pair["curvature_per_mm"] is None
    pair = seamwright.measure_pair(jet(p=(math.nan, 0, 0)), flat)
    assert pair["degenerate_a"] == "not finite" and pair["gap_mm"] is None


def test_tensor_and_principal_curvatures():
    random = np.random.default_rng(seed_of_test())
    for _ in range(20):
        k1, k2, rotation = *sorted(random.normal(size=2), reverse=True), random_rotation(random)
        surface = moved(paraboloid(k1, k2, random.uniform(0, 3)), rotation)
        tensor = seamwright.curvature_tensor(surface)
        assert tensor.shape == (3, 3) and tensor == pytest.approx(tensor.T, abs=1e-12)
        assert sorted(np.linalg.eigvalsh(tensor)) == pytest.approx(sorted([k1, k2, 0]), abs=1e-12)
        found1, found2, d1, d2 = seamwright.principal_curvatures(surface)
        assert (found1, found2) == pytest.approx((k1, k2), abs=1e-12)
        assert d1 @ tensor @ d1 == pytest.approx(
            k1, abs=1e-10
        ) and d2 @ tensor @ d2 == pytest.approx(k2, abs=1e-10)


def test_a_jet_without_tangent_plane_is_an_error():
    for call in (seamwright.curvature_tensor, seamwright.principal_curvatures):
        with pytest.raises(ValueError, match="vanishing normal"):
            call(jet(u=(1, 0, 0), v=(1, 0, 0)))
