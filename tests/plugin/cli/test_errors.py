# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input: one line on standard error that says what is wrong, status 2, nothing written."""

import re

import pytest

from command import contents, expect_one_line, run
from models import BROKEN, box_text


def write(path, content):
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def bad_inputs(folder):
    """name: (arguments, what the line must say)."""
    good = write(folder / "good.step", box_text())
    text = box_text()
    empty_step = text[: text.index("#9=")] + "ENDSEC;\nEND-ISO-10303-21;\n"
    foreign = "#16=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.GRAM.));\n"
    cases = {
        "missing file": ([folder / "none.step"], "none.step"),
        "folder": ([folder], "folder"),
        "empty file": ([write(folder / "empty.step", "")], "empty"),
        "no STEP": ([write(folder / "text.step", "Dear all,\nthis is a letter.\n")], "text.step"),
        "binary noise": ([write(folder / "noise.step", bytes(range(256)) * 8)], "noise.step"),
        "truncated": ([write(folder / "cut.step", text[: len(text) // 2])], "truncated"),
        "no shapes": ([write(folder / "nothing.step", empty_step)], "nothing.step"),
        "no unit": ([write(folder / "nounit.step", box_text(unit=""))], "unit"),
        "unknown unit": ([write(folder / "gram.step", box_text(unit=foreign))], "unit"),
        "second of two": ([good, folder / "none.step"], "none.step"),
        "no model": ([], "MODEL"),
        "unknown option": ([good, "--frobnicate"], "--frobnicate"),
        "unknown format": ([good, "--format", "xml"], "xml"),
        "unknown level": ([good, "--level", "G7"], "G7"),
        "unknown profile": ([good, "--profile", "class-b"], "class-b"),
        "crease below the profile's angle": (
            [good, "--profile", "vda", "--crease", "0.05"],
            "0.05",
        ),
        "word for a number": ([good, "--gap", "wide"], "--gap: 'wide'"),
        "negative jobs": ([good, "--jobs", "-1"], "--jobs: -1"),
        "crease below angle": ([good, "--angle", "3", "--crease", "2"], "2"),
        "missing folder": ([good, "-o", folder / "nowhere" / "out.json"], "nowhere"),
        "output is a folder": ([good, "-o", folder], "folder"),
        "output is the model": ([good, "-o", good], "good.step"),
        "output is another model": (
            [good, "-o", write(folder / "old.step", "old")],
            "old.step: has the name of a model",
        ),
        "output is a second model": (
            [write(folder / "other.step", text), good, "-o", good],
            "good.step",
        ),
    }
    for option in ("gap", "angle", "curvature", "flat-radius", "crease", "match"):
        for text in ("nan", "inf", "-0.5"):
            cases[f"{text} for {option}"] = ([good, f"--{option}", text], f"--{option}: {text} ")
        for text in ("", "0x1p3", "1mm"):
            cases[f"'{text}' for {option}"] = ([good, f"--{option}", text], f"--{option}: '{text}'")
    cases["zero flat-radius"] = ([good, "--flat-radius", "0"], "--flat-radius: 0 ")
    most = "3000000000 is too large: at most 2147483647 is possible"
    cases["more jobs than there are numbers"] = ([good, "--jobs", "3000000000"], f"--jobs: {most}")
    cases["fewer jobs than there are numbers"] = (
        [good, "--jobs", "-3000000000"],
        "--jobs: -3000000000 must not be negative",
    )
    cases["a number beyond the range"] = (
        [good, "--gap", "1e400"],
        "--gap: 1e400 is beyond the range of numbers",
    )
    cases["no number of jobs"] = ([good, "--jobs", ""], "--jobs: '' is not a whole number")
    return cases


def names():
    import pathlib
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        return list(bad_inputs(pathlib.Path(folder)))


@pytest.mark.parametrize("name", names())
def test_one_line_and_status_2(tmp_path, name):
    arguments, said = bad_inputs(tmp_path)[name]
    before = contents(tmp_path)
    for form in ("table", "json", "csv"):
        chosen = [] if name == "unknown format" else ["--format", form]
        expect_one_line(run("analyze", *chosen, *arguments), said)
    if "-o" not in arguments:
        output = tmp_path / "out.txt"
        expect_one_line(run("analyze", *arguments, "-o", output), said)
    assert contents(tmp_path) == before, "nothing is written"


def test_the_folder_is_not_a_step_away_from_being_written(tmp_path):
    good = write(tmp_path / "good.step", box_text())
    expect_one_line(run("analyze", good, "-o", tmp_path / "a" / "b" / "out.json"), "a")
    assert not (tmp_path / "a").exists()


def test_no_subcommand_and_unknown_subcommand():
    expect_one_line(run(), "subcommand")
    commands = "'analyze', 'repair', 'match', 'fill', 'corner', 'blend', 'extend' and 'curve' (see "
    expect_one_line(run("analyse"), commands)


def test_names_with_line_breaks_keep_to_one_line(tmp_path):
    expect_one_line(run("analyze", tmp_path / "two\nlines.step"), "two")


def test_the_order_of_checks_saves_the_reading(tmp_path):
    """A bad output is refused before a model is read."""
    good = write(tmp_path / "good.step", box_text())
    expect_one_line(
        run("analyze", good, "-o", tmp_path / "nowhere" / "x", reader="/bin/false"), "nowhere"
    )


@pytest.mark.parametrize(
    "reader,said",
    [
        ("/bin/false", "good.step"),
        ("/nonexistent/reader", "/nonexistent/reader"),
        ("/etc/passwd", "/etc/passwd"),
        ("/bin/true", "good.step"),
    ],
)
def test_readers_that_do_not_read(tmp_path, reader, said):
    expect_one_line(run("analyze", write(tmp_path / "good.step", box_text()), reader=reader), said)


@pytest.mark.parametrize(
    "content",
    [
        "garbage",
        "\\0\\0\\0\\0\\0\\0\\0\\0\\0",
        "S\\1\\0\\0\\0\\0\\0\\0\\0x",
        "S\\377\\377\\377\\377\\377\\377\\377\\377",
        "F\\2\\0\\0\\0\\0\\0\\0\\0{}",
        "E\\2\\0\\0\\0\\0\\0\\0\\0{}",
        "E\\1\\0\\0\\0\\0\\0\\0\\0x",
        "",
    ],
)
def test_readers_that_talk_nonsense(tmp_path, content):
    reader = tmp_path / "reader"
    reader.write_text(f"#!/bin/sh\nprintf '{content}' >&3\n")
    reader.chmod(0o755)
    expect_one_line(
        run("analyze", write(tmp_path / "good.step", box_text()), reader=reader), "good.step"
    )


@pytest.mark.parametrize(
    "file, said",
    [
        ("point_as_context.stp", ""),
        ("scope.stp", ""),
        ("triangles.stp", ""),
        ("lfs_pointer.stp", "Git LFS"),
    ],
)
def test_broken_files(file, said):
    result = run("analyze", BROKEN / file)
    expect_one_line(result, BROKEN / file)
    assert said in result.stderr


def test_utf16_is_called_so(tmp_path):
    path = write(tmp_path / "wide.step", b"\xff\xfe" + box_text().encode("utf-16-le"))
    expect_one_line(run("analyze", path), "UTF-16")


def test_a_face_of_a_missing_surface_is_reported(tmp_path):
    text = re.sub(r"(ADVANCED_FACE\('',\(#\d+\),)#\d+", r"\1#99999999", box_text(), count=1)
    result = run("analyze", write(tmp_path / "dangling.step", text))
    assert result.returncode in (0, 1)
    assert "6 faces" in result.stdout and "could not be made" in result.stdout


def test_help_and_version_go_to_standard_output():
    for arguments in (["--help"], ["analyze", "--help"], ["--version"]):
        result = run(*arguments)
        assert result.returncode == 0 and result.stderr == "" and result.stdout
    assert run("--version").stdout.startswith("seamwright ")
