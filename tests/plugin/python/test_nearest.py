# SPDX-License-Identifier: LGPL-2.1-or-later
"""BSplineSurface and nearest_join: shapes, keywords and errors; the figures by seams that are
enclosed."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierPatch, BSplineSurface


def net(sense, across, along, seed, noise=0.05):
    """Poles near z = x y / 20, the edge i = 0 along x = 0."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(sense * 3 * np.arange(across + 1), np.linspace(0, 10, along), indexing="ij")
    return np.stack([x, y, 0.05 * x * y], axis=-1) + random.normal(0, noise, (across + 1, along, 3))


def pair(degree=3):
    return BezierPatch(net(-1, 3, degree + 1, 1)), BezierPatch(net(1, 3, degree + 1, 2))


def spline(sense, seed, knots=(0.5,)):
    return BSplineSurface(
        net(sense, 3, 4 + len(knots), seed),
        [0] * 4 + [1] * 4,
        [0] * 4 + list(knots) + [1] * 4,
        3,
        3,
    )


def assert_joined(join, order, edge_a="u0", edge_b="u0"):
    assert join["status"] == "joined"
    assert join["residual"] < 1e-13
    assert join["stationarity"] < 1e-10
    seam = seamwright.enclose_seam(
        join["a"],
        edge_a,
        join["b"],
        edge_b,
        level="G3" if order == 3 else "G1",
        angle_deg=1e-8,
        curvature_rel=1e-8,
    )
    assert seam["gap_mm"]["upper"] < 1e-9
    assert seam["angle_deg"]["upper"] < 1e-8
    if order >= 2:
        assert seam["curvature_per_mm"]["upper"] < 1e-8
    if order == 3:
        assert seam["curvature_change_per_mm2"]["upper"] < 1e-7


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("moves", ["both", "a", "b"])
def test_patches_join(order, moves):
    a, b = pair()
    join = seamwright.nearest_join(a, "u0", b, "u0", order=order, moves=moves)
    assert_joined(join, order)
    assert (join["a"] == a) == (moves == "b")
    assert (join["b"] == b) == (moves == "a")
    moved = [np.sum((np.asarray(join[k].poles) - s.poles) ** 2) for k, s in (("a", a), ("b", b))]
    assert sum(moved) == pytest.approx(join["cost"], rel=1e-9)
    again = seamwright.nearest_join(join["a"], "u0", join["b"], "u0", order=order)
    assert again["status"] == "unchanged"
    assert again["a"] == join["a"] and again["largest_move_mm"] == 0


def test_spline_surfaces_join_and_are_enclosed():
    join = seamwright.nearest_join(spline(-1, 3), "u0", spline(1, 4), "u0")
    assert_joined(join, 1)
    with pytest.raises(ValueError, match="known of a patch are u0, u1, v0 and v1"):
        seamwright.enclose_seam(join["a"], "l0", join["b"], "u0")


def test_what_moves_is_dear_or_stays():
    a, b = pair()
    costly, stays = np.full((4, 4), 1e4), np.zeros((4, 4), bool)
    stays[:2, 0] = True
    join = seamwright.nearest_join(a, "u0", b, "u0", weights_a=costly)
    assert_joined(join, 1)
    assert np.abs(join["a"].poles - a.poles).max() < 1e-3
    join = seamwright.nearest_join(a, "u0", b, "u0", fixed_b=stays)
    assert_joined(join, 1)
    assert (join["b"].poles[:2, 0] == b.poles[:2, 0]).all()


def test_degrees_along_the_seam_may_differ():
    a, b = BezierPatch(net(-1, 3, 4, 1)), BezierPatch(net(1, 2, 5, 2))
    join = seamwright.nearest_join(a, "u0", b, "u0")
    assert_joined(join, 1)
    assert (join["a"].degree_v, join["a"].degree_u, join["b"].degree_v) == (4, 3, 4)
    kept = seamwright.nearest_join(a, "u0", b, "u0", moves="b")
    assert kept["a"] == a
    assert_joined(kept, 1)


def test_reversed_edges():
    a, b = pair()
    back = BezierPatch(b.poles[:, ::-1])
    join, same = seamwright.nearest_join(
        a, "u0", back, "u0", reversed=True
    ), seamwright.nearest_join(a, "u0", b, "u0")
    assert np.abs(join["b"].poles[:, ::-1] - same["b"].poles).max() < 1e-11


def test_splines_join():
    a, b = (s.with_raised_knots("v") for s in (spline(-1, 1), spline(1, 2)))
    join = seamwright.nearest_join(a, "u0", b, "u0")
    assert join["status"] == "joined" and join["residual"] < 1e-13
    assert isinstance(join["a"], BSplineSurface) and list(join["a"].knots_v) == list(a.knots_v)
    assert np.abs(join["beta"]).max() > 1e-4
    for t in np.linspace(0, 1, 37):
        p, q = join["a"].jet(0, t), join["b"].jet(0, t)
        assert np.abs(p.p - q.p).max() < 1e-12
        beta = (1 - t) * join["beta"][0] + t * join["beta"][1]
        assert (
            np.abs(q.u + join["alpha"][0] * p.u - beta * p.v).max() < 1e-11
        )  # u runs out of b, so into a


def ranged(sense, seed, degree, inner, first, last):
    """A spline of that degree along v over first..last, with these shares as inner knots."""
    shares = [0] * (degree + 1) + list(inner) + [1] * (degree + 1)
    knots = first + (last - first) * np.array(shares)
    poles = net(sense, 3, len(knots) - degree - 1, seed, 0.02)
    return BSplineSurface(poles, [0] * 4 + [1] * 4, knots, 3, degree)


def across(surface, v, sign):
    """Point, unit normal and curvature tensor on u = 0 by the partials alone."""
    jet = surface.jet(0, v)
    normal = np.cross(jet.u, jet.v)
    square = normal @ normal
    x, y = np.cross(jet.v, normal) / square, np.cross(normal, jet.u) / square
    normal = sign * normal / np.sqrt(square)
    mixed = np.outer(x, y) + np.outer(y, x)
    tensor = normal @ jet.uu * np.outer(x, x) + normal @ jet.uv * mixed
    return jet.p, normal, tensor + normal @ jet.vv * np.outer(y, y)


@pytest.mark.parametrize("moves", ["both", "a", "b"])
@pytest.mark.parametrize("backwards", [False, True])
def test_knots_degrees_and_ranges_may_differ(moves, backwards):
    a = ranged(-1, 1, 3, [0.25, 0.5], -2, 2)
    b = ranged(1, 2, 4, [0.3, 0.5 + 1e-12], 10, 60)
    if backwards:
        b = BSplineSurface(
            b.poles[:, ::-1], b.knots_u, 70 - np.array(b.knots_v)[::-1], b.degree_u, b.degree_v
        )
    join = seamwright.nearest_join(a, "u0", b, "u0", 2, moves, backwards)
    assert join.status == "joined" and join.parameter is None
    for t in np.linspace(0, 1, 41):
        p = across(join.a, -2 + 4 * t, 1)
        q = across(join.b, 10 + 50 * (1 - t if backwards else t), 1 if backwards else -1)
        assert np.abs(p[0] - q[0]).max() < 1e-10
        assert np.abs(p[1] - q[1]).max() < 1e-9
        assert np.abs(p[2] - q[2]).max() < 1e-8
    assert (join.a == a) == (moves == "b") and (join.b == b) == (moves == "a")
    assert join.raised_degree_a == (moves != "b") and join.raised_degree_b == 0
    assert join.added_knots_a == (pytest.approx([-0.8]) if moves != "b" else [])
    if moves != "a":
        added = join.added_knots_b
        assert {round(abs(k - 60 * backwards - 10 * (not backwards)) / 50, 9) for k in added} == {
            0.25,
            0.5,
        }
    assert max(join.moved_knots_a, join.moved_knots_b) < 2e-12
    again = seamwright.nearest_join(join.a, "u0", join.b, "u0", 2, reversed=backwards)
    assert again.status == "unchanged" and again.added_knots_a == again.added_knots_b == []


def test_a_patch_that_gets_knots_is_a_spline():
    a, b = pair()[0], ranged(1, 2, 3, [0.4], 0, 3)
    join = seamwright.nearest_join(a, "u0", b, "u0")
    assert isinstance(join.a, BSplineSurface) and join.a.knots_v[4] == pytest.approx(0.4)
    assert_joined(join, 1)
    kept = seamwright.nearest_join(a, "u0", b, "u0", moves="b")
    assert kept.a is a


def test_weights_and_fixed_poles_are_those_given():
    a, b = ranged(-1, 1, 3, [0.25], 0, 1), ranged(1, 2, 3, [0.6], 0, 1)
    stays = np.zeros(a.weights.shape, bool)
    stays[:2, :2] = True
    join = seamwright.nearest_join(a, "u0", b, "u0", fixed_a=stays)
    assert_joined(join, 1)
    before = a.with_knot("v", join.added_knots_a[0])
    assert (join.a.poles[:2, :2] == before.poles[:2, :2]).all()
    assert (join.a.poles[:2, 0] == a.poles[:2, 0]).all()
    costly = seamwright.nearest_join(a, "u0", b, "u0", weights_a=np.full(a.weights.shape, 1e6))
    assert np.abs(costly.a.poles - before.poles).max() < 1e-5


def test_a_side_at_another_speed():
    a, b = pair()
    plain = seamwright.nearest_join(a, "u0", b, "u0")
    faster = BezierPatch(b.poles, np.tile(1.5 ** np.arange(4), (4, 1)))
    join = seamwright.nearest_join(a, "u0", faster, "u0")
    assert join.parameter["of"] == "b"
    assert join.parameter["numerator"] == pytest.approx([0, 1 / 1.5])
    assert join.parameter["denominator"] == pytest.approx([1, 1 / 1.5])
    assert np.abs(join.a.poles - plain.a.poles).max() < 1e-10
    assert np.abs(join.b.poles - plain.b.poles).max() < 1e-10
    assert join.b.weights == pytest.approx(faster.weights, rel=1e-12)
    assert seamwright.join_condition(join.a, "u0", join.b, "u0").verdict == "G1"


def test_surface():
    s = spline(1, 3)
    assert (
        s.poles.shape == (4, 5, 3) and (s.weights == 1).all() and (s.degree_u, s.degree_v) == (3, 3)
    )
    finer = s.with_knot("u", 0.25).with_knot("v", 0.5)
    assert finer.poles.shape == (5, 6, 3)
    assert np.abs(finer.point(0.3, 0.7) - s.point(0.3, 0.7)).max() < 1e-13
    assert np.abs(finer.jet(0.3, 0.7).vvv - s.jet(0.3, 0.7).vvv).max() < 1e-9
    higher = s.elevated("v")
    assert (higher.degree_v, list(higher.knots_v)) == (4, [0] * 5 + [0.5] * 2 + [1] * 5)
    assert np.abs(higher.point(0.3, 0.7) - s.point(0.3, 0.7)).max() < 1e-13
    patch = BezierPatch(net(1, 2, 4, 4), np.linspace(1, 2, 12).reshape(3, 4))
    assert (
        np.abs(BSplineSurface.from_patch(patch).point(0.2, 0.9) - patch.point(0.2, 0.9)).max()
        < 1e-13
    )
    assert s == spline(1, 3) and s != finer


def test_what_cannot_join_is_said():
    a, b = pair()
    everything = np.ones((4, 4), bool)
    join = seamwright.nearest_join(a, "u0", b, "u0", fixed_a=everything, fixed_b=everything)
    assert join["status"] == "infeasible" and join["a"] == a and join["b"] == b
    assert join["residual"] > 1e-4


@pytest.mark.parametrize(
    "change, text",
    [
        ({"edge_a": "w0"}, "edge_a 'w0': known of a patch are u0, u1, v0 and v1"),
        ({"order": 4}, "order is 4"),
        ({"moves": "c"}, "moves is 'c'"),
        ({"weights_a": np.ones((3, 4))}, r"weights_a have shape \(3, 4\)"),
        ({"fixed_b": np.ones(16, bool)}, r"fixed_b have shape \(16\)"),
        ({"weights_b": -np.ones((4, 4))}, "weight 0 of a move of surface b is -1"),
        ({"degree_beta": 9}, "degree of beta is 9"),
        (
            {"b": BezierPatch(net(1, 3, 5, 2)), "fixed_a": np.eye(4, k=1, dtype=bool)},
            "pole 1 along the seam, 0 across it, of surface a cannot stay",
        ),
    ],
)
def test_bad_arguments(change, text):
    a, b = pair()
    arguments = {"a": a, "edge_a": "u0", "b": b, "edge_b": "u0"} | change
    with pytest.raises(ValueError, match=text):
        seamwright.nearest_join(**arguments)


@pytest.mark.parametrize("scale", [1e-300, 1e-200, 1e-105, 1e105, 1e200])
def test_sizes_whose_squares_are_no_numbers(scale):
    a, b = (BezierPatch(scale * patch.poles) for patch in pair())
    with pytest.raises(ValueError, match="1e-100 to 1e100 mm are possible"):
        seamwright.nearest_join(a, "u0", b, "u0")


@pytest.mark.parametrize("scale", [1e-95, 1e95])
def test_joins_of_other_sizes_are_alike(scale):
    given = pair()
    usual = seamwright.nearest_join(given[0], "u0", given[1], "u0")
    a, b = (BezierPatch(scale * patch.poles) for patch in given)
    found = seamwright.nearest_join(a, "u0", b, "u0")
    assert found["status"] == usual["status"] == "joined"
    assert found["largest_move_mm"] == pytest.approx(scale * usual["largest_move_mm"], rel=1e-9)


def test_bad_surfaces():
    poles = net(1, 3, 4, 1)
    knots = [0] * 4 + [1] * 4
    with pytest.raises(ValueError, match="knot 3 of knots_u"):
        BSplineSurface(poles, [0] * 3 + [0.5] + [1] * 4, knots, 3, 3)
    with pytest.raises(ValueError, match="poles 12"):
        BSplineSurface(poles[:3], knots, knots, 3, 3)
    with pytest.raises(ValueError, match=r"poles have shape \(4, 12\)"):
        BSplineSurface(poles.reshape(4, 12), knots, knots, 3, 3)
    with pytest.raises(ValueError, match="weight 2 is 0"):
        BSplineSurface(poles, knots, knots, 3, 3, np.where(np.arange(16).reshape(4, 4) == 2, 0, 1))
    with pytest.raises(ValueError, match="direction is 'w'"):
        BSplineSurface(poles, knots, knots, 3, 3).with_knot("w", 0.5)
