# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and SIGTERM: a clean end with status 130 or 143, soon, with nothing written and no process
left."""

import fcntl
import os
import pathlib
import signal
import subprocess
import time

import pytest

from command import PROGRAM
from models import box_text, step_text

SLOW_READER = """#!/bin/sh
echo $$ > {pid}
exec sleep 1000
"""


def start(arguments, reader=None):
    environment = dict(os.environ)
    if reader:
        environment["SEAMWRIGHT_READER"] = str(reader)
    return subprocess.Popen(
        [PROGRAM, "analyze", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
    )


def wait_for(condition, seconds=20):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.01)


def stop(process, how):
    asked = time.monotonic()
    process.send_signal(how)
    out, error = process.communicate(timeout=20)
    assert time.monotonic() - asked < 3, "it took long to stop"
    return out, error


def is_running(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().split(")")[1].split()[0] != "Z"
    except OSError:
        return False


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_while_reading(tmp_path, how):
    model, reader, pid, output = (
        tmp_path / name for name in ("box.step", "reader", "pid", "out.txt")
    )
    model.write_text(box_text())
    reader.write_text(SLOW_READER.format(pid=pid))
    reader.chmod(0o755)
    process = start([model, "-o", output], reader)
    wait_for(lambda: pid.exists() and pid.read_text().strip())
    out, error = stop(process, how)
    assert process.returncode == 128 + how
    assert out == "" and error.count("\n") == 1
    assert not output.exists()
    assert not is_running(int(pid.read_text())), "the reading process is gone as well"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["box.step", "pid", "reader"]


def grid(n):
    """A bumpy roof of n by n squares in one shell, each split in two triangles."""
    points = [(x, y, 0.1 * ((3 * x + 5 * y) % 7)) for y in range(n + 1) for x in range(n + 1)]
    faces = []
    for y in range(n):
        for x in range(n):
            a, b, c, d = (
                y * (n + 1) + x,
                y * (n + 1) + x + 1,
                (y + 1) * (n + 1) + x + 1,
                (y + 1) * (n + 1) + x,
            )
            faces += [[a, b, c], [a, c, d]]
    return step_text(points, faces, closed=False)


def test_a_real_reader_at_work_and_several_models(tmp_path):
    model, output = tmp_path / "grid.step", tmp_path / "out.txt"
    model.write_text(grid(40))
    process = start([model] * 400 + ["-o", output])
    time.sleep(1.5)
    assert process.poll() is None
    out, error = stop(process, signal.SIGINT)
    assert process.returncode == 130
    assert out == "" and "stopped" in error
    assert not output.exists()


def test_the_terminal_sends_it_to_the_whole_group(tmp_path):
    """The reader gets Ctrl-C too; its end is not a crash to complain of."""
    model, reader, pid = (tmp_path / name for name in ("box.step", "reader", "pid"))
    model.write_text(box_text())
    reader.write_text(SLOW_READER.format(pid=pid))
    reader.chmod(0o755)
    environment = dict(os.environ, SEAMWRIGHT_READER=str(reader))
    process = subprocess.Popen(
        [PROGRAM, "analyze", str(model)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        start_new_session=True,
    )
    wait_for(lambda: pid.exists() and pid.read_text().strip())
    os.killpg(process.pid, signal.SIGINT)
    out, error = process.communicate(timeout=20)
    assert process.returncode == 130, error
    assert out == "" and "crash" not in error


def write_points(path):
    path.write_text("".join(f"{x},{x * x / 100}\n" for x in range(40)))


def curve(*arguments):
    return subprocess.Popen(
        [PROGRAM, "curve", "arcs", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def has_waited_long(process):
    """Whether it did nothing for a while: it waits for a pipe."""
    state = [pathlib.Path(f"/proc/{process.pid}/stat").read_text() for _ in range(2)]
    time.sleep(0.3)
    state.append(pathlib.Path(f"/proc/{process.pid}/stat").read_text())
    return all(text.split(")")[1].split()[0] == "S" for text in state) and state[0] == state[-1]


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("signals", [1, 2])
def test_a_step_that_does_not_end(tmp_path, how, signals):
    """The points come from a pipe, and no more of them come."""
    pipe, output = tmp_path / "points.csv", tmp_path / "out.csv"
    os.mkfifo(pipe)
    process = curve(pipe, "-o", output)
    with pipe.open("w", encoding="ascii") as points:
        points.write("0,0\n1,1\n")
        points.flush()
        wait_for(lambda: has_waited_long(process))
        asked = time.monotonic()
        for _ in range(signals - 1):
            process.send_signal(how)
            time.sleep(0.2)
        out, error = stop(process, how)
        seconds = time.monotonic() - asked
    assert process.returncode == 128 + how
    assert out == "" and error == "seamwright: stopped, nothing was written\n"
    assert signals == 1 or seconds < 0.9
    assert os.listdir(tmp_path) == ["points.csv"]


def full_pipe(path):
    """A pipe that takes no more bytes, and is read by nobody."""
    os.mkfifo(path)
    end = os.open(path, os.O_RDWR | os.O_NONBLOCK)
    fcntl.fcntl(end, fcntl.F_SETPIPE_SZ, 4096)
    os.write(end, bytes(4096))
    return end


@pytest.mark.parametrize("name", ["out.csv", "out.step"])
def test_an_unfinished_file_is_removed(tmp_path, name):
    points, report, output = tmp_path / "points.csv", tmp_path / "report", tmp_path / name
    write_points(points)
    end = full_pipe(report)
    try:
        process = curve(points, "-o", output, "--json", report)
        wait_for(lambda: len(os.listdir(tmp_path)) == 3 and has_waited_long(process))
        unfinished = set(os.listdir(tmp_path)) - {"points.csv", "report"}
        assert unfinished != {name}, "it is beside its target"
        out, error = stop(process, signal.SIGTERM)
    finally:
        os.close(end)
    assert process.returncode == 143
    assert out == "" and error == "seamwright: stopped, nothing was written\n"
    assert sorted(os.listdir(tmp_path)) == ["points.csv", "report"]
