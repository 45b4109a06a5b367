# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests of the command."""

import pathlib
import sys

import pytest

from models import box_text

# A failure in these helpers shows its values, as one in a test does.
pytest.register_assert_rewrite("repairs", "curves")

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))


@pytest.fixture
def box(tmp_path):
    """The file of a box of 10 by 20 by 30, alone in its folder."""
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path
