# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command corner: what it writes, says and refuses."""

import json
import os

import pytest

from command import expect_one_line, run
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("corner")


def corner(model, *options, out="out.step"):
    """The result, the report and the file written."""
    out, report = model.parent / out, model.parent / "corner.json"
    result = run("corner", model, "-o", out, "--json", report, "--overwrite", *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    return result, report, out


def analysis(path):
    return json.loads(run("analyze", "--format", "json", path).stdout)


@pytest.mark.parametrize("out", ["out.step", "out.igs", "out.brep", "out.bin"])
def test_a_corner_of_a_box_is_rounded(box, out):
    result, report, written = corner(box, "--vertex", "Vertex1", "--radius", "0.1,0.2,0.3", out=out)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "REACHED G1" in result.stdout and "24 new seams" in result.stdout
    assert sorted(edge["radius_mm"] for edge in report["edges"]) == [0.1, 0.2, 0.3]
    found = analysis(written)
    assert found["model"]["faces"] == report["output"]["faces"] == 6 + 3 + 6
    assert found["summary"]["open_edges"] == found["summary"]["defects"] == 0
    assert len(report["faces"]) == 9
    smooth = {tuple(seam["edges"]) for seam in found["seams"] if seam["class"] == "smooth"}
    assert len(smooth) == len(report["seams"])


def test_one_radius_is_that_of_all_edges(box):
    one = corner(box, "--vertex", "1", "--radius", "0.2")[1]
    three = corner(box, "--vertex", "1", "--radius", "0.2,0.2,0.2", "--setback", "0.3")[1]
    assert {edge["radius_mm"] for edge in one["edges"]} == {0.2}
    assert [edge["setback_mm"] for edge in three["edges"]] == pytest.approx([0.3] * 3)


def test_a_setback_of_zero_is_chosen(box):
    chosen = corner(box, "--vertex", "1", "--radius", "0.2")[1]["edges"]
    some = corner(box, "--vertex", "1", "--radius", "0.2", "--setback", "0,0.5,0")[1]["edges"]
    assert sorted(edge["setback_mm"] for edge in some) == pytest.approx(
        [chosen[0]["setback_mm"]] * 2 + [0.5]
    )
    assert min(some, key=lambda edge: edge["edge"])["setback_mm"] != 0.5


def test_an_angle_above_that_of_creases_is_understood(box):
    assert corner(box, "--vertex", "1", "--radius", "0.2", "--angle", "8")[0].returncode == 0


def test_radii_go_round_from_the_edge_with_the_smallest_number(box):
    report = corner(box, "--vertex", "1", "--radius", "0.1,0.2,0.3")[1]
    edges = {edge["edge"]: edge["radius_mm"] for edge in report["edges"]}
    order = [edge["edge"] for edge in report["edges"]]
    start = order.index(min(order))
    assert [edges[edge] for edge in order[start:] + order[:start]] == [0.1, 0.2, 0.3]


def test_every_key_of_the_report_matters(box):
    expect_every_key_matters(corner(box, "--vertex", "1", "--radius", "0.2")[1], VALIDATOR)


def test_what_falls_short_is_not_written(box):
    options = ["--vertex", "1", "--radius", "0.2", "--angle", "1e-9", "--patches-only"]
    result, report, out = corner(box, *options)
    assert result.returncode == 1 and "NOT REACHED G1: a seam between a patch and " in result.stdout
    assert not out.exists() and report["output"] is None and not report["met"]
    result, report, out = corner(box, *options, "--keep-anyway")
    assert result.returncode == 1 and out.exists() and report["output"]["defects"] > 0


def test_where_patches_have_no_room_opencascade_fills_and_is_named(box):
    options = ["--vertex", "1", "--radius", "8"]
    result, report, out = corner(box, *options)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "filled by OpenCASCADE, worst angle " in result.stdout
    assert "; not by patches: edge " in result.stdout and "REACHED G1" in result.stdout
    assert report["filled_by"] == "opencascade" and report["regular"] is None
    assert report["patches_shortfall"].endswith("would have room")
    assert report["patches_shortfall_code"] == "setback_too_large"
    assert [edge["setback_mm"] for edge in report["edges"]] == [None] * 3
    # Three cylinders and an octant of a sphere, with six contacts and three sections.
    assert len(report["faces"]) == 4 and len(report["seams"]) == 9
    assert analysis(out)["summary"]["defects"] == 0
    patched = corner(box, "--vertex", "1", "--radius", "0.2")
    assert patched[1]["filled_by"] == "patches" and "filled by patches\n" in patched[0].stdout
    refused = run("corner", box, "-o", out.parent / "no.step", *options, "--patches-only")
    expect_one_line(refused, "would have room")


@pytest.mark.parametrize(
    "options, message",
    [
        (["--radius", "0.2"], "--vertex"),
        (["--vertex", "1"], "--radius"),
        (["--vertex", "9", "--radius", "0.2"], "vertex 9: the model has vertices 1 to 8"),
        (
            ["--vertex", "0", "--radius", "0.2"],
            "--vertex: invalid Vertex number '0': numbers start at 1 (see ",
        ),
        (["--vertex", "Edge1", "--radius", "0.2"], "invalid Vertex number 'Edge1'"),
        (
            ["--vertex", "1", "--radius", "0.2,0.3"],
            "--radius has 2 lengths: one for all edges is needed, or one for each of Edge1",
        ),
        (["--vertex", "1", "--radius", "0.2", "--setback", "1,2"], "--setback has 2 lengths"),
        (["--vertex", "1", "--radius", "0"], "--radius: 0 must be larger than zero"),
        (["--vertex", "1", "--radius", "nan"], "--radius: nan"),
        (["--vertex", "1", "--radius", "0.2,,0.3"], "--radius: '' is not a number"),
        (
            ["--vertex", "1", "--radius", "0.2", "--setback", "-1"],
            "--setback: -1 must not be negative",
        ),
        *(
            ([*("--vertex", "1", "--radius", "0.2"), option, "1"], option)
            for option in ("--curvature", "--crease", "--flat-radius")
        ),
        (["--vertex", "1", "--radius", "20"], "before it begins on one side"),
        (["--vertex", "1", "--radius", "wide"], "wide"),
        (["--vertex", "1", "--radius", "0.2", "--gap", "1e-15"], "gap tolerance is 1e-15 mm"),
    ],
)
def test_bad_usage(box, tmp_path, options, message):
    expect_one_line(run("corner", box, "-o", tmp_path / "out.step", *options), message)
    assert os.listdir(tmp_path) == ["box.step"]
