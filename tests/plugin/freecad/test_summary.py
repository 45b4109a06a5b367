# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts and sentences about a report, word by word."""

import pytest
from test_plain import TOLERANCE, figure, seam

from freecad.seamwright.plain import summary

#: Nouns whose plural is not their name with an s.
PLURALS = {"extremum": "extrema", "line of joints": "lines of joints"}


def report(*seams, level="G1", **freecad):
    return {"seams": list(seams), "tolerance": dict(TOLERANCE), "open": [],
            "freecad": {"level": level, **freecad}}  # fmt: skip


@pytest.mark.parametrize("noun", summary.NOUNS)
def test_nouns_are_counted(noun):
    several = PLURALS.get(noun, noun + "s")
    none = "0 extrema" if noun == "extremum" else "no " + several
    assert [summary.counted(count, noun) for count in (0, 1, 2, 21)] == [
        none, "1 " + noun, "2 " + several, "21 " + several
    ]  # fmt: skip


def test_a_sentence_begins_with_a_capital():
    assert summary.capital("no arcs of A") == "No arcs of A" and summary.capital("") == ""


def test_a_model_without_defects_passes():
    good = report(seam(1), seam(2, "crease", angle=90.0))
    assert summary.passed(good)
    assert summary.summary_text(good) == (
        "2 seams: no defects, 1 crease, 1 smooth; apart from creases, largest gap \u22650.001 mm, "
        "largest angle \u22650.01\u00b0; 0 of 2 verdicts certain; G1 is met."
    )
    assert summary.passed(report(seam(1)))
    assert not summary.passed(report(seam(1), seam(2, "defect"))) and not summary.passed(report())


def test_without_gaps_or_angles_there_are_no_largest_ones():
    text = "1 seam: no defects, 1 crease, 0 smooth; 0 of 1 verdict certain; G2 is met."
    assert summary.summary_text(report(seam(1, "crease"), level="G2")) == text
    for name in ("gap_mm", "angle_deg"):
        one = {**seam(1), name: None}
        assert summary.summary_text(report(one)) == (
            "1 seam: no defects, no creases, 1 smooth; 0 of 1 verdict certain; G1 is met."
        )


def test_facts_are_the_properties_of_an_analysis():
    seams = [seam(1), seam(2, "defect", gap=0.25), {**seam(3, angle=0.05), "certified": True},
             {**seam(4, "crease", angle=80.0), "kind": "matched"}]  # fmt: skip
    found = summary.facts({**report(*seams), "open": [{"edge": 7}, {"edge": 8}]})
    text = found.pop("Summary")
    assert text.startswith("4 seams, 1 of them matched: 1 defect, 1 crease, 2 smooth; 2 free edges")
    assert found == {
        "Seams": 4, "Defects": 1, "Creases": 1, "Uncertain": 3, "Matched": 1, "OpenEdges": 2,
        "MaxGap": 0.25, "MaxAngle": 0.05, "Passed": False,
    }  # fmt: skip
    empty = summary.facts(report())
    assert (empty["Seams"], empty["MaxGap"], empty["MaxAngle"]) == (0, 0, 0)


def test_a_defect_is_sharp_from_the_limits_on():
    limits = {"gap": TOLERANCE["gap_mm"], "angle": TOLERANCE["crease_deg"]}
    said = "as sharp as a crease"
    at_the_limit = report(seam(1, "defect", **limits))
    assert said not in summary.summary_text(at_the_limit)
    for name in limits:
        beyond = {**limits, **{each: 2 * value for each, value in limits.items() if each != name}}
        assert said not in summary.summary_text(report(seam(1, "defect", **beyond))), name
    beyond = report(seam(1, "defect", gap=0.0101, angle=5.01))
    assert "; 1 defect as sharp as a crease, but with a gap; " in summary.summary_text(beyond)


@pytest.mark.parametrize(
    "freecad, said",
    [
        ({}, "1 free edge can be matched: see Tolerances."),
        ({"tried_match_mm": 2.5}, "1 free edge; none lie side by side within 2.5 mm."),
        (
            {"tried_match_mm": 2.5, "proposed_match_mm": 0.05},
            "1 free edge; edges lie side by side: match them within 0.05 mm.",
        ),
    ],
)
def test_free_edges_without_seams(freecad, said):
    free = {**report(**freecad), "open": [{"edge": 1}]}
    assert summary.summary_text(free) == "No seams: no two faces share an edge. " + said
    assert summary.proposed_match_mm(free) == freecad.get("proposed_match_mm")


@pytest.mark.parametrize(
    "level, figures",
    [
        ("G0", "gap \u2264 0.01 mm"),
        ("G1", "gap \u2264 0.01 mm, angle \u2264 0.1\u00b0"),
        ("G2", "gap \u2264 0.01 mm, angle \u2264 0.1\u00b0, curvature \u2264 2 %"),
        ("G3", "gap \u2264 0.01 mm, angle \u2264 0.1\u00b0, curvature \u2264 2 %"),
    ],
)
def test_the_tolerances_of_each_level(level, figures):
    assert summary.tolerance_text(report(level=level)) == "%s: %s" % (level, figures)


def test_a_figure_without_an_upper_bound_makes_the_largest_one_uncertain():
    one, two = seam(1), seam(2)
    one["gap_mm"], two["gap_mm"] = {"lower": 0.5, "upper": 0.5, "at": 0}, figure(0.2)
    assert "largest gap \u22650.5 mm" in summary.summary_text(report(one, two))


def test_a_crease_is_no_defect_that_is_as_sharp_as_one():
    wide = seam(1, "crease", gap=0.5, angle=90.0)
    assert "as sharp as" not in summary.summary_text(report(wide, seam(2)))


def test_a_report_is_judged_by_g1_unless_it_says_another_level():
    plain = {"seams": [seam(1)], "tolerance": TOLERANCE}
    assert summary.summary_text(plain).endswith("; G1 is met.")
    assert summary.tolerance_text(plain).startswith("G1: ")
