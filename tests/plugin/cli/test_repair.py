# SPDX-License-Identifier: LGPL-2.1-or-later
"""What repair writes: the model, the table and the JSON, and that they say the same."""

import json
import os
import re
import subprocess
import sys

import pytest

from command import PROGRAM, READER, run
from models import OCCT_DATA, box_text, installed, reader_that_finds, roof_text
from patches import sheet_text, surfaces_of, worst_figures
from schemas import expect_every_key_matters, expect_valid, schema, validator

VALIDATOR = validator("repair")


def sheet(folder, name="sheet.step", **how):
    path = folder / name
    path.write_text(sheet_text(**how))
    return path


def repair(model, *options, out=None):
    """Exit status, report and the written model."""
    out = out or model.parent / "out.step"
    json_file = out.parent / (out.name + ".json")
    result = run("repair", model, "-o", out, "--json", json_file, "--overwrite", *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(json_file.read_text())
    expect_valid(report, VALIDATOR)
    check_laws(report, result.returncode)
    return result, report, out


def analysis(path, *options):
    return json.loads(run("analyze", "--format", "json", *options, path).stdout)


def check_laws(report, status):
    seams, summary = report["seams"], report["summary"]
    assert summary["seams"] == len(seams)
    assert summary["treated"] == sum(seam["treated"] for seam in seams)
    assert summary["repaired"] == sum(seam["repaired"] for seam in seams)
    assert summary["left"] == summary["treated"] - summary["repaired"]
    for key in ("before", "after"):
        assert summary[f"defects_{key}"] == sum(seam[key]["class"] == "defect" for seam in seams)
    assert status == (1 if summary["defects_after"] or report["output"]["defects"] else 0)
    assert summary["sewn"] == sum(seam["sewn"] for seam in seams)
    assert summary["passed"] == (status == 0)
    levels = ["none", "G0", "G1", "G2", "G3"]
    lost = [
        seam
        for seam in seams
        if levels.index(seam["after"]["level"]) < levels.index(seam["before"]["level"])
    ]
    assert summary["lowered"] == sum(not seam["treated"] and not seam["sewn"] for seam in lost)
    assert summary["changed"] == bool(report["moves"] or report["edge_moves"] or summary["sewn"])
    assert (report["numbers_now"] is not None) == bool(summary["sewn"])
    assert summary["largest_move_mm"] == max(
        (move["largest_move_mm"] for move in report["moves"]), default=0
    )
    limit = report["options"]["max_move_mm"]
    assert limit in (None, "auto") or summary["largest_move_mm"] <= limit
    assert not {move["face"] for move in report["moves"]} & set(report["options"]["fixed_faces"])
    assert report["tolerance"]["level"] == report["options"]["target"]
    for seam in seams:
        check_seam(seam, report)


def check_seam(seam, report):
    before, after, tolerance, now = (
        seam["before"],
        seam["after"],
        report["tolerance"],
        report["numbers_now"],
    )
    assert before["id"] == after["id"]
    if now is None:
        assert (before["edges"], before["faces"]) == (after["edges"], after["faces"])
    else:
        assert {now["faces"][face - 1] for face in before["faces"]} == set(after["faces"])
        assert set(after["edges"]) <= {
            number for edge in before["edges"] for number in now["edges"][edge - 1]
        }
    assert seam["sewn"] == (before["kind"] == "matched" != after["kind"]) and not (
        seam["sewn"] and seam["not_sewn"]
    )
    assert (seam["not_sewn"] == "") == (seam["not_sewn_code"] == "")
    if seam["treated"]:
        assert seam["repaired"] == (seam["reason"] == "")
        assert (seam["reason"] == "") == (seam["reason_code"] == "")
    else:
        assert not seam["repaired"]
    if seam["repaired"]:
        # Where the gap alone was at fault, closing it leaves a crease.
        assert after["class"] in ("smooth", "crease") and after["certified"]
        if after["class"] == "crease":
            assert (
                before["gap_mm"]["upper"]
                > report["tolerance"]["gap_mm"]
                >= after["gap_mm"]["upper"]
            )
            return
        limits = ["gap_mm", "angle_deg"] + ["curvature_rel"] * (report["options"]["target"] == "G2")
        assert all(after[figure]["upper"] <= tolerance[figure] for figure in limits)


def expect_same_verdicts(report, out, *options):
    """analyze finds in the written model what the report says of it, the seams in any order."""

    def verdicts(seams):
        return sorted(
            (seam["faces"], seam["edges"], seam["level"], seam["class"], seam["certified"])
            for seam in seams
        )

    found = analysis(out, "--level", report["options"]["target"], *options)
    assert verdicts(found["seams"]) == verdicts([seam["after"] for seam in report["seams"]])
    return found


@pytest.mark.parametrize("target", ["G1", "G2"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_sheet_flows_again(tmp_path, target, seed):
    model = sheet(tmp_path, count_x=2, count_y=2, seed=seed)
    before = worst_figures(surfaces_of(model.read_text()))
    result, report, out = repair(model, "--target", target)
    assert result.returncode == 0 and result.stderr == ""
    assert before[1] > 0.1 and report["summary"]["repaired"] > 1
    assert max(seam["before"]["angle_deg"]["upper"] for seam in report["seams"]) == pytest.approx(
        before[1], rel=1e-3
    )
    gap_mm, angle_deg = worst_figures(surfaces_of(out.read_text()))
    assert gap_mm <= 1e-9 and angle_deg <= 0.1
    assert angle_deg <= max(seam["after"]["angle_deg"]["upper"] for seam in report["seams"]) + 1e-6
    expect_same_verdicts(report, out)
    assert report["output"] == {
        "path": str(out),
        "format": "STEP",
        "edges": 12,
        "faces": 4,
        "open_edges": 8,
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }


def test_the_schema_notices_a_missing_key_a_wrong_type_and_a_foreign_key(tmp_path):
    _, report, _ = repair(sheet(tmp_path, shared=False), "--match", "0.1")
    expect_every_key_matters(report, VALIDATOR)


def test_what_both_schemas_describe_is_the_same():
    analyzed, repaired = schema("analysis"), schema("repair")["$defs"]
    parts = {
        **analyzed["$defs"],
        **{key: analyzed["properties"][key] for key in ("generator", "model", "tolerance")},
    }
    assert {key: repaired[key] for key in parts} == parts


@pytest.mark.parametrize("make", [lambda: sheet_text(noise_mm=0), box_text, lambda: roof_text(30)])
def test_what_has_no_defect_is_written_as_it_was(tmp_path, make):
    model = tmp_path / "model.step"
    model.write_text(make())
    result, report, out = repair(model)
    assert result.returncode == 0
    assert not report["summary"]["changed"] and report["summary"]["treated"] == 0
    assert "nothing moved" in result.stdout
    assert surfaces_of(out.read_text()) == surfaces_of(model.read_text()), "number by number"
    for seam, again in zip(report["seams"], expect_same_verdicts(report, out)["seams"]):
        assert again == seam["before"] == seam["after"]


@pytest.mark.parametrize("name", ["box.step", "sheet.brep", "sheet.bin", "sheet.igs"])
def test_what_has_no_defect_comes_back_byte_for_byte(tmp_path, name):
    model = tmp_path / name
    if name == "box.step":
        model.write_text(box_text())
    else:
        repair(sheet(tmp_path), out=model)
    result, report, out = repair(model, out=tmp_path / ("out" + model.suffix))
    assert result.returncode == 0 and not report["summary"]["changed"]
    assert out.read_bytes() == model.read_bytes()
    assert report["output"]["defects"] == 0
    # Another format is written again.
    other = repair(model, out=tmp_path / ("other.brep" if name == "box.step" else "other.step"))[2]
    assert len(analysis(other)["seams"]) == len(report["seams"])


def test_the_verdict_is_on_the_file_too(tmp_path):
    model, other, out = (
        sheet(tmp_path),
        sheet(tmp_path, "other.step", count_x=3),
        tmp_path / "out.step",
    )
    found = analysis(other)
    result = run(
        "repair",
        model,
        "-o",
        out,
        "--json",
        tmp_path / "out.json",
        reader=reader_that_finds(other, tmp_path, READER),
    )
    assert result.returncode == 1, result.stderr
    report = json.loads((tmp_path / "out.json").read_text())
    expect_valid(report, VALIDATOR)
    assert report["summary"]["defects_after"] == 0
    assert report["output"] == {
        "path": str(out),
        "format": "STEP",
        "edges": 10,
        "faces": 3,
        "open_edges": 8,
        "defects": 2,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert (found["model"]["edges"], found["model"]["faces"]) == (10, 3)
    line = (
        "read back: 2 defects, 3 faces, 10 edges, 8 free edges, 2 seams; the model in memory has "
        "0, 2, 7, 6, 1: "
        "numbers of faces and edges differ"
    )
    assert result.stdout.endswith(f"\n{out} {line}\nFAILED: 2 defects at level G1\n")
    assert result.stderr == f"seamwright: warning: {out}: {line}\n"
    assert analysis(out)["summary"]["defects"] == 0, "the model itself is written"


def test_what_cannot_be_read_back_is_not_written(tmp_path):
    model, reader = sheet(tmp_path), reader_that_finds(tmp_path / "none.step", tmp_path, READER)
    before = sorted(tmp_path.iterdir())
    result = run(
        "repair", model, "-o", tmp_path / "out.step", "--json", tmp_path / "out.json", reader=reader
    )
    assert result.returncode == 2 and result.stdout == ""
    assert "out.step: can't be read back" in result.stderr and result.stderr.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("file,most_defects", [("bottle.brep", 0), ("hammer.brep", 4)])
def test_step_of_loose_tolerances_keeps_the_verdict(tmp_path, file, most_defects):
    """Vertices of these stand off their edges; a reader that is not told so bends the curves to
    them."""
    model = tmp_path / file
    model.write_bytes(installed(OCCT_DATA / "occ" / file).read_bytes())
    result, report, _ = repair(model)
    assert report["output"]["defects"] == report["summary"]["defects_after"] <= most_defects
    assert "read back" not in result.stdout and result.stderr == ""


def test_what_cannot_be_repaired_is_written_as_it_was(tmp_path):
    model = sheet(tmp_path)
    result, report, out = repair(model, "--max-move", "1e-6")
    assert result.returncode == 1
    assert report["summary"]["left"] == 1 and not report["summary"]["changed"]
    assert surfaces_of(out.read_text()) == surfaces_of(model.read_text())
    assert "mm" in report["seams"][0]["reason"]


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
        and "with --convert" in result.stdout
    )


def test_planes_move_where_told(tmp_path):
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


def test_the_report_goes_to_pipes(tmp_path):
    model = sheet(tmp_path)
    result = run("repair", model, "-o", tmp_path / "o.step", "--json", "/dev/stdout")
    report, table = result.stdout.split("\n", 1)
    assert json.loads(report)["schema"] == "seamwright.repair/1" and "defects" in table


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
        == "it has the level already"
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


@pytest.mark.parametrize(
    "name,format",
    [
        ("a.step", "STEP"),
        ("a.STP", "STEP"),
        ("a.igs", "IGES"),
        ("a.brep", "BREP"),
        ("a.bin", "binary BREP"),
    ],
)
def test_the_name_of_the_output_tells_its_format(tmp_path, name, format):
    result, report, out = repair(sheet(tmp_path, count_y=2), out=tmp_path / name)
    assert result.returncode == 0
    found = analysis(out)
    facts = {key: found["model"][key] for key in ("edges", "faces")}
    assert report["output"] == {
        "path": str(out),
        "format": format,
        **facts,
        "open_edges": found["summary"]["open_edges"],
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert found["model"]["format"] == format and found["model"]["faces"] == 4
    # Other formats may number edges otherwise.
    levels = sorted((seam["faces"], seam["level"], seam["class"]) for seam in found["seams"])
    assert levels == sorted(
        (seam["after"]["faces"], seam["after"]["level"], seam["after"]["class"])
        for seam in report["seams"]
    )


def table_rows(text):
    """The rows below the headings: result, edges, faces and level."""
    lines = text.splitlines()
    start = next((k for k, line in enumerate(lines) if line.startswith("result")), None)
    if start is None:
        return []
    at = [lines[start].index(title) for title in ("result", "edge", "faces", "level", "gap mm")]
    rows = []
    for line in lines[start + 1 : lines.index("", start)]:
        cells = [line[a:b].strip() for a, b in zip(at, at[1:])]
        words = cells[3].split()
        cells[3] = " ".join(words[: 3 if words[1:2] == ["->"] else 1])
        rows.append(tuple(cells))
    return rows


@pytest.mark.parametrize(
    "options",
    [(), ("--fix", "1,2"), ("--target", "G2", "--max-move", "0.001"), ("--max-move", "0.012")],
)
def test_the_table_says_what_json_says(tmp_path, options):
    result, report, _ = repair(sheet(tmp_path, count_x=3), *options)
    text, summary = result.stdout, report["summary"]
    assert (
        f"{summary['seams']} seams: {summary['treated']} treated, {summary['repaired']} repaired, "
        f"{summary['left']} left;"
        in text
    )
    assert (
        f"{summary['defects_before']} defect" in text
        and f"before, {summary['defects_after']} after" in text
    )
    if summary["changed"]:
        assert f"moved, by at most {summary['largest_move_mm']:.3g} mm" in text
    assert ("PASSED" in text) == (result.returncode == 0) == ("FAILED" not in text)

    def row(seam):
        verdict = "repaired" if seam["repaired"] else "left" if seam["treated"] else "not treated"
        levels = seam["before"]["level"], seam["after"]["level"]
        return (
            verdict,
            ",".join(f"Edge{edge}" for edge in seam["before"]["edges"]),
            "{}-{}".format(*seam["before"]["faces"]),
            " -> ".join(dict.fromkeys(levels)),
        )

    shown = [seam for seam in report["seams"] if seam["treated"] or seam["reason"]]
    assert sorted(table_rows(text)) == sorted(map(row, shown))
    assert all(seam["reason"] in text for seam in shown)


def test_standard_output_says_the_same_without_json(tmp_path):
    model = sheet(tmp_path)
    shown, _, _ = repair(model)
    again = run("repair", model, "-o", tmp_path / "other.step")
    assert again.returncode == shown.returncode
    strip = [
        [line for line in text.splitlines() if "read in" not in line]
        for text in (shown.stdout, again.stdout)
    ]
    assert strip[0] == strip[1]
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "other.step",
        "out.step",
        "out.step.json",
        "sheet.step",
    ]


def test_jobs_change_nothing(tmp_path):
    model, reports, written = sheet(tmp_path, count_x=3, count_y=2), [], []
    for jobs in (1, 3):
        _, report, out = repair(model, "--jobs", jobs)
        del report["time_s"]
        reports.append(report)
        written.append(surfaces_of(out.read_text()))
    assert reports[0] == reports[1] and written[0] == written[1]


@pytest.mark.parametrize(
    "path, treated, least_repaired, largest_move_mm",
    [
        (OCCT_DATA / "occ/shell1.brep", 102, 98, 0.05),
        (OCCT_DATA / "step/linkrods.step", 16, 16, 0.2),
    ],
    ids=["shell1", "linkrods"],
)
def test_defects_of_real_models(tmp_path, path, treated, least_repaired, largest_move_mm):
    """What is left of shell1 would make a face less fair."""
    _, report, out = repair(installed(path), out=tmp_path / "out.brep")
    assert report["summary"]["treated"] == treated
    assert report["summary"]["repaired"] >= least_repaired, report["summary"]
    assert report["summary"]["worse_faces"] == 0
    assert report["summary"]["largest_move_mm"] <= largest_move_mm
    expect_same_verdicts(report, out)


def test_edges_that_reading_adds_are_named(tmp_path):
    """Vertices of linkrods stand off their paths: the reader bridges the ends with edges that are
    in no seam."""
    result, report, out = repair(
        installed(OCCT_DATA / "step/linkrods.step"), out=tmp_path / "out.step"
    )
    in_memory = 108
    assert out.read_text().count("EDGE_CURVE(") == in_memory
    found = analysis(out)
    added = sorted(
        set(range(1, found["model"]["edges"] + 1))
        - {edge for seam in found["seams"] for edge in seam["edges"]}
    )
    assert report["output"]["edges"] == found["model"]["edges"] == in_memory + len(added)
    if not added:
        assert "read back" not in result.stderr
        return
    count = (
        "1 edge without length was"
        if len(added) == 1
        else f"{len(added)} edges without length were"
    )
    assert result.stderr == (
        f"seamwright: warning: {out}: read back: {in_memory + len(added)} edges; the model in "
        "memory has "
        f"{in_memory}: {count} added by reading; numbers of edges differ from Edge{added[0]} on\n"
    )


def largest_memory_kb(*arguments):
    """Of the command that ran, without the process that reads files."""
    with open(os.devnull, "w") as nowhere:
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=nowhere, stderr=nowhere)
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode in (0, 1)
    return usage.ru_maxrss


@pytest.mark.skipif(sys.platform != "linux", reason="peaks of memory are in kB on Linux alone")
def test_memory_stays_small(tmp_path):
    """102 seams between 99 faces, all of them repaired: no more than half of what the analysis
    takes is added."""
    path = installed(OCCT_DATA / "occ/shell1.brep")
    analysed = largest_memory_kb("analyze", path, "--jobs", 2)
    repaired = largest_memory_kb("repair", path, "-o", tmp_path / "out.brep", "--jobs", 2)
    assert repaired <= 1.5 * analysed, (analysed, repaired)


@pytest.mark.parametrize("name", ["step/screw.step", "occ/CrankArm.brep"])
def test_the_source_stays_and_the_file_has_the_verdicts_told(tmp_path, name):
    path = installed(OCCT_DATA / name)
    model = tmp_path / path.name
    model.write_bytes(path.read_bytes())
    content = model.read_bytes()
    _, report, out = repair(model, out=tmp_path / ("out" + path.suffix))
    assert model.read_bytes() == content
    expect_same_verdicts(report, out)


def test_conditions_that_depend_on_each_other(tmp_path):
    """Tight tolerances treat so much that conditions of whole nets depend on each other."""
    _, report, _ = repair(
        installed(OCCT_DATA / "occ/shell1.brep"), "--angle", "0.05", out=tmp_path / "out.brep"
    )
    assert report["summary"]["repaired"] > 100
