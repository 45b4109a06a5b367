# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve with airfoils, whose points have few digits or errors."""

import math
import random
import re

import pytest

from command import expect_one_line, run
from curves import WAVE, curve, points_file, rows_of

TOLERANCES = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)


def thickness_at(x):
    return x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))) + 0.2969 * math.sqrt(x)


def foil(count=31, thickness=0.09, camber=0.02, reflex=1.5):
    """The outline of a cambered airfoil with a chord of 100 mm, rounded to five digits of it."""
    upper, lower = [], []
    for i in range(count):
        x = (1 - math.cos(math.pi * i / (count - 1))) / 2
        half = 5 * thickness * thickness_at(x)
        mean = 4 * camber * x * (1 - x) * (1 + reflex * (x - 0.5))
        upper.append((round(x, 5) * 100, round(mean + half, 5) * 100))
        lower.append((round(x, 5) * 100, round(mean - half, 5) * 100))
    return upper[::-1] + lower[1:]


def turns(figures):
    return figures["extrema"] + figures["inflections"]


@pytest.mark.parametrize(
    "shape", [{}, {"count": 25, "thickness": 0.08, "camber": 0.03, "reflex": 0.5}, {"reflex": 1}]
)
def test_a_larger_tolerance_leaves_no_more_waves(tmp_path, shape):
    given = points_file(tmp_path, foil(**shape))
    for tolerance in TOLERANCES:
        (found,) = curve("fair", given, "--tolerance", tolerance)[1]["curves"]
        assert turns(found["after"]) <= 8 < turns(found["before"])
        assert 0 < found["moved_mm"] <= tolerance


def test_conics_of_a_part_of_the_tolerance_are_kept(tmp_path):
    given = points_file(tmp_path, foil())
    found = {}
    for tolerance in (0.02, 0.1, 0.2):
        (found[tolerance],) = curve("conic", given, "--tolerance", tolerance)[1]["curves"]
        assert found[tolerance]["distance_mm"] <= tolerance
    assert turns(found[0.2]["after"]) <= turns(found[0.1]["after"])
    assert turns(found[0.1]["after"]) <= turns(found[0.02]["after"])


def noisy_outline(error=0.02):
    errors = random.Random(1)
    upper = [(1 - math.cos(math.pi * i / 89)) / 2 for i in range(90)]
    upper = [(round(100 * x, 3), round(60 * thickness_at(x), 3)) for x in upper]
    outline = upper[::-1] + [(x, -y) for x, y in upper[1:-1]]
    return [
        (x + errors.uniform(-error, error), y + errors.uniform(-error, error))
        for x, y in outline
    ]


@pytest.mark.parametrize("method", ["conic", "fair"])
def test_errors_do_not_hide_the_corner_of_a_sharp_edge(tmp_path, method):
    """Beside the edge the points are so near to each other that their errors are sharp turns."""
    outline = noisy_outline()
    given = points_file(tmp_path, outline)
    result, report, out = curve(method, given, "--closed", "--tolerance", 0.03, out="out.csv")
    assert result.returncode == 0
    (found,) = report["curves"]
    assert found["corners"] == 1 and found["distance_mm"] <= 0.03
    assert turns(found["after"]) < turns(found["before"]) / 4
    keys = ("x", "y") if method == "fair" else ("x0", "y0")
    assert tuple(float(rows_of(out)[0][key]) for key in keys) == pytest.approx(outline[0])


def test_conics_name_points_that_are_left_out(tmp_path):
    errors = random.Random(2)
    points = [(x, y + errors.uniform(-0.05, 0.05)) for x, y in WAVE]
    twin = (points[7][0] + 1e-4, points[7][1])
    given = points_file(tmp_path, [*points[:8], twin, *points[8:]])
    result, report, _ = curve("conic", given, "--tolerance", 0.2)
    assert "  left out: the point of line 9, 0.0001 mm from that of line 8\n" in result.stdout
    assert 0 < report["curves"][0]["distance_mm"] <= 0.2


@pytest.mark.parametrize("away", [0, 1e9])
def test_messages_have_degrees_and_coordinates(tmp_path, away):
    outline = noisy_outline(0.4)
    given = points_file(tmp_path, [(x + away, y) for x, y in outline])
    out = tmp_path / "out.csv"
    result = run("curve", "clothoid", given, "--closed", "--tolerance", 0.03, "-o", out)
    expect_one_line(result, " degrees off their chord, more than 120: insert a point")
    number = r"(-?[0-9.e+-]+)"
    pattern = rf"points \({number}, {number}\) and \({number}, {number}\)"
    named = [float(text) for text in re.search(pattern, result.stderr).groups()]
    origin = (0, 0)
    if away > 0:
        origin = re.search(rf"\(coordinates from \({number}, {number}\)\)", result.stderr).groups()
    x, y = float(origin[0]) - away, float(origin[1])
    for place in (named[:2], named[2:]):
        assert min(math.dist((place[0] + x, place[1] + y), point) for point in outline) < 2e-4
