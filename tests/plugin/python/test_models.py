# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models read and analysed from Python."""

import csv
import io
import json
import math
import os
import pathlib
import sys
import threading
import time

import jsonschema
import numpy
import pytest

import seamwright

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))
from models import OCCT_DATA, box_text, installed, roof_text  # noqa: E402

SCHEMA = json.loads((HERE.parents[2] / "docs" / "analysis-1.schema.json").read_text())


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path


@pytest.fixture
def roof(tmp_path):
    path = tmp_path / "roof.step"
    path.write_text(roof_text(1))
    return path


def test_a_model_tells_what_it_is(box):
    model = seamwright.read(box)
    assert (model.face_count, model.edge_count, model.format) == (6, 12, "STEP")
    assert model.path == str(box) and model.length_unit == "millimetre" and model.notes == []
    assert model.read_s > 0
    assert seamwright.read(str(box)).face_count == 6, "a string as well"


def test_the_report_follows_the_schema(box, roof):
    for path, passed in ((box, True), (roof, False)):
        report = seamwright.read(path).analyze()
        found = report.to_dict()
        jsonschema.Draft202012Validator(SCHEMA).validate(found)
        assert json.loads(report.to_json()) == found and "\n" not in report.to_json()
        assert report.passed is passed and found["summary"]["passed"] is passed
        assert report.seams == found["seams"] and len(report) == len(found["seams"])
        rows = list(csv.DictReader(io.StringIO(report.to_csv())))
        assert [int(row["seam"]) for row in rows] == [seam["id"] for seam in found["seams"]]
        assert ("PASSED" in report.to_table()) is passed


def test_tolerances_are_taken(roof):
    model = seamwright.read(roof)
    assert not model.analyze().passed
    assert model.analyze(angle_deg=1.01).passed and model.analyze(level="G0").passed
    assert model.analyze(crease_deg=0.5).passed
    report = model.analyze(
        gap_mm=0.5,
        angle_deg=2,
        curvature_rel=0.25,
        flat_radius_mm=77,
        crease_deg=9,
        level="G2",
        jobs=1,
    )
    expected = {
        "gap_mm": 0.5,
        "angle_deg": 2,
        "curvature_rel": 0.25,
        "flat_radius_mm": 77,
        "crease_deg": 9,
    }
    tolerance = report.to_dict()["tolerance"]
    assert {key: tolerance[key] for key in expected} == pytest.approx(expected)
    assert tolerance["level"] == "G2"
    assert report.seams[0]["angle_deg"]["lower"] == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize(
    "arguments,number",
    [
        ({"gap_mm": -0.25}, "-0.25"),
        ({"gap_mm": math.nan}, "nan"),
        ({"angle_deg": -3}, "-3"),
        ({"angle_deg": math.inf}, "inf"),
        ({"curvature_rel": -0.5}, "-0.5"),
        ({"flat_radius_mm": 0}, "0"),
        ({"crease_deg": 91}, "91"),
        ({"angle_deg": 4, "crease_deg": 3}, "3"),
        ({"match_mm": -2}, "-2"),
        ({"match_mm": math.inf}, "inf"),
        ({"jobs": -1}, "-1"),
        ({"jobs": 10**30}, "1000000000"),
        ({"level": "G9"}, "G9"),
        ({"profile": "class-b"}, "class-b"),
        ({"gap_mm": "wide"}, "gap_mm is 'wide'"),
        ({"angle_deg": []}, r"angle_deg is \[\]"),
        ({"crease_deg": True}, "crease_deg is True"),
        ({"match_mm": "near"}, "match_mm is 'near'"),
        ({"jobs": 1.5}, "jobs is 1.5"),
        ({"jobs": None}, "jobs is None"),
        ({"level": 1}, "level is 1"),
        ({"profile": None}, "profile is None"),
    ],
)
def test_bad_arguments_are_value_errors_with_the_number(box, arguments, number):
    with pytest.raises(ValueError, match=number):
        seamwright.read(box).analyze(**arguments)


def test_unknown_names_and_positions_are_type_errors(box):
    model = seamwright.read(box)
    with pytest.raises(TypeError):
        model.analyze(frobnicate=1)
    with pytest.raises(TypeError):
        model.analyze(0.01)
    with pytest.raises(TypeError):
        seamwright.read(None)


def test_numbers_of_numpy_are_numbers(roof):
    import numpy

    model = seamwright.read(roof)
    assert model.analyze(
        angle_deg=numpy.float32(1.5), gap_mm=numpy.int64(1), jobs=numpy.int32(1)
    ).passed


def test_profiles_fill_in_what_is_not_given(box):
    assert list(seamwright.PROFILES) == ["default", "class-a", "vda"]
    model = seamwright.read(box)
    for name, figures in seamwright.PROFILES.items():
        found = model.analyze(profile=name).to_dict()["tolerance"]
        assert {key: found[key] for key in figures} == pytest.approx(figures, rel=1e-12)
    found = model.analyze(gap_mm=0.5, profile="class-a").to_dict()["tolerance"]
    assert (found["gap_mm"], found["angle_deg"]) == (0.5, pytest.approx(0.01, rel=1e-12))


def test_level_g3_and_matching_are_taken(box):
    report = seamwright.read(box).analyze(level="G3", match_mm=0.5)
    assert report.to_dict()["tolerance"]["level"] == "G3" and report.passed


def test_any_byte_in_the_name_of_a_file(tmp_path, box):
    path = os.fsencode(tmp_path) + b"/N\xe4ht.step"
    with open(path, "wb") as file:
        file.write(box.read_bytes())
    model = seamwright.read(os.fsdecode(path))
    assert os.fsencode(model.path) == path
    report = model.analyze()
    replaced = path.decode(errors="replace")
    assert report.to_dict()["model"]["path"] == replaced
    assert report.to_table().startswith(replaced) and replaced in report.to_csv()
    with pytest.raises(seamwright.ModelError, match="none.step"):
        seamwright.read(os.fsdecode(os.fsencode(tmp_path) + b"/\xe4none.step"))


def test_bad_models_are_model_errors_with_the_file(tmp_path):
    contents = {
        "empty.step": "",
        "text.step": "a letter",
        "cut.step": box_text()[:2000],
        "nounit.step": box_text(unit=""),
    }
    for name, content in contents.items():
        (tmp_path / name).write_text(content)
    for name in [*contents, "missing.step"]:
        with pytest.raises(seamwright.ModelError, match=name):
            seamwright.read(tmp_path / name)
    with pytest.raises(seamwright.ModelError, match="folder"):
        seamwright.read(tmp_path)


def test_progress_of_both(box):
    shares = []
    model = seamwright.read(box, progress=shares.append)
    model.analyze(progress=shares.append)
    assert shares and all(0 <= share <= 1 for share in shares) and shares[-1] == 1


@pytest.mark.parametrize("answer", [False, 0, 0.0, "", numpy.bool_(False), numpy.int64(0)])
def test_what_is_false_to_python_cancels(box, answer):
    with pytest.raises(seamwright.Cancelled):
        seamwright.read(box, progress=lambda share: answer)
    with pytest.raises(seamwright.Cancelled):
        seamwright.read(box).analyze(progress=lambda share: answer)


@pytest.mark.parametrize("answer", [None, True, 1, "0", numpy.bool_(True), numpy.float64(0.5)])
def test_none_and_what_is_true_go_on(box, answer):
    assert (
        seamwright.read(box, progress=lambda share: answer)
        .analyze(progress=lambda share: answer)
        .passed
    )


def test_an_answer_without_truth_raises_what_python_raises(box):
    with pytest.raises(ValueError, match="truth value of an array"):
        seamwright.read(box).analyze(progress=lambda share: numpy.zeros(2))


def test_what_progress_raises_comes_out(box):
    def bad(share):
        raise KeyError("from inside")

    with pytest.raises(KeyError, match="from inside"):
        seamwright.read(box, progress=bad)
    model = seamwright.read(box)
    with pytest.raises(KeyError, match="from inside"):
        model.analyze(progress=bad)


def slow_reader(tmp_path, monkeypatch):
    reader = tmp_path / "reader"
    reader.write_text("#!/bin/sh\nexec sleep 1\n")
    reader.chmod(0o755)
    monkeypatch.setenv("SEAMWRIGHT_READER", str(reader))


def test_other_threads_run_while_a_file_is_read(box, tmp_path, monkeypatch):
    slow_reader(tmp_path, monkeypatch)
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.01)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    with pytest.raises(seamwright.ModelError):
        seamwright.read(box)
    end = time.monotonic()
    done.set()
    thread.join()
    assert end - start > 0.8
    assert sum(start + 0.05 < t < end - 0.05 for t in ticks) > 20


def test_other_threads_run_while_seams_are_measured():
    """A counter in another thread moves on during one call that itself never returns to Python."""
    model = seamwright.read(installed(OCCT_DATA / "step/linkrods.step"))
    count, running = [0], [True]

    def work():
        while running[0]:
            count[0] += 1

    before = sys.getswitchinterval()
    thread = threading.Thread(target=work)
    thread.start()
    try:
        sys.setswitchinterval(1e-4)
        time.sleep(0.05)
        first = count[0]
        model.analyze(jobs=1)
        assert count[0] - first > 1000
    finally:
        running[0] = False
        thread.join()
        sys.setswitchinterval(before)


def test_ctrl_c_reaches_a_long_call(box, tmp_path, monkeypatch):
    import signal

    slow_reader(tmp_path, monkeypatch)
    threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        seamwright.read(box)
    assert time.monotonic() - start < 0.9


def test_verdicts_alone_are_those_of_all_figures():
    model = seamwright.read(installed(OCCT_DATA / "step/linkrods.step"))
    full, quick = model.analyze(level="G2"), model.analyze(level="G2", verdict_only=True)
    assert [(s["level"], s["class"], s["certified"]) for s in quick.seams] == [
        (s["level"], s["class"], s["certified"]) for s in full.seams
    ]
    with pytest.raises(ValueError, match="verdict_only"):
        model.analyze(verdict_only="yes")


def test_jobs_change_nothing():
    model = seamwright.read(installed(OCCT_DATA / "step/linkrods.step"))
    one = model.analyze(jobs=1).seams
    assert model.analyze(jobs=2).seams == one and model.analyze(jobs=8).seams == one


def test_names_and_colours():
    attributes = seamwright.read(installed(OCCT_DATA / "step/screw.step")).attributes
    for attribute in attributes:
        assert set(attribute) == {"kind", "index", "name", "color", "layers"}
        assert attribute["index"] >= 1
        assert attribute["color"] is None or all(0 <= part <= 1 for part in attribute["color"])


def test_without_freecad_the_bridge_says_so(box, monkeypatch):
    monkeypatch.setitem(sys.modules, "Part", None)
    with pytest.raises(RuntimeError, match="run inside FreeCAD"):
        seamwright.Model.from_freecad(object())
    with pytest.raises(RuntimeError, match="run inside FreeCAD"):
        seamwright.read(box).to_freecad()


def test_models_do_not_pile_up(box):
    """Memory after many analyses stays where it was."""
    import resource

    model = seamwright.read(box)
    for _ in range(50):
        model.analyze(jobs=1).to_dict()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(1500):
        model.analyze(jobs=1)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 20_000, "kB"
