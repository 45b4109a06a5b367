# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said about a repair, and the colours of its moves."""

import json
import math

import pytest
from test_plain import SIGHTS, TOLERANCE, lab, linear, seam

from freecad.seamwright.plain import moves, repair_text, rows

ARROW = repair_text.ARROW


def analysis(*seams):
    return {"seams": list(seams), "tolerance": dict(TOLERANCE)}


def repaired(before, after, reason="", treated=True):
    return {
        "before": before,
        "after": after,
        "treated": treated,
        "repaired": treated and not reason,
        "reason": reason,
    }


@pytest.fixture
def done():
    """Three of five seams were to be repaired: one was, one failed, one cannot."""
    before = [
        seam(1),
        seam(2, "defect", angle=0.4),
        seam(3, "defect", angle=0.9),
        seam(4, "crease", angle=90.0),
        seam(5, "defect", angle=0.2),
    ]
    after = [before[0], seam(2, angle=1e-9), *before[2:]]
    seams = [
        repaired(before[0], after[0], treated=False),
        repaired(before[1], after[1]),
        repaired(before[2], after[2], "face 3: it needs a move of 2 mm, more than 0.5 mm"),
        repaired(before[3], after[3], treated=False),
        repaired(before[4], after[4], "face 5 is a plane, face 6 is fixed; edge 5", treated=False),
    ]
    found = [{"face": 2, "largest_move_mm": 0.02}, {"face": 3, "largest_move_mm": 0.125}]
    return repair_text.build_report(analysis(*before), analysis(*after), seams, found, "G1", False)


def test_the_report_holds_what_was_to_be_repaired_and_can_be_stored(done):
    assert [each["before"]["id"] for each in done["seams"]] == [2, 3, 5]
    assert done["total"] == 5
    assert done["defects"] == [3, 2]
    assert done["angle_deg"] == [0.9, 0.9]
    assert json.loads(json.dumps(done)) == done


def test_summary_counts_what_was_repaired_and_moved(done):
    assert repair_text.summary_text(done) == (
        "1 of 3 seams repaired to G1; 2 faces moved, poles by up to 0.125 mm; "
        "defects before 3, after 2."
    )
    assert repair_text.summary_text({**done, "moves": []}).count("nothing moved") == 1


def test_rows_come_worst_first_with_figures_before_and_after(done):
    rows = repair_text.build_rows(done)
    assert [row.seam for row in rows] == [3, 2, 5]
    assert [row.state for row in rows] == [
        repair_text.NOT_REPAIRED,
        repair_text.REPAIRED,
        repair_text.NOT_REPAIRED,
    ]
    cells = rows[1].cells
    assert cells[0] == "Edge2"
    assert cells[1] == "2, 3"
    assert cells[2] == "\u22650.4" + ARROW + "\u22651e-9"
    assert cells[-1] == "repaired"
    assert all(len(row.cells) == len(repair_text.COLUMNS) for row in rows)
    assert repair_text.COLUMNS[repair_text.CURVATURE_COLUMN][0].startswith("Curvature")


def test_reasons_name_faces_and_edges_as_the_user_sees_them(done):
    by_seam = {row.seam: row for row in repair_text.build_rows(done)}
    assert by_seam[3].cells[-1] == "Face3: it needs a move of 2 mm, more than 0.5 mm"
    assert by_seam[5].cells[-1] == "Face5 is a plane, Face6 is fixed; Edge5"
    assert by_seam[5].detail.endswith("Face5 is a plane, Face6 is fixed; Edge5")
    assert "Before: Seam 3" in by_seam[3].detail and "After: Seam 3" in by_seam[3].detail


@pytest.mark.parametrize(
    ("edges", "target", "wanted"),
    [
        (set(), "G1", [2, 3, 5]),
        ({3}, "G1", [3]),
        ({1}, "G1", []),
        ({1}, "G2", [1]),
        ({77}, "G1", []),
    ],
)
def test_foreseen_are_defects_or_the_chosen_that_fall_short(done, edges, target, wanted):
    before = analysis(
        seam(1),
        seam(2, "defect", angle=0.4),
        seam(3, "defect", angle=0.9),
        seam(4, "crease"),
        seam(5, "defect"),
    )
    for each in before["seams"]:
        each["level"] = "G1" if each["id"] == 1 else "G0"
    report = repair_text.build_report(
        before, None, repair_text.waiting(before, target, edges), [], target, bool(edges)
    )
    assert [each["before"]["id"] for each in report["seams"]] == wanted
    assert not repair_text.is_done(report)
    assert {row.state for row in repair_text.build_rows(report)} <= {repair_text.WAITING}
    text = repair_text.summary_text(report)
    assert text.startswith("%d seam" % len(wanted) if wanted else "Nothing to repair: ")
    assert not wanted or text.endswith("to repair to %s." % target)


def test_nothing_to_repair_says_why():
    def text(chosen, *seams):
        both = analysis(*seams)
        every = [repaired(each, each, treated=False) for each in seams]
        return repair_text.summary_text(
            repair_text.build_report(both, both, every, [], "G1", chosen)
        )

    assert (
        text(False, seam(1))
        == "Nothing to repair: no seam falls short of G1; the model is unchanged."
    )
    assert (
        text(True, seam(1))
        == "Nothing to repair: the chosen seams meet G1; the model is unchanged."
    )
    assert text(False).startswith("Nothing to repair: no two faces share an edge")


def test_a_model_changes_also_where_no_face_moved():
    both = analysis(seam(1, "defect", gap=0.4))
    every = [repaired(seam(1, "defect", gap=0.4), seam(1))]
    assert not repair_text.has_changed(repair_text.build_report(both, both, every, [], "G1", False))
    led = repair_text.build_report(both, both, every, [], "G1", False, 3)
    assert repair_text.has_changed(led)
    assert "3 edges got new curves on their faces" in repair_text.summary_text(
        led
    ) and "nothing" not in repair_text.summary_text(led)
    sewn = repair_text.build_report(
        both, both, [{**every[0], "treated": False, "reason": "", "sewn": True}], [], "G1", False
    )
    assert repair_text.has_changed(sewn) and "1 seam sewn" in repair_text.summary_text(sewn)


def test_seams_that_could_not_be_measured_are_worst():
    seams = [seam(1, "defect", angle=0.4), seam(2, "defect", gap=None, angle=None, curvature=None)]
    report = repair_text.build_report(
        analysis(*seams),
        analysis(*seams),
        [repaired(each, each, "why") for each in seams],
        [],
        "G1",
        False,
    )
    rows = repair_text.build_rows(report)
    assert [row.seam for row in rows] == [2, 1]
    assert rows[0].cells[2] == "\u2013" + ARROW + "\u2013"


def test_located_names_each_face_and_edge_of_the_object(done):
    place = rows.located([seam["before"] for seam in done["seams"]], done["tolerance"], "Panel")[
        "freecad"
    ]
    assert place["edges"]["3"] == ["Panel", "Edge3"]
    assert place["faces"]["6"] == ["Panel", "Face6"]


# Colours of moves


@pytest.mark.parametrize("sight", sorted(SIGHTS))
def test_larger_moves_are_darker_for_every_eye(sight):
    lightness = [
        lab(
            [sum(m * c for m, c in zip(row, linear(moves.colour(k / 50)))) for row in SIGHTS[sight]]
        )[0]
        for k in range(51)
    ]
    assert all(one > other for one, other in zip(lightness, lightness[1:]))
    assert lightness[0] - lightness[-1] > 50


def test_colours_pass_through_the_ramp_and_stop_at_its_ends():
    for share, rgb in moves.RAMP:
        assert moves.colour(share) == pytest.approx(rgb)
    assert moves.colour(-1.0) == moves.colour(0.0)
    assert moves.colour(7.0) == moves.colour(1.0)
    low, high = moves.RAMP[1], moves.RAMP[2]
    middle = moves.colour((low[0] + high[0]) / 2)
    assert middle == pytest.approx([(a + b) / 2 for a, b in zip(low[1], high[1])])


def test_colours_are_relative_to_the_largest_move():
    assert moves.colours([0.0, 0.5, 2.0], 2.0)[2] == pytest.approx(
        [c / 255 for c in moves.RAMP[-1][1]]
    )
    assert (
        moves.colours([0.0, 0.0], 0.0) == [pytest.approx([c / 255 for c in moves.RAMP[0][1]])] * 2
    )
    assert all(0 <= channel <= 1 for rgb in moves.colours([0.1, 0.7], 0.7) for channel in rgb)


def test_the_legend_has_millimetres_from_the_largest_to_none():
    entries = moves.legend_entries(0.2)
    figures = [float(name.removesuffix(" mm")) for _, name, _ in entries]
    assert figures == pytest.approx([0.2 * share for share in moves.LEGEND_SHARES], rel=5e-3)
    assert figures == sorted(figures, reverse=True) and figures[-1] == 0
    assert [entry[0].rgb for entry in entries][0] == moves.RAMP[-1][1]
    assert [name for _, name, _ in moves.legend_entries(0.0)] == ["0 mm"]
    assert math.isclose(max(moves.LEGEND_SHARES), 1.0)


def test_the_footer_counts_faces():
    found = [{"face": 1, "largest_move_mm": 0.02}, {"face": 4, "largest_move_mm": 0.3}]
    assert moves.legend_footer(found, 6) == "2 of 6 faces moved, poles by up to 0.3 mm"
    assert moves.legend_footer([], 6) == "no face moved"


def test_headings_of_the_table():
    assert [heading for heading, _ in repair_text.COLUMNS] == [
        "Edge", "Faces", "Angle \u00b0", "Gap {unit}", "Curvature %", "Result"
    ]  # fmt: skip
    assert repair_text.COLUMNS[repair_text.CURVATURE_COLUMN][0] == "Curvature %"


def test_an_empty_report_has_nothing_to_repair():
    assert repair_text.summary_text(repair_text.EMPTY_REPORT) == (
        "Nothing to repair: no two faces share an edge, and none are matched."
    )
    assert repair_text.largest_move_mm(repair_text.EMPTY_REPORT) == 0
    assert not repair_text.is_done(repair_text.EMPTY_REPORT)


def test_what_waits_is_not_repaired_yet(done):
    before = analysis(seam(1), seam(2, "defect", angle=0.4))
    seams = repair_text.waiting(before, "G1", set())
    report = repair_text.build_report(before, None, seams, [], "G1", False)
    assert repair_text.repaired_count(report) == 0
    assert [row.cells[-1] for row in repair_text.build_rows(report)] == [""]
    assert repair_text.summary_text(report) == "1 seam to repair to G1."


def test_the_tool_tip_has_the_seam_before_and_after(done):
    row = next(row for row in repair_text.build_rows(done) if row.state == repair_text.REPAIRED)
    before, after = row.detail.split("\n\n")
    assert before.startswith("Before: Seam 2 (shared)\nGap: \u22650.001 mm, largest at 0.25")
    assert after.startswith("After: Seam 2 (shared)\n") and "Angle: \u22651e-9\u00b0" in after
    assert [each.split("\n")[-1] for each in (before, after)] == ["The verdict is not certain"] * 2
    assert row.cells[2] == "\u22650.4 \u2192 \u22651e-9" and row.cells[-1] == "repaired"


def test_without_moves_only_new_curves_are_told(done):
    done.update(moves=[], edges_led=2)
    assert repair_text.summary_text(done) == (
        "1 of 3 seams repaired to G1; 2 edges got new curves on their faces; defects before 3, "
        "after 2."
    )


def test_an_empty_report_has_the_keys_of_one_that_was_made(done):
    assert set(repair_text.EMPTY_REPORT) == set(done)
    assert (repair_text.EMPTY_REPORT["target"], repair_text.EMPTY_REPORT["chosen"]) == ("G1", False)
