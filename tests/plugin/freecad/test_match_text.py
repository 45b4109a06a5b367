# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about a match of two faces."""

import pytest
from test_plain import TOLERANCE, figure, seam

from freecad.seamwright.plain import match_text


@pytest.fixture
def matched():
    return {
        "matched": True, "reason": "joined in poles", "exact": True, "largest_move_mm": 0.36346,
        "target": "G1", "tolerance": dict(TOLERANCE), "faces": ["Left.Face1", "Right.Face4"],
        "before": {**seam(1, "defect"), "gap_mm": figure(0.0, 1e-13),
                   "angle_deg": figure(3.0685, 3.0686), "curvature_rel": None, "level": "G0",
                   "certified": True},
        "after": {**seam(1), "gap_mm": figure(0.0, 1e-13), "angle_deg": figure(0.0, 2.73e-6),
                  "curvature_rel": figure(0.41, 0.45), "level": "G1", "certified": False},
    }  # fmt: skip


def test_a_match_is_told_before_and_after(matched):
    assert match_text.table(matched) == [
        ("Gap mm", "\u22641e-13", "\u22641e-13"),
        ("Angle \u00b0", "3.07", "\u22642.8e-6"),
        ("Curvature %", "\u2013", "41..45"),
        ("Level", "G0", "G1"),
        ("Certain", "yes", "no"),
    ]
    assert match_text.summary(matched) == (
        "Matched: G1 is met; gap \u22641e-13 mm; angle \u22642.8e-6\u00b0; curvature 41..45 %; "
        "poles moved by up to 0.363 mm (the seam is exact up to rounding)."
    )
    matched["reason"] += ", inner knots along the seam repeated twice more"
    assert match_text.summary(matched).endswith("0.363 mm (the seam is exact up to rounding).")


def test_a_match_tells_new_poles_and_how_far_the_shape_changes(matched):
    matched["poles"] = [[[4, 4], [4, 4]], [[8, 11], [13, 19]]]
    matched["reason"] = "joined to the tolerance by a change up to 57.03 mm from the side"
    text = match_text.summary(matched)
    assert text.endswith(
        "0.363 mm; Right.Face4 has 13 x 19 poles instead of 8 x 11 (within the tolerances; the "
        "shape changes up to 57.03 mm away from the seam)."
    )
    matched["poles"] = [[None, [9, 2]], [None, None]]
    assert "; Left.Face1 has 9 x 2 poles (" in match_text.summary(matched)


def test_a_failed_match_tells_the_seam_as_it_is(matched):
    matched.update(matched=False, reason="a pole would move by 0.4 mm")
    assert [line[2] for line in match_text.table(matched)] == ["\u2013"] * 5
    assert match_text.summary(matched) == "Not matched: a pole would move by 0.4 mm."
    matched["before"] = None
    assert [line[1] for line in match_text.table(matched)] == ["\u2013"] * 5


def test_sentences_of_the_kernel_get_the_names_of_the_document():
    def name(text):
        return match_text.named(
            text, ["Left.Face1", "Right.Face4"], lambda number: "Left.Edge%d" % (number + 1)
        )

    assert name("face 2 is a plane; face 12 and surface 1 are not meant") == (
        "Right.Face4 is a plane; face 12 and surface 1 are not meant"
    )
    assert name("edge 7 is not a common boundary; these are: 1, 5") == (
        "Left.Edge8 is not a common boundary; these are: Left.Edge2, Left.Edge6"
    )


def test_a_figure_of_no_seam_counts_as_nothing(matched):
    assert match_text.value(matched["before"], "angle_deg") == 3.0686
    assert match_text.value(matched["before"], "curvature_rel") == 0.0
    assert match_text.value(None, "angle_deg") == 0.0


def test_an_empty_report_has_no_match(matched):
    empty = {**match_text.EMPTY_REPORT, "reason": "There is one face.", "tolerance": TOLERANCE}
    assert match_text.summary(empty) == "Not matched: There is one face."
    assert {line[1:] for line in match_text.table(empty)} == {("\u2013", "\u2013")}
    assert (empty["exact"], empty["largest_move_mm"]) == (False, 0)


def test_what_helps_is_told_where_a_match_would_be_less_fair():
    assert match_text.advised("it bends more.", "less_fair") == (
        "it bends more: allow a change over a larger Depth, or a larger Fairness"
    )
    assert match_text.advised("it bends more.", "too_far") == "it bends more."


def test_a_face_that_joins_several_is_told():
    assert match_text.chain_reason(["A.Face1", "B.Face2", "C.Face3"], 12.345) == (
        "A.Face1 joins B.Face2, C.Face3 to the tolerance; the shape changes up to 12.3 mm away "
        "from the seam"
    )


def test_the_worst_of_several_seams():
    one = {**seam(1, gap=0.001, angle=0.4, curvature=None), "level": "G2", "certified": True}
    two = {**seam(2, gap=0.005, angle=0.1, curvature=0.3), "level": "G0", "certified": False}
    two["angle_deg"] = figure(0.1, 0.39)
    two["gap_mm"] = figure(0.0, 0.002)
    for seams in ([one, two], [two, one]):
        found = match_text.worst(seams)
        assert (found["id"], found["level"], found["certified"]) == (2, "G0", False)
        assert found["angle_deg"] == figure(0.4), "of the other seam"
        assert found["gap_mm"] == figure(0.0, 0.002) and found["curvature_rel"] == figure(0.3)
    assert match_text.worst([one, {**two, "certified": True}])["certified"]
    turned = match_text.worst([{**one, "certified": False}, {**two, "certified": True}])
    assert turned["id"] == 2 and not turned["certified"], "all have to be certain"
    assert match_text.worst([]) is None
    assert match_text.worst([{**one, "angle_deg": figure(0.0)}])["angle_deg"] == figure(0.0)


def test_figures_that_were_not_measured_are_not_told(matched):
    matched["after"]["curvature_rel"] = None
    assert match_text.summary(matched) == (
        "Matched: G1 is met; gap \u22641e-13 mm; angle \u22642.8e-6\u00b0; poles moved by up to "
        "0.363 mm (the seam is exact up to rounding)."
    )


def test_a_face_that_has_no_poles_any_more_is_not_told(matched):
    matched["poles"] = [[[4, 4], None], [[4, 4], [4, 5]]]
    text = match_text.summary(matched)
    assert "Left" not in text and "; Right.Face4 has 4 x 5 poles instead of 4 x 4 (" in text
