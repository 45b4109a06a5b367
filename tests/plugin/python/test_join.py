# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joins built, judged and recognised, against closed forms and the enclosure of seams."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierPatch, BezierTriangle
from seeds import seed_of_test

RANDOM = None


@pytest.fixture(autouse=True)
def random_numbers():
    global RANDOM
    RANDOM = np.random.default_rng(seed_of_test())


def patch(m, n, weights=None):
    i, j = np.meshgrid(np.arange(m + 1.0), np.arange(n + 1.0), indexing="ij")
    net = np.stack([3 * i, 4 * j, 0 * i], axis=-1) + RANDOM.uniform(-0.5, 0.5, (m + 1, n + 1, 3))
    return BezierPatch(net, weights)


def triangle(n):
    poles = [(3.0 * i, 3.0 * j, 0) for i in range(n + 1) for j in range(n - i + 1)]
    return BezierTriangle(np.array(poles) + RANDOM.uniform(-0.5, 0.5, (len(poles), 3)))


def test_rows_are_those_of_the_formula():
    given = patch(3, 3)
    poles, weights = seamwright.join_rows(given, "u1", alpha=1.25, beta=-0.375, degree_across=2)
    a = given.poles[3] - given.poles[2]
    e = np.diff(given.poles[3], axis=0)
    k = np.arange(4)[:, None]
    along = (k / 3) * np.vstack([np.zeros((1, 3)), e]) + (1 - k / 3) * np.vstack(
        [e, np.zeros((1, 3))]
    )
    assert poles.shape == (2, 4, 3) and (weights == 1).all()
    assert poles[0] == pytest.approx(given.poles[3])
    assert poles[1] - poles[0] == pytest.approx(3 / 2 * 1.25 * a + 3 / 2 * -0.375 * along)


def test_continuation_joins_and_is_certified():
    given = patch(3, 2)
    for edge in ("u0", "u1", "v0", "v1"):
        for backwards in (False, True):
            beyond = seamwright.continuation(
                given,
                edge,
                alpha=[1, 1.5],
                beta=[0.25, -0.25],
                p=0.5,
                order=2,
                degree_across=4,
                reversed=backwards,
            )
            assert beyond.degree_u == 4
            # continuation runs along the edge backwards, the others run the second surface's edge:
            # the same pairs of points
            found = seamwright.join_condition(given, edge, beyond, "u0", reversed=backwards)
            assert found["verdict"] == "G1" and found["g2"] and found["parametric_order"] == 0
            assert found["angle_bound_rad"] < 1e-9 and found["gap_bound_mm"] < 1e-12
            seam = seamwright.enclose_seam(
                given, edge, beyond, "u0", reversed=backwards, level="G2"
            )
            assert seam["level"] == "G2" and seam["certified"]


def test_parametric_continuation():
    given = patch(3, 3)
    found = seamwright.join_condition(
        given, "v1", seamwright.continuation(given, "v1", order=2), "u0"
    )
    assert found["parametric_order"] == 2 and found["first"]["holds"] and found["second"]["holds"]


def test_triangles():
    given = triangle(3)
    beyond = seamwright.triangle_continuation(given, "l1", alpha=0.75, beta=0.25)
    assert beyond.degree == 3
    assert seamwright.join_condition(given, "l1", beyond, "l0")["verdict"] == "G1"
    raised = seamwright.triangle_continuation(patch(2, 3), "u1")
    assert raised.degree == 4
    with pytest.raises(ValueError, match="the defect is"):
        seamwright.triangle_continuation(patch(2, 3), "u1", degree=3)
    across = seamwright.continuation(given, "l2", beta=[0.5, -0.5], degree_across=3)
    assert seamwright.join_condition(given, "l2", across, "u0")["verdict"] == "G1"


def test_order_3():
    given = patch(3, 3)
    made = {"alpha": 0.4, "beta": [0.25, -0.5], "p": 0.1, "q": [0.5, 0.25], "h": -0.1, "k": 0.25}
    beyond = seamwright.continuation(given, "u1", order=3, **made)
    found = seamwright.join_condition(given, "u1", beyond, "u0")
    assert found["g2"] and found["g3"] and found["curvature_change"]["holds"]
    seam = seamwright.enclose_seam(given, "u1", beyond, "u0", level="G3")
    assert seam["level"] == "G3" and seam["certified"]
    fit = seamwright.fit_connection(given, "u1", beyond, "u0", order=3)
    assert fit["found"]
    for name, value in made.items():
        assert fit["connection"][name][[0, -1]] == pytest.approx(
            np.atleast_1d(value)[[0, -1]], abs=1e-7
        )
    second = seamwright.continuation(given, "u1", order=2)
    assert not seamwright.join_condition(given, "u1", second, "u0")["g3"]
    further = BezierPatch(patch(3, 3).poles + np.array([30.0, 0, 0]))
    between = seamwright.blend(given, "u1", further, "u0", 3)
    assert between.degree_u == 7
    assert seamwright.join_condition(given, "u1", between, "u0")["g3"]


def test_triangles_of_higher_order():
    given = triangle(4)
    for order in (2, 3):
        beyond = seamwright.triangle_continuation(given, "l1", alpha=0.75, beta=0.25, order=order)
        assert beyond.degree == 4
        found = seamwright.join_condition(given, "l1", beyond, "l0")
        assert found["g2"] and found["g3"] == (order == 3)
    assert seamwright.triangle_continuation(patch(2, 3), "u1", order=2).degree == 5
    joined = seamwright.joined(triangle(5), "l2", given, "l0", order=2)
    assert seamwright.join_condition(given, "l0", joined, "l2")["g2"]


def test_joined_keeps_the_other_poles():
    given, other = patch(3, 3), patch(4, 3)
    joined = seamwright.joined(other, "u0", given, "u1", alpha=0.9, order=2)
    assert (joined.poles[3:] == other.poles[3:]).all()
    assert seamwright.join_condition(given, "u1", joined, "u0")["g2"]
    turned = seamwright.joined(other, "v1", given, "u1", reversed=True)
    assert seamwright.join_condition(given, "u1", turned, "v1", reversed=True)["verdict"] == "G1"
    first, second = triangle(3), triangle(3)
    bent = seamwright.joined(second, "l2", first, "l0")
    assert seamwright.join_condition(first, "l0", bent, "l2")["verdict"] == "G1"


def test_blend_joins_both():
    a, b = patch(3, 2), patch(2, 3)
    b = BezierPatch(b.poles + [30, 0, 5])
    for order in (1, 2):
        between = seamwright.blend(
            a, "u1", b, "u0", order, to_a={"alpha": 2.0}, to_b={"alpha": [2, 1], "beta": 0.1}
        )
        assert (between.degree_u, between.degree_v) == (2 * order + 1, 4 if order == 1 else 5)
        for surface, edge, own in ((a, "u1", "u0"), (b, "u0", "u1")):
            found = seamwright.join_condition(surface, edge, between, own)
            assert found["verdict"] == "G1" and (order == 1 or found["g2"])


def test_conditions_that_fail():
    given = patch(3, 3)
    beyond = seamwright.continuation(given, "u1", order=2, degree_across=3)
    poles = beyond.poles
    poles[1, 1, 2] += 1e-5
    moved = seamwright.join_condition(given, "u1", BezierPatch(poles), "u0")
    assert moved["verdict"] == "not G1" and not moved["g2"] and moved["curvature"] is None
    assert moved["tangent_plane"]["relative"] > 1e3 * moved["tangent_plane"]["noise"]
    assert (
        seamwright.join_condition(given, "u1", BezierPatch(poles), "u0", tolerance=1e-3)["verdict"]
        == "G1"
    )
    back = beyond.poles
    back[1:] = 2 * back[0] - back[1:]
    assert seamwright.join_condition(given, "u1", BezierPatch(back), "u0")["verdict"] == "fold"
    flat = BezierPatch([given.poles[3], given.poles[3]])
    collapsed = seamwright.join_condition(given, "u1", flat, "u0")
    assert (
        collapsed["verdict"] == "singular"
        and collapsed["singular_at"] == 0
        and collapsed["tangent_plane"] is None
    )


def test_functions_come_back():
    given = patch(3, 3, weights=RANDOM.uniform(0.9, 1.1, (4, 4)))
    made = {
        "alpha": 0.8,
        "beta": [0.25, -0.5],
        "p": 0.5,
        "q": [0.5, 0.25],
        "e0": [1, 1.125],
        "e1": 0.0625,
    }
    beyond = seamwright.continuation(given, "u1", order=2, degree_across=5, e2=0, **made)
    fit = seamwright.fit_connection(given, "u1", beyond, "u0", order=2)
    assert fit["found"] and fit["note"] == ""
    for name in ("alpha", "beta", "p", "q", "e0"):
        assert fit["connection"][name] == pytest.approx(np.atleast_1d(made[name]), abs=1e-9)
    assert seamwright.join_condition(given, "u1", beyond, "u0", connection=fit["connection"])["g2"]
    other = seamwright.fit_connection(given, "u1", patch(3, 3), "u0")
    assert not other["found"] and "the edges do not coincide" in other["note"]


def test_orient():
    given = patch(3, 2)
    beyond = seamwright.continuation(given, "v0", reversed=True)
    a, b, backwards = seamwright.orient(given, "v0", beyond, "u0")
    assert backwards and a.poles[-1] == pytest.approx(b.poles[0])


def test_alpha_surfaces():
    net = patch(3, 3).poles
    surface = seamwright.alpha_surface(net, 0.5, 0.75)
    assert surface.point(0, 0) == pytest.approx(net[0, 0]) and (
        surface.degree_u,
        surface.degree_v,
    ) == (5, 5)
    assert surface.jet(0, 0).u == pytest.approx(5 * 0.5 * (net[1, 0] - net[0, 0]))
    rows = seamwright.alpha_join_rows(net, 0.5, 0.75, next_a_u=0.9, order=2, beta1=1.2, beta2=-0.5)
    following = seamwright.alpha_surface(
        np.concatenate([rows, patch(1, 3).poles[:1] + [18, 0, 0]]), 0.9, 0.75
    )
    assert seamwright.join_condition(surface, "u1", following, "u0")["g2"]
    with pytest.raises(ValueError, match="row 0 misses it by"):
        seamwright.alpha_join_rows(net, 0.5, 0.75, next_a_v=0.5)


@pytest.mark.parametrize(
    "arguments, word",
    [
        ({"alpha": -1}, "alpha is -1"),
        ({"alpha": "wide"}, "wide"),
        ({"alpha": [1, float("nan")]}, "coefficient 1 = nan"),
        ({"alpha": []}, "alpha has no coefficient"),
        ({"order": 4}, "order 4"),
        ({"order": 1.5}, "1.5"),
        ({"beta": True}, "beta is True"),
        ({"degree_across": 0}, "order 1"),
        ({"degree": 1}, "degree 1"),
        ({"reversed": 1}, "reversed is 1"),
        ({"e0": 0}, "e0 is 0"),
    ],
)
def test_bad_arguments(arguments, word):
    with pytest.raises(ValueError, match=word):
        seamwright.continuation(patch(2, 3), "u1", **arguments)


@pytest.mark.parametrize("alpha", [[], float("nan"), float("inf"), -float("inf"), 0, -1, [1, -0.5]])
def test_bad_functions_of_a_given_connection(alpha):
    given = patch(2, 3)
    beyond = seamwright.continuation(given, "u1", order=2)
    with pytest.raises(ValueError, match="alpha "):
        seamwright.join_condition(given, "u1", beyond, "u0", connection={"alpha": alpha})


def test_bad_tolerances_and_dicts():
    given = patch(2, 3)
    beyond = seamwright.continuation(given, "u1")
    for judge in (seamwright.join_condition, seamwright.fit_connection):
        for tolerance in (-1, float("nan"), float("inf")):
            with pytest.raises(ValueError, match="tolerance is"):
                judge(given, "u1", beyond, "u0", tolerance=tolerance)
    with pytest.raises(ValueError, match="connection is 3: a dict"):
        seamwright.join_condition(given, "u1", beyond, "u0", connection=3)
    with pytest.raises(ValueError, match="to_b is 0.5: a dict"):
        seamwright.blend(given, "u1", beyond, "u1", to_b=0.5)


def test_a_fold_is_no_connection():
    given = patch(2, 3)
    beyond = seamwright.continuation(given, "u1", alpha=[1, 1.5])
    fit = seamwright.fit_connection(
        given, "u1", BezierPatch(2 * beyond.poles[0] - beyond.poles), "u0"
    )
    assert not fit["found"] and "the join is fold" in fit["note"]
    assert fit["connection"]["alpha"] == pytest.approx([-1, -1.5])


def test_bad_surfaces_and_names():
    with pytest.raises(ValueError, match="u9"):
        seamwright.continuation(patch(2, 3), "u9")
    with pytest.raises(ValueError, match="of a triangle"):
        seamwright.continuation(triangle(2), "u1")
    with pytest.raises(ValueError, match="a BezierPatch or a BezierTriangle is needed"):
        seamwright.continuation(3, "u1")
    with pytest.raises(TypeError, match="gamma"):
        seamwright.continuation(patch(2, 3), "u1", gamma=1)
    with pytest.raises(ValueError, match="4, 4, 3"):
        seamwright.alpha_surface(np.zeros((3, 4, 3)))
    with pytest.raises(ValueError, match="a_u is 2"):
        seamwright.alpha_surface(np.zeros((4, 4, 3)), 2, 1)
