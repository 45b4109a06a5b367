# SPDX-License-Identifier: LGPL-2.1-or-later
"""n_sided_fill: kinds of sides, keywords and errors; the joins by seams that are enclosed."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierPatch


def corners_of(n, radius=10.0):
    angles = 2 * np.pi * np.arange(n) / n
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def biquadratic(corners):
    """The patch of z = (2 x^2 - y^2) / 100 above a quadrilateral, corners (u, v) = 00, 01, 10, 11;
    by values at 3 by 3 places."""
    t = np.array([0, 0.5, 1])
    inverse = np.linalg.inv(np.stack([(1 - t) ** 2, 2 * t * (1 - t), t**2], axis=-1))
    u, v = np.meshgrid(t, t, indexing="ij")
    xy = np.stack([(1 - u) * (1 - v), (1 - u) * v, u * (1 - v), u * v], axis=-1) @ np.array(corners)
    values = np.concatenate([xy, (2 * xy[..., :1] ** 2 - xy[..., 1:] ** 2) / 100], axis=-1)
    return BezierPatch(np.einsum("ai,bj,ijc->abc", inverse, inverse, values))


def surroundings(n):
    inner, outer = corners_of(n), corners_of(n, 15)
    return [
        biquadratic([inner[k], inner[(k + 1) % n], outer[k], outer[(k + 1) % n]]) for k in range(n)
    ]


def random_sides(n, random):
    """Cubic edges with fields that are horizontal at the corners, so that planes agree."""
    corners = np.column_stack([corners_of(n), random.uniform(-1, 1, n)])
    sides = []
    for k in range(n):
        a, b = corners[k], corners[(k + 1) % n]
        chord = np.array([b[0] - a[0], b[1] - a[1], 0])
        edge = np.array([a, a + chord / 3, b - chord / 3, b])
        out = np.cross(chord, [0, 0, 0.3])
        cross = np.array([out, out, out]) + np.outer([0, 1, 0], random.uniform(-0.5, 0.5, 3))
        sides.append((BezierCurve(edge), cross))
    return sides


def angle(a, edge_a, b, edge_b):
    return seamwright.enclose_seam(a, edge_a, b, edge_b, angle_deg=1e-8)["angle_deg"]["upper"]


@pytest.mark.parametrize(("law", "is_g2"), [("linear", False), ("g2", True)])
def test_curvature_across_spokes(law, is_g2):
    """Random sides, so that no surface of low degree fills the hole."""
    random = np.random.default_rng(8)
    fill = seamwright.n_sided_fill(random_sides(5, random), law=law)
    patches = fill["patches"]
    for k in range(5):
        seam = seamwright.enclose_seam(
            patches[k], "u0", patches[(k + 1) % 5], "v0", angle_deg=1e-8, curvature_rel=1e-8
        )
        assert (seam["curvature_rel"]["upper"] < 1e-6) == is_g2


@pytest.mark.parametrize("law", ["linear", "quadratic", "g2"])
@pytest.mark.parametrize("n", [3, 5, 6, 12])
def test_hole_in_a_quadric(n, law):
    fill = seamwright.n_sided_fill([(patch, "u0") for patch in surroundings(n)], law=law)
    patches = fill["patches"]
    degree = {"linear": 4, "quadratic": 5, "g2": 6}[law]
    assert [patch.poles.shape for patch in patches] == [(degree + 1, degree + 1, 3)] * n
    assert fill["regular"] and fill["spoke_scale"] is None
    assert all(corner["exact"] and corner["angle_bound_rad"] == 0 for corner in fill["corners"])
    assert fill["corners"][0]["angle_rad"] == pytest.approx(np.pi * (1 - 2 / n), abs=0.15)
    assert fill["spoke"]["beta"][0] == pytest.approx(2 * np.cos(2 * np.pi / n))
    assert all(len(side) == 2 and min(side[0]["alpha"]) > 0 for side in fill["sides"])
    for k in range(n):
        assert angle(patches[k], "u0", patches[(k + 1) % n], "v0") < 1e-8
    if law != "quadratic":
        points = np.array(
            [patch.point(u, v) for patch in patches for u in (0, 0.3, 0.8) for v in (0, 0.6, 1)]
        )
        assert np.allclose(
            points[:, 2], (2 * points[:, 0] ** 2 - points[:, 1] ** 2) / 100, atol=1e-12
        )


def test_kinds_of_sides():
    around = surroundings(4)
    given = [(patch, "u0") for patch in around]
    fill = seamwright.n_sided_fill(given)
    turned = [(BezierPatch(patch.poles[:, ::-1]), "u0", True) for patch in around]
    assert np.array_equal(
        seamwright.n_sided_fill(turned)["patches"][2].poles, fill["patches"][2].poles
    )
    fields = [
        (BezierCurve(patch.poles[0]), 2 * (patch.poles[1] - patch.poles[0])) for patch in around
    ]
    assert np.allclose(
        seamwright.n_sided_fill(fields)["patches"][2].poles, fill["patches"][2].poles, atol=1e-13
    )
    free = seamwright.n_sided_fill([*given[:3], BezierCurve(around[3].poles[0])])
    assert free["sides"][3] is None and free["sides"][2] is not None
    for k in range(4):
        assert angle(free["patches"][k], "u0", free["patches"][(k + 1) % 4], "v0") < 1e-8


def test_incompatible_corner_is_bounded():
    around = surroundings(4)
    sides = [
        (BezierCurve(patch.poles[0]), 2 * (patch.poles[1] - patch.poles[0])) for patch in around
    ]
    sides[0][1][1, 2] += 0.5
    corners = seamwright.n_sided_fill(sides)["corners"]
    assert [corner["exact"] for corner in corners] == [False, False, True, True]
    assert abs(corners[0]["twist_defect_mm"]) > 0.01 and 0 < corners[0]["angle_bound_rad"] < 0.1


@pytest.mark.parametrize(
    "sides, message",
    [
        (lambda s: s[:2], "2 sides: a fill has 3 to 12"),
        (lambda s: [s[0], s[2], s[1], s[3]], "side 1 begins .* mm from where side 0 ends"),
        (lambda s: [s[0][0], *s[1:]], "side 0 is .*: a BezierCurve, "),
        (lambda s: [(s[0][0], "w0"), *s[1:]], "side 0: edge 'w0': known of a patch are u0"),
        (lambda s: [(s[0][0], "u0", 1), *s[1:]], "side 0: reversed is 1: True or False"),
        (lambda s: [*s[:3], (BezierCurve(s[3][0].poles[0]), [[1, 2]])], "side 3: cross has shape"),
    ],
)
def test_bad_sides(sides, message):
    with pytest.raises(ValueError, match=message):
        seamwright.n_sided_fill(sides([(patch, "u0") for patch in surroundings(4)]))


@pytest.mark.parametrize(
    "keywords, message",
    [
        ({"law": "cubic"}, "law is 'cubic': linear, quadratic or g2"),
        ({"law": 4}, "law is 4: a name is needed"),
        ({"fairness_order": 1}, "fairness order 1: known are 2 and 3"),
        ({"fairness_order": 2.5}, "fairness_order is 2.5: a whole number"),
        ({"corner_tolerance_rad": float("nan")}, "corner tolerance nan"),
    ],
)
def test_bad_keywords(keywords, message):
    with pytest.raises(ValueError, match=message):
        seamwright.n_sided_fill([(patch, "u0") for patch in surroundings(4)], **keywords)


def quarter(k):
    """A quarter of a circle of radius 10 in the plane z = 0, nearly, run counter-clockwise; the
    cross-boundary derivative is its outward normal."""
    h = 0.5522847498307936
    poles = 10 * np.array([[1, 0], [1, h], [h, 1], [0, 1]])
    for _ in range(k):
        poles = np.stack([-poles[:, 1], poles[:, 0]], axis=-1)
    along = 3 * np.diff(poles, axis=0)
    flat = np.zeros((len(poles), 1))
    return (
        BezierCurve(np.hstack([poles, flat])),
        np.hstack([along[:, 1:], -along[:, :1], flat[:3]]),
        np.zeros((1, 3)),
    )


@pytest.mark.parametrize("degrees", [None, 0, 2])
def test_round_hole(degrees):
    fill = seamwright.ring_fill([quarter(k) for k in range(4)], curvature_degrees=degrees)
    patches = fill["patches"]
    assert len(patches) == 5 and fill["regular"] and len(fill["corners"]) == 4
    assert all(
        corner["exact"] and corner["angle_rad"] == pytest.approx(np.pi)
        for corner in fill["corners"]
    )
    assert max(abs(patch.poles[..., 2]).max() for patch in patches) < 1e-12
    assert (fill["curvature_jump_per_mm"] is None) == (degrees is None)
    for k in range(4):
        assert angle(patches[k - 1], "v1", patches[k], "v0") < 1e-9
        assert np.allclose(patches[k].point(1, 0.3), quarter(k)[0].point(0.3), atol=1e-12)


def inward(patch, place, t, step=1e-3):
    """First and second derivative of a patch across an edge, by differences of points. ``place``
    gives (u, v) for a parameter across the edge and one along it."""
    p = [np.asarray(patch.point(*place(k * step, t))) for k in range(5)]
    first = (-25 * p[0] + 48 * p[1] - 36 * p[2] + 16 * p[3] - 3 * p[4]) / (12 * step)
    return first, (35 * p[0] - 104 * p[1] + 114 * p[2] - 56 * p[3] + 11 * p[4]) / (12 * step**2)


def curvature_across(patch, place, t, step=1e-3):
    """The unit normal and the normal curvature across an edge, by differences of points."""
    before, u, after = (inward(patch, place, t + k * step)[0] for k in (-1, 0, 1))
    p = [np.asarray(patch.point(*place(0, t + k * step))) for k in (-1, 0, 1)]
    v, vv = (p[2] - p[0]) / (2 * step), (p[2] - 2 * p[1] + p[0]) / step**2
    share = (u @ v) / (v @ v)
    bend = inward(patch, place, t)[1] - 2 * share * (after - before) / (2 * step) + share**2 * vv
    across = u - share * v
    normal = np.cross(v, across) / np.linalg.norm(np.cross(v, across))
    return normal, (bend @ normal) / (across @ across)


@pytest.mark.parametrize("law", ["linear", "g2"])
def test_ring_by_differences(law):
    """Curvature across a spoke and an edge of the middle patch, from points alone."""
    oval, down = np.diag([1, 0.7, 1]), [0, 0, -6]
    sides = [
        (BezierCurve(curve.poles @ oval), (field + down) @ oval)
        for curve, field, _ in map(quarter, range(4))
    ]
    fill = seamwright.ring_fill(sides, law=law)
    assert fill["regular"] and (fill["spoke_jump_per_mm"] is None) == (law == "linear")
    first, second, middle = (fill["patches"][k] for k in (0, 1, 4))
    jumps = []
    for t in (0.2, 0.5, 0.7):
        for one, other in (
            ((first, lambda s, t: (s, t)), (middle, lambda s, t: (t, s))),
            ((second, lambda s, t: (t, s)), (first, lambda s, t: (t, 1 - s))),
        ):
            (n, k), (m, j) = curvature_across(*one, t), curvature_across(*other, t)
            assert np.allclose(n, -m, atol=1e-6)
            jumps.append(abs(k + j))
    assert max(jumps) < 1e-4 if law == "g2" else max(jumps) > 1e-3


def test_curvature_degrees():
    sides = [(patch, "u0") for patch in surroundings(5)]
    fill = seamwright.n_sided_fill(sides, curvature_degrees=1)
    assert fill["patches"][0].degree_u == 1 + seamwright.n_sided_fill(sides)["patches"][0].degree_u
    assert fill["curvature_jump_per_mm"] < 1e-9
    for bad in (-1, 7):
        with pytest.raises(ValueError, match=f"curvature degrees {bad}"):
            seamwright.n_sided_fill(sides, curvature_degrees=bad)
    with pytest.raises(ValueError, match="3 sides"):
        seamwright.ring_fill(sides[:3])
    with pytest.raises(ValueError, match="no quadratic law"):
        seamwright.ring_fill(sides[:4], law="quadratic")
