# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of points: curves end and begin there, and the figures do not count them."""

import math

import pytest

from curves import curve, points_file, rows_of


def sampled(corners, count):
    """Points of the sides of a closed polygon, without the last corner again."""
    sides = zip(corners, corners[1:] + corners[:1])
    return [
        tuple(round(a + (b - a) * k / count, 6) for a, b in zip(start, end))
        for start, end in sides
        for k in range(count)
    ]


def half_disc(radius=10, count=24):
    """An arc of half a circle, and its diameter."""
    arc = [math.pi * k / count for k in range(count)]
    points = [(radius * math.cos(angle), radius * math.sin(angle)) for angle in arc]
    return points + [(2 * radius * k / count - radius, 0) for k in range(count)]


@pytest.mark.parametrize("first", [0, 7])
def test_clothoids_keep_the_corners_of_a_rectangle(tmp_path, first):
    corners = [(0, 0), (40, 0), (40, 20), (0, 20)]
    points = sampled(corners, 10)
    given = points_file(tmp_path, points[first:] + points[:first])
    result, report, out = curve("clothoid", given, "--closed", out="out.csv")
    assert result.returncode == 0 and "REACHED WITH RESERVATIONS" in result.stdout
    (found,) = report["curves"]
    assert found["corners"] == 4 and found["pieces"] == 40
    lines = sorted((10 * k - first) % 40 + 1 for k in range(4))
    assert f"4 corners in lines {', '.join(map(str, lines))}: " in result.stdout
    assert found["after"]["length_mm"] == pytest.approx(120, abs=1e-9)
    for figures in (found["before"], found["after"]):
        assert figures["energy_per_mm"] == pytest.approx(0, abs=1e-12)
        assert figures["extrema"] == figures["inflections"] == 0
    assert all(abs(float(row["curvature_per_mm"])) < 1e-9 for row in rows_of(out))


def test_clothoids_between_corners_are_g2(tmp_path):
    """An arc, a corner and a line: the curvature is that of the arc up to the corner."""
    arc = [(10 * math.sin(k / 10), 10 - 10 * math.cos(k / 10)) for k in range(11)]
    end = arc[-1]
    line = [(end[0] + k * math.cos(-1), end[1] + k * math.sin(-1)) for k in range(1, 11)]
    result, report, _ = curve("clothoid", points_file(tmp_path, arc + line))
    (found,) = report["curves"]
    assert found["corners"] == 1 and "a corner in line 11: " in result.stdout
    assert found["after"]["length_mm"] == pytest.approx(20, abs=1e-4)
    assert found["after"]["energy_per_mm"] == pytest.approx(10 / 10**2, rel=1e-4)


@pytest.mark.parametrize("method", ["arcs", "clothoid", "conic", "fair"])
def test_figures_do_not_count_corners(tmp_path, method):
    given = points_file(tmp_path, half_disc())
    _, report, _ = curve(method, given, "--closed", "--tolerance", "0.001")
    (found,) = report["curves"]
    assert found["corners"] == 2
    for figures in (found["before"], found["after"]):
        assert figures["energy_per_mm"] == pytest.approx(math.pi / 10, rel=1e-3)
        assert figures["extrema"] == figures["inflections"] == 0
