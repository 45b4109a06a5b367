# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cells of the table of seams, word by word."""

import math

import pytest
from test_plain import TOLERANCE, figure, seam

from freecad.seamwright.plain import rows

COLUMNS = {column.field: column for column in rows.COLUMNS}


def built(*seams, **freecad):
    report = {"seams": list(seams), "tolerance": dict(TOLERANCE), "freecad": freecad}
    return rows.build_rows(report)


def cells(row):
    return {name: rows.cell_text(row, column) for name, column in COLUMNS.items()}


def test_headings_are_short_and_have_units():
    assert [column.title for column in rows.COLUMNS] == [
        "Seam", "Class", "Angle \u00b0", "Gap {unit}", "Curv. %", "Change %", "Level", "Certain",
        "Edge", "Faces", "Length {unit}",
    ]  # fmt: skip


def test_cells_of_a_seam():
    (row,) = built({**seam(12, "defect", angle=0.25, edges=[7, 30]), "certified": True})
    assert cells(row) == {
        "seam": "12", "seam_class": "Defect", "angle_deg": "\u22650.25", "gap_mm": "\u22650.001",
        "curvature_rel": "\u226550", "curvature_change_rel": "\u2013", "level": "G0",
        "certain": "yes", "edge_text": "7, 30", "face_text": "12, 13", "length_mm": "120",
    }  # fmt: skip


def test_cells_of_what_was_not_measured_have_a_dash():
    one = seam(1, "defect", gap=None, angle=None, curvature=None)
    del one["length_mm"]
    (row,) = built(one)
    found = cells(row)
    dashes = {name for name, text in found.items() if text == "\u2013"}
    assert dashes == {"angle_deg", "gap_mm", "curvature_rel", "curvature_change_rel", "length_mm"}
    assert (found["seam_class"], found["certain"]) == ("Defect?", "no")


def test_edges_of_several_objects_have_the_names_of_their_objects():
    names = {
        "edges": {"3": ["Box", "Edge7"]},
        "faces": {"3": ["Box", "Face2"], "4": ["Sheet", "Face1"]},
    }
    (row,) = built(seam(3), objects=["Box"], **names)
    assert (row.edge_text, row.face_text) == ("Edge7", "Face2, Face1")
    assert (cells(row)["edge_text"], cells(row)["face_text"]) == ("7", "2, 1")
    (row,) = built(seam(3), objects=["Box", "Sheet"], **names)
    assert (row.edge_text, row.face_text) == ("Box.Edge7", "Box.Face2, Sheet.Face1")
    assert (cells(row)["edge_text"], cells(row)["face_text"]) == (row.edge_text, row.face_text)


@pytest.mark.parametrize("gap, angle", [(None, 0.05), (0.001, None), (None, None)])
def test_a_seam_that_was_not_measured_is_the_worst(gap, angle):
    one = {**seam(1, gap=0.001), "gap_mm": figure(gap), "angle_deg": figure(angle)}
    assert rows.severity(one, TOLERANCE, "G1") == math.inf


@pytest.mark.parametrize(
    "level, field", [("G0", "gap_mm"), ("G1", "angle_deg"), ("G2", "curvature_rel")]
)
def test_below_the_defects_a_column_shows_the_order(level, field):
    seams = [
        seam(1, gap=9e-3, angle=0.01, curvature=0.001),
        seam(2, gap=1e-5, angle=0.02, curvature=0.01),
        seam(3, gap=1e-3, angle=0.02, curvature=0.005),
        seam(4, gap=1e-4, angle=0.0, curvature=0.02),
        seam(5, "defect", gap=1e-3, angle=1.0),
        seam(6, "defect", gap=1.0, angle=0.3),
    ]
    report = {"seams": seams, "tolerance": TOLERANCE, "freecad": {"level": level}}
    found = rows.build_rows(report)
    figures = [getattr(row, field) for row in found[2:]]
    assert figures == sorted(figures, reverse=True)
    if level == "G1":
        assert [row.seam for row in found] == [6, 5, 3, 2, 1, 4]


def test_columns_that_tell_nothing_are_needless():
    sure = {**seam(1), "certified": True}
    change = {**sure, "curvature_change_rel": figure(0.5)}
    for field, teller in (("curvature_change_rel", change), ("certain", seam(1))):
        assert rows.NEEDLESS[field](built(sure, sure))
        assert not rows.NEEDLESS[field](built(sure, teller))


@pytest.mark.parametrize("field, wanted", [
    ("seam_class", [2, 1, 3]), ("level", [2, 1, 3]), ("edge_text", [1, 3, 2]), ("seam", [1, 2, 3]),
])  # fmt: skip
def test_words_sort_by_their_meaning(field, wanted):
    given = [
        {**seam(1, "crease", edges=[9]), "level": "G0"},
        {**seam(2, "defect", edges=[100]), "level": "none"},
        {**seam(3, "smooth", edges=[20]), "level": "G3"},
    ]
    assert [row.seam for row in rows.sort_rows(built(*given), field)] == wanted
    assert [row.seam for row in rows.sort_rows(built(*given), field, True)] == wanted[::-1]


def test_four_intervals_are_listed_and_of_five_three():
    def told(count):
        left_out = {"angle_deg": [[k / 8, k / 8 + 0.01] for k in range(1, count + 1)]}
        text = rows.detail_text({**seam(1), "left_out": left_out}, TOLERANCE)
        return text.split("excluding ")[1].split(" of it")[0]

    four = ["0.125 to 0.135", "0.25 to 0.26", "0.375 to 0.385", "0.5 to 0.51"]
    assert told(4) == ", ".join(four)
    assert told(5) == ", ".join(four[:3]) + " and 2 more intervals"


def test_the_tool_tip_of_a_seam_with_all_figures():
    figures = {"gap_mm": 0.25, "angle_deg": 0.5, "curvature_per_mm": 0.125, "curvature_rel": 0.75,
               "curvature_change_per_mm2": 0.0625, "curvature_change_rel": 0.875}  # fmt: skip
    given = {name: {"lower": value, "upper": value, "at": 0.5} for name, value in figures.items()}
    text = rows.detail_text({**seam(7), **given, "certified": True, "note": "a note"}, TOLERANCE)
    place = ", largest at 0.5 of the edge"
    assert text.split("\n") == [
        "Seam 7 (shared)",
        "Gap: 0.25 mm" + place,
        "Angle: 0.5\u00b0" + place,
        "Difference of curvature: 0.125 /mm" + place,
        "Relative difference of curvature: 75 %" + place,
        "Difference of the change of curvature: 0.0625 /mm\u00b2" + place,
        "Relative difference of the change of curvature: 87.5 %" + place,
        "The verdict is certain: it is the same for every value within the bounds",
        "a note",
    ]


def test_numbers_stand_to_the_right():
    assert [column.field for column in rows.COLUMNS if column.numeric] == [
        "seam", "angle_deg", "gap_mm", "curvature_rel", "curvature_change_rel", "length_mm"
    ]  # fmt: skip


def test_the_worst_change_of_curvature_is_told_in_percent():
    change = {"lower": 0.875, "upper": 0.875, "at": 0.5}
    worst = {"quantity": "curvature_change", "at": 0.5, "point": [0, 0, 0]}
    one = {**seam(1), "curvature_change_rel": change, "worst": worst}
    assert rows.worst_label(one, TOLERANCE) == "change of curvature 87.5 %"


def test_the_level_of_the_report_decides_which_seam_is_worst():
    bent, kinked = seam(1, curvature=0.5, angle=0.01), seam(2, curvature=0.001, angle=0.09)
    assert [row.seam for row in built(bent, kinked)] == [2, 1], "G1 unless it says another level"
    assert [row.seam for row in built(bent, kinked, level="G2")] == [1, 2]


def test_a_figure_without_a_place_has_none():
    one = {**seam(1), "gap_mm": {"lower": 0.25, "upper": 0.25, "at": None}}
    assert "Gap: 0.25 mm\n" in rows.detail_text(one, TOLERANCE)
    del one["gap_mm"]["at"]
    assert "Gap: 0.25 mm\n" in rows.detail_text(one, TOLERANCE)


def test_elements_of_one_object_have_its_name():
    found = rows.located((each for each in (seam(1), seam(4))), TOLERANCE, "Fill")
    assert found == {
        "tolerance": TOLERANCE,
        "freecad": {
            "faces": {str(n): ["Fill", "Face%d" % n] for n in (1, 2, 4, 5)},
            "edges": {str(n): ["Fill", "Edge%d" % n] for n in (1, 4)},
        },
    }
