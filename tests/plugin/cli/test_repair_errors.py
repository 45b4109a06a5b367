# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input of repair: one line on standard error that says what is wrong, status 2, nothing
written."""

import os
import pathlib
import subprocess
import tempfile

import pytest

from command import PROGRAM, contents, expect_one_line, run
from models import BROKEN, box_text
from patches import sheet_text


def bad_inputs(folder):
    """name: (arguments, what the line must say)."""
    good, out, old = folder / "good.step", folder / "out.step", folder / "old.step"
    good.write_text(sheet_text())
    old.write_text("old")
    (folder / "OLD.BRP").write_text("old")
    (folder / "empty.step").write_text("")
    (folder / "cut.step").write_text(box_text()[:2000])
    (folder / "link.step").symlink_to(good)
    to = ["-o", out]
    cases = {
        "no model": (to, "MODEL"),
        "no output": ([good], "-o"),
        "two models": ([good, old, *to], "old.step"),
        "missing file": ([folder / "none.step", *to], "none.step"),
        "folder": ([folder, *to], "folder"),
        "empty file": ([folder / "empty.step", *to], "empty"),
        "truncated": ([folder / "cut.step", *to], "truncated"),
        "unknown option": ([good, *to, "--frobnicate"], "--frobnicate"),
        "target G0": ([good, *to, "--target", "G0"], "G0"),
        "target G3": ([good, *to, "--target", "G3"], "G3"),
        "unknown profile": ([good, *to, "--profile", "class-b"], "class-b"),
        "edge 0": ([good, *to, "--edges", "0"], "invalid Edge number '0': numbers start at 1"),
        "edge 8": ([good, *to, "--edges", "2,8"], "edge 8: the model has edges 1 to 7"),
        "edge -1": ([good, *to, "--edges=-1"], "invalid Edge number '-1'"),
        "edge 1.5": ([good, *to, "--edges", "1.5"], "1.5"),
        "edge x": ([good, *to, "--edges", "2,x"], "invalid Edge number 'x'"),
        "huge edge": ([good, *to, "--edges", "99999999999"], "99999999999"),
        "no edge": ([good, *to, "--edges"], "--edges"),
        "empty edge": (
            [good, *to, "--edges", ""],
            "invalid Edge number '': give for example 39 or Edge39",
        ),
        "face as edge": ([good, *to, "--edges", "Face2"], "invalid Edge number 'Face2'"),
        "edge that is not a seam": ([good, *to, "--edges", "1"], "edge 1 is not a seam"),
        "face 0": ([good, *to, "--fix", "0"], "invalid Face number '0': numbers start at 1"),
        "face 3": ([good, *to, "--fix", "1,3"], "face 3: the model has faces 1 to 2"),
        "face x": ([good, *to, "--fix", "x"], "x"),
        "empty item in a list": ([good, *to, "--edges", "1,,2"], "--edges: "),
        "empty item at the end": ([good, *to, "--fix", "1,"], "--fix: "),
        "empty number": ([good, *to, "--max-move", ""], "--max-move: '' is not a number"),
        "hexadecimal number": ([good, *to, "--max-time", "0x1p3"], "--max-time: '0x1p3'"),
        "zero time": ([good, *to, "--max-time", "0"], "--max-time: 0 must be larger than zero"),
        "blank in a list": ([good, *to, "--edges", "2,", "3"], "3"),
        "word for a number": ([good, *to, "--max-move", "far"], "far"),
        "NaN move": ([good, *to, "--max-move", "nan"], "--max-move: nan"),
        "negative move": ([good, *to, "--max-move", "-0.5"], "-0.5"),
        "negative jobs": ([good, *to, "--jobs", "-1"], "-1"),
        "crease below angle": ([good, *to, "--angle", "3", "--crease", "2"], "2"),
        "gap below rounding": ([good, *to, "--gap", "1e-20"], "1e-20"),
        "no format": ([good, "-o", folder / "out"], "not a known extension"),
        "foreign format": ([good, "-o", folder / "out.stl"], ".stl"),
        "missing folder": ([good, "-o", folder / "nowhere" / "out.step"], "nowhere"),
        "output is a folder": ([good, "-o", folder / "sub.step"], "folder"),
        "output is there": ([good, "-o", old], "already exists; use --overwrite or "),
        "output is the model": ([good, "-o", good, "--overwrite"], "use --overwrite-source"),
        "output leads to the model": (
            [good, "-o", folder / "link.step", "--overwrite"],
            "use --overwrite-source",
        ),
        "report in a missing folder": (
            [good, *to, "--json", folder / "nowhere" / "a.json"],
            "nowhere",
        ),
        "report is a folder": ([good, *to, "--json", folder], "folder"),
        "report is the model": ([good, *to, "--json", good], "good.step"),
        "report is the output": (
            [good, *to, "--json", folder / "." / "out.step"],
            "out.step: is the output model",
        ),
        "report on standard output": ([good, *to, "--json", "-"], "--json -"),
        "report over another model": (
            [good, *to, "--json", old],
            "old.step: has the name of a model",
        ),
        "report over a model in capitals": (
            [good, *to, "--json", folder / "OLD.BRP", "--overwrite"],
            "OLD.BRP: has the name of a model",
        ),
    }
    for option in ("gap", "angle", "curvature", "flat-radius", "crease", "match"):
        for value in ("nan", "inf", "-0.5"):
            cases[f"{value} {option}"] = ([good, *to, f"--{option}", value], value)
    (folder / "sub.step").mkdir()
    return cases


def names():
    with tempfile.TemporaryDirectory() as folder:
        return list(bad_inputs(pathlib.Path(folder)))


@pytest.mark.parametrize("name", names())
def test_one_line_and_status_2(tmp_path, name):
    arguments, said = bad_inputs(tmp_path)[name]
    before = contents(tmp_path)
    expect_one_line(run("repair", *arguments), said)
    if "--json" not in arguments:
        expect_one_line(run("repair", *arguments, "--json", tmp_path / "report.json"), said)
    assert contents(tmp_path) == before, "nothing is written"


@pytest.mark.parametrize(
    "name",
    [
        "no format",
        "missing folder",
        "output is there",
        "output is the model",
        "report is the output",
        "report in a missing folder",
        "report is the model",
        "report over another model",
        "report on standard output",
        "NaN move",
    ],
)
def test_the_order_of_checks_saves_the_reading(tmp_path, name):
    arguments, said = bad_inputs(tmp_path)[name]
    expect_one_line(run("repair", *arguments, reader="/bin/false"), said)


@pytest.mark.parametrize("file", ["point_as_context.stp", "scope.stp", "lfs_pointer.stp"])
def test_broken_files(tmp_path, file):
    path = BROKEN / file
    expect_one_line(run("repair", path, "-o", tmp_path / "out.step"), path)
    assert os.listdir(tmp_path) == []


def test_the_model_itself_only_where_asked(tmp_path):
    model = tmp_path / "sheet.step"
    model.write_text(sheet_text())
    content = model.read_bytes()
    assert run("repair", model, "-o", model).returncode == 2
    assert model.read_bytes() == content
    assert run("repair", model, "-o", model, "--overwrite-source").returncode == 0
    assert model.read_bytes() != content and run("analyze", model).returncode == 0
    assert os.listdir(tmp_path) == ["sheet.step"]


def test_an_older_report_is_replaced_and_an_older_model_where_asked(tmp_path):
    model, out, report = (tmp_path / name for name in ("sheet.step", "out.step", "report.json"))
    model.write_text(sheet_text())
    out.write_text("old")
    report.write_text("old")
    assert run("repair", model, "-o", out, "--json", report).returncode == 2
    assert out.read_text() == report.read_text() == "old"
    assert run("repair", model, "-o", out, "--json", report, "--overwrite").returncode == 0
    assert out.read_text().startswith("ISO-10303-21;") and report.read_text().startswith(
        '{"schema":"seamwright.repair/1"'
    )


def test_relative_names(tmp_path):
    (tmp_path / "sheet.step").write_text(sheet_text())
    result = run("repair", "sheet.step", "-o", "out.brep", "--json", "out.json", cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert sorted(os.listdir(tmp_path)) == ["out.brep", "out.json", "sheet.step"]


def test_a_full_standard_output_is_told_and_leaves_a_whole_model(tmp_path):
    model, out = tmp_path / "sheet.step", tmp_path / "out.step"
    model.write_text(sheet_text())
    with open("/dev/full", "w") as full:
        result = subprocess.run(
            [PROGRAM, "repair", str(model), "-o", str(out)],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )
    assert result.returncode == 2 and result.stderr.count("\n") == 1
    assert run("analyze", out).returncode == 0, "what was repaired is whole"


def test_help_goes_to_standard_output():
    result = run("repair", "--help")
    assert result.returncode == 0 and result.stderr == ""
    for option in (
        "--target",
        "--max-move",
        "--edges",
        "--fix",
        "--json",
        "--overwrite-source",
        "--no-sew",
        "--profile",
    ):
        assert option in result.stdout
    assert "{" not in result.stdout[result.stdout.index("--no-sew") :].split(maxsplit=1)[0]
