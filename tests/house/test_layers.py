# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows point one way: plugin -> occ_adapter -> core; handles and FreeCAD stay where they
belong."""

import ast
import os
import re
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
ADDON = SOURCE / "plugin/freecad/freecad/seamwright"
OPENCASCADE = re.compile(
    r"\b(?:TopoDS|TopAbs|TopExp|TopTools|TopLoc|Geom|Geom2d|BRep[A-Za-z]*|Bnd|gp|TCol[A-Za-z]*"
    r"|XCAFDoc|TDF|STEP[A-Za-z]*"
    r"|Standard)_\w+|\bopencascade::handle\b|\bHandle\("
)
# A program must name what it catches and which OpenCASCADE it runs.
ANY_PLUGIN_MAY = {"Standard_Failure", "Standard_Version"}


def files(folder, *endings):
    found = [path for path in (SOURCE / folder).rglob("*") if path.suffix in endings]
    assert found, f"no files under {folder}"
    return sorted(found)


def code(path):
    """A C++ file without comments and without what stands in quotes."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", " ", text, flags=re.S)


def includes(path):
    """What a C++ file includes, with the first quote or bracket."""
    directive = r"^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*([<\"]?[^>\"\n]*)"
    return re.findall(directive, path.read_text(encoding="utf-8"), re.M)


def imports(path):
    """The modules a Python file imports, also inside its functions."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{'.' * node.level}{node.module or ''}.{name.name}" for name in node.names)


def test_core_includes_nothing_but_std_eigen_and_core():
    allowed = re.compile(r"<(?:[a-z_]+|Eigen/\w+|seamwright/core/[\w/]+\.hpp)")
    # An installed core does not need fmt; the other header is the compiler's own.
    in_sources = re.compile(r"<(?:fmt/\w+|immintrin)\.h")
    wrong = [
        (path.name, name)
        for path in files("core", ".hpp", ".cpp")
        for name in includes(path)
        if not allowed.fullmatch(name)
        and not (path.suffix == ".cpp" and in_sources.fullmatch(name))
    ]
    assert wrong == []


def test_core_names_nothing_of_opencascade():
    wrong = [(path.name, OPENCASCADE.findall(code(path))) for path in files("core", ".hpp", ".cpp")]
    assert [entry for entry in wrong if entry[1]] == []


def test_adapter_includes_nothing_but_what_it_stands_on():
    allowed = re.compile(
        r"<(?:[a-z_]+|[A-Za-z]\w*\.hxx|Eigen/\w+|fmt/(?:format|ranges)\.h|nlohmann/json\.hpp"
        r"|seamwright/(?:core|occ_adapter)/[\w/]+\.hpp)"
    )
    of_the_system = {
        "<dlfcn.h",
        "<fcntl.h",
        "<poll.h",
        "<signal.h",
        "<spawn.h",
        "<sys/file.h",
        "<sys/mman.h",
        "<sys/prctl.h",
        "<sys/resource.h",
        "<sys/stat.h",
        "<sys/types.h",
        "<sys/wait.h",
        "<unistd.h",
    }
    wrong = [
        (path.name, name)
        for path in files("occ_adapter", ".hpp", ".cpp")
        for name in includes(path)
        if not allowed.fullmatch(name) and name not in of_the_system
    ]
    assert wrong == []


@pytest.mark.parametrize("layer", ["core", "occ_adapter"])
def test_folders_are_free_of_cycles(layer):
    """No folder includes another one that includes it, directly or through others."""
    folders = {}
    for path in files(layer, ".hpp", ".cpp"):
        own = str(path.parent.relative_to(SOURCE))
        named = {
            str(Path(name[1:]).parent).removeprefix("seamwright/")
            for name in includes(path)
            if name.startswith(f"<seamwright/{layer}/")
        }
        folders.setdefault(own, set()).update(named - {own})
    try:
        order = list(TopologicalSorter(folders).static_order())
    except CycleError as error:
        pytest.fail("folders include each other: " + " -> ".join(error.args[1]))
    assert len(order) > 5


def test_plugins_leave_opencascade_to_the_adapter():
    wrong = []
    for path in files("plugin", ".hpp", ".cpp"):
        if path.stem == "pointer_bridge":
            continue
        names = set(OPENCASCADE.findall(code(path)))
        names |= {Path(name[1:]).stem for name in includes(path) if name.endswith(".hxx")}
        wrong += [(path.name, name) for name in sorted(names - ANY_PLUGIN_MAY)]
    assert wrong == []


def test_python_package_names_freecad_only_in_the_bridge():
    wrong = [
        (path.name, name)
        for path in files("plugin/python/seamwright", ".py")
        if path.name != "bridge.py"
        for name in imports(path)
        if name.split(".")[0] in {"FreeCAD", "FreeCADGui", "Part", "PySide", "pivy"}
    ]
    assert wrong == []


@pytest.mark.parametrize(
    "ring, forbidden",
    [
        (
            "plain",
            {
                "FreeCAD",
                "FreeCADGui",
                "Part",
                "PySide",
                "pivy",
                "freecad.seamwright.document",
                "freecad.seamwright.gui",
            },
        ),
        ("document", {"FreeCADGui", "PySide", "pivy", "freecad.seamwright.gui"}),
    ],
)
def test_rings_of_the_workbench(ring, forbidden):
    wrong = []
    for path in sorted((ADDON / ring).rglob("*.py")):
        for name in imports(path):
            parts = name.split(".")
            if parts[0] in forbidden or ".".join(parts[:3]) in forbidden:
                wrong.append((path.name, name))
    assert wrong == []


def test_every_source_file_states_its_licence():
    sources = [
        path
        for folder in ("core", "occ_adapter", "plugin", "samples", "tests")
        for path in files(folder, ".hpp", ".cpp", ".py", ".txt", ".FCMacro")
    ]
    wrong = [
        str(path.relative_to(SOURCE))
        for path in sources
        if path.stat().st_size
        and "SPDX-License-Identifier: LGPL-2.1-or-later"
        not in path.read_text(encoding="utf-8")[:400]
    ]
    assert wrong == []


def test_versions_of_opencascade_are_told_apart_in_one_header():
    asking = {
        str(path.relative_to(SOURCE))
        for folder in ("occ_adapter", "plugin", "samples", "benchmarks", "tests")
        for path in files(folder, ".hpp", ".cpp")
        if re.search(r"\bOCC_VERSION_(?:HEX|MAJOR|MINOR|MAINTENANCE)\b", code(path))
    }
    assert asking == {"occ_adapter/occt_version.hpp"}
