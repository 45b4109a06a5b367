# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the command."""

import os
import pathlib
import subprocess

PROGRAM = os.environ["SEAMWRIGHT"]
(READER,) = pathlib.Path(PROGRAM).parent.glob("seamwright-read-*")


def bound_by_permissions():
    """What a command begins with, so that permissions of files bind the superuser too."""
    if os.geteuid() != 0:
        return []
    return ["setpriv", "--bounding-set", "-dac_override,-dac_read_search"]


def run(*arguments, reader=None, cwd=None, begin=()):
    environment = dict(os.environ)
    environment.pop("SEAMWRIGHT_READER", None)
    if reader is not None:
        environment["SEAMWRIGHT_READER"] = str(reader)
    return subprocess.run(
        [*begin, PROGRAM, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=60,
        cwd=cwd,
        env=environment,
        stdin=subprocess.DEVNULL,
    )


def contents(folder):
    """What a folder holds, to see that nothing in it was written."""
    return {path: path.read_bytes() if path.is_file() else None for path in folder.rglob("*")}


def expect_one_line(result, said):
    """Bad input: status 2 and one line that names what is bad."""
    assert result.returncode == 2, (result.returncode, result.stdout, result.stderr)
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1 and result.stderr.endswith("\n"), result.stderr
    assert result.stderr.startswith("seamwright: ")
    assert str(said) in result.stderr
