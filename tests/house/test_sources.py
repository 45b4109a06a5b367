# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the code names as its source can be opened in this tree.

A citation is what follows the word `Source:`, up to the first period before white space. It names,
between semicolons, statements (docs/theory/surfaces.md S1.2, S2.1 to S2.3), whole pages
(docs/theory/repair.md) or works ([Farin2002]). What stands in parentheses is an explanation.
"""

import os
import re
from collections import Counter
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
FOLDERS = (
    ".ci",
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
BIBLIOGRAPHY = "docs/bibliography.md"
WORD = "Source:"
NUMBER = r"[A-Z]\d+(?:\.\d+)?"
KEY = r"[A-Za-z]+\d{4}[a-z]?"
CITATION = re.compile(rf"(?<![\w.]){WORD}\s+(.*?)(?:\.(?=\s|$)|\Z)", re.S)
STATEMENTS = re.compile(rf"(docs/[\w./-]+\.md)(?: ({NUMBER}(?:(?:, | to | and ){NUMBER})*))?")
STATEMENT = re.compile(rf'(?:<a id="([^"]*)"></a>)?\*\*({NUMBER})\*\*')
ENTRY = re.compile(rf'^- <a id="([^"]*)"></a>\*\*\[({KEY})\]\*\*', re.M)


def texts():
    """Each text file of the tree, by its path."""
    found = {}
    paths = [*SOURCE.glob("*"), *(path for name in FOLDERS for path in (SOURCE / name).rglob("*"))]
    for path in sorted(paths):
        if not path.is_file() or "__pycache__" in path.parts:
            continue
        try:
            found[path.relative_to(SOURCE).as_posix()] = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            pass  # a picture or a model
    return found


TEXTS = texts()


def citations(text):
    """What a text cites, with comment signs and line ends taken out."""
    plain = re.sub(r"^[ \t]*(?://[/!]?|#)?[ \t]*", "", text, flags=re.M)
    paragraphs = re.split(r"\n\s*\n", plain)
    return [" ".join(match.split()) for part in paragraphs for match in CITATION.findall(part)]


def statements(text):
    """Pairs of anchor and number in a page of the theory."""
    return STATEMENT.findall(text)


THEORY = {name: text for name, text in TEXTS.items() if re.fullmatch(r"docs/theory/\S+\.md", name)}
NUMBERS = {name: [number for _, number in statements(text)] for name, text in THEORY.items()}
KEYS = [key for _, key in ENTRY.findall(TEXTS.get(BIBLIOGRAPHY, ""))]


def faults(citation):
    """Why a citation cannot be followed; empty if it can."""
    found, named = [], 0
    for part in re.sub(r"\([^)]*\)", "", citation).split(";"):
        part = part.strip()
        key, page = re.fullmatch(rf"\[({KEY})\]", part), STATEMENTS.fullmatch(part)
        if key:
            named += 1
            if key[1] not in KEYS:
                found.append(f"{part} is not in the bibliography")
        elif page:
            named += 1
            name, numbers = page[1], re.findall(NUMBER, page[2] or "")
            if name not in TEXTS:
                found.append(f"there is no page {name}")
            known = NUMBERS.get(name, [])
            found += [f"{name} has no {number}" for number in numbers if number not in known]
        else:
            found.append(f"'{part}' names nothing")
    return found if named else [*found, "nothing is named"]


def test_every_source_can_be_followed():
    cited = [(name, citation) for name, text in TEXTS.items() for citation in citations(text)]
    assert len(cited) > 50, "where are the citations?"
    wrong = [(name, citation, faults(citation)) for name, citation in cited if faults(citation)]
    assert wrong == []


def test_nothing_names_texts_that_are_not_in_the_tree():
    outside = re.compile(r"(?:MATH|ERRATA)-|text 00\d")
    wrong = [
        (name, number)
        for name, text in TEXTS.items()
        for number, line in enumerate(text.splitlines(), 1)
        if outside.search(line)
    ]
    assert wrong == []


def test_every_statement_has_one_number_and_its_anchor():
    assert {name for name in NUMBERS if NUMBERS[name]} == set(THEORY)
    count = Counter(number for numbers in NUMBERS.values() for number in numbers)
    assert [number for number, times in count.items() if times > 1] == []
    wrong = [
        (name, anchor, number)
        for name, text in THEORY.items()
        for anchor, number in statements(text)
        if anchor != number.lower().replace(".", "-")
    ]
    assert wrong == []


def test_theory_refers_to_statements_and_works_that_exist():
    known = {number for numbers in NUMBERS.values() for number in numbers}
    anchors = {number.lower().replace(".", "-") for number in known} | {key.lower() for key in KEYS}
    wrong = []
    for name, text in THEORY.items():
        numbers = re.findall(r"(?<![\w.])[A-Z]\d+\.\d+(?![\w.]?\d)", text)
        wrong += [(name, number) for number in numbers if number not in known]
        wrong += [(name, key) for key in re.findall(rf"\[({KEY})\]", text) if key not in KEYS]
        targets = re.findall(r"#([a-z]\d+(?:-\d+)?)\)|bibliography\.md#(\S+)", text)
        wrong += [(name, target) for target in map("".join, targets) if target not in anchors]
    assert wrong == []


def test_every_work_is_listed_once_and_cited():
    entries = ENTRY.findall(TEXTS[BIBLIOGRAPHY])
    assert [(anchor, key) for anchor, key in entries if anchor != key.lower()] == []
    assert [key for key, times in Counter(key for _, key in entries).items() if times > 1] == []
    cited = {
        key
        for name, text in TEXTS.items()
        if name != BIBLIOGRAPHY and Path(name).name != Path(__file__).name
        for key in re.findall(rf"\[({KEY})\](?!:)", text)
    }
    assert [key for _, key in entries if key not in cited] == []


def test_data_name_the_page_that_they_follow():
    wrong = [
        (name, page)
        for name, text in TEXTS.items()
        if name.startswith("tests/data/")
        for page in re.findall(r'"spec"\s*:\s*"([^"]*)"', text)
        if page not in TEXTS
    ]
    assert wrong == []


@pytest.mark.parametrize(
    "citation, fault",
    [
        ("docs/theory/surfaces.md S1.1", None),
        ("docs/theory/surfaces.md S1.1, S1.3 to S1.5 (without samples); [PegnaWolter1992]", None),
        ("docs/theory/repair.md", None),
        ("docs/theory/surfaces.md S1.99", "has no S1.99"),
        ("docs/theory/surfaces.md S1.1 to S1.99", "has no S1.99"),
        ("docs/theory/surfaces.md F1.1", "has no F1.1"),
        ("docs/theory/spheres.md S1.1", "there is no page docs/theory/spheres.md"),
        ("[Nobody1901]", "[Nobody1901] is not in the bibliography"),
        ("docs/theory/surfaces.md S1.1; a chapter", "'a chapter' names nothing"),
        ("(derived here)", "nothing is named"),
    ],
)
def test_made_up_sources_are_told_from_true_ones(citation, fault):
    found = faults(citation)
    assert found == [] if fault is None else any(fault in text for text in found), found


def test_citations_are_read_from_comments_and_paragraphs():
    code = (
        f"int a;\n/// What it does. {WORD} docs/theory/surfaces.md S1.2,\n"
        f"/// S1.3; [Farin2002]. More.\nint b = this.{WORD} 1;\n"
    )
    assert citations(code) == ["docs/theory/surfaces.md S1.2, S1.3; [Farin2002]"]
    assert citations(f"# {WORD} [Farin2002].\n\ntext") == ["[Farin2002]"]
    assert citations(f"{WORD} without an end\n\nAnother paragraph.") == ["without an end"]
