# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command fill: what it writes, says and refuses."""

import json
import os
import re

import pytest

from command import READER, contents, expect_one_line, run
from models import OCCT_DATA, box_text, installed, reader_that_finds, roof_text, step_text
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("fill")


def fill(model, *options, out="out.step"):
    """The result, the report and the file written."""
    out, report = model.parent / out, model.parent / "fill.json"
    result = run("fill", model, "-o", out, "--json", report, "--overwrite", *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    assert (report["output"] is None) == (not report["filled"])
    return result, report, out


def analysis(path, *options):
    return json.loads(run("analyze", "--format", "json", *options, path).stdout)


def test_a_face_of_a_box_is_replaced_in_position(box):
    result, report, out = fill(box, "--face", "1", "--target", "G0")
    assert result.returncode == 0 and result.stderr == ""
    assert result.stdout.startswith("filled with 1 face;") and "REACHED G0" in result.stdout
    assert (
        report["filled"]
        and report["reached"]
        and report["sides"] == report["corners"] == report["inner"] == []
    )
    found = analysis(out)
    assert found["model"]["faces"] == report["output"]["faces"] == 6
    assert found["model"]["edges"] == report["output"]["edges"]
    assert found["summary"]["open_edges"] == report["output"]["open_edges"] == 0
    assert report["model"] == analysis(box)["model"]


def test_faces_are_named_as_analyze_names_them(box):
    by_number = fill(box, "--face", "3", "--target", "G0")[1]
    by_name = fill(box, "--face", "Face3", "--target", "G0")[1]
    for report in (by_number, by_name):
        del report["time_s"]
    assert by_name == by_number


def test_several_faces_leave_one_hole(box, tmp_path):
    faces = analysis(box)["seams"][0]["faces"]
    # Their hole has six corners, two of 270 degrees, and walls that no plane sees.
    report = fill(box, "--face", ",".join(map(str, faces)), "--target", "G0")[1]
    assert report["reason_code"] == "corner_above_180" and not report["filled"]
    assert report["removed_curvature_per_mm"] < 1e-9 and report["curvature_per_mm"] is None
    shell = tmp_path / "shell.brep"
    shell.write_bytes(installed(OCCT_DATA / "occ/shell1.brep").read_bytes())
    assert fill(shell, "--face", "Face64")[1]["reached"]


def test_every_key_of_the_report_matters(box):
    expect_every_key_matters(fill(box, "--face", "1", "--keep-anyway")[1], VALIDATOR)


def test_a_smooth_fill_of_a_real_shell(tmp_path):
    shell = tmp_path / "shell.brep"
    shell.write_bytes(installed(OCCT_DATA / "occ/shell1.brep").read_bytes())
    for out in ("out.step", "out.igs", "out.brep", "out.bin"):
        result, report, written = fill(shell, "--face", "64", out=out)
        assert result.returncode == 0, result.stdout + result.stderr
        assert report["output"]["defects"] == 0
        worst = [seam["angle_deg"]["upper"] for seam in report["outer"] + report["inner"]]
        assert report["largest_angle_deg"] == max(worst)
        seams = [
            seam
            for seam in analysis(written, "--angle", "0.01")["seams"]
            if set(seam["faces"]) & set(report["faces"])
        ]
        assert len(seams) == len(worst)
        assert all(
            seam["class"] == "smooth" for seam in seams
        ), "the file says what the report says"


def test_a_closed_solid_comes_out_closed_with_its_colours(tmp_path):
    text = box_text()
    box = tmp_path / "box.step"
    face = text.index("ADVANCED_FACE")
    number = text[text.rindex("#", 0, face) : face].rstrip("=")
    colour = (
        f"#9001=STYLED_ITEM('',(#9002),{number});#9002=PRESENTATION_STYLE_ASSIGNMENT((#9003));"
        "#9003=SURFACE_STYLE_USAGE(.BOTH.,#9004);"
        "#9004=SURFACE_SIDE_STYLE('',(#9005));#9005=SURFACE_STYLE_FILL_AREA(#9006);"
        "#9006=FILL_AREA_STYLE('',(#9007));"
        "#9007=FILL_AREA_STYLE_COLOUR('',#9008);#9008=COLOUR_RGB('',1.,0.,0.);"
    )
    box.write_text(text.replace("ENDSEC;\nEND-ISO", colour + "\nENDSEC;\nEND-ISO"))
    result, report, out = fill(box, "--face", "6", "--target", "G0")
    assert result.returncode == 0 and result.stderr == ""
    written = out.read_text()
    assert written.count("MANIFOLD_SOLID_BREP(") == 1 and "OPEN_SHELL" not in written
    assert written.count("COLOUR_RGB(") + written.count("DRAUGHTING_PRE_DEFINED_COLOUR(") >= 1
    assert report["output"]["open_edges"] == 0


def test_a_filled_solid_keeps_its_name(tmp_path):
    box = tmp_path / "box.step"
    box.write_text(re.sub(r"PRODUCT\('[^']*','[^']*'", "PRODUCT('Bracket','Bracket'", box_text()))
    _, report, out = fill(box, "--face", "6", "--target", "G0")
    assert report["filled"] and re.search(r"PRODUCT\('Bracket'", out.read_text())


def test_the_table_has_the_figures_of_every_seam(tmp_path):
    shell = tmp_path / "shell.brep"
    shell.write_bytes(installed(OCCT_DATA / "occ/shell1.brep").read_bytes())
    for target in ("G0", "G1", "G2"):
        result, report, _ = fill(shell, "--face", "64", "--target", target, "--keep-anyway")
        seams = report["outer"] + report["inner"]
        worst = max(seam["curvature_rel"]["upper"] for seam in seams)
        assert report["largest_curvature_rel"] == worst
        assert f"curvature {100 * worst:.3g} %" in result.stdout.splitlines()[0]
        jump = report["curvature_jump_per_mm"]
        assert jump is None if target == "G0" else 0 < jump < 0.1
        rows = [line for line in result.stdout.splitlines() if line.startswith(("met ", "missed "))]
        assert {row.split()[1] for row in rows} == {
            f"Edge{seam['edges'][0]}" for seam in seams
        } and len(rows) == len(seams)
        missed = sum(line.startswith("missed ") for line in rows)
        assert missed == report["output"]["defects"] and all(
            line.startswith("missed ") for line in rows[:missed]
        )


def test_all_faces_leave_no_hole(box):
    result, report, _ = fill(box, "--face", "1,2,3,4,5,6")
    assert report["reason_code"] == "only_face" and not report["filled"]
    assert "the 6 faces are all of the model: a fill needs others around it" in result.stdout


def test_faces_in_a_reason_are_those_of_the_given_model(box):
    """Beside face k of a box are all faces but k and the one opposite."""
    opposite = {1: 2, 2: 1, 3: 5, 5: 3, 4: 6, 6: 4}
    for face in opposite:
        result, report, _ = fill(box, "--face", str(face))
        beside = {f"face {other}" for other in range(1, 7) if other not in (face, opposite[face])}
        assert report["reason"].startswith("a seam between face ")
        assert report["reason_code"] == "misses_target"
        assert report["reason"].split(" and the fill")[0].removeprefix("a seam between ") in beside
        assert set(re.findall(r"(face \d), the fill ", result.stdout)) == beside
        edges = {seam["edges"][0] for seam in analysis(box)["seams"] if face in seam["faces"]}
        assert {edge for side in report["sides"] for edge in side["edges"]} == edges


def test_holes_of_one_size_are_distinguished(tmp_path):
    """A box without its ends: the list names holes as --hole takes them, with where they are."""
    points = [(x, y, z) for z in (0, 30) for x, y in ((0, 0), (10, 0), (10, 20), (0, 20))]
    tube = tmp_path / "tube.step"
    tube.write_text(
        step_text(points, [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]], closed=False)
    )
    listed = run("fill", tube, "-o", tmp_path / "out.step", "--target", "G0")
    expect_one_line(
        listed, "has 2 holes, name one with --hole; Hole1: 4 sides, 60 mm around (5, 10, "
    )
    places = dict(re.findall(r"(Hole\d): 4 sides, 60 mm around \(5, 10, (\d+)\)", listed.stderr))
    assert sorted(places.values()) == ["0", "30"]
    for name, place in places.items():
        written = fill(tube, "--hole", name, "--target", "G0")[2]
        (hole,) = re.findall(
            r"around \((.*?)\)",
            run("fill", written, "-o", tmp_path / "o.step", "--hole", "9").stderr,
        )
        assert hole == f"5, 10, {30 - int(place)}"


def test_what_can_not_be_smooth_is_not_written(box):
    result, report, out = fill(box, "--face", "1")
    assert result.returncode == 1
    assert "NOT REACHED G1" in result.stdout and "90 degrees" in result.stdout
    assert not out.exists() and report["output"] is None and "90 degrees" in report["reason"]
    assert report["reason_code"] == "misses_target"
    (cause,) = report["causes"]
    assert cause["code"] == "position_only" and cause["point_mm"] is None
    assert cause["numbers"] == {"turn_deg": pytest.approx(90)}
    assert set(cause["edges"]) <= {edge for side in report["sides"] for edge in side["edges"]}
    result, report, out = fill(box, "--face", "1", "--keep-anyway")
    assert result.returncode == 1 and out.exists()
    assert report["output"]["defects"] == sum(
        seam["angle_deg"]["lower"] > 0.01 for seam in report["outer"] + report["inner"]
    )


def test_the_verdict_is_on_the_file_too(box, tmp_path):
    other, out, report = tmp_path / "other.step", tmp_path / "out.step", tmp_path / "out.json"
    other.write_text(roof_text(1))
    result = run(
        "fill",
        box,
        "-o",
        out,
        "--json",
        report,
        "--face",
        "1",
        "--target",
        "G0",
        reader=reader_that_finds(other, tmp_path, READER),
    )
    assert result.returncode == 1, result.stderr
    found = json.loads(report.read_text())
    expect_valid(found, VALIDATOR)
    assert found["reached"] and found["output"]["faces"] == 2 and found["output"]["open_edges"] == 6
    assert (
        f"{out} read back: 2 faces, 7 edges, 6 free edges, 1 seam; the model in memory has 6, "
        in result.stdout
    )
    assert (
        result.stderr.startswith(f"seamwright: warning: {out}: read back: ")
        and result.stderr.count("\n") == 1
    )


def test_what_cannot_be_read_back_is_not_written(box, tmp_path):
    reader = reader_that_finds(tmp_path / "none.step", tmp_path, READER)
    before = contents(tmp_path)
    expect_one_line(
        run(
            "fill", box, "-o", tmp_path / "out.step", "--face", "1", "--target", "G0", reader=reader
        ),
        "out.step: can't be read back",
    )
    assert contents(tmp_path) == before


@pytest.mark.parametrize(
    "options, message",
    [
        (["--face", "7"], "face 7: the model has faces 1 to "),
        ([], "has no hole"),
        (["--face", "1", "--hole", "1"], "excludes"),
        (["--face", "0"], "--face: invalid Face number '0': numbers start at 1 (see "),
        (["--face", "Face-1"], "invalid Face number 'Face-1': numbers start at 1"),
        (["--hole", "0"], "--hole: invalid Hole number '0': numbers start at 1 (see "),
        (["--hole", "Hole1"], "has no hole"),
        (["--hole", "Face1"], "invalid Hole number 'Face1': give for example 39 or Hole39"),
        (["--face", "1", "--angle", "0"], "angle tolerance is 0 deg: a fill needs more"),
        (["--face", "1", "--angle", "0", "--target", "G0"], "angle tolerance is 0 deg"),
        (["--face", ""], "invalid Face number '': give for example 39 or Face39"),
        (["--face", "Edge3"], "invalid Face number 'Edge3'"),
        (["--face", "1", "--target", "G3"], "--target"),
        (["--face", "1", "--gap", "nan"], "--gap: nan"),
        (["--face", "1", "--corner", ""], "--corner: '' is not a number"),
        (["--face", "1", "--curvature", "-0.5"], "-0.5"),
        (["--face", "1,Face1"], "face 1 is given twice"),
        (["--face", "1,1", "--repair-first"], "face 1 is given twice"),
        (["--face", "3000000000"], "--face: 3000000000 is too large: at most 2147483647"),
        (["--face", "-3000000000"], "numbers start at 1"),
        (["--face", "1", "--corner", "180"], "180 degrees: it must be above 0 and below 180"),
        (["--face", "1", "--gap", "1e-15"], "the rounding of this model's coordinates"),
        (["--face", "1", "--gap", "1e-15", "--repair-first"], "the rounding of this model's"),
    ],
)
def test_bad_usage(box, tmp_path, options, message):
    expect_one_line(run("fill", box, "-o", tmp_path / "out.step", *options), message)
    assert not (tmp_path / "out.step").exists()


def test_nothing_is_replaced_by_a_slip_of_the_hand(box, tmp_path):
    old = tmp_path / "old.step"
    old.write_text("old")
    options = ["--face", "1", "--target", "G0"]
    expect_one_line(run("fill", box, "-o", old, *options), "use --overwrite or")
    expect_one_line(run("fill", box, "-o", box, *options), "use --overwrite-source")
    expect_one_line(
        run("fill", box, "-o", tmp_path / "out.step", "--json", old, *options),
        "has the name of a model",
    )
    assert old.read_text() == "old" and sorted(os.listdir(tmp_path)) == ["box.step", "old.step"]
    assert run("fill", box, "-o", old, "--overwrite", *options).returncode == 0
