# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every repair by the command promises, for the tests of it."""

import json

from command import run
from patches import sheet_text
from schemas import expect_valid, validator

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
