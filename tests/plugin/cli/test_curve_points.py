# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve with points of curves that cross themselves, points of lines and arcs, few
points, and models of one edge."""

import math

import pytest

from command import expect_one_line, run
from curves import METHODS, curve, points_file


def lemniscate(count, start):
    points = []
    for i in range(count):
        t = start + 2 * math.pi * i / count
        shrunk = 1 + math.sin(t) ** 2
        points.append((50 * math.cos(t) / shrunk, 50 * math.sin(t) * math.cos(t) / shrunk))
    return points


@pytest.mark.parametrize("count", [24, 40])
@pytest.mark.parametrize("start", [math.pi / 2, math.pi / 2 + 1e-9, 0, 1])
@pytest.mark.parametrize("closed", [True, False])
def test_conics_of_a_figure_eight(tmp_path, count, start, closed):
    """At pi/2 it begins at its crossing, where the turn of the points is rounding."""
    points = lemniscate(count, start)
    given = points_file(tmp_path, points if closed else [*points, points[0]])
    result, report, _ = curve("conic", given, *(["--closed"] if closed else []))
    assert result.returncode == 0, result.stderr
    (found,) = report["curves"]
    assert found["distance_mm"] <= 0.01
    # The length of a lemniscate: 2.622057554... times its half width, twice.
    assert found["after"]["length_mm"] == pytest.approx(2 * 2.622057554 * 50, rel=1e-3)
    assert found["after"]["inflections"] in ({2} if closed else {1, 2})
    assert found["after"]["extrema"] <= 4


@pytest.mark.parametrize("count", [24, 60])
@pytest.mark.parametrize("offset", [1e-4, 3e-5, 1e-5, 1e-6, 1e-8])
def test_conics_through_points_with_one_beside_an_inflection(tmp_path, count, offset):
    """The conics between that point and its inflection would wave."""
    given = points_file(tmp_path, lemniscate(count, math.pi / 2 + offset))
    result, report, _ = curve("conic", given, "--closed", "--tolerance", "0")
    assert result.returncode == 0, result.stderr
    (found,) = report["curves"]
    assert (found["after"]["extrema"], found["after"]["inflections"]) == (2, 2)


def test_an_empty_line_between_outlines_is_named(tmp_path):
    given = tmp_path / "two.csv"
    sides = ["".join(f"{x},{y}\n" for x in range(11)) for y in (0, 5)]
    given.write_text("\n".join(sides))
    result, _, _ = curve("arcs", given)
    assert "an empty line is before line 13: the points before and after it are one curve" in (
        result.stderr
    )


def slot(steps=15):
    points = []
    for side in (1, -1):
        points += [(side * (-25 + 50 * k / steps), -8 * side) for k in range(steps)]
        angles = [math.pi * (k / steps - 0.5) for k in range(steps)]
        points += [(side * (25 + 8 * math.cos(a)), side * 8 * math.sin(a)) for a in angles]
    return points


@pytest.mark.parametrize("method", ["clothoid", "conic", "fair"])
def test_samples_of_lines_and_arcs_are_for_the_method_arcs(tmp_path, method):
    result, report, _ = curve(method, points_file(tmp_path, slot()), "--closed", out="out.svg")
    (found,) = report["curves"]
    named = [note for note in found["notes"] if "samples of 4 lines and arcs" in note]
    assert len(named) == 1 and "the method arcs gives them" in named[0]
    assert result.stdout.endswith("\nREACHED WITH RESERVATIONS\n")


def test_samples_of_a_smooth_curve_are_not_for_the_method_arcs(tmp_path):
    wave = [(0.5 * i, 4 * math.sin(0.2 * i)) for i in range(100)]
    for method in ("clothoid", "fair"):
        result, _, _ = curve(method, points_file(tmp_path, wave), out="out.svg")
        assert result.stdout.endswith("\nREACHED\n") and "method arcs" not in result.stdout


def test_two_points(tmp_path):
    given = points_file(tmp_path, [(0, 0), (3, 4)])
    for method in ("arcs", "clothoid", "conic"):
        result, report, _ = curve(method, given)
        assert result.returncode == 0
        assert report["curves"][0]["after"]["length_mm"] == pytest.approx(5)
    result = run("curve", "fair", given, "-o", tmp_path / "fair.csv")
    assert result.returncode == 2
    expect_one_line(
        result, "2 points: nothing can be made fair between them; at least 3 are needed"
    )


@pytest.mark.parametrize("name", ["edge.step", "edge.igs", "edge.brep"])
def test_models_of_one_edge(tmp_path, name):
    low = points_file(tmp_path, [(3 * i, 0.09 * i * i) for i in range(20)])
    length_mm = curve("clothoid", low, out=name)[1]["curves"][0]["after"]["length_mm"]
    for method in METHODS:
        result, report, _ = curve(method, tmp_path / name, out="again.svg")
        (found,) = report["curves"]
        assert result.returncode == 0 and found["edges"] == [1]
        assert found["after"]["length_mm"] == pytest.approx(length_mm, abs=0.1)
    high = points_file(tmp_path, [(3 * i, 10 + 0.1 * i * i) for i in range(20)], "high.csv")
    result = run("curve", "blend", tmp_path / name, high, "-o", tmp_path / f"blend_{name}")
    assert result.returncode == 0, result.stderr


def test_faults_of_a_key_curve_have_no_number_of_a_frame(tmp_path):
    names = ["low.csv", "high.csv"]
    low, high = (
        points_file(tmp_path, [(3 * i, height + 0.09 * i * i) for i in range(20)], name)
        for height, name in zip((0, 10), names)
    )
    result = run("curve", "blend", low, high, "-o", tmp_path / "o.csv", "--tolerance", 1e-12)
    assert result.returncode == 2
    expect_one_line(result, "low.csv: the tolerance is 1e-12 mm, and places on the curve are known")
