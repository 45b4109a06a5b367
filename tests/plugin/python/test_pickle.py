# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copies through pickle and copy: bitwise, also of poles whose weights are not 1."""

import copy
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import seamwright
from seeds import fnv1a

sys.path.insert(0, str(Path(__file__).parents[1] / "cli"))
from models import box_text, roof_text  # noqa: E402

RANDOM = np.random.default_rng(fnv1a("test_pickle.py"))


def rational(kind, shape, *before, after=()):
    poles, weights = RANDOM.normal(size=(*shape, 3)), RANDOM.uniform(0.1, 9, shape)
    return kind(*before, poles, *after, weights)


def objects():
    # Divided, so that homogeneous poles are not products of the poles and weights that are shown.
    curve = rational(seamwright.BezierCurve, (6,)).split(1 / 3)[1]
    patch = rational(seamwright.BezierPatch, (4, 3)).split_u(1 / 3)[0]
    triangle = rational(seamwright.BezierTriangle, (10,)).split_at(0.3, 0.3)[1]
    bspline = rational(seamwright.BSplineCurve, (5,), 3, [0, 0, 0, 0, 1 / 3, 1, 1, 1, 1])
    surface = rational(
        seamwright.BSplineSurface,
        (4, 3),
        after=([0, 0, 0, 0.4, 1, 1, 1], [0, 0, 0, 1, 1, 1], 2, 2),
    ).with_knot("u", 0.7)
    return [
        curve,
        patch,
        triangle,
        bspline,
        bspline.bezier_spline(),
        surface,
        seamwright.BernsteinPolynomial(RANDOM.normal(size=4), 1e-3).split(0.3)[0],
        *planar_objects(),
    ]


def planar_objects():
    """A value of each class of curves of the plane."""
    points = RANDOM.normal(size=(5, 2)) + 3 * np.arange(5)[:, None]
    clothoids = seamwright.clothoid_spline(points).chain
    arcs = seamwright.biarc_spline(points).chain
    return [
        arcs.arcs[1],
        arcs,
        seamwright.ArcChain([seamwright.PlanarArc([0, 0], 0, 0, 1)], corners=[0]),
        seamwright.ArcChain([seamwright.PlanarArc([0, 0], 0, 1, 2 * np.pi)], closed=True),
        clothoids.pieces[2],
        clothoids,
        seamwright.log_spiral([1, 2], -0.4, [9, 3], 1.1),
        seamwright.MatrixCurve(
            2,
            [0, 0, 0, 1 / 3, 1, 1, 1],
            *RANDOM.normal(size=(2, 4, 3)),
            RANDOM.uniform(0.1, 9, 4),
            RANDOM.uniform(0, 9, 4),
        ),
        seamwright.PlanarConic(*RANDOM.normal(size=(3, 2)), 0.7).halves()[1],
    ]


def state(thing):
    return pickle.dumps(thing)


COPIES = [
    copy.copy,
    copy.deepcopy,
    *(
        lambda thing, protocol=protocol: pickle.loads(pickle.dumps(thing, protocol))
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1)
    ),
]


@pytest.mark.parametrize("thing", objects(), ids=repr)
@pytest.mark.parametrize("duplicate", COPIES)
def test_copies_are_bitwise(thing, duplicate):
    result = duplicate(thing)
    assert type(result) is type(thing) and result is not thing
    assert result == thing and state(result) == state(thing)


def test_jets_are_copied():
    patch = rational(seamwright.BezierPatch, (4, 3))
    jet = patch.jet(0.3, 0.7)
    for duplicate in COPIES:
        result = duplicate(jet)
        for name in ("p", "u", "v", "uu", "uv", "vv", "uuu", "uuv", "uvv", "vvv"):
            assert np.array_equal(getattr(result, name), getattr(jet, name))


def test_a_closed_spline_stays_closed():
    points = [[1, 0, 0], [0, 1, 0], [-1, 0, 1], [0, -1, 0], [1, 0, 0.0]]
    spline = seamwright.nu_spline(points, ends="periodic").curve
    result = pickle.loads(pickle.dumps(spline))
    assert spline.closed and result.closed and result == spline


@pytest.mark.parametrize("thing", objects(), ids=repr)
def test_another_process_reads_it(thing, tmp_path):
    path = tmp_path / "thing"
    path.write_bytes(pickle.dumps(thing))
    program = f"import pickle; print(repr(pickle.load(open({str(path)!r}, 'rb'))))"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert run.stdout.strip() == repr(thing), run.stderr


def test_a_bad_state_is_refused():
    curve = seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])
    for bad in (np.zeros((2, 3)), np.full((2, 4), np.nan)):
        with pytest.raises((ValueError, TypeError)):
            seamwright.BezierCurve.__new__(seamwright.BezierCurve).__setstate__(bad)
    assert pickle.loads(pickle.dumps(curve)) == curve


def test_tell_what_they_are():
    assert repr(seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])) == "<BezierCurve of degree 1>"
    assert "rational" in repr(objects()[1])


# Models, reports and meshes


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = tmp_path_factory.mktemp("models") / "roof.step"
    path.write_text(roof_text(1))
    return seamwright.read(path)


def figures(model):
    report = model.analyze(jobs=1).to_dict()
    return [{k: v for k, v in seam.items() if k != "note"} for seam in report["seams"]]


def test_models_are_copied(model):
    wanted = figures(model)
    for duplicate in COPIES[:3]:
        result = duplicate(model)
        assert (result.path, result.format, result.length_unit) == (
            model.path,
            model.format,
            model.length_unit,
        )
        assert result.attributes == model.attributes and result.notes == model.notes
        found = figures(result)
        assert [s["faces"] for s in found] == [s["faces"] for s in wanted]
        assert [s["class"] for s in found] == [s["class"] for s in wanted]
        for a, b in zip(found, wanted):
            assert a["length_mm"] == pytest.approx(b["length_mm"], rel=1e-12)


def test_reports_are_copied(model):
    report = model.analyze(jobs=1)
    for duplicate in COPIES:
        result = duplicate(report)
        assert result.to_json() == report.to_json() and result.to_table() == report.to_table()
        assert result.to_csv() == report.to_csv() and pickle.dumps(result) == pickle.dumps(report)
    changed = report.__getstate__()
    for bad in (changed[:-1], [*changed, 0]):
        with pytest.raises(ValueError, match="state of a Report is too"):
            seamwright.Report.__new__(seamwright.Report).__setstate__(bad)
    assert repr(report) == f"<Report of {len(report)} seams: failed>"
    seams = pickle.loads(pickle.dumps(report.seams))
    assert seams == report.seams and type(seams[0]) is seamwright.results.Seam


def test_meshes_are_copied(model):
    mesh = model.display_mesh()
    for duplicate in COPIES[:3]:
        result = duplicate(mesh)
        for name in ("points", "normals", "parameters", "triangles", "principal_curvatures"):
            assert np.array_equal(getattr(result, name), getattr(mesh, name), equal_nan=True)
        assert np.array_equal(result.first_nodes, mesh.first_nodes)
        assert result.faults == mesh.faults


RESULTS_WITH_MODELS = {
    "RepairReport": lambda box: box.repair(jobs=1),
    "FillReport": lambda box: box.fill(face=1, jobs=1),
    "MatchResult": lambda box: box.match_faces(1, 3),
    "CornerFillet": lambda box: box.corner_fillet(1, 0.1),
    "BlendedSurface": lambda box: box.extend_surface(1, 0.1, faces=1),
}


@pytest.mark.parametrize("kind", RESULTS_WITH_MODELS)
def test_results_with_models_are_copied_but_not_pickled(tmp_path, kind):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    result = RESULTS_WITH_MODELS[kind](seamwright.read(path))
    assert type(result).__name__ == kind
    for duplicate in (copy.copy, copy.deepcopy):
        assert duplicate(result).to_dict() == result.to_dict()
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        with pytest.raises(TypeError, match=kind + r" can't be pickled.*to_dict\(\)"):
            pickle.dumps(result, protocol)
    assert pickle.loads(pickle.dumps(result.to_dict())) == result.to_dict()
