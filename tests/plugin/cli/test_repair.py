# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repair writes: the model and its verdicts."""

import json
import os
import subprocess
import sys

import pytest

from command import PROGRAM, READER, run
from models import OCCT_DATA, box_text, installed, reader_that_finds, roof_text
from patches import sheet_text, surfaces_of, worst_figures
from repairs import VALIDATOR, analysis, expect_same_verdicts, repair, sheet
from schemas import expect_valid


@pytest.mark.parametrize("target", ["G1", "G2"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_sheet_flows_again(tmp_path, target, seed):
    model = sheet(tmp_path, count_x=2, count_y=2, seed=seed)
    before = worst_figures(surfaces_of(model.read_text()))
    result, report, out = repair(model, "--target", target)
    assert result.returncode == 0 and result.stderr == ""
    assert before[1] > 0.1 and report["summary"]["repaired"] > 1
    assert max(seam["before"]["angle_deg"]["upper"] for seam in report["seams"]) == pytest.approx(
        before[1], rel=1e-3
    )
    gap_mm, angle_deg = worst_figures(surfaces_of(out.read_text()))
    assert gap_mm <= 1e-9 and angle_deg <= 0.1
    assert angle_deg <= max(seam["after"]["angle_deg"]["upper"] for seam in report["seams"]) + 1e-6
    expect_same_verdicts(report, out)
    assert report["output"] == {
        "path": str(out),
        "format": "STEP",
        "edges": 12,
        "faces": 4,
        "open_edges": 8,
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }


@pytest.mark.parametrize("make", [lambda: sheet_text(noise_mm=0), box_text, lambda: roof_text(30)])
def test_what_has_no_defect_is_written_as_it_was(tmp_path, make):
    model = tmp_path / "model.step"
    model.write_text(make())
    result, report, out = repair(model)
    assert result.returncode == 0
    assert not report["summary"]["changed"] and report["summary"]["treated"] == 0
    assert "nothing moved" in result.stdout
    assert surfaces_of(out.read_text()) == surfaces_of(model.read_text()), "number by number"
    for seam, again in zip(report["seams"], expect_same_verdicts(report, out)["seams"]):
        assert again == seam["before"] == seam["after"]


@pytest.mark.parametrize("name", ["box.step", "sheet.brep", "sheet.bin", "sheet.igs"])
def test_what_has_no_defect_comes_back_byte_for_byte(tmp_path, name):
    model = tmp_path / name
    if name == "box.step":
        model.write_text(box_text())
    else:
        repair(sheet(tmp_path), out=model)
    result, report, out = repair(model, out=tmp_path / ("out" + model.suffix))
    assert result.returncode == 0 and not report["summary"]["changed"]
    assert out.read_bytes() == model.read_bytes()
    assert report["output"]["defects"] == 0
    # Another format is written again.
    other = repair(model, out=tmp_path / ("other.brep" if name == "box.step" else "other.step"))[2]
    assert len(analysis(other)["seams"]) == len(report["seams"])


def test_the_verdict_is_on_the_file_too(tmp_path):
    model, other, out = (
        sheet(tmp_path),
        sheet(tmp_path, "other.step", count_x=3),
        tmp_path / "out.step",
    )
    found = analysis(other)
    result = run(
        "repair",
        model,
        "-o",
        out,
        "--json",
        tmp_path / "out.json",
        reader=reader_that_finds(other, tmp_path, READER),
    )
    assert result.returncode == 1, result.stderr
    report = json.loads((tmp_path / "out.json").read_text())
    expect_valid(report, VALIDATOR)
    assert report["summary"]["defects_after"] == 0
    assert report["output"] == {
        "path": str(out),
        "format": "STEP",
        "edges": 10,
        "faces": 3,
        "open_edges": 8,
        "defects": 2,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert (found["model"]["edges"], found["model"]["faces"]) == (10, 3)
    line = (
        "read back: 2 defects, 3 faces, 10 edges, 8 free edges, 2 seams; the model in memory has "
        "0, 2, 7, 6, 1: "
        "numbers of faces and edges differ"
    )
    assert result.stdout.endswith(f"\n{out} {line}\nFAILED: 2 defects at level G1\n")
    assert result.stderr == f"seamwright: warning: {out}: {line}\n"
    assert analysis(out)["summary"]["defects"] == 0, "the model itself is written"


def test_what_cannot_be_read_back_is_not_written(tmp_path):
    model, reader = sheet(tmp_path), reader_that_finds(tmp_path / "none.step", tmp_path, READER)
    before = sorted(tmp_path.iterdir())
    result = run(
        "repair", model, "-o", tmp_path / "out.step", "--json", tmp_path / "out.json", reader=reader
    )
    assert result.returncode == 2 and result.stdout == ""
    assert "out.step: can't be read back" in result.stderr and result.stderr.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("file,most_defects", [("bottle.brep", 0), ("hammer.brep", 4)])
def test_step_of_loose_tolerances_keeps_the_verdict(tmp_path, file, most_defects):
    """Vertices of these stand off their edges; a reader that is not told so bends the curves to
    them."""
    model = tmp_path / file
    model.write_bytes(installed(OCCT_DATA / "occ" / file).read_bytes())
    result, report, _ = repair(model)
    assert report["output"]["defects"] == report["summary"]["defects_after"] <= most_defects
    assert "read back" not in result.stdout and result.stderr == ""


def test_what_cannot_be_repaired_is_written_as_it_was(tmp_path):
    model = sheet(tmp_path)
    result, report, out = repair(model, "--max-move", "1e-6")
    assert result.returncode == 1
    assert report["summary"]["left"] == 1 and not report["summary"]["changed"]
    assert surfaces_of(out.read_text()) == surfaces_of(model.read_text())
    assert "mm" in report["seams"][0]["reason"]


@pytest.mark.parametrize(
    "name,format",
    [
        ("a.step", "STEP"),
        ("a.STP", "STEP"),
        ("a.igs", "IGES"),
        ("a.brep", "BREP"),
        ("a.bin", "binary BREP"),
    ],
)
def test_the_name_of_the_output_tells_its_format(tmp_path, name, format):
    result, report, out = repair(sheet(tmp_path, count_y=2), out=tmp_path / name)
    assert result.returncode == 0
    found = analysis(out)
    facts = {key: found["model"][key] for key in ("edges", "faces")}
    assert report["output"] == {
        "path": str(out),
        "format": format,
        **facts,
        "open_edges": found["summary"]["open_edges"],
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert found["model"]["format"] == format and found["model"]["faces"] == 4
    # Other formats may number edges otherwise.
    levels = sorted((seam["faces"], seam["level"], seam["class"]) for seam in found["seams"])
    assert levels == sorted(
        (seam["after"]["faces"], seam["after"]["level"], seam["after"]["class"])
        for seam in report["seams"]
    )


@pytest.mark.parametrize(
    "path, treated, least_repaired, largest_move_mm",
    [
        (OCCT_DATA / "occ/shell1.brep", 102, 98, 0.05),
        (OCCT_DATA / "step/linkrods.step", 16, 16, 0.2),
    ],
    ids=["shell1", "linkrods"],
)
def test_defects_of_real_models(tmp_path, path, treated, least_repaired, largest_move_mm):
    """What is left of shell1 would make a face less fair."""
    _, report, out = repair(installed(path), out=tmp_path / "out.brep")
    assert report["summary"]["treated"] == treated
    assert report["summary"]["repaired"] >= least_repaired, report["summary"]
    assert report["summary"]["worse_faces"] == 0
    assert report["summary"]["largest_move_mm"] <= largest_move_mm
    expect_same_verdicts(report, out)


def test_edges_that_reading_adds_are_named(tmp_path):
    """Vertices of linkrods stand off their paths: the reader bridges the ends with edges that are
    in no seam."""
    result, report, out = repair(
        installed(OCCT_DATA / "step/linkrods.step"), out=tmp_path / "out.step"
    )
    in_memory = 108
    assert out.read_text().count("EDGE_CURVE(") == in_memory
    found = analysis(out)
    added = sorted(
        set(range(1, found["model"]["edges"] + 1))
        - {edge for seam in found["seams"] for edge in seam["edges"]}
    )
    assert report["output"]["edges"] == found["model"]["edges"] == in_memory + len(added)
    if not added:
        assert "read back" not in result.stderr
        return
    count = (
        "1 edge without length was"
        if len(added) == 1
        else f"{len(added)} edges without length were"
    )
    assert result.stderr == (
        f"seamwright: warning: {out}: read back: {in_memory + len(added)} edges; the model in "
        "memory has "
        f"{in_memory}: {count} added by reading; numbers of edges differ from Edge{added[0]} on\n"
    )


def largest_memory_kb(*arguments):
    """Of the command that ran, without the process that reads files. A small process starts it,
    because the peak of a child counts from the memory of its parent."""
    start = (
        "import os, subprocess, sys\n"
        "process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL)\n"
        "_, status, usage = os.wait4(process.pid, 0)\n"
        "assert os.waitstatus_to_exitcode(status) in (0, 1)\n"
        "print(usage.ru_maxrss)"
    )
    command = [sys.executable, "-S", "-c", start, PROGRAM, *map(str, arguments)]
    return int(subprocess.run(command, stdout=subprocess.PIPE, check=True, timeout=60).stdout)


@pytest.mark.skipif(sys.platform != "linux", reason="peaks of memory are in kB on Linux alone")
def test_memory_stays_small(tmp_path):
    """102 seams between 99 faces, all of them repaired: 120 MB, where the analysis takes 38 MB."""
    path = installed(OCCT_DATA / "occ/shell1.brep")
    analysed = largest_memory_kb("analyze", path, "--jobs", 2)
    repaired = largest_memory_kb("repair", path, "-o", tmp_path / "out.brep", "--jobs", 2)
    assert repaired <= 4 * analysed, (analysed, repaired)


@pytest.mark.parametrize("name", ["step/screw.step", "occ/CrankArm.brep"])
def test_the_source_stays_and_the_file_has_the_reported_verdicts(tmp_path, name):
    path = installed(OCCT_DATA / name)
    model = tmp_path / path.name
    model.write_bytes(path.read_bytes())
    content = model.read_bytes()
    _, report, out = repair(model, out=tmp_path / ("out" + path.suffix))
    assert model.read_bytes() == content
    expect_same_verdicts(report, out)
