# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of the help: where they are, their contents, and the section of each command."""

import ast
import os
import pathlib
import re

import pytest

from freecad.seamwright.plain import help_pages

DOCS = pathlib.Path(
    os.environ.get("SEAMWRIGHT_SOURCE", pathlib.Path(__file__).resolve().parents[3])
) / "docs"  # fmt: skip

ADDON = pathlib.Path(help_pages.__file__).parents[1]

PAGES = {
    "workbench.md": "# The `workbench`\n\n## Use\n\n### Deeper\n",
    "fill.md": "# Fill holes\n## In FreeCAD\n",
    "repair.md": "# Repair\n",
    "zebra.md": "# beta\n\n```sh\n# no title\n## no section\n```\n\n"
                "## A *b*: [c d](e.md), f-g_h!\n",
    "alpha.md": "# Zulu\n## One\n## Two\n",
    "plain.md": "No heading here.\n",
    "notes.txt": "# Not a page\n",
}  # fmt: skip


@pytest.fixture
def installed(tmp_path, monkeypatch):
    """A folder of an installed workbench with PAGES; returns a function that removes them."""
    package = tmp_path / "Mod" / "freecad" / "seamwright"
    docs = tmp_path / "Mod" / "docs"
    docs.mkdir(parents=True)
    package.mkdir(parents=True)
    for name, text in PAGES.items():
        (docs / name).write_text(text, encoding="utf-8")
    monkeypatch.setattr(help_pages, "PACKAGE", str(package))
    return docs


def test_pages_are_those_of_the_installed_workbench(installed):
    assert help_pages.folder() == str(installed)
    assert help_pages.address("fill.md#in-freecad") == "file://%s/fill.md#in-freecad" % installed


def test_pages_of_the_repository_are_found(installed, monkeypatch):
    deep = installed.parent / "plugin" / "freecad" / "freecad" / "seamwright"
    monkeypatch.setattr(help_pages, "PACKAGE", str(deep))
    assert help_pages.folder() == str(installed)


def test_without_pages_there_is_the_address_of_the_project(installed):
    (installed / "workbench.md").unlink()
    assert help_pages.folder() is None and help_pages.contents() == []
    assert help_pages.address("fill.md#in-freecad") == (
        "https://example.org/seamwright/blob/main/docs/fill.md#in-freecad"
    )


def test_contents_have_pages_of_the_workbench_first_then_others_by_title(installed):
    found = help_pages.contents()
    assert [(name, title) for name, title, _ in found] == [
        ("workbench.md", "The workbench"), ("fill.md", "Fill holes"), ("repair.md", "Repair"),
        ("zebra.md", "beta"), ("plain.md", "plain.md"), ("alpha.md", "Zulu"),
    ]  # fmt: skip
    sections = {name: listed for name, _, listed in found}
    assert sections["workbench.md"] == [("Use", "use")]
    assert sections["alpha.md"] == [("One", "one"), ("Two", "two")]
    assert sections["zebra.md"] == [("A b: c d, f-g_h!", "a-b-c-d-f-g_h")]


@pytest.mark.parametrize(
    "heading, anchor",
    [
        ("Use", "use"), (" In FreeCAD ", "in-freecad"), ("f-g_h!", "f-g_h"),
        ("What to accept: profiles", "what-to-accept-profiles"),
        ("G\u00b9, and (more)", "g\u00b9-and-more"),
    ],
)  # fmt: skip
def test_anchors_are_those_of_github(heading, anchor):
    assert help_pages.anchor(heading) == anchor


def test_commands_and_kinds_have_their_sections():
    assert help_pages.section_of("Seamwright_UmbrellaFill") == "fill.md#in-freecad"
    assert help_pages.section_of("Clothoid") == "freecad_curves.md#each-command"
    assert help_pages.section_of("Seamwright_Unknown") == "workbench.md"
    assert help_pages.section_of_kind("SeamAnalysis") == "workbench.md#use"
    assert help_pages.section_of_kind("SeamRepair") == "workbench.md#repair-seams"
    assert help_pages.section_of_kind("DraftAngle") == "freecad_analysis.md#draft-angle"


def test_every_section_exists():
    for section in {*help_pages.SECTIONS.values(), *help_pages.FIRST}:
        page, _, anchor = section.partition("#")
        text = (DOCS / page).read_text(encoding="utf-8")
        headings = re.findall(r"^#+ (.+)$", text, re.M)
        assert not anchor or anchor in [each.lower().replace(" ", "-") for each in headings]


@pytest.mark.parametrize(
    "text, first",
    [
        ("Open it. Then go. Stop.", "Open it."), ("Is it? Yes.", "Is it?"), ("Go! Now.", "Go!"),
        ("Within 0.1 mm. More.", "Within 0.1 mm."), ("No end", "No end"),
        ("\u6253\u5f00\u3002\u7136\u540e\u7ee7\u7eed\u3002", "\u6253\u5f00\u3002"),
    ],
)  # fmt: skip
def test_the_first_sentence_of_a_tool_tip(text, first):
    assert help_pages.first_sentence(text) == first


def kinds():
    """The names of the classes in the tables KINDS of the workbench."""
    for path in (ADDON / "document").glob("*/kinds.py"):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.Assign) and node.targets[0].id == "KINDS":
                (loop,) = node.value.generators
                yield from (each.id for each in loop.iter.elts)


def test_every_command_has_its_section():
    text = (ADDON / "gui" / "commands.py").read_text(encoding="utf-8")
    commands = re.findall(r'^    name = "Seamwright_(\w+)"$', text, re.M)
    assert len(commands) == 7
    assert set(help_pages.SECTIONS) == {*commands, *kinds(), "Help"}
