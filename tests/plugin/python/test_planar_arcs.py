# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs, chains, biarcs and arcs near curves, through Python: closed forms and dense samples."""

import math

import numpy as np
import pytest
import seamwright
from planar_samples import circle_points, distances, ends_of, moved, turned, wrapped
from seamwright import ArcChain, PlanarArc
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_planar_arcs.py"))
CUBIC = seamwright.BezierCurve([[0, 0, 0], [10, 15, 0], [20, -15, 0], [30, 5, 0]])


def expect_ends(chain, start, start_rad, end, end_rad):
    assert np.abs(chain.point(0) - start).max() < 1e-12
    assert np.abs(chain.point(chain.length_mm) - end).max() < 1e-11
    assert abs(wrapped(chain.direction_at_rad(0) - start_rad)) < 1e-12
    assert abs(wrapped(chain.direction_at_rad(chain.length_mm) - end_rad)) < 1e-11


def expect_g1(chain):
    for before, after in zip(chain.arcs, chain.arcs[1:]):
        assert np.linalg.norm(before.end - after.start) < 1e-10
        assert abs(wrapped(before.end_direction_rad - after.direction_rad)) < 1e-8


# Arcs


def test_an_arc_is_part_of_its_circle():
    arc = PlanarArc([1, 2], 0, 0.5, 2 * math.pi)  # half of the circle of radius 2 around (1, 4)
    s = np.linspace(0, arc.length_mm, 9).reshape(3, 3)
    points = arc.point(s)
    assert points.shape == (3, 3, 2)
    assert np.abs(np.linalg.norm(points - [1, 4], axis=-1) - 2).max() < 1e-15
    assert np.abs(arc.end - [1, 6]).max() < 1e-14 and arc.sweep_rad == math.pi
    assert np.array_equal(arc.direction_at_rad(s), s / 2)
    assert arc.direction_at_rad(1) == 0.5 and isinstance(arc.direction_at_rad(1), float)
    assert np.array_equal(arc.curvature_at_per_mm(s), np.full((3, 3), 0.5))
    assert np.array_equal(arc.point(1.0), arc.point(np.array(1.0))) and arc.point(1).shape == (2,)
    assert repr(arc) == "<PlanarArc of 6.283185307179586 mm, curvature 0.5 / mm>"


def test_lines_and_nearly_straight_arcs():
    line = PlanarArc([0, 0], math.pi / 2, 0, 3)
    assert np.abs(line.point([0, 1, 3]) - [[0, 0], [0, 1], [0, 3]]).max() < 1e-15
    flat = PlanarArc([0, 0], 0, 1e-12, 1000)
    assert flat.end[1] == pytest.approx(1e-12 * 1000**2 / 2, rel=1e-12)


def test_reversed_and_offset_arcs():
    arc = PlanarArc([1, 2], 0.3, -0.2, 5)
    s = np.linspace(0, 5, 7)
    assert np.abs(arc.reversed().point(s) - arc.point(5 - s)).max() < 1e-14
    for distance in (-0.7, 2.0):
        other = arc.offset(distance)
        share = np.linspace(0, 1, 5)
        direction = arc.direction_at_rad(5 * share)
        normal = np.stack([-np.sin(direction), np.cos(direction)], axis=-1)
        expected = arc.point(5 * share) + distance * normal
        assert np.abs(other.point(other.length_mm * share) - expected).max() < 1e-14
    with pytest.raises(ValueError, match="reaches the centre"):
        arc.offset(-5)


def test_an_arc_as_a_spline_has_the_same_points_and_the_arc_length_at_its_knots():
    arc = PlanarArc([3, -1], 1, -0.5, 11)  # turns by 5.5 rad
    spline = arc.bezier_spline()
    assert spline.segments == 3 and spline.is_rational and spline.knots[-1] == 11
    assert np.abs(spline.point(spline.knots)[:, :2] - arc.point(spline.knots)).max() < 1e-14
    centre = arc.start + 2 * np.array([math.sin(1), -math.cos(1)])
    points = spline.point(np.linspace(0, 11, 200))
    assert np.abs(np.linalg.norm(points[:, :2] - centre, axis=1) - 2).max() < 1e-14
    assert np.all(points[:, 2] == 0)
    assert seamwright.arc_length(spline, 1e-10).value_mm == pytest.approx(11, abs=1e-10)


def test_the_arc_through_a_point():
    for _ in range(50):
        start, direction, end, _ = ends_of(RANDOM)
        arc = seamwright.arc_through(start, direction, end)
        assert np.array_equal(arc.start, start) and arc.direction_rad == direction
        assert np.linalg.norm(arc.end - end) < 1e-12 * max(1, arc.length_mm)
    half = seamwright.arc_through([0, 0], math.pi / 2, [-2, 0])
    assert half.curvature_per_mm == pytest.approx(1) and half.length_mm == pytest.approx(math.pi)


# Chains


def square_with_round_corners(side, radius):
    """Counter-clockwise, from the beginning of the lower side."""
    arcs, point, direction = [], np.array([radius, 0.0]), 0.0
    for _ in range(4):
        arcs.append(PlanarArc(point, direction, 0, side - 2 * radius))
        arcs.append(PlanarArc(arcs[-1].end, direction, 1 / radius, radius * math.pi / 2))
        point, direction = arcs[-1].end, direction + math.pi / 2
    return ArcChain(arcs, closed=True)


def test_a_chain_has_the_parameter_of_its_arcs():
    chain = square_with_round_corners(10, 2)
    length = 4 * 6 + 4 * math.pi
    assert len(chain) == len(chain.arcs) == 8 and chain.closed and chain.corners == []
    assert chain.length_mm == pytest.approx(length, rel=1e-15)
    assert chain.energy_per_mm == pytest.approx(4 * math.pi / 4, rel=1e-14)
    assert np.abs(chain.point([0, 3, 6, 6 + math.pi]) - [[2, 0], [5, 0], [8, 0], [10, 2]]).max() < (
        1e-14
    )
    # At a joint the later arc counts.
    assert chain.curvature_at_per_mm(6.0) == 0.5 and chain.curvature_at_per_mm(5.999) == 0
    spline = chain.bezier_spline()
    s = np.array(spline.knots)
    assert spline.closed and np.abs(spline.point(s)[:, :2] - chain.point(s)).max() < 1e-13
    assert all(joint.order_reached == 1 for joint in spline.measure_joints(2))
    assert repr(chain).startswith("<ArcChain of 8 arcs, 36.566") and repr(chain).endswith("closed>")


def test_offsets_of_a_chain():
    chain = square_with_round_corners(10, 2)
    inside, outside = chain.offset(1), chain.offset(-1)
    assert inside.length_mm == pytest.approx(chain.length_mm - 2 * math.pi)
    assert outside.length_mm == pytest.approx(chain.length_mm + 2 * math.pi)
    assert inside.closed and chain.offset(0) == chain
    assert inside.bezier_spline().closed
    with pytest.raises(ValueError, match="reaches the centre"):
        chain.offset(2)
    corner = ArcChain([PlanarArc([0, 0], 0, 0, 5), PlanarArc([5, 0], 1, 0, 5)], corners=[1])
    around = corner.offset(-2)
    assert len(around) == 3 and around.arcs[1].curvature_per_mm == 0.5
    assert np.abs(np.linalg.norm(around.arcs[1].point([0, 0.7]) - [5, 0], axis=1) - 2).max() < 1e-15
    assert corner.offset(0) == corner
    with pytest.raises(ValueError, match="inside of the corner before arc 1"):
        corner.offset(1)


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda: ArcChain([]), ValueError, r"arcs are \[\]: at least one is needed"),
        (lambda: ArcChain(3), TypeError, "arcs is 3: a sequence is needed"),
        (lambda: ArcChain("ab"), TypeError, "arcs is 'ab'"),
        (lambda: ArcChain([3]), TypeError, r"arcs\[0\] is 3: a PlanarArc is needed"),
        (
            lambda: ArcChain([PlanarArc([0, 0], 0, 0, 1), PlanarArc([2, 0], 0, 0, 1)]),
            ValueError,
            "the end of 0 is 1.0 mm from the start of 1",
        ),
        (
            lambda: ArcChain([PlanarArc([0, 0], 0, 0, 1)], closed=True),
            ValueError,
            "the end of 0 is 1.0 mm from the start of 0",
        ),
        (
            lambda: ArcChain([PlanarArc([0, 0], 0, 0, 1)], corners=[1]),
            ValueError,
            "value 1: the ch",
        ),
        (lambda: PlanarArc([0, 0], 0, 1, 0), ValueError, "length_mm is 0.0: it must be positive"),
        (lambda: PlanarArc([0, 0], 0, 1, 1e5), ValueError, "turns by 100000.0 rad: at most 10000"),
        (lambda: PlanarArc([0, math.nan], 0, 1, 1), ValueError, "start is .*: it must be finite"),
        (lambda: PlanarArc([0, 0, 0], 0, 1, 1), ValueError, "start is .*two numbers"),
        (lambda: PlanarArc([0, 0], math.inf, 1, 1), ValueError, "direction_rad is inf"),
        (lambda: PlanarArc([0, 0], 0, 0, 1).point(1.5), ValueError, "s_mm is 1.5: the curve has 0"),
        (
            lambda: PlanarArc([0, 0], 0, 0, 1).point([0, -1]),
            ValueError,
            "s_mm has the value -1.0: the curve has 0 .. 1.0",
        ),
        (lambda: seamwright.arc_through([1, 1], 0, [1, 1]), ValueError, "the same point"),
    ],
)
def test_bad_arcs(call, kind, text):
    with pytest.raises(kind, match=text):
        call()


# Samples


def sampled_slot(steps):
    """Points of a slot of 40 mm with half circles of 10 mm: two lines, two arcs, no corner."""
    along = np.arange(steps) / steps
    turns = math.pi * (along - 0.5)
    line = np.stack([40 * along, np.full(steps, -10.0)], axis=1)
    cap = np.stack([40 + 10 * np.cos(turns), 10 * np.sin(turns)], axis=1)
    half = np.concatenate([line, cap])
    return np.concatenate([half, [40, 0] - half])


def test_samples_of_lines_and_arcs_are_these():
    found = seamwright.sampled_arcs(sampled_slot(12), closed=True)
    assert sorted(round(arc.length_mm, 9) for arc in found.chain.arcs) == [
        round(10 * math.pi, 9), round(10 * math.pi, 9), 40, 40,
    ]  # fmt: skip
    assert found.chain.closed and found.chain.corners == [] and found.distance_mm < 1e-9


def test_corners_between_points_are_found():
    sides = np.repeat([[1, 0], [0, 1], [-1, 0], [0, -1]], (60, 40, 60, 40), axis=0)
    points = np.cumsum(sides, axis=0) - 0.4 * sides
    assert not np.any((points % 1 == 0).all(axis=1))
    found = seamwright.sampled_arcs(points, closed=True)
    assert sorted(tuple(np.round(arc.start, 9)) for arc in found.chain.arcs) == [
        (0, 0), (0, 40), (60, 0), (60, 40),
    ]  # fmt: skip
    assert found.chain.corners == [0, 1, 2, 3]


def test_points_of_other_curves_are_no_samples_of_arcs():
    turns = np.linspace(0, 2 * math.pi, 40, endpoint=False)
    ellipse = np.stack([30 * np.cos(turns), 10 * np.sin(turns)], axis=1)
    assert seamwright.sampled_arcs(ellipse, closed=True, tolerance_mm=1e-4) is None
    assert seamwright.point_corners(ellipse, closed=True) == []


def test_corners_of_points():
    outline = [[x, 0] for x in range(10)] + [[10, y] for y in range(8)]
    assert seamwright.point_corners(outline) == [10]
    assert seamwright.point_corners(outline, corner_rad=2) == []
    with pytest.raises(ValueError, match="2 points: at least 3"):
        seamwright.point_corners(outline[:2])
    with pytest.raises(ValueError, match="points 0 and 1 are equal"):
        seamwright.sampled_arcs([[0, 0], [0, 0], [1, 0]])


# Biarcs


@pytest.mark.parametrize("x", [0.1, 0.5, 0.8])
def test_a_biarc_meets_its_ends(x):
    for _ in range(30):
        ends = ends_of(RANDOM)
        found = seamwright.biarc(*ends, x=x)
        expect_ends(found.chain, *ends)
        expect_g1(found.chain)
        assert found.x == x and np.array_equal(found.joint_mm, found.chain.arcs[1].start)
        k = [arc.curvature_per_mm for arc in found.chain.arcs]
        assert found.is_convex == (k[0] * k[1] > 0)


def test_rules_of_biarcs():
    ends = ([0, 0], -0.6, [10, 0], 0.9)  # a C-shape below the chord
    x = np.linspace(0.01, 0.99, 2001)
    family = [[a.curvature_per_mm for a in seamwright.biarc(*ends, x=v).chain.arcs] for v in x]
    k = np.array(family)
    equal = seamwright.biarc(*ends, rule="equal chords")
    chords = [np.linalg.norm(a.end - a.start) for a in equal.chain.arcs]
    assert equal.x == 0.5 and chords[0] == pytest.approx(chords[1])
    assert abs(x[np.argmin(np.abs(k[:, 0] - k[:, 1]))] - 0.5) < 1e-3
    parallel = seamwright.biarc(*ends, rule="parallel")
    assert abs(wrapped(parallel.chain.arcs[1].direction_rad)) < 1e-15
    assert seamwright.biarc(*ends) == parallel == seamwright.biarc(*ends, rule="default")
    radii = seamwright.biarc(*ends, rule="least radius difference")
    convex = k[:, 0] * k[:, 1] > 0
    best = np.argmin(np.where(convex, np.abs(1 / k[:, 0] - 1 / k[:, 1]), np.inf))
    assert abs(radii.x - x[best]) < 2e-3
    s_shape = ([0, 0], 0.6, [10, 0], 0.5)
    assert seamwright.biarc(*s_shape).x == 0.5
    with pytest.raises(ValueError):
        seamwright.biarc(*s_shape, rule="parallel")


def test_ends_on_a_circle_give_its_arc():
    for rule in ("equal chords", "parallel", "least radius difference"):
        found = seamwright.biarc([2, 0], math.pi / 2, [0, 2], math.pi, rule=rule)
        for arc in found.chain.arcs:
            assert arc.curvature_per_mm == pytest.approx(0.5, rel=1e-14)


def test_bad_biarcs():
    ends = ([0, 0], 0.1, [1, 0], 0.2)
    for bad in (0, 1, -1, math.nan):
        with pytest.raises(ValueError):
            seamwright.biarc(*ends, x=bad)
    with pytest.raises(ValueError, match="x is 0.5: it has no meaning with a rule"):
        seamwright.biarc(*ends, rule="parallel", x=0.5)
    with pytest.raises(ValueError, match="rule is 'best': known are 'default', 'equal.* and"):
        seamwright.biarc(*ends, rule="best")
    with pytest.raises(ValueError):
        seamwright.biarc([0, 0], -math.pi, [1, 0], math.pi)
    with pytest.raises(ValueError, match="end is"):
        seamwright.biarc([0, 0], 0, [1], 0)


# Biarc splines

POINTS = np.array([[0, 0], [4, 3], [9, 4], [13, 1], [18, 2], [22, 7.0]])


@pytest.mark.parametrize("tangents", ["near circles", "linear energy", "energy"])
@pytest.mark.parametrize("closed", [False, True])
def test_a_biarc_spline_passes_through_its_points(tangents, closed):
    points = circle_points(7, 5) * [1, 0.6] if closed else POINTS
    spline = seamwright.biarc_spline(points, closed=closed, tangents=tangents)
    segments = len(points) - (not closed)
    assert len(spline.chain) == 2 * segments and spline.chain.closed == closed
    expect_g1(spline.chain)
    starts = np.array([spline.chain.arcs[2 * i].start for i in range(segments)])
    assert np.array_equal(starts, points[:segments])
    given = seamwright.planar_tangents(points, closed=closed, tangents=tangents)
    assert np.array_equal(given.directions_rad, spline.directions_rad)
    assert spline.directions_rad.shape == (len(points),)
    assert spline.energy_per_mm == spline.chain.energy_per_mm
    assert spline.curve == spline.chain.bezier_spline()
    assert seamwright.arc_length(spline, 1e-9).value_mm == pytest.approx(spline.chain.length_mm)


def test_points_of_a_circle_give_the_circle():
    spline = seamwright.biarc_spline(circle_points(8, 3), closed=True)
    for arc in spline.chain.arcs:
        assert arc.curvature_per_mm == pytest.approx(1 / 3, rel=1e-13)
    assert spline.chain.length_mm == pytest.approx(6 * math.pi, rel=1e-14)
    assert spline.energy_per_mm == pytest.approx(2 * math.pi / 3, rel=1e-13)


def test_the_energy_of_biarcs_is_least():
    best = seamwright.biarc_spline(POINTS, tangents="energy").energy_per_mm
    for tangents in ("linear energy", "near circles"):
        assert best <= seamwright.biarc_spline(POINTS, tangents=tangents).energy_per_mm
    steps = seamwright.planar_tangents(POINTS, tangents="energy").steps
    assert isinstance(steps, int) and steps > 0


def test_motion_and_reversal_of_points():
    spline = seamwright.biarc_spline(POINTS)
    other = seamwright.biarc_spline(moved(POINTS))
    s = np.linspace(0, spline.chain.length_mm, 50)
    s[-1] = min(spline.chain.length_mm, other.chain.length_mm)
    assert np.abs(other.chain.point(s) - moved(spline.chain.point(s))).max() < 1e-11
    back = seamwright.biarc_spline(POINTS[::-1])
    turns = wrapped(back.directions_rad[::-1] + math.pi - spline.directions_rad)
    assert np.abs(turns).max() < 1e-12


def test_end_tangents():
    spline = seamwright.biarc_spline(
        POINTS, start_direction_rad=1.0, end_direction_rad=np.float32(0.5)
    )
    assert spline.directions_rad[0] == pytest.approx(1) and spline.directions_rad[-1] == 0.5
    with pytest.raises(ValueError, match="closed curve has no end directions"):
        seamwright.biarc_spline(POINTS, closed=True, start_direction_rad=1.0)


@pytest.mark.parametrize(
    "arguments, text",
    [
        ({"points": POINTS[:1]}, "point"),
        ({"points": np.zeros((4, 3))}, r"points have shape \(4, 3\): \(count, 2\) is needed"),
        ({"points": np.where(POINTS == 13, np.nan, POINTS)}, "3"),
        ({"points": POINTS[[0, 1, 1, 2]]}, "1 and 2"),
        ({"points": [[0, 0], [2, 0], [1, 0]]}, r"\(2, 0\)"),
        ({"variation": -1}, r"variation \(lambda\) is -1"),
        ({"tangents": "best"}, "tangents is 'best': known are 'near circles'"),
        ({"start_direction_rad": math.nan}, "nan"),
        ({"closed": 1}, "closed is 1"),
        ({"rule": None}, "rule is None"),
    ],
)
def test_bad_points(arguments, text):
    with pytest.raises(ValueError, match=text):
        seamwright.biarc_spline(**{"points": POINTS} | arguments)


# Arcs near curves


@pytest.mark.parametrize("tolerance", [1.0, 0.1, 1e-3])
def test_arcs_stay_within_the_tolerance_in_both_directions(tolerance):
    fit = seamwright.fit_arcs(CUBIC, tolerance)
    assert fit.distance_mm <= tolerance and not fit.chain.closed
    expect_g1(fit.chain)
    curve = CUBIC.point(np.linspace(0, 1, 4001))[:, :2]
    arcs = fit.chain.point(np.linspace(0, fit.chain.length_mm, 4001))
    # Samples of both are 0.01 mm apart: the distance between them is that of curves up to a part.
    spacing = 0.012
    for a, b in ((curve, arcs), (arcs, curve)):
        assert distances(a, b).max() <= math.hypot(fit.distance_mm, spacing)


def test_fewer_arcs_for_a_larger_tolerance():
    counts = [len(seamwright.fit_arcs(CUBIC, t).chain) for t in (1, 0.1, 0.01, 0.001)]
    assert counts == sorted(counts) and counts[-1] < 25 * counts[0]
    # For arcs that are fitted to a smooth curve the number grows by the cube root.
    assert counts[-1] / counts[1] == pytest.approx(100 ** (1 / 3), rel=0.5)


def test_a_chain_comes_back_and_corners_are_kept():
    chain = square_with_round_corners(10, 2)
    fit = seamwright.fit_arcs(chain.bezier_spline(), 1e-6)
    assert fit.chain.closed and len(fit.chain) in (8, 9)
    line = seamwright.BezierSpline(1, [0, 1, 2], [[0, 0, 0], [5, 0, 0], [5, 5, 0]])
    cornered = seamwright.fit_arcs(line)
    assert cornered.chain.corners == [len(cornered.chain) // 2]
    assert cornered.distance_mm < 1e-12
    assert seamwright.fit_arcs(fit, 1e-3).chain.closed  # a result is a curve


@pytest.mark.parametrize(
    "curve, arguments, kind, text",
    [
        (CUBIC, {"tolerance_mm": 0}, ValueError, "tolerance is 0"),
        (CUBIC, {"tolerance_mm": math.nan}, ValueError, "tolerance_mm is nan"),
        (CUBIC, {"tolerance_mm": "x"}, ValueError, "tolerance_mm is 'x'"),
        (CUBIC, {"corner_rad": 4}, ValueError, "corner angle is 4"),
        (seamwright.BezierCurve([[0, 0, 0], [1, 0, 1]]), {}, ValueError, "outside of the plane"),
        (seamwright.BezierCurve([[0, 0, 0]] * 3), {}, ValueError, "stops"),
        (POINTS, {}, TypeError, "curve is"),
    ],
)
def test_bad_curves(curve, arguments, kind, text):
    with pytest.raises(kind, match=text):
        seamwright.fit_arcs(curve, **arguments)


def test_turned_curves_have_turned_arcs():
    arc = seamwright.arc_through([1, 0], 0.2, [4, 3])
    other = seamwright.arc_through(turned([1, 0], 0.9), 1.1, turned([4, 3], 0.9))
    assert other.curvature_per_mm == pytest.approx(arc.curvature_per_mm, rel=1e-14)
