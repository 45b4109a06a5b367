# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoids, clothoid splines, logarithmic spirals and their arcs, through Python: the oracle is
quadrature of the tangent by numpy."""

import math

import numpy as np
import pytest
import seamwright
from planar_samples import circle_points, distances, ends_of, moved, quadrature, wrapped
from seamwright import Clothoid, ClothoidChain, LogSpiral
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_clothoids.py"))
POINTS = np.array([[0, 0], [4, 3], [9, 4], [13, 1], [18, 2], [22, 7.0]])


def integral(start, direction, length):
    """The end of a curve from its start, by its direction as a function of the arc length."""
    x = quadrature(lambda s: np.cos(direction(s)), 0, length)
    y = quadrature(lambda s: np.sin(direction(s)), 0, length)
    return np.asarray(start) + [x, y]


# Clothoids


def test_a_clothoid_is_the_integral_of_its_direction():
    for _ in range(30):
        k, slope, length = RANDOM.uniform(-1, 1), RANDOM.uniform(-0.2, 0.2), RANDOM.uniform(1, 9)
        curve = Clothoid([1, -2], 0.4, k, slope, length)
        for s in RANDOM.uniform(0, length, 3):
            expected = integral([1, -2], lambda u: 0.4 + k * u + slope * u * u / 2, s)
            assert np.abs(curve.point(s) - expected).max() < 1e-13
        s = np.linspace(0, length, 5)
        assert np.abs(curve.curvature_at_per_mm(s) - (k + slope * s)).max() < 1e-15
        assert np.abs(curve.direction_at_rad(s) - (0.4 + k * s + slope * s * s / 2)).max() < 1e-14
        assert curve.end_curvature_per_mm == curve.curvature_at_per_mm(length)
        assert curve.end_direction_rad == curve.direction_at_rad(length)


def test_the_spiral_of_euler():
    # The curvature is the arc length times pi: the points are the Fresnel integrals.
    curve = Clothoid([0, 0], 0, 0, math.pi, 2)
    assert np.abs(curve.point(1) - [0.7798934003768228, 0.4382591473903548]).max() < 1e-14
    assert np.abs(curve.point(2) - [0.4882534060753408, 0.3434156783636982]).max() < 1e-14


def test_the_clothoid_between_two_ends():
    for _ in range(200):
        start, start_rad, end, end_rad = ends_of(RANDOM)
        curve = seamwright.clothoid(start, start_rad, end, end_rad)
        size = max(1, curve.length_mm**2 / np.linalg.norm(end - start))
        assert np.linalg.norm(curve.end - end) < 1e-13 * size
        assert abs(wrapped(curve.end_direction_rad - end_rad)) < 1e-12
        back = seamwright.clothoid(end, end_rad + math.pi, start, start_rad + math.pi)
        assert back.length_mm == pytest.approx(curve.length_mm, rel=1e-11)
        assert back.curvature_slope_per_mm2 == pytest.approx(
            curve.curvature_slope_per_mm2, rel=1e-9, abs=1e-12
        )


def test_limits_of_clothoids():
    arc = seamwright.clothoid([2, 0], math.pi / 2, [0, 2], math.pi)
    assert arc.length_mm == pytest.approx(math.pi, rel=1e-14)
    assert abs(arc.curvature_slope_per_mm2) < 1e-15
    line = seamwright.clothoid([0, 0], 0.5, 3 * np.array([math.cos(0.5), math.sin(0.5)]), 0.5)
    assert line.length_mm == pytest.approx(3) and abs(line.curvature_per_mm) < 1e-15
    with pytest.raises(ValueError, match="point against the chord"):
        seamwright.clothoid([0, 0], -math.pi, [1, 0], math.pi)


def test_a_reversed_clothoid():
    curve = Clothoid([1, 2], 0.3, 0.1, -0.05, 6)
    s = np.linspace(0, 6, 7)
    assert np.abs(curve.reversed().point(s) - curve.point(6 - s)).max() < 1e-14
    there_and_back = curve.curvature_at_per_mm(6 - s) + curve.reversed().curvature_at_per_mm(s)
    assert np.abs(there_and_back).max() < 1e-15


@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-10])
def test_quintics_keep_their_distance(tolerance):
    curve = Clothoid([0, 0], 0, -0.5, 0.2, 10)
    found = curve.bezier_spline(tolerance)
    assert found.distance_mm <= tolerance and found.curve.degree == 5
    s = np.linspace(0, 10, 1001)
    points = found.curve.point(s)
    assert np.linalg.norm(points[:, :2] - curve.point(s), axis=1).max() <= found.distance_mm + 1e-14
    assert np.all(points[:, 2] == 0) and found.curve.continuity() >= 2
    assert seamwright.arc_length(found, 1e-9).value_mm == pytest.approx(10, abs=3 * tolerance)


# Splines of clothoids


@pytest.mark.parametrize("closed", [False, True])
def test_a_spline_of_clothoids_is_g2(closed):
    points = circle_points(7, 5) * [1, 0.6] if closed else POINTS
    spline = seamwright.clothoid_spline(points, closed=closed)
    chain = spline.chain
    assert len(chain) == len(chain.pieces) == len(points) - (not closed)
    assert chain.closed == closed and spline.curvature_jump_per_mm < 1e-12
    pieces = chain.pieces
    following = pieces[1:] + pieces[:1] if closed else pieces[1:]
    for before, after in zip(pieces, following):
        assert np.linalg.norm(before.end - after.start) < 1e-12
        assert abs(wrapped(before.end_direction_rad - after.direction_rad)) < 1e-12
        assert abs(before.end_curvature_per_mm - after.curvature_per_mm) < 1e-12
    assert np.array_equal([piece.start for piece in pieces], points[: len(pieces)])
    ends = [spline.chain.curvature_at_per_mm(s) for s in (0, chain.length_mm)]
    assert (abs(ends[0] - ends[1]) if closed else np.abs(ends).max()) < 1e-12
    found = chain.bezier_spline(1e-6)
    assert found.curve.closed == closed and found.distance_mm <= 1e-6
    s = np.linspace(0, chain.length_mm, 500)
    assert np.abs(found.curve.point(s)[:, :2] - chain.point(s)).max() <= 1.01e-6
    assert all(joint.order_reached == 2 for joint in found.curve.measure_joints(2))


def test_ends_of_clothoid_splines():
    spline = seamwright.clothoid_spline(POINTS, start_direction_rad=0.2, end_curvature_per_mm=-0.1)
    length = spline.chain.length_mm
    assert abs(wrapped(spline.chain.direction_at_rad(0) - 0.2)) < 1e-12
    assert spline.chain.curvature_at_per_mm(length) == pytest.approx(-0.1, abs=1e-11)
    assert spline.directions_rad.shape == (6,) and spline.steps > 0
    circle = circle_points(12, 4)[:7]
    half = seamwright.clothoid_spline(
        circle, start_curvature_per_mm=0.25, end_curvature_per_mm=0.25
    )
    assert np.abs(half.chain.curvature_at_per_mm(np.linspace(0, 12, 9)) - 0.25).max() < 1e-12
    assert half.chain.length_mm == pytest.approx(4 * math.pi, rel=1e-12)


def test_motion_of_clothoid_splines():
    one, other = seamwright.clothoid_spline(POINTS), seamwright.clothoid_spline(moved(POINTS))
    assert other.chain.length_mm == pytest.approx(one.chain.length_mm, rel=1e-13)
    s = np.linspace(0, 0.999 * one.chain.length_mm, 50)
    assert np.abs(other.chain.point(s) - moved(one.chain.point(s))).max() < 1e-11


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (
            lambda: Clothoid([0, 0], 0, 0, 0, -1),
            ValueError,
            "length_mm is -1.0: it must be positive",
        ),
        (lambda: Clothoid([0, 0], 0, 0, math.nan, 1), ValueError, "curvature_slope_per_mm2 is nan"),
        (lambda: Clothoid([0, 0], 0, 0, 1, 1e3), ValueError, "at most 10000"),
        (lambda: Clothoid([0, 0], 0, 0, 1, 1).point(2), ValueError, "s_mm is 2.0: the curve has 0"),
        (lambda: Clothoid([0, 0], 0, 0, 1, 1).bezier_spline(0), ValueError, "tolerance is 0"),
        (lambda: ClothoidChain([]), ValueError, r"pieces are \[\]"),
        (lambda: ClothoidChain([POINTS]), TypeError, r"pieces\[0\] is array"),
        (
            lambda: ClothoidChain([Clothoid([0, 0], 0, 0, 0, 1), Clothoid([1, 1], 0, 0, 0, 1)]),
            ValueError,
            "the end of 0 is 1.0 mm from the start of 1",
        ),
        (lambda: seamwright.clothoid([1, 2], 0, [1, 2], 0), ValueError, "both ends are the point"),
        (lambda: seamwright.clothoid_spline(POINTS[:1]), ValueError, "point"),
        (
            lambda: seamwright.clothoid_spline(
                POINTS, end_direction_rad=1, end_curvature_per_mm=0
            ),
            ValueError,
            "end_direction_rad is 1 and end_curvature_per_mm is 0: only one can be given",
        ),
        (
            lambda: seamwright.clothoid_spline(POINTS, closed=True, start_curvature_per_mm=0.5),
            ValueError,
            "a closed curve has no ends with 0.5",
        ),
        (lambda: seamwright.clothoid_spline([[0, 0], [2, 0], [1, 0]]), ValueError, r"\(2, 0\)"),
    ],
)
def test_bad_clothoids(call, kind, text):
    with pytest.raises(kind, match=text):
        call()


# Arcs that approximate clothoids, and logarithmic spirals

ENDS = ([1, 2], -0.4, [9, 3], 1.1)


def test_arcs_with_curvatures_in_arithmetic_progression():
    for count in (2, 5, 40):
        chain = seamwright.euler_arcs(*ENDS, count)
        assert len(chain) == count and np.linalg.norm(chain.point(chain.length_mm) - [9, 3]) < 1e-12
        k = np.array([arc.curvature_per_mm for arc in chain.arcs])
        assert np.ptp(np.diff(k)) < 1e-13 or count == 2
        assert np.ptp([arc.length_mm for arc in chain.arcs]) < 1e-13
    limit = seamwright.clothoid(*ENDS)
    errors = []
    for count in (20, 40):
        chain = seamwright.euler_arcs(*ENDS, count)
        share = np.linspace(0, 1, 101)
        errors.append(
            np.abs(
                chain.point(share * chain.length_mm) - limit.point(share * limit.length_mm)
            ).max()
        )
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.2)


def test_a_logarithmic_spiral_is_the_integral_of_its_tangent():
    for radius, growth in ((2, 0.3), (-2, 0.3), (-3, -0.7), (1.5, 0)):
        spiral = LogSpiral([1, 2], 0.5, radius, growth, 2)
        u = np.linspace(0, 2, 5)
        side = math.copysign(1, radius)
        assert np.abs(spiral.direction_at_rad(u) - (0.5 + side * u)).max() < 1e-15
        assert np.abs(spiral.curvature_at_per_mm(u) * radius * np.exp(growth * u) - 1).max() < 1e-14
        for last in u[1:]:
            radii = lambda v: abs(radius) * np.exp(growth * v)  # noqa: E731
            x = quadrature(lambda v: radii(v) * np.cos(0.5 + side * v), 0, last)
            y = quadrature(lambda v: radii(v) * np.sin(0.5 + side * v), 0, last)
            assert np.abs(spiral.point(last) - [1 + x, 2 + y]).max() < 1e-13
        assert spiral.length_mm == pytest.approx(quadrature(radii, 0, 2), rel=1e-13)
        # The angle between the tangent and the direction to the pole is constant.
        to_pole = spiral.pole - spiral.point(u)
        angle = np.arctan2(to_pole[:, 1], to_pole[:, 0]) - spiral.direction_at_rad(u)
        assert np.abs(wrapped(angle - angle[0])).max() < 1e-12
    circle = LogSpiral([1, 2], 0, 1.5, 0, 2)
    assert np.abs(circle.pole - [1, 3.5]).max() < 1e-15 and circle.length_mm == 3


def test_the_spiral_between_two_ends_and_its_arcs():
    spiral = seamwright.log_spiral(*ENDS)
    assert np.linalg.norm(spiral.end - [9, 3]) < 1e-13
    assert spiral.end_direction_rad == pytest.approx(1.1, abs=1e-14)
    arcs = seamwright.log_arcs(*ENDS, 60)
    points = spiral.point(np.linspace(0, spiral.turn_rad, 2001))
    assert distances(arcs.point(np.linspace(0, arcs.length_mm, 300)), points).max() < 1e-2
    radii = np.array([1 / arc.curvature_per_mm for arc in arcs.arcs])
    assert np.ptp(radii[1:] / radii[:-1]) < 1e-12
    assert np.ptp([arc.sweep_rad for arc in arcs.arcs]) < 1e-12
    fewest = seamwright.log_arcs(*ENDS)
    assert np.linalg.norm(fewest.point(fewest.length_mm) - [9, 3]) < 1e-12
    with pytest.raises(ValueError, match=f"at least {len(fewest)}"):
        seamwright.log_arcs(*ENDS, len(fewest) - 1)
    with pytest.raises(ValueError):
        seamwright.log_spiral([0, 0], 0.5, [1, 0], 0.5)
    with pytest.raises(ValueError, match="the radii at the ends differ by more than e"):
        seamwright.log_spiral([0, 0], -0.01, [1, 0], 1.5)


def test_quintics_of_a_spiral_keep_their_distance():
    spiral = LogSpiral([0, 0], 0, -3, 0.4, 3)
    for tolerance in (1e-2, 1e-8):
        found = spiral.bezier_spline(tolerance)
        u = np.linspace(0, 3, 1001)
        error = np.linalg.norm(found.curve.point(u)[:, :2] - spiral.point(u), axis=1).max()
        assert error <= found.distance_mm + 1e-14 and found.distance_mm <= tolerance


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: LogSpiral([0, 0], 0, 0, 1, 1), "radius_mm is 0, and 0.0 at the end"),
        (lambda: LogSpiral([0, 0], 0, 1, 1e6, 1), "radius_mm is 1, and inf at the end"),
        (lambda: LogSpiral([0, 0], 0, 1, 1, 0), "turn_rad is 0.0: it must be positive"),
        (
            lambda: LogSpiral([0, 0], 0, 1, 1, 1).point(-0.1),
            "u_rad is -0.1: the curve has 0 .. 1.0",
        ),
        (lambda: LogSpiral([0, 0], 0, 1, 1, 1).bezier_spline(math.nan), "tolerance_mm is nan"),
        (lambda: seamwright.euler_arcs(*ENDS, 0), "0 arcs"),
        (lambda: seamwright.euler_arcs(*ENDS, 2.5), "count is 2.5"),
        (lambda: seamwright.euler_arcs(*ENDS, 10**7), "count is 10000000: at most 1000000"),
        (lambda: seamwright.log_arcs(*ENDS, True), "count is True"),
    ],
)
def test_bad_spirals(call, text):
    with pytest.raises(ValueError, match=text):
        call()


# Clothoids near a curve


def test_a_slot_keeps_its_lines_and_gets_four_transitions():
    line = seamwright.PlanarArc([0, -10], 0, 0, 40)
    cap = seamwright.PlanarArc([40, -10], 0, 0.1, 10 * math.pi)
    half = [line, cap]
    turned = [seamwright.PlanarArc([40 - x, -y], math.pi, a.curvature_per_mm, a.length_mm)
              for a, (x, y) in zip(half, [line.start, cap.start])]
    slot = seamwright.ArcChain(half + turned, closed=True)
    fit = seamwright.fit_clothoids(slot.bezier_spline(), 0.01)
    assert fit.chain.closed and fit.corners == () and 0 < fit.distance_mm <= 0.01
    curvatures = [(p.curvature_per_mm, p.end_curvature_per_mm) for p in fit.chain.pieces]
    assert len(curvatures) == 8
    assert sum(k == (0, 0) for k in curvatures) == 2
    for (_, end), (start, _) in zip(curvatures, curvatures[1:]):
        assert end == pytest.approx(start, abs=1e-12)
    # The caps keep their centres: their radius is smaller by the shift L^2 / (24 R) to first order.
    largest = max(end for _, end in curvatures)
    ramp = max(p.length_mm for p in fit.chain.pieces if p.curvature_slope_per_mm2 > 1e-6)
    assert 10 - 1 / largest == pytest.approx(ramp**2 * largest / 24, rel=1e-3)
    corner = seamwright.ArcChain([line, seamwright.PlanarArc([40, -10], 1, 0, 5)], corners=[1])
    assert seamwright.fit_clothoids(corner.bezier_spline()).corners == (1,)
    with pytest.raises(ValueError, match="tolerance"):
        seamwright.fit_clothoids(slot.bezier_spline(), 0)
