# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models written from Python."""

import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import time

import pytest

import seamwright

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))
from models import OCCT_DATA, box_text, installed  # noqa: E402
from seeds import seed_of_test  # noqa: E402

FORMATS = {
    "a.step": "STEP",
    "a.STP": "STEP",
    "a.igs": "IGES",
    "a.iges": "IGES",
    "a.brep": "BREP",
    "a.brp": "BREP",
    "a.bin": "binary BREP",
}


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return seamwright.read(path)


def facts(model):
    return model.face_count, model.edge_count, model.attributes, model.length_unit


def verdicts(model):
    """Faces, level, class and length of each seam."""
    return [
        (seam["faces"], seam["level"], seam["class"], round(seam["length_mm"], 6))
        for seam in model.analyze().seams
    ]


def test_the_accuracy_of_the_source_is_stated(box, tmp_path):
    box.write(tmp_path / "a.step")
    text = (tmp_path / "a.step").read_text().replace("\n", "")
    stated = re.search(r"UNCERTAINTY_MEASURE_WITH_UNIT\(LENGTH_MEASURE\(([^)]*)\)", text)
    assert float(stated[1]) == pytest.approx(1e-7)


def test_every_format(box, tmp_path):
    for name, format in FORMATS.items():
        report = box.write(tmp_path / name)
        assert report["format"] == format and report["changed_faces"] == 0
        assert report["followed_source"] is (format in ("STEP", "IGES"))
        back = seamwright.read(tmp_path / name)
        assert (back.format, back.face_count, back.edge_count) == (format, 6, 12)
        assert verdicts(back) == verdicts(box)


def test_real_files_come_back(tmp_path):
    for name in ("step/screw.step", "step/linkrods.step"):
        model = seamwright.read(installed(OCCT_DATA / name))
        report = model.write(tmp_path / "out.step", overwrite=True)
        assert report == {
            "format": "STEP",
            "followed_source": True,
            "changed_faces": 0,
            "changed_edges": 0,
            "changed_vertices": 0,
            "notes": [],
        }
        back = seamwright.read(tmp_path / "out.step")
        assert facts(back) == facts(model)
        assert verdicts(back) == verdicts(model)


def test_attributes_tell_layers(box):
    assert all(
        set(entry) == {"kind", "index", "name", "color", "layers"} for entry in box.attributes
    )


def test_from_memory(box, tmp_path):
    memory = seamwright.bridge._core._model_from_binary(
        seamwright.bridge._core._binary_from_model(box)
    )
    assert memory.path == ""
    report = memory.write(tmp_path / "memory.step")
    assert report["followed_source"] is False
    assert verdicts(seamwright.read(tmp_path / "memory.step")) == verdicts(box)


def test_refusals_name_the_file(box, tmp_path):
    before = (tmp_path / "box.step").read_bytes()
    (tmp_path / "old.step").write_text("old")
    for path, words in (
        ("a.stl", "not a known extension"),
        ("a", "not a known extension"),
        ("none/a.step", "no folder"),
        ("old.step", "overwrite"),
        ("box.step", "overwrite_source"),
    ):
        with pytest.raises(seamwright.ModelError) as error:
            box.write(tmp_path / path)
        assert words in str(error.value) and str(tmp_path / path) in str(error.value)
    with pytest.raises(seamwright.ModelError, match="overwrite_source"):
        box.write(tmp_path / "box.step", overwrite=True)
    with pytest.raises(TypeError):
        box.write(tmp_path / "old.step", True)
    assert sorted(os.listdir(tmp_path)) == ["box.step", "old.step"]
    assert (tmp_path / "box.step").read_bytes() == before and (
        tmp_path / "old.step"
    ).read_text() == "old"
    box.write(tmp_path / "old.step", overwrite=True)
    box.write(tmp_path / "box.step", overwrite_source=True)
    assert (
        facts(seamwright.read(tmp_path / "old.step"))
        == facts(seamwright.read(tmp_path / "box.step"))
        == facts(box)
    )


def test_a_source_that_is_gone(box, tmp_path):
    (tmp_path / "box.step").unlink()
    with pytest.raises(seamwright.ModelError, match="box.step"):
        box.write(tmp_path / "out.step")
    assert os.listdir(tmp_path) == []
    assert box.write(tmp_path / "out.step", afresh=True)["followed_source"] is False
    assert seamwright.read(tmp_path / "out.step").face_count == 6


def test_progress_rises_and_cancels(box, tmp_path):
    shares = []
    box.write(tmp_path / "a.step", progress=lambda share: shares.append(share))
    assert shares == sorted(shares) and 0 <= shares[0] and shares[-1] == 1
    with pytest.raises(seamwright.Cancelled):
        box.write(tmp_path / "b.step", progress=lambda share: False)
    with pytest.raises(ZeroDivisionError):
        box.write(tmp_path / "b.step", progress=lambda share: 1 / 0)
    assert sorted(os.listdir(tmp_path)) == ["a.step", "box.step"]


WRITER = """
import sys, seamwright
models = [seamwright.read(path) for path in sys.argv[2:]]
print("ready", flush=True)
while True:
    for model in models:
        model.write(sys.argv[1], overwrite=True)
"""


def test_killed_at_any_moment(box, tmp_path):
    """The target is whole after each kill, and one of the two models."""
    other = tmp_path / "screw.step"
    other.write_bytes(installed(OCCT_DATA / "step/screw.step").read_bytes())
    target = tmp_path / "folder" / "target.brep"
    target.parent.mkdir()
    contents = set()
    for model in (box, seamwright.read(other)):
        model.write(target, overwrite=True)
        contents.add(target.read_bytes())
    moments = random.Random(seed_of_test())
    for _ in range(6):
        command = [sys.executable, "-c", WRITER, str(target), box.path, str(other)]
        with subprocess.Popen(command, stdout=subprocess.PIPE) as writer:
            assert writer.stdout.readline() == b"ready\n"
            time.sleep(moments.uniform(0, 0.03))
            writer.send_signal(signal.SIGKILL)
        assert target.read_bytes() in contents
        assert all(
            name == "target.brep" or name.endswith(".part") for name in os.listdir(target.parent)
        )
