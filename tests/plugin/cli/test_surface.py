# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands blend and extend: what they write, say and refuse."""

import json
import math

import pytest

from command import expect_one_line, run
from patches import SIZE, point_and_normal, sheet_text, surfaces_of
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("blend_surface")
RIGHT, LEFT = "Edge6", "Edge4"  # of the left patch, of the right patch: they face each other


@pytest.fixture
def gap(tmp_path):
    """A smooth sheet of three patches without the middle one."""
    path = tmp_path / "gap.step"
    path.write_text(sheet_text(3, 1, noise_mm=0, without={(1, 0)}))
    return path


@pytest.fixture
def hole(tmp_path):
    """A smooth sheet of nine patches without the one in the middle."""
    path = tmp_path / "hole.step"
    path.write_text(sheet_text(3, 3, noise_mm=0, without={(1, 1)}))
    return path


def made(command, model, *options, out="out.step"):
    """The result, the report and the file written."""
    out, report = model.parent / out, model.parent / "surface.json"
    result = run(command, model, "-o", out, "--json", report, "--overwrite", *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    return result, report, out


def blend(model, *options, out="out.step"):
    return made("blend", model, "--start", RIGHT, "--end", LEFT, *options, out=out)


@pytest.mark.parametrize("out", ["out.step", "out.igs", "out.brep", "out.bin"])
def test_a_blend_joins_both_sides(gap, out):
    result, report, written = blend(gap, "--start-order", "G3", "--end-order", "G1", out=out)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "REACHED: every seam has the level of its end" in result.stdout
    assert f"{written}: {report['output']['format']}\n" in result.stdout
    assert [side["side"] for side in report["sides"]] == ["start", "end"]
    assert report["fold"] is None and not any(side["reason"] for side in report["sides"])
    assert not any(seam["note"] for seam in report["seams"])
    assert [(seam["target"], seam["level"]) for seam in report["seams"]] == [
        ("G3", "G3"),
        ("G1", "G1"),
    ]
    assert report["surface"]["degrees"] == [5, 3 + 1 + 1]
    analysis = json.loads(
        run("analyze", "--format", "json", "--match", "0.02", written).stdout
    )
    assert analysis["model"]["faces"] == 3 == report["output"]["faces"]
    assert sorted(seam["faces"] for seam in analysis["seams"]) == [[1, 3], [2, 3]]
    assert analysis["summary"]["defects"] == 0 == report["output"]["defects"]


def test_the_surface_fills_the_gap_of_the_sheet(gap):
    text = blend(gap)[2].read_text()
    (place,) = [key for key in surfaces_of(text) if key[0] == 1]
    surface = surfaces_of(text)[place]
    whole = surfaces_of(sheet_text(3, 1, noise_mm=0))[1, 0]
    for k in range(11):
        point = point_and_normal(surface, k / 10, 0.5)[0]
        # The middle patch is plane but for small heights, which its parameters measure.
        wanted = point_and_normal(whole, point[0] / SIZE - 1, point[1] / SIZE)[0]
        assert abs(point[2] - wanted[2]) < 0.05


def test_an_extension_has_its_length_and_order(gap):
    result, report, written = made("extend", gap, "--edge", RIGHT, "--length", "5")
    assert result.returncode == 0, result.stdout + result.stderr
    assert [seam["target"] for seam in report["seams"]] == ["G2"]
    surfaces = surfaces_of(written.read_text()).values()
    (new,) = (surface for surface in surfaces if surface["degrees"] == (5, 2))
    for k in range(5):
        line = [point_and_normal(new, k / 4, i / 200)[0] for i in range(201)]
        assert abs(sum(map(math.dist, line, line[1:])) - 5) < 1e-3


def test_the_end_may_be_flipped(gap):
    result, report, _ = blend(gap, "--flip", "--keep-anyway")
    straight = blend(gap, "--keep-anyway")[1]
    assert report["surface"]["degrees"] == straight["surface"]["degrees"]
    # Lines across all cross halfway.
    assert result.returncode == 1 and straight["reached"] and not report["reached"]
    assert "the surface runs through itself" in report["sides"][1]["reason"]
    assert "the surface runs through itself" in result.stdout


def across_the_hole(hole, *options):
    """The edges on its sides x = 20 and x = 40, and lateral ones y = 20 and y = 40."""
    return made(
        "blend", hole, "--start", "Edge5", "--end", "Edge22", "--lateral", "Edge13,Edge14", *options
    )


@pytest.mark.parametrize("order", ["G0", "G1", "G2"])
def test_lateral_boundaries_run_along_edges(hole, order):
    result, report, written = across_the_hole(hole, "--lateral-order", order)
    assert result.returncode == 0, result.stdout + result.stderr
    assert [boundary["edges"] for boundary in report["laterals"]] == [[13], [14]]
    for boundary in report["laterals"]:
        assert boundary["target"] == order and boundary["reason"] == ""
        assert 0 <= boundary["distance_mm"] < 0.01
        assert boundary["covered_mm"] == pytest.approx(boundary["length_mm"], rel=1e-3)
    assert "lateral boundary along Edge13: at most " in result.stdout
    assert sorted(seam["target"] for seam in report["seams"]) == sorted(["G2", "G2", order, order])
    # The surface is the patch that is missing, nearly.
    whole = surfaces_of(sheet_text(3, 3, noise_mm=0))[1, 1]
    surfaces = surfaces_of(written.read_text()).values()
    (made_one,) = [surface for surface in surfaces if surface["degrees"][0] == 5]
    for k in range(11):
        for i in range(11):
            x, y, z = point_and_normal(made_one, k / 10, i / 10)[0]
            u, v = (min(max(at / SIZE - 1, 0), 1) for at in (x, y))
            wanted = point_and_normal(whole, u, v)[0]
            assert abs(z - wanted[2]) < 0.05
    analysis = json.loads(
        run("analyze", "--format", "json", "--match", "0.02", "--level", order, written).stdout
    )
    matched = [seam for seam in analysis["seams"] if 9 in seam["faces"]]
    assert len(matched) == 4 and all(seam["level"] >= order for seam in matched)


def test_every_key_of_the_report_matters(gap, hole):
    expect_every_key_matters(blend(gap)[1], VALIDATOR)
    expect_every_key_matters(across_the_hole(hole)[1], VALIDATOR)


def test_what_falls_short_is_not_written(gap):
    options = ["--angle", "1e-13"]
    result, report, out = blend(gap, *options)
    assert result.returncode == 1 and "NOT REACHED" in result.stdout
    assert not out.exists() and report["output"] is None and not report["reached"]
    result, report, out = blend(gap, *options, "--keep-anyway")
    assert result.returncode == 1 and out.exists() and report["output"]["defects"] > 0


@pytest.mark.parametrize(
    "command, options, message",
    [
        ("blend", ["--start", "1"], "--end"),
        ("blend", ["--start", "99", "--end", "1"], "start: edge 99"),
        ("blend", ["--start", "Face1", "--end", "1"], "invalid Edge number 'Face1'"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--start-order", "G4"], "--start-order"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--end-tension", "0"], "--end-tension: 0"),
        (
            "blend",
            ["--start", RIGHT, "--end", LEFT, "--start-faces", "7"],
            "edge 6 does not bound face 7",
        ),
        ("blend", ["--start", RIGHT, "--end", RIGHT], "edge 6 is in start and in end"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--lateral", "7"], "gap_mm = 20"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--lateral", "Face1"], "'Face1'"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--lateral-order", "G3"], "--lateral-order"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--lateral-order", ""], "an order is needed"),
        (
            "blend",
            ["--start", RIGHT, "--end", LEFT, "--lateral-order", "6=G1,Edge6=G1"],
            "edge 6 has two orders",
        ),
        (
            "blend",
            ["--start", RIGHT, "--end", LEFT, "--lateral-order", "6=G1,G2"],
            "'G2' is neither",
        ),
        (
            "blend",
            ["--start", RIGHT, "--end", LEFT, "--lateral-faces", "1"],
            "lateral faces or a lateral order need lateral edges",
        ),
        ("blend", ["--start", RIGHT, "--end", "7"], "start and end meet at "),
        ("extend", ["--edge", "6,6", "--length", "1"], "side: edge 6 is given twice"),
        ("blend", ["--start", "5,6", "--end", LEFT], "start: the side has a corner of "),
        ("extend", ["--edge", "5,6,7,8", "--length", "1"], "side: the side has a corner of "),
        ("extend", ["--edge", RIGHT, "--length", "1e300"], "or the length is too large"),
        ("extend", ["--edge", RIGHT], "--length"),
        ("extend", ["--edge", RIGHT, "--length", "1", "--to", "2"], "--to"),
        ("extend", ["--edge", RIGHT, "--to", "2"], "does not meet face 2 within "),
        ("extend", ["--edge", RIGHT, "--to", "9"], "face 9"),
        ("extend", ["--edge", RIGHT, "--length", "-1"], "--length: -1 must be larger than zero"),
        ("extend", ["--edge", RIGHT, "--length", "5", "--order", "G0"], "--order"),
        ("blend", ["--start", RIGHT, "--end", LEFT, "--gap", "1e-15"], "gap tolerance is 1e-15 mm"),
        ("extend", ["--edge", RIGHT, "--to", "2", "--gap", "1e-15"], "gap tolerance is 1e-15 mm"),
        ("extend", ["--edge", RIGHT, "--length", "5", "--gap", "1e-15"], "the rounding of this"),
    ],
)
def test_bad_arguments_are_refused_in_one_line(gap, command, options, message):
    out = gap.parent / "out.step"
    result = run(command, gap, "-o", out, *options)
    expect_one_line(result, message)
    assert not out.exists()
