# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests of the files of translations."""

import ast
import importlib.util
import os
import pathlib
import re
import string
import struct

import pytest

from freecad.seamwright.plain import help_pages

SOURCE = pathlib.Path(
    os.environ.get("SEAMWRIGHT_SOURCE", pathlib.Path(__file__).resolve().parents[3])
)
TOOL = SOURCE / "plugin/freecad/tools/translations.py"

_spec = importlib.util.spec_from_file_location("translations", TOOL)
tool = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(tool)

FILES = sorted(tool.FILES.glob("*.ts"))
COMPLETE = ("seamwright_de.ts", "seamwright_zh-CN.ts")

#: Texts with a blank that are no texts for the user: sentences of the kernel, errors for callers of
#: Python functions, drawing, formats without words.
NOT_SHOWN = re.compile(
    r"kernel_words|report_text|these are: |stripes\.py|distance\.py|nearest\.py"
    r"|choose one of %s|choose from %s|a Part\.Shape is needed|%r|no document to put"
    r"|Sans Serif|How the last computation ended|The faces of fills|[a-z]+ spoke"
    r"|^\S+: (edge | to |not smooth)"
    r"|without result|not repaired|free edge|line of joints|fill, |^\S+: User parameter:"
    r"|^(number_field|expressions)\.py: no"
)


def fields(text):
    """The fields that are filled in, with their formats."""
    return sorted(each[1:] for each in string.Formatter().parse(text) if each[1] is not None)


def phrases():
    """(file, text) of all texts in the source that have a blank between words."""
    for path in sorted(tool.PACKAGE.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        documentation = {
            node.value for node in ast.walk(tree) if isinstance(node, ast.Expr)
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                if node not in documentation and re.search(r"[A-Za-z]{2,} [A-Za-z]", node.value):
                    yield path.name, node.value


def test_each_language_has_a_file():
    names = ["de", "fr", "ja", "zh-CN"]
    assert [path.name for path in FILES] == ["seamwright_%s.ts" % name for name in names]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_files_have_all_texts_of_the_source_and_no_others(path):
    known, wanted = set(tool.read(path)), tool.texts()
    hint = "run plugin/freecad/tools/translations.py update"
    assert (sorted(wanted - known), sorted(known - wanted)) == ([], []), hint


def test_every_phrase_of_the_source_is_translated():
    known = {text for _, text in tool.texts()}
    missed = [
        (name, text)
        for name, text in phrases()
        if text not in known and not NOT_SHOWN.search("%s: %s" % (name, text))
    ]
    assert missed == []


@pytest.mark.parametrize("name", COMPLETE)
def test_these_languages_are_complete(name):
    found = tool.read(tool.FILES / name)
    assert [key for key, translation in found.items() if not translation] == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_translations_have_the_fields_of_their_texts(path):
    wrong = [
        (text, translation)
        for (_, text), translation in tool.read(path).items()
        if translation and fields(translation) != fields(text)
    ]
    assert wrong == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_text_has_one_translation_in_all_contexts(path):
    found = {}
    for (_, text), translation in tool.read(path).items():
        found.setdefault(text, set()).add(translation)
    assert {text: each for text, each in found.items() if len(each) > 1} == {}


def test_chinese_texts_have_chinese_commas():
    found = tool.read(tool.FILES / "seamwright_zh-CN.ts").values()
    assert [text for text in found if re.search("[\u4e00-\u9fff][,;:]", text)] == []


@pytest.mark.parametrize("text", ["Open it. Then go.", "Is it? Then go.", "打开。然后继续。"])
def test_the_status_bar_shows_one_sentence(text):
    assert help_pages.first_sentence(text) == re.match("[^.?。]+[.?。]", text).group()


def test_files_are_written_as_they_are_read(tmp_path):
    for path in FILES:
        language = path.stem.split("_")[1].replace("-", "_")
        tool.write(tmp_path / path.name, language, tool.read(path))
        assert (tmp_path / path.name).read_bytes() == path.read_bytes()


def test_compiled_files_have_sorted_hashes_and_all_finished_texts():
    texts = {("A", "one"): "eins", ("A", "two"): "", ("B", "three \u2026"): "drei"}
    data = tool.compiled(texts)
    tag, size = struct.unpack(">BI", data[16:21])
    entries = [struct.unpack(">II", data[k : k + 8]) for k in range(21, 21 + size, 8)]
    assert (tag, len(entries)) == (0x42, 2)
    assert entries == sorted(entries)
    assert "eins".encode("utf-16-be") in data and "three \u2026".encode() in data
    assert b"two" not in data


def test_the_hash_is_that_of_elf_files():
    # From the System V Application Binary Interface: h = 0x077905a6 for "printf".
    assert tool._hash(b"printf") == 0x077905A6
    assert tool._hash(b"") == 1
