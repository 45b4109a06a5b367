# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve: what it writes."""

import math
import random
import re
import xml.etree.ElementTree

import pytest

from command import expect_one_line, run
from curves import CIRCLE, METHODS, VALIDATOR, WAVE, curve, points_file, rows_of
from drawings import dxf_entities, dxf_samples
from schemas import expect_every_key_matters


def distance(point, samples):
    return min(math.dist(point, sample) for sample in samples)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "out", ["out.dxf", "out.svg", "out.csv", "out.step", "out.igs", "out.brep", "out.bin"]
)
def test_every_method_writes_every_format(tmp_path, method, out):
    result, report, written = curve(method, points_file(tmp_path, WAVE), out=out)
    # The wave has inflections, where conics can't be G2.
    verdict = "REACHED WITH RESERVATIONS" if method == "conic" else "REACHED"
    assert result.returncode == 0 and result.stdout.endswith(f"\n{verdict}\n"), result.stdout
    assert written.stat().st_size > 0 and report["reached"]
    assert report["output"]["path"] == str(written)
    assert report["curves"][0]["distance_mm"] <= 0.01


@pytest.mark.parametrize("tolerance", [0, 0.001, 0.1])
def test_arcs_pass_near_the_points(tmp_path, tolerance):
    _, report, out = curve("arcs", points_file(tmp_path, WAVE), "--tolerance", tolerance)
    samples = dxf_samples(out.read_text())
    # Samples of an arc are at most 0.2 mm apart.
    assert max(distance(point, samples) for point in WAVE) <= tolerance + 0.1
    (found,) = report["curves"]
    assert found["points"] == 20 and found["pieces"] == (38 if tolerance == 0 else found["pieces"])
    ends = samples[0], samples[-1]
    assert max(math.dist(a, b) for a, b in zip(ends, (WAVE[0], WAVE[-1]))) < 1e-9


def test_a_larger_tolerance_needs_fewer_arcs(tmp_path):
    points = points_file(tmp_path, WAVE)
    counts = [
        curve("arcs", points, "--tolerance", t)[1]["curves"][0]["pieces"] for t in (1e-3, 1e-2, 0.1)
    ]
    assert counts == sorted(counts, reverse=True) and counts[0] > 2 * counts[-1]


def test_points_of_a_circle_are_a_circle(tmp_path):
    given = points_file(tmp_path, CIRCLE)
    _, report, out = curve("arcs", given, "--closed")
    ((name, groups),) = dxf_entities(out.read_text())
    assert name == "CIRCLE"
    assert (groups[10], groups[20], groups[40]) == pytest.approx((3, 4, 10))
    assert report["curves"][0]["after"]["inflections"] == 0


def arc_points(count, spacing=1.0):
    """Points of a quarter of a circle; spacing: a power of the even parameters."""
    turns = [math.pi / 2 * (i / (count - 1)) ** spacing for i in range(count)]
    return [(3 + 50 * math.cos(turn), 4 + 50 * math.sin(turn)) for turn in turns]


@pytest.mark.parametrize("count, spacing", [(3, 1), (9, 1), (33, 1), (91, 1), (33, 1.5)])
def test_points_of_an_open_arc_are_this_arc(tmp_path, count, spacing):
    given = points_file(tmp_path, arc_points(count, spacing))
    _, report, out = curve("arcs", given)
    ((name, groups),) = dxf_entities(out.read_text())
    assert name == "ARC" and (groups[10], groups[20], groups[40]) == pytest.approx((3, 4, 50))
    (found,) = report["curves"]
    assert found["before"]["extrema"] == 0 and found["notes"] == []
    (found,) = curve("clothoid", given)[1]["curves"]
    assert found["after"]["extrema"] == found["after"]["inflections"] == 0
    assert found["after"]["energy_per_mm"] == pytest.approx(math.pi / 100, rel=1e-6)


@pytest.mark.parametrize(
    "points, options, box",
    [
        ([(50 * x, 50 * y) for x, y in CIRCLE], ["--closed"], (-350, -300, 650, 700)),
        (arc_points(9), [], (3, 4, 53, 54)),
        ([(0, 1), (3, 5)], [], (0, 1, 3, 5)),
    ],
)
def test_the_box_of_an_svg_is_tight(tmp_path, points, options, box):
    _, _, out = curve("arcs", points_file(tmp_path, points), *options, out="out.svg")
    x, y, width, height = map(
        float, re.search('viewBox="([^"]*)"', out.read_text()).group(1).split()
    )
    border = 0.05 * max(box[2] - box[0], box[3] - box[1])
    # Its y axis points downwards.
    expected = (box[0] - border, -box[3] - border, box[2] - box[0], box[3] - box[1])
    assert (x, y, width - 2 * border, height - 2 * border) == pytest.approx(expected)


@pytest.mark.parametrize("steps", [8, 30])
def test_samples_of_a_stadium_are_its_lines_and_arcs(tmp_path, steps):
    """Also if the polygon of the points is further from the arcs than the tolerance."""
    points = []
    for side in (1, -1):
        points += [(side * (-20 + 40 * k / steps), -10 * side) for k in range(steps)]
        angles = [math.pi * (k / steps - 0.5) for k in range(steps)]
        points += [(side * (20 + 10 * math.cos(a)), side * 10 * math.sin(a)) for a in angles]
    rounded = [(round(x, 4), round(y, 4)) for x, y in points]
    result, report, out = curve("arcs", points_file(tmp_path, rounded), "--closed", out="out.csv")
    assert result.returncode == 0 and ": 2 arcs and 2 lines, " in result.stdout
    (found,) = report["curves"]
    assert found["distance_mm"] < 1e-3 and "samples of these lines and arcs" in found["notes"][0]
    assert found["after"]["length_mm"] == pytest.approx(80 + 20 * math.pi, abs=0.01)


@pytest.mark.parametrize("first", [0, 5])
def test_samples_of_a_rectangle_are_its_sides(tmp_path, first):
    corners = [(0, 0), (40, 0), (40, 20), (0, 20)]
    points = [
        tuple(round(a + (b - a) * k / 50, 3) for a, b in zip(corner, corners[(i + 1) % 4]))
        for i, corner in enumerate(corners)
        for k in range(50)
    ]
    given = points_file(tmp_path, points[first:] + points[:first])
    result, report, out = curve("arcs", given, "--closed", "--tolerance", "0.1", out="out.csv")
    assert ": 0 arcs and 4 lines, " in result.stdout
    (found,) = report["curves"]
    assert found["corners"] == 4 and found["distance_mm"] < 1e-9
    ends = [(float(row["x0"]), float(row["y0"])) for row in rows_of(out)]
    assert all(distance(corner, ends) < 1e-9 for corner in corners)


@pytest.mark.parametrize("first", [0, 1, 37, 80, 105])
def test_samples_with_errors_have_no_start(tmp_path, first):
    errors = random.Random(5)
    points = []
    for side in (1, -1):
        points += [(side * (k - 20), -10 * side) for k in range(40)]
        angles = [math.pi * (k / 30 - 0.5) for k in range(30)]
        points += [(side * (20 + 10 * math.cos(a)), side * 10 * math.sin(a)) for a in angles]
    points = [tuple(c + errors.uniform(-0.03, 0.03) for c in point) for point in points]
    given = points_file(tmp_path, points[first:] + points[:first])
    result, report, _ = curve("arcs", given, "--closed", "--tolerance", "0.05")
    assert ": 2 arcs and 2 lines, " in result.stdout
    (found,) = report["curves"]
    assert found["corners"] == 0
    assert found["after"]["length_mm"] == pytest.approx(80 + 20 * math.pi, abs=0.05)


def polygon(count):
    turns = [math.tau * (i + 0.5) / count for i in range(count)]
    return [(3 + 20 * math.cos(turn), 4 + 20 * math.sin(turn)) for turn in turns]


@pytest.mark.parametrize("count", [4, 8])
def test_corners_can_be_all_points(tmp_path, count):
    given = points_file(tmp_path, polygon(count))
    note = f"turn by {360 / count:.0f} degrees on average"
    result, report, _ = curve("arcs", given, "--closed")
    assert result.stdout.count(note) == 1 and "give --polygon\n" in result.stdout
    assert report["curves"][0]["lines"] == 0
    _, report, out = curve("arcs", given, "--closed", "--polygon", out="out.csv")
    (found,) = report["curves"]
    assert found["lines"] == found["pieces"] == found["corners"] == count
    assert found["notes"] == [] and found["distance_mm"] == 0
    assert found["after"]["length_mm"] == pytest.approx(40 * count * math.sin(math.pi / count))
    starts = [(float(row["x0"]), float(row["y0"])) for row in rows_of(out)]
    assert starts == pytest.approx(polygon(count))


def test_points_of_curves_have_no_note_about_corners(tmp_path):
    for points in (CIRCLE, polygon(11)):
        assert "--polygon" not in curve("arcs", points_file(tmp_path, points), "--closed")[0].stdout
    assert "--polygon" not in curve("arcs", points_file(tmp_path, WAVE))[0].stdout


def test_an_open_polygon_has_its_ends(tmp_path):
    given = points_file(tmp_path, [(0, 0), (10, 0), (20, 0), (20, 10)])
    (found,) = curve("arcs", given, "--polygon")[1]["curves"]
    # At the second point the line goes straight on.
    assert (found["pieces"], found["lines"], found["corners"]) == (3, 3, 1)


@pytest.mark.parametrize("tolerance", ["0", "0.001", "0.05"])
def test_arcs_of_an_airfoil_have_a_corner_at_its_sharp_end(tmp_path, tolerance):
    outline = naca(0.12, 60, chord=100)
    given = points_file(tmp_path, outline)
    _, report, out = curve("arcs", given, "--closed", "--tolerance", tolerance, out="out.dxf")
    (found,) = report["curves"]
    assert found["closed"] and found["corners"] == 1
    samples = dxf_samples(out.read_text())
    assert distance(max(outline), samples) < 1e-9
    assert found["distance_mm"] <= float(tolerance) + 1e-9


def test_two_points_are_a_line(tmp_path):
    given = points_file(tmp_path, [(0, 1), (3, 5)])
    ((name, groups),) = dxf_entities(curve("arcs", given)[2].read_text())
    assert name == "LINE"
    assert (groups[10], groups[20], groups[11], groups[21]) == pytest.approx((0, 1, 3, 5))


def test_a_closed_outline_is_closed(tmp_path):
    points = [(0, 0), (4, -1), (9, 0), (10, 4), (6, 7), (1, 5)]
    given = points_file(tmp_path, points)
    result, report, out = curve("arcs", given, "--closed", "--tolerance", "0")
    assert report["curves"][0]["closed"] and ", closed: " in result.stdout
    polyline = next(groups for name, groups in dxf_entities(out.read_text()) if name == "POLYLINE")
    assert polyline[70] == 1
    samples = dxf_samples(out.read_text())
    assert math.dist(samples[0], samples[-1]) < 1e-9
    assert max(distance(point, samples) for point in points) < 1e-9
    # The first point given again at the end is no other point.
    again = points_file(tmp_path, [*points, points[0]], "again.csv")
    assert curve("arcs", again, "--closed", "--tolerance", "0")[1]["curves"] == report["curves"]


def test_svg_has_the_arcs_of_the_table(tmp_path):
    given = points_file(tmp_path, WAVE)
    svg = curve("arcs", given, out="out.svg")[2]
    (path,) = xml.etree.ElementTree.parse(svg).getroot().iter("{http://www.w3.org/2000/svg}path")
    rows = rows_of(curve("arcs", given, out="out.csv")[2])
    arcs = re.findall(r"A (\S+) \S+ 0 0 ([01]) (\S+) (\S+)", path.get("d"))
    assert len(arcs) == sum(1 for row in rows if row["radius"])
    for (radius, left, x, y), row in zip(arcs, (row for row in rows if row["radius"])):
        assert float(radius) == float(row["radius"])
        assert (left == "1") == (float(row["sweep_deg"]) > 0)
        assert (float(x), float(y)) == pytest.approx((float(row["x1"]), float(row["y1"])))


def test_clothoids_of_the_table_join(tmp_path):
    rows = rows_of(curve("clothoid", points_file(tmp_path, WAVE), out="out.csv")[2])
    assert len(rows) == 19
    for row, after, point in zip(rows, rows[1:], WAVE):
        assert (float(row["x"]), float(row["y"])) == pytest.approx(point, abs=1e-12)
        end = float(row["curvature_per_mm"]) + float(row["curvature_slope_per_mm2"]) * float(
            row["length_mm"]
        )
        assert end == pytest.approx(float(after["curvature_per_mm"]), abs=1e-9)


def test_conics_of_the_table_are_g2(tmp_path):
    given = points_file(tmp_path, [(math.cos(t / 5) * 20, math.sin(t / 5) * 12) for t in range(12)])
    rows = rows_of(curve("conic", given, "--tolerance", "0.05", out="out.csv")[2])

    def curvature(row, start):
        x0, y0, cx, cy, x1, y1, w = (float(row[key]) for key in list(row)[1:])
        area = ((cx - x0) * (y1 - y0) - (cy - y0) * (x1 - x0)) / 2
        leg = math.hypot(cx - x0, cy - y0) if start else math.hypot(x1 - cx, y1 - cy)
        return area / (w * w * leg**3)

    joints = [(curvature(a, False), curvature(b, True)) for a, b in zip(rows, rows[1:])]
    same_turn = [(a, b) for a, b in joints if a * b > 0]
    assert len(same_turn) > 2
    assert all(a == pytest.approx(b, rel=1e-9) for a, b in same_turn)


def conic_curvatures(rows, count=200):
    """Curvatures along the conics of a table, by differences of the homogeneous polynomials."""
    for row in rows:
        a, c, b = (
            complex(float(row[x]), float(row[y]))
            for x, y in (("x0", "y0"), ("corner_x", "corner_y"), ("x1", "y1"))
        )
        w = float(row["weight"])
        for k in range(count + 1):
            t = k / count
            p, q = (1 - t) ** 2 * a + 2 * w * t * (1 - t) * c + t * t * b, (
                (1 - t) ** 2 + 2 * w * t * (1 - t) + t * t
            )
            dp = 2 * ((1 - t) * (w * c - a) + t * (b - w * c))
            dq = 2 * ((1 - t) * (w - 1) + t * (1 - w))
            ddp, ddq = 2 * (a - 2 * w * c + b), 2 * (2 - 2 * w)
            z = p / q
            first = (dp - z * dq) / q
            second = (ddp - 2 * first * dq - z * ddq) / q
            yield (first.conjugate() * second).imag / abs(first) ** 3


def convex_points(random, count):
    """The corners of a random convex polygon: random edges in the order of their directions."""
    edges = [complex(random.uniform(-1, 1), random.uniform(-1, 1)) for _ in range(count)]
    mean = sum(edges) / count
    place, points = 0j, []
    for edge in sorted((e - mean for e in edges), key=lambda e: math.atan2(e.imag, e.real)):
        points.append((10 * place.real, 10 * place.imag))
        place += edge
    return points


@pytest.mark.parametrize("count", [5, 9, 17, 33, 60])
@pytest.mark.parametrize("closed", [False, True])
def test_conics_through_points_in_convex_position_are_convex(tmp_path, count, closed):
    points = convex_points(random.Random(count), count)
    points = points if closed else points[: 2 + count // 2]
    options = ["--closed"] if closed else []
    given = points_file(tmp_path, points)
    _, report, out = curve("conic", given, "--tolerance", 0, *options, out="out.csv")
    rows = rows_of(out)
    assert min(conic_curvatures(rows)) > 0
    joints = [complex(float(row["x0"]), float(row["y0"])) for row in rows]
    assert all(min(abs(complex(*p) - z) for z in joints) < 1e-12 for p in points[:-1])
    (found,) = report["curves"]
    assert found["after"]["inflections"] == 0 and found["distance_mm"] == 0
    assert not any("G1" in note for note in found["notes"])
    # Conics that got their curvature from joint to joint had three times as many extrema.
    assert found["after"]["extrema"] <= found["before"]["extrema"] + 6


def test_few_points_in_convex_position_have_few_extrema(tmp_path):
    given = points_file(tmp_path, [(0, 0), (8, 14), (30, 26), (62, 28), (95, 18), (120, 0)])
    _, report, _ = curve("conic", given)
    (found,) = report["curves"]
    assert found["after"]["extrema"] <= found["before"]["extrema"]
    assert found["after"]["inflections"] == 0 and not found["notes"]


def test_conics_say_where_they_are_not_g2(tmp_path):
    result, report, _ = curve("conic", points_file(tmp_path, WAVE), "--tolerance", 0)
    (found,) = report["curves"]
    assert result.stdout.endswith("\nREACHED WITH RESERVATIONS\n") and report["reached"]
    assert any("G1 only" in note for note in found["notes"])
    assert found["after"]["inflections"] == found["before"]["inflections"]


def test_fair_points_move_within_the_tolerance(tmp_path):
    rough = [(x, y + 0.05 * (-1) ** (i % 3)) for i, (x, y) in enumerate(WAVE)]
    _, report, out = curve(
        "fair", points_file(tmp_path, rough), "--tolerance", "0.08", out="out.csv"
    )
    moved = [
        math.dist(point, (float(row["x"]), float(row["y"])))
        for point, row in zip(rough, rows_of(out), strict=True)
    ]
    (found,) = report["curves"]
    assert max(moved) <= 0.08 and max(moved) == pytest.approx(found["moved_mm"])
    assert found["after"]["variation_per_mm3"] < found["before"]["variation_per_mm3"]
    assert found["after"]["extrema"] <= found["before"]["extrema"]
    # The table is an input again.
    assert curve("fair", out, "--tolerance", "0", out="again.csv")[1]["curves"][0]["moved_mm"] == 0


def naca(thickness, count, *, sharp=True, chord=100):
    """An outline of a symmetric airfoil, rounded to 3 decimals; a sharp end is one point."""
    last = -0.1036 if sharp else -0.1015
    sides = []
    for i in range(count):
        x = (1 - math.cos(math.pi * i / (count - 1))) / 2
        y = 0.2969 * math.sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 + x * last)))
        sides.append((round(chord * x, 3), round(5 * chord * thickness * y, 3)))
    upper, lower = sides[::-1], [(x, -y) for x, y in sides[1:]]
    return [*upper, *(lower[:-1] if sharp else lower)]


def step_splines(text):
    """Degree, knots and poles of the B-splines of a STEP file, in its order."""
    text = re.sub(r"\s", "", text)
    poles = {
        name: tuple(float(x) for x in values.split(","))
        for name, values in re.findall(r"(#\d+)=CARTESIAN_POINT\('[^']*',\(([^)]*)\)\)", text)
    }
    for degree, names, counts, knots in re.findall(
        r"B_SPLINE_CURVE_WITH_KNOTS\('[^']*',(\d+),\(([^)]*)\),[^(]*\(([^)]*)\),\(([^)]*)\)", text
    ):
        repeated = [
            float(knot)
            for count, knot in zip(counts.split(","), knots.split(","))
            for _ in range(int(count))
        ]
        yield int(degree), repeated, [poles[name][:2] for name in names.split(",")]


def de_boor(degree, knots, poles, t):
    span = max(i for i in range(degree, len(poles)) if knots[i] <= t)
    d = [poles[i] for i in range(span - degree, span + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[j + span - degree], knots[j + 1 + span - r]
            a = (t - low) / (high - low)
            d[j] = tuple((1 - a) * p + a * q for p, q in zip(d[j - 1], d[j]))
    return d[degree]


def sides_of(points):
    """The signs of the turns of a polygon, without repetition; turns that are rounding skipped."""
    signs = []
    for (ax, ay), (bx, by), (cx, cy) in zip(points, points[1:], points[2:]):
        turn = (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
        size = math.dist((ax, ay), (bx, by)) * math.dist((bx, by), (cx, cy))
        if abs(turn) > 1e-9 * size and (not signs or (turn > 0) != signs[-1]):
            signs.append(turn > 0)
    return signs


@pytest.mark.parametrize(
    "thickness, count, tolerance, chord", [(0.12, 35, 0.05, 100), (0.08, 61, 0.5, 200)]
)
def test_a_faired_airfoil_turns_to_one_side(tmp_path, thickness, count, tolerance, chord):
    outline = naca(thickness, count, chord=chord)
    given = points_file(tmp_path, outline)
    _, report, out = curve("fair", given, "--closed", "--tolerance", tolerance, out="out.step")
    (found,) = report["curves"]
    assert found["after"]["inflections"] == 0 and found["corners"] == 1
    assert all("can come from the rounding of the points" in note for note in found["notes"])
    assert found["after"]["extrema"] <= 3
    assert found["after"]["variation_per_mm3"] < found["before"]["variation_per_mm3"]
    assert found["moved_mm"] <= tolerance
    ((degree, knots, poles),) = step_splines(out.read_text())
    samples = []
    for low, high in zip(sorted(set(knots)), sorted(set(knots))[1:]):
        samples += [
            de_boor(degree, knots, poles, low + (high - low) * (k + 0.5) / 8) for k in range(8)
        ]
    assert len(sides_of(samples)) == 1
    # The sharp end stays.
    start, end = poles[0], poles[-1]
    assert math.dist(start, outline[0]) < 1e-6 and math.dist(end, outline[0]) < 1e-6


def end_turns_deg(rows, exact, count=4):
    """How far the outer chords of a curve turn from those of the exact points, in degrees."""

    def turn(i, j):
        a, b = (
            math.atan2(points[j][1] - points[i][1], points[j][0] - points[i][0])
            for points in (rows, exact)
        )
        return abs(math.degrees(math.remainder(a - b, math.tau)))

    last = len(rows) - 1
    return max(max(turn(k, k + 1), turn(last - k - 1, last - k)) for k in range(count))


def test_free_ends_have_no_hooks(tmp_path):
    exact = naca(0.12, 20, sharp=False)
    held_deg = free_deg = 0
    for seed in range(5):
        noise = random.Random(seed)
        read = [(x, y + noise.uniform(-0.03, 0.03)) for x, y in exact]
        read[0], read[-1] = ((x, y + 0.1) for x, y in (exact[0], exact[-1]))
        given = points_file(tmp_path, read)
        turns = []
        for options in ([], ["--free-ends"]):
            out = curve("fair", given, "--tolerance", "0.06", *options, out="out.csv")[2]
            rows = [(float(row["x"]), float(row["y"])) for row in rows_of(out)]
            assert all(math.dist(p, q) <= 0.06 for p, q in zip(read, rows))
            stays = [rows[0] == read[0], rows[-1] == read[-1]]
            assert stays == ([False, False] if options else [True, True])
            turns.append(end_turns_deg(rows, exact))
        held_deg += turns[0]
        free_deg += turns[1]
    assert held_deg > 3 * free_deg


def test_conics_of_an_airfoil_have_a_corner_at_its_sharp_end(tmp_path):
    outline = naca(0.12, 40, chord=100)
    given = points_file(tmp_path, outline)
    _, report, _ = curve("conic", given, "--closed", "--tolerance", 0, out="out.step")
    (found,) = report["curves"]
    assert found["closed"] and found["corners"] == 1 and found["distance_mm"] == 0
    assert found["after"]["inflections"] == 0
    assert found["after"]["length_mm"] == pytest.approx(found["before"]["length_mm"], rel=1e-4)


def test_a_tolerance_of_0_returns_the_points(tmp_path):
    outline = naca(0.12, 20, sharp=False)
    given = points_file(tmp_path, outline)
    _, report, out = curve("fair", given, "--closed", "--tolerance", "0", out="out.csv")
    assert [(float(row["x"]), float(row["y"])) for row in rows_of(out)] == outline
    (found,) = report["curves"]
    assert found["before"] == found["after"] and found["moved_mm"] == 0 and found["corners"] == 2


def test_inflections_that_the_points_do_not_have_are_noted(tmp_path):
    points = [(4, -1), (9, 0), (10, 4), (6, 7), (1, 5), (0, 0)]
    _, report, _ = curve("fair", points_file(tmp_path, points), "--closed", "--tolerance", "0.02")
    (found,) = report["curves"]
    assert found["after"]["inflections"] == 2 and found["corners"] == 0
    assert found["notes"] == ["2 more inflections than the circles through three faired points"]


def test_points_of_space_stay_in_their_plane(tmp_path):
    points = [(1 + x, 2 + 0.6 * y, 3 + 0.8 * y) for x, y in WAVE]
    given = points_file(tmp_path, points)
    _, report, out = curve("arcs", given, "--tolerance", "0", out="out.step")
    plane = report["curves"][0]["plane"]
    for point in points:
        offset = [a - b for a, b in zip(point, plane["origin"])]
        u, v = (sum(a * b for a, b in zip(offset, plane[axis])) for axis in "xy")
        back = [
            o + u * a + v * b for o, a, b in zip(plane["origin"], plane["x"], plane["y"])
        ]
        assert math.dist(back, point) < 1e-9
    (again,) = curve("arcs", out, out="again.step")[1]["curves"]
    assert again["distance_mm"] <= 0.01 and again["pieces"] <= 38


@pytest.mark.parametrize("out", ["out.step", "out.igs", "out.brep"])
@pytest.mark.parametrize("method", METHODS)
def test_a_model_of_curves_is_an_input(tmp_path, method, out):
    model = curve("arcs", points_file(tmp_path, CIRCLE[:7]), out=out)[2]
    result, report, _ = curve(method, model, out="again.brep")
    assert result.returncode == 0, result.stdout
    (found,) = report["curves"]
    assert found["edges"] and found["points"] == 0 and not found["closed"]
    assert found["after"]["length_mm"] == pytest.approx(10 * math.pi, rel=1e-2)


def uneven_model(tmp_path):
    """A spline near a circle of 50 mm, with waves of 0.004 mm and uneven pieces."""
    points, angle = [], 0
    for i in range(30):
        angle += 0.02 if i % 3 else 0.11
        radius = 50 + 0.004 * math.sin(i * i)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return curve("clothoid", points_file(tmp_path, points), out="uneven.step")[2]


def test_conics_near_a_model_do_not_follow_its_waves(tmp_path):
    result, report, _ = curve("conic", uneven_model(tmp_path), "--tolerance", 0.03)
    (found,) = report["curves"]
    assert found["before"]["extrema"] >= 20 and found["distance_mm"] <= 0.03
    assert found["after"]["extrema"] <= found["before"]["extrema"] / 3
    assert found["after"]["inflections"] == 0 and result.stdout.endswith("\nREACHED\n")


@pytest.mark.parametrize("tolerance", [1e-4, 0.01, 0.3])
def test_a_faired_spline_is_never_less_fair(tmp_path, tolerance):
    _, report, _ = curve("fair", uneven_model(tmp_path), "--tolerance", tolerance)
    (found,) = report["curves"]
    for key in ("extrema", "inflections", "energy_per_mm"):
        assert found["after"][key] <= found["before"][key] * (1 + 1e-9), key


def test_conics_pass_beside_an_inflection_near_a_point(tmp_path):
    # Of an airfoil: the angles beside the inflection have a ratio of 200.
    points = [
        (1, 0),
        (0.9967185, 0.00034782),
        (0.98706463, 0.00149967),
        (0.97145561, 0.00363339),
        (0.95035123, 0.00677805),
        (0.92424036, 0.0108692),
        (0.8936239, 0.0157696),
        (0.85900629, 0.02129402),
        (0.82089086, 0.02721967),
    ]
    given = points_file(tmp_path, points)
    result, report, _ = curve("conic", given, "--tolerance", 0, out="out.step")
    assert result.returncode == 0, result.stderr
    (found,) = report["curves"]
    assert found["after"]["inflections"] == 1


def test_conics_near_points_are_within_the_tolerance_and_fairer(tmp_path):
    rough = [(x, y + 0.1 * (-1) ** (i % 3)) for i, (x, y) in enumerate(WAVE)]
    given = points_file(tmp_path, rough)
    through = curve("conic", given, "--tolerance", 0)[1]["curves"][0]
    _, report, out = curve("conic", given, "--tolerance", 0.2, out="out.csv")
    (found,) = report["curves"]
    assert 0 < found["distance_mm"] <= 0.2
    assert found["after"]["extrema"] < through["after"]["extrema"]
    samples = []
    for row in rows_of(out):
        x0, y0, cx, cy, x1, y1, w = (float(row[key]) for key in list(row)[1:])
        for k in range(401):
            t = k / 400
            a, b, c = (1 - t) ** 2, 2 * w * t * (1 - t), t * t
            q = a + b + c
            samples.append(((a * x0 + b * cx + c * x1) / q, (a * y0 + b * cy + c * y1) / q))
    assert max(min(math.dist(p, s) for s in samples) for p in rough) <= 0.201


def test_edges_are_chosen(box):
    result = run("curve", "arcs", box, "-o", box.parent / "out.dxf")
    expect_one_line(result, "has no free edges: name edges with --edge, or take --edge all")
    _, report, _ = curve("arcs", box, "--edge", "Edge1,2")
    assert sorted(edge for found in report["curves"] for edge in found["edges"]) == [1, 2]
    _, report, _ = curve("arcs", box, "--edge", "all", out="out.step")
    assert [found["edges"] for found in report["curves"]] == [[i] for i in range(1, 13)]
    assert all(found["lines"] == found["pieces"] == 1 for found in report["curves"])


def test_every_key_of_the_report_matters(tmp_path):
    report = curve("arcs", points_file(tmp_path, WAVE))[1]
    for optional in ("notes",):
        report["curves"][0][optional] = []
    report["model"]["notes"] = []
    expect_every_key_matters(
        {
            **report,
            "curves": [{**report["curves"][0], "edges": [1]}],
            "refused": [{"edges": [2], "reason": "why"}],
        },
        VALIDATOR,
    )
