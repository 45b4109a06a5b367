# SPDX-License-Identifier: LGPL-2.1-or-later
"""Model.from_patches, surface and curve: what is built comes back, is judged and is written."""

import copy
import pathlib
import pickle
import sys

import numpy as np
import pytest

import seamwright
from seamwright import (
    BezierCurve,
    BezierPatch,
    BezierSpline,
    BezierTriangle,
    BSplineCurve,
    BSplineSurface,
    Model,
)

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from models import OCCT_DATA, installed  # noqa: E402


def patch(function, weights=None):
    """Return the bicubic patch with the poles function(i / 3, j / 3)."""
    u, v = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    return BezierPatch(np.stack(np.broadcast_arrays(*function(u, v)), axis=-1), weights)


def wavy(generator):
    heights = generator.normal(size=(4, 4))
    return patch(lambda u, v: (10 * u, 10 * v, heights))


def spline(generator):
    surface = BSplineSurface.from_patch(wavy(generator))
    return surface.with_knot("u", 0.3).with_knot("v", 0.7)


def triangle():
    return BezierTriangle([[0, 0, 0], [0, 5, 1], [0, 10, 0], [5, 0, 1], [5, 5, 2], [10, 0, 0]])


WHOLE = patch(lambda u, v: (10 * u, 10 * v, 2 * u**3 + v * v))


@pytest.fixture
def generator():
    return np.random.default_rng(7)


def around(k, n=5):
    return np.array([np.cos(2 * np.pi * k / n), np.sin(2 * np.pi * k / n)])


def inside_five_sides():
    def side(k):
        begin, end = 12 * around(k), 12 * around(k + 1)
        plane = [begin, 0.9 * (2 * begin + end) / 3, 0.9 * (begin + 2 * end) / 3, end]
        height = (0, 4, 2, 3, 1)
        return np.column_stack([plane, (height[k], 5, 5, height[(k + 1) % 5])])

    return seamwright.umbrella_inside([side(k) for k in range(5)])


@pytest.mark.parametrize("name", ["a.step", "a.iges", "a.bin", "a.brep"])
def test_files_hold_the_poles(tmp_path, generator, name):
    given = [wavy(generator), spline(generator), wavy(generator)]
    model = Model.from_patches([*given, triangle()])
    assert (model.format, model.path, model.face_count, model.edge_count) == ("memory", "", 6, 21)
    model.write(tmp_path / name)
    back = seamwright.read(tmp_path / name)
    assert back.face_count == 6 and not back.notes
    # Text of IGES and BREP has 17 and 15 digits.
    near = {"a.brep": 1e-13, "a.iges": 1e-14}.get(name, 0)
    for face in range(1, 7):
        written, read = model.surface(face), back.surface(face)
        assert np.allclose(read.poles, written.poles, rtol=0, atol=near)
        assert (read.knots_u, read.knots_v) == (written.knots_u, written.knots_v)
    for face, surface in enumerate(given, 1):
        if isinstance(surface, BezierPatch):
            surface = BSplineSurface.from_patch(surface)
        assert model.surface(face) == surface


def test_rational_surfaces_come_back(tmp_path, generator):
    weights = generator.uniform(0.3, 3, (4, 4))
    given = BezierPatch(wavy(generator).poles, weights)
    model = Model.from_patches(given)
    model.write(tmp_path / "a.step")
    for surface in (model.surface(1), seamwright.read(tmp_path / "a.step").surface(1)):
        assert np.allclose(surface.poles, given.poles, rtol=0, atol=1e-13)
        assert np.allclose(surface.weights, weights, rtol=1e-15)


def test_curves_are_edges(generator):
    poles = generator.normal(size=(4, 3))
    curves = [
        BezierCurve(poles),
        BSplineCurve(2, [0, 0, 0, 0.3, 1, 1, 1], poles),
        seamwright.gamma_spline([[0, 0, 0], [5, 3, 0], [9, 1, 2], [12, 4, 0], [15, 0, 1]]),
    ]
    model = Model.from_patches(curves, ["a", "b", None])
    assert (model.face_count, model.edge_count) == (0, 3)
    assert [(part.kind, part.index, part.name) for part in model.attributes] == [
        ("Edge", 1, "a"),
        ("Edge", 2, "b"),
    ]
    assert np.array_equal(model.curve(1).poles, poles)
    assert model.curve(2) == curves[1]
    middle = np.mean(model.curve(3).knots[:: len(model.curve(3).knots) - 1])
    assert isinstance(curves[2], BezierSpline)
    assert np.allclose(model.curve(3).point(middle), curves[2].point(middle))
    assert len(model.analyze()) == 0
    assert pickle.loads(pickle.dumps(model)).edge_count == 3


def test_names_are_of_all_faces_of_an_item(generator):
    model = Model.from_patches([triangle(), wavy(generator)], ["three", "one"])
    assert [(part.index, part.name) for part in model.attributes] == [
        (1, "three"),
        (2, "three"),
        (3, "three"),
        (4, "one"),
    ]
    assert copy.copy(model).attributes == model.attributes


def test_exact_pairs_are_measured(tmp_path):
    pair = WHOLE.split_u(0.4)
    apart = Model.from_patches(pair)
    assert len(apart.analyze()) == 0
    sewn = Model.from_patches(pair, ["left", "right"], sew_mm=1e-4)
    assert (sewn.edge_count, sewn.notes) == (7, [])
    assert [part.name for part in sewn.attributes] == ["left", "right"]
    assert [sewn.surface(face) for face in (1, 2)] == list(map(BSplineSurface.from_patch, pair))
    sewn.write(tmp_path / "a.step")
    for model, kind, match_mm in (
        (apart, "matched", 0.01),
        (sewn, "shared", 0),
        (seamwright.read(tmp_path / "a.step"), "shared", 0),
    ):
        (seam,) = model.analyze(level="G2", match_mm=match_mm).seams
        assert (seam.kind, seam.level, seam.certified) == (kind, "G2", True)
        assert seam.gap_mm.upper < 1e-11 and seam.curvature_per_mm.upper < 1e-8


def test_faces_that_do_not_meet_are_not_sewn():
    first, second = WHOLE.split_u(0.4)
    moved = BezierPatch(np.asarray(second.poles) + [0, 0, 0.01])
    model = Model.from_patches([first, moved], sew_mm=1e-3)
    assert model.edge_count == 8
    (seam,) = model.analyze(match_mm=0.1, gap_mm=0.1).seams
    assert seam.gap_mm.lower == pytest.approx(0.01, rel=0.05)


def test_the_results_of_constructions(tmp_path):
    filled = inside_five_sides()
    model = Model.from_patches([filled], ["hole"], sew_mm=1e-4)
    members = filled.members
    assert model.face_count == sum(3 if isinstance(m, BezierTriangle) else 1 for m in members)
    report = model.analyze()
    assert len(report) >= 5 and report.passed and not model.notes
    model.write(tmp_path / "hole.step")
    again = seamwright.read(tmp_path / "hole.step").analyze()
    assert len(again) == len(report) and again.passed
    loft = seamwright.frame_loft(
        lambda omega: BezierCurve([[0, 0, omega], [1, 1 + omega, omega], [2, 0, omega]]), (0, 1)
    )
    assert Model.from_patches(loft).surface(1) == loft.surface


def test_degenerate_sides_are_written(tmp_path):
    corner = patch(lambda u, v: (10 * u, 10 * u * v, u * u * v))
    cone = BezierTriangle([[0, 0, 0], [5, 0, 0], [10, 0, 0], [0, 0, 0], [7, 7, 0], [0, 0, 0]])
    tube = patch(lambda u, v: (np.sin(2 * np.pi * v).round(15), np.cos(2 * np.pi * v), 9 * u))
    model = Model.from_patches([corner, cone, tube])
    assert model.face_count == 5
    model.write(tmp_path / "a.step")
    back = seamwright.read(tmp_path / "a.step")
    assert back.face_count == 5 and not back.notes
    assert len(model.display_mesh().faults) == len(back.display_mesh().faults) == 0


def test_what_is_refused(generator):
    good = wavy(generator)
    point = BezierPatch(np.zeros((2, 2, 3)))
    with pytest.raises(ValueError, match=r"items\[1\]: all poles are within .* of a point"):
        Model.from_patches([good, point])
    with pytest.raises(ValueError, match=r"items: all poles"):
        Model.from_patches(point)
    with pytest.raises(ValueError, match=r"items\[0\]: degree 26"):
        Model.from_patches([BezierPatch(generator.normal(size=(27, 2, 3)))])
    for items, said in (
        ([good, 3], r"items\[1\] is 3"),
        ({"a": good}, "items is"),
        ([[good]], r"items\[0\] is"),
    ):
        with pytest.raises(TypeError, match=said):
            Model.from_patches(items)
    with pytest.raises(ValueError, match="no surfaces and no curves"):
        Model.from_patches([])
    for keywords, said in (
        ({"names": ["a", "b"]}, "2 names for 1 item"),
        ({"tolerance_mm": 0}, "0 mm"),
        ({"tolerance_mm": float("nan")}, "nan mm"),
        ({"sew_mm": -1}, "-1 mm"),
        ({"sew_mm": "far"}, "sew_mm is 'far'"),
        ({"jobs": 0.5}, "jobs is 0.5"),
    ):
        with pytest.raises(ValueError, match=said):
            Model.from_patches([good], **keywords)
    for names in ("a", [3]):
        with pytest.raises(TypeError, match="names"):
            Model.from_patches([good], names)
    model = Model.from_patches([good])
    for call, said in (
        (lambda: model.surface(2), "face 2"),
        (lambda: model.surface(True), "face is True"),
        (lambda: model.curve(0), "edge 0"),
    ):
        with pytest.raises(ValueError, match=said):
            call()


def test_surfaces_of_other_kinds_are_named():
    model = seamwright.read(installed(OCCT_DATA / "step/screw.step"))
    complaints = []
    for face in range(1, model.face_count + 1):
        try:
            model.surface(face)
        except ValueError as error:
            complaints.append(str(error))
    assert any(said.startswith("Face") and "has a plane" in said for said in complaints)


def test_progress_and_cancelling():
    shares = []
    Model.from_patches(WHOLE.split_u(0.5), sew_mm=1e-3, progress=shares.append)
    assert shares and shares == sorted(shares) and shares[-1] <= 1
    with pytest.raises(seamwright.Cancelled):
        Model.from_patches(WHOLE.split_u(0.5), sew_mm=1e-3, progress=lambda share: False)


def test_symmetric_edges_have_no_gap_beside_their_middle():
    # The one edge runs slower at both ends: points halfway agree, however few are compared.
    def strip(x, y):
        return seamwright.BezierPatch(np.array([[(a, b, 0) for b in y] for a in x], float))

    model = seamwright.Model.from_patches(
        [strip((0, 60), (-10, 0)), strip((0, 10, 50, 60), (0, 10))]
    )
    (seam,) = model.analyze(match_mm=0.1).seams
    assert seam.gap_mm.upper < 1e-4
