# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summaries of the analysis tools, word by word."""

import pytest

from freecad.seamwright.plain import map_text

MESH = {"faces": 1, "points": 121, "faults": []}


def curved(**changed):
    return {"quantity": "Mean", "unit": "1/mm", "undefined": False, "least": -0.1, "largest": 0.2,
            "least_at": [1, 2, 3], "largest_at": [4.0000004, -5e-7, -0.25], **MESH,
            **changed}  # fmt: skip


def test_places_have_signs_and_no_noise():
    assert map_text.curvature_text(curved()) == (
        "Mean curvature \u22120.1 to 0.2 1/mm, the strongest at (4, 0, \u22120.25). 1 face, "
        "121 points."
    )


def test_the_smallest_radius_is_told_with_its_place():
    report = curved(quantity="Smallest radius", unit="mm", least=12.34, largest=50.0)
    assert map_text.curvature_text(report) == (
        "Smallest radius 12.3 mm at (1, 2, 3). 1 face, 121 points."
    )


@pytest.mark.parametrize("quantity, text", [
    ("Mean", "No value is defined. 1 face, 121 points."),
    ("Smallest radius", "The faces are flat: they have no radius. 1 face, 121 points."),
])
def test_a_map_without_values_says_so_in_a_sentence(quantity, text):
    report = curved(quantity=quantity, undefined=True, least=0.0, largest=0.0, least_at=None,
                    largest_at=None)  # fmt: skip
    assert map_text.curvature_text(report) == text


def test_faces_that_are_not_drawn_correctly_are_counted():
    faults = [{"face": 1}, {"face": 2}]
    text = map_text.reflection_text({"lines": "Isophotes", **MESH, "faults": faults})
    assert text == "Isophotes. 1 face, 121 points, 2 faces not drawn correctly."
    assert map_text.reflection_text({"lines": "Zebra stripes", **MESH}) == (
        "Zebra stripes. 1 face, 121 points."
    )


def test_shares_of_draft_angles_are_in_percent():
    shares = {"towards": 0.5, "away": 0.12344, "steep": 0.37656}
    assert map_text.draft_text({"shares": shares, **MESH}) == (
        "Of the area, 50 % drafts towards the pull, 12.3 % away, 37.7 % is too steep. "
        "1 face, 121 points."
    )
    small = {"towards": 0.00164, "away": 0.00036, "steep": 0.998}
    assert map_text.draft_text({"shares": small, **MESH}).startswith(
        "Of the area, 0.2 % drafts towards the pull, 0 % away, 99.8 % is too steep. "
    )
    all_steep = {"towards": 0.0, "away": 1e-9, "steep": 1.0}
    assert map_text.draft_text({"shares": all_steep, **MESH}).startswith(
        "Of the area, 0 % drafts towards the pull, 0 % away, 100 % is too steep. "
    )


def test_a_deviation_is_sampled():
    report = {"undefined": False, "least": -0.02, "largest": 0.1, "furthest_mm": 0.1,
              "furthest_at": [1, 2, 3], "beyond": 0, **MESH}  # fmt: skip
    text = (
        "Largest deviation 0.1 mm at (1, 2, 3); \u22120.02 to 0.1 mm%s. "
        "Sampled at 121 points: between them it may be larger."
    )
    assert map_text.deviation_text(report) == text % ""
    assert map_text.deviation_text({**report, "beyond": 1}) == (
        text % "; 1 point beyond the edges of the other shape left out"
    )
    same = {**report, "furthest_mm": 0.0, "least": 0.0, "largest": 0.0}
    assert map_text.deviation_text(same) == (
        "No deviation above rounding. Sampled at 121 points: between them it may be larger."
    )
    assert map_text.deviation_text({**report, "undefined": True}) == (
        "No point lies over the other shape."
    )


def test_a_comb_tells_the_largest_curvature_and_its_radius():
    report = {"lines": 6, "largest_per_mm": 0.04, "largest_at": [0, 10, 0]}
    assert map_text.comb_text(report) == (
        "6 curves; largest curvature 0.04 1/mm, radius 25 mm, at (0, 10, 0). Sampled."
    )
    assert map_text.comb_text({**report, "lines": 1, "largest_per_mm": 0.0}) == (
        "1 curve; all are straight."
    )
