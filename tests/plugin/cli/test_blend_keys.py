# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which points of key curves correspond in curve blend, and the corners of key curves.

The oracles are formulas of the outlines that the points are taken from.
"""

import json
import math

import numpy as np
import pytest

from command import run
from curves import points_file, rows_of
from models import curve_text
from schemas import expect_valid, validator

VALIDATOR = validator("blend")


def blend(folder, *inputs, options=()):
    """The result, the report, and the points of each frame by omega."""
    out, report = folder / "out.csv", folder / "blend.json"
    result = run("curve", "blend", *inputs, "-o", out, "--json", report, "--overwrite", *options)
    assert result.returncode == 0, result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    frames = {}
    for row in rows_of(out):
        frames.setdefault(float(row["omega"]), []).append([float(row[c]) for c in "xyz"])
    return result, report, {omega: np.array(points) for omega, points in frames.items()}


def polygon_model(path, corners, closed=True):
    """A STEP file of the polygon with these corners, an edge for each side."""
    lines, names = [], []
    corners = [tuple(map(float, corner)) for corner in corners]
    for i, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1] * closed)):
        first = 10 * (i + 1)
        for j, point in enumerate((a, b)):
            place = ",".join(f"{x:.17E}" for x in point)
            lines.append(f"#{first + j}=CARTESIAN_POINT('',({place}));")
        lines += [
            f"#{first + 2}=B_SPLINE_CURVE_WITH_KNOTS('',1,(#{first},#{first + 1}),.UNSPECIFIED.,"
            f".F.,.F.,(2,2),(0.,1.),.UNSPECIFIED.);",
            f"#{first + 3}=TRIMMED_CURVE('',#{first + 2},(#{first},PARAMETER_VALUE(0.)),"
            f"(#{first + 1},PARAMETER_VALUE(1.)),.T.,.PARAMETER.);",
        ]
        names.append(f"#{first + 3}")
    last = 10 * (len(corners) + 1)
    lines.append(f"#{last}=GEOMETRIC_CURVE_SET('',({','.join(names)}));")
    path.write_text(curve_text(lines, [f"#{last}"]))
    return path


def rectangle(width, height, z, turn_deg=0, first=0, backwards=False):
    turn = math.radians(turn_deg)
    corners = []
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        x, y = x * width, y * height
        corners.append((x * math.cos(turn) - y * math.sin(turn),
                        x * math.sin(turn) + y * math.cos(turn), z))
    corners = corners[first:] + corners[:first]
    return corners[::-1] if backwards else corners


@pytest.mark.parametrize("turn_deg", [0, 30, -40])
@pytest.mark.parametrize("first, backwards", [(0, False), (2, False), (3, True)])
def test_rectangles_correspond_corner_by_corner(tmp_path, turn_deg, first, backwards):
    low = polygon_model(tmp_path / "low.step", rectangle(20, 10, 0))
    corners = rectangle(16, 7, 30, turn_deg, first, backwards)
    high = polygon_model(tmp_path / "high.step", corners)
    _, report, frames = blend(tmp_path, low, high, options=["--frames", 3])
    assert report["match"] == "features"
    # Halfway corners, those of the rectangle that is turned with the second one.
    for a, b in zip(rectangle(20, 10, 0), rectangle(16, 7, 30, turn_deg)):
        halfway = (np.array(a) + b) / 2
        assert np.linalg.norm(frames[0.5] - halfway, axis=1).min() < 1e-9
    assert not any("polygon" in note for note in report["notes"])


def slot(count, side=30, radius=10, z=0, start=0):
    """Points at equal distances along a slot."""
    arc = math.pi * radius
    length = 2 * (side + arc)
    points = []
    for i in range(count):
        s = (length * i / count + start) % length
        sign = -1 if s >= length / 2 else 1
        s %= length / 2
        if s < side:
            x, y = s - side / 2, -radius
        else:
            angle = (s - side) / radius - math.pi / 2
            x, y = side / 2 + radius * math.cos(angle), radius * math.sin(angle)
        points.append((sign * x, sign * y, z))
    return points


def distance_from_slot(points, side=30, radius=10):
    x = np.maximum(np.abs(points[:, 0]) - side / 2, 0)
    return np.abs(np.hypot(x, points[:, 1]) - radius).max()


@pytest.mark.parametrize("start", [0, 7, 25.5])
@pytest.mark.parametrize("exact", [True, False])
def test_a_slot_between_two_slots_is_that_slot(tmp_path, start, exact):
    files = [points_file(tmp_path, slot(60), "a.csv"),
             points_file(tmp_path, slot(75, z=20, start=start), "b.csv")]
    options = ["--closed", "--frames", 3] + (["--exact"] if exact else [])
    _, _, frames = blend(tmp_path, *files, options=options)
    of_keys = max(distance_from_slot(frames[0]), distance_from_slot(frames[1]))
    assert distance_from_slot(frames[0.5]) < of_keys + (0.02 if exact else 0.003)


def test_circles_do_not_twist(tmp_path):
    def circle(count, radius, z, start):
        angles = [start + math.tau * i / count for i in range(count)]
        return [(radius * math.cos(a), radius * math.sin(a), z) for a in angles]

    files = [points_file(tmp_path, circle(20, 10, 0, 0), "a.csv"),
             points_file(tmp_path, circle(27, 6, 20, 2), "b.csv")]
    _, _, frames = blend(tmp_path, *files, options=["--closed", "--frames", 3])
    radii = np.hypot(frames[0.5][:, 0], frames[0.5][:, 1])
    # A turn by 1 degree would be 0.0003 mm, and the splines through 20 points are 0.001 mm off.
    assert np.abs(radii - 8).max() < 0.003


def airfoil(count, thickness, z=0.0, chord=100):
    """A closed symmetric section with a blunt trailing edge, from its upper corner on."""
    def half(x):
        return 5 * thickness * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3
                                - 0.1015 * x**4)
    places = [(1 + math.cos(math.pi * i / count)) / 2 for i in range(count + 1)]
    upper = [(chord * x, chord * half(x), z) for x in places]
    return upper + [(x, -y, z) for x, y, _ in upper[-2::-1]]


def test_corners_of_points_stay(tmp_path):
    """The two corners of a blunt trailing edge."""
    sections = [airfoil(40, 0.12), airfoil(33, 0.16, 200, 70)]
    files = [points_file(tmp_path, p, f"{i}.csv") for i, p in enumerate(sections)]
    result, report, frames = blend(tmp_path, *files, options=["--closed", "--frames", 3])
    for name, count in (("0.csv", 81), ("1.csv", 67)):
        note = f"{name}: 2 points are corners (number 1, {count}), and joints of G0 in all frames"
        assert note in " ".join(report["notes"]) and note in result.stdout
    orders = [[joint["order"] for joint in frame["joints"]] for frame in report["frames"]]
    assert all(order.count(0) == 2 for order in orders)
    # Corner corresponds to corner.
    for which in (0, -1):
        halfway = (np.array(sections[0][which]) + sections[1][which]) / 2
        assert np.linalg.norm(frames[0.5] - halfway, axis=1).min() < 1e-9
    # The edge between the corners is a line.
    edge = frames[0.5][frames[0.5][:, 0] > 85 - 1e-6]
    assert len(edge) > 4 and np.ptp(edge[:, 0]) < 2e-6


def test_a_half_circle_with_its_diameter(tmp_path):
    """Corners in the middle of the file; the arc is an arc up to them, also for an open curve."""
    def outline(count, radius, z):
        arc = [(radius * math.cos(math.pi * i / count), radius * math.sin(math.pi * i / count), z)
               for i in range(count + 1)]
        line = [(-radius + 2 * radius * i / 10, 0, z) for i in range(1, 10)]
        points = arc + line
        return points[5:] + points[:5]

    files = [points_file(tmp_path, outline(20, 10, 0), "a.csv"),
             points_file(tmp_path, outline(26, 10, 30), "b.csv")]
    result, report, frames = blend(tmp_path, *files, options=["--closed", "--frames", 3])
    assert "a.csv: 2 points are corners (number 16, 26)" in result.stdout
    for points in frames.values():
        on_arc = points[points[:, 1] > 1e-6]
        assert np.abs(np.hypot(on_arc[:, 0], on_arc[:, 1]) - 10).max() < 0.01
        for x in (-10, 10):
            assert np.abs(points[:, :2] - [x, 0]).sum(axis=1).min() < 1e-9


def test_given_pairs_name_points_of_curves_with_corners(tmp_path):
    sections = [airfoil(40, 0.12), airfoil(33, 0.16, 200, 70)]
    files = [points_file(tmp_path, p, f"{i}.csv") for i, p in enumerate(sections)]
    options = ["--closed", "--frames", 3, "--pair", "1,1", "--pair", "41,34", "--pair", "81,67"]
    _, report, frames = blend(tmp_path, *files, options=options)
    assert report["match"] == "pairs"
    for a, b in ((0, 0), (40, 33), (80, 66)):
        halfway = (np.array(sections[0][a]) + sections[1][b]) / 2
        assert np.linalg.norm(frames[0.5] - halfway, axis=1).min() < 1e-5


def test_sides_of_turned_rectangles_stay_straight(tmp_path):
    """The frame in the middle is the polygon of the means of the corners."""

    def corners_of(width, height, turn_deg):
        turn = math.radians(turn_deg)
        corners = [(0, 0), (width, 0), (width, height), (0, height)]
        return np.array(
            [
                (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn))
                for x, y in corners
            ]
        )

    keys = [corners_of(80, 50, 0), corners_of(40, 60, 20)]
    files = []
    for k, (corners, steps) in enumerate(zip(keys, (30, 21))):
        sides = zip(corners, np.roll(corners, -1, axis=0))
        points = [tuple(a + (b - a) * i / steps) for a, b in sides for i in range(steps)]
        files.append(points_file(tmp_path, points, f"key{k}.csv"))
    _, _, frames = blend(tmp_path, *files, options=["--closed"])
    means = np.column_stack([np.mean(keys, axis=0), np.zeros(4)])
    sides = list(zip(means, np.roll(means, -1, axis=0)))

    def distance(point, start, end):
        share = np.clip((point - start) @ (end - start) / np.sum((end - start) ** 2), 0, 1)
        return np.linalg.norm(start + share * (end - start) - point)

    off = max(min(distance(point, *side) for side in sides) for point in frames[0.5])
    assert off < 1e-3


def test_given_pairs_go_once_around_closed_curves(tmp_path):
    """The second curve is the first one, numbered from another corner on."""
    corners = [(0, 0), (40, 0), (40, 20), (0, 20)]
    points = [
        tuple(a + (b - a) * k / 10 for a, b in zip(corner, corners[(i + 1) % 4]))
        for i, corner in enumerate(corners)
        for k in range(10)
    ]
    first = points_file(tmp_path, points, "first.csv")
    second = points_file(tmp_path, points[15:] + points[:15], "second.csv")
    pairs = [f"{1 + 10 * k},{1 + (10 * k - 15) % 40}" for k in range(4)]
    options = ["--closed", *(text for pair in pairs for text in ("--pair", pair))]
    result, _, frames = blend(tmp_path, first, second, options=options)
    assert "4 given pairs correspond" in result.stdout
    assert all(np.allclose(frame, frames[0], atol=1e-9) for frame in frames.values())


def test_a_polygon_of_many_corners_is_named(tmp_path):
    def polygon(count, size, z):
        angles = [math.tau * i / count for i in range(count)]
        return [(2 * size * math.cos(a), size * math.sin(a), z) for a in angles]

    low = polygon_model(tmp_path / "low.step", polygon(80, 10, 0))
    high = polygon_model(tmp_path / "high.step", polygon(12, 8, 30))
    result, report, _ = blend(tmp_path, low, high, options=["--frames", 2])
    note = (f"{low}: a polygon with 80 corners, all of which stay in all frames. If it samples a "
            f"smooth curve, make one of it first: seamwright curve arcs {low} ")
    assert note in result.stdout and "12 corners" not in result.stdout
    # What the note says works, and has no corner.
    arcs = tmp_path / "smooth.step"
    assert run("curve", "arcs", low, "--tolerance", 0.05, "-o", arcs).returncode == 0
    result, report, _ = blend(tmp_path, arcs, arcs, options=["--frames", 2])
    orders = {joint["order"] for frame in report["frames"] for joint in frame["joints"]}
    assert 0 not in orders and "a polygon with" not in result.stdout


def test_between_two_curves_has_no_effect(tmp_path):
    points = [(0, 0), (10, 8), (25, 12), (40, 6)]
    files = [points_file(tmp_path, [(x, y + 20 * i) for x, y in points], f"{i}.csv")
             for i in range(3)]
    note = "--between C0 has no effect: there is no key curve between two"
    result, report, _ = blend(tmp_path, *files[:2], options=["--between", "C0", "--frames", 3])
    assert note in report["notes"] and note in result.stdout
    assert "no effect" not in blend(tmp_path, *files[:2])[0].stdout
    assert "no effect" not in blend(tmp_path, *files, options=["--between", "C0"])[0].stdout


def test_lengths_are_taken_where_features_mislead(tmp_path):
    """In order the faint corner of one curve would be the right angle of the other."""
    low = polygon_model(tmp_path / "low.step", [(0, 0, 0), (33, 5, 0), (50, 0, 0), (50, 50, 0)],
                        closed=False)
    high = polygon_model(tmp_path / "high.step", [(0, 0, 9), (50, 0, 9), (55, 17, 9), (50, 50, 9)],
                         closed=False)
    result, report, _ = blend(tmp_path, low, high, options=["--frames", 2])
    assert report["match"] == "length"
    assert ", by equal shares of the length: with jumps and extrema" in result.stdout
    _, report, frames = blend(tmp_path, low, low, options=["--frames", 2])
    assert report["match"] == "features"
