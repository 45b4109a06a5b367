# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences: what is allowed, what is used of what is stored."""

import math

import pytest

from freecad.seamwright.plain import palette, preferences

BY_NAME = {each.name: each for each in preferences.ALL}

#: {name: (default, least, largest, label)}
NUMBERS = {
    "GapTolerance": (0.01, 1e-9, 1e6, "Gap tolerance"),
    "AngleTolerance": (0.1, 1e-9, 90, "Angle tolerance"),
    "CurvatureTolerance": (0.02, 1e-9, 1, "Curvature tolerance"),
    "FlatRadius": (1e5, 1e-3, 1e12, "Flat above radius"),
    "CreaseAngle": (5, 1e-9, 90, "Crease angle"),
    "Threads": (0, 0, 256, "Threads"),
    "CombLines": (40, 2, 1000, "Lines of a comb"),
    "ZebraStripes": (16, 2, 200, "Zebra stripes on a ball"),
    "ColourDefect": (0xD55E0000, 0, 0xFFFFFFFF, "Defect"),
    "ColourG3": (0x1E328200, 0, 0xFFFFFFFF, "G3"),
}


@pytest.mark.parametrize("name", NUMBERS)
def test_numbers_have_their_ends_and_nothing_beyond(name):
    preference, (default, least, largest, label) = BY_NAME[name], NUMBERS[name]
    assert (preference.default, preference.label) == (default, label)
    for value in (default, least, largest):
        assert preferences.is_allowed(preference, value)
    for value in (least - 1, least * (1 - 1e-9) - 1e-15, largest + 1, largest * (1 + 1e-9)):
        assert not preferences.is_allowed(preference, value)


def test_each_class_and_level_has_a_colour():
    names = ["Defect", "Crease", "Smooth", "None", "G0", "G1", "G2", "G3"]
    colours = [each for each in preferences.ALL if each.name.startswith("Colour")]
    assert [each.name for each in colours] == ["Colour" + name for name in names]
    for each, entry in zip(colours, (*palette.CLASSES, *palette.LEVELS)):
        assert palette.unpacked(each.default) == entry.standard_rgb


def test_counts_are_whole_and_numbers_finite():
    assert preferences.is_allowed(BY_NAME["CombLines"], 41.0)
    assert not preferences.is_allowed(BY_NAME["CombLines"], 40.5)
    for value in (math.nan, math.inf, -math.inf):
        assert preferences.is_allowed(BY_NAME["CombLines"], value) is False
    assert preferences.is_allowed(BY_NAME["CombLines"], 40.5) is False
    assert preferences.is_allowed(BY_NAME["GapTolerance"], 0.5)
    assert not preferences.is_allowed(BY_NAME["GapTolerance"], math.nan)
    assert not preferences.is_allowed(preferences.Preference("Any", 1.0, "Any"), math.inf)
    assert preferences.is_allowed(preferences.Preference("Any", 1.0, "Any"), -1e300)


def test_a_switch_is_on_at_first_and_takes_no_numbers():
    live = BY_NAME["LivePreview"]
    assert live.default is True and live.label == "Preview while fields are changed"
    assert preferences.is_allowed(live, False) and preferences.is_allowed(live, True)
    assert not preferences.is_allowed(live, 1)


@pytest.mark.parametrize(
    "name, value, text",
    [
        ("AngleTolerance", 100, "Angle tolerance cannot be 100: choose from 1e-09 to 90"),
        ("CombLines", 1, "Lines of a comb cannot be 1: choose from 2 to 1000"),
        ("CreaseAngle", 0.05, "The crease angle, 0.05\u00b0, must be larger than the angle "
                              "tolerance, 0.1\u00b0"),
        ("CreaseAngle", 0.1, "The crease angle, 0.1\u00b0, must be larger than the angle "
                             "tolerance, 0.1\u00b0"),
    ],
)  # fmt: skip
def test_what_is_not_allowed_is_named(name, value, text):
    with pytest.raises(ValueError) as caught:
        preferences.check({**preferences.defaults(), name: value})
    assert str(caught.value) == text
    preferences.check(preferences.defaults())


def test_a_stored_value_that_is_not_allowed_is_ignored():
    found = preferences.usable({**preferences.defaults(), "CombLines": 0, "ZebraStripes": 8})
    assert found == {**preferences.defaults(), "ZebraStripes": 8}


def test_tolerances_that_contradict_each_other_are_ignored_together():
    stored = {"GapTolerance": 0.5, "AngleTolerance": 3.0, "CreaseAngle": 2.0, "CombLines": 7}
    found = preferences.usable({**preferences.defaults(), **stored})
    assert found == {**preferences.defaults(), "CombLines": 7}


def test_tolerances_are_those_of_the_kernel():
    found = {each.argument: each.default for each in preferences.ALL if each.argument}
    assert found == {
        "gap_mm": 0.01, "angle_deg": 0.1, "curvature_rel": 0.02,
        "flat_radius_mm": 1e5, "crease_deg": 5.0,
    }  # fmt: skip
