# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every code of a reason is in the schema of its report, and in the docs with a remedy."""

import json
import os
import re
from pathlib import Path
from typing import NamedTuple

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])


class Domain(NamedTuple):
    source: str  # makes the codes
    header: str  # has the enum
    enum: str
    page: str  # explains the codes
    tables: tuple  # of codes on the page, counted from 0
    schema: str = ""  # empty: reports of this kind have no schema
    keys: tuple = ()  # path to the property
    reported: tuple = ()  # first and last code that reports can have; empty: all
    cause_keys: tuple = ()  # path to the property of causes, which have the codes after those


REASONS = {
    "repair": Domain(
        source="occ_adapter/repair/reasons.cpp",
        header="occ_adapter/repair/repair_reason.hpp",
        enum="RepairFault",
        page="docs/repair.md",
        tables=(0,),
        schema="docs/repair-1.schema.json",
        keys=("$defs", "repaired_seam", "properties", "reason_code"),
    ),
    "sewing": Domain(
        source="occ_adapter/topology/sew_reasons.cpp",
        header="occ_adapter/topology/sew_reason.hpp",
        enum="SewFault",
        page="docs/repair.md",
        tables=(1,),
        schema="docs/repair-1.schema.json",
        keys=("$defs", "repaired_seam", "properties", "not_sewn_code"),
    ),
    "match": Domain(
        source="occ_adapter/match/match_reasons.cpp",
        header="occ_adapter/match/match_reason.hpp",
        enum="MatchFault",
        page="docs/match.md",
        tables=(0, 1),
        schema="docs/match-1.schema.json",
        keys=("properties", "reason_code"),
    ),
    "fill": Domain(
        source="occ_adapter/fill/fill_reason.cpp",
        header="occ_adapter/fill/fill_reason.hpp",
        enum="FillFault",
        page="docs/fill.md",
        tables=(0, 1),
        schema="docs/fill-1.schema.json",
        keys=("properties", "reason_code"),
        reported=("unusable_boundary", "invalid_shape"),
        cause_keys=("$defs", "cause", "properties", "code"),
    ),
    # A corner that is refused has no report.
    "corner": Domain(
        source="occ_adapter/fill/corner_reasons.cpp",
        header="occ_adapter/fill/corner_reason.hpp",
        enum="CornerFault",
        page="docs/corner_fillet.md",
        tables=(0, 1),
        schema="docs/corner-1.schema.json",
        keys=("properties", "shortfall_code"),
        reported=("checks_fail", "misses_target"),
    ),
}


def text_of(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def codes_of(path):
    (array,) = re.findall(r"constexpr std::array \w*codes = \{([^}]*)\}", text_of(path))
    return re.findall(r'"(\w*)"', array)


def in_schema(path, keys):
    """The codes that the schema allows for a property."""
    part = json.loads(text_of(path))
    for key in keys:
        part = part[key]
    return part["enum"]


def enumerators(path, enum):
    (body,) = re.findall(rf"enum class {enum} \{{([^}}]*)\}}", text_of(path))
    return re.findall(r"\w+", re.sub(r"//[^\n]*", "", body))


def tables_of(page):
    """Of each table of codes on the page: the cells of its rows."""
    table = r"^\| code \| meaning \| remedy \|\n\|[-|]+\|\n((?:\|.*\n)+)"
    return [
        [line.strip("| ").split(" | ") for line in rows.splitlines()]
        for rows in re.findall(table, text_of(page), re.M)
    ]


def test_every_enum_of_faults_is_here():
    found = {
        (path.relative_to(SOURCE).as_posix(), enum)
        for folder in ("core", "occ_adapter", "plugin")
        for path in (SOURCE / folder).rglob("*.hpp")
        for enum in re.findall(r"\bcodeOf\((\w+) fault\)", path.read_text(encoding="utf-8"))
    }
    assert found == {(domain.header, domain.enum) for domain in REASONS.values()}


@pytest.mark.parametrize("domain", REASONS.values(), ids=REASONS)
def test_codes_are_the_names_of_the_faults(domain):
    names = enumerators(domain.header, domain.enum)
    snakes = [re.sub(r"(?<=[a-z])(?=[A-Z0-9])", "_", name).lower() for name in names]
    snakes = [name.replace("open_cascade", "opencascade") for name in snakes]
    codes = codes_of(domain.source)
    assert snakes[0] == "none" and codes[0] == "" and len(codes) > 2
    assert codes[1:] == snakes[1:]


@pytest.mark.parametrize(
    "domain", [domain for domain in REASONS.values() if domain.schema], ids=lambda d: d.enum
)
def test_codes_are_in_the_schema(domain):
    codes = codes_of(domain.source)
    if domain.reported:
        first, last = (codes.index(code) for code in domain.reported)
        codes = ["", *codes[first : last + 1]]
    assert in_schema(domain.schema, domain.keys) == codes


@pytest.mark.parametrize(
    "domain", [domain for domain in REASONS.values() if domain.cause_keys], ids=lambda d: d.enum
)
def test_codes_of_causes_are_in_the_schema(domain):
    codes = codes_of(domain.source)
    causes = codes[codes.index(domain.reported[1]) + 1 :]
    assert causes and in_schema(domain.schema, domain.cause_keys) == causes


@pytest.mark.parametrize("domain", REASONS.values(), ids=REASONS)
def test_codes_are_in_the_docs_with_a_remedy(domain):
    tables = tables_of(domain.page)
    rows = [row for k in domain.tables for row in tables[k]]
    assert [row for row in rows if len(row) != 3 or not all(cell.strip() for cell in row)] == []
    explained = [code for row in rows for code in re.findall(r"`(\w+)`", row[0])]
    assert sorted(explained) == sorted(codes_of(domain.source)[1:])


def test_every_table_of_codes_is_of_a_domain():
    pages = {domain.page for domain in REASONS.values()}
    for page in pages:
        taken = [k for domain in REASONS.values() if domain.page == page for k in domain.tables]
        assert sorted(taken) == list(range(len(tables_of(page)))), page
