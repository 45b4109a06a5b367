# SPDX-License-Identifier: LGPL-2.1-or-later
"""What CONTRIBUTING.md asks of every source file and no compiler checks."""

import re
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

from sources import CODE, LANGUAGES, ROOT, texts

COLUMNS = 100
#: It tells its parent what went wrong, whatever it was.
CATCHES_ALL = {"occ_adapter/model/reader_main.cpp"}


def measures():
    """The script tools/measures as a module."""
    loader = SourceFileLoader("measures", str(ROOT / "tools/measures"))
    module = module_from_spec(spec_from_loader("measures", loader))
    loader.exec_module(module)
    return module


def test_lines_have_at_most_100_columns():
    files = dict(texts(LANGUAGES, CODE))
    assert len(files) > 500
    long = [
        f"{name}:{number}: {len(line)} columns"
        for name, text in files.items()
        for number, line in enumerate(text.splitlines(), 1)
        if len(line) > COLUMNS
    ]
    assert not long, "\n".join(long)


def test_no_handler_takes_a_bug_for_a_reason():
    """Handlers name what they expect: std::exception is also what a bug throws. Those of all that
    may be thrown hand it on."""
    pattern = r"catch \((const )?std::exception\b"
    assert re.search(pattern, "} catch (const std::exception& error) {")
    bad = [
        f"{name}:{number}: {line.strip()}"
        for name, text in texts(("core", "occ_adapter"), (".cpp", ".hpp"))
        if name not in CATCHES_ALL
        for number, line in enumerate(text.splitlines(), 1)
        if re.search(pattern, line)
    ]
    assert not bad, "\n".join(bad)


def test_functions_and_classes_are_short():
    tool = measures()
    found = tool.Measures(tool.files_of(None))
    assert found.functions > 3000
    long = [
        f"{name}:{block.first}: {block.kind} {block.name} has {block.lines} lines"
        for name, blocks in found.long.items()
        for block in blocks
    ]
    assert not long, "\n".join(long)


#: Tests of what other systems than Linux, or other Pythons than FreeCAD's, have not.
MAY_SKIP = {
    "tests/occ_adapter/errors_test.cpp",
    "tests/occ_adapter/prove_test.cpp",
    "tests/plugin/cli/test_repair.py",
    "tests/plugin/python/test_models.py",
    "tests/plugin/python/test_repair.py",
}


def test_no_test_is_skipped_where_the_packages_are_installed():
    pattern = r"GTEST_SKIP|importorskip|pytest\.skip|mark\.skip|skipTest|SKIP_RETURN_CODE"
    files = [
        name
        for name, text in texts(("tests",), (*CODE, ".txt"))
        if name != "tests/house/test_style.py" and re.search(pattern, text)
    ]
    assert set(files) == MAY_SKIP
