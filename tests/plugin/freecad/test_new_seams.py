# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said about holes, their fills, and corners of fillets."""

import itertools
import json

import pytest
from test_plain import TOLERANCE, seam

from freecad.seamwright.plain import corner_text, fill_text, new_seams, profiles, repair_text

LIMITS = {"gap_mm": 0.001, "angle_deg": 0.01, "corner_deg": 15.0}


def measured(number, angle=0.001, gap=1e-6, between="fill, Face1", bounded=True):
    """A seam whose figures are known to 1 %, or from below only."""
    made = {**seam(number), "between": between}
    for name, value in (("angle_deg", angle), ("gap_mm", gap)):
        made[name] = {"lower": 0.99 * value, "upper": value if bounded else None, "at": 0.5}
    return made


def hole(number, *sides, longest=False, corners=True, centre=(1.0, -1e-12, 2.5)):
    return {
        "id": number,
        "length_mm": 10.0 * len(sides),
        "centre_mm": list(centre),
        "has_corners": corners,
        "longest": longest,
        "sides": [
            {"edges": list(edges), "faces": [1] * len(edges), "length_mm": 10.0} for edges in sides
        ],
    }


# Seams


def test_rows_come_worst_first_and_say_what_is_certain():
    seams = [
        measured(1, angle=0.009),
        measured(2, angle=0.02),
        measured(3, angle=0.001, bounded=False),
        measured(4, gap=0.5, angle=0.0),
        measured(5),
    ]
    rows = new_seams.build_rows(seams, LIMITS, "G1")
    assert [row.index for row in rows] == [3, 1, 2, 0, 4]
    verdicts = ["misses G1"] * 2 + ["G1 uncertain"] + ["meets G1"] * 2
    assert [row.cells[-1] for row in rows] == verdicts
    states = [repair_text.NOT_REPAIRED] * 3 + [repair_text.REPAIRED] * 2
    assert [row.state for row in rows] == states
    assert all(len(row.cells) == len(new_seams.COLUMNS) for row in rows)
    assert rows[1].cells[:3] == ("Edge2", "fill, Face1", "0.02")
    rows = new_seams.build_rows(seams, LIMITS, "G0")
    assert sorted(row.cells[-1] for row in rows) == [
        "G0 uncertain",
        *["meets G0"] * 3,
        "misses G0",
    ]
    assert {row.index for row in rows[:2]} == {2, 3}


@pytest.mark.parametrize("value", [0.01, 0.01 * (1 + 1e-12), 0.00999])
def test_the_limit_itself_is_met(value):
    assert new_seams.certainly_meets(measured(1, angle=value), LIMITS, "G1") == (value <= 0.01)


def test_a_seam_that_was_not_kept_has_no_number():
    made = {**measured(3), "edges": [], "faces": []}
    (row,) = new_seams.build_rows([made], LIMITS, "G1")
    assert row.cells[0] == "\u2013"


def test_largest_figures_are_bounds_of_all():
    seams = [measured(1, angle=0.002), measured(2, angle=0.003), measured(3, angle=0.001)]
    assert new_seams.largest(seams, "angle_deg") == {"lower": 0.99 * 0.003, "upper": 0.003}
    assert new_seams.bound(seams, "angle_deg") == 0.003
    text = "3 seams, gap at most 1e-6 mm, angle at most 0.003\u00b0"
    assert new_seams.largest_text(seams, LIMITS) == text + ", curvature unknown"
    for each, curvature in zip(seams, (0.01, 0.25, 0.0)):
        each["curvature_rel"] = {"lower": curvature, "upper": curvature, "at": 0.5}
    assert new_seams.largest_text(seams, LIMITS) == text + ", curvature at most 25 %"
    assert new_seams.bound(seams, "curvature_rel") == 0.25
    seams[1]["curvature_rel"] = None
    assert new_seams.largest_text(seams, LIMITS) == text + ", curvature unknown"
    seams.append(measured(4, angle=0.0001, bounded=False))
    assert new_seams.largest(seams, "angle_deg")["upper"] is None
    assert new_seams.bound(seams, "angle_deg") == 0.99 * 0.003
    assert "angle unknown" in new_seams.largest_text(seams, LIMITS)
    assert new_seams.bound([], "gap_mm") == 0.0


def test_a_worst_point_that_does_not_decide_is_dropped():
    curved = {**measured(1), "worst": {"quantity": "curvature", "at": 0.5, "point": [0, 0, 0]}}
    assert new_seams.deciding(curved, "G1")["worst"] is None
    assert new_seams.deciding(curved, "G2")["worst"] is not None
    kinked = {**measured(1), "worst": {"quantity": "angle", "at": 0.5, "point": [0, 0, 0]}}
    assert new_seams.deciding(kinked, "G1") is kinked
    assert new_seams.deciding(kinked, "G0")["worst"] is None


# Holes


def test_the_longest_loop_is_left_out_unless_there_is_no_other():
    outer, inner = hole(1, [1, 2], [3], longest=True), hole(2, [4], [5], [6])
    assert fill_text.default_holes([outer, inner]) == [inner]
    assert fill_text.default_holes([outer]) == [outer]
    assert fill_text.default_holes([]) == []
    assert (
        fill_text.hole_text(inner, [outer, inner])
        == "Hole 2: 3 sides, length 30 mm, centre (1, 0, 2.5)"
    )
    assert (
        fill_text.hole_text(outer, [outer, inner])
        == "Hole 1: 2 sides, length 20 mm, centre (1, 0, 2.5), the longest loop: an outer boundary?"
    )
    alone = fill_text.hole_text(outer, [outer])
    assert alone == "Hole 1: 2 sides, length 20 mm, centre (1, 0, 2.5)"
    smooth = hole(3, [7], corners=False)
    assert (
        fill_text.hole_text(smooth, [smooth])
        == "Hole 3: no corner, length 10 mm, centre (1, 0, 2.5)"
    )
    assert fill_text.hole_tip(outer) == "Edge1, Edge2, Edge3"


def test_loops_of_one_length_are_all_filled_and_distinguished():
    holes = [hole(1, [1, 2], [3], centre=(0, 0, 0)), hole(2, [4, 5], [6], centre=(0, 0, 30))]
    assert fill_text.default_holes(holes) == holes
    assert [fill_text.hole_text(each, holes).split("centre ")[1] for each in holes] == [
        "(0, 0, 0)",
        "(0, 0, 30)",
    ]


def test_one_edge_of_a_hole_names_it_whatever_the_order():
    holes = [hole(1, [1, 2], [3]), hole(2, [4], [5], [6]), hole(3, [9])]
    for edges in itertools.permutations([5, 1, 2]):
        assert fill_text.chosen_holes(holes, edges) == holes[:2]
    with pytest.raises(ValueError, match="edge 7 does not belong to a hole"):
        fill_text.chosen_holes(holes, [5, 7])


# Fills


@pytest.mark.parametrize("replaced", [None, 1, 3, 5])
@pytest.mark.parametrize("new", [{5, 6, 7}, {1, 2}, {2, 3, 6}])
def test_old_numbers_undo_what_a_fill_did(new, replaced):
    count = 6  # faces of the source
    old = [number for number in range(1, count + 1) if number != replaced]
    total = len(old) + len(new)
    filled = [number for number in range(1, total + 1) if number not in new]
    found = [fill_text.old_number(number, new, replaced) for number in filled]
    assert found == old[: len(found)]
    assert [fill_text.old_number(number, new, replaced) for number in new] == [None] * len(new)


def found(filled=True, reason=""):
    outer, inner = seam(8), seam(9)
    outer["faces"], inner["faces"] = [3, 6], [6, 7]
    return {
        "filled": filled,
        "reached": not reason,
        "reason": reason,
        "reason_code": "misses_target" if reason else "",
        "target": "G1",
        "faces": [6, 7],
        "outer": [outer],
        "inner": [inner],
    }


def test_a_kept_fill_has_the_numbers_of_the_result_and_names_of_the_source():
    entry = fill_text.entry(found(), face=2)
    assert [each["between"] for each in entry["seams"]] == ["fill, Face4", fill_text.INSIDE]
    assert (entry["faces"], entry["seams"][0]["edges"]) == ([6, 7], [8])
    assert json.loads(json.dumps(entry)) == entry
    report = {"target": "G1", "tolerance": LIMITS, "fills": [entry]}
    assert fill_text.new_faces(report) == ({6, 7}, 2)
    assert fill_text.summary_text(report).startswith("Face2 replaced with 2 faces; 2 seams")
    assert fill_text.summary_text(report).endswith("; G1 is met.")


def test_a_fill_that_was_not_kept_says_why_in_names_of_the_source():
    reason = (
        "a seam between face 3 and the fill does not certainly reach G1: level G0, angle 1 degrees"
    )
    entry = fill_text.entry(found(filled=False, reason=reason), hole=2)
    assert entry["faces"] == [] and all(each["edges"] == [] for each in entry["seams"])
    report = {"target": "G1", "tolerance": LIMITS, "fills": [entry]}
    assert fill_text.summary_text(report) == (
        "Not filled: Hole 2: a seam between Face3 and the fill does not certainly reach G1: "
        "level G0, angle 1\u00b0."
    )


def test_a_fill_that_misses_says_what_it_needs():
    reason = "a seam misses the target: gap 0.0152998 mm (edges 8, 7) and 2.1201e-06 mm"
    entry = fill_text.entry(found(False, reason), hole=2)
    assert (entry["filled"], entry["seams"][0]["edges"]) == (False, [])
    entry["seams"][0]["source_edges"] = [3]
    rows = new_seams.build_rows(entry["seams"], LIMITS, "G1")
    assert sorted(row.cells[0] for row in rows) == ["Edge3 (model)", "\u2013"]
    assert entry["reason"] == "a seam misses the target: gap 0.0153 mm (Edge8, Edge7) and 2.1e-6 mm"
    for name, upper in (("gap_mm", 0.0003), ("angle_deg", 0.18359929)):
        entry["seams"][0][name] = {"lower": 0.0, "upper": upper, "at": 0.0}
        entry["seams"][1][name] = {"lower": 0.0, "upper": 1e-9, "at": 0.0}
    assert fill_text.allowing(entry, "G1") == {"gap_mm": 0.0003, "angle_deg": 0.19}
    report = {"target": "G1", "tolerance": LIMITS, "fills": [entry]}
    wanted = "The best fill needs an angle tolerance of 0.19\u00b0; Keep anyway keeps it."
    assert fill_text.reasons(report)[0].endswith(wanted)
    for faulty in ({"reason_code": "may_fold"}, {"seams": [{"gap_mm": None}]}):
        assert fill_text.allowing({**entry, **faulty}, "G1") == {}


def test_some_of_several_fills():
    kept, missed = fill_text.entry(found(), hole=1), fill_text.entry(
        found(False, "it has 0 corners"), hole=2
    )
    anyway = fill_text.entry(found(True, "it is too far"), hole=3)

    def text(*fills):
        return fill_text.summary_text({"target": "G1", "tolerance": LIMITS, "fills": list(fills)})

    assert text(kept, missed).startswith("1 of 2 holes filled with 2 faces; ")
    assert text(kept, anyway).endswith("; G1 is not met, kept anyway.")
    assert (
        text(missed, missed)
        == "0 of 2 holes filled: Hole 2: it has 0 corners. Hole 2: it has 0 corners."
    )
    report = {"target": "G1", "tolerance": LIMITS, "fills": [kept, missed, anyway]}
    assert fill_text.reasons(report) == ["Hole 2: it has 0 corners.", "Hole 3: it is too far."]
    assert fill_text.waiting_text([], [1, 2]) == "2 holes to fill."
    assert fill_text.waiting_text(["Face7"], []) == "Face7 to replace."


def test_a_profile_is_known_by_the_tolerances_there_are():
    assert profiles.name_of({"gap_mm": 0.001, "angle_deg": 0.01, "corner_deg": 15.0}) == "class-a"
    assert profiles.name_of({"gap_mm": 0.01, "angle_deg": 0.1, "section_mm": 1e-6}) == "default"
    assert profiles.name_of({"gap_mm": 0.001, "angle_deg": 0.1}) is None


# Corners


def corner(met=True, shortfall="", filled_by="patches", patches_shortfall=""):
    edges = [
        {
            "edge": n,
            "convex": n != 4,
            "angle_deg": 90.0,
            "radius_mm": r,
            "contact_mm": r,
            "setback_mm": 4.0,
        }
        for n, r in ((4, 1.0), (1, 2.5), (9, 0.125))
    ]
    seams = []
    for number, (between, faces) in enumerate(
        (
            ("spoke", [10, 11]),
            ("section", [7, 10]),
            ("spring", [1, 11]),
            ("contact", [1, 8]),
            ("fillets", [7, 8]),
        ),
        1,
    ):
        seams.append({**seam(number), "between": between, "faces": faces})
    return {
        "met": met,
        "shortfall": shortfall,
        "filled_by": filled_by,
        "patches_shortfall": patches_shortfall,
        "faces": [7, 8, 10, 11],
        "edges": edges,
        "seams": seams,
    }


def test_a_corner_is_told_with_its_radii():
    report = corner_text.build_report(corner(), TOLERANCE)
    assert corner_text.summary_text(report).startswith(
        "Corner of 3 edges rounded with radii 1, 2.5, 0.125 mm; 5 seams"
    )
    assert corner_text.new_faces(report) == {7, 8, 10, 11}
    assert corner_text.patches(report) == {10, 11}
    assert "OpenCASCADE" not in corner_text.summary_text(report)
    assert [corner_text.edge_text(edge) for edge in report["edges"][:2]] == [
        "concave, 90\u00b0",
        "convex, 90\u00b0",
    ]
    assert [each["between"] for each in report["seams"]] == list(corner_text.BETWEEN.values())
    assert json.loads(json.dumps(report)) == report


def test_a_corner_that_opencascade_fills_says_so():
    found = corner(filled_by="opencascade", patches_shortfall="edge 4: no section.")
    report = corner_text.build_report(found, TOLERANCE)
    assert corner_text.summary_text(report).endswith(
        "G1 is met. Filled by OpenCASCADE; not by patches: Edge4: no section."
    )


def test_a_corner_of_an_older_document_was_filled_by_patches():
    report = corner_text.build_report(corner(), TOLERANCE)
    for key in ("filled_by", "patches_reason", "faces"):
        del report[key]
    assert corner_text.summary_text(report).endswith("G1 is met.")
    assert corner_text.new_faces(report) == {7, 10, 11}


def test_a_corner_that_falls_short_says_why_and_has_no_numbers():
    report = corner_text.build_report(corner(False, "the seam at edge 5 has 1 degree."), TOLERANCE)
    assert corner_text.summary_text(report) == "Not rounded: the seam at Edge5 has 1 degree."
    assert corner_text.new_faces(report) == set()


@pytest.mark.parametrize(
    ("lengths", "radius"),
    [
        ([10, 10, 10], 1.0),
        ([3.7, 40], 0.3),
        ([0.029], 0.002),
        ([2500, 8000], 200.0),
        ([99.99], 9.0),
        ([1e-3], 1e-4),
    ],
)
def test_a_suggested_radius_is_a_tenth_of_the_shortest_edge_to_one_digit(lengths, radius):
    assert corner_text.suggested_radius_mm(lengths) == radius


def test_numbers_by_edge():
    assert corner_text.by_edge([2.0], [4, 1, 9], "Radii") == {4: 2.0, 1: 2.0, 9: 2.0}
    assert corner_text.by_edge([1.0, 2.0, 3.0], [4, 1, 9], "Radii") == {4: 1.0, 1: 2.0, 9: 3.0}
    for numbers, text in (([], "no numbers"), ([1.0, 2.0], "2 numbers"), ([1.0] * 4, "4 numbers")):
        with pytest.raises(
            ValueError,
            match="Radii has %s for the 3 edges of the corner .Edge4, Edge1, Edge9" % text,
        ):
            corner_text.by_edge(numbers, [4, 1, 9], "Radii")


def test_cells_of_a_seam_inside_a_fill_and_its_headings():
    figures = {name: {"lower": 1e-6, "upper": 1e-6, "at": 0} for name in ("angle_deg", "gap_mm")}
    inside = {**measured(3, between="the fill itself"), **figures}
    (row,) = new_seams.build_rows([inside], LIMITS, "G1")
    assert dict(zip((heading for heading, _ in new_seams.COLUMNS), row.cells)) == {
        "Edge": "Edge3", "Between": "the fill itself", "Angle \u00b0": "1e-6",
        "Gap {unit}": "1e-6", "Curvature %": "\u226550", "Result": "meets G1",
    }  # fmt: skip
    (row,) = new_seams.build_rows([measured(3, between="fill, Face12")], LIMITS, "G1")
    assert row.cells[1] == "fill, Face12"


def test_a_lower_bound_at_the_tolerance_is_no_certain_miss():
    for factor, missed in ((1, False), (1 + 1e-12, True)):
        one = {**measured(1), "angle_deg": {"lower": 0.01 * factor, "upper": 0.02, "at": 0}}
        assert new_seams.certainly_misses(one, LIMITS, "G1") == missed


def test_the_largest_figures_are_rounded_up():
    one = {**measured(1), "gap_mm": {"lower": 1.14e-6, "upper": 1.1443e-6, "at": 0.5},
           "angle_deg": {"lower": 0.1, "upper": 0.10011, "at": 0.5}}  # fmt: skip
    text = new_seams.largest_text([one], LIMITS)
    assert text.startswith("1 seam, gap at most 1.2e-6 mm, angle at most 0.101\u00b0")


def test_a_gap_without_an_upper_bound_is_unknown():
    text = new_seams.largest_text([measured(1, bounded=False)], LIMITS)
    assert text == "1 seam, gap unknown, angle unknown, curvature unknown"


def test_a_figure_that_was_not_measured_is_neither_met_nor_missed():
    one = {**measured(1), "angle_deg": None}
    assert not new_seams.certainly_meets(one, LIMITS, "G1")
    assert not new_seams.certainly_misses(one, LIMITS, "G1")
    assert new_seams.certainly_misses({**one, "gap_mm": {"lower": 1, "upper": 2}}, LIMITS, "G1")
    text = new_seams.largest_text([{**one, "curvature_rel": None}], LIMITS)
    assert text == "1 seam, gap at most 1e-6 mm", "no word of what no seam has"


def test_the_change_of_curvature_has_the_tolerance_of_curvature():
    limits = {**LIMITS, "curvature_rel": 0.02}
    figures = {name: {"lower": 0.0, "upper": 1e-9} for name in limits}
    for change, met, missed in ((0.019, True, False), (0.021, False, True)):
        figures["curvature_change_rel"] = {"lower": change, "upper": change}
        assert new_seams.certainly_meets(figures, limits, "G3") == met
        assert new_seams.certainly_misses(figures, limits, "G3") == missed
