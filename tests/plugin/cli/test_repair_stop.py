# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair stopped: Ctrl-C ends it with status 130 and nothing left behind; killed at any moment, the
files are whole or absent."""

import fcntl
import json
import os
import pty
import random
import signal
import subprocess
import time

import pytest

from command import PROGRAM, run
from patches import sheet_text
from seeds import seed_of_test


@pytest.fixture
def model(tmp_path):
    """A folder with a sheet that takes a second or more."""
    path = tmp_path / "sheet.step"
    path.write_text(sheet_text(count_x=6, count_y=5))
    return path


def start(model, out="out.step", **streams):
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams}
    return subprocess.Popen(
        [
            PROGRAM,
            "repair",
            str(model),
            "-o",
            str(model.parent / out),
            "--json",
            str(model.parent / "out.json"),
        ],
        stdin=subprocess.DEVNULL,
        text=True,
        **streams,
    )


def whole_run(model, out="out.step"):
    """Seconds that it takes, and the two files."""
    began = time.monotonic()
    process = start(model, out)
    process.communicate(timeout=60)
    assert process.returncode in (0, 1)
    seconds = time.monotonic() - began
    files = [model.parent / name for name in (out, "out.json")]
    content = [file.read_text() for file in files]
    for file in files:
        file.unlink()
    return seconds, content


def without_time(text):
    """A STEP file but for the time of day in its header."""
    return [line for line in text.splitlines() if "FILE_NAME" not in line]


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(model, how):
    content = model.read_bytes()
    seconds, _ = whole_run(model)
    moments, stopped = random.Random(seed_of_test()), 0
    for _ in range(5):
        process = start(model)
        time.sleep(moments.uniform(0.05, 0.8) * seconds)
        asked = time.monotonic()
        process.send_signal(how)
        out, error = process.communicate(timeout=30)
        assert time.monotonic() - asked < 5, "it took long to stop"
        if process.returncode == 128 + how:
            stopped += 1
            assert out == "" and error == "seamwright: stopped, nothing was written\n"
            assert os.listdir(model.parent) == [model.name]
        elif process.returncode == -how:
            assert time.monotonic() - asked < 1, "it had not begun"
        else:
            assert process.returncode in (0, 1)
        for name in ("out.step", "out.json"):
            (model.parent / name).unlink(missing_ok=True)
    assert stopped >= 2
    assert model.read_bytes() == content


def wait_for_a_file_beside(model, process):
    """Until something is being written, or the process has ended."""
    while process.poll() is None and os.listdir(model.parent) == [model.name]:
        time.sleep(0.0005)


@pytest.mark.parametrize("out", ["out.step", "out.brep"])
def test_killed_at_any_moment(model, out):
    """Moments of the whole run, and as many while files are written, read back and renamed."""
    content = model.read_bytes()
    seconds, (written, report) = whole_run(model, out)
    moments, seen = random.Random(seed_of_test()), set()
    for aimed in [False, True] * 12:
        process = start(model, out, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if aimed:
            wait_for_a_file_beside(model, process)
        time.sleep(moments.uniform(0, 0.3 if aimed else 1.05) * seconds)
        process.send_signal(signal.SIGKILL)
        process.wait(timeout=20)
        assert model.read_bytes() == content
        left = {
            name: (model.parent / name).read_text()
            for name in os.listdir(model.parent)
            if name != model.name
        }
        seen.add("model" if out in left else "part" if left else "nothing")
        if out in left:
            assert without_time(left[out]) == without_time(written)
        if "out.json" in left:
            assert out in left, "the report speaks of a model that is there"
            assert {**json.loads(left["out.json"]), "time_s": 0} == {
                **json.loads(report),
                "time_s": 0,
            }
        for name in left:
            assert name in (out, "out.json") or ".part" in name
            (model.parent / name).unlink()
    assert {"nothing", "part"} <= seen


def test_what_a_killed_run_left_is_swept_by_the_next(model):
    left = []
    for _ in range(20):
        process = start(model, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for_a_file_beside(model, process)
        process.send_signal(signal.SIGKILL)
        process.wait(timeout=20)
        left = [name for name in os.listdir(model.parent) if name.startswith(".out.step.")]
        if left:
            break
        for name in ("out.step", "out.json"):
            (model.parent / name).unlink(missing_ok=True)
    assert left
    whole_run(model)
    assert not [name for name in os.listdir(model.parent) if name.startswith(".out.step.")]


def test_what_is_being_written_and_other_files_stay(model):
    others = [
        model.parent / name
        for name in (
            ".out.step.x7.part",
            ".other.step.7.part",
            "out.step.7.part",
            ".out.step..part",
        )
    ]
    held, stale = model.parent / ".out.step.7.part", model.parent / ".out.step.8.part"
    for path in (*others, held, stale):
        path.write_text("kept")
    with open(held, "r+") as writer:
        fcntl.flock(writer, fcntl.LOCK_EX)
        whole_run(model)
        assert held.exists() and not stale.exists()
    whole_run(model)
    assert not held.exists() and all(path.read_text() == "kept" for path in others)


def test_a_bar_on_a_terminal_and_none_in_a_pipe(tmp_path):
    model = tmp_path / "small.step"
    model.write_text(sheet_text())
    master, slave = pty.openpty()
    process = start(model, stderr=slave)
    os.close(slave)
    text, shown = process.communicate(timeout=30)[0], b""
    while True:
        try:
            data = os.read(master, 65536)
        except OSError:
            break
        if not data:
            break
        shown += data
    os.close(master)
    shown = shown.decode()
    assert process.returncode == 0
    for what in (
        "reading small.step",
        "repairing small.step",
        "writing out.step",
        "checking out.step",
    ):
        assert what in shown
    assert shown.endswith("\r\x1b[K"), "the line is clear in the end"
    assert "\r" not in text and "\x1b" not in text and "PASSED" in text
    again = run("repair", model, "-o", tmp_path / "again.step")
    assert again.stderr == "" and "\r" not in again.stdout
