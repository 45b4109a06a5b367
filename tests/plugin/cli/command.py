# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the command."""

import os
import pathlib
import subprocess

PROGRAM = os.environ["SEAMWRIGHT"]


def run(*arguments, reader=None, cwd=None):
    environment = dict(os.environ)
    environment.pop("SEAMWRIGHT_READER", None)
    if reader is not None:
        environment["SEAMWRIGHT_READER"] = str(reader)
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, cwd=cwd,
                          env=environment, stdin=subprocess.DEVNULL)


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


def reader_that_finds(other, folder):
    """A reader that finds another model where the written one waits for its place."""
    reader = folder / "reader.sh"
    (real,) = pathlib.Path(PROGRAM).parent.glob("seamwright-read-*")
    reader.write_text("#!/bin/bash\nargs=()\nfor arg; do\n"
                      f"  case \"$arg\" in *.part) args+=({str(other)!r});; *) args+=(\"$arg\");; esac\n"
                      f"done\nexec {str(real)!r} \"${{args[@]}}\"\n")
    reader.chmod(0o755)
    return reader
