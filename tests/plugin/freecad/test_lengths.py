# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths in tables: in the unit of the user."""

import pytest

from freecad.seamwright.plain import fill_text, lengths, match_text, new_seams, rows

INCH = lengths.Unit("in", 25.4)

LIMITS = {"gap_mm": 0.01, "angle_deg": 0.1, "curvature_rel": 0.02}


@pytest.fixture(autouse=True)
def inches():
    lengths.ask(lambda: INCH)
    yield
    lengths.ask(lambda: lengths.MM)


def seam(gap_mm):
    figures = {"gap_mm": gap_mm, "angle_deg": 0.2, "curvature_rel": 0.3}
    return {
        **{name: {"lower": each, "upper": each, "at": 0.5} for name, each in figures.items()},
        "id": 3, "kind": "shared", "class": "defect", "level": "G0", "certified": True,
        "edges": [4], "faces": [1, 2], "length_mm": 50.8, "note": "",
        "worst": {"quantity": "gap", "point": [0, 0, 0]},
    }  # fmt: skip


def test_cells_headings_and_tool_tips_have_the_unit_of_the_user():
    (row,) = rows.build_rows({"seams": [seam(0.254)], "tolerance": LIMITS})
    cells = dict(zip(*(line.split("\t") for line in rows.cells([row]).split("\n"))))
    assert (cells["Gap in"], cells["Length in"], cells["Angle \u00b0"]) == ("0.01", "2", "0.2")
    assert "Gap: 0.01 in, largest at 0.5 of the edge" in row.detail
    assert rows.worst_label(seam(0.254), LIMITS) == "0.01 in"
    assert lengths.titled(rows.COLUMNS[3].tip).endswith(", in in")


def test_what_is_stored_is_in_mm():
    assert rows.figure_text(seam(0.254), "gap_mm", LIMITS) == "0.254"
    (row,) = rows.build_rows({"seams": [seam(0.254)], "tolerance": LIMITS})
    assert row.gap_mm == 0.254


def test_the_other_tables():
    built = new_seams.build_rows([{**seam(0.0254), "between": "fill, Face3"}], LIMITS, "G1")
    assert built[0].cells[3] == "0.001"
    report = {"before": seam(0.0254), "after": None, "matched": False, "tolerance": LIMITS}
    assert match_text.table(report)[0] == ("Gap in", "0.001", "\u2013")
    hole = {"id": 1, "sides": [], "has_corners": False, "longest": False, "length_mm": 254.0,
            "centre_mm": [25.4, 0, -50.8]}  # fmt: skip
    text = fill_text.hole_text(hole, [hole])
    assert text == "Hole 1: no corner, length 10 in, centre (1, 0, -2)"


def test_a_figure_stays_on_its_side_of_the_tolerance():
    near = 0.010000001
    found = {"gap_mm": {"lower": near, "upper": near}}
    assert float(rows.shown_text(found, "gap_mm", LIMITS)) > 0.01 / 25.4
