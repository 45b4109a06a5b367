# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conic segments and G2 chains of conics, through Python: closed forms and derivatives."""

import math

import numpy as np
import pytest
import seamwright
from planar_samples import circle_points, moved, quadrature, wrapped
from seamwright import PlanarArc, PlanarConic

T = np.linspace(0, 1, 11)


def curvature(conic, t):
    """From the derivatives of the rational curve."""
    d = conic.bezier_curve().derivatives(t, 2)[..., :2]
    cross = d[..., 1, 0] * d[..., 2, 1] - d[..., 1, 1] * d[..., 2, 0]
    return cross / np.linalg.norm(d[..., 1, :], axis=-1) ** 3


def expect_g2(before, after):
    assert np.linalg.norm(before.end - after.start) < 1e-12
    assert abs(wrapped(before.direction_at_rad(1) - after.direction_at_rad(0))) < 1e-9
    k = before.curvature_at_per_mm(1)
    assert after.curvature_at_per_mm(0) == pytest.approx(k, rel=1e-8)


def test_a_parabola_an_ellipse_and_a_circle():
    parabola = PlanarConic([-1, 1], [0, -1], [1, 1])  # y = x^2
    points = parabola.point(T)
    assert points.shape == (11, 2) and np.abs(points[:, 1] - points[:, 0] ** 2).max() < 1e-15
    expected = 2 / (1 + 4 * points[:, 0] ** 2) ** 1.5
    assert np.abs(parabola.curvature_at_per_mm(T) / expected - 1).max() < 1e-13
    assert np.abs(parabola.direction_at_rad(T) - np.arctan(2 * points[:, 0])).max() < 1e-14
    assert parabola.curvature_kind == "one maximum" and parabola.weight == 1
    quarter = PlanarConic([2, 0], [2, 2], [0, 2], math.sqrt(0.5))
    assert np.abs(np.linalg.norm(quarter.point(T), axis=1) - 2).max() < 1e-15
    assert np.abs(quarter.curvature_at_per_mm(T) - 0.5).max() < 1e-15
    assert quarter.turn_rad == pytest.approx(math.pi / 2)
    assert np.abs(quarter.bezier_curve().point(T)[:, :2] - quarter.point(T)).max() < 1e-15
    ellipse = PlanarConic([3, 0], [3, 1], [0, 1], math.sqrt(0.5))
    assert ellipse.curvature_at_per_mm(0) == pytest.approx(3)  # a / b^2
    part = PlanarConic.from_arc(seamwright.PlanarArc([0, -1], 0.3, 1, 0.9))
    flat = PlanarConic(*(v * [3, 1] for v in (part.start, part.corner, part.end)), part.weight)
    assert flat.curvature_kind == "monotone"


def test_curvature_and_direction_are_those_of_the_curve():
    conic = PlanarConic([0, 0], [2, 5], [6, 4], 1.7)
    assert np.abs(conic.curvature_at_per_mm(T) / curvature(conic, T) - 1).max() < 1e-12
    d = conic.bezier_curve().derivatives(T, 1)[:, 1]
    assert np.abs(wrapped(conic.direction_at_rad(T) - np.arctan2(d[:, 1], d[:, 0]))).max() < 1e-13
    back = conic.reversed()
    assert np.abs(back.point(T) - conic.point(1 - T)).max() < 1e-14
    assert np.abs(back.curvature_at_per_mm(T) + conic.curvature_at_per_mm(1 - T)).max() < 1e-14
    first, second = conic.halves()
    assert np.array_equal(first.end, second.start)
    assert np.abs(first.end - conic.point(0.5)).max() < 1e-15
    expect_g2(first, second)


def test_extrema_agree_with_the_profile():
    random = np.random.default_rng(7)
    kinds = {"monotone": 0, "one maximum": 1, "one minimum": 1, "maximum and minimum": 2}
    seen = set()
    for _ in range(300):
        conic = PlanarConic([0, 0], random.uniform(-2, 6, 2), [4, 0], random.uniform(0.2, 3))
        profile = seamwright.curvature_profile(conic.bezier_curve())
        if profile.undecided_extrema == []:
            assert len(profile.extrema) == kinds[conic.curvature_kind]
            seen.add(conic.curvature_kind)
    assert len(seen) >= 3


def test_arcs_are_conics():
    arc = seamwright.arc_through([1, 0], 0.3, [4, 3])
    conic = PlanarConic.from_arc(arc)
    assert np.array_equal(conic.start, arc.start) and np.abs(conic.end - arc.end).max() < 1e-14
    assert np.abs(conic.curvature_at_per_mm(T) - arc.curvature_per_mm).max() < 1e-13
    circle = seamwright.PlanarArc([2, 0], math.pi / 2, 0.5, 4 * math.pi)
    with pytest.raises(ValueError, match="turns by 6.28"):
        PlanarConic.from_arc(circle)
    pieces = seamwright.conics_of_arcs([circle])
    assert len(pieces) == 4 and all(isinstance(piece, PlanarConic) for piece in pieces)
    for piece in pieces:
        assert np.abs(np.linalg.norm(piece.point(T), axis=1) - 2).max() < 1e-14
    chain = seamwright.biarc_spline(circle_points(5, 2), closed=True)
    assert seamwright.conics_of_arcs(chain) == seamwright.conics_of_arcs(chain.chain.arcs)


def test_two_conics_have_the_given_curvatures():
    ends = ([0, 0], [4, 5], [9, 1])
    first, second = seamwright.two_conics(*ends, -0.3, -0.2, start_share=0.4, end_share=0.6)
    expect_g2(first, second)
    assert first.curvature_at_per_mm(0) == pytest.approx(-0.3, rel=1e-13)
    assert second.curvature_at_per_mm(1) == pytest.approx(-0.2, rel=1e-13)
    assert first.direction_at_rad(0) == pytest.approx(math.atan2(5, 4))
    assert second.direction_at_rad(1) == pytest.approx(math.atan2(-4, 5))
    other, _ = seamwright.two_conics(*moved(ends), -0.3, -0.2, start_share=0.4, end_share=0.6)
    assert np.abs(other.corner - moved(first.corner)).max() < 1e-13


def test_arcs_become_g2_conics():
    points = circle_points(7, 5) * [1, 0.6]
    spline = seamwright.biarc_spline(points, closed=True)
    found = seamwright.g2_conics(spline)
    count = len(found.conics)
    assert count == 14 + found.divisions and found.g1_joints == [] and found.curve.closed
    for i, conic in enumerate(found.conics):
        expect_g2(conic, found.conics[(i + 1) % count])
    assert 0 < found.least_weight <= found.largest_weight
    assert found.largest_move_mm < 1
    starts = np.array([conic.start for conic in found.conics])
    assert all(np.abs(starts - point).sum(axis=1).min() < 1e-12 for point in points)
    assert all(joint.order_reached >= 2 for joint in found.curve.measure_joints(2))
    again = seamwright.g2_conics(found, closed=True)
    assert again.largest_move_mm < 1e-7 and again.divisions == 0


def test_inflections_stay_g1():
    points = [[0, 0], [4, 3], [9, 4], [13, 1], [18, 2], [22, 7.0]]
    found = seamwright.g2_conics(seamwright.biarc_spline(points))
    assert found.g1_joints and not found.curve.closed
    for i, (before, after) in enumerate(zip(found.conics, found.conics[1:]), 1):
        if i not in found.g1_joints:
            expect_g2(before, after)
    arcs = list(seamwright.biarc_spline(points).chain.arcs)
    assert seamwright.g2_conics(arcs).conics == found.conics
    given = seamwright.g2_conics(seamwright.biarc_spline(points), start_curvature_per_mm=-0.2)
    assert given.conics[0].curvature_at_per_mm(0) == pytest.approx(-0.2, rel=1e-12)


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (
            lambda: PlanarConic([0, 0], [1, 1], [2, 0], 0),
            ValueError,
            "weight is 0.0: it must be pos",
        ),
        (lambda: PlanarConic([0, 0], [0, 0], [2, 0]), ValueError, "corner is .*must differ"),
        (lambda: PlanarConic([0, 0], [1, math.inf], [2, 0]), ValueError, "corner is .*finite"),
        (lambda: PlanarConic([0, 0], [1, 1], [2, 0]).point(1.1), ValueError, "t is 1.1: the curve"),
        (lambda: PlanarConic.from_arc(3), TypeError, "arc is 3: a PlanarArc is needed"),
        (lambda: seamwright.two_conics([0, 0], [1, 0], [2, 0], 1, 1), ValueError, "on a line"),
        (
            lambda: seamwright.two_conics([0, 0], [1, 1], [2, 0], 1, 1),
            ValueError,
            "the sign of the",
        ),
        (
            lambda: seamwright.two_conics([0, 0], [1, 1], [2, 0], -1, -1, start_share=1),
            ValueError,
            "share 1 is not between 0 and 1",
        ),
        (lambda: seamwright.conics_of_arcs(3), TypeError, "arcs is 3: a sequence is needed"),
        (lambda: seamwright.g2_conics([]), ValueError, "empty"),
        (lambda: seamwright.g2_conics([3]), TypeError, r"chain\[0\] is 3: a PlanarConic is needed"),
        (
            lambda: seamwright.g2_conics(
                [PlanarConic([0, 0], [1, 1], [2, 0]), PlanarConic([3, 0], [4, 1], [5, 0])]
            ),
            ValueError,
            "1",
        ),
    ],
)
def test_bad_conics(call, kind, text):
    with pytest.raises(kind, match=text):
        call()


def test_lengths_of_conics():
    arc = PlanarArc([1, 2], 0.3, 0.5, 4)
    assert PlanarConic.from_arc(arc).length_mm == pytest.approx(4, rel=1e-10)
    conic = PlanarConic([0, 0], [3, 4], [7, 1], 0.6)

    def speed(t):
        return np.linalg.norm(conic.bezier_curve().derivatives(t, 1)[..., 1, :], axis=-1)

    assert conic.length_mm == pytest.approx(quadrature(speed, 0, 1), rel=1e-10)
    first, second = conic.halves()
    assert first.length_mm + second.length_mm == pytest.approx(conic.length_mm, rel=1e-10)
