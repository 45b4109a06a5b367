# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command fill: what it writes, says and refuses."""

import json

import pytest

from command import run
from models import box_text


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path


def test_a_face_of_a_box_is_replaced_in_position(box, tmp_path):
    out, report = tmp_path / "out.step", tmp_path / "fill.json"
    result = run("fill", box, "-o", out, "--face", "1", "--target", "G0", "--json", report)
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith("filled with 4 faces") and "REACHED G0" in result.stdout
    fill = json.loads(report.read_text())
    assert fill["filled"] and fill["reached"] and all(side["position_only"] for side in fill["sides"])
    analysis = json.loads(run("analyze", "--format", "json", out).stdout)
    assert analysis["model"]["faces"] == 9


def test_what_can_not_be_smooth_is_not_written(box, tmp_path):
    out = tmp_path / "out.step"
    result = run("fill", box, "-o", out, "--face", "1")
    assert result.returncode == 1
    assert "NOT REACHED G1" in result.stdout and "90 degrees" in result.stdout
    assert not out.exists()
    assert run("fill", box, "-o", out, "--face", "1", "--keep-anyway").returncode == 1
    assert out.exists()


@pytest.mark.parametrize(
    "options, message",
    [
        (["--face", "7"], "no face 7"),
        ([], "has no hole"),
        (["--face", "1", "--hole", "1"], "excludes"),
        (["--face", "0"], "--face"),
        (["--face", "1", "--target", "G3"], "--target"),
        (["--face", "1", "--gap", "nan"], "nan"),
    ],
)
def test_bad_usage(box, tmp_path, options, message):
    result = run("fill", box, "-o", tmp_path / "out.step", *options)
    assert result.returncode == 2
    assert message in result.stderr and not (tmp_path / "out.step").exists()
