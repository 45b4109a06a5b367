# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the report goes: standard output, a file that is whole or untouched, and the progress bar
beside it."""

import errno
import json
import os
import pty
import select
import stat
import subprocess

import pytest

from command import PROGRAM, bound_by_permissions, run
from models import box_text, roof_text


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path


def without_times(text):
    report = json.loads(text)
    del report["time_s"]
    return report


@pytest.mark.parametrize("form", ["table", "json", "csv"])
def test_the_file_holds_what_standard_output_would(box, tmp_path, form):
    output = tmp_path / "out.txt"
    shown = run("analyze", "--format", form, box)
    saved = run("analyze", "--format", form, box, "-o", output)
    assert (saved.returncode, saved.stdout, saved.stderr) == (shown.returncode, "", "")
    if form == "json":
        assert without_times(output.read_text()) == without_times(shown.stdout)
    else:
        strip = [line for line in shown.stdout.splitlines() if "read in" not in line]
        assert [line for line in output.read_text().splitlines() if "read in" not in line] == strip


def test_nothing_else_is_left_in_the_folder(box, tmp_path):
    before = set(os.listdir(tmp_path))
    assert run("analyze", box, "-o", tmp_path / "out.txt").returncode == 0
    assert set(os.listdir(tmp_path)) - before == {"out.txt"}


def test_an_older_file_is_replaced_by_renaming(box, tmp_path):
    output = tmp_path / "out.txt"
    output.write_text("old")
    kept = tmp_path / "kept.txt"
    os.link(output, kept)  # a second name of the old file: writing in place would show here
    assert run("analyze", box, "-o", output).returncode == 0
    assert kept.read_text() == "old"
    assert "12 seams" in output.read_text()


def test_a_failed_run_leaves_the_older_file_alone(box, tmp_path):
    output = tmp_path / "out.txt"
    output.write_text("old")
    assert run("analyze", box, tmp_path / "none.step", "-o", output).returncode == 2
    assert output.read_text() == "old"


def test_a_defect_is_no_reason_not_to_write(tmp_path):
    path, output = tmp_path / "roof.step", tmp_path / "out.json"
    path.write_text(roof_text(1))
    assert run("analyze", "--format", "json", path, "-o", output).returncode == 1
    assert json.loads(output.read_text())["summary"]["defects"] == 1


def test_a_link_to_the_model_is_the_model(box, tmp_path):
    link = tmp_path / "link.step"
    link.symlink_to(box)
    content = box.read_bytes()
    result = run("analyze", box, "-o", link)
    assert result.returncode == 2
    assert box.read_bytes() == content and link.is_symlink()
    hard = tmp_path / "hard.step"
    os.link(box, hard)
    assert run("analyze", box, "-o", hard).returncode == 2
    assert box.read_bytes() == content


def test_relative_names(box, tmp_path):
    assert run("analyze", "box.step", "-o", "out.txt", cwd=tmp_path).returncode == 0
    assert (tmp_path / "out.txt").exists()


def test_a_device_is_written_to_and_stays_one(box):
    assert run("analyze", box, "-o", "/dev/null").returncode == 0
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def test_a_full_disk_is_reported(box):
    with open("/dev/full", "w") as full:
        result = subprocess.run(
            [PROGRAM, "analyze", str(box)],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )
    assert result.returncode == 2
    assert result.stderr.count("\n") == 1
    assert run("analyze", box, "-o", "/dev/full").returncode == 2


@pytest.mark.parametrize(
    "command, out",
    [
        (["curve", "arcs", "points.csv"], "out.dxf"),
        (["curve", "arcs", "points.csv"], "out.step"),
        (["curve", "blend", "points.csv", "points.csv"], "out.csv"),
        (["repair", "box.step"], "out.step"),
    ],
)
def test_a_report_that_cannot_be_written_leaves_no_output(box, tmp_path, command, out):
    (tmp_path / "points.csv").write_text("0,0\n1,2\n3,3\n")
    before = set(os.listdir(tmp_path))
    result = run(*command, "-o", out, "--json", "/dev/full", cwd=tmp_path)
    assert (result.returncode, result.stdout) == (2, "") and "/dev/full" in result.stderr
    assert set(os.listdir(tmp_path)) == before


def test_a_read_only_folder_is_reported(box, tmp_path):
    folder = tmp_path / "locked"
    folder.mkdir(mode=0o500)
    result = run("analyze", box, "-o", folder / "out.txt", begin=bound_by_permissions())
    assert result.returncode == 2 and "locked" in result.stderr


def drain(descriptor, process):
    """What the terminal shows until the process has ended."""
    shown = b""
    while True:
        ready, _, _ = select.select([descriptor], [], [], 0.1)
        if ready:
            try:
                data = os.read(descriptor, 65536)
            except OSError as error:
                if error.errno != errno.EIO:
                    raise
                data = b""
            if not data:
                break
            shown += data
        elif process.poll() is not None:
            break
    process.wait(timeout=10)
    return shown.decode()


def on_terminal(box, **where):
    master, slave = pty.openpty()
    streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": slave} | {
        key: (slave if value == "terminal" else value) for key, value in where.items()
    }
    process = subprocess.Popen([PROGRAM, "analyze", "--format", "json", str(box)], **streams)
    os.close(slave)
    try:
        return drain(master, process), process
    finally:
        os.close(master)


def test_a_bar_on_a_terminal_and_it_is_wiped(box):
    shown, process = on_terminal(box)
    assert process.returncode == 0
    assert "reading box.step" in shown and "analysing box.step" in shown
    assert "[" in shown and "%" in shown
    assert shown.endswith("\r\x1b[K"), "the line is clear in the end"
    assert json.loads(process.stdout.read())["summary"]["seams"] == 12


def test_the_bar_never_enters_the_report(box):
    """Standard output on the terminal, standard error in a pipe: the report alone."""
    shown, process = on_terminal(box, stdout="terminal", stderr=subprocess.PIPE)
    assert process.stderr.read() == b""
    assert json.loads(shown)["summary"]["seams"] == 12


def test_no_bar_in_a_pipe(box):
    result = run("analyze", box)
    assert result.stderr == ""
    assert "\r" not in result.stdout and "\x1b" not in result.stdout
