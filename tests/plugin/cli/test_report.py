# SPDX-License-Identifier: LGPL-2.1-or-later
"""What analyze writes: JSON against its schema, table and CSV against the JSON, exit statuses."""

import csv
import io
import json
import math
import re

import pytest

from command import run
from models import BROKEN, OCCT_DATA, box_text, installed, roof_text
from patches import sheet_text
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("analysis")

FILES = [
    OCCT_DATA / "step/screw.step",
    OCCT_DATA / "step/linkrods.step",
    OCCT_DATA / "occ/shell1.brep",
    OCCT_DATA / "iges/bearing.iges",
    OCCT_DATA / "occ/hammer.brep",
]


def without_a_number(text):
    """The place of the first vertex is none."""
    place = re.search(r"VERTEX_POINT\('',#(\d+)", text)[1]
    return re.sub(rf"(#{place}=CARTESIAN_POINT\('',\()[^)]*", r"\1NAN,INF,0.", text, count=1)


_METRE = "#16=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"
TEXTS = {
    "sheet": sheet_text(count_x=3, count_y=2),
    "loose sheet": sheet_text(count_x=3, count_y=2, shared=False),
    "box in metres": box_text(unit=_METRE),
    "a vertex is not a number": without_a_number(sheet_text()),
    "a surface is missing": re.sub(
        r"(ADVANCED_FACE\('',\(#\d+\),)#\d+", r"\1#99999999", box_text(), count=1
    ),
}

FIGURES = (
    "gap_mm",
    "angle_deg",
    "curvature_per_mm",
    "curvature_rel",
    "curvature_change_per_mm2",
    "curvature_change_rel",
)


@pytest.fixture
def box(tmp_path):
    path = tmp_path / "box.step"
    path.write_text(box_text())
    return path


def roof(tmp_path, angle_deg):
    path = tmp_path / f"roof{angle_deg}.step"
    path.write_text(roof_text(angle_deg))
    return path


def analysis(path, *options):
    result = run("analyze", "--format", "json", *options, path)
    assert result.returncode in (0, 1), result.stderr
    lines = result.stdout.splitlines()
    assert len(lines) == 1
    report = json.loads(lines[0])
    notes = report["model"]["notes"]
    assert result.stderr == "".join(f"seamwright: warning: {path}: {note}\n" for note in notes)
    return report, result.returncode


def strict(report):
    expect_valid(report, VALIDATOR)


def check_summary(report):
    seams, summary = report["seams"], report["summary"]
    assert summary["seams"] == len(seams)
    for level in ("none", "G0", "G1", "G2", "G3"):
        assert summary["by_level"][level] == sum(seam["level"] == level for seam in seams)
    for key, name in (("smooth", "smooth"), ("defects", "defect"), ("creases", "crease")):
        assert summary[key] == sum(seam["class"] == name for seam in seams)
    assert summary["uncertified"] == sum(not seam["certified"] for seam in seams)
    assert summary["matched_seams"] == sum(seam["kind"] == "matched" for seam in seams)
    assert summary["passed"] == (summary["defects"] == 0)
    assert summary["open_edges"] == len(report["open"])
    assert summary["non_manifold_edges"] == len(report["non_manifold"])
    for key, figure in (("max_gap_mm", "gap_mm"), ("max_angle_deg", "angle_deg")):
        values = [seam[figure]["lower"] for seam in seams if seam[figure]]
        assert summary[key] == pytest.approx(max(values, default=0), rel=1e-12)


def check_seams(report):
    tolerance = report["tolerance"]
    assert [seam["id"] for seam in report["seams"]] == list(range(1, len(report["seams"]) + 1))
    for seam in report["seams"]:
        assert all(face <= report["model"]["faces"] for face in seam["faces"])
        assert all(edge <= report["model"]["edges"] for edge in seam["edges"])
        assert seam["kind"] == "matched" or (seam["kind"] == "closed") == (
            seam["faces"][0] == seam["faces"][1]
        )
        for figure in FIGURES:
            if seam[figure] and seam[figure]["upper"] is not None:
                assert seam[figure]["lower"] <= seam[figure]["upper"]
        if seam["angle_deg"] and seam["angle_deg"]["lower"] > tolerance["crease_deg"]:
            assert seam["curvature_per_mm"] is None and seam["curvature_rel"] is None
        if seam["gap_mm"] is None:
            assert seam["level"] == "none" and seam["note"]
        elif seam["gap_mm"]["lower"] > tolerance["gap_mm"]:
            assert seam["level"] == "none"
        elif seam["angle_deg"] and seam["angle_deg"]["lower"] > tolerance["angle_deg"]:
            assert seam["level"] == "G0"
        if seam["certified"] and seam["class"] == "smooth":
            limits = {"G0": {"gap_mm": tolerance["gap_mm"]}}
            limits["G1"] = {**limits["G0"], "angle_deg": tolerance["angle_deg"]}
            limits["G2"] = limits["G3"] = {
                **limits["G1"],
                "curvature_rel": tolerance["curvature_rel"],
            }
            for figure, limit in limits[seam["level"]].items():
                assert seam[figure]["upper"] <= limit, (seam["id"], figure)


def check_report(path):
    report, status = analysis(path)
    strict(report)
    check_summary(report)
    check_seams(report)
    assert status == (0 if report["summary"]["defects"] == 0 else 1)
    assert report["model"]["path"] == str(path)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_reports_of_files_follow_the_schema(path):
    check_report(installed(path))


@pytest.mark.parametrize("name", TEXTS)
def test_reports_of_generated_models_follow_the_schema(tmp_path, name):
    path = tmp_path / "model.step"
    path.write_text(TEXTS[name])
    check_report(path)


def test_a_face_that_the_file_names_and_nobody_can_make_is_warned_of(tmp_path, box):
    broken = tmp_path / "lost.step"
    broken.write_text(box.read_text().replace("ADVANCED_FACE", "ADVANCED_FAXE", 1))
    report, status = analysis(broken)
    assert report["model"]["faces"] == 5 and report["summary"]["open_edges"] == 4
    assert any("6 faces, 1 of them" in note for note in report["model"]["notes"])


def test_box(box):
    report, status = analysis(box)
    strict(report)
    assert status == 0
    assert report["model"]["faces"] == 6 and report["model"]["edges"] == 12
    assert report["summary"]["creases"] == 12
    assert (
        sorted(round(seam["length_mm"], 9) for seam in report["seams"])
        == [10] * 4 + [20] * 4 + [30] * 4
    )
    for seam in report["seams"]:
        assert seam["angle_deg"]["lower"] == pytest.approx(90, abs=1e-9)
        assert (seam["level"], seam["class"], seam["kind"]) == ("G0", "crease", "shared")


def test_defaults_are_those_of_the_help(box):
    tolerance = analysis(box)[0]["tolerance"]
    expected = {
        "gap_mm": 0.01,
        "angle_deg": 0.1,
        "curvature_rel": 0.02,
        "flat_radius_mm": 100000,
        "crease_deg": 5,
    }
    assert {key: tolerance[key] for key in expected} == pytest.approx(expected, rel=1e-12)
    assert tolerance["level"] == "G1"


def test_options_arrive(box):
    tolerance = analysis(
        box,
        "--gap",
        "0.5",
        "--angle",
        "1.5",
        "--curvature",
        "0.25",
        "--flat-radius",
        "777",
        "--crease",
        "12",
        "--level",
        "G0",
    )[0]["tolerance"]
    expected = {
        "gap_mm": 0.5,
        "angle_deg": 1.5,
        "curvature_rel": 0.25,
        "flat_radius_mm": 777,
        "crease_deg": 12,
    }
    assert {key: tolerance[key] for key in expected} == pytest.approx(expected, rel=1e-12)
    assert tolerance["level"] == "G0"


PROFILES = {"default": (0.01, 0.1, 0.02), "class-a": (0.001, 0.01, 0.02), "vda": (0.02, 0.1, 0.1)}


@pytest.mark.parametrize("profile", PROFILES)
def test_a_profile_sets_what_is_accepted(box, profile):
    tolerance = analysis(box, "--profile", profile)[0]["tolerance"]
    expected = dict(
        zip(("gap_mm", "angle_deg", "curvature_rel"), PROFILES[profile]),
        flat_radius_mm=1e5,
        crease_deg=5,
    )
    assert {key: tolerance[key] for key in expected} == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    "options",
    [
        ["--profile", "vda", "--gap", "0.5", "--crease", "7"],
        ["--crease", "7", "--gap", "0.5", "--profile", "vda"],
    ],
)
def test_an_option_overrides_the_profile_in_any_order(box, options):
    tolerance = analysis(box, *options)[0]["tolerance"]
    expected = {
        "gap_mm": 0.5,
        "angle_deg": 0.1,
        "curvature_rel": 0.1,
        "flat_radius_mm": 1e5,
        "crease_deg": 7,
    }
    assert {key: tolerance[key] for key in expected} == pytest.approx(expected, rel=1e-12)


def test_the_profile_decides_the_status(tmp_path):
    path = roof(tmp_path, 0.05)
    assert analysis(path)[1] == 0 and analysis(path, "--profile", "class-a")[1] == 1


def test_help_says_what_a_profile_means():
    text = run("analyze", "--help").stdout
    for profile, (gap, angle, curvature) in PROFILES.items():
        line = next(line for line in text.splitlines() if line.startswith(f"  {profile} "))
        assert f"gap {gap:g} mm, angle {angle:g} deg, curvature {curvature:g}," in line


def test_level_g3_is_taken(box):
    report, status = analysis(box, "--level", "G3")
    strict(report)
    assert report["tolerance"]["level"] == "G3"
    assert status == 0, "the edges of a box are creases at any level"


def test_without_matching_open_edges_stay_open(tmp_path):
    report, _ = analysis(roof(tmp_path, 1), "--match", "0")
    assert report["summary"]["matched_seams"] == 0 and report["summary"]["open_edges"] == 6


def test_the_schema_knows_enclosures_and_the_worst_point(tmp_path):
    report, _ = analysis(roof(tmp_path, 1))
    seam = report["seams"][0]
    seam["worst"] = {"quantity": "angle", "at": 0.5, "point": [0.0, 5.0, 0.0]}
    seam["angle_deg"]["upper"] = 1.001
    seam["curvature_change_rel"] = {"lower": 0.1, "upper": None, "at": 1}
    strict(report)
    for worst in (
        {"quantity": "torsion", "at": 0.5, "point": [0, 5, 0]},
        {"quantity": "gap", "at": 2, "point": [0, 5, 0]},
        {"quantity": "gap", "at": 0.5, "point": [0, 5]},
        {"quantity": "gap", "at": 0.5},
    ):
        seam["worst"] = worst
        assert not VALIDATOR.is_valid(report), worst


@pytest.mark.parametrize(
    "angle,status,name",
    [
        (0, 0, "smooth"),
        (0.05, 0, "smooth"),
        (0.2, 1, "defect"),
        (4.9, 1, "defect"),
        (5.1, 0, "crease"),
        (60, 0, "crease"),
    ],
)
def test_status_and_class_follow_the_angle(tmp_path, angle, status, name):
    report, found = analysis(roof(tmp_path, angle))
    strict(report)
    assert len(report["seams"]) == 1 and report["summary"]["open_edges"] == 6
    assert report["seams"][0]["angle_deg"]["lower"] == pytest.approx(angle, abs=1e-6)
    assert (found, report["seams"][0]["class"]) == (status, name)


def test_level_and_tolerances_decide_the_status(tmp_path):
    path = roof(tmp_path, 0.2)
    assert analysis(path, "--level", "G0")[1] == 0
    assert analysis(path, "--angle", "0.3")[1] == 0
    assert analysis(path, "--crease", "0.15")[1] == 0
    assert analysis(path, "--level", "G2")[1] == 1


def csv_rows(*arguments):
    result = run("analyze", "--format", "csv", *arguments)
    assert all(line.startswith("seamwright: warning: ") for line in result.stderr.splitlines())
    return list(csv.DictReader(io.StringIO(result.stdout)))


def number(text):
    return float(text) if text else None


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_csv_says_what_json_says(path):
    report, _ = analysis(installed(path))
    rows = csv_rows(path)
    assert len(rows) == len(report["seams"])
    for row, seam in zip(rows, report["seams"]):
        assert int(row["seam"]) == seam["id"]
        assert [int(row["face_a"]), int(row["face_b"])] == seam["faces"]
        assert [int(edge) for edge in row["edges"].split()] == seam["edges"]
        assert (row["kind"], row["level"], row["class"], row["note"]) == (
            seam["kind"],
            seam["level"],
            seam["class"],
            seam["note"],
        )
        assert float(row["length_mm"]) == seam["length_mm"]
        assert row["certified"] == ("true" if seam["certified"] else "false")
        for figure in FIGURES:
            expected = seam[figure] or {"lower": None, "upper": None, "at": None}
            assert {part: number(row[f"{figure}_{part}"]) for part in expected} == expected
        worst = seam["worst"] or {"quantity": "", "at": None, "point": [None] * 3}
        assert (row["worst"], number(row["worst_at"])) == (worst["quantity"], worst["at"])
        assert [number(row[f"worst_{axis}_mm"]) for axis in "xyz"] == worst["point"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_table_says_what_json_says(path):
    report, status = analysis(installed(path))
    result = run("analyze", path)
    assert result.returncode == status
    text = result.stdout
    summary = report["summary"]
    assert (
        f"{summary['seams']} seams: {summary['defects']} defects, {summary['smooth']} smooth, "
        f"{summary['creases']} creases" in text
    )
    assert ("PASSED" in text) == (status == 0 and summary["seams"] > 0)
    assert ("NO VERDICT" in text) == (summary["seams"] == 0)
    assert ("FAILED" in text) == (status == 1)
    certain = summary["seams"] - summary["uncertified"]
    assert (
        not summary["seams"] or f"{certain} of {summary['seams']} verdict" in text.splitlines()[-1]
    )
    rows = [
        line.split()
        for line in text.splitlines()
        if line.split()[:1] and line.split()[0].rstrip("?") in ("smooth", "defect", "crease")
    ]
    edges = {",".join(f"Edge{edge}" for edge in seam["edges"]): seam for seam in report["seams"]}
    assert sorted(row[:5] for row in rows) == sorted(
        [
            seam["class"] + ("" if seam["certified"] else "?"),
            seam["level"],
            name,
            "{}-{}".format(*seam["faces"]),
            seam["kind"],
        ]
        for name, seam in edges.items()
    )
    for row in rows:
        seam = edges[row[2]]
        assert float(row[5]) == pytest.approx(seam["length_mm"], abs=5.1e-4)
        for cell, figure, factor in zip(
            row[6:9], ("gap_mm", "angle_deg", "curvature_rel"), (1, 1, 100)
        ):
            if seam[figure] is None:
                assert cell == "-"
                continue
            lower, upper = said(cell)
            bound = math.inf if seam[figure]["upper"] is None else seam[figure]["upper"]
            true = [factor * value for value in (seam[figure]["lower"], bound)]
            assert lower <= 1.06 * true[0] and 1.06 * upper >= true[1], (cell, seam[figure])


def said(cell):
    """The range of values that a cell of the table speaks of."""
    if cell.startswith("\N{LESS-THAN OR EQUAL TO}"):
        return 0, float(cell[1:])
    if cell.startswith("\N{GREATER-THAN OR EQUAL TO}"):
        return float(cell[1:]), math.inf
    lower, _, upper = cell.partition("..")
    return float(lower), float(upper or lower)


def test_several_models_in_one_call(tmp_path, box):
    bad = roof(tmp_path, 0.2)
    result = run("analyze", "--format", "json", box, bad, box)
    assert result.returncode == 1, "one model with a defect is enough"
    reports = [json.loads(line) for line in result.stdout.splitlines()]
    assert [report["model"]["path"] for report in reports] == [str(box), str(bad), str(box)]
    for report in reports:
        strict(report)
    rows = csv_rows(box, bad)
    assert [row["model"] for row in rows] == [str(box)] * 12 + [str(bad)]
    table = run("analyze", box, bad).stdout
    assert table.count("PASSED") == 1 and table.count("FAILED") == 1


def test_csv_quotes_what_needs_it(tmp_path):
    path = tmp_path / 'a "b", c.step'
    path.write_text(box_text())
    assert {row["model"] for row in csv_rows(path)} == {str(path)}


def test_names_of_files_may_hold_any_letter(tmp_path):
    path = tmp_path / "Näht Ω 缝.step"
    path.write_text(box_text())
    assert analysis(path)[0]["model"]["path"] == str(path)


@pytest.mark.parametrize(
    "path",
    [*FILES, OCCT_DATA / "occ/CrankArm.brep", BROKEN / "loop_off_its_torus.stp"],
    ids=lambda path: path.name,
)
def test_verdicts_alone_are_those_of_all_figures(path):
    full, status = analysis(installed(path), "--level", "G2")
    quick, quick_status = analysis(installed(path), "--level", "G2", "--verdict-only")
    assert quick_status == status
    for seam, other in zip(full["seams"], quick["seams"], strict=True):
        for key in ("level", "class", "certified", "left_out"):
            assert other[key] == seam[key]
        if any(seam["left_out"].values()):
            assert [other[figure] for figure in FIGURES] == [seam[figure] for figure in FIGURES]
        for figure in FIGURES:
            assert (other[figure] is None) == (seam[figure] is None)
            if not seam[figure] or seam[figure]["upper"] is None:
                continue
            # Both enclose the same number.
            assert other[figure]["lower"] <= seam[figure]["upper"]
            assert other[figure]["upper"] is None or other[figure]["upper"] >= seam[figure]["lower"]


def test_jobs_change_nothing():
    path = installed(OCCT_DATA / "step/linkrods.step")
    reports = []
    for jobs in (1, 2, 8):
        report, _ = analysis(path, "--jobs", str(jobs))
        del report["time_s"]
        reports.append(report)
    assert reports[0] == reports[1] == reports[2]


def test_the_schema_notices_a_missing_key_a_wrong_type_and_a_foreign_key(tmp_path):
    report, _ = analysis(roof(tmp_path, 1))
    expect_every_key_matters(report, VALIDATOR)
