# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests of the command."""

import pytest

from models import box_text


@pytest.fixture
def box(tmp_path):
    """The file of a box of 10 by 20 by 30, alone in its folder."""
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path
