# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages about the code name files and functions that exist, and graphs that are true.

In the pages below, `folder/file` in backticks names a file or a folder of the tree, and
`folder/file:name` a function or class in that file; members are named C++ `Class::name` and Python
`Class.name`.
"""

import ast
import os
import re
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
PAGES = ("docs/architecture.md", "CONTRIBUTING.md")
FOLDERS = (
    "benchmarks",
    "cmake",
    "core",
    "docs",
    "occ_adapter",
    "plugin",
    "samples",
    "tests",
    "tools",
)
NAMED = re.compile(rf"`((?:{'|'.join(FOLDERS)})/[^`\s:*]*)(?::([\w:.~]+))?(?:\s[^`]*)?`")
FENCE = re.compile(r"^```.*?^```$", re.M | re.S)


def tool(name):
    """A program of tools/ as a module."""
    loader = SourceFileLoader(name.replace("-", "_"), str(SOURCE / "tools" / name))
    module = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


MEASURES = tool("measures")


def names_of_cpp(text):
    """The functions and classes that a C++ file defines, members also with their class."""
    blocks = MEASURES.blocks(text)
    for block in blocks:
        yield block.name
        yield from (
            f"{outer.name}::{block.name}"
            for outer in blocks
            if outer.kind == "class"
            and outer.first <= block.first
            and block.last <= outer.last
            and outer != block
        )


def names_of_python(text):
    """The functions and classes that a Python file defines, members with their class."""

    def inside(node, prefix):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, (ast.FunctionDef, ast.ClassDef)):
                yield prefix + child.name
                if isinstance(child, ast.ClassDef):
                    yield from inside(child, f"{prefix}{child.name}.")

    yield from inside(ast.parse(text), "")


def fault(path, name):
    """Why what a page names cannot be found; empty if it can."""
    file = SOURCE / path
    if not file.exists():
        return f"there is no {path}"
    if not name:
        return ""
    text = file.read_text(encoding="utf-8")
    names = set(names_of_python(text) if file.suffix == ".py" else names_of_cpp(text))
    # Members of a class in a header are defined in the .cpp file as Class::member.
    owners = {known.split("::")[0] for known in names}
    return "" if name in names | owners else f"{path} has no {name}"


def named(page):
    return NAMED.findall(FENCE.sub("", (SOURCE / page).read_text(encoding="utf-8")))


@pytest.mark.parametrize("page", PAGES)
def test_what_is_named_exists(page):
    found = named(page)
    assert len(found) > 10, "where are the names?"
    assert [fault(*each) for each in found if fault(*each)] == []


@pytest.mark.parametrize("layer", ("core", "occ_adapter"))
def test_graphs_show_the_includes(layer):
    block = tool("module-graph").blocks()[layer]
    text = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
    assert (
        f"<!-- module-graph {layer}: begin -->\n{block}\n<!-- module-graph {layer}: end -->" in text
    ), "out of date: run tools/module-graph --write"


def test_every_folder_of_core_and_adapter_is_described():
    text = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
    folders = [
        f"{layer}/{path.name}/"
        for layer in ("core", "occ_adapter")
        for path in (SOURCE / layer).iterdir()
        if path.is_dir()
    ]
    assert [name for name in folders if f"| `{name}` |" not in text] == []


@pytest.mark.parametrize(
    "path, name, expected",
    [
        ("core/seam/judge.cpp", "judge", ""),
        ("core/seam/judge.cpp", "", ""),
        ("core/seam/", "", ""),
        ("core/seam/judge.cpp", "condemn", "core/seam/judge.cpp has no condemn"),
        ("core/seam/gavel.cpp", "judge", "there is no core/seam/gavel.cpp"),
        ("occ_adapter/repair/improve.cpp", "Moving::run", ""),
        ("tests/house/test_architecture.py", "fault", ""),
        ("tools/measures", "Block", "tools/measures has no Block"),
    ],
)
def test_faults_are_found(path, name, expected):
    assert fault(path, name) == expected


def test_names_are_read_from_backticks():
    text = "`core/seam/judge.cpp:judge`, `core/seam/`, `judge`, `build/dev`, `tools/test -R core`"
    assert NAMED.findall(text) == [
        ("core/seam/judge.cpp", "judge"),
        ("core/seam/", ""),
        ("tools/test", ""),
    ]
