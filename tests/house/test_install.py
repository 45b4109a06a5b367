# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cmake --install puts where, and that it runs from there."""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

BUILD = Path(os.environ["SEAMWRIGHT_BUILD"])
PREFIX = Path(os.environ["SEAMWRIGHT_PREFIX"])
MODELS = Path(os.environ["SEAMWRIGHT_MODELS"])
BROKEN = MODELS / "broken_block.step"
READER = re.compile(r"libexec/seamwright/seamwright-read-occt\d+\.\d+")


def installed(prefix):
    return sorted(str(path.relative_to(prefix)) for path in prefix.rglob("*") if not path.is_dir())


def install(component, prefix):
    subprocess.run(
        ["cmake", "--install", str(BUILD), "--prefix", str(prefix), "--component", component],
        check=True,
        capture_output=True,
    )
    return installed(prefix)


def clean_environment(**extra):
    """No path of the build tree leads anywhere."""
    kept = {name: os.environ[name] for name in ("HOME", "LANG", "TMPDIR") if name in os.environ}
    return {"PATH": "/usr/bin:/bin", **kept, **extra}


def analyze(command, *arguments):
    return subprocess.run(
        [str(command), "analyze", str(BROKEN), *arguments],
        capture_output=True,
        text=True,
        env=clean_environment(),
        cwd="/",
    )


def test_runtime_runs_wherever_it_is_put(tmp_path):
    placed = install("runtime", tmp_path / "first")
    assert placed[0] == "bin/seamwright"
    assert READER.fullmatch(placed[1])
    assert len(placed) == 2
    shutil.move(tmp_path / "first", tmp_path / "second")
    run = analyze(tmp_path / "second/bin/seamwright", "--format", "json")
    assert run.returncode == 1, run.stderr
    summary = json.loads(run.stdout)["summary"]
    assert (summary["seams"], summary["defects"]) == (48, 1)


def test_command_runs_through_a_link_and_from_the_path(tmp_path):
    (tmp_path / "seamwright").symlink_to(PREFIX / "bin/seamwright")
    assert analyze(tmp_path / "seamwright").returncode == 1
    run = subprocess.run(
        ["seamwright", "analyze", str(MODELS / "rounded_block.step")],
        capture_output=True,
        text=True,
        env=clean_environment(PATH=f"{PREFIX}/bin:/usr/bin:/bin"),
    )
    assert run.returncode == 0, run.stderr
    assert "PASSED" in run.stdout


def test_development_holds_what_a_compiler_needs(tmp_path):
    placed = install("development", tmp_path)
    headers = [name for name in placed if name.startswith("include/")]
    assert "include/seamwright/core/seam/measure.hpp" in headers
    assert "include/seamwright/occ_adapter/analyze/analyze.hpp" in headers
    rest = [
        re.sub(r"^lib/(\w+-linux-gnu[a-z0-9]*/)?", "", name)
        for name in placed
        if name not in headers
    ]
    assert {
        "libseamwright_core.a",
        "libseamwright_occ.a",
        "cmake/Seamwright/SeamwrightConfig.cmake",
    } <= set(rest)
    assert not any(name.startswith(("bin/", "libexec/")) for name in placed)


def test_installed_headers_need_only_installed_headers():
    folder = PREFIX / "include"
    missing = []
    for header in folder.rglob("*.hpp"):
        for name in re.findall(
            r"#include <(seamwright/[^>]+)>", header.read_text(encoding="utf-8")
        ):
            if not (folder / name).exists():
                missing.append((header.name, name))
    assert missing == []


def test_python_package_works_from_the_install(tmp_path):
    placed = install("python", tmp_path)
    package = tmp_path / "lib/python3/dist-packages"
    assert f"{package.relative_to(tmp_path)}/seamwright/__init__.py" in placed
    program = (
        "import sys, seamwright; r = seamwright.read(sys.argv[1]).analyze(); print(len(r), "
        "r.passed, seamwright.__file__)"
    )
    run = subprocess.run(
        ["/usr/bin/python3", "-c", program, str(BROKEN)],
        capture_output=True,
        text=True,
        env=clean_environment(PYTHONPATH=str(package)),
        cwd="/",
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.split() == ["48", "False", str(package / "seamwright/__init__.py")]


def test_workbench_brings_its_module(tmp_path):
    placed = install("workbench", tmp_path)
    addon = "share/freecad/Mod/Seamwright"
    assert {f"{addon}/package.xml", f"{addon}/LICENSE", f"{addon}/seamwright/__init__.py"} <= set(
        placed
    )
    assert any(re.search(r"/seamwright/_core\..*\.so$", name) for name in placed)
    assert all(name.startswith(addon) for name in placed)


def test_installed_text_names_no_folder_of_the_build():
    texts = [
        PREFIX / name
        for name in installed(PREFIX)
        if name.endswith((".cmake", ".hpp", ".py", ".json", ".xml"))
    ]
    assert texts
    assert [text.name for text in texts if str(BUILD) in text.read_text(encoding="utf-8")] == []


@pytest.mark.parametrize("program", ["bin/seamwright"])
def test_programs_have_no_search_path_into_the_build_tree(program):
    dynamic = subprocess.run(
        ["readelf", "-d", str(PREFIX / program)], capture_output=True, text=True, check=True
    ).stdout
    assert "RUNPATH" not in dynamic and "RPATH" not in dynamic
