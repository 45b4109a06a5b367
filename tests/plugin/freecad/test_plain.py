# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pure Python ring: colours, rows, sentences, export, finding the kernel."""

import csv
import io
import itertools
import json
import math
import os
import pathlib
import sys
from unittest import mock

import pytest

from freecad.seamwright.plain import (
    enclosure,
    export,
    filters,
    kernel,
    match_distance,
    palette,
    profiles,
    report_text,
    rows,
    summary,
)

TOLERANCE = {
    "gap_mm": 0.01,
    "angle_deg": 0.1,
    "curvature_rel": 0.02,
    "flat_radius_mm": 1e5,
    "crease_deg": 5.0,
}


def figure(value, upper=None):
    return None if value is None else {"lower": value, "upper": upper, "at": 0.25}


def seam(number, seam_class="smooth", gap=0.001, angle=0.01, curvature=0.5, edges=None):
    """A seam as the kernel reports it."""
    return {
        "id": number,
        "kind": "shared",
        "edges": edges or [number],
        "faces": [number, number + 1],
        "length_mm": 10.0 * number,
        "gap_mm": figure(gap),
        "angle_deg": figure(angle),
        "curvature_per_mm": figure(curvature),
        "curvature_rel": figure(curvature),
        "curvature_change_per_mm2": None,
        "curvature_change_rel": None,
        "left_out": {"angle_deg": [], "curvature_per_mm": [], "curvature_rel": []},
        "level": "none" if gap is None else "G1" if seam_class == "smooth" else "G0",
        "class": seam_class,
        "certified": False,
        "worst": None,
        "note": "" if gap is not None else "no pcurve",
    }


@pytest.fixture
def report():
    return {
        "seams": [
            seam(1),
            seam(2, "crease", angle=90.0, curvature=None),
            seam(3, "defect", angle=0.4),
            seam(4, "defect", angle=0.9),
            seam(5, "defect", gap=None, angle=None, curvature=None),
        ],
        "open": [{"edge": 9, "face": 1}],
        "tolerance": dict(TOLERANCE),
        "freecad": {
            "level": "G1",
            "objects": ["Box"],
            "faces": {"1": ["Box", "Face1"]},
            "edges": {"1": ["Box", "Edge1"], "3": ["Box", "Edge7"]},
        },
    }


# Colours


def linear(rgb):
    return [
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (v / 255 for v in rgb)
    ]


#: Linear RGB as seen without one kind of cone (Machado, Oliveira and Fernandes 2009, severity 1).
SIGHTS = {
    "full": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": (
        (0.152286, 1.052583, -0.204868),
        (0.114503, 0.786281, 0.099216),
        (-0.003882, -0.048116, 1.051998),
    ),
    "deuteranopia": (
        (0.367322, 0.860646, -0.227968),
        (0.280085, 0.672501, 0.047413),
        (-0.011820, 0.042940, 0.968881),
    ),
    "tritanopia": (
        (1.255528, -0.076749, -0.178779),
        (-0.078411, 0.930809, 0.147602),
        (0.004733, 0.691367, 0.303900),
    ),
}


def lab(rgb_linear):
    """CIE L*a*b* of linear sRGB, white D65."""
    to_xyz = (
        (0.4124, 0.3576, 0.1805, 0.95047),
        (0.2126, 0.7152, 0.0722, 1.0),
        (0.0193, 0.1192, 0.9505, 1.08883),
    )
    x, y, z = (
        _cube_root(max(0.0, sum(m * c for m, c in zip(row[:3], rgb_linear))) / row[3])
        for row in to_xyz
    )
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def _cube_root(t):
    return t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116


@pytest.mark.parametrize("entries", [palette.CLASSES, palette.LEVELS], ids=["classes", "levels"])
@pytest.mark.parametrize("sight", sorted(SIGHTS))
def test_colours_look_different_to_every_eye(sight, entries):
    seen = [
        lab([sum(m * c for m, c in zip(row, linear(each.rgb))) for row in SIGHTS[sight]])
        for each in entries
    ]
    for one, other in itertools.combinations(seen, 2):
        assert math.dist(one, other) > 20


def test_rank_is_worst_first():
    assert [palette.rank(key) for key in ("defect", "crease", "smooth")] == [0, 1, 2]
    with pytest.raises(KeyError):
        palette.rank("unheard of")


# Rows


def test_rows_come_worst_first(report):
    assert [row.seam for row in rows.build_rows(report)] == [5, 4, 3, 2, 1]


def test_severity_counts_what_decides_at_the_level():
    bad_curvature = seam(1, gap=0.02, angle=0.05, curvature=0.5)
    assert rows.severity(bad_curvature, TOLERANCE, "G1") == pytest.approx(2.0)
    assert rows.severity(bad_curvature, TOLERANCE, "G2") == pytest.approx(25.0)
    assert rows.severity(seam(1, gap=0.02), {**TOLERANCE, "gap_mm": 0.0}, "G0") == math.inf
    assert rows.severity(seam(1, gap=0.0), {**TOLERANCE, "gap_mm": 0.0}, "G0") == 0.0


@pytest.mark.parametrize("descending", [False, True])
def test_rows_without_value_sort_last(report, descending):
    sorted_rows = rows.sort_rows(rows.build_rows(report), "angle_deg", descending)
    assert [row.seam for row in sorted_rows[:-1]] == ([2, 4, 3, 1] if descending else [1, 3, 4, 2])
    assert sorted_rows[-1].angle_deg is None


@pytest.mark.parametrize("column", rows.COLUMNS, ids=lambda column: column.field)
def test_every_column_sorts_and_shows(report, column):
    built = rows.sort_rows(rows.build_rows(report), column.field)
    assert len(built) == 5
    assert all(isinstance(rows.cell_text(row, column), str) for row in built)


def test_edges_sort_by_number_not_by_spelling():
    report = {"seams": [seam(10), seam(9)], "tolerance": TOLERANCE}
    built = rows.sort_rows(rows.build_rows(report), "edge_text")
    assert [row.edge_text for row in built] == ["Edge9", "Edge10"]


def test_filter_keeps_one_class(report):
    built = rows.build_rows(report)
    assert {row.seam for row in rows.filter_rows(built, "defect")} == {3, 4, 5}
    assert rows.filter_rows(built, None) == built


def test_elements_are_named_after_their_owner(report):
    assert rows.element_text(report, "edges", 3, False) == "Edge7"
    assert rows.element_text(report, "edges", 3, True) == "Box.Edge7"
    assert rows.element_text(report, "edges", 8, True) == "Edge8"


def common_cases():
    path = pathlib.Path(__file__).resolve().parents[2] / "data" / "enclosure_texts.json"
    return json.loads(path.read_text(encoding="utf-8"))["cases"]


@pytest.mark.parametrize("case", common_cases(), ids=lambda case: case["text"])
def test_enclosures_are_written_as_the_command_writes_them(case):
    assert enclosure.text({**case, "at": 0.5}, 1, case["limit"]) == case["text"]


def test_a_figure_counts_by_its_upper_bound_when_it_has_one():
    assert rows.figure_value(figure(0.1)) == 0.1
    assert rows.figure_value(figure(0.1, 0.2)) == 0.2
    assert rows.figure_value(None) is None


def test_cells_show_enclosures_and_curvature_in_percent(report):
    report["seams"] = [{**seam(1), "gap_mm": figure(0.0, 1e-13), "curvature_rel": figure(0.1, 0.2)}]
    (row,) = rows.build_rows(report)
    cells = {column.field: rows.cell_text(row, column) for column in rows.COLUMNS}
    assert cells["gap_mm"] == "\u22641e-13" and cells["curvature_rel"] == "10..20"
    assert cells["angle_deg"] == "\u22650.01" and cells["curvature_change_rel"] == "\u2013"
    assert cells["certain"] == "no" and row.gap_mm == 1e-13


def test_the_tool_tip_says_bounds_place_and_certainty(report):
    certain = {**seam(1), "gap_mm": figure(0.1, 0.2), "certified": True}
    text = rows.detail_text(certain, TOLERANCE)
    assert "Gap: 0.1..0.2 mm, largest at 0.25 of the edge" in text and "verdict is certain" in text
    assert "change" not in text
    text = rows.detail_text(report["seams"][4], TOLERANCE)
    assert "Gap: not measured" in text and text.endswith("The verdict is not certain\nno pcurve")


def test_the_tool_tip_names_what_figures_leave_out():
    left_out = {
        "angle_deg": [],
        "curvature_per_mm": [],
        "curvature_rel": [[0, 1e-6], [0.25, 0.2501], [0.9995, 1]],
    }
    text = rows.detail_text({**seam(1), "left_out": left_out}, TOLERANCE)
    (curvature,) = [line for line in text.split("\n") if "excluding" in line]
    assert curvature.endswith(
        "at 0.25 of the edge, excluding the first 1e-06, 0.25 to 0.2501, the last 0.0005 of it"
    )
    assert text.count("excluding") == 1

    left_out["curvature_rel"] = [[k / 8, k / 8 + 1e-9] for k in range(1, 7)]
    text = rows.detail_text({**seam(1), "left_out": left_out}, TOLERANCE)
    assert "excluding 1e-09 at 0.125, 1e-09 at 0.25, 1e-09 at 0.375 and 3 more intervals" in text


def test_the_change_of_curvature_decides_for_g3():
    g3 = {**seam(1, curvature=0.01), "curvature_change_rel": figure(0.1, 0.1)}
    assert rows.severity(g3, TOLERANCE, "G3") == pytest.approx(5.0)
    assert rows.severity(g3, TOLERANCE, "G2") == pytest.approx(0.5)
    assert "change of curvature: 10 %" in rows.detail_text(g3, TOLERANCE)


@pytest.mark.parametrize(
    "quantity, label",
    [
        ("gap", "\u22650.001 mm"),
        ("angle", "12.4\u00b0"),
        ("curvature", "curvature 50..60 %"),
        ("curvature_change", ""),
    ],
)
def test_the_label_of_a_worst_point_has_figure_and_unit(quantity, label):
    one = {**seam(1), "angle_deg": figure(12.4, 12.4), "curvature_rel": figure(0.5, 0.6)}
    one["worst"] = {"quantity": quantity, "at": 0.5, "point": [0, 0, 0]}
    assert rows.worst_label(one, TOLERANCE) == label
    assert rows.worst_label(seam(1), TOLERANCE) == ""


def test_uncertain_rows_can_be_filtered(report):
    report["seams"][1]["certified"] = True
    built = rows.build_rows(report)
    assert {row.seam for row in rows.filter_rows(built, rows.UNCERTAIN)} == {1, 3, 4, 5}


def test_a_picked_edge_is_found_on_source_and_analysis(report):
    report["seams"] = [seam(1, edges=[4]), seam(2, edges=[4, 6]), seam(3, edges=[3])]
    known = {"Edge1": 4, "Edge2": 6, "Edge3": 3}
    numbers = rows.edge_numbers_by_name(report, "Analysis")
    for element in (*known, "Edge4", "Edge0", "Vertex1", ""):
        assert numbers.get(("Analysis", element)) == known.get(element)
    assert numbers["Box", "Edge7"] == 3
    assert ("Box", "Edge8") not in numbers
    assert rows.edge_numbers_by_name({}, "Analysis") == {}
    assert rows.edge_numbers(report) == list(summary.edge_classes(report))


def test_reports_of_older_versions_are_shown(report):
    for old in report["seams"]:
        for key in ("worst", "curvature_change_per_mm2", "curvature_change_rel", "left_out"):
            del old[key]
        assert rows.detail_text(old, TOLERANCE)
    assert len(rows.build_rows(report)) == 5
    assert export.csv_text(report).count("\n") == 6


# Profiles


def test_profiles_are_those_of_the_kernel():
    import seamwright

    assert list(profiles.PROFILES) == list(seamwright.PROFILES) == list(profiles.LABELS)
    for name, figures in seamwright.PROFILES.items():
        assert profiles.PROFILES[name] == pytest.approx(figures, rel=1e-12)


def test_a_profile_is_known_by_its_figures():
    for name, figures in profiles.PROFILES.items():
        assert profiles.name_of({**figures, "match_mm": 3.0}) == name
        assert profiles.name_of({**figures, "gap_mm": 0.0101}) is None
    assert "gap 0.001 mm, angle 0.01\u00b0, curvature 2 %" in profiles.tip("class-a")


# Sentences


def test_summary_counts_and_judges(report):
    text = summary.summary_text(report)
    assert text.startswith("5 seams: 3 defects, 1 crease, 1 smooth; 1 free edge;")
    assert "largest gap \u22650.001 mm, largest angle \u22650.9\u00b0" in text and text.endswith(
        "G1 is not met."
    )
    assert not summary.passed(report)


def test_the_summary_tells_defects_that_are_as_sharp_as_creases(report):
    said = "defects as sharp as a crease, but with a gap"
    assert said not in summary.summary_text(report)
    report["seams"] += [
        seam(11, "defect", gap=0.02, angle=90.0),
        seam(12, "defect", gap=0.02, angle=60.0),
        seam(13, "defect", gap=0.001, angle=6.0),  # sharp in one place only
        seam(14, "defect", gap=0.02, angle=3.0),
        seam(15, "crease", gap=0.001, angle=90.0),
    ]
    text = summary.summary_text(report)
    assert "largest angle \u226590\u00b0; 2 %s; " % said in text


def test_summary_without_seams():
    assert summary.summary_text({"seams": []}) == "No seams: no two faces share an edge."
    text = summary.summary_text(
        {"seams": [], "open": [{"edge": 1, "face": 1}, {"edge": 2, "face": 1}]}
    )
    assert text.endswith("2 free edges can be matched: see Tolerances.")
    assert not summary.passed({"seams": []})


def test_an_edge_of_two_seams_has_the_worst_class():
    report = {"seams": [seam(1, edges=[4]), seam(2, "defect", edges=[4, 6]), seam(3, edges=[4])]}
    assert list(summary.edge_classes(report).items()) == [(4, "defect"), (6, "defect")]


def test_the_tolerance_line_names_what_decides(report):
    assert summary.tolerance_text(report) == "G1: gap \u2264 0.01 mm, angle \u2264 0.1\u00b0"
    report["freecad"]["level"] = "G2"
    assert summary.tolerance_text(report).endswith("curvature \u2264 2 %")


def test_legend_has_every_class_with_its_count(report):
    entries = summary.legend_entries(report)
    assert [text for _, text, _ in entries] == ["Defect: 3", "Crease: 1", "Smooth: 1"]
    assert entries[1][2] == "sharper than 5\u00b0, taken as intended"


def test_the_summary_says_how_many_verdicts_are_certain_and_how_many_seams_matched(report):
    assert "; 0 of 5 verdicts certain; G1" in summary.summary_text(report)
    report["seams"][0].update(certified=True, kind="matched")
    text = summary.summary_text(report)
    assert "; 1 of 5 verdicts certain; G1" in text and text.startswith(
        "5 seams, 1 of them matched: "
    )


def test_the_largest_figure_is_one_that_was_seen(report):
    report["seams"][0]["gap_mm"]["upper"] = 0.5
    assert summary.largest(report, "gap_mm") == 0.001


def test_the_summary_encloses_the_largest_figure_of_all_seams(report):
    report["seams"] = [seam(1), seam(2)]
    for one, lower, upper in zip(report["seams"], (0.5, 0.2), (0.6, 0.7)):
        one["gap_mm"] = {"lower": lower, "upper": upper, "at": 0}
        one["angle_deg"] = {"lower": 0, "upper": 1e-12, "at": 0}
    assert "largest gap 0.5..0.7 mm, largest angle \u22641e-12\u00b0;" in summary.summary_text(
        report
    )


# Export


def test_json_comes_back_as_written(report, tmp_path):
    export.write(report, tmp_path / "seams.json")
    assert json.loads((tmp_path / "seams.json").read_text(encoding="utf-8")) == report


def test_csv_has_a_line_a_seam_and_full_digits(report, tmp_path):
    report["seams"][0]["gap_mm"]["lower"] = 0.1234567890123456
    export.write(report, tmp_path / "seams.CSV")
    lines = list(csv.DictReader(io.StringIO((tmp_path / "seams.CSV").read_text(encoding="utf-8"))))
    assert [line["id"] for line in lines] == ["1", "2", "3", "4", "5"]
    assert float(lines[0]["gap_mm_lower"]) == 0.1234567890123456
    assert lines[0]["edges"] == "Box.Edge1" and lines[4]["gap_mm_lower"] == ""
    assert lines[0]["worst"] == lines[0]["worst_z_mm"] == ""


def test_csv_has_bounds_and_the_worst_point(report):
    report["seams"][0].update(
        angle_deg=figure(0.1, 0.2), worst={"quantity": "angle", "at": 0.5, "point": [1, -2, 3]}
    )
    line = next(csv.DictReader(io.StringIO(export.csv_text(report))))
    assert (line["angle_deg_lower"], line["angle_deg_upper"], line["angle_deg_at"]) == (
        "0.1",
        "0.2",
        "0.25",
    )
    assert (line["worst"], line["worst_at"], line["worst_y_mm"]) == ("angle", "0.5", "-2")


def test_a_missing_folder_is_named(report, tmp_path):
    with pytest.raises(export.ExportError, match="nowhere does not exist"):
        export.write(report, tmp_path / "nowhere" / "seams.csv")


def test_an_unknown_ending_is_refused(report, tmp_path):
    with pytest.raises(export.ExportError, match=r"\.csv or \.json"):
        export.write(report, tmp_path / "seams.txt")
    assert os.listdir(tmp_path) == []


def test_a_failed_export_leaves_the_old_file(report, tmp_path):
    target = tmp_path / "seams.json"
    target.write_text("old")
    with mock.patch("os.replace", side_effect=OSError(28, "No space left on device")):
        with pytest.raises(export.ExportError, match="No space left"):
            export.write(report, target)
    assert target.read_text() == "old" and os.listdir(tmp_path) == ["seams.json"]


# Kernel


def module(version):
    return mock.Mock(OCCT_VERSION=version)


def test_kernel_of_the_same_occt_is_taken():
    with mock.patch.object(kernel, "built_for", return_value={}):
        for version in ("7.6.3", "7.6.9"):
            with mock.patch.dict(sys.modules, seamwright=module(version)):
                assert kernel.load("7.6.3").OCCT_VERSION == version


def test_kernel_of_another_occt_is_refused():
    with mock.patch.object(kernel, "built_for", return_value={}):
        with mock.patch.dict(sys.modules, seamwright=module("7.8.1")):
            with pytest.raises(kernel.KernelUnavailable, match="OpenCASCADE 7.8.1.*7.6.3"):
                kernel.load("7.6.3")


def test_another_occt_is_refused_before_anything_is_loaded():
    built = {"python": "3.13", "occt": "7.8.1"}
    with mock.patch.object(kernel, "built_for", return_value=built):
        with mock.patch.dict(sys.modules, seamwright=None):
            with pytest.raises(kernel.KernelUnavailable, match="built for OpenCASCADE 7.8.1"):
                kernel.load("7.6.3")


def test_a_missing_module_says_what_it_was_built_for():
    built = {"python": "3.13", "occt": "7.6.3"}
    with mock.patch.object(kernel, "built_for", return_value=built):
        with mock.patch.dict(sys.modules, seamwright=None):
            with pytest.raises(kernel.KernelUnavailable, match="Python 3.13 and OpenCASCADE 7.6.3"):
                kernel.load("7.6.3")


# What is shown of seams


def test_seams_of_a_level_are_coloured_by_the_worst_of_an_edge(report):
    report["seams"] = [seam(1, edges=[4]), seam(2, edges=[4, 6]), seam(3, edges=[3])]
    for entry, level in zip(report["seams"], ("G2", "G0", "none")):
        entry["level"] = level
    assert summary.edge_keys(report, summary.LEVEL) == {4: "G0", 6: "G0", 3: "none"}
    assert summary.level_counts(report) == {"none": 1, "G0": 1, "G1": 0, "G2": 1, "G3": 0}
    texts = [(entry.key, text) for entry, text, _ in summary.legend_entries(report, summary.LEVEL)]
    assert texts[:2] == [("none", "No level: 1"), ("G0", "G0: 1")]


def test_filters_count_what_they_show(report):
    report["seams"][1]["certified"] = True
    built = rows.build_rows(report)
    shown = [len(rows.filter_rows(built, filters.of(name))) for name in filters.NAMES]
    assert filters.counts(report) == shown
    assert shown[0] == shown[1] + shown[filters.NAMES.index("Smooth")]
    for name in filters.NAMES:
        edges = {n for row in rows.filter_rows(built, filters.of(name)) for n in row.edges}
        assert rows.shown_edges(report, filters.of(name)) == edges


def test_copied_rows_are_a_table_of_text(report):
    built = rows.build_rows(report)
    lines = [line.split("\t") for line in rows.cells(built).split("\n")]
    assert lines[0] == [column.title.format(unit="mm") for column in rows.COLUMNS]
    assert [line[0] for line in lines[1:]] == [str(row.seam) for row in built]
    assert {len(line) for line in lines} == {len(rows.COLUMNS)}


# Reports in parts


@pytest.mark.parametrize("separators", [(",", ":"), (", ", ": ")])
@pytest.mark.parametrize("part", [1, 500, 10**6])
def test_a_report_read_in_parts_is_the_same(monkeypatch, report, separators, part):
    monkeypatch.setattr(report_text, "PART", part)
    report["summary"] = {"seams": 5}
    report["seams"][2]["note"] = 'a note with "seams":[ and , {"id": 3} in it'
    text = json.dumps(report, separators=separators)
    assert report_text.read(text) == report
    longer = report_text.with_entry(text, "more", {"a": [1, 2]})
    assert report_text.read(longer) == {**report, "more": {"a": [1, 2]}}
    empty = {**report, "seams": []}
    assert report_text.read(json.dumps(empty, separators=separators)) == empty


# The proposed match distance


def side_by_side(*gaps):
    return [{"gap_mm": figure(gap)} for gap in gaps]


@pytest.mark.parametrize(
    "gaps, expected",
    [
        ((), None),
        ((0.0, 0.0), 0.02),  # twice the gap tolerance
        ((0.004, 0.02), 0.05),
        ((0.02, 0.03, 4.0), 0.1),  # edges 4 mm apart only pass each other
        ((0.03, 9.5), 0.1),  # cut off at the distance that was tried
        ((9.5,), None),
        ((7.0,), 10.0),  # not more than was tried
    ],
)
def test_the_proposed_distance_covers_the_gaps(gaps, expected):
    found = match_distance.proposed(side_by_side(*gaps), 10.0, 0.01)
    assert found == (expected if expected is None else pytest.approx(expected))
