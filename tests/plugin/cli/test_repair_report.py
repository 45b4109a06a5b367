# SPDX-License-Identifier: LGPL-2.1-or-later
"""The JSON and the table of repair, and that they say the same."""

import json

import pytest

from command import run
from repairs import VALIDATOR, repair, sheet
from schemas import expect_every_key_matters, schema


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


def test_the_report_goes_to_pipes(tmp_path):
    model = sheet(tmp_path)
    result = run("repair", model, "-o", tmp_path / "o.step", "--json", "/dev/stdout")
    report, table = result.stdout.split("\n", 1)
    assert json.loads(report)["schema"] == "seamwright.repair/1" and "defects" in table


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
