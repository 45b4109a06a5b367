# SPDX-License-Identifier: LGPL-2.1-or-later
"""The types that the package states: mypy accepts them, and the compiled module has the same names,
parameters and defaults."""

import ast
import os
import subprocess
from pathlib import Path

import pytest
import seamwright
from seamwright import _core

PACKAGE = Path(seamwright.__file__).parent
STUB = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Of all checks, so that they share mypy's cache."""
    return tmp_path_factory.mktemp("types")


def run(program, *arguments, folder):
    environment = {
        **os.environ,
        "MYPYPATH": str(PACKAGE.parent),
        "PYTHONPATH": str(PACKAGE.parent),
        "MYPY_CACHE_DIR": str(folder / "cache"),
    }
    done = subprocess.run(
        [program, *map(str, arguments)], cwd=folder, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_package_is_marked_as_typed():
    assert (PACKAGE / "py.typed").exists()


def test_the_type_checker_accepts_the_package_and_its_use(folder):
    configuration = folder / "mypy.ini"
    configuration.write_text(
        "[mypy]\nwarn_unused_ignores = True\n"
        "[mypy-Part,FreeCAD]\nignore_missing_imports = True\n",
        encoding="utf-8",
    )
    run("mypy", "--config-file", configuration, "-p", "seamwright", folder=folder)
    # Silent: of the package itself less is asked.
    use = HERE / "typed_use.py"
    run("mypy", "--strict", "--follow-imports=silent", use, folder=folder)


def test_the_type_checker_refuses_wrong_use(folder):
    use = folder / "wrong.py"
    use.write_text(
        "import seamwright\n"
        "curve = seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])\n"
        "seamwright.frenet_frame(curve, 0.5).no_such_figure\n"
        "seamwright.arc_length('curve', 1e-3)\n"
        "seamwright.read('part.step').analyze(gap=1)\n",
        encoding="utf-8",
    )
    done = subprocess.run(
        ["mypy", str(use)],
        cwd=folder,
        env={
            **os.environ,
            "MYPYPATH": str(PACKAGE.parent),
            "MYPY_CACHE_DIR": str(folder / "cache"),
        },
        capture_output=True,
        text=True,
    )
    for line in (3, 4, 5):
        assert f"wrong.py:{line}: error" in done.stdout, done.stdout


def test_stub_and_module_have_the_same_names(folder):
    allowed = folder / "allowed"
    # Names that pybind11 adds; the signatures of compiled functions are compared below.
    allowed.write_text(
        "\n".join(
            [
                r"seamwright\._core\..*\.__(init|getstate|setstate|deepcopy|copy)__",
                r"seamwright\._core\..*\.__pybind11_module_local.*",
                r"seamwright\._core\.[A-Z]\w*",  # their metaclass is one of pybind11
            ]
        ),
        encoding="utf-8",
    )
    run(
        "stubtest",
        "--allowlist",
        allowed,
        "--ignore-unused-allowlist",
        "seamwright._core",
        folder=folder,
    )


def divided(text):
    """The parts of a text between commas that are outside brackets and quotes."""
    parts, depth, quote = [""], 0, ""
    for c in text:
        if quote:
            quote = "" if c == quote else quote
        elif c in "'\"":
            quote = c
        elif c == "," and depth == 0:
            parts.append("")
            continue
        depth += (not quote) * ((c in "([{") - (c in ")]}"))
        parts[-1] += c
    return [part.strip() for part in parts if part.strip()]


def of_docstring(doc):
    """(name, keyword only, default) of each parameter, from the first line of a docstring."""
    line = doc.splitlines()[0]
    inside = line[line.index("(") + 1 : line.rindex(") -> ")]
    result, keyword_only = [], False
    for part in divided(inside):
        if part == "*":
            keyword_only = True
            continue
        name, _, rest = part.partition(":")
        _, equals, default = rest.partition(" = ")
        result.append((name, keyword_only, default if equals else None))
    return result


def of_stub(function):
    given = function.args
    plain = [(a.arg, False) for a in given.args]
    defaults = [None] * (len(plain) - len(given.defaults)) + [*map(ast.unparse, given.defaults)]
    result = [(name, False, default) for (name, _), default in zip(plain, defaults)]
    for argument, default in zip(given.kwonlyargs, given.kw_defaults):
        result.append((argument.arg, True, default and ast.unparse(default)))
    return result


def same_default(a, b):
    if a is None or b is None:
        return a is b
    return "..." in (a, b) or ast.literal_eval(a) == ast.literal_eval(b)


def functions():
    for node in STUB.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node, getattr(_core, node.name)
        elif isinstance(node, ast.ClassDef):
            for member in node.body:
                is_property = isinstance(member, ast.FunctionDef) and any(
                    ast.unparse(d) == "property" for d in member.decorator_list
                )
                if isinstance(member, ast.FunctionDef) and not is_property:
                    yield (
                        f"{node.name}.{member.name}",
                        member,
                        getattr(getattr(_core, node.name), member.name),
                    )


def is_compared(name, function):
    """Whether it is a compiled function of one signature."""
    written_in_python = name.endswith((".from_freecad", ".to_freecad"))
    operator = name.endswith((".__len__", ".__eq__")) or "Overloaded" in (function.__doc__ or "")
    return not written_in_python and not operator


@pytest.mark.parametrize(
    "stub, function",
    [
        pytest.param(stub, function, id=name)
        for name, stub, function in functions()
        if is_compared(name, function)
    ],
)
def test_stub_and_module_have_the_same_parameters(stub, function):
    compiled, stated = of_docstring(function.__doc__), of_stub(stub)
    assert [c[:2] for c in compiled] == [s[:2] for s in stated]
    for (name, _, a), (_, _, b) in zip(compiled, stated):
        assert same_default(a, b), f"{name}: {a} in the module, {b} in the stub"


def test_every_public_name_is_in_the_stub():
    stated = {node.name for node in STUB.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    stated |= {node.target.id for node in STUB.body if isinstance(node, ast.AnnAssign)}
    assert {name for name in dir(_core) if not name.startswith("__")} <= stated


