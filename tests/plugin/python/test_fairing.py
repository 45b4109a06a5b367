# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature of points and curves, and fairing within tolerances, through Python: closed forms,
dense samples and finite differences."""

import math

import numpy as np
import pytest
import seamwright
from planar_samples import circle_points, moved
from seamwright import BezierCurve, BSplineCurve
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_fairing.py"))
X = np.linspace(-2, 2, 41)
PARABOLA = np.stack([X, X * X / 2], axis=1)
ROUGH = PARABOLA + RANDOM.uniform(-1e-3, 1e-3, PARABOLA.shape)
KNOTS = [0, 0, 0, 0, *range(1, 9), 9, 9, 9, 9]


def rough_curve(size=0.05):
    x = np.linspace(0, 9, 12)
    poles = np.stack([x, np.sin(x / 2), 0 * x], axis=1)
    poles[1:-1, 1] += size * np.array([1, -1] * 5)
    return BSplineCurve(3, KNOTS, poles)


def energy(points):
    """The sum of squared differences of curvature, each over the distance of the points."""
    k = seamwright.point_curvatures(points)
    return (np.diff(k) ** 2 / np.linalg.norm(np.diff(points[1:-1], axis=0), axis=1)).sum()


# Points


def test_curvature_at_points():
    k = seamwright.point_curvatures(circle_points(9, 4), closed=True)
    assert k.shape == (9,) and np.abs(k - 0.25).max() < 1e-15
    assert np.abs(seamwright.point_curvatures(circle_points(9, 4)[::-1]) + 0.25).max() < 1e-15
    k = seamwright.point_curvatures(PARABOLA)
    assert k.shape == (39,)
    assert np.abs(k - 1 / (1 + X[1:-1] ** 2) ** 1.5).max() < 5e-3  # of second order in the distance
    assert np.abs(seamwright.point_curvatures(moved(PARABOLA)) - k).max() < 1e-11


def test_how_fair_points_are():
    fair, rough = seamwright.point_fairness(PARABOLA), seamwright.point_fairness(ROUGH)
    assert fair.energy_per_mm3 == pytest.approx(energy(PARABOLA), rel=1e-12)
    assert fair.extrema == [20] and fair.inflections == []  # the vertex
    assert rough.energy_per_mm3 > 10 * fair.energy_per_mm3 and len(rough.extrema) > 5
    assert 0 < fair.rounding_per_mm3 < 1e-6 * fair.energy_per_mm3
    circle = seamwright.point_fairness(circle_points(20, 3), closed=True)
    assert circle.extrema == [] == circle.inflections


def test_misread_points_are_found():
    points = PARABOLA.copy()
    assert seamwright.isolated_inflections(points) == []
    points[15, 1] += 0.05
    assert seamwright.isolated_inflections(points) == [15]


def test_fair_points_stay_within_their_tolerances():
    tolerance = np.full(len(ROUGH), 2e-3)
    tolerance[[7, 20]] = 0
    faired = seamwright.fair_points(ROUGH, tolerance)
    moves = np.linalg.norm(faired.points_mm - ROUGH, axis=1)
    assert np.all(moves <= tolerance) and np.array_equal(faired.points_mm[7], ROUGH[7])
    assert np.array_equal(faired.points_mm[[0, -1]], ROUGH[[0, -1]])
    assert faired.moved_mm == moves.max() == moves[faired.most_moved] > 0
    assert faired.after.energy_per_mm3 == pytest.approx(energy(faired.points_mm), rel=1e-9)
    assert faired.after.energy_per_mm3 < 0.2 * faired.before.energy_per_mm3
    assert faired.before == seamwright.point_fairness(ROUGH)
    assert faired.status == "converged" and faired.converged and faired.steps > 0
    wide = seamwright.fair_points(ROUGH, 2e-3, ends_fixed=False)
    assert wide.after.energy_per_mm3 <= faired.after.energy_per_mm3
    assert len(wide.after.extrema) < len(wide.before.extrema)


def test_the_energy_is_least():
    """A trial move of any point along its normal does not lower it."""
    faired = seamwright.fair_points(ROUGH[::2], 1e-2)
    least = energy(faired.points_mm)
    moves = np.linalg.norm(faired.points_mm - ROUGH[::2], axis=1)
    for i in np.flatnonzero(moves[2:-2] < 5e-3) + 2:
        chord = ROUGH[2 * i + 2] - ROUGH[2 * i - 2]
        normal = np.array([-chord[1], chord[0]]) / np.linalg.norm(chord)
        for step in (1e-4, -1e-4):
            trial = faired.points_mm.copy()
            trial[i] += step * normal
            assert energy(trial) > least


def test_circles_and_no_tolerance_change_nothing():
    circle = circle_points(15, 3)
    assert np.abs(seamwright.fair_points(circle, 0.1, closed=True).points_mm - circle).max() < 1e-9
    same = seamwright.fair_points(ROUGH, 0)
    assert np.array_equal(same.points_mm, ROUGH) and same.moved_mm == 0
    assert np.array_equal(seamwright.filter_curvature(ROUGH, 0).points_mm, ROUGH)


def test_the_filter_of_curvature():
    filtered = seamwright.filter_curvature(ROUGH, 2e-3)
    moves = np.linalg.norm(filtered.points_mm - ROUGH, axis=1)
    assert moves.max() <= 2e-3 and filtered.moved_mm == moves.max()
    assert filtered.after.energy_per_mm3 < filtered.before.energy_per_mm3
    best = seamwright.fair_points(ROUGH, 2e-3)
    assert best.after.energy_per_mm3 < filtered.after.energy_per_mm3


@pytest.mark.parametrize("function", [seamwright.fair_points, seamwright.filter_curvature])
@pytest.mark.parametrize(
    "points, tolerance, text",
    [
        (ROUGH[:2], 1e-3, "point"),
        (ROUGH[:, :1], 1e-3, r"points have shape \(41, 1\): \(count, 2\) is needed"),
        (np.where(ROUGH == ROUGH[5, 0], np.nan, ROUGH), 1e-3, "5"),
        (ROUGH[[0, 1, 1, 2, 3]], 1e-3, "1"),
        (ROUGH, -1, "-1"),
        (ROUGH, math.nan, "nan"),
        (ROUGH, "x", "tolerance_mm is 'x'"),
    ],
)
def test_bad_points(function, points, tolerance, text):
    with pytest.raises(ValueError, match=text):
        function(points, tolerance)


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: seamwright.fair_points(ROUGH, [1, 2]), "2 tolerances|tolerance"),
        (lambda: seamwright.fair_points(ROUGH, 1, ends_fixed=1), "ends_fixed is 1"),
        (lambda: seamwright.fair_points(ROUGH, 1, max_steps=1.5), "max_steps is 1.5"),
        (lambda: seamwright.filter_curvature(ROUGH, 1, strength=0.5), "strength is 0.5"),
        (lambda: seamwright.filter_curvature(ROUGH, [1] * 41), "tolerance_mm is"),
        (lambda: seamwright.point_curvatures(ROUGH, closed=None), "closed is None"),
        (lambda: seamwright.isolated_inflections("x"), "points are 'x'"),
        (lambda: seamwright.point_fairness([[0, 0], [1, 0]]), "point"),
    ],
)
def test_bad_arguments_of_points(call, text):
    with pytest.raises(ValueError, match=text):
        call()


# Curves


def test_the_profile_of_a_parabola_and_of_an_s():
    parabola = BezierCurve([[-1, 1, 0], [1, -3, 0], [3, 9, 0]])  # y = x^2 over [-1, 3]
    profile = seamwright.curvature_profile(parabola)
    (extremum,) = profile.extrema
    assert extremum.lower <= 0.25 <= extremum.upper and extremum.upper - extremum.lower < 1e-6
    assert extremum.maximum and extremum.curvature_per_mm == pytest.approx(2)
    assert profile.signed and not profile.monotone and profile.inflections == []
    s = BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [3, 0, 0]])
    ((lower, upper),) = seamwright.curvature_profile(s).inflections
    assert lower <= 0.5 <= upper
    half = seamwright.curvature_profile(parabola.split(0.3)[1])
    assert half.monotone and half.extrema == []


def test_the_profile_of_a_spline_and_in_space():
    curve = rough_curve()
    profile = seamwright.curvature_profile(curve)
    t = np.linspace(0, 9, 90001)
    d = curve.derivatives(t, 2)
    k = (d[:, 1, 0] * d[:, 2, 1] - d[:, 1, 1] * d[:, 2, 0]) / np.linalg.norm(d[:, 1], axis=1) ** 3
    signs = t[:-1][k[:-1] * k[1:] < 0]
    assert len(signs) == len(profile.inflections)
    for (lower, upper), at in zip(profile.inflections, signs):
        assert lower - 1e-4 <= at <= upper + 1e-4
    fairness = seamwright.curve_fairness(curve)
    assert fairness.extrema == len(profile.extrema)
    assert fairness.inflections == len(profile.inflections)
    rises = np.sign(np.diff(k))
    assert (rises[1:] * rises[:-1] < 0).sum() == fairness.extrema + fairness.extrema_at_knots
    space = seamwright.curvature_profile(BezierCurve([[0, 0, 0], [2, 0, 0], [2, 2, 1], [0, 3, 2]]))
    assert not space.signed


def test_fair_curves_stay_within_the_tolerance():
    curve = rough_curve()
    t = np.linspace(0, 9, 2001)
    energies = [seamwright.curve_fairness(curve).energy]
    for tolerance in (1e-3, 1e-2, 0.1):
        faired = seamwright.fair_curve(curve, tolerance)
        moves = np.linalg.norm(faired.curve.point(t) - curve.point(t), axis=1)
        assert moves.max() <= faired.moved_mm <= tolerance
        assert faired.moved_mm > 0.95 * tolerance and faired.curve.knots == curve.knots
        assert np.array_equal(faired.curve.poles[[0, -1]], curve.poles[[0, -1]])
        assert faired.before == seamwright.curve_fairness(curve)
        assert faired.after == seamwright.curve_fairness(faired)  # a result is a curve
        energies.append(faired.after.energy)
    assert energies == sorted(energies, reverse=True)
    assert faired.after.inflections < faired.before.inflections


@pytest.mark.parametrize(
    "ends, held", [("nothing", 0), ("position", 1), ("tangent", 2), ("curvature", 3)]
)
def test_ends_that_are_held(ends, held):
    curve = rough_curve()
    faired = seamwright.fair_curve(curve, 0.02, ends=ends).curve
    kept = [*range(held), *range(12 - held, 12)]
    assert np.array_equal(faired.poles[kept], curve.poles[kept])
    assert not np.array_equal(faired.poles[held], curve.poles[held])


def test_no_tolerance_and_other_classes():
    curve = rough_curve()
    assert seamwright.fair_curve(curve, 0).curve == curve
    spline = curve.bezier_spline()
    assert np.abs(seamwright.fair_curve(spline, 0.02).curve.poles - (
        seamwright.fair_curve(curve, 0.02).curve.poles)).max() < 1e-9
    cubic = BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [3, 0, 1]])
    assert seamwright.fair_curve(cubic, 0.1).after.energy < seamwright.curve_fairness(cubic).energy


def test_the_energy_is_the_integral():
    curve = rough_curve()
    third = curve.derivatives(np.arange(9) + 0.5, 3)[:, 3]  # constant in each span
    assert seamwright.curve_fairness(curve).energy == pytest.approx((third**2).sum(), rel=1e-12)


def test_fairing_at_knots():
    curve = rough_curve()
    once = seamwright.fair_at_knot(curve, 7)
    changed = np.flatnonzero(np.any(once.poles != curve.poles, axis=1))
    assert list(changed) == [5]
    # P''' is the same on both sides of the knot 4.
    sides = once.derivatives([3.9, 4.1], 3)[:, 3]
    assert np.abs(sides[0] - sides[1]).max() < 1e-12
    limited = seamwright.fair_at_knot(curve, 7, 1e-3)
    assert np.linalg.norm(limited.poles[5] - curve.poles[5]) <= 1e-3
    faired = seamwright.fair_at_knots(curve, 0.02)
    moves = np.linalg.norm(faired.curve.poles - curve.poles, axis=1)
    assert 0 < moves.max() <= 0.02 and faired.moved_mm <= 0.02 and faired.smoothing == 0


def bezier_map(knots, degree, pole, count):
    """Return the Bezier poles of a basis function, by its values in each span."""
    poles = np.zeros((count, 3))
    poles[pole, 0] = 1
    curve = seamwright.BSplineCurve(degree, knots, poles)
    t = np.linspace(0.02, 0.98, degree + 1)
    bernstein = [
        [math.comb(degree, j) * u**j * (1 - u) ** (degree - j) for j in range(degree + 1)]
        for u in t
    ]
    ends = np.unique(knots)
    values = [curve.derivatives(a + t * (b - a), 0)[:, 0, 0] for a, b in zip(ends, ends[1:])]
    return np.concatenate([np.linalg.solve(bernstein, row) for row in values])


@pytest.mark.parametrize("case", range(4))
def test_fair_curves_have_the_least_energy_within_the_tolerance(case):
    optimize = pytest.importorskip("scipy.optimize")
    random = np.random.default_rng(case)
    degree, count, tolerance = 3 + case % 2, 9 + case, 0.02
    inner = np.cumsum(random.uniform(0.5, 1.5, count - degree - 1))
    knots = np.r_[[0.0] * (degree + 1), inner, [inner[-1] + 1] * (degree + 1)]
    t = 4 * np.array([knots[i + 1 : i + degree + 1].mean() for i in range(count)]) / knots[-1]
    poles = np.stack([(5 + t) * np.cos(t), (5 + t) * np.sin(t), t * (case % 3 > 0)], axis=1)
    poles[:, : 2 + (case % 3 > 0)] += random.uniform(-0.05, 0.05, (count, 2 + (case % 3 > 0)))
    faired = seamwright.fair_curve(
        seamwright.BSplineCurve(degree, knots, poles), tolerance, ends="tangent"
    )
    # The third derivative is linear in each span at most, so that two nodes are exact.
    ends = np.unique(knots)
    width = np.diff(ends)
    nodes = np.ravel([ends[:-1] + width * (0.5 + s / math.sqrt(12)) for s in (-1, 1)])
    roots = np.tile(np.sqrt(width / 2), 2)[:, None]

    def third(rows):
        curve = seamwright.BSplineCurve(degree, knots, rows)
        return curve.derivatives(nodes, 3)[:, 3] * roots

    free = range(2, count - 2)
    unit = np.eye(count)[:, :, None] * np.array([1.0, 0, 0])
    form = np.stack([third(unit[i])[:, 0] for i in free], axis=1)
    bounds = np.stack([bezier_map(knots, degree, i, count) for i in free], axis=1)
    start = third(poles)

    def energy(moves):
        rest = start + tolerance * form @ moves.reshape(-1, 3)
        return (rest**2).sum() / faired.after.energy, (
            2 * tolerance * (form.T @ rest).ravel() / faired.after.energy
        )

    def slacks(moves):
        return 1 - ((bounds @ moves.reshape(-1, 3)) ** 2).sum(axis=1)

    def slopes(moves):
        sides = bounds @ moves.reshape(-1, 3)
        return -2 * (bounds[:, :, None] * sides[:, None, :]).reshape(len(bounds), -1)

    least = optimize.minimize(
        energy,
        np.zeros(3 * len(free)),
        jac=True,
        constraints={"type": "ineq", "fun": slacks, "jac": slopes},
        method="SLSQP",
        options={"maxiter": 500, "ftol": 1e-12},
    )
    assert least.success and abs(least.fun - 1) < 1e-4
    assert faired.after.energy < faired.before.energy


def test_a_smoothing_spline_is_between_interpolation_and_a_parabola():
    t = np.linspace(0, 9, 60)
    points = np.stack([t, np.sin(t), 0.1 * t * t], axis=1)
    noisy = points + RANDOM.normal(0, 0.01, points.shape)
    def residual(curve):
        return np.linalg.norm(curve.point(t) - noisy)
    splines = [seamwright.smoothing_spline(noisy, t, KNOTS, s) for s in (1e-6, 1e-2, 1, 1e8)]
    assert all(isinstance(spline, BSplineCurve) and spline.degree == 3 for spline in splines)
    residuals = [residual(spline) for spline in splines]
    energies = [seamwright.curve_fairness(spline).energy for spline in splines]
    assert residuals == sorted(residuals) and energies == sorted(energies, reverse=True)
    # For a large smoothing it is the parabola of least squares.
    for axis in range(3):
        parabola = np.polynomial.Polynomial.fit(t, noisy[:, axis], 2)
        assert np.abs(splines[-1].point(t)[:, axis] - parabola(t)).max() < 1e-5
    fixed = seamwright.smoothing_spline(noisy, t, KNOTS, 1, ends_fixed=True)
    assert np.array_equal(fixed.poles[[0, -1]], noisy[[0, -1]])


def test_a_polished_curve_varies_less():
    curve = rough_curve()
    t = np.linspace(0, 9, 2001)
    variation = seamwright.curvature_variation(curve).energy_per_mm3
    last = variation
    for tolerance in (1e-3, 1e-2, 0.1):
        found = seamwright.polish_curve(curve, tolerance, ends="tangent")
        moves = np.linalg.norm(found.curve.point(t) - curve.point(t), axis=1)
        assert moves.max() <= found.moved_mm <= tolerance and found.curve.knots == curve.knots
        assert np.array_equal(found.curve.poles[[0, 1, -2, -1]], curve.poles[[0, 1, -2, -1]])
        assert found.variation_before_per_mm3 == pytest.approx(variation, rel=1e-9)
        assert found.variation_after_per_mm3 == pytest.approx(
            seamwright.curvature_variation(found).energy_per_mm3, rel=1e-6
        )
        assert found.variation_after_per_mm3 < last
        last = found.variation_after_per_mm3
        assert found.after == seamwright.curve_fairness(found)
    same = seamwright.polish_curve(curve, 0)
    assert same.curve == curve and same.moved_mm == 0


RATIONAL = BezierCurve([[0, 0, 0], [1, 1, 0], [2, 0, 0]], [1, 2, 1])
LINE = BezierCurve([[0, 0, 0], [1, 1, 0]])


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda: seamwright.fair_curve(RATIONAL, 1), ValueError, "rational"),
        (lambda: seamwright.curve_fairness(LINE), ValueError, "degree of? ?1|degree 1"),
        (lambda: seamwright.fair_curve(rough_curve(), -1), ValueError, "tolerance is -1"),
        (lambda: seamwright.fair_curve(rough_curve(), math.nan), ValueError, "nan"),
        (
            lambda: seamwright.fair_curve(rough_curve(), 1, ends="all"),
            ValueError,
            "ends is 'all': k",
        ),
        (lambda: seamwright.fair_curve(ROUGH, 1), TypeError, "curve is"),
        (lambda: seamwright.polish_curve(RATIONAL, 1), ValueError, "rational"),
        (lambda: seamwright.polish_curve(rough_curve(), -1), ValueError, "tolerance is -1"),
        (lambda: seamwright.polish_curve(rough_curve(), 1, ends="x"), ValueError, "ends is 'x'"),
        (lambda: seamwright.fair_at_knots(RATIONAL, 1), ValueError, "rational|degree"),
        (lambda: seamwright.fair_at_knot(rough_curve(), 2), ValueError, "2"),
        (lambda: seamwright.fair_at_knot(rough_curve(), 99), ValueError, "99"),
        (lambda: seamwright.fair_at_knot(rough_curve(), 7, -1), ValueError, "-1"),
        (lambda: seamwright.fair_at_knot(rough_curve(), 7.0), ValueError, "index is 7.0"),
        (lambda: seamwright.curvature_profile(3), TypeError, "curve is 3"),
        (
            lambda: seamwright.curvature_profile(BezierCurve([[0, 0, 0]] * 2)),
            ValueError,
            "may stop",
        ),
        (
            lambda: seamwright.smoothing_spline(np.zeros((3, 2)), [1, 2, 3], KNOTS, 1),
            ValueError,
            r"points have shape \(3, 2\)",
        ),
        (
            lambda: seamwright.smoothing_spline(np.zeros((3, 3)), [1, 2], KNOTS, 1),
            ValueError,
            "3 points for 2 parameters",
        ),
        (
            lambda: seamwright.smoothing_spline(np.zeros((3, 3)), [1, 2, 10], KNOTS, 1),
            ValueError,
            "parameter 2 is 10",
        ),
        (
            lambda: seamwright.smoothing_spline(np.zeros((3, 3)), [1, 2, 3], KNOTS, 0),
            ValueError,
            "smoothing is 0",
        ),
        (
            lambda: seamwright.smoothing_spline(np.zeros((2, 3)), [1, 2], KNOTS, 1),
            ValueError,
            "singular",
        ),
    ],
)
def test_bad_curves(call, kind, text):
    with pytest.raises(kind, match=text):
        call()


@pytest.mark.parametrize("size", [1e-200, 1e-40, 1e40, 1e150, 1e200])
def test_sizes_beyond_the_range_are_refused(size):
    for function in (
        seamwright.point_curvatures,
        seamwright.point_fairness,
        seamwright.isolated_inflections,
        lambda points: seamwright.fair_points(points, 0.01 * size),
    ):
        with pytest.raises(ValueError, match="^points 0 and . are .* mm apart: the energy needs"):
            function(PARABOLA * size)


@pytest.mark.parametrize("size", [1e-27, 1e27])
def test_sizes_in_the_range_scale(size):
    k = seamwright.point_curvatures(PARABOLA)
    assert np.abs(seamwright.point_curvatures(PARABOLA * size) * size - k).max() < 1e-9
    faired = seamwright.fair_points(ROUGH * size, 1e-3 * size)
    assert 0 < faired.after.energy_per_mm3 < faired.before.energy_per_mm3 < math.inf


@pytest.mark.parametrize("count", [1, 3])
def test_a_point_has_no_variation_of_the_curvature(count):
    with pytest.raises(ValueError, match=r"segment 0 is the point \(1, 2, 0\)"):
        seamwright.curvature_variation(BezierCurve([[1, 2, 0]] * count))
