# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the command."""

import os
import subprocess

PROGRAM = os.environ["SEAMWRIGHT"]


def run(*arguments, reader=None, cwd=None):
    environment = dict(os.environ)
    environment.pop("SEAMWRIGHT_READER", None)
    if reader is not None:
        environment["SEAMWRIGHT_READER"] = str(reader)
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, cwd=cwd,
                          env=environment, stdin=subprocess.DEVNULL)
