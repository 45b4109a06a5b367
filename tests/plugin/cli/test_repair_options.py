# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of repair: what they treat, move and allow."""

import re

import pytest

from command import run
from models import OCCT_DATA, installed, roof_text
from patches import surfaces_of, worst_figures
from repairs import analysis, expect_same_verdicts, repair, sheet


def test_planes_stay_and_the_reason_says_so(tmp_path):
    model = tmp_path / "roof.step"
    model.write_text(roof_text(1))
    result, report, _ = repair(model)
    assert result.returncode == 1
    (seam,) = report["seams"]
    assert not seam["treated"] and "plane" in seam["reason"]
    assert seam["reason_code"] == "face_without_poles"
    assert (
        seam["wants_conversion"]
        and report["summary"]["wants_conversion"] == 1
        and "--convert lets such faces" in result.stdout
    )


def test_planes_move_where_asked(tmp_path):
    model = tmp_path / "roof.step"
    model.write_text(roof_text(1))
    result, report, out = repair(model, "--convert", "--max-move", "inf")
    assert report["options"]["convert_analytic"] and report["converted"]
    assert result.returncode == 0 and report["summary"]["repaired"] == 1
    assert report["summary"]["wants_conversion"] == 0
    expect_same_verdicts(report, out)


def test_options_arrive(tmp_path):
    model = sheet(tmp_path, count_x=3)
    first, second = (seam["edges"][0] for seam in analysis(model)["seams"])
    _, report, _ = repair(
        model,
        "--target",
        "G2",
        "--max-move",
        "0.25",
        "--edges",
        f"{second},{first}",
        "--fix",
        "1,3",
        "--match",
        "0.05",
        "--no-sew",
        "--jobs",
        "1",
        "--gap",
        "0.02",
        "--angle",
        "0.05",
        "--curvature",
        "0.1",
        "--flat-radius",
        "5000",
        "--crease",
        "7",
    )
    assert report["options"] == {
        "target": "G2",
        "max_move_mm": 0.25,
        "edges": [second, first],
        "fixed_faces": [1, 3],
        "match_mm": 0.05,
        "sew": False,
        "convert_analytic": False,
        "fairness": 1.5,
        "keep_curvature": False,
        "max_time_s": None,
    }
    tolerance = {
        "gap_mm": 0.02,
        "angle_deg": 0.05,
        "curvature_rel": 0.1,
        "flat_radius_mm": 5000,
        "crease_deg": 7,
    }
    assert {key: report["tolerance"][key] for key in tolerance} == pytest.approx(
        tolerance, rel=1e-12
    )
    assert [move["face"] for move in report["moves"]] == [2]


def test_lists_may_have_blanks(tmp_path):
    model = sheet(tmp_path, count_x=3)
    first, second = (seam["edges"][0] for seam in analysis(model)["seams"])
    _, report, _ = repair(model, "--edges", f" {second}, Edge{first} ", "--fix", "1 ,\t3")
    assert report["options"]["edges"] == [second, first] and report["options"]["fixed_faces"] == [
        1,
        3,
    ]
    result = run("repair", model, "-o", tmp_path / "o.step", "--edges", "1, 2 3")
    assert result.returncode == 2 and "invalid Edge number '2 3'" in result.stderr


def test_each_command_says_its_exit_status():
    expected = {
        "analyze": "0 all seams meet the level",
        "repair": "0 all seams of the result meet the target",
        "fill": "0 the new seams meet the target",
        "corner": "0 the new seams meet the tolerances",
    }
    for command, meaning in expected.items():
        text = run(command, "--help").stdout
        assert text.count("Exit status:") == 1 and f"Exit status: {meaning}" in text


def test_repair_ends_in_time(tmp_path):
    result, report, _ = repair(sheet(tmp_path), "--max-time", "1e-6")
    assert (
        result.returncode == 1
        and not report["summary"]["changed"]
        and report["options"]["max_time_s"] == 1e-6
    )
    assert {seam["reason"] for seam in report["seams"] if seam["treated"]} == {
        "the time limit was reached first"
    }


def test_defaults_are_those_of_the_help(tmp_path):
    _, report, _ = repair(sheet(tmp_path))
    assert report["options"] == {
        "target": "G1",
        "max_move_mm": "auto",
        "edges": [],
        "fixed_faces": [],
        "match_mm": 0,
        "sew": True,
        "convert_analytic": False,
        "fairness": 1.5,
        "keep_curvature": False,
        "max_time_s": None,
    }
    expected = {
        "gap_mm": 0.01,
        "angle_deg": 0.1,
        "curvature_rel": 0.02,
        "flat_radius_mm": 100000,
        "crease_deg": 5,
    }
    assert {key: report["tolerance"][key] for key in expected} == pytest.approx(expected, rel=1e-12)
    assert re.search(r"--max-move MM +No point", run("repair", "--help").stdout)
    _, report, _ = repair(sheet(tmp_path), "--max-move", "inf", "--profile", "class-a")
    assert report["options"]["max_move_mm"] is None and report["tolerance"]["gap_mm"] == 0.001


def test_only_the_edges_named_are_treated(tmp_path):
    model = sheet(tmp_path, count_x=3)
    first, second = (seam["edges"][0] for seam in analysis(model)["seams"])
    result, report, out = repair(model, "--edges", second)
    assert result.returncode == 1, "the other one is a defect still"
    treated = [seam["before"]["edges"] for seam in report["seams"] if seam["treated"]]
    assert treated == [[second]]
    result, report, _ = repair(out, "--edges", f"{first}", out=tmp_path / "again.step")
    assert result.returncode == 0
    assert (
        repair(out, "--edges", second, out=tmp_path / "again.step")[1]["seams"][1]["reason"]
        == "it already reaches the target"
    )


def test_a_crease_is_no_defect_unless_the_user_says_so(tmp_path):
    model = sheet(tmp_path)
    result, report, _ = repair(model, "--angle", "0.01", "--crease", "0.02")
    assert result.returncode == 0 and report["summary"]["treated"] == 0
    assert report["seams"][0]["before"]["class"] == "crease"


@pytest.mark.parametrize("options,kind,edges", [((), "shared", 7), (("--no-sew",), "matched", 8)])
def test_open_edges_are_matched_and_sewn(tmp_path, options, kind, edges):
    model = sheet(tmp_path, shared=False)
    assert repair(model)[1]["seams"] == []
    result, report, out = repair(model, "--match", "0.1", *options)
    assert result.returncode == 0
    (seam,) = report["seams"]
    assert (
        seam["repaired"] and seam["before"]["kind"] == "matched" and seam["after"]["kind"] == kind
    )
    assert worst_figures(surfaces_of(out.read_text()))[1] <= 0.1
    assert expect_same_verdicts(report, out, "--match", "0.1")["model"]["edges"] == edges
    assert ("repaired, sewn" in result.stdout) == (kind == "shared")


def test_jobs_change_nothing(tmp_path):
    model, reports, written = sheet(tmp_path, count_x=3, count_y=2), [], []
    for jobs in (1, 3):
        _, report, out = repair(model, "--jobs", jobs)
        del report["time_s"]
        reports.append(report)
        written.append(surfaces_of(out.read_text()))
    assert reports[0] == reports[1] and written[0] == written[1]


def test_conditions_that_depend_on_each_other(tmp_path):
    """Tight tolerances treat so much that conditions of whole nets depend on each other."""
    _, report, _ = repair(
        installed(OCCT_DATA / "occ/shell1.brep"), "--angle", "0.05", out=tmp_path / "out.brep"
    )
    assert report["summary"]["repaired"] > 100
