# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each ring of the workbench imports only from the rings inside it."""

import ast
import pathlib

import pytest

PACKAGE = (
    pathlib.Path(__file__).resolve().parents[3] / "plugin" / "freecad" / "freecad" / "seamwright"
)
FREECAD = {"FreeCAD", "Part", "Mesh", "PartDesign", "Import"}
WINDOW = {"FreeCADGui", "PySide", "PySide2", "PySide6", "pivy", "ImportGui", "PartGui"}
INSIDE = "freecad.seamwright."

FORBIDDEN = {
    "plain": FREECAD | WINDOW | {INSIDE + "document", INSIDE + "gui"},
    "document": WINDOW | {INSIDE + "gui"},
}

#: The folders of the ring ``gui``; each imports only from those on lines before its own.
GUI_ORDER = (
    {"widgets"},
    {"scene"},
    {"base"},
    {"analysis", "repair", "match", "fill", "corner", "curves", "surfaces", "maps"},
)


def imported(path):
    """Every module a file imports, wherever in the file."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "%s: relative import" % path
            yield node.module
            yield from ("%s.%s" % (node.module, alias.name) for alias in node.names)


def files(ring):
    found = sorted((PACKAGE / ring).rglob("*.py"))
    assert found, "no files in ring %s" % ring
    return found


@pytest.mark.parametrize("ring", sorted(FORBIDDEN))
def test_ring_imports_inwards_only(ring):
    for path in files(ring):
        for module in imported(path):
            for wrong in FORBIDDEN[ring]:
                assert module != wrong and not module.startswith(wrong + "."), "%s imports %s" % (
                    path.relative_to(PACKAGE),
                    module,
                )


def test_folders_of_the_gui_import_in_order():
    assert set().union(*GUI_ORDER) == {
        path.name for path in (PACKAGE / "gui").iterdir() if any(path.glob("*.py"))
    }
    before = set()
    for group in GUI_ORDER:
        for folder in sorted(group):
            allowed = before | {folder, "icon_path"}
            for path in (PACKAGE / "gui" / folder).glob("*.py"):
                for module in imported(path):
                    if module.startswith(INSIDE + "gui."):
                        inner = module[len(INSIDE + "gui.") :].split(".")[0]
                        assert inner in allowed, "%s imports %s" % (path.name, module)
        before |= group


def test_the_namespace_package_is_left_to_freecad():
    assert not (PACKAGE.parent / "__init__.py").exists()


def test_every_file_says_its_licence():
    for path in PACKAGE.rglob("*"):
        if path.suffix in (".py", ".svg"):
            head = path.read_text(encoding="utf-8")[:200]
            assert "SPDX-License-Identifier: LGPL-2.1-or-later" in head, path
