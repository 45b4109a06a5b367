# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about the architecture names files and functions that exist, and the graph as it is."""

import os
import re
import subprocess
from pathlib import Path

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
PAGE = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
PATH = re.compile(r"`((?:core|occ_adapter|plugin|tools)/[\w/.]+)`")


def test_files_exist():
    names = PATH.findall(PAGE)
    assert len(names) > 20
    assert [name for name in names if not (SOURCE / name).exists()] == []


def test_functions_stand_in_the_files_named_with_them():
    pairs = re.findall(r"`(\w+)\(\)`\s+in\s+`([\w/.]+)`", PAGE)
    assert len(pairs) > 8
    assert [
        (name, path)
        for name, path in pairs
        if not re.search(rf"\b{name}\(", (SOURCE / path).read_text(encoding="utf-8"))
    ] == []


def test_graph_is_that_of_the_sources():
    shown = re.search(r"<!-- graph -->\n```mermaid\n(.*?)```\n<!-- end of graph -->", PAGE, re.S)[1]
    made = subprocess.run(
        [SOURCE / "tools/measures", "--graph"], capture_output=True, text=True, check=True
    ).stdout
    assert shown == made
