# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of the tree, for the tests of the house."""

import os
from pathlib import Path

ROOT = Path(os.environ["SEAMWRIGHT_SOURCE"])
CODE = (".cpp", ".hpp", ".py", ".i", ".FCMacro")
LANGUAGES = ("core", "occ_adapter", "plugin", "tests", "samples", "benchmarks")
FOLDERS = (*LANGUAGES, "tools", "cmake", "docs")


def texts(folders=FOLDERS, endings=None):
    """Path from the root and text of each file of these folders; endings: all, or those."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if not path.is_file() or "__pycache__" in path.parts:
                continue
            if endings is not None and path.suffix not in endings:
                continue
            try:
                yield path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                continue  # a picture or a document
