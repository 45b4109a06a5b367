# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve: what it reads, says and refuses, and how it is stopped."""

import json
import math
import random
import signal
import subprocess
import time

import pytest

from command import PROGRAM, contents, expect_one_line, run
from curves import METHODS, WAVE, curve, points_file, rows_of


def test_files_of_points_have_many_forms(tmp_path):
    forms = {
        "a.csv": "x,y\n# by hand\n0,0\n1,2 # digitised\n\n3,3\n",
        "b.dat": "NACA 0012\n 0.0  0.0\n 1.0\t2.0\n 3.0  3.0\n",
        "c.txt": "0;0\r\n1;2\r\n3;3\r\n",
        "d.xyz": "0,0,7\n+1,2e0,7\n3,3,7\n",
        "e.csv": "x,y\r0,0\r1,2\r\r3,3\r",
        "f.csv": '"x","y"\n"0","0"\n"1","2"\n"3","3"\n',
    }
    reports = []
    for name, text in forms.items():
        (tmp_path / name).write_bytes(text.encode())
        reports.append(curve("arcs", tmp_path / name)[1]["curves"][0])
    assert len({json.dumps([r["after"], r["pieces"]]) for r in reports}) == 1
    assert reports[3]["plane"]["origin"] == [0, 0, 7]


@pytest.mark.parametrize(
    "name, data",
    [
        ("mark.csv", b"\xef\xbb\xbf4,0\n2,0.5\n0,0\n2,-0.5\n4,-0.25\n"),
        ("comma.csv", b"4;0\n2;0,5\n0;0\n2;-0,5\n4;-0,25\n"),
        ("lednicer.dat", b"Foil\n 3.0 3.0\n\n0 0\n2 .5\n4 0\n\n0 0\n2 -.5\n4 -.25\n"),
    ],
)
def test_points_of_spreadsheets_and_airfoils(tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    rows = rows_of(curve("fair", tmp_path / name, "--tolerance", "0", out="out.csv")[2])
    points = [(float(row["x"]), float(row["y"])) for row in rows]
    assert points == [(4, 0), (2, 0.5), (0, 0), (2, -0.5), (4, -0.25)]


@pytest.mark.parametrize(
    "text, options, message",
    [
        ("", [], "has no points"),
        ("x,y\n# nothing\n", [], "has no points"),
        ("1,2\n", [], "has 1 point: a curve needs at least 2"),
        ("1,2\n3,4\n", ["--closed"], "has 2 points: a closed curve needs at least 3"),
        ("0,0\n1,1\n1,1\n2,0\n", [], "the points of lines 2 and 3 are equal"),
        ("0,0\n1,nan\n", [], "line 2 has the number nan, which is not finite"),
        ("0,0\n1,inf\n", [], "line 2 has the number inf, which is not finite"),
        ("0,0\n1,1e999\n", [], "line 2 has the number 1e999, which is not finite"),
        ("0,0\n5,0\n2,0\n", [], "turn back by 180 degrees at line 2"),
        ("0,0\n1,one\n", [], "line 2 has 'one' where a number is needed"),
        ("0,0\n1,1\nend of file\n", [], "line 3 has 'end' where a number is needed"),
        ("1.2.3,0\n1,1\n2,0\n", [], "line 1 has '1.2.3' where a number is needed"),
        ("x,y\n0x10,0\n1,1\n2,0\n", [], "line 2 has '0x10' where a number is needed"),
        ("0,0x10\n1,1\n2,0\n", [], "line 1 has '0x10' where a number is needed"),
        ("1.234,5;2,0\n1;1\n2;0\n", [], "line 1 has '1.234.5' where a number is needed"),
        ('"1,234","5"\n1,1\n2,0\n', [], "line 1 has '1,234' where a number is needed"),
        ("nan,0\n1,1\n2,0\n", [], "line 1 has the number nan, which is not finite"),
        ("0,0\n1,1,1\n", [], "line 2 has 3 numbers, line 1 has 2"),
        ("1\n", [], "line 1 has 1 number: 2 or 3 are needed"),
        ("0,0,0\n9,0,0\n9,9,0\n0,9,3\n", [], "are not in a plane: that of line "),
        ("tolerance,x,y\n1,0,0\n", [], "line 1 names a column of tolerances, which must follow"),
        ("x,y,tolerance\n0,0\n1,2,-1\n", [], "line 3 has the tolerance -1 mm: it must be"),
        ("x [mm],half breadth,Tolerance [mm]\n0,0\n1,2,-1\n", [], "line 3 has the tolerance -1 mm"),
        ("a x;a y;tol\n0;0\n1;2;-1\n", [], "line 3 has the tolerance -1 mm"),
        ("x,y,tolerance\n0,0\n1,2,nan\n", [], "line 3 has the tolerance nan mm: it must"),
        ("x,y,tolerance\n0,0\n1,2,inf\n", [], "line 3 has the tolerance inf mm: it must"),
        ("x,y,tolerance\n0,0\n1,,2\n", [], "line 3 has an empty entry"),
        ("x;y;tolerance\n0;0\n1; ;2\n", [], "line 3 has an empty entry"),
        ("x,y\n0,0\n1,,2\n3,1\n", [], "line 3 has an empty entry between its numbers"),
        ("0,0\n1, ,2\n3,1\n", [], "line 2 has an empty entry between its numbers"),
        (",0,0\n1,2\n3,1\n", [], "line 1 has an empty entry between its numbers"),
        ('0,0\n"1","","2"\n3,1\n', [], "line 2 has an empty entry between its numbers"),
        ("0,5;0\n1;;2\n3;1\n", [], "line 2 has an empty entry between its numbers"),
        ("x,y,tolerance\n0,0\n1,2,3,4\n", [], "line 3 has 4 numbers: 2 and at most a tolerance"),
        ("x,y,z,tolerance\n0,0\n", [], "line 2 has 2 numbers: 3 and at most a tolerance"),
        ("x,y,tolerance\n0,0\n1,2,few\n", [], "line 3 has 'few' where a number is needed"),
        ("0,0\n1,2\n3,3\n", ["--edge", "1"], "has no edges"),
        ("0,0\n1,2\n3,3\n", ["--tolerance", "-1"], "--tolerance: -1 must not be negative"),
        ("0,0\n1,2\n3,3\n", ["--edge", "0"], "--edge: invalid Edge number '0'"),
    ],
)
@pytest.mark.parametrize("method", METHODS)
def test_bad_points(tmp_path, method, text, options, message):
    given = tmp_path / "points.csv"
    given.write_text(text)
    before = contents(tmp_path)
    options = [*options, "--json", tmp_path / "curve.json"]
    expect_one_line(run("curve", method, given, "-o", tmp_path / "out.svg", *options), message)
    assert contents(tmp_path) == before


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_utf_16_is_refused(tmp_path, encoding):
    given = tmp_path / "points.csv"
    given.write_bytes("0,0\n1,2\n3,3\n".encode(encoding))
    result = run("curve", "arcs", given, "-o", tmp_path / "out.svg")
    expect_one_line(result, "is UTF-16 or no text: save the points as text in UTF-8")


def test_points_that_are_too_near_are_named(tmp_path):
    points = [*WAVE[:7], (WAVE[6][0], WAVE[6][1] + 1e-8), *WAVE[7:]]
    result = run("curve", "clothoid", points_file(tmp_path, points), "-o", tmp_path / "out.csv")
    expect_one_line(result, "the points of lines 7 and 8 are only 1e-08 mm apart: remove one")


@pytest.mark.parametrize("gap", [1e-13, 1e-8, 1e-4, 4e-3])
@pytest.mark.parametrize("at", [0, 7, 19])
@pytest.mark.parametrize("angle", [0, 1.2, 3])
def test_points_made_fair_may_repeat_a_neighbour(tmp_path, gap, at, angle):
    noise = random.Random(at)
    points = [(x, y + noise.uniform(-0.005, 0.005)) for x, y in WAVE]
    x, y = points[at]
    twin = (x + gap * math.cos(angle), y + gap * math.sin(angle))
    given = points_file(tmp_path, [*points[: at + 1], twin, *points[at + 1 :]])
    result, report, out = curve("fair", given, out="out.csv")
    (record,) = report["curves"]
    # The end of the curve is the last point.
    left, kept = (20, 21) if at == 19 else (at + 2, at + 1)
    assert f"left out: the point of line {left}, " in result.stdout
    assert f" mm from that of line {kept}\n" in result.stdout
    assert (record["points"], record["pieces"]) == (21, 20)
    rows = [(float(row["x"]), float(row["y"])) for row in rows_of(out)]
    assert len(rows) == 20 and record["moved_mm"] <= record["distance_mm"] <= 0.01
    assert all(min(math.dist(p, q) for q in rows) <= 0.01 for p in [*points, twin])
    assert record["after"]["inflections"] <= 4


def test_points_that_are_too_near_for_the_tolerance_are_noted(tmp_path):
    points = [*WAVE, (WAVE[-1][0] + 0.02, WAVE[-1][1] + 0.02)]
    result = curve("fair", points_file(tmp_path, points), "--tolerance", "1e-3")[0]
    assert "  the points of lines 20 and 21 are only 0.0283 mm apart: remove one\n" in result.stdout


@pytest.mark.parametrize("method", METHODS)
def test_tolerances_of_points(tmp_path, method):
    noise = random.Random(4)
    points = [(x, y + noise.uniform(-0.02, 0.02)) for x, y in WAVE]
    tolerances = [0.0, 0.04, 0.001, None] * 5
    given = tmp_path / "points.csv"
    lines = [
        ",".join(repr(number) for number in (*point, tolerance) if number is not None)
        for point, tolerance in zip(points, tolerances)
    ]
    given.write_text("x,y,Tolerance_mm\n" + "\n".join(lines) + "\n")
    result, report, out = curve(method, given, "--tolerance", "0.03", out="out.csv")
    note = "tolerances of points are for the method fair: --tolerance holds"
    assert (note in result.stderr) == (method != "fair")
    if method != "fair":
        return
    assert "  tolerances of the points, by their file: 0 to 0.04 mm\n" in result.stdout
    rows = [(float(row["x"]), float(row["y"])) for row in rows_of(out)]
    moves = [math.dist(p, q) for p, q in zip(points, rows)]
    for move, tolerance in zip(moves, tolerances):
        assert move <= (0.03 if tolerance is None else tolerance)
    assert moves[0] == moves[4] == 0 and 0.03 < max(moves[1::4]) <= 0.04
    assert report["curves"][0]["moved_mm"] == pytest.approx(max(moves))


def test_a_column_of_tolerances_may_be_empty(tmp_path):
    given = points_file(tmp_path, WAVE, header="x,y,tolerance\n")
    plain = points_file(tmp_path, WAVE, name="plain.csv")
    one, other = (curve("fair", path)[1]["curves"][0] for path in (given, plain))
    assert one == other


@pytest.mark.parametrize("method", METHODS)
def test_ends_that_meet_are_noted(tmp_path, method):
    ring = [(50 * math.cos(0.1 * i), 30 * math.sin(0.1 * i)) for i in range(62)]
    given = points_file(tmp_path, [*ring, (ring[0][0], ring[0][1] + 1e-14)])
    (open_curve,) = curve(method, given)[1]["curves"]
    assert any("--closed joins the curve there" in note for note in open_curve["notes"])
    (closed,) = curve(method, given, "--closed")[1]["curves"]
    assert closed["points"] == 62 and closed["notes"] == [
        note for note in closed["notes"] if "--closed" not in note
    ]


@pytest.mark.parametrize("method", METHODS)
def test_ends_that_nearly_meet_are_noted(tmp_path, method):
    ring = [(50 * math.cos(0.1 * i), 30 * math.sin(0.1 * i)) for i in range(62)]
    note = "mm from the first one: if the curve is closed there, remove the point and give --closed"
    again = points_file(tmp_path, [*ring, (ring[0][0], ring[0][1] + 0.05)])
    assert f"  the last point is 0.05 {note}\n" in curve(method, again)[0].stdout
    assert note not in curve(method, points_file(tmp_path, ring))[0].stdout
    assert note not in curve(method, points_file(tmp_path, ring), "--closed")[0].stdout


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["arcs", "points.csv", "-o", "out.svg", "--free-ends"], "is for the method fair"),
        (["fair", "points.csv", "-o", "out.svg", "--free-ends", "--closed"], "has no ends"),
        (["conic", "points.csv", "-o", "out.svg", "--polygon"], "is for the method arcs, not for"),
        (["arcs", "points.csv", "-o", "out.pdf"], "'.pdf' is not a known extension"),
        (["arcs", "points.csv", "-o", "points.csv"], "is the input itself"),
        (["arcs", "points.csv", "-o", "old.dxf"], "already exists; use --overwrite"),
        (["arcs", "points.csv", "-o", "missing/out.dxf"], "missing does not exist"),
        (["arcs", "none.csv", "-o", "out.dxf"], "none.csv: no such file"),
        (["arcs", "none.step", "-o", "out.dxf"], "none.step"),
        (["arcs", "points.csv"], "-o is required"),
        (["spirals", "points.csv", "-o", "out.dxf"], "spirals"),
        (["arcs", "points.csv", "-o", "out.dxf", "--json", "out.dxf"], "is the output"),
        (["arcs", "points.csv", "-o", "out.dxf", "--max-time", "1e-9"], "is over before"),
    ],
)
def test_bad_usage(tmp_path, arguments, message):
    points_file(tmp_path, WAVE)
    (tmp_path / "old.dxf").write_text("old")
    before = contents(tmp_path)
    expect_one_line(run("curve", *arguments, cwd=tmp_path), message)
    assert contents(tmp_path) == before


def long_input(folder):
    """Points whose arcs take many seconds."""
    return points_file(
        folder, [(0.01 * i, 10 * math.sin(0.01 * i)) for i in range(30_000)], "long.csv"
    )


@pytest.mark.parametrize("method", METHODS)
def test_the_time_limit_stops_a_single_curve(tmp_path, method):
    given = long_input(tmp_path)
    before = contents(tmp_path)
    options = ["-o", tmp_path / "out.dxf", "--json", tmp_path / "curve.json"]
    result = run("curve", method, given, *options, "--max-time", "0.01")
    expect_one_line(result, "--max-time 0.01 s is over")
    assert contents(tmp_path) == before


def test_ctrl_c_stops_a_single_curve(tmp_path):
    given = long_input(tmp_path)
    before = contents(tmp_path)
    process = subprocess.Popen(
        [PROGRAM, "curve", "arcs", given, "-o", tmp_path / "out.dxf", "--tolerance", "1e-6"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    out, error = process.communicate(timeout=60)
    assert process.returncode == 130 and out == "" and "stopped" in error
    assert contents(tmp_path) == before


def test_far_points_become_as_many_arcs(tmp_path):
    near = [(x, round(y * 2**20) / 2**20) for x, y in WAVE]
    far = [(x + 2.0**30, y + 2.0**30) for x, y in near]
    counts = [
        curve("arcs", points_file(tmp_path, points), out="out.csv")[1]["curves"][0]["pieces"]
        for points in (near, [(x - 2.0**30, y - 2.0**30) for x, y in far], far)
    ]
    assert counts[0] == counts[1] and abs(counts[1] - counts[2]) <= 2


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "size, options, message",
    [
        (1e90, [], "e+91 mm, and products of lengths above"),
        (1e-160, [], "mm, and products of lengths below"),
    ],
)
def test_sizes_beyond_the_range_are_refused(tmp_path, method, size, options, message):
    given = points_file(tmp_path, [(size * x, size * y) for x, y in WAVE])
    expect_one_line(run("curve", method, given, "-o", tmp_path / "out.dxf", *options), message)


def test_a_tolerance_below_the_rounding_is_refused(tmp_path):
    given = points_file(tmp_path, [(x + 1e9, y) for x, y in WAVE])
    result = run("curve", "arcs", given, "-o", tmp_path / "out.dxf", "--tolerance", "1e-7")
    expect_one_line(result, "is too small for coordinates of 1e+09 mm")


@pytest.mark.parametrize("method", METHODS)
def test_a_tolerance_below_the_rounding_of_large_sizes_is_refused(tmp_path, method):
    given = points_file(tmp_path, [(0, 0), (1e20, 1e19), (2e20, 0), (3e20, 5e19)])
    result = run("curve", method, given, "-o", tmp_path / "out.step")
    expect_one_line(result, "is too small for coordinates of 3e+20 mm, which are rounded by")
    assert curve(method, given, "--tolerance", "1e8", out="out.csv")[0].returncode == 0


@pytest.mark.parametrize("name", ["2412 airfoil", "20-32C airfoil"])
def test_a_name_that_begins_with_a_number(tmp_path, name):
    given = tmp_path / "foil.dat"
    given.write_text(f"{name}\n4 0\n2 .5\n0 0\n2 -.5\n")
    result, report, _ = curve("arcs", given)
    assert report["curves"][0]["points"] == 4
    assert "line 1 is taken for a name" in result.stderr


def test_extrema_of_rounded_digits_do_not_count(tmp_path):
    circle = [(10 * math.cos(0.0015 * i), 10 * math.sin(0.0015 * i)) for i in range(2000)]
    given = points_file(tmp_path, [(round(x, 6), round(y, 6)) for x, y in circle])
    (found,) = curve("fair", given, "--tolerance", "0")[1]["curves"]
    assert any("can come from the rounding of the points" in note for note in found["notes"])
    notes = curve("clothoid", given)[1]["curves"][0]["notes"]
    assert any("can come from the rounding of the points" in note for note in notes)


def test_curves_of_a_model_need_a_tolerance(box):
    given = ("curve", "arcs", box, "--edge", "1", "--tolerance", "0")
    result = run(*given, "-o", box.parent / "out.dxf")
    expect_one_line(result, "--tolerance is 0 mm")


def test_corners_are_those_of_points(box):
    result = run("curve", "arcs", box, "--polygon", "-o", box.parent / "out.dxf")
    expect_one_line(result, "is a model: --polygon is for points")


def test_curves_of_several_planes_are_no_drawing(box):
    result = run("curve", "arcs", box, "--edge", "all", "-o", box.parent / "out.dxf")
    expect_one_line(result, "lie in several planes")


def test_help_names_methods_and_statuses():
    text = run("curve", "--help").stdout
    for word in (*METHODS, "--tolerance", "--closed", "--edge", "Exit status: 0 every curve"):
        assert word in text


@pytest.mark.parametrize("method", METHODS)
def test_help_of_a_method_is_about_this_method(method):
    text = run("curve", method, "--help").stdout
    assert text.startswith(f"{method}: ")
    assert f"Usage: seamwright curve {method} [OPTIONS] INPUT -o OUT\n" in text
    assert not any(other in text for other in METHODS if other not in (method, "fair"))
    assert ("--free-ends" in text) == (method == "fair")
    assert ("--polygon" in text) == (method == "arcs")
    for word in ("--tolerance", "--closed", "--edge", "Exit status: 0 every curve"):
        assert word in text
