# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays of parameters and numbers of numpy: the oracle is the call with one Python number."""

import numpy as np
import pytest
import seamwright
from seeds import fnv1a

RANDOM = np.random.default_rng(fnv1a("test_arrays.py"))
CURVE = seamwright.BezierCurve(RANDOM.normal(size=(5, 3)), RANDOM.uniform(0.5, 2, 5))
SPLINE = seamwright.nu_spline(RANDOM.normal(size=(5, 3))).curve
# Weights that differ little, so that continuations have positive weights too.
PATCH = seamwright.BezierPatch(RANDOM.normal(size=(4, 3, 3)), RANDOM.uniform(1, 1.01, (4, 3)))
TRIANGLE = seamwright.BezierTriangle(RANDOM.normal(size=(10, 3)))
SURFACE = seamwright.BSplineSurface.from_patch(PATCH)
T = np.array([[0.0, 0.25, 0.5], [0.75, 0.9, 1.0]])


@pytest.mark.parametrize("curve", [CURVE, SPLINE, SPLINE.to_bspline()], ids=repr)
def test_curves_at_arrays(curve):
    points, rows = curve.point(T), curve.derivatives(T, 2)
    assert points.shape == (2, 3, 3) and rows.shape == (2, 3, 3, 3)
    for index in np.ndindex(T.shape):
        t = float(T[index])
        assert np.array_equal(points[index], curve.point(t))
        assert np.array_equal(rows[index], curve.derivatives(t, 2))
    assert curve.point([]).shape == (0, 3) and curve.derivatives(np.empty((0, 2)), 1).shape == (
        0,
        2,
        2,
        3,
    )


def test_jets_of_curves_at_arrays():
    jets = CURVE.jet(T)
    assert jets.shape == (2, 3, 4, 3) and np.array_equal(jets[1, 0], CURVE.jet(0.75))


@pytest.mark.parametrize("surface", [PATCH, TRIANGLE, SURFACE], ids=repr)
def test_surfaces_at_arrays_that_broadcast(surface):
    u, v = np.array([[0.1], [0.4]]), np.array([0.0, 0.3, 0.5])
    points, jets = surface.point(u, v), surface.jet(u, v)
    assert points.shape == (2, 3, 3) and jets.shape == (2, 3) and jets.dtype == object
    for i, j in np.ndindex(2, 3):
        one = surface.jet(float(u[i, 0]), float(v[j]))
        assert np.array_equal(points[i, j], surface.point(float(u[i, 0]), float(v[j])))
        assert np.array_equal(jets[i, j].uv, one.uv) and np.array_equal(jets[i, j].p, one.p)
    assert surface.point(0.25, v).shape == (3, 3)
    with pytest.raises(ValueError, match=r"has shape \(2\), \w+ \(3\): they do not broadcast"):
        surface.point([0, 1], v)


def test_frames_at_arrays():
    inflection = seamwright.BezierCurve([[0, 0, 0], [1, 1, 0], [2, -1, 0], [3, 0, 0]])
    t = np.array([0.25, 0.5, 0.75])
    frames = seamwright.frenet_frame(inflection, t)
    assert list(frames.kind) == ["regular", "inflection", "regular"]
    assert np.isnan(frames.normal[1]).all() and np.isnan(frames.torsion_per_mm[1])
    for i in (0, 2):
        one = seamwright.frenet_frame(inflection, float(t[i]))
        for key, value in one.items():
            assert np.array_equal(frames[key][i], value), key
    line = seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])
    assert seamwright.frenet_frame(line, T).normal.shape == (2, 3, 3)


def test_shapes_at_arrays():
    shapes = seamwright.surface_shape(PATCH, T, 0.5, [1, 0, 0])
    assert shapes.tensor_per_mm.shape == (2, 3, 3, 3)
    one = seamwright.surface_shape(PATCH, 0.25, 0.5, [1, 0, 0])
    for key, value in one.items():
        assert np.array_equal(shapes[key][0, 1], value), key


def test_lengths_at_arrays():
    lengths = seamwright.arc_length(CURVE, 1e-9, 0, [0.25, 0.5, 1])
    assert lengths.value_mm.shape == (3,) and lengths.reached.dtype == bool
    assert lengths.value_mm[1] == seamwright.arc_length(CURVE, 1e-9, 0, 0.5).value_mm
    t = seamwright.parameter_at_length(CURVE, lengths.value_mm, 1e-8)
    assert t == pytest.approx([0.25, 0.5, 1], abs=1e-6)
    assert isinstance(seamwright.parameter_at_length(CURVE, 0.1, 1e-8), float)


def test_polynomials_at_arrays():
    p = seamwright.BernsteinPolynomial([0, 1, 0, 3])
    lower, upper = p.evaluate(T)
    assert lower.shape == T.shape and (lower[0, 1], upper[0, 1]) == p.evaluate(0.25)


def test_alpha_functions_at_arrays():
    rows = seamwright.alpha_basis(0.8, T)
    assert rows.shape == (2, 3, 4) and np.array_equal(rows[1, 2], seamwright.alpha_basis(0.8, 1))


NUMBERS = [np.float64(0.5), np.float32(0.5), np.array(0.5), np.float16(0.5)]
WHOLES = [np.int64(2), np.int8(2), np.uint32(2), np.array(2)]


@pytest.mark.parametrize("half", NUMBERS, ids=lambda n: n.dtype.name)
def test_numbers_of_numpy_are_numbers(half):
    points = RANDOM.normal(size=(5, 3))
    square = np.stack([*np.meshgrid(range(4), range(4)), np.zeros((4, 4))], axis=-1)
    calls = [
        lambda n: CURVE.point(n).tolist(),
        lambda n: CURVE.split(n),
        lambda n: PATCH.iso_curve_u(n),
        lambda n: seamwright.frenet_frame(CURVE, n),
        lambda n: seamwright.arc_length(CURVE, n, 0, n),
        lambda n: seamwright.nu_spline(points, nu=n),
        lambda n: seamwright.gamma_spline(points, n, n),
        lambda n: seamwright.continuation(PATCH, "u1", alpha=n, beta=[n, n]),
        lambda n: seamwright.alpha_surface(square, n, n),
        lambda n: seamwright.enclose_seam(PATCH, "u1", PATCH, "u0", gap_mm=n, angle_deg=n),
        lambda n: seamwright.n_sided_fill(sides(), corner_tolerance_rad=0 * n),
        lambda n: seamwright.BernsteinPolynomial([1, 2], n).split(n),
        lambda n: n * seamwright.BernsteinPolynomial([1, 2]) * n,
        lambda n: seamwright.spline_knots(points, n),
    ]
    for call in calls:
        assert call(half) == call(0.5)


def sides():
    corners = np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0.0]])
    return [
        seamwright.BezierCurve(np.linspace(a, b, 4))
        for a, b in zip(corners, np.roll(corners, -1, axis=0))
    ]


@pytest.mark.parametrize("two", WHOLES, ids=lambda n: n.dtype.name + str(n.ndim))
def test_whole_numbers_of_numpy_are_whole_numbers(two):
    calls = [
        lambda n: CURVE.derivatives(0.5, n).tolist(),
        lambda n: SPLINE.segment(n),
        lambda n: seamwright.fit_beta(CURVE, CURVE, n),
        lambda n: seamwright.continuation(PATCH, "u1", order=n),
        lambda n: TRIANGLE.to_patch(n),
        lambda n: seamwright.n_sided_fill(sides(), fairness_order=n),
        lambda n: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", n, degree_beta=n),
        lambda n: SURFACE.with_raised_knots("u", n),
        lambda n: SPLINE.to_bspline(n) if SPLINE.continuity() >= 2 else None,
    ]
    for call in calls:
        assert call(two) == call(2)


def test_flags_of_numpy_are_flags():
    for flag in (np.True_, np.array(True)):
        assert seamwright.continuation(PATCH, "u1", reversed=flag) == (
            seamwright.continuation(PATCH, "u1", reversed=True)
        )
        with pytest.raises(ValueError, match="t is"):
            CURVE.point(flag)
        with pytest.raises(ValueError, match="order is"):
            CURVE.derivatives(0, flag)


def test_numbers_of_other_precision_make_the_same_curve():
    poles = np.arange(9).reshape(3, 3)
    for kind in (np.float32, np.int16, np.uint8):
        assert seamwright.BezierCurve(poles.astype(kind)) == seamwright.BezierCurve(poles)
    assert seamwright.BezierCurve(poles[:, ::-1]) == seamwright.BezierCurve(
        poles[:, ::-1].copy(order="F")
    )
