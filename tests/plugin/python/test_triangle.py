# SPDX-License-Identifier: LGPL-2.1-or-later
"""BezierTriangle against Bernstein sums in exact fractions, and as a side of seams."""

import math
from fractions import Fraction

import numpy as np
import pytest

import seamwright
from seamwright import BezierPatch, BezierTriangle
from seeds import seed_of_test

CORNERS = np.eye(3)


def indices(n):
    return [(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]


def exact_point(poles, weights, l0, l1):
    """The rational point as the definition says, in fractions, rounded at the end."""
    n = math.isqrt(2 * len(poles)) - 1
    l = (Fraction(l0), Fraction(l1), 1 - Fraction(l0) - Fraction(l1))
    sums = [Fraction(0)] * 4
    for (i, j, k), pole, weight in zip(indices(n), poles, weights):
        b = math.factorial(n) // (math.factorial(i) * math.factorial(j) * math.factorial(k))
        b *= l[0] ** i * l[1] ** j * l[2] ** k * Fraction(float(weight))
        for axis in range(3):
            sums[axis] += b * Fraction(float(pole[axis]))
        sums[3] += b
    return np.array([float(s / sums[3]) for s in sums[:3]])


def net(random, degree):
    poles = random.normal(size=(len(indices(degree)), 3))
    return poles, random.uniform(0.4, 2.5, len(poles))


@pytest.fixture
def random():
    return np.random.default_rng(seed_of_test())


@pytest.mark.parametrize("degree", range(7))
def test_points_and_properties(random, degree):
    poles, weights = net(random, degree)
    for triangle, w in (
        (BezierTriangle(poles), np.ones(len(poles))),
        (BezierTriangle(poles, weights), weights),
    ):
        assert triangle.degree == degree
        assert triangle.is_rational == (w is weights and degree > 0)
        assert np.allclose(triangle.poles, poles, rtol=0, atol=1e-15) and np.array_equal(
            triangle.weights, w
        )
        for l0, l1 in ((0.25, 0.5), (0, 0.125), (1, 0), (0.375, 0.625)):
            assert np.allclose(
                triangle.point(l0, l1), exact_point(poles, w, l0, l1), rtol=0, atol=1e-14
            )


def test_jet_of_a_polynomial():
    # X = (u, v, u^2 - 3 u v), placed by its blossom
    def blossom(a, b):
        return [
            (a[0] + b[0]) / 2,
            (a[1] + b[1]) / 2,
            a[0] * b[0] - 1.5 * (a[0] * b[1] + a[1] * b[0]),
        ]

    p0, p1, p2 = (1, 0), (0, 1), (0, 0)
    triangle = BezierTriangle(
        [blossom(*pair) for pair in ((p2, p2), (p2, p1), (p1, p1), (p0, p2), (p0, p1), (p0, p0))]
    )
    jet = triangle.jet(0.5, 0.25)
    assert np.allclose(jet.p, [0.5, 0.25, 0.25 - 0.375])
    assert np.allclose([jet.u, jet.v], [[1, 0, 1 - 0.75], [0, 1, -1.5]])
    assert np.allclose([jet.uu, jet.uv, jet.vv], [[0, 0, 2], [0, 0, -3], [0, 0, 0]])
    assert not np.any([jet.uuu, jet.uuv, jet.uvv, jet.vvv])


def test_elevation_parts_and_corners(random):
    poles, weights = net(random, 4)
    triangle = BezierTriangle(poles, weights)
    l = np.array([0.25, 0.625, 0.125])

    def same(part, place):
        return np.allclose(
            part.point(l[0], l[1]),
            exact_point(poles, weights, place[0], place[1]),
            rtol=0,
            atol=1e-13,
        )

    assert triangle.elevated().degree == 5 and same(triangle.elevated(), l)
    corners = np.array([[0.5, 0.25, 0.25], [0, 0.75, 0.25], [0.125, 0.125, 0.75]])
    assert same(triangle.subtriangle(corners), l @ corners)
    middle = np.array([0.25, 0.25, 0.5])
    for k, part in enumerate(triangle.split_at(middle[0], middle[1])):
        around = CORNERS.copy()
        around[k] = middle
        assert same(part, l @ around)
    *outer, inner = triangle.quartered()
    assert same(inner, (1 - l) / 2) and all(
        same(part, (l + CORNERS[k]) / 2) for k, part in enumerate(outer)
    )
    assert same(triangle.permuted([1, 2, 0]), l[[2, 0, 1]])


def test_blossom(random):
    poles, weights = net(random, 3)
    triangle = BezierTriangle(poles, weights)
    l = [0.25, 0.5, 0.25]
    value = triangle.blossom([l, l, l])
    assert np.allclose(value[:3] / value[3], triangle.point(0.25, 0.5), rtol=0, atol=1e-14)
    for row, ijk in enumerate(indices(3)):
        value = triangle.blossom([CORNERS[c] for c in range(3) for _ in range(ijk[c])])
        assert np.allclose(value, [*(weights[row] * poles[row]), weights[row]], rtol=0, atol=1e-15)


def test_edges(random):
    triangle = BezierTriangle(*net(random, 3))
    for k, name in enumerate(("l0", "l1", "l2")):
        curve = triangle.edge_curve(name)
        l = 0.75 * CORNERS[(k + 1) % 3] + 0.25 * CORNERS[(k + 2) % 3]
        assert np.allclose(curve.point(0.25), triangle.point(l[0], l[1]), rtol=0, atol=1e-14)


@pytest.mark.parametrize("rational", (False, True))
def test_patches_and_back(random, rational):
    poles, weights = net(random, 4)
    triangle = BezierTriangle(poles, weights if rational else None)
    u, v = 0.75, 0.25
    for apex in range(3):
        l = np.roll([1 - u, u * (1 - v), u * v], apex)
        assert np.allclose(
            triangle.to_patch(apex).point(u, v), triangle.point(l[0], l[1]), rtol=0, atol=1e-13
        )
    for k, patch in enumerate(triangle.to_patches()):
        a, b, d = (
            CORNERS[k],
            (CORNERS[k] + CORNERS[(k + 1) % 3]) / 2,
            (CORNERS[k] + CORNERS[(k + 2) % 3]) / 2,
        )
        l = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * np.ones(3) / 3 + (1 - u) * v * d
        assert np.allclose(patch.point(u, v), triangle.point(l[0], l[1]), rtol=0, atol=1e-13)
    back = BezierTriangle.from_patch(triangle.elevated().to_patch())
    assert back.degree == 4 and np.allclose(back.poles, poles, rtol=0, atol=1e-12)


def test_what_is_no_triangle():
    square = BezierPatch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]])
    with pytest.raises(ValueError, match="0.5 mm"):
        BezierTriangle.from_patch(square)
    assert BezierTriangle.from_patch(square, tolerance_mm=0.6).degree <= 1


def test_seams_of_triangles_and_patches(random):
    poles, weights = net(random, 3)
    flat = np.array([[i, j, 0] for i, j, _ in indices(3)]) / 3
    triangle = BezierTriangle(flat + 0.05 * poles, weights)
    tight = {"level": "G2", "gap_mm": 1e-10, "angle_deg": 1e-7, "curvature_rel": 1e-6}
    four = triangle.quartered()
    for k in range(3):
        seam = seamwright.enclose_seam(four[3], f"l{k}", four[k], f"l{k}", reversed=True, **tight)
        assert (seam["level"], seam["class"], seam["certified"]) == ("G2", "smooth", True)
    patches = triangle.to_patches()
    for k in range(3):
        seam = seamwright.enclose_seam(patches[k], "u1", patches[(k + 1) % 3], "v1", **tight)
        assert (seam["level"], seam["certified"]) == ("G2", True)
    tip = triangle.subtriangle([[1, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5]])
    rest = triangle.to_patch().split_u(0.5)[1]
    for arguments in ((tip, "l0", rest, "u0"), (rest, "u0", tip, "l0")):
        assert seamwright.enclose_seam(*arguments, **tight)["level"] == "G2"


def test_the_angle_at_a_seam():
    slope = 0.01
    level = BezierTriangle(
        [[0, 1, 0], [0, 0, 0], [-1, 0.5, 0]]
    )  # the edge l0 from (0, 0) to (0, 1)
    y = np.array([0, 0.5, 1])
    bent = BezierPatch(
        [np.stack([0 * y, y, 0 * y], axis=-1), np.stack([0 * y + 1, y, [0, 2 * slope, 0]], axis=-1)]
    )
    seam = seamwright.enclose_seam(level, "l0", bent, "u0")
    angle = math.degrees(math.atan(slope))
    assert (
        seam["angle_deg"]["lower"] <= angle + 1e-13
        and angle <= seam["angle_deg"]["upper"] <= 1.01 * angle
    )
    assert seamwright.enclose_seam(level, "l0", bent, "u0", reversed=True)["gap_mm"][
        "lower"
    ] == pytest.approx(1)


ONE = BezierTriangle(np.zeros((3, 3)))


@pytest.mark.parametrize(
    "call, word",
    [
        (lambda: BezierTriangle(np.zeros((4, 3))), "poles 4"),
        (lambda: BezierTriangle(np.zeros((3, 2))), r"\(3, 2\)"),
        (lambda: BezierTriangle(np.zeros((3, 3)), np.ones(4)), r"\(4\)"),
        (lambda: BezierTriangle(np.zeros((3, 3)), [1, -2, 1]), "weight 1 is -2"),
        (lambda: BezierTriangle([[0, 0, 0], [0, math.nan, 0], [0, 0, 0]]), "pole 1"),
        (lambda: ONE.edge_curve("u0"), "'u0'"),
        (lambda: ONE.permuted([0, 0, 2]), "0, 0, 2"),
        (lambda: ONE.subtriangle(np.eye(3)[:2]), "2 rows"),
        (lambda: ONE.subtriangle(np.full((3, 3), math.nan)), "corner 0"),
        (
            lambda: ONE.subtriangle([[1, 0, 0], [0, 1, 0], [0, 0, 2]]),
            "corners, row 2 has the sum 2",
        ),
        (lambda: ONE.blossom(np.eye(3)[:2]), "arguments 2"),
        (lambda: ONE.blossom([[1, -1, 0]]), "arguments, row 0 has the sum 0"),
        (lambda: ONE.to_patch(3), "apex 3"),
        (lambda: ONE.point(0, math.nan), "l1 is nan"),
        (lambda: ONE.jet(math.inf, 0), "l0 is inf"),
        (lambda: ONE.to_patch().point(math.nan, 0), "u is nan"),
        (lambda: ONE.to_patch().jet(0, -math.inf), "v is -inf"),
        (lambda: ONE.edge_curve("l0").point(math.nan), "t is nan"),
        (lambda: ONE.to_patch().split_u(math.nan), "t is nan"),
        (lambda: ONE.edge_curve("l0").split(math.nan), "t is nan"),
        (lambda: ONE.edge_curve("l0").jet(math.nan), "t is nan"),
        (lambda: ONE.edge_curve("l0").derivatives(math.nan, 2), "t is nan"),
        (lambda: ONE.edge_curve("l0").derivatives(0.5, 10**6), "order 1000000"),
        (lambda: BezierTriangle.from_patch(ONE.to_patch(), tolerance_mm=-1), "-1"),
        (lambda: BezierTriangle.from_patch(ONE.to_patch(), tolerance_mm="wide"), "wide"),
        (lambda: seamwright.enclose_seam(ONE, "u0", ONE, "l0"), "edge_a 'u0'"),
        (lambda: seamwright.enclose_seam(ONE, "l0", ONE.to_patch(), "l0"), "edge_b 'l0'"),
    ],
)
def test_bad_arguments(call, word):
    with pytest.raises(ValueError, match=word):
        call()


def test_what_has_no_edges_is_no_side():
    with pytest.raises(TypeError, match="patch_b is 3"):
        seamwright.enclose_seam(ONE, "l0", 3, "l0")
    with pytest.raises(TypeError):
        hash(ONE)
