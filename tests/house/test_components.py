# SPDX-License-Identifier: LGPL-2.1-or-later
"""Components switch off, and what is missing is named with the Debian package that brings it."""

import json
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
COMPONENTS = ("OCC", "CLI", "PYTHON", "FREECAD")


def configure(folder, parts=COMPONENTS, *arguments):
    """cmake's status and output in one line; parts are the components that are on."""
    command = [
        "cmake",
        "-S",
        str(SOURCE),
        "-B",
        str(folder),
        "-G",
        "Ninja",
        "-DSEAMWRIGHT_BUILD_TESTS=OFF",
        "-DPython_EXECUTABLE=/usr/bin/python3",
    ]
    command += [
        f"-DSEAMWRIGHT_BUILD_{part}={'ON' if part in parts else 'OFF'}" for part in COMPONENTS
    ]
    if shutil.which("ccache"):
        command.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    run = subprocess.run([*command, *arguments], capture_output=True, text=True)
    return run.returncode, " ".join((run.stdout + run.stderr).split())


@pytest.mark.parametrize(
    "parts",
    [("OCC",), ("OCC", "CLI"), ("OCC", "PYTHON"), ("OCC", "PYTHON", "FREECAD"), COMPONENTS],
    ids="+".join,
)
def test_combination_configures(tmp_path, parts):
    status, output = configure(tmp_path, parts)
    assert status == 0, output


@pytest.mark.parametrize(
    "parts, missing",
    [
        (("CLI",), "CLI needs OCC"),
        (("PYTHON",), "PYTHON needs OCC"),
        (("OCC", "FREECAD"), "FREECAD needs PYTHON"),
    ],
)
def test_contradiction_is_named(tmp_path, parts, missing):
    status, output = configure(tmp_path, parts)
    assert status != 0
    assert missing in output


def commands(build):
    """What decides how a file of core compiles, by its path: headers, definitions, the standard."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = Path(entry["file"])
        words = shlex.split(entry["command"].replace(str(build), "BUILD"))
        if path.is_relative_to(SOURCE / "core"):
            found[path.relative_to(SOURCE)] = {
                f"{word} {following}" if word == "-isystem" else word
                for word, following in zip(words, words[1:])
                if word.startswith(("-I", "-D", "-isystem", "-std=", "-f"))
            }
    return found


def test_core_alone_needs_neither_opencascade_nor_python(tmp_path):
    """Core compiles with these very commands in the whole, but for definitions that it does not
    name: so it builds alone."""
    # The build beside may join sources to units; how each is compiled is asked of builds that
    # don't.
    status, output = configure(tmp_path / "whole", COMPONENTS, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    assert status == 0, output
    missing = [
        f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON"
        for name in ("OpenCASCADE", "Python", "pybind11", "CLI11")
    ]
    status, output = configure(
        tmp_path / "alone", (), "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *missing
    )
    assert status == 0, output
    alone, built = commands(tmp_path / "alone"), commands(tmp_path / "whole")
    assert alone and alone.keys() == built.keys()
    assert [path for path in alone if not alone[path] <= built[path]] == []
    more = {re.sub("^-D|=.*", "", word) for path in alone for word in built[path] - alone[path]}
    assert [
        (path, name) for path in alone for name in more if name in (SOURCE / path).read_text()
    ] == []
    plan = subprocess.run(
        ["ninja", "-C", str(tmp_path / "alone"), "-n"], capture_output=True, text=True, check=True
    ).stdout
    assert set(re.findall(r"Building CXX object (\w+)/", plan)) == {"core"}, plan
    assert re.findall(r"Linking .* (\S+)\n", plan) == ["lib/libseamwright_core.a"], plan


@pytest.mark.parametrize(
    "package, component, debian",
    [
        ("Eigen3", None, "libeigen3-dev"),
        ("fmt", None, "libfmt-dev"),
        ("OpenCASCADE", "OCC", "libocct-modeling-algorithms-dev"),
        ("nlohmann_json", "OCC", "nlohmann-json3-dev"),
        ("CLI11", "CLI", "libcli11-dev"),
        ("Python", "PYTHON", "python3-dev"),
        ("pybind11", "PYTHON", "pybind11-dev"),
    ],
)
def test_missing_package_is_named(tmp_path, package, component, debian):
    status, output = configure(tmp_path, COMPONENTS, f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON")
    assert status != 0
    assert "apt-get install" in output and debian in output
    if component:
        assert f"-DSEAMWRIGHT_BUILD_{component}=OFF" in output


def test_missing_swig_is_named(tmp_path):
    status, output = configure(tmp_path, COMPONENTS, "-DSWIG_EXECUTABLE=")
    assert status != 0
    assert "apt-get install swig" in output


def test_missing_googletest_is_named(tmp_path):
    status, output = configure(
        tmp_path, (), "-DSEAMWRIGHT_BUILD_TESTS=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON"
    )
    assert status != 0
    assert "libgtest-dev" in output


def test_benchmarks_are_off_and_name_their_package(tmp_path):
    missing = "-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON"
    assert configure(tmp_path, (), missing)[0] == 0
    status, output = configure(tmp_path, (), missing, "-DSEAMWRIGHT_BUILD_BENCHMARKS=ON")
    assert status != 0
    assert "BENCHMARKS needs benchmark" in output and "libbenchmark-dev" in output
