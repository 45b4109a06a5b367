# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve blend: frames and lofts, what it says, and what it refuses.

The oracles are poles read from the written STEP file and evaluated with numpy.
"""

import json
import math
import re

import numpy as np
import pytest

from command import contents, expect_one_line, run
from curves import CIRCLE, points_file, rows_of
from models import box_text
from schemas import expect_every_key_matters, expect_valid, validator

VALIDATOR = validator("blend")
LOW = [(0, 0), (10, 8), (25, 12), (40, 6), (60, 10)]
HIGH = [(0, 30), (10, 45), (25, 60), (40, 50), (60, 40)]
ELLIPSE = [(2 * x, 1.2 * y) for x, y in CIRCLE]
SPACE_A = [(5 * i, 3 * math.sin(i), 0) for i in range(6)]
SPACE_B = [(5 * i, 6 * math.cos(i), 20 + i % 2) for i in range(6)]


def blend(folder, *inputs, out="out.step", options=("--exact",), status=0):
    """The result, the report and the file written."""
    result = run(
        "curve", "blend", *inputs, "-o", folder / out, "--json", folder / "blend.json",
        "--overwrite", *options,
    )
    assert result.returncode == status, result.stderr
    report = json.loads((folder / "blend.json").read_text())
    expect_valid(report, VALIDATOR)
    assert report["reached"] == (status == 0)
    return result, report, folder / out


@pytest.fixture
def pair(tmp_path):
    return points_file(tmp_path, LOW, "low.csv"), points_file(tmp_path, HIGH, "high.csv")


@pytest.fixture
def space(tmp_path):
    return points_file(tmp_path, SPACE_A, "a.csv"), points_file(tmp_path, SPACE_B, "b.csv")


def splines_of(path):
    """Degree, poles, multiplicities and knots of the B-spline curves of a STEP file."""
    text = re.sub(r"\s+", "", path.read_text())
    points = {
        name: [float(x) for x in numbers.split(",")]
        for name, numbers in re.findall(r"(#\d+)=CARTESIAN_POINT\('[^']*',\(([^)]*)\)\)", text)
    }
    found = re.findall(
        r"=B_SPLINE_CURVE_WITH_KNOTS\('[^']*',(\d+),\(([^)]*)\),[^()]*,\(([^)]*)\),\(([^)]*)\)",
        text,
    )
    return [
        (
            int(degree),
            np.array([points[name] for name in names.split(",")]),
            [int(n) for n in multiplicities.split(",")],
            [float(x) for x in knots.split(",")],
        )
        for degree, names, multiplicities, knots in found
    ]


def segments_of(degree, poles, multiplicities, knots):
    """The Bezier poles of each segment, by de Boor's insertion of knots."""
    flat = [x for x, n in zip(knots, multiplicities) for _ in range(n)]
    poles = [np.array(p) for p in poles]
    for x, n in list(zip(knots, multiplicities))[1:-1]:
        for _ in range(degree - n):
            k = max(i for i, t in enumerate(flat) if t <= x)
            new = poles[: k - degree + 1]
            for i in range(k - degree + 1, k + 1):
                if flat[i + degree] > flat[i] and i < len(poles):
                    share = (x - flat[i]) / (flat[i + degree] - flat[i])
                    new.append((1 - share) * poles[i - 1] + share * poles[i])
                else:
                    new.append(poles[i - 1])
            poles = new + poles[k:]
            flat.insert(k + 1, x)
    poles = np.array(poles)
    return [poles[i : i + degree + 1] for i in range(0, len(poles) - 1, degree)]


def bezier(poles, t):
    """Points of a Bezier curve at a column of parameters."""
    n = len(poles) - 1
    return sum(math.comb(n, k) * t**k * (1 - t) ** (n - k) * p for k, p in enumerate(poles))


def tangent_and_curvature(poles):
    """Tangent and curvature vector where a Bezier curve of these poles begins."""
    n = len(poles) - 1
    first, second = n * (poles[1] - poles[0]), n * (n - 1) * (poles[2] - 2 * poles[1] + poles[0])
    square = first @ first
    return first / math.sqrt(square), (second - (second @ first) / square * first) / square


def expect_g2(segments, closed=False, order=2):
    """Tangents and curvatures agree at all joints."""
    pairs = list(zip(segments, segments[1:]))
    for a, b in pairs + ([(segments[-1], segments[0])] if closed else []):
        tangent_a, curvature_a = tangent_and_curvature(a[::-1])
        tangent_b, curvature_b = tangent_and_curvature(b)
        assert np.abs(a[-1] - b[0]).max() < 1e-9
        assert np.abs(tangent_a + tangent_b).max() < 1e-8
        if order >= 2:
            assert np.abs(curvature_a - curvature_b).max() < 1e-7 * (1 + abs(curvature_a).max())


def test_frames_of_points_are_g2_and_begin_and_end_at_the_curves(tmp_path, pair):
    _, report, path = blend(tmp_path, *pair, options=["--exact", "--frames", 5])
    splines = splines_of(path)
    assert len(splines) == len(report["frames"]) == 5
    frames = [segments_of(*spline) for spline in splines]
    for frame, record in zip(frames, report["frames"]):
        assert len(frame) == 4 and len(record["joints"]) == 3
        expect_g2(frame)
        assert all(joint["order"] == 2 for joint in record["joints"])
        assert max(max(joint["defects"]) for joint in record["joints"]) < 1e-11
    for frame, points in ((frames[0], LOW), (frames[-1], HIGH)):
        met = np.array([frame[0][0]] + [segment[-1] for segment in frame])[:, :2]
        assert np.abs(met - points).max() < 1e-9
    # The ends of open curves are blended linearly.
    middle = frames[2]
    assert np.abs(middle[0][0][:2] - (np.array(LOW[0]) + HIGH[0]) / 2).max() < 1e-9
    assert np.abs(middle[-1][-1][:2] - (np.array(LOW[-1]) + HIGH[-1]) / 2).max() < 1e-9
    assert [frame["omega"] for frame in report["frames"]] == [0, 0.25, 0.5, 0.75, 1]


def test_curves_over_common_knots(tmp_path, pair):
    """Unless --exact is given: the curves are met within the tolerance, and poles are blended."""
    _, exact, path = blend(tmp_path, *pair, out="exact.csv", options=["--exact", "--frames", 3])
    result, report, fitted = blend(tmp_path, *pair, options=["--frames", 3, "--tolerance", "0.01"])
    assert [key["refitted_mm"] for key in exact["key_curves"]] == [0, 0]
    assert all(0 < key["refitted_mm"] <= 0.01 for key in report["key_curves"])
    assert {j["remedy"] for frame in report["frames"] for j in frame["joints"]} == {"plain"}
    frames = [segments_of(*spline) for spline in splines_of(fitted)]
    for frame in frames:
        expect_g2(frame)
    # Every point of a key curve is near its refitted curve, which is sampled 50 times denser.
    t = np.linspace(0, 1, 801)[:, None]
    for omega, frame in ((0, frames[0]), (1, frames[-1])):
        dense = np.concatenate([bezier(poles, t) for poles in frame])
        for row in rows_of(path):
            if float(row["omega"]) == omega:
                point = [float(row[c]) for c in "xyz"]
                assert np.linalg.norm(dense - point, axis=1).min() < 0.02
    assert any("correspond" in note for note in report["notes"]) and "matched" in result.stdout


def middle_distance(folder, pair, *options):
    """How far the frame at omega 1/2 is from halfway between point 2 of the first curve and point 3
    of the second."""
    _, report, path = blend(folder, *pair, out="out.csv", options=["--frames", 3, *options])
    rows = [row for row in rows_of(path) if float(row["omega"]) == 0.5]
    points = np.array([[float(row[c]) for c in "xy"] for row in rows])
    halfway = (np.array(LOW[1]) + np.array(HIGH[2])) / 2
    return np.linalg.norm(points - halfway, axis=1).min(), report


def test_given_pairs_correspond(tmp_path, pair):
    distance, report = middle_distance(tmp_path, pair, "--pair", "4,75%", "--pair", "2,3")
    assert distance < 0.5 and report["match"] == "pairs"  # samples are that far apart
    assert any("2 given pairs correspond" in note for note in report["notes"])
    assert middle_distance(tmp_path, pair, "--match", "length")[0] > 1


def test_curves_of_different_numbers_of_points(tmp_path, pair):
    more = points_file(tmp_path, [(6 * i, 3 * math.sin(i)) for i in range(11)], "more.csv")
    for options in (["--frames", 3], ["--frames", 3, "--match", "length", "--exact"]):
        _, report, path = blend(tmp_path, pair[0], more, options=options)
        assert [key["segments"] for key in report["key_curves"]] == [4, 10]
        for spline in splines_of(path):
            expect_g2(segments_of(*spline))


def test_lengths_are_those_of_the_curves(tmp_path, pair):
    _, report, path = blend(tmp_path, *pair, options=["--exact", "--frames", 3])
    t = np.linspace(0, 1, 4001)[:, None]
    for frame, record in zip(map(lambda s: segments_of(*s), splines_of(path)), report["frames"]):
        length = 0
        for poles in frame:
            length += np.linalg.norm(np.diff(bezier(poles, t), axis=0), axis=1).sum()
        assert record["length_mm"] == pytest.approx(length, rel=3e-6)


def test_closed_frames_are_g2_around(tmp_path):
    files = [points_file(tmp_path, p, f"{i}.csv") for i, p in enumerate((CIRCLE, ELLIPSE))]
    result, report, path = blend(tmp_path, *files, options=["--exact", "--closed", "--frames", 4])
    joints = len(report["frames"][0]["joints"])
    assert joints >= 12 and report["closed"]
    assert f"2 key curves, closed: 4 frames with {joints} joints each" in result.stdout
    for spline in splines_of(path):
        frame = segments_of(*spline)
        assert len(frame) == joints
        expect_g2(frame, closed=True)


def test_curves_of_space(tmp_path, space):
    _, report, path = blend(tmp_path, *space, options=["--exact", "--order", "3", "--frames", 3])
    assert report["order"] == 3 and all(
        joint["order"] == 2 or joint["order"] == 3
        for frame in report["frames"]
        for joint in frame["joints"]
    )
    for spline in splines_of(path):
        expect_g2(segments_of(*spline))
    for out in ("out.svg", "out.dxf"):
        before = contents(tmp_path)
        files = ["-o", tmp_path / out, "--json", tmp_path / "no.json"]
        refused = run("curve", "blend", *space, *files)
        expect_one_line(refused, "a drawing has one plane, and the frames are up to ")
        assert contents(tmp_path) == before


def test_three_key_curves_are_frames(tmp_path, pair):
    third = points_file(tmp_path, [(x, 2 * y + 40) for x, y in LOW], "third.csv")
    for between in ("C0", "C1", "C2"):
        options = ["--exact", "--between", between, "--frames", 5]
        _, report, path = blend(tmp_path, *pair, third, options=options)
        assert report["in_between"] == between and len(report["key_curves"]) == 3
        frame = segments_of(*splines_of(path)[2])
        met = np.array([frame[0][0]] + [segment[-1] for segment in frame])[:, :2]
        for point in HIGH:
            assert np.linalg.norm(met - point, axis=1).min() < 1e-9


def test_all_outputs_tell_the_same_curves(tmp_path, pair):
    _, report, path = blend(tmp_path, *pair, options=["--exact", "--frames", 3])
    frames = [segments_of(*spline) for spline in splines_of(path)]
    _, report, table = blend(tmp_path, *pair, out="out.csv", options=["--exact", "--frames", 3])
    rows = rows_of(table)
    assert list(rows[0]) == ["omega", "x", "y", "z"] and len(rows) == 3 * (4 * 16 + 1)
    assert report["output"] == {"path": str(table), "format": "CSV", "distance_mm": 0}
    for k, omega in enumerate((0, 0.5, 1)):
        points = np.array(
            [[float(row[c]) for c in "xyz"] for row in rows if float(row["omega"]) == omega]
        )
        assert len(points) == 65
        corners = np.array([frames[k][0][0]] + [segment[-1] for segment in frames[k]])
        assert np.abs(points[::16] - corners).max() < 1e-9
        # Half of a segment, by the binomials.
        segment = frames[k][1]
        n = len(segment) - 1
        half = sum(math.comb(n, i) * p for i, p in enumerate(segment)) / 2**n
        assert np.abs(points[24] - half).max() < 1e-9
    for out, kind in (("out.svg", "SVG"), ("out.dxf", "DXF")):
        _, report, drawing = blend(tmp_path, *pair, out=out, options=["--exact", "--frames", 3])
        assert report["output"]["format"] == kind
        assert 0 < report["output"]["distance_mm"] <= 0.1 * report["tolerance_mm"]
        text = drawing.read_text()
        assert (text.count("<path") if kind == "SVG" else text.count("\nPOLYLINE\n")) == 3
    for out, kind in (("out.brep", "BREP"), ("out.bin", "binary BREP"), ("out.igs", "IGES")):
        assert blend(tmp_path, *pair, out=out)[1]["output"]["format"] == kind


def test_loft(tmp_path, space):
    result, report, path = blend(tmp_path, *space, options=["--exact", "--loft"])
    loft = report["loft"]
    assert loft["reached"] and loft["distance_mm"] <= report["tolerance_mm"]
    joints = len(report["frames"][0]["joints"])
    assert joints >= 4 and [line["joint"] for line in loft["lines"]] == list(range(1, joints + 1))
    for line in loft["lines"]:
        assert line["certified"] and line["gap_mm"]["upper"] < 1e-9
        # Nothing is seen; the bounds are rounding, which pieces of uneven lengths enlarge.
        assert line["angle_deg"]["lower"] == 0 and line["curvature_rel"]["lower"] == 0
        assert line["angle_deg"]["upper"] < 1e-3 and line["curvature_rel"]["upper"] < 1e-3
    assert "loft: degree " in result.stdout and "REACHED" in result.stdout
    judged = run("analyze", path, "--format", "json")
    assert judged.returncode == 0
    summary = json.loads(judged.stdout)["summary"]
    assert summary["defects"] == 0


def test_corners_are_left_out_of_the_figures_of_a_loft(tmp_path):
    """A polygon has corners: their lines say nothing about the loft."""
    files = []
    for i, z in enumerate((0, 40)):
        files.append(tmp_path / f"box{i}.step")
        files[i].write_text(box_text(20, 30 + i, z or 5))
    edges = ["--edge", "1,2"] * 2
    result, report, _ = blend(tmp_path, *files, options=["--loft", *edges])
    orders = [line["order"] for line in report["loft"]["lines"]]
    assert orders == [joint["order"] for joint in report["frames"][0]["joints"]]
    corners = orders.count(0)
    assert corners >= 1
    assert f"deg ({corners} left out, below G1 in the key curves)" in result.stdout or (
        f"no angle judged ({corners} left out, below G1 in the key curves)" in result.stdout
    )


def test_joints_below_g2_are_left_out_of_the_curvature(tmp_path):
    """Joints of arcs are G1, and not G2."""
    files = [tmp_path / "low.step", tmp_path / "high.step"]
    for points, z, file in ((LOW, 0, files[0]), (HIGH, 30, files[1])):
        space = points_file(tmp_path, [(x, y, z) for x, y in points], "arcs.csv")
        assert run("curve", "arcs", space, "-o", file).returncode in (0, 1)
    result, report, _ = blend(tmp_path, *files, options=["--exact", "--loft"])
    lines = report["loft"]["lines"]
    lower = [line for line in lines if line["order"] < 2]
    assert lower and all(line["order"] >= 1 for line in lines)
    assert any(line["curvature_per_mm"]["lower"] > 1e-3 for line in lower)
    assert f"({len(lower)} left out, below G2 in the key curves)" in result.stdout
    found = re.search(r"angle at most (\S+) deg", result.stdout)
    assert float(found.group(1)) < 1e-6


def test_frames_are_wires_in_files_of_step(tmp_path, pair):
    """Readers make a wire of a composite curve, and single edges of a set of other curves."""
    _, report, path = blend(tmp_path, *pair, options=["--exact", "--frames", 4])
    text = re.sub(r"\s+", "", path.read_text())
    sets = re.findall(r"=GEOMETRIC_CURVE_SET\('',\((#\d+)\)\);", text)
    assert len(sets) == len(report["frames"]) == 4
    starts = []
    for name in sets:
        segments = re.search(name + r"=COMPOSITE_CURVE\('',\(([^)]*)\),", text).group(1)
        first = segments.split(",")[0]
        curve = re.search(first + r"=COMPOSITE_CURVE_SEGMENT\(.CONTINUOUS.,.T.,(#\d+)\)", text)
        point = re.search(curve.group(1) + r"=TRIMMED_CURVE\('',#\d+,\((#\d+)", text).group(1)
        coordinates = re.search(point + r"=CARTESIAN_POINT\('',\(([^)]*)\)", text).group(1)
        starts.append(float(coordinates.split(",")[1]))
    assert starts == pytest.approx([0, 10, 20, 30])


def test_closeness_merges_joints(tmp_path, pair):
    low, high = pair
    shifted = points_file(tmp_path, [(x + 0.05 * (x == 25), y + 20) for x, y in LOW], "shifted.csv")
    pieces = [
        len(blend(tmp_path, low, shifted, options=[
            "--exact", "--match", "length", "--closeness", closeness])[1]["frames"][0]["joints"])
        for closeness in (0, 0.05)
    ]
    assert pieces[1] == 3 < pieces[0]
    expect_one_line(run("curve", "blend", low, high, "--closeness", 0.1, "-o", tmp_path / "a.step"),
                    "--exact")


def test_a_closed_loft_has_no_defects(tmp_path):
    files = [points_file(tmp_path, p, f"{i}.csv") for i, p in enumerate((CIRCLE, ELLIPSE))]
    _, report, path = blend(tmp_path, *files, options=["--exact", "--closed", "--loft"])
    assert len(report["loft"]["lines"]) == len(report["frames"][0]["joints"]) >= 12
    judged = run("analyze", path, "--level", "G2", "--format", "json")
    assert judged.returncode == 0
    seams = json.loads(judged.stdout)["seams"]
    assert [seam["level"] for seam in seams] == ["G2"] and seams[0]["certified"]


def test_a_loft_begins_with_the_first_curve(tmp_path, space):
    """The edges of the loft, blended, are the curves that were blended."""
    loft = blend(tmp_path, *space, options=["--exact", "--loft"])[2].rename(tmp_path / "loft.step")
    edges = {}
    for edge in (1, 2, 3, 4):
        out = tmp_path / f"edge{edge}.csv"
        done = run(
            "curve", "blend", loft, loft, "--edge", edge, "--edge", edge, "-o", out, "--frames", 2,
            "--exact",
        )
        assert done.returncode == 0, done.stderr
        rows = rows_of(out)
        edges[edge] = np.array([[float(row[c]) for c in "xyz"] for row in rows[: len(rows) // 2]])
    for given in (SPACE_A, SPACE_B):
        distances = [
            max(np.linalg.norm(points - p, axis=1).min() for p in np.array(given, float))
            for points in edges.values()
        ]
        assert min(distances) < 1e-6, distances


def test_written_frames_are_read_as_key_curves(tmp_path, pair):
    _, _, path = blend(tmp_path, *pair, options=["--exact", "--frames", 3])
    model = path.rename(tmp_path / "frames.step")
    _, report, out = blend(tmp_path, model, out="all.step", options=["--exact", "--frames", 3])
    assert [key["edges"] for key in report["key_curves"]] == [[1], [2], [3]]
    assert [key["input"] for key in report["key_curves"]] == [0, 0, 0]
    for a, b in zip(splines_of(model), splines_of(out)):
        for given, found in zip(segments_of(*a), segments_of(*b)):
            assert np.abs(given - found).max() < 1e-9
    # One edge of each file, and an edge beside points.
    options = ["--exact", "--edge", "1", "--edge", "3", "--frames", 3]
    _, report, _ = blend(tmp_path, model, model, out="two.step", options=options)
    assert [key["edges"] for key in report["key_curves"]] == [[1], [3]]
    # Files of points have no edges: a list belongs to the model beside them.
    _, report, _ = blend(
        tmp_path, pair[0], model, out="mixed.step", options=["--edge", "Edge3", "--frames", 3]
    )
    assert [(key["points"], key["edges"]) for key in report["key_curves"]] == [(5, []), (0, [3])]


def test_corners_stay_corners(tmp_path, box):
    """Two edges of a box, and those of a larger one: the joint is a corner in both."""
    larger = tmp_path / "larger.step"
    larger.write_text(box_text(30, 20, 50))
    options = ["--exact", "--edge", "1,2", "--edge", "1,2", "--frames", 3]
    result, report, _ = blend(tmp_path, box, larger, options=options)
    orders = {joint["order"] for frame in report["frames"] for joint in frame["joints"]}
    assert orders == {0} and "1 of 1 joint is below G2" in result.stdout
    assert report["notes"] and report["notes"][0] in result.stdout


def test_rounding_far_from_the_origin_is_named(tmp_path, pair):
    far = points_file(tmp_path, [(x + 1e12, y) for x, y in LOW], "far.csv")
    result = run("curve", "blend", pair[0], far, "-o", tmp_path / "out.step", "--exact")
    too_small = "the tolerance 0.001 mm is too small for coordinates of 1e+12 mm"
    expect_one_line(result, "far.csv: " + too_small)
    options = ["--exact", "--tolerance", "0.01", "--frames", 3]
    result, report, _ = blend(tmp_path, pair[0], far, options=options)
    assert "9 joints of a lower order than G2: defect" in result.stdout
    assert "3 of 3 joints are below G2 in the key curves" in result.stdout
    assert any("far.csv: the coordinates are rounded by" in note for note in report["notes"])
    assert not any("low.csv" in note for note in report["notes"])


def test_an_order_above_that_of_the_key_curves_is_named(tmp_path, pair):
    options = ["--exact", "--order", 3, "--frames", 3]
    result, report, _ = blend(tmp_path, *pair, options=options)
    assert "9 joints of a lower order than G3: defect" in result.stdout
    assert not any("rounded" in note for note in report["notes"])


def test_the_same_curve_twice_stays(tmp_path, pair):
    result, report, path = blend(tmp_path, pair[0], pair[0], options=["--exact", "--frames", 3])
    joints = [joint for frame in report["frames"] for joint in frame["joints"]]
    assert {joint["remedy"] for joint in joints} == {"plain"}
    assert max(joint["moved_mm"] for joint in joints) == 0
    first, *others = splines_of(path)
    assert all(np.abs(first[1] - other[1]).max() < 1e-9 for other in others)


def test_every_key_of_the_report_matters(tmp_path, space):
    report = blend(tmp_path, *space, options=["--exact", "--loft"])[1]
    for key in report["key_curves"]:
        key["edges"] = [1]
    report["notes"] = report["models"][0]["notes"] = ["one"]
    expect_every_key_matters(report, VALIDATOR)


def test_runs_are_repeated_bitwise(tmp_path, pair):
    first, second = (blend(tmp_path, *pair, out="out.csv") for _ in range(2))
    assert first[1] == second[1] and first[0].stdout == second[0].stdout


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["low.csv", "-o", "out.step"], "low.csv: has one curve, and a blend needs two or more"),
        (["-o", "out.step"], "INPUT is required"),
        (["low.csv", "high.csv"], "-o is required (see 'seamwright curve blend --help')"),
        (["low.csv", "none.csv", "-o", "out.step"], "none.csv: no such file"),
        (["none.step", "low.csv", "-o", "out.step"], "none.step: no such file"),
        (["low.csv", "nan.csv", "-o", "out.step"], "nan.csv: line 2 has the number nan"),
        (["low.csv", "one.csv", "-o", "out.step"], "one.csv: has 1 point"),
        (["low.csv", "high.csv", "-o", "out.csv", "--loft"], "out.csv: a loft is a surface"),
        (["low.csv", "high.csv", "-o", "out.svg", "--loft"], "out.svg: a loft is a surface"),
        (["low.csv", "high.csv", "-o", "out.pdf"], "'.pdf' is not a known extension"),
        (["low.csv", "high.csv", "-o", "low.csv"], "low.csv is the input itself"),
        (["low.csv", "high.csv", "-o", "high.csv", "--overwrite"], "high.csv is the input itself"),
        (["low.csv", "high.csv", "-o", "old.step"], "old.step already exists; use --overwrite"),
        (["low.csv", "high.csv", "-o", "no/out.step"], "there is no folder no"),
        (["low.csv", "high.csv", "-o", "out.step", "--json", "out.step"], "is the output"),
        (["low.csv", "high.csv", "-o", "out.step", "--json", "high.csv"], "high.csv"),
        (["low.csv", "high.csv", "-o", "out.step", "--edge", "1"], "has no edges"),
        (["box.step", "box.step", "-o", "out.step", "--edge", "1"], "is given 1 times for 2"),
        (["box.step", "low.csv", "-o", "out.step", "--edge", "99"], "edge 99: the model has edges"),
        (["box.step", "low.csv", "-o", "out.step", "--edge", "all"], "box.step: has 12 curves"),
        (["box.step", "low.csv", "-o", "out.step"], "box.step: has no free edges"),
        (["low.csv", "high.csv", "-o", "out.step", "--frames", "1"], "--frames"),
        (["low.csv", "high.csv", "-o", "out.step", "--order", "0"], "--order"),
        (["low.csv", "high.csv", "-o", "out.step", "--order", "5"], "--order"),
        (["low.csv", "high.csv", "-o", "out.step", "--tolerance", "0"], "--tolerance: 0 must"),
        (["low.csv", "high.csv", "-o", "out.step", "--tolerance", "nan"], "--tolerance"),
        (["low.csv", "high.csv", "-o", "out.step", "--between", "C3"], "--between"),
        (["low.csv", "high.csv", "-o", "out.step", "--match", "near"], "--match"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "1,3"], "an end of the curve of low"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "2,9"], "and no point 9"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "2"], "has 1 place, and 2 key"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "2,x"], "--pair: 'x' is neither"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "2,0"], "--pair: '0' is neither"),
        (["low.csv", "high.csv", "-o", "out.step", "--pair", "2,101%"], "--pair: '101%'"),
        (
            ["low.csv", "high.csv", "-o", "out.step", "--pair", "2,3", "--pair", "3,2"],
            "the curve of high.csv, which runs the other way: reverse its points",
        ),
        (
            ["low.csv", "high.csv", "-o", "out.step", "--pair", "2,3", "--match", "length"],
            "excludes",
        ),
        (["ring.step", "open.step", "-o", "out.step", "--edge", "1", "--edge", "1"], "open"),
    ],
)
def test_bad_usage(tmp_path, pair, box, arguments, message):
    (tmp_path / "nan.csv").write_text("0,0\n1,nan\n2,0\n")
    (tmp_path / "one.csv").write_text("0,0\n")
    (tmp_path / "old.step").write_text("old")
    if "ring.step" in arguments:
        # Four segments each, and of one degree.
        rings = [points_file(tmp_path, p[:4], f"{i}.csv") for i, p in enumerate((LOW, HIGH))]
        run("curve", "blend", *rings, "--closed", "-o", tmp_path / "ring.step", "--frames", "2")
        run("curve", "blend", *pair, "-o", tmp_path / "open.step", "--frames", "2")
    before = contents(tmp_path)
    if "--json" not in arguments:
        arguments = [*arguments, "--json", "new.json"]
    expect_one_line(run("curve", "blend", *arguments, cwd=tmp_path), message)
    assert contents(tmp_path) == before


def test_help_states_one_exit_status():
    shown = run("curve", "blend", "--help").stdout
    assert shown.count("Exit status:") == 1 and "every joint keeps the order" in shown
    assert "or all, each alone" in " ".join(shown.split())
