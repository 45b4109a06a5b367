# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command match: the seams that it makes, by plain evaluation of the file, and refusals."""

import json

import pytest

from command import contents, expect_one_line, run
from patches import seam_figures, sheet_text, surfaces_of
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("match")
SHARED = "Edge2"  # of the left patch and the right one


@pytest.fixture
def sheet(tmp_path):
    """Two patches that meet in one edge with an angle."""
    path = tmp_path / "sheet.step"
    path.write_text(sheet_text(2, 1, noise_mm=0.2))
    return path


def match(model, *options, face=1, side=SHARED, out="out.step"):
    out, report = model.parent / out, model.parent / "match.json"
    arguments = ["--face", face, "--side", side, "-o", out, "--json", report, "--overwrite"]
    result = run("match", model, *arguments, *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    return result, report, out


@pytest.mark.parametrize("target", ["G1", "G2"])
def test_a_face_meets_its_neighbour(sheet, target):
    before = surfaces_of(sheet.read_text())
    assert seam_figures(before, (0, 0))[0][1] > 0.5
    result, report, out = match(sheet, "--target", target)
    assert result.returncode == 0, result.stdout + result.stderr
    assert report["matched"] and report["reason_code"] in ("", None)
    after = surfaces_of(out.read_text())
    gap_mm, angle_deg = seam_figures(after, (0, 0))[0]
    assert gap_mm < 1e-3 and angle_deg < 0.1
    assert after[1, 0] == before[1, 0]
    analysis = json.loads(run("analyze", "--format", "json", "--level", target, out).stdout)
    (seam,) = analysis["seams"]
    assert seam["level"] >= target and seam["certified"]
    assert [item["after"]["level"] >= target for item in report["seams"]] == [True]


def test_the_depth_bounds_the_change(sheet):
    result, report, out = match(sheet, "--depth", "8")
    assert result.returncode == 0, result.stdout + result.stderr
    assert 0 < report["depth_mm"] <= 8
    before, after = surfaces_of(sheet.read_text())[0, 0], surfaces_of(out.read_text())[0, 0]
    assert after["poles"][0] == pytest.approx(before["poles"][0])


def test_reports_notice_what_is_wrong(sheet):
    expect_every_key_matters(match(sheet)[1], VALIDATOR)


def test_what_falls_short_is_not_written(sheet):
    result, report, out = match(sheet, "--angle", "1e-13")
    assert result.returncode == 1 and not report["matched"] and report["reason"]
    assert report["remedy"]
    assert not out.exists()


@pytest.mark.parametrize(
    "side, said",
    [
        ("x", "--side 'x'"),
        ("2@0.5", "--side '2@0.5'"),
        ("2:3:4", "--side '2:3:4'"),
        ("99", "edge 99"),
        ("6", "edge 6"),  # of the other face
        ("2@0.7-0.2", "0.7"),
    ],
)
def test_sides_that_are_none(sheet, side, said):
    kept = contents(sheet.parent)
    out = sheet.parent / "out.step"
    expect_one_line(run("match", sheet, "-o", out, "--face", "1", "--side", side), said)
    assert contents(sheet.parent) == kept


def test_faces_that_are_none(sheet):
    out = sheet.parent / "out.step"
    expect_one_line(run("match", sheet, "-o", out, "--face", "3", "--side", "2"), "face 3")


@pytest.mark.parametrize("option, name", [("--gap", "gap tolerance"), ("--match", "distance to")])
def test_lengths_below_the_rounding_of_coordinates(sheet, option, name):
    out = sheet.parent / "out.step"
    result = run("match", sheet, "-o", out, "--face", "1", "--side", "2", option, "1e-15")
    expect_one_line(result, name)
    assert "the rounding of this model's coordinates" in result.stderr
