# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every code of a reason is in the schema of its report, and in the docs with a remedy."""

import json
import os
import re
from pathlib import Path

import pytest

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
# Code that makes the codes, its schema with the path to them, and the page that explains them.
REASONS = {
    "repair": (
        "occ_adapter/repair/reasons.cpp",
        "docs/repair-1.schema.json",
        ("$defs", "repaired_seam", "properties", "reason_code"),
        "docs/repair.md",
    ),
    "sewing": (
        "occ_adapter/topology/sew_reasons.cpp",
        "docs/repair-1.schema.json",
        ("$defs", "repaired_seam", "properties", "not_sewn_code"),
        "docs/repair.md",
    ),
}


def codes_of(path):
    text = (SOURCE / path).read_text(encoding="utf-8")
    (array,) = re.findall(r"constexpr std::array \w*codes = \{([^}]*)\}", text)
    return re.findall(r'"(\w*)"', array)


def explained_in(page):
    """The codes in the first column of tables."""
    rows = re.findall(r"^\| (`[^|]*) \|", (SOURCE / page).read_text(encoding="utf-8"), re.M)
    return {code for row in rows for code in re.findall(r"`(\w+)`", row)}


@pytest.mark.parametrize("domain", REASONS)
def test_codes_are_in_the_schema_and_in_the_docs(domain):
    source, schema, keys, page = REASONS[domain]
    codes = codes_of(source)
    assert codes[0] == "" and len(codes) > 2
    part = json.loads((SOURCE / schema).read_text(encoding="utf-8"))
    for key in keys:
        part = part[key]
    assert part["enum"] == codes
    assert set(codes[1:]) - explained_in(page) == set()
