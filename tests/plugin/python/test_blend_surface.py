# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces between sides of a model, and beyond one, from Python."""

import numpy as np
import pytest

import seamwright


def sheet(x, z, tilt):
    """A cubic patch of 30 by 40 mm."""
    u, v = np.meshgrid(np.linspace(0, 30, 4), np.linspace(0, 40, 4), indexing="ij")
    heights = z + tilt * u + 0.002 * (u - 15) ** 2 + 0.003 * (v - 10) ** 2
    return seamwright.BezierPatch(np.stack([x + u, v, heights], axis=-1))


@pytest.fixture(scope="module")
def sheets():
    return seamwright.Model.from_patches([sheet(0, 0, 0.3), sheet(60, 8, -0.2)])


def edge_at(model, x):
    """The number of the edge whose points all have that x."""
    for edge in range(1, model.edge_count + 1):
        if np.allclose(np.asarray(model.curve(edge).poles)[:, 0], x):
            return edge
    raise AssertionError(x)


@pytest.mark.parametrize("start", ["G0", "G1", "G2", "G3"])
@pytest.mark.parametrize("end", ["G1", "G2"])
def test_a_surface_joins_two_sides(sheets, start, end):
    edges = edge_at(sheets, 30), edge_at(sheets, 60)
    result = sheets.blend_surface(*edges, start_order=start, end_order=end, angle_deg=1e-3)
    assert result.reached and repr(result).startswith("<BlendedSurface reached: ")
    assert result.surface.degree_v == int(start[1]) + int(end[1]) + 1
    levels = {seam.edges[0]: seam.level for seam in result.seams}
    assert levels[edges[0]] >= start and levels[edges[1]] >= end
    assert all(seam.faces[1] == 0 for seam in result.seams)
    assert result.model.face_count == sheets.face_count + 1
    keys = {"reached", "spans", "fold", "to", "sides", "laterals", "seams"}
    assert set(result.to_dict()) == keys
    assert result.fold is None and result.laterals == []
    assert [(side["side"], side["edges"]) for side in result.sides] == [
        ("start", [edges[0]]),
        ("end", [edges[1]]),
    ]
    for side in result.sides:
        assert side["reason"] == "" and side["covered_mm"] > 0.99 * side["length_mm"]


def test_the_whole_model_is_as_smooth_as_the_result_says(sheets):
    result = sheets.blend_surface(edge_at(sheets, 30), edge_at(sheets, 60))
    report = result.model.analyze(level="G2", match_mm=0.02)
    assert len(report.seams) == 2 and report.passed


def test_flip_lets_the_end_run_the_other_way(sheets):
    edges = edge_at(sheets, 30), edge_at(sheets, 60)
    corners = [
        np.array([sheets.blend_surface(*edges, flip=flip).surface.point(u, 1.0) for u in (0, 1)])
        for flip in (False, True)
    ]
    assert np.allclose(corners[0], corners[1][::-1], atol=1e-6)
    with pytest.raises(ValueError, match="flip"):
        sheets.blend_surface(*edges, flip="yes")


def test_tension_moves_the_surface(sheets):
    edges = edge_at(sheets, 30), edge_at(sheets, 60)
    middles = [
        sheets.blend_surface(*edges, start_tension=t).surface.point(0.5, 0.5) for t in (0.5, 1, 2)
    ]
    assert np.linalg.norm(middles[1] - middles[0]) > 0.01
    assert np.linalg.norm(middles[2] - middles[1]) > 0.01


def height(x, y):
    return 0.004 * x**2 + 0.003 * y**2 - 0.002 * x * y


def patch_at(i, j, size=20):
    """The part of a surface of degree two over a square of a grid."""
    x, y = (size * np.array([[k, k], [k, k + 1], [k + 1, k + 1]]) for k in (i, j))
    poles = [
        [
            (
                a.mean(),
                b.mean(),
                0.004 * a.prod() + 0.003 * b.prod() - 0.002 * a.mean() * b.mean(),
            )
            for b in y
        ]
        for a in x
    ]
    return seamwright.BezierPatch(np.array(poles, float))


@pytest.fixture(scope="module")
def hole():
    """A smooth sheet of nine patches without the middle one, and the edges around the hole."""
    patches = [patch_at(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    model = seamwright.Model.from_patches(patches, sew_mm=1e-3)

    def edge_of(axis, value):
        for edge in range(1, model.edge_count + 1):
            points = np.asarray(model.curve(edge).poles)[[0, -1], :2]
            if np.allclose(points[:, axis], value) and np.allclose(
                np.sort(points[:, 1 - axis]), [20, 40]
            ):
                return edge
        raise AssertionError((axis, value))

    return model, [edge_of(0, 20), edge_of(0, 40), edge_of(1, 20), edge_of(1, 40)]


@pytest.mark.parametrize("order", ["G0", "G1", "G2"])
def test_lateral_boundaries_run_along_edges(hole, order):
    model, (start, end, *lateral) = hole
    result = model.blend_surface(start, end, lateral=lateral, lateral_order=order, angle_deg=1e-2)
    assert result.reached
    assert [boundary["target"] for boundary in result.laterals] == [order] * 2
    assert sorted(edge for boundary in result.laterals for edge in boundary["edges"]) == lateral
    levels = {seam.edges[0]: seam.level for seam in result.seams}
    assert levels[start] >= "G2" and levels[end] >= "G2"
    for boundary in result.laterals:
        assert boundary["distance_mm"] < 1e-3 and boundary["reason"] == ""
        assert levels[boundary["edges"][0]] >= order
    for u in (0, 1):
        for v in np.linspace(0, 1, 41):
            x, y, z = result.surface.point(float(u), float(v))
            assert min(abs(y - 20), abs(y - 40)) < 1e-3 and abs(z - height(x, y)) < 1e-3
    free = model.blend_surface(start, end)
    assert free.laterals == [] and len(free.seams) == 2


def test_each_lateral_boundary_has_its_own_order(hole):
    model, (start, end, first, second) = hole
    result = model.blend_surface(
        start, end, lateral=[first, second], lateral_order={second: "G2"}, angle_deg=1e-2
    )
    assert result.reached
    targets = {boundary["edges"][0]: boundary["target"] for boundary in result.laterals}
    assert targets == {first: "G0", second: "G2"}
    levels = {seam.edges[0]: seam.level for seam in result.seams}
    assert levels[second] >= "G2"


def test_sides_may_share_a_vertex(hole):
    model, (start, _, lateral, _) = hole
    result = model.blend_surface(start, lateral, angle_deg=1e-2)
    assert result.reached
    for u in np.linspace(0, 0.2, 9):  # near the vertex it continues the sheet
        for v in (0, 0.3, 0.6, 1):
            x, y, z = result.surface.point(float(u), v)
            assert abs(z - height(x, y)) < 2e-3 * ((x - 20) ** 2 + (y - 20) ** 2) + 1e-9
    with pytest.raises(ValueError, match="flip: the vertex that the sides share says"):
        model.blend_surface(start, lateral, flip=True)


@pytest.mark.parametrize("order", ["G1", "G2", "G3"])
def test_a_side_is_continued(sheets, order):
    result = sheets.extend_surface(edge_at(sheets, 30), 5, order=order)
    assert result.reached and result.surface.degree_v == int(order[1])
    begin, end = (result.surface.point(0.5, v) for v in (0, 1))
    assert 4.5 < np.linalg.norm(end - begin) < 5.5


def test_a_side_is_continued_up_to_a_face(sheets):
    u, v = np.meshgrid([0.0, 1.0], [0.0, 1.0], indexing="ij")
    wall = seamwright.BezierPatch(np.stack([40 + 2 * u, -100 + 300 * v, -100 + 200 * u], axis=-1))
    model = seamwright.Model.from_patches([sheet(0, 0, 0.3), wall])
    result = model.extend_surface(edge_at(model, 30), to=2)
    assert result.reached and result.to["face"] == 2 and result.to["distance_mm"] < 1e-5
    assert 8 < result.to["least_mm"] <= result.to["most_mm"] < 14
    assert result.model.face_count == 3
    assert sheets.extend_surface(edge_at(sheets, 30), 5).to is None
    for arguments in ({}, {"length_mm": 5, "to": 2}):
        with pytest.raises(ValueError, match="length_mm or to: exactly one of them is needed"):
            model.extend_surface(edge_at(model, 30), **arguments)


def test_a_face_that_does_not_cut_the_extension_is_a_bad_argument(sheets):
    far = seamwright.BezierPatch(np.asarray(sheet(0, 900, 0).poles))
    model = seamwright.Model.from_patches([sheet(0, 0, 0.3), far])
    with pytest.raises(ValueError, match="face 2"):
        model.extend_surface(edge_at(model, 30), to=2)
    with pytest.raises(ValueError, match="tension is too large"):
        sheets.blend_surface(edge_at(sheets, 30), edge_at(sheets, 60), start_tension=1e308)


def test_a_face_is_named_where_an_edge_has_two(tmp_path):
    patches = [sheet(0, 0, 0.3), sheet(30, 9, 0.3)]
    joined = seamwright.Model.from_patches(patches, sew_mm=0.1)
    shared = next(iter(joined.analyze().seams)).edges[0]
    with pytest.raises(ValueError, match="edge 2 is not free: it bounds face 1, face 2"):
        joined.extend_surface(shared, 5)
    assert joined.extend_surface(shared, 5, faces=1).reached


@pytest.mark.parametrize(
    "change, message",
    [
        ({"start": []}, "start: a side needs an edge"),
        ({"start": 99}, "99"),
        ({"start": "1"}, "start is '1'"),
        ({"start_order": "G4"}, "start_order 'G4': known are G0, G1, G2 and G3"),
        ({"end_order": 2}, "end_order is 2"),
        ({"end_tension": 0}, "end: tension is 0"),
        ({"start_faces": [2]}, "edge 2 does not bound face 2"),
        ({"lateral": 99}, "99"),
        ({"lateral": "1"}, "lateral is '1'"),
        ({"lateral_order": "G1"}, "need lateral edges"),
        ({"lateral_order": {3: "G2"}}, "need lateral edges"),
        ({"lateral_order": {3: 2}}, "lateral_order is 2"),
        ({"lateral": 3, "lateral_order": {4: "G1"}}, "lateral order: edge 4 is not in lateral"),
        ({"lateral": 3, "lateral_order": {3: "G3"}}, "lateral order is 3: 0 to 2"),
        ({"gap_mm": -1}, "gap tolerance is -1 mm"),
    ],
)
def test_bad_arguments_are_named(sheets, change, message):
    arguments = {"start": edge_at(sheets, 30), "end": edge_at(sheets, 60), **change}
    with pytest.raises(ValueError, match=message):
        sheets.blend_surface(**arguments)
    with pytest.raises(ValueError, match="length_mm is -1"):
        sheets.extend_surface(edge_at(sheets, 30), -1)
