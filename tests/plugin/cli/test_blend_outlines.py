# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of lines and arcs as key curves of curve blend, and lofts with corners.

The oracles are the formulas of the outlines: a rounded rectangle is what is as far from a smaller
rectangle as its radius, and the sides of a frustum are planes.
"""

import json
import math

import numpy as np
import pytest

from command import expect_one_line, run
from curves import points_file, rows_of
from schemas import expect_valid, validator

VALIDATOR = validator("blend")


def blend(folder, *inputs, out="out.csv", options=()):
    """The report and the text of a blend of closed curves."""
    report = folder / "blend.json"
    result = run("curve", "blend", *inputs, "--closed", "-o", folder / out, "--json", report,
                 "--overwrite", *options)
    assert result.returncode == 0, result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    return report, result.stdout


def frame_at(path, omega):
    rows = [row for row in rows_of(path) if float(row["omega"]) == omega]
    points = np.array([[float(row[c]) for c in "xyz"] for row in rows])
    apart = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    return points[apart > 1e-9]


def rounded(width, height, radius, z=0.0, digits=6, sides=5, arcs=8):
    points = []
    centres = [(1, -1), (1, 1), (-1, 1), (-1, -1)]
    for k, (x, y) in enumerate(centres):
        cx, cy = x * (width / 2 - radius), y * (height / 2 - radius)
        for i in range(arcs + 1):
            angle = math.radians(90 * (k - 1) + 90 * i / arcs)
            points.append((cx + radius * math.cos(angle), cy + radius * math.sin(angle)))
        next_x, next_y = centres[(k + 1) % 4]
        end = np.array([next_x * (width / 2 - radius), next_y * (height / 2 - radius)])
        normal = np.array([math.cos(math.radians(90 * k)), math.sin(math.radians(90 * k))])
        start = np.array(points[-1])
        points += [tuple(start + (end + radius * normal - start) * i / sides)
                   for i in range(1, sides)]
    return [(round(float(x), digits), round(float(y), digits), z) for x, y in points]


def from_rounded(points, width, height, radius):
    """Signed distances from the rounded rectangle."""
    beyond = np.abs(points[:, :2]) - [width / 2 - radius, height / 2 - radius]
    return (np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(axis=1), 0)
            - radius)


def curvatures(points):
    """Of the circles through three neighbours of a closed curve."""
    before = points - np.roll(points, 1, axis=0)
    after = np.roll(points, -1, axis=0) - points
    across = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    lengths = [np.linalg.norm(v, axis=1) for v in (before, after, before + after)]
    return 2 * across / (lengths[0] * lengths[1] * lengths[2])


def on_ends_of_arcs(points, width, height, radius):
    """Whether points are where the arcs of a rounded rectangle begin or end."""
    x, y = np.abs(points[:, :2]).T
    ends = [(width / 2, height / 2 - radius), (width / 2 - radius, height / 2)]
    return np.any([np.hypot(x - u, y - v) < 1e-4 for u, v in ends], axis=0)


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("first, second", [
    ((40, 30, 5), (80, 50, 5)),
    ((40, 30, 5), (60, 40, 10)),
    ((60, 40, 5), (40, 60, 15)),  # long sides become short ones
])
def test_a_rounded_rectangle_between_two_is_one(tmp_path, first, second, exact):
    files = [points_file(tmp_path, rounded(*first), "a.csv"),
             points_file(tmp_path, rounded(*second), "b.csv")]
    report, text = blend(tmp_path, *files, options=["--frames", 3] + ["--exact"] * exact)
    assert text.count("samples of 4 lines and 4 arcs") == 2
    assert "8 jumps of the curvature correspond" in text
    width, height, radius = (np.array(first) + second) / 2
    points = frame_at(tmp_path / "out.csv", 0.5)
    assert np.abs(from_rounded(points, width, height, radius)).max() < 1e-4
    x, y = np.abs(points[:, :2]).T
    on_sides = (x < width / 2 - radius - 1e-6) | (y < height / 2 - radius - 1e-6)
    assert on_sides.any()
    assert np.abs(from_rounded(points, width, height, radius))[on_sides].max() < 1e-6
    bends = curvatures(points)
    assert bends.min() > -1e-9
    # The circle through a joint of line and arc and its neighbours is of both.
    is_end = on_ends_of_arcs(points, width, height, radius)
    inside_arcs = ~on_sides & ~is_end
    assert is_end.sum() == 8 and inside_arcs.sum() > 40
    assert np.abs(bends[inside_arcs] * radius - 1).max() < 5e-3


def test_points_of_a_smooth_curve_are_no_arcs(tmp_path):
    """Arcs come as near to dense points of an ellipse as their few digits tell."""
    def ellipse(z):
        return [(round(30 * math.cos(a), 3), round(20 * math.sin(a), 3), z)
                for a in np.arange(300) * math.tau / 300]

    files = [points_file(tmp_path, ellipse(z), f"{z:.0f}.csv") for z in (0.0, 20.0)]
    _, text = blend(tmp_path, *files)
    assert "samples of" not in text


def test_few_points_are_no_arcs(tmp_path):
    """Each three points are on an arc."""
    files = [points_file(tmp_path, [(0.0, y), (10.0, y + 4), (25.0, y)], f"{y}.csv")
             for y in (0.0, 30.0)]
    result = run("curve", "blend", *files, "-o", tmp_path / "out.csv")
    assert result.returncode == 0 and "samples of" not in result.stdout


def test_pairs_of_points_on_lines_and_arcs(tmp_path):
    """The outline begins at the points of the first pair, halfway between them."""
    a, b = rounded(40, 30, 5), rounded(80, 50, 5)
    files = [points_file(tmp_path, a, "a.csv"), points_file(tmp_path, b, "b.csv")]
    for number in (5, 11, 9, 1):
        pair = f"{number},{number}"
        far = f"{number + 26},{number + 26}"
        blend(tmp_path, *files, options=["--frames", 3, "--pair", pair, "--pair", far])
        start = frame_at(tmp_path / "out.csv", 0.5)[0]
        halfway = (np.array(a[number - 1]) + b[number - 1]) / 2
        assert np.linalg.norm(start - halfway) < 1e-4


def rectangle(width, height, z, first=0, count=4):
    """Points on the sides; the first one is that number from a corner on."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = []
    for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
        for i in range(count):
            at_x, at_y = x + (u - x) * i / count, y + (v - y) * i / count
            points.append((at_x * width / 2, at_y * height / 2, z))
    return points[first:] + points[:first]


@pytest.mark.parametrize("first", [0, 2])
def test_a_loft_has_edges_at_corners(tmp_path, first):
    """A frustum: four planes, and the angles between them."""
    files = [points_file(tmp_path, rectangle(40, 30, 0.0, first), "a.csv"),
             points_file(tmp_path, rectangle(60, 20, 50.0), "b.csv")]
    report, text = blend(tmp_path, *files, out="out.step", options=["--loft"])
    assert report["loft"]["faces"] == 4 and "4 faces between corners" in text
    judged = run("analyze", tmp_path / "out.step", "--format", "json")
    judged = json.loads(judged.stdout)
    assert judged["model"]["faces"] == 4
    seams = judged["seams"]
    assert len(seams) == 4 and {seam["kind"] for seam in seams} == {"shared"}
    normals = np.array([(50, 0, -10), (0, 50, 5)]) / [[math.hypot(50, 10)], [math.hypot(50, 5)]]
    angle_deg = math.degrees(math.acos(abs(normals[0] @ normals[1])))
    length_mm = math.sqrt(10**2 + 5**2 + 50**2)
    for seam in seams:
        assert seam["gap_mm"]["upper"] < 1e-9
        assert abs(seam["angle_deg"]["lower"] - angle_deg) < 1e-3
        assert abs(seam["length_mm"] - length_mm) < 1e-6


@pytest.mark.parametrize("exact", [False, True])
def test_a_loft_without_corners_is_one_face_that_closes_smoothly(tmp_path, exact):
    """Its edge is not at a joint of a line and an arc, where the key curves begin."""
    files = [points_file(tmp_path, rounded(40, 30, 5, 0.0), "a.csv"),
             points_file(tmp_path, rounded(80, 50, 5, 60.0), "b.csv")]
    report, _ = blend(tmp_path, *files, out="out.step", options=["--loft"] + ["--exact"] * exact)
    assert report["loft"]["faces"] == 1
    assert [line["order"] for line in report["loft"]["lines"]].count(1) == 8
    judged = json.loads(run("analyze", tmp_path / "out.step", "--level", "G2", "--format",
                            "json").stdout)
    assert [seam["level"] for seam in judged["seams"]] == ["G2"]


SQUARE = [(-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (-20.0, 20.0)]


def star(first=0):
    """Five tips, of which the third is at the top."""
    points = []
    for i in range(10):
        angle, radius = math.radians(-126 + 36 * i), 10 if i % 2 else 25
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return points[first:] + points[:first]


def sides(corners, count=5):
    """Points on the sides of a polygon."""
    points = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        points += [tuple(a[k] + (b[k] - a[k]) * i / count for k in range(2)) for i in range(count)]
    return points


def corner_pairs(report):
    return {tuple(tuple(np.round(place["point_mm"][:2], 3)) for place in pair["places"])
            for pair in report["pairs"] if pair["kind"] == "corner"}


# The square's corners with feet and arms of the star, for that is nearest, and symmetric.
PAIRS = {((-20, -20), star()[0]), ((20, -20), star()[2]), ((20, 20), star()[4]),
         ((-20, 20), star()[8])}
PAIRS = {tuple(tuple(np.round(place, 3)) for place in pair) for pair in PAIRS}


@pytest.mark.parametrize("first, backwards", [(0, False), (1, False), (6, True), (7, True)])
@pytest.mark.parametrize("star_first", [False, True])
def test_corners_of_a_square_and_a_star_correspond_symmetrically(tmp_path, first, backwards,
                                                                 star_first):
    outline = star(first)[::-1] if backwards else star(first)
    files = [points_file(tmp_path, sides(SQUARE), "square.csv"),
             points_file(tmp_path, sides(outline), "star.csv")]
    pairs = PAIRS
    if star_first:
        files.reverse()
        pairs = {pair[::-1] for pair in PAIRS}
    report, text = blend(tmp_path, *files)
    assert corner_pairs(report) == pairs
    for pair in report["pairs"]:
        for place, path in zip(pair["places"], files):
            points = np.loadtxt(path, delimiter=",")
            assert np.abs(points[place["point"] - 1][:2] - place["point_mm"][:2]).max() < 1e-4
            assert f"point {place['point']} (" in text


def numbers(report):
    return [[place["point"] for place in pair["places"]] for pair in report["pairs"]]


def test_pairs_of_the_report_are_pairs_of_the_command(tmp_path):
    """The numbers of the points that correspond give the same frames again."""
    files = [points_file(tmp_path, sides(SQUARE), "square.csv"),
             points_file(tmp_path, sides(star(3)), "star.csv")]
    report, _ = blend(tmp_path, *files, options=["--frames", 3])
    frame = frame_at(tmp_path / "out.csv", 0.5)
    options = []
    for pair in report["pairs"]:
        options += ["--pair", ",".join(str(place["point"]) for place in pair["places"])]
    assert len(options) == 8
    again, _ = blend(tmp_path, *files, options=["--frames", 3] + options)
    assert {pair["kind"] for pair in again["pairs"]} == {"given"}
    assert numbers(again) == numbers(report)
    assert np.abs(frame_at(tmp_path / "out.csv", 0.5) - frame).max() < 1e-6


def test_curves_that_match_nothing_are_named(tmp_path):
    turn = math.radians(45)
    turned = [(x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z)
              for x, y, z in rounded(40, 40, 8, 50.0, digits=15)]
    files = [points_file(tmp_path, rectangle(40, 30, 0.0), "a.csv"),
             points_file(tmp_path, turned, "b.csv")]
    _, text = blend(tmp_path, *files)
    assert "equal shares of the length correspond" in text and "--pair" in text


@pytest.mark.parametrize("order", [0, 1])
def test_open_and_closed_curves_are_named(tmp_path, order):
    points = points_file(tmp_path, [(0, 0), (10, 8), (25, 12), (40, 6)], "open.csv")
    outline = points_file(tmp_path, rounded(40, 30, 5), "outline.csv")
    assert run("curve", "arcs", outline, "--closed", "-o", tmp_path / "ring.step").returncode == 0
    files = [points, tmp_path / "ring.step"]
    if order:
        files.reverse()
    result = run("curve", "blend", *files, "-o", tmp_path / "out.step")
    kinds = ["open", "closed"][::-1 if order else 1]
    expect_one_line(result, f"{files[1]}: key curve 2 ({files[1]}) is {kinds[1]}, and key curve 1 "
                            f"({files[0]}) is {kinds[0]}")


def test_a_loft_without_area_is_refused(tmp_path):
    square = "0 0\n5 0\n10 0\n10 5\n10 10\n5 10\n0 10\n0 5\n"
    for name in ("a.csv", "b.csv"):
        (tmp_path / name).write_text(square)
    options = ["--closed", "--loft", "-o", "loft.step"]
    result = run("curve", "blend", "a.csv", "b.csv", *options, cwd=tmp_path)
    expect_one_line(result, "area")
    assert not (tmp_path / "loft.step").exists()
