# SPDX-License-Identifier: LGPL-2.1-or-later
"""three_sided_fill: surroundings that are known, kinds of sides, keywords and errors; the joins by
seams that are enclosed."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierPatch

CORNERS = np.array([[10.0, 1.0], [-3.0, 8.0], [-9.0, -7.0]])


def height(xy):
    return (2 * xy[..., :1] ** 2 - xy[..., 1:] ** 2 + xy[..., :1] * xy[..., 1:]) / 100


def side(k):
    """Above the line from corner k to the next: a parabola, and the field that lies above the
    direction across it."""
    a, b = CORNERS[k], CORNERS[(k + 1) % 3]
    out = np.array([b[1] - a[1], a[0] - b[0]])
    middle = 2 * height((a + b) / 2) - (height(a) + height(b)) / 2
    slope = [np.array([4 * p[0] + p[1], p[0] - 2 * p[1]]) @ out / 100 for p in (a, b)]
    return (
        BezierCurve([[*a, height(a)[0]], [*(a + b) / 2, middle[0]], [*b, height(b)[0]]]),
        np.array([[*out, slope[0]], [*out, slope[1]]]),
    )


def beyond(curve, cross):
    """The patch behind a side: edge u0 is the side."""
    edge = np.asarray(curve.poles)
    field = np.array([cross[0], (cross[0] + cross[1]) / 2, cross[1]])
    return BezierPatch(np.stack([edge, edge + field]))


def angle(*seam, **keywords):
    return seamwright.enclose_seam(*seam, angle_deg=1e-8, **keywords)["angle_deg"]["upper"]


def test_hole_in_a_quadric():
    sides = [side(k) for k in range(3)]
    fill = seamwright.three_sided_fill(sides)
    triangles = fill["triangles"]
    assert [triangle.degree for triangle in triangles] == [3, 3, 3]
    assert fill["regular"] and fill["fairness_mm2"] < 1e-22
    assert all(corner["exact"] and corner["angle_bound_rad"] == 0 for corner in fill["corners"])
    assert sum(corner["angle_rad"] for corner in fill["corners"]) == pytest.approx(np.pi, abs=0.1)
    assert all(min(join["alpha"]) > 0 for join in fill["sides"])
    for k in range(3):
        assert angle(triangles[k], "l1", triangles[k - 1], "l0", reversed=True) < 1e-8
        assert angle(triangles[k], "l2", beyond(*sides[k]), "u0") < 1e-8
        points = np.array(
            [triangles[k].point(u, v) for u, v in ((0, 0), (0.2, 0.3), (0.7, 0.1), (0, 0.6))]
        )
        assert np.allclose(points[:, 2:], height(points[:, :2]), atol=1e-12)


def test_kinds_of_sides():
    sides = [side(k) for k in range(3)]
    fill = seamwright.three_sided_fill(sides)
    patches = seamwright.three_sided_fill([(beyond(*given), "u0") for given in sides])["triangles"]
    assert patches[0].degree == 4
    for u, v in ((0, 0), (0.2, 0.3)):
        assert np.allclose(patches[1].point(u, v), fill["triangles"][1].point(u, v), atol=1e-12)
    free = seamwright.three_sided_fill([*sides[:2], sides[2][0]])
    assert free["sides"][2] is None and free["sides"][1] is not None
    assert angle(free["triangles"][0], "l1", free["triangles"][2], "l0", reversed=True) < 1e-8


# No tensor-product patch can meet both neighbours of that corner.
def test_twists_need_not_agree():
    sides = [side(k) for k in range(3)]
    sides[0][1][1] *= 1.5
    sides = [
        (curve, np.array([cross[0], (cross[0] + cross[1]) / 2, cross[1]])) for curve, cross in sides
    ]
    sides[0][1][1, 2] += 2
    assert not all(corner["exact"] for corner in seamwright.n_sided_fill(sides)["corners"])
    fill = seamwright.three_sided_fill(sides)
    assert all(corner["exact"] for corner in fill["corners"])
    for k, (curve, cross) in enumerate(sides):
        edge = np.asarray(curve.poles)
        assert (
            angle(fill["triangles"][k], "l2", BezierPatch(np.stack([edge, edge + cross])), "u0")
            < 1e-8
        )


@pytest.mark.parametrize(
    "sides, message",
    [
        (lambda s: s[:2], "2 sides: a fill by triangles has 3"),
        (lambda s: [*s, s[0]], "4 sides: a fill by triangles has 3"),
        (lambda s: [s[0], s[2], s[1]], "side 0 begins .* mm from where side 2 ends"),
        (lambda s: [5, *s[1:]], "side 0 is 5: a BezierCurve, "),
        (lambda s: [*s[:2], (s[2][0], [[1, 2]])], "side 2: cross has shape"),
        (
            lambda s: [s[0], (s[1][0], [[1, 2, float("nan")]]), s[2]],
            "side 1: coefficient 0 of the cross-boundary derivative is nan",
        ),
        (
            lambda s: [s[0], (s[1][0], [[0, 0, 1]]), s[2]],
            "corner 1: the tangent planes of its sides differ by",
        ),
    ],
)
def test_bad_sides(sides, message):
    with pytest.raises(ValueError, match=message):
        seamwright.three_sided_fill(sides([side(k) for k in range(3)]))


@pytest.mark.parametrize(
    "keywords, message",
    [
        ({"fairness_order": 1}, "fairness order 1: known are 2 and 3"),
        ({"fairness_order": 2.5}, "fairness_order is 2.5: a whole number"),
        ({"corner_tolerance_rad": float("nan")}, "corner tolerance nan"),
    ],
)
def test_bad_keywords(keywords, message):
    with pytest.raises(ValueError, match=message):
        seamwright.three_sided_fill([side(k) for k in range(3)], **keywords)
