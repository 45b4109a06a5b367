# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours and the words of classes and levels of seams."""

import pytest

from freecad.seamwright.plain import palette

#: The colours that docs/workbench.md states.
STATED = {
    "defect": "#d55e00", "crease": "#2846a0", "smooth": "#009e73",
    "none": "#6e001e", "G0": "#d55e00", "G1": "#f0b43c", "G2": "#4696dc", "G3": "#1e3282",
}  # fmt: skip


@pytest.fixture
def chosen():
    yield palette.use
    palette.use({})


def test_colours_are_those_of_the_documentation():
    found = {entry.key: entry.html for entry in (*palette.CLASSES, *palette.LEVELS)}
    assert found == STATED


def test_chosen_colours_replace_those_of_their_keys_only(chosen):
    chosen({"crease": (255, 51, 0)})
    assert (palette.CREASE.rgb, palette.CREASE.html) == ((255, 51, 0), "#ff3300")
    assert palette.CREASE.unit_rgb == pytest.approx((1.0, 0.2, 0.0))
    assert palette.SMOOTH.html == "#009e73"
    chosen({"smooth": (0, 0, 1)})
    assert (palette.CREASE.html, palette.SMOOTH.html) == ("#2846a0", "#000001")


@pytest.mark.parametrize(
    "rgb, number",
    [((0x12, 0x34, 0x56), 0x12345600), ((255, 0, 254), 0xFF00FE00), ((0, 255, 1), 0x00FF0100)],
)
def test_a_packed_colour_is_that_of_freecad(rgb, number):
    assert palette.packed(rgb) == number
    assert palette.unpacked(number) == rgb
    assert palette.unpacked(number | 0xFF) == rgb, "the last byte is no colour"


def test_classes_are_told_by_the_level():
    assert palette.meaning("smooth", "G2", 5.0) == "meets G2"
    assert palette.meaning("defect", "G2", 5.0) == "falls short of G2"
    assert palette.meaning("crease", "G2", 7.5) == "sharper than 7.5\u00b0, taken as intended"


def test_levels_are_told_in_words():
    assert palette.LEVEL_MEANINGS == {
        "none": "gap larger than the tolerance",
        "G0": "meet with an angle",
        "G1": "meet without a kink",
        "G2": "equal curvature",
        "G3": "equal change of curvature",
    }
    assert [level.name for level in palette.LEVELS] == ["No level", "G0", "G1", "G2", "G3"]
