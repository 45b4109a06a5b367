# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said about fills, word by word."""

import pytest
from test_plain import seam

from freecad.seamwright.plain import fill_text

LIMITS = {"gap_mm": 0.01, "angle_deg": 0.1, "curvature_rel": 0.02}


def bounds(gap, angle=0.0, curvature=0.0):
    figures = {"gap_mm": gap, "angle_deg": angle, "curvature_rel": curvature}
    return {name: each and {"lower": 0.0, "upper": each} for name, each in figures.items()}


def missed(*seams):
    return {"filled": False, "reason_code": "may_miss_target", "seams": list(seams)}


@pytest.mark.parametrize(
    "between, number",
    [("fill, Face12", 12), ("fill, Face3", 3), ("the fill itself", None), ("fill, Face", None)],
)
def test_the_face_beside_a_fill(between, number):
    assert fill_text.face_beside({"between": between}) == number
    if number:
        assert fill_text.beside("Face%d" % number) == between


def test_inside_a_fill_both_faces_are_new():
    one = {**seam(1), "faces": [4, 5], "worst": {"quantity": "gap", "at": 0, "point": [1, 2, 3]}}
    found = {"filled": True, "reached": True, "reason": "", "reason_code": "", "target": "G1",
             "faces": [4, 5], "outer": [], "inner": [one, seam(2)]}  # fmt: skip
    entry = fill_text.entry(found, hole=1)
    assert entry["seams"][0]["between"] == "the fill itself"
    assert [each["point"] for each in entry["seams"]] == [[1, 2, 3], None]
    report = {"fills": [entry, {**entry, "seams": []}, entry]}
    assert fill_text.every_seam(report) == 2 * entry["seams"]


def test_what_has_to_be_allowed_is_told_in_the_units_of_the_fields():
    fill = missed(bounds(0.0201, 0.3, 0.0451))
    assert fill_text.allowing(fill, "G2") == {
        "gap_mm": 0.021, "angle_deg": 0.3, "curvature_rel": 0.046
    }  # fmt: skip
    assert fill_text.allowing_text(fill, "G2", LIMITS) == (
        "The best fill needs a gap tolerance of 0.021 mm, an angle tolerance of 0.3\u00b0, a "
        "curvature tolerance of 4.6 %; Keep anyway keeps it."
    )
    assert fill_text.allowing_text(missed(bounds(0.01, 0.1)), "G1", LIMITS) == ""


def test_a_figure_of_zero_needs_nothing_and_one_that_is_unknown_cannot_be_allowed():
    exact = missed({**bounds(0.5), "angle_deg": {"lower": 0.0, "upper": 0.0}})
    assert fill_text.allowing(exact, "G1") == {"gap_mm": 0.5, "angle_deg": 0.0}
    assert fill_text.allowing(missed({**bounds(0.5), "angle_deg": None}), "G1") == {}
    unbounded = {**bounds(0.5), "angle_deg": {"lower": 0.3, "upper": None}}
    assert fill_text.allowing(missed(unbounded), "G1") == {}
    assert fill_text.allowing(missed(bounds(0.5, 0.2), unbounded), "G1") == {}


def test_a_report_without_fills_has_no_face_to_name():
    text = fill_text.summary_text(fill_text.EMPTY_REPORT)
    assert text.startswith("0 of no holes filled") and "Face" not in text


def test_a_hole_is_told_where_it_is():
    one = {"id": 1, "sides": [], "has_corners": False, "longest": False, "length_mm": 12.344,
           "centre_mm": [-1e-10, 1e-8, -2.00004]}  # fmt: skip
    assert fill_text.hole_text(one, [one]) == (
        "Hole 1: no corner, length 12.34 mm, centre (0, 1e-08, -2)"
    )


def test_seams_of_a_fill_that_was_not_kept_have_no_numbers_and_no_worst_point():
    one = {**seam(3), "worst": {"quantity": "gap", "at": 0, "point": [1, 2, 3]}}
    found = {"filled": False, "reached": False, "reason": "it is too far", "reason_code": "",
             "target": "G1", "faces": [4], "outer": [one], "inner": []}  # fmt: skip
    entry = fill_text.entry(found, face=2)
    (kept,) = entry["seams"]
    assert (kept["edges"], kept["faces"], kept["worst"]) == ([], [], None)
    assert kept["point"] == [1, 2, 3]
    assert fill_text.new_faces({"fills": [entry]}) == (set(), None)


def test_a_fill_that_was_kept_anyway_needs_no_button():
    fill = {**missed(bounds(0.5, 0.2)), "filled": True, "reached": False, "hole": 1, "face": None,
            "reason": "a seam misses."}  # fmt: skip
    report = {"target": "G1", "tolerance": LIMITS, "fills": [fill]}
    assert fill_text.reasons(report) == ["Hole 1: a seam misses."]
    assert "Keep anyway" in fill_text.reasons({**report, "fills": [{**fill, "filled": False}]})[0]


def test_a_fill_with_waves_is_named():
    found = {"filled": True, "reached": True, "reason": "", "reason_code": "", "target": "G1",
             "faces": [4], "outer": [seam(1)], "inner": [], "waves": 2.34}  # fmt: skip
    entry = fill_text.entry(found, hole=2)
    assert fill_text.waves_text(entry) == (
        "Hole 2 bends both ways, 2.3 times as strongly as the faces around it: look at its "
        "stripes for dents or waves."
    )
    report = {**fill_text.EMPTY_REPORT, "fills": [entry], "target": "G1", "tolerance": LIMITS}
    assert fill_text.summary_text(report).endswith(fill_text.waves_text(entry))
    fair = fill_text.entry({**found, "waves": None}, hole=2)
    assert fill_text.waves_text(fair) == ""
    assert "stripes" not in fill_text.summary_text({**report, "fills": [fair]})
