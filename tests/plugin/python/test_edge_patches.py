# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches beside boundaries of splines, as the functions of joins take them."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierPatch
from seeds import seed_of_test


@pytest.fixture
def model():
    """Two curved patches that face each other."""
    u, v = np.meshgrid(np.linspace(0, 30, 4), np.linspace(0, 40, 4), indexing="ij")
    low = np.stack([u, v, 0.01 * u**2 + 0.003 * (v - 10) ** 2], axis=-1)
    high = np.stack([60 + u, v, 25 - 0.01 * (u - 30) ** 2 + 0.002 * v**2], axis=-1)
    return seamwright.Model.from_patches([BezierPatch(low), BezierPatch(high)])


def edge_at(model, x):
    return next(
        edge
        for edge in range(1, model.edge_count + 1)
        if np.allclose(np.asarray(model.curve(edge).poles)[:, 0], x)
    )


def test_sides_of_a_model_are_blended_span_by_span(model):
    first = model.side_ribbon(edge_at(model, 30), 5.0)
    second = model.side_ribbon(edge_at(model, 60), 5.0)
    assert first.reached and second.reached and first.faces == [1] and second.faces == [2]
    a, b = first.surface, second.surface.with_knot("u", 0.3).with_knot("u", 0.7)
    along_a, along_b = (s.point(1.0, 1.0) - s.point(0.0, 1.0) for s in (a, b))
    turned = bool(np.dot(along_a, along_b) < 0)
    pairs = seamwright.edge_pairs(a, first.edge, b, second.edge, reversed=turned)
    assert len(pairs) >= 3
    blends = [seamwright.blend(p, "v1", q, "v1", order=2, reversed=turned) for p, q in pairs]
    for (p, q), blend in zip(pairs, blends):
        to_p = seamwright.enclose_seam(p, "v1", blend, "u0", level="G2")
        to_q = seamwright.enclose_seam(q, "v1", blend, "u1", reversed=turned, level="G2")
        assert (to_p.level, to_q.level) == ("G2", "G2") and to_p.certified and to_q.certified
    for before, after in zip(blends, blends[1:]):
        seam = seamwright.enclose_seam(before, "v1", after, "v0", level="G2")
        assert seam.level == "G2" and seam.gap_mm.upper < 1e-9
    # They are as good beside the faces themselves.
    joined = seamwright.Model.from_patches([model.surface(1), model.surface(2), *blends])
    report = joined.analyze(match_mm=0.01, level="G2")
    beside = [s for s in report.seams if any(face <= 2 for face in s.faces)]
    assert len(beside) >= 2 and all(s.level == "G2" and s.certified for s in beside)


def test_patches_are_parts_of_the_surface():
    random = np.random.default_rng(seed_of_test())
    i, j = np.meshgrid(np.arange(4.0), np.arange(3.0), indexing="ij")
    patch = BezierPatch(np.stack([i, j, random.uniform(-1, 1, (4, 3))], axis=-1))
    surface = seamwright.BSplineSurface.from_patch(patch).with_knot("u", 0.25)
    parts = seamwright.edge_patches(surface, "v1", breaks=[0.5])
    assert len(parts) == 3
    for part, begin, end in zip(parts, (0, 0.25, 0.5), (0.25, 0.5, 1)):
        for u, v in random.uniform(0, 1, (5, 2)):
            np.testing.assert_allclose(
                part.point(u, v), patch.point(begin + u * (end - begin), v), atol=1e-13
            )
    assert len(seamwright.edge_patches(patch, "u0")) == 1


def test_pieces_of_one_surface_are_joined_in_any_knots():
    """Two halves of one surface have different knots; each pair of patches is G2."""
    i, j = np.meshgrid(np.linspace(0, 20, 5), np.linspace(0, 20, 4), indexing="ij")
    patch = BezierPatch(np.stack([i, j, 0.02 * i * j - 0.01 * j**2], axis=-1))
    whole = seamwright.BSplineSurface.from_patch(patch)
    left, right = seamwright.edge_patches(whole, "v0", breaks=[0.5])
    a = seamwright.BSplineSurface.from_patch(left).with_knot("v", 0.4)
    b = seamwright.BSplineSurface.from_patch(right).with_knot("v", 0.75).with_knot("u", 0.5)
    pairs = seamwright.edge_pairs(a, "u1", b, "u0")
    assert len(pairs) == 3
    for p, q in pairs:
        condition = seamwright.join_condition(p, "u1", q, "u0")
        assert condition.verdict == "G1" and condition.g2


def test_bad_arguments_are_refused():
    patch = BezierPatch(np.zeros((2, 2, 3)) + np.arange(2)[:, None, None])
    with pytest.raises(ValueError, match="break 1"):
        seamwright.edge_patches(patch, "u0", breaks=[1.0])
    with pytest.raises(ValueError, match="known of a patch"):
        seamwright.edge_patches(patch, "w0")
    with pytest.raises(TypeError, match="a is 3"):
        seamwright.edge_pairs(3, "u0", patch, "u1")
