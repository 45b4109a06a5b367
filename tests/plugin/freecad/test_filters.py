# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choices of *Show*."""

from freecad.seamwright.plain import filters


def test_the_choices_of_the_panel():
    assert filters.NAMES == [
        "All seams", "Not smooth", "Defect", "Crease", "Smooth", "Uncertain"
    ]  # fmt: skip
    assert [filters.of(name) for name in filters.NAMES] == [
        None, "not smooth", "defect", "crease", "smooth", "uncertain"
    ]  # fmt: skip
