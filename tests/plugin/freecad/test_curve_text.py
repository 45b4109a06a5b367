# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences about curves that were made, word by word."""

import pytest

from freecad.seamwright.plain import curve_text

#: Of 78.34 mm length, with three extrema and one inflection.
FIGURES = {"length_mm": 78.34, "extrema": 3, "inflections": 1}
FIGURES_TEXT = "78.3 mm long; curvature: 3 extrema, 1 inflection"


def test_upper_bounds_are_rounded_up():
    assert curve_text.bound(0.12301) == "0.124"
    assert curve_text.bound(0.123) == "0.123"
    assert curve_text.bound(0) == "0"


def test_lines_without_arcs_are_proven():
    report = {"curves": 1, "arcs": 0, "lines": 3, "length_mm": 20.0, "distance_mm": 0.0,
              "least_arcs": 2}  # fmt: skip
    assert curve_text.arcs_text(report) == (
        "No arcs and 3 lines, 20 mm long, at most 0 mm from the input (proven)."
    )


def fair(**changed):
    return {
        "before": {"extrema": 9, "inflections": 4},
        "after": {"extrema": 3, "inflections": 0},
        "moved_mm": 0.01234,
        "kept": 0,
        "variation_before_per_mm3": None,
        "variation_after_per_mm3": None,
        **changed,
    }


def test_a_fair_curve_is_told_before_and_after():
    text = "Curvature extrema 9 \u2192 3, inflections 4 \u2192 0%s; moved at most 0.0124 mm%s."
    assert curve_text.fair_text(fair()) == text % ("", "")
    assert curve_text.fair_text(fair(kept=1)) == text % ("", "; 1 edge kept as given")
    assert curve_text.fair_text(fair(kept=2)) == text % ("", "; 2 edges kept as given")


@pytest.mark.parametrize(
    "before, after, told",
    [
        (2e-4, 5e-5, " 2e-4 \u2192 5e-5 1/mm\u00b3 (75 % less)"),
        (0.02, 0.025, " 0.02 \u2192 0.025 1/mm\u00b3 (25 % more)"),
        (0.03, 0.07, " 0.03 \u2192 0.07 1/mm\u00b3 (133 % more)"),
        (0.03, 0.02, " 0.03 \u2192 0.02 1/mm\u00b3 (33 % less)"),
        (0.03, 0.0, " 0.03 \u2192 0 1/mm\u00b3 (100 % less)"),
        (0.02, 0.02, " 0.02 \u2192 0.02 1/mm\u00b3"),
    ],
)
def test_the_variation_of_curvature_is_compared(before, after, told):
    report = fair(variation_before_per_mm3=before, variation_after_per_mm3=after)
    assert ", inflections 4 \u2192 0, variation of curvature%s; moved" % told in (
        curve_text.fair_text(report)
    )


@pytest.mark.parametrize("before, after", [(None, 0.1), (0.0, 0.1), (0.1, None)])
def test_a_variation_that_is_unknown_is_not_told(before, after):
    report = fair(variation_before_per_mm3=before, variation_after_per_mm3=after)
    assert "variation" not in curve_text.fair_text(report)


def test_a_spline_goes_through_points_or_near_their_polygon():
    report = {**FIGURES, "points": 7, "interpolates": True}
    assert curve_text.spline_text(report) == "Through 7 points, %s." % FIGURES_TEXT
    assert curve_text.spline_text({**report, "interpolates": False}) == (
        "Near the polygon of 7 points, %s." % FIGURES_TEXT
    )


def test_clothoids_tell_their_sharpest_place():
    report = {"pieces": 3, "length_mm": 78.34, "distance_mm": 0.0099501, "least_radius_mm": 12.5}
    assert curve_text.clothoid_text(report) == (
        "3 pieces, 78.3 mm long, smallest radius 12.5 mm, at most 0.00996 mm from the input."
    )
    straight = {**report, "pieces": 1, "least_radius_mm": None, "curves": 1}
    assert curve_text.clothoid_text(straight) == (
        "1 piece, 78.3 mm long, straight, at most 0.00996 mm from the input."
    )
    assert curve_text.clothoid_text({**straight, "curves": 2}) == (
        "1 piece, 78.3 mm long, straight, at most 0.00996 mm from the input. There are 2 separate "
        "curves: edges that do not touch are not joined; Bridge Curve does that."
    )


def test_a_logarithmic_spiral_is_a_spline_or_arcs():
    report = {"length_mm": 78.34, "turn_deg": 270.0, "first_radius_mm": 5.0,
              "last_radius_mm": 24.06, "arcs": 6, "distance_mm": None}  # fmt: skip
    text = "78.3 mm long, turns by 270\u00b0, radius 5 to 24.1 mm, %s."
    assert curve_text.log_spiral_text(report) == (
        text % "as 6 arcs of one sweep"
    )
    near = {**report, "distance_mm": 0.0}
    assert curve_text.log_spiral_text(near) == text % "at most 0 mm from the spiral"


@pytest.mark.parametrize(
    "weight, kind",
    [
        (1.0, "A parabola"), (1 + 5e-10, "A parabola"), (1 - 5e-10, "A parabola"),
        (0.7, "An ellipse of weight 0.7"), (0.999, "An ellipse of weight 0.999"),
        (1.5, "A hyperbola of weight 1.5"), (1.001, "A hyperbola of weight 1"),
    ],
)  # fmt: skip
def test_the_weight_of_a_conic_says_its_kind(weight, kind):
    """As for a rational quadratic of Bezier: below 1 an ellipse, above it a hyperbola."""
    report = {"conics": 1, "least_weight": weight, "largest_weight": weight, "length_mm": 10.0,
              "g1_joints": 0}  # fmt: skip
    assert curve_text.conic_text(report) == kind + ", 10 mm long."


def test_several_conics_tell_their_jumps_and_their_distance():
    report = {"conics": 3, "least_weight": 0.5, "largest_weight": 1.0, "length_mm": 10.0,
              "g1_joints": 0, "distance_mm": None}  # fmt: skip
    text = "3 conics of weights 0.5 to 1, 10 mm long%s."
    assert curve_text.conic_text(report) == text % ""
    told = {**report, "g1_joints": 2, "distance_mm": 0.0201}
    assert curve_text.conic_text(told) == text % (
        "; 2 joints with a jump of the curvature; seen up to 0.0201 mm from the edges"
    )
    near = {**report, "g1_joints": 1, "distance_mm": 0.0}
    assert curve_text.conic_text(near) == text % (
        "; 1 joint with a jump of the curvature; seen up to 0 mm from the edges"
    )


def test_curves_between_curves():
    report = {"frames": 5, "faces": 2, "surface": False, "keys": 3, "distance_mm": 1e-4,
              "order": 2, "features": 4}  # fmt: skip
    text = "%s between 3 curves, within 1e-4 mm; joints keep up to G2, %s paired."
    assert curve_text.blend_text(report) == text % ("5 curves", "4 features")
    assert curve_text.blend_text({**report, "surface": True, "features": 0}) == (
        text % ("Surface of 2 faces", "no features")
    )


def test_joined_curves_move_poles_or_points():
    report = {"order": 2, "gap_mm": 0.25, "moved_mm": 0.1251}
    text = "Joined G2; the ends were 0.25 mm apart, no %s moved further than 0.126 mm."
    assert curve_text.join_text(report) == text % "pole"
    assert curve_text.join_text({**report, "continued": True}) == text % "point"


def test_a_bridge_tells_both_ends():
    assert curve_text.bridge_text({**FIGURES, "orders": ("G2", "G1")}) == (
        "Joins the first edge G2 and the second G1, %s." % FIGURES_TEXT
    )
