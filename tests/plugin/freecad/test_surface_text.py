# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts about new surfaces."""

import pytest

from freecad.seamwright.plain import surface_text

TOLERANCE = {"gap_mm": 0.01, "angle_deg": 0.1, "curvature_rel": 0.02}


def figure(lower, upper):
    return {"lower": lower, "upper": upper, "at": 0.5}


def seam(target, angle, curvature, **changed):
    return {
        "id": 1,
        "kind": "matched",
        "side": "Start",
        "name": "Plate.Edge3",
        "target": target,
        "gap_mm": figure(1e-5, 2e-5),
        "angle_deg": angle,
        "curvature_rel": curvature,
        "curvature_change_rel": None,
        "certified": True,
        **changed,
    }


def report(*seams, **changed):
    return {
        "reached": True,
        "tolerance": TOLERANCE,
        "poles": [9, 6],
        "to": None,
        "fold": None,
        "sides": [{"side": "start", "reason": ""}],
        "laterals": [],
        "seams": list(seams),
        **changed,
    }


MET = seam("G2", figure(1e-6, 2e-6), figure(1e-4, 2e-4))


@pytest.mark.parametrize(
    "target, angle, curvature, result",
    [
        ("G2", figure(1e-6, 2e-6), figure(1e-4, 2e-4), "G2 is met"),
        ("G2", figure(1e-6, 2e-6), figure(0.01, None), "G2 is uncertain"),
        ("G2", figure(1e-6, 2e-6), figure(0.3, 0.4), "misses G2"),
        ("G1", figure(1e-6, 2e-6), figure(0.3, 0.4), "G1 is met"),
        ("G0", figure(20.0, 21.0), figure(0.3, 0.4), "G0 is met"),
    ],
)
def test_a_row_is_judged_by_the_level_of_its_side(target, angle, curvature, result):
    (row,) = surface_text.build_rows(report(seam(target, angle, curvature)))
    assert row.cells[:2] == ("Start", "Plate.Edge3") and row.cells[-1] == result
    assert row.met == result.endswith("is met") and len(row.cells) == len(surface_text.COLUMNS)


def test_lines_inside_a_surface_that_have_their_level_are_one_row():
    inside = {"kind": surface_text.LINE, "side": "Inside"}
    lines = [
        seam("G2", figure(0, place * 1e-6), figure(1e-4, 2e-4), name=str(place), **inside)
        for place in (1, 2, 3)
    ]
    lines[1] = seam("G2", figure(0, 1e-6), figure(0.3, 0.4), name="2", **inside)
    missed, together = surface_text.build_rows(report(*lines))
    assert (missed.seams, missed.met, missed.cells[:2]) == ((1,), False, ("Inside", "line 2"))
    assert (together.seams, together.met) == ((0, 2), True)
    assert together.cells == (
        "Inside", "2 lines of joints", "\u22642e-5", "\u22643e-6", "\u22640.02", "\u2013",
        "G2 is met",
    )  # fmt: skip
    (row,) = surface_text.build_rows(report(lines[0]))
    assert row.cells[:2] == ("Inside", "line 1")


def test_the_change_of_curvature_is_a_figure_of_seams_with_g3():
    found = report(MET, {**MET, "target": "G3", "curvature_change_rel": figure(1e-3, 1.1e-3)})
    cells = [row.cells[surface_text.CHANGE] for row in surface_text.build_rows(found)]
    assert cells == ["\u2013", "0.1..0.11"]
    assert surface_text.has_change(found) and not surface_text.has_change(report(MET))
    assert surface_text.COLUMNS[surface_text.CHANGE][0] == "Change %"


def test_bounds_are_those_of_seams_whose_level_they_decide():
    other = seam("G0", figure(20.0, 21.0), figure(0.3, 0.4))
    assert surface_text.largest([MET, other]) == {
        "gap_mm": 2e-5,
        "angle_deg": 2e-6,
        "curvature_rel": 2e-4,
    }
    assert surface_text.summary(report(MET, other)) == (
        "Every seam has its level: gap at most 2e-5 mm, angle at most 2e-6\u00b0, curvature at "
        "most 0.02 %; 9 x 6 poles."
    )


@pytest.mark.parametrize(
    "target, figures",
    [("G0", "gap at most 2e-5 mm"), ("G1", "gap at most 2e-5 mm, angle at most 2e-6\u00b0")],
)
def test_figures_that_decide_no_level_are_left_out(target, figures):
    only = seam(target, figure(1e-6, 2e-6), figure(0.8, 0.93))
    assert surface_text.summary(report(only)) == (
        "Every seam has its level: %s; 9 x 6 poles." % figures
    )


def test_the_summary_says_what_falls_short():
    missed = seam("G2", figure(1e-6, 2e-6), figure(0.3, 0.4))
    text = surface_text.summary(
        report(
            missed,
            reached=False,
            fold={"distance_mm": 5.0},
            sides=[{"side": "start", "reason": "no seam was found."}],
            laterals=[{"reason": "it is too far"}],
        )
    )
    assert text.startswith(
        "Not reached (G2 is not certain at Plate.Edge3; start, no seam was found; lateral "
        "boundary, it is too far; the surface folds 5 mm from the side): gap"
    )


def test_lengths_up_to_a_face_are_told_and_no_report_has_no_rows():
    text = surface_text.summary(report(MET, to={"least_mm": 10.1, "most_mm": 10.44}))
    assert text.endswith("9 x 6 poles; 10.1 to 10.4 mm long.")
    assert surface_text.build_rows({"reason": "no edge"}) == []


def test_a_blend_that_folds_says_so_although_its_seams_have_their_level():
    found = report(MET, fold={"distance_mm": 17.1745})
    assert surface_text.folds(found) and not surface_text.folds(report(MET))
    assert surface_text.summary({**found, **surface_text.largest(found["seams"])}).startswith(
        "Every seam has its level, but the surface turns back 17.2 mm from the start; less "
        "tension may help: gap"
    )


def test_one_line_that_has_its_level_is_met_and_several_keep_their_order():
    inside = {"kind": surface_text.LINE, "side": "inside"}
    (row,) = surface_text.build_rows(report({**MET, **inside, "name": "7"}))
    assert (row.met, row.seams, row.cells[1]) == (True, (0,), "line 7")
    lines = [{**MET, **inside, "name": str(place)} for place in (1, 2)]
    lines[1].update(side="outside", target="G0")
    (row,) = surface_text.build_rows(report(*lines))
    assert (row.cells[0], row.cells[-1]) == ("inside", "G2 is met"), "those of the first line"
    assert row.detail == "Lines inside the surface at which the curves have their joints"


def umbrella(**changed):
    return {"members": 5, "order": "G2", "reached": True, "gap_mm": 1.01e-5, "angle_deg": 0.0020001,
            "curvature_rel": 0.0122901, "moved_mm": 0.0, "moved_most": 3, "fit_mm": 0.0,
            "outer_edges": [], **changed}  # fmt: skip


def test_faces_around_a_point_tell_their_figures():
    text = "5 faces around the point: %s, gap at most 1.1e-5 mm, angle at most 0.00201\u00b0%s; "
    bent = ", curvature at most 1.23 %"
    assert surface_text.umbrella_summary(umbrella()) == (
        text % ("every seam is G2", bent) + "no edge moved."
    )
    assert surface_text.umbrella_summary(umbrella(order="G1")) == (
        text % ("every seam is G1", "") + "no edge moved."
    )
    assert surface_text.umbrella_summary(umbrella(reached=False)).startswith(
        text % ("not every seam is certainly G2", bent)
    )


@pytest.mark.parametrize(
    "changed, followed",
    [
        ({"moved_mm": 9e-10}, "no edge moved."),
        ({"moved_mm": 0.01201}, "edges moved by at most 0.0121 mm, edge 3 most."),
        ({"fit_mm": 1e-4}, "no edge moved, curves within 1e-4 mm of them."),
        ({"outer_edges": [1]}, "no edge moved; the outer boundary stays."),
        (
            {"moved_mm": 2.0, "fit_mm": 0.5, "outer_edges": [1]},
            "edges moved by at most 2 mm, edge 3 most, curves within 0.5 mm of them; the outer "
            "boundary stays.",
        ),
    ],
)
def test_faces_around_a_point_tell_what_moved(changed, followed):
    text = surface_text.umbrella_summary(umbrella(**changed))
    assert text.split("curvature at most 1.23 %; ")[1] == followed


def test_a_loft_tells_its_lines_of_joints():
    found = {"faces": 2, "keys": 4, "distance_mm": 0.001001, "seams": [], "angle_deg": 0.03001,
             "curvature_rel": 0.124501}  # fmt: skip
    assert surface_text.loft_summary(found) == "2 faces through 4 curves, within 0.00101 mm."
    assert surface_text.loft_summary({**found, "seams": [MET]}) == (
        "2 faces through 4 curves, within 0.00101 mm; across 1 line of joints: angle at most "
        "0.0301\u00b0, curvature at most 12.5 %."
    )


def test_headings_of_the_table():
    assert [heading for heading, _ in surface_text.COLUMNS] == [
        "Place", "Along", "Gap {unit}", "Angle \u00b0", "Curvature %",
            "Change %", "Result",
    ]  # fmt: skip


def test_seams_at_sides_have_a_row_each():
    found = surface_text.build_rows(report(MET, {**MET, "name": "Plate.Edge4"}))
    assert [row.cells[1] for row in found] == ["Plate.Edge3", "Plate.Edge4"]
    assert [row.seams for row in found] == [(0,), (1,)]


def test_a_surface_that_does_not_fold_says_nothing_of_it():
    side = {"side": "end", "reason": "no seam was found."}
    assert surface_text.summary(report(MET, reached=False, sides=[side])).startswith(
        "Not reached (end, no seam was found): gap"
    )
