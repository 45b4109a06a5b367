# SPDX-License-Identifier: LGPL-2.1-or-later
"""A project of someone else finds the installed Seamwright, compiles against it and runs."""

import os
import subprocess
from pathlib import Path

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
PREFIX = Path(os.environ["SEAMWRIGHT_PREFIX"])
MODELS = Path(os.environ["SEAMWRIGHT_MODELS"])


def run(*command, **options):
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_consumer(tmp_path):
    run(
        "cmake",
        "-S",
        SOURCE / "tests/house/consumer",
        "-B",
        tmp_path,
        "-G",
        "Ninja",
        f"-DCMAKE_PREFIX_PATH={PREFIX}",
    )
    run("cmake", "--build", tmp_path)
    cache = (tmp_path / "CMakeCache.txt").read_text()
    assert f"Seamwright_DIR:PATH={PREFIX}" in cache
    (reader,) = (PREFIX / "libexec/seamwright").iterdir()
    output = run(
        tmp_path / "consumer",
        MODELS / "broken_block.step",
        env={**os.environ, "SEAMWRIGHT_READER": str(reader)},
    )
    assert (
        output
        == "core: patch of degree 1 x 1, point (0.5, 0.5, 0)\nocc: 48 seams, verdict: some fall "
           "short\n"
    )


def test_consumer_of_the_core_only(tmp_path):
    run(
        "cmake",
        "-S",
        SOURCE / "tests/house/consumer",
        "-B",
        tmp_path,
        "-G",
        "Ninja",
        f"-DCMAKE_PREFIX_PATH={PREFIX}",
        "-DCORE_ONLY=ON",
    )
    run("cmake", "--build", tmp_path)
    assert run(tmp_path / "consumer").startswith("core: patch")
    linked = run("ldd", tmp_path / "consumer")
    assert "libTK" not in linked
