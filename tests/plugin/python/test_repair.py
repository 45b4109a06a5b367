# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models repaired from Python."""

import json
import math
import pathlib
import subprocess
import sys
import threading
import time

import pytest

import seamwright

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))
from models import OCCT_DATA, box_text, installed, reader_that_finds  # noqa: E402
from patches import sheet_text, surfaces_of, worst_figures  # noqa: E402
from schemas import expect_valid, validator  # noqa: E402

VALIDATOR = validator("repair")


def sheet(folder, **how):
    path = folder / "sheet.step"
    path.write_text(sheet_text(**how))
    return seamwright.read(path)


@pytest.mark.parametrize("target", ["G1", "G2"])
def test_a_sheet_flows_again(tmp_path, target):
    model = sheet(tmp_path, count_y=2)
    report = model.repair(target=target)
    assert report.changed and report.passed and report.after.passed and not report.before.passed
    assert not model.analyze().passed, "the model given is not changed"
    found = report.model.analyze(level=target)
    assert found.seams == report.after.seams == [seam["after"] for seam in report.seams]
    assert report.before.seams == [seam["before"] for seam in report.seams]
    report.model.write(tmp_path / "out.step")
    gap_mm, angle_deg = worst_figures(surfaces_of((tmp_path / "out.step").read_text()))
    assert gap_mm <= 1e-9 and angle_deg <= 0.1
    assert "repaired" in report.to_table() and "PASSED" in report.to_table()
    done = report.summary["repaired"]
    assert repr(report) == f"<RepairReport: {done} of {done} seams repaired, 0 defects left>"


def test_a_reason_has_its_numbers_and_its_location(tmp_path):
    model = sheet(tmp_path)
    (seam,) = [seam for seam in model.repair(max_move_mm=1e-6).seams if seam.treated]
    assert seam.reason_code == "misses_tolerance"
    numbers = seam.reason_facts.numbers
    assert numbers["limit_mm"] == 1e-6 and numbers["times_tolerance"] > 1
    assert f"{numbers['times_tolerance']:.3g} times the tolerance" in seam.reason
    (held,) = model.repair(edges=seam.before.edges, fixed_faces=seam.before.faces).seams
    assert (held.reason_code, held.reason_facts.faces) == ("face_fixed", seam.before.faces)
    assert held.not_sewn_facts.to_dict() == {"numbers": {}, "faces": [], "edges": []}


def test_the_report_follows_the_schema(tmp_path):
    report = sheet(tmp_path, count_x=3).repair(fixed_faces=[1], max_move_mm=None, edges=None)
    found = report.to_dict()
    expect_valid(found, VALIDATOR)
    assert json.loads(report.to_json()) == found and "\n" not in report.to_json()
    assert (report.seams, report.moves, report.summary) == (
        found["seams"],
        found["moves"],
        found["summary"],
    )
    assert found["output"] is None and found["options"]["max_move_mm"] is None
    assert 1 not in [move["face"] for move in report.moves]


def test_what_is_written_is_read_back(tmp_path):
    report = sheet(tmp_path, count_x=3).repair()
    shares = []
    written = report.write(tmp_path / "out.step", progress=shares.append)
    assert (
        written["format"] == "STEP" and written["followed_source"] and written["changed_faces"] == 3
    )
    assert written["output"] == {
        "path": str(tmp_path / "out.step"),
        "format": "STEP",
        "edges": 10,
        "faces": 3,
        "open_edges": 8,
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert written["differences"] == ""
    assert shares == sorted(shares) and shares[-1] == 1
    assert [seam["class"] for seam in seamwright.read(tmp_path / "out.step").analyze().seams] == [
        "smooth"
    ] * 2
    with pytest.raises(seamwright.ModelError, match="overwrite"):
        report.write(tmp_path / "out.step")
    for stop in (0, 0.3, 0.7):
        with pytest.raises(seamwright.Cancelled):
            report.write(tmp_path / "other.step", progress=lambda share: share < stop)
    assert not (tmp_path / "other.step").exists()


def test_the_file_is_judged_not_the_model(tmp_path, monkeypatch):
    """The command's own test, from Python: a reader that finds another model where the new one
    waits."""
    found = list((pathlib.Path(seamwright.__file__).parents[2] / "bin").glob("seamwright-read-*"))
    assert found, "no reader beside this module"
    report = sheet(tmp_path).repair()
    other = tmp_path / "other.step"
    other.write_text(sheet_text(count_x=3))
    monkeypatch.setenv("SEAMWRIGHT_READER", str(reader_that_finds(other, tmp_path, found[0])))
    written = report.write(tmp_path / "out.step")
    assert written["output"]["defects"] == 2 and written["output"]["faces"] == 3
    assert written["differences"].startswith(
        "read back: 2 defects, 3 faces, 10 edges, 8 free edges"
    )
    monkeypatch.setenv(
        "SEAMWRIGHT_READER", str(reader_that_finds(tmp_path / "none.step", tmp_path, found[0]))
    )
    before = sorted(tmp_path.iterdir())
    with pytest.raises(seamwright.ModelError, match="can't be read back, so it is not written"):
        report.write(tmp_path / "another.step")
    assert sorted(tmp_path.iterdir()) == before


def test_keywords_are_taken(tmp_path):
    model = sheet(tmp_path, count_x=3)
    first, second = (seam["edges"][0] for seam in model.analyze().seams)
    report = model.repair(
        target="G2",
        max_move_mm=0.25,
        edges=(second,),
        fixed_faces={3},
        match_mm=0.05,
        sew=False,
        jobs=1,
        gap_mm=0.02,
        angle_deg=0.05,
        curvature_rel=0.1,
        flat_radius_mm=5000,
        crease_deg=7,
    )
    found = report.to_dict()
    assert found["options"] == {
        "target": "G2",
        "max_move_mm": 0.25,
        "edges": [second],
        "fixed_faces": [3],
        "match_mm": 0.05,
        "sew": False,
        "convert_analytic": False,
        "fairness": 1.5,
        "keep_curvature": False,
        "max_time_s": None,
    }
    expected = {
        "gap_mm": 0.02,
        "angle_deg": 0.05,
        "curvature_rel": 0.1,
        "flat_radius_mm": 5000,
        "crease_deg": 7,
    }
    assert {key: found["tolerance"][key] for key in expected} == pytest.approx(expected)
    assert [seam["before"]["edges"] for seam in report.seams if seam["treated"]] == [[second]]
    assert {move["face"] for move in report.moves} == {2}


def test_numbers_of_numpy_are_numbers(tmp_path):
    import numpy

    model = sheet(tmp_path)
    (edge,) = model.analyze().seams[0]["edges"]
    report = model.repair(
        edges=numpy.array([edge]), fixed_faces=numpy.array([2]), max_move_mm=numpy.float64(1)
    )
    assert report.passed and [move["face"] for move in report.moves] == [1]


def test_open_edges_are_sewn(tmp_path):
    model = sheet(tmp_path, shared=False)
    assert model.repair().seams == []
    report = model.repair(match_mm=0.1)
    assert report.passed and report.summary["sewn"] == 1 and report.model.edge_count == 7
    expect_valid(report.to_dict(), VALIDATOR)
    assert report.model.analyze().seams == report.after.seams
    assert model.repair(match_mm=0.1, sew=False).model.edge_count == 8


def test_what_has_no_defect_stays(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    for model in (sheet(tmp_path, noise_mm=0), seamwright.read(path)):
        report = model.repair()
        assert (
            report.passed
            and not report.changed
            and report.moves == []
            and report.summary["treated"] == 0
        )
        assert report.after.seams == report.before.seams


def test_what_is_left_says_why(tmp_path):
    report = sheet(tmp_path).repair(max_move_mm=1e-6)
    assert not report.passed and not report.changed
    assert report.summary["left"] == 1 and "mm" in report.seams[0]["reason"]
    assert "FAILED" in report.to_table()


@pytest.mark.parametrize(
    "arguments,said",
    [
        ({"target": "G3"}, "G3"),
        ({"target": 1}, "target is 1"),
        ({"max_move_mm": -0.5}, "-0.5"),
        ({"max_move_mm": math.nan}, "nan"),
        ({"max_move_mm": "far"}, "max_move_mm is 'far'"),
        ({"edges": [0]}, "edge 0: the model has edges 1 to 7"),
        ({"edges": [2, 8]}, "edge 8"),
        ({"edges": [1]}, "edge 1 is not a seam"),
        ({"edges": []}, r"edges is \[\]"),
        ({"edges": 3}, "edges is 3"),
        ({"edges": "3"}, "edges is '3'"),
        ({"edges": [1.5]}, "edges is 1.5"),
        ({"edges": [True]}, "edges is True"),
        ({"edges": [None]}, "edges is None"),
        ({"fixed_faces": [3]}, "face 3: the model has faces 1 to 2"),
        ({"fixed_faces": 1}, "fixed_faces is 1"),
        ({"fixed_faces": None}, "fixed_faces is None"),
        ({"fixed_faces": [10**30]}, "fixed_faces is 1000"),
        ({"gap_mm": -0.25}, "-0.25"),
        ({"angle_deg": 4, "crease_deg": 3}, "3"),
        ({"match_mm": math.inf}, "inf"),
        ({"jobs": -1}, "-1"),
        ({"jobs": 1.5}, "jobs is 1.5"),
        ({"profile": "class-b"}, "class-b"),
        ({"sew": 1}, "sew is 1"),
    ],
)
def test_bad_arguments_are_value_errors_with_the_number(tmp_path, arguments, said):
    with pytest.raises(ValueError, match=said):
        sheet(tmp_path).repair(**arguments)


def test_unknown_names_and_positions_are_type_errors(tmp_path):
    model = sheet(tmp_path)
    with pytest.raises(TypeError):
        model.repair("G1")
    with pytest.raises(TypeError):
        model.repair(max_move=1)


def test_progress_rises_and_cancels(tmp_path):
    model = sheet(tmp_path, count_y=2)
    shares = []
    model.repair(progress=shares.append)
    assert shares == sorted(shares) and 0 <= shares[0] and shares[-1] == 1
    for stop in (0, 0.1):
        with pytest.raises(seamwright.Cancelled):
            model.repair(progress=lambda share: share < stop)
    for stop in (0, 0.1, 0.3, 1):
        with pytest.raises(ZeroDivisionError):
            model.repair(progress=lambda share: share < stop or 1 / 0)
    assert model.repair().passed, "the model is usable still"


def test_others_run_meanwhile(tmp_path):
    """The GIL is released: another thread counts while this one repairs."""
    model = sheet(tmp_path, count_x=6, count_y=4)
    ticks, done = [], threading.Event()

    def count():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    began = time.monotonic()
    model.repair()
    ended = time.monotonic()
    done.set()
    counter.join()
    assert sum(began < tick < ended for tick in ticks) > 0.05 * (ended - began) / 0.001


def test_no_thread_is_left_behind(tmp_path):
    """Checks on threads of OpenCASCADE's own have shared what they must not, and written to freed
    memory. In a process of its own: in this one such threads may wait from before."""
    if not pathlib.Path("/proc/self/task").exists():
        pytest.skip("this system does not list the threads of a process")
    path = tmp_path / "sheet.step"
    path.write_text(sheet_text(count_x=3, count_y=2))
    program = (
        "import os, sys, seamwright; model = seamwright.read(sys.argv[1]); before = "
        "len(os.listdir('/proc/self/task')); "
        "print(model.repair(jobs=2).passed, len(os.listdir('/proc/self/task')) - before)"
    )
    run = subprocess.run([sys.executable, "-c", program, str(path)], capture_output=True, text=True)
    assert (run.stdout, run.stderr) == ("True 0\n", "")


def test_reasons_are_told_where_a_part_of_the_seams_reaches_g2():
    """19 of these 35 seams reach G2 now, 13 others G1."""
    model = seamwright.read(installed(OCCT_DATA / "occ/shell1.brep"))
    edges = [
        86,
        87,
        90,
        91,
        92,
        103,
        104,
        105,
        106,
        107,
        109,
        111,
        131,
        132,
        134,
        135,
        137,
        140,
        141,
        143,
        144,
        146,
        147,
    ]
    edges += [150, 189, 190, 192, 193, 194, 195, 196, 197, 198, 199, 200]
    seams = {
        seam["before"]["edges"][0]: seam for seam in model.repair(target="G2", edges=edges).seams
    }
    for edge in edges:
        assert seams[edge]["treated"]
        assert seams[edge]["repaired"] == (seams[edge]["reason"] == ""), edge
    assert sum(seam["repaired"] for seam in seams.values()) >= 12
