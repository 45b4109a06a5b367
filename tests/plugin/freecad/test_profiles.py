# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named tolerances are those that docs/seams.md states."""

import pytest

from freecad.seamwright.plain import profiles

#: gap in mm, angle in degrees, curvature; and what the panel says.
STATED = {
    "default": (0.01, 0.1, 0.02,
                "mechanical parts: gap 0.01 mm, angle 0.1\u00b0, curvature 2 %"),
    "class-a": (0.001, 0.01, 0.02,
                "visible surfaces, judged by their reflections: gap 0.001 mm, angle 0.01\u00b0, "
                "curvature 2 %"),
    "vda": (0.02, 0.1, 0.1,
            "exchange of surfaces between CAD systems: gap 0.02 mm, angle 0.1\u00b0, curvature "
            "10 %"),
}  # fmt: skip


@pytest.mark.parametrize("name", STATED)
def test_profiles_are_those_of_the_documentation(name):
    gap_mm, angle_deg, curvature_rel, tip = STATED[name]
    assert profiles.PROFILES[name] == {
        "gap_mm": gap_mm, "angle_deg": angle_deg, "curvature_rel": curvature_rel,
        "flat_radius_mm": 100000.0, "crease_deg": 5.0,
    }  # fmt: skip
    assert profiles.tip(name) == tip


def test_profiles_have_names():
    assert list(profiles.PROFILES) == list(STATED)
    assert [label for label, _ in profiles.LABELS.values()] == ["Default", "Class A", "VDA"]


@pytest.mark.parametrize("change, name", [(0.0, "vda"), (1e-15, "vda"), (1e-9, None)])
def test_a_profile_is_known_up_to_rounding(change, name):
    given = {key: value * (1 + change) for key, value in profiles.PROFILES["vda"].items()}
    assert profiles.name_of(given) == name


def test_of_equal_profiles_the_first_is_named():
    assert profiles.name_of({"angle_deg": 0.1}) == "default"
    assert profiles.name_of({"angle_deg": 0.1, "curvature_rel": 0.1}) == "vda"
