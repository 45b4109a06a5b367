# SPDX-License-Identifier: LGPL-2.1-or-later
"""The data of tests are what their scripts compute."""

import importlib
import os
import sys
from pathlib import Path

import pytest

DATA = Path(os.environ["SEAMWRIGHT_SOURCE"]) / "tests" / "data"
sys.path.insert(0, str(DATA / "scripts"))

import oracle

# Takes longer than all others: to be run by hand.
SLOW = {"seam_measures"}
# No oracles: texts that two programs share.
TEXTS = {"enclosure_texts"}
NAMES = sorted(path.stem for path in DATA.glob("*.json"))


def test_every_file_has_a_script():
    scripts = {path.stem for path in (DATA / "scripts").glob("*.py")}
    assert set(NAMES) - scripts == TEXTS


@pytest.mark.parametrize("name", sorted(set(NAMES) - SLOW - TEXTS))
def test_figures_are_recomputed(name):
    script = importlib.import_module(name)
    found, count = oracle.faults(name, script.expected, getattr(script, "SURE", oracle.SURE))
    assert found == [] and count > 0
