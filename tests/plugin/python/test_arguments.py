# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad arguments: every message begins with or contains the name of the argument and its value."""

import math
import re

import numpy as np
import pytest
import seamwright
from seamwright import BezierCurve, BezierPatch

LINE = BezierCurve([[0, 0, 0], [1, 0, 0]])
BEND = BezierCurve([[1, 0, 0], [2, 0, 0], [3, 1, 0]])
SPLINE = seamwright.nu_spline([[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 1.0]]).curve
X, Y = np.meshgrid([0.0, 1, 2, 3], [0.0, 1, 2, 3], indexing="ij")
NET = np.stack([X, Y, 0 * X], axis=-1)
PATCH = BezierPatch(NET)
SURFACE = seamwright.BSplineSurface.from_patch(PATCH)
TRIANGLE = seamwright.BezierTriangle([[0, 0, 0], [0, 1, 0], [1, 0, 0]])
POINTS = [[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 1.0]]
POLYNOMIAL = seamwright.BernsteinPolynomial([0, 1])
CORNERS = np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0.0]])
SIDES = [
    BezierCurve(np.linspace(a, b, 4)) for a, b in zip(CORNERS, np.roll(CORNERS, -1, axis=0))
]
SPOKES = [[[0, 0, 0], np.array(d) / 2, d] for d in ([1, 0, 0], [0, 1, 0], [-1, -1, 0.0])]

PLANE = [[0, 0], [4, 3], [9, 4], [13, 1.0]]
ENDS = ([0, 0], -0.4, [9, 3], 1.1)
ARC = seamwright.PlanarArc([0, 0], 0, 0.1, 9)
CLOTHOID = seamwright.clothoid(*ENDS)
CONIC = seamwright.PlanarConic([0, 0], [1, 1], [2, 0])

# Functions of one argument, by its name.
PARAMETERS = [
    ("t", LINE.point),
    ("t", LINE.jet),
    ("t", lambda x: LINE.derivatives(x, 1)),
    ("t", SPLINE.point),
    ("t", lambda x: SPLINE.derivatives(x, 1)),
    ("t", lambda x: seamwright.frenet_frame(LINE, x)),
    ("t", lambda x: seamwright.alpha_basis(1, x)),
    ("u", lambda x: PATCH.point(x, 0)),
    ("v", lambda x: PATCH.jet(0, x)),
    ("u", lambda x: SURFACE.point(x, 0)),
    ("v", lambda x: SURFACE.jet(0, x)),
    ("l0", lambda x: TRIANGLE.point(x, 0)),
    ("l1", lambda x: TRIANGLE.jet(0, x)),
    ("u", lambda x: seamwright.surface_shape(PATCH, x, 0)),
    ("first", lambda x: seamwright.arc_length(LINE, 1e-3, x)),
    ("last", lambda x: seamwright.arc_length(LINE, 1e-3, 0, x)),
    ("length_mm", lambda x: seamwright.parameter_at_length(LINE, x, 1e-3)),
    ("s_mm", ARC.point),
    ("s_mm", seamwright.ArcChain([ARC]).curvature_at_per_mm),
    ("s_mm", CLOTHOID.direction_at_rad),
    ("u_rad", seamwright.log_spiral(*ENDS).point),
    ("t", CONIC.curvature_at_per_mm),
]
NUMBERS = [
    ("direction_rad", lambda x: seamwright.arc_through([0, 0], x, [1, 0])),
    ("end_direction_rad", lambda x: seamwright.clothoid([0, 0], 0, [1, 0], x)),
    ("distance_mm", ARC.offset),
    ("tolerance_mm", CLOTHOID.bezier_spline),
    ("weight", lambda x: seamwright.PlanarConic([0, 0], [1, 1], [2, 0], x)),
    ("growth", lambda x: seamwright.LogSpiral([0, 0], 0, 1, x, 1)),
    ("corner_rad", lambda x: seamwright.fit_arcs(LINE, corner_rad=x)),
    ("corner_rad", lambda x: seamwright.fit_clothoids(LINE, corner_rad=x)),
    ("corner_rad", lambda x: seamwright.point_corners(PLANE, corner_rad=x)),
    ("error_mm", lambda x: seamwright.point_corners(PLANE, error_mm=x)),
    ("tolerance_mm", lambda x: seamwright.sampled_arcs(PLANE, tolerance_mm=x)),
    ("start_share", lambda x: seamwright.two_conics(*PLANE[:3], -1, -1, start_share=x)),
    ("start_curvature_per_mm", lambda x: seamwright.clothoid_spline(
        PLANE, start_curvature_per_mm=x)),
    ("strength", lambda x: seamwright.filter_curvature(PLANE, 1, strength=x)),
    ("t", LINE.split),
    ("t", PATCH.split_u),
    ("u", PATCH.iso_curve_u),
    ("l0", lambda x: TRIANGLE.split_at(x, 0)),
    ("tolerance_mm", lambda x: seamwright.arc_length(LINE, x)),
    ("resolution", lambda x: seamwright.find_degeneracies(LINE, x)),
    ("length_mm", lambda x: seamwright.fit_beta(LINE, BEND, length_mm=x)),
    ("length", lambda x: seamwright.curve_join_poles(LINE, 3, [1], length=x)),
    ("gap_mm", lambda x: seamwright.enclose_seam(PATCH, "u1", PATCH, "u0", gap_mm=x)),
    ("angle_deg", lambda x: seamwright.measure_joint(LINE, BEND, angle_deg=x)),
    ("tolerance", lambda x: seamwright.join_condition(PATCH, "u1", PATCH, "u0", tolerance=x)),
    ("nu", lambda x: seamwright.nu_spline(POINTS, nu=x)),
    ("exponent", lambda x: seamwright.spline_knots(POINTS, x)),
    ("a_u", lambda x: seamwright.alpha_surface(NET, x)),
    ("a", lambda x: seamwright.alpha_curve(POINTS, x)),
    ("a_min", lambda x: seamwright.energy_optimal_alpha(POINTS, a_min=x)),
    ("beta1", lambda x: seamwright.alpha_join_poles(POINTS, 1, beta1=x)),
    ("corner_tolerance_rad", lambda x: seamwright.n_sided_fill(SIDES, corner_tolerance_rad=x)),
    ("gap_mm", lambda x: seamwright.umbrella(SPOKES, gap_mm=x)),
    ("knot", lambda x: SURFACE.with_knot("u", x)),
    ("padding", lambda x: seamwright.BernsteinPolynomial([1], x)),
    ("alpha", lambda x: seamwright.continuation(PATCH, "u1", alpha=x)),
]
WHOLES = [
    ("order", lambda x: LINE.derivatives(0, x)),
    ("order", lambda x: SPLINE.derivatives(0, x)),
    ("order", lambda x: SPLINE.measure_joints(x)),
    ("i", SPLINE.segment),
    ("order", lambda x: seamwright.measure_joint(LINE, BEND, x)),
    ("order", lambda x: seamwright.fit_beta(LINE, BEND, x)),
    ("degree", lambda x: seamwright.curve_join_poles(LINE, x, [1])),
    ("degree", lambda x: seamwright.BSplineCurve(x, [0, 0, 1, 1], POINTS[:2])),
    ("degree_u", lambda x: seamwright.BSplineSurface(NET, [0, 1], [0, 1], x, 3)),
    ("order", lambda x: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", x)),
    ("degree_beta", lambda x: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", degree_beta=x)),
    ("order", lambda x: seamwright.continuation(PATCH, "u1", order=x)),
    ("order", lambda x: seamwright.blend(PATCH, "u1", PATCH, "u0", x)),
    ("max_iterations", lambda x: seamwright.curve_nearest_join(LINE, BEND, max_iterations=x)),
    ("fairness_order", lambda x: seamwright.n_sided_fill(SIDES, fairness_order=x)),
    ("curvature_degrees", lambda x: seamwright.ring_fill(SIDES, curvature_degrees=x)),
    ("spoke_degree", lambda x: seamwright.umbrella_inside(SIDES, spoke_degree=x)),
    ("apex", TRIANGLE.to_patch),
    ("by", POLYNOMIAL.elevated),
    ("times", lambda x: SURFACE.with_raised_knots("u", x)),
    ("count", lambda x: seamwright.euler_arcs(*ENDS, x)),
    ("max_steps", lambda x: seamwright.fair_points(PLANE, 1, max_steps=x)),
    ("index", lambda x: seamwright.fair_at_knot(LINE, x)),
]
FLAGS = [
    ("reversed", lambda x: seamwright.continuation(PATCH, "u1", reversed=x)),
    ("reversed", lambda x: seamwright.enclose_seam(PATCH, "u1", PATCH, "u0", reversed=x)),
    ("reversed", lambda x: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", reversed=x)),
    ("keep_end", lambda x: seamwright.curve_joined(LINE, BEND, [1], keep_end=x)),
    ("closed", lambda x: seamwright.umbrella(SPOKES, closed=x)),
    ("closed", lambda x: seamwright.gamma_spline(POINTS, closed=x)),
    ("around", SPLINE.continuity),
    ("parametric", lambda x: seamwright.alpha_nearest_join(NET, 1, 1, NET, 1, 1, parametric=x)),
    ("closed", lambda x: seamwright.biarc_spline(PLANE, closed=x)),
    ("closed", lambda x: seamwright.point_curvatures(PLANE, closed=x)),
    ("ends_fixed", lambda x: seamwright.fair_points(PLANE, 1, ends_fixed=x)),
]
ARRAYS = [
    ("poles", BezierCurve),
    ("poles", BezierPatch),
    ("poles", seamwright.BezierTriangle),
    ("poles", lambda x: seamwright.BSplineCurve(1, [0, 0, 1, 1], x)),
    ("weights", lambda x: BezierCurve(POINTS, x)),
    ("vertices", lambda x: seamwright.gamma_spline(x)),
    ("points", seamwright.nu_spline),
    ("points", seamwright.spline_knots),
    ("net", seamwright.alpha_surface),
    ("next_net", lambda x: seamwright.fit_alpha_seam(NET, 1, 1, x, 1, 1)),
    ("polygon", lambda x: seamwright.alpha_spline(x, [1])),
    ("derivatives", seamwright.arc_length_derivatives),
    ("corners", TRIANGLE.subtriangle),
    ("weights_a", lambda x: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", weights_a=x)),
    ("form", lambda x: seamwright.umbrella(SPOKES, form=x)),
    ("points", seamwright.biarc_spline),
    ("points", seamwright.clothoid_spline),
    ("points", lambda x: seamwright.fair_points(x, 1)),
    ("points", lambda x: seamwright.smoothing_spline(x, [0, 1], [0, 0, 1, 1], 1)),
]
LISTS = [
    ("beta", seamwright.beta_matrix),
    ("first", lambda x: seamwright.composed_beta([1], x)),
    ("scale", lambda x: seamwright.curve_join_poles(LINE, 3, [1], scale=x)),
    ("knots", lambda x: seamwright.BSplineCurve(1, x, POINTS[:2])),
    ("knots_v", lambda x: seamwright.BSplineSurface(NET, [0, 0, 1, 1], x, 3, 3)),
    ("parameters", lambda x: seamwright.rotation_minimizing_frames(LINE, x)),
    ("direction", lambda x: seamwright.surface_shape(PATCH, 0, 0, x)),
    ("coefficients", seamwright.BernsteinPolynomial),
    ("slopes", lambda x: seamwright.umbrella(SPOKES, slopes=x)),
    ("lengths", lambda x: seamwright.alpha_spline(POINTS, [1], lengths=x)),
    ("start", lambda x: seamwright.arc_through(x, 0, [1, 0])),
    ("end", lambda x: seamwright.biarc([0, 0], 0, x, 0)),
    ("corner", lambda x: seamwright.PlanarConic([0, 0], x, [2, 0])),
]
NAMES = [
    ("edge", lambda x: TRIANGLE.edge_curve(x)),
    ("edge_a", lambda x: seamwright.nearest_join(PATCH, x, PATCH, "u0")),
    ("edge_b", lambda x: seamwright.enclose_seam(PATCH, "u1", PATCH, x)),
    ("moves", lambda x: seamwright.nearest_join(PATCH, "u1", PATCH, "u0", moves=x)),
    ("moves", lambda x: seamwright.curve_nearest_join(LINE, BEND, moves=x)),
    ("direction", lambda x: SURFACE.with_knot(x, 0.5)),
    ("law", lambda x: seamwright.n_sided_fill(SIDES, law=x)),
    ("ends", lambda x: seamwright.nu_spline(POINTS, ends=x)),
    ("energy", lambda x: seamwright.energy_optimal_alpha(POINTS, x)),
    ("profile", lambda x: seamwright.measure_joint(LINE, BEND, profile=x)),
    ("level", lambda x: seamwright.enclose_seam(PATCH, "u1", PATCH, "u0", level=x)),
    ("tangents", lambda x: seamwright.biarc_spline(PLANE, tangents=x)),
    ("rule", lambda x: seamwright.biarc_spline(PLANE, rule=x)),
    ("ends", lambda x: seamwright.fair_curve(LINE.elevated(), 1, ends=x)),
]
SURFACES = [
    ("a", lambda x: seamwright.measure_pair(x, PATCH.jet(0, 0))),
    ("b", lambda x: seamwright.measure_pair(PATCH.jet(0, 0), x)),
    ("jet", seamwright.curvature_tensor),
    ("patch", lambda x: seamwright.surface_shape(x, 0, 0)),
    ("patch_a", lambda x: seamwright.enclose_seam(x, "u1", PATCH, "u0")),
    ("a", lambda x: seamwright.nearest_join(x, "u1", PATCH, "u0")),
    ("b", lambda x: seamwright.orient(PATCH, "u1", x, "u0")),
    ("patch", seamwright.BSplineSurface.from_patch),
    ("patch", seamwright.BezierTriangle.from_patch),
    ("curve", seamwright.BSplineCurve.from_bezier),
    ("arc", seamwright.PlanarConic.from_arc),
    ("surface", lambda x: seamwright.continuation(x, "u1")),
    ("given", lambda x: seamwright.joined(PATCH, "u1", x, "u1")),
]


# Functions of a sequence of other things than numbers.
SEQUENCES = [
    ("sides", seamwright.n_sided_fill),
    ("kinds", lambda x: seamwright.umbrella(SPOKES, kinds=x)),
    ("spokes", seamwright.umbrella),
    ("given", lambda x: seamwright.match_pieces([SPLINE, SPLINE], given=x)),
    ("keys", seamwright.match_pieces),
    ("segments", lambda x: seamwright.BezierSpline.from_segments(x, [0, 1])),
    ("arcs", seamwright.conics_of_arcs),
    ("chain", seamwright.g2_conics),
]


def cases(table, values, are_good=lambda name, value: False):
    """Each call with each value but those that it takes."""
    for number, (name, call) in enumerate(table):
        for value in values:
            if are_good(name, value):
                continue
            yield pytest.param(name, call, value, id=f"{name}-{number}-{value!r:.20}")


def named(name, call, value, kinds=ValueError):
    with pytest.raises(kinds) as caught:
        call(value)
    assert re.search(rf"(^|\W){re.escape(name)}(\W|$)", str(caught.value)), str(caught.value)


def is_end(name, value):
    """None is the end of the curve."""
    return value is None and name in ("first", "last")


@pytest.mark.parametrize(
    "name, call, value",
    cases(PARAMETERS, ["x", None, True, 1j, math.nan, [0, math.inf], ["a"]], is_end),
)
def test_parameters(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize("name, call, value", cases(NUMBERS, ["x", True, 1j, {}, object()]))
def test_numbers(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize("name, call, value", cases(WHOLES, ["x", True, 1.5, 2.0, [1], 1 << 70]))
def test_whole_numbers(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize("name, call, value", cases(FLAGS, [1, 0, "yes", None, np.int64(1)]))
def test_flags(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize(
    "name, call, value",
    cases(ARRAYS, ["x", [[1, "a", 2]], 1j * np.ones((4, 3)), np.ones((4, 3), bool), np.ones(7)]),
)
def test_arrays(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize(
    "name, call, value", cases(LISTS, ["x", 3, [1, "a"], [1, True], np.ones((2, 2)), [1j]])
)
def test_sequences(name, call, value):
    named(name, call, value)


@pytest.mark.parametrize(
    "name, call, value", cases(SEQUENCES, [3, "x", b"x", np.array(3), np.array(3.0), object()])
)
def test_sequences_of_other_things(name, call, value):
    named(name, call, value, (TypeError, ValueError))
    with pytest.raises((TypeError, ValueError), match="a sequence"):
        call(value)


@pytest.mark.parametrize("name, call, value", cases(NAMES, ["w", 3, None]))
def test_names(name, call, value):
    named(name, call, value)


def is_curve(name, value):
    return name == "curve" and value is LINE


@pytest.mark.parametrize("name, call, value", cases(SURFACES, [3, None, "x", NET, LINE], is_curve))
def test_surfaces(name, call, value):
    named(name, call, value, (TypeError, ValueError))


def test_numbers_that_are_nan_are_reported():
    for name, call in [*PARAMETERS, *NUMBERS]:
        with pytest.raises(ValueError) as caught:
            call(math.nan)
        assert "nan" in str(caught.value), (name, str(caught.value))


def test_unknown_arguments_are_named():
    for call in (seamwright.continuation, seamwright.join_rows):
        with pytest.raises(TypeError, match="gamma"):
            call(PATCH, "u1", gamma=1)
    with pytest.raises(TypeError, match="gamma"):
        seamwright.continuation(PATCH, "u1", connection={"gamma": 1})


def test_names_of_files_are_checked():
    for bad in (3, None, LINE):
        with pytest.raises(TypeError, match="^path is .*: the name of a file is needed"):
            seamwright.read(bad)


def test_messages_show_a_long_value_on_one_line():
    with pytest.raises(ValueError) as error:
        seamwright.arc_through(np.zeros((300, 3)), 0, [1, 1])
    assert "\n" not in str(error.value) and len(str(error.value)) < 300
    assert " ... " in str(error.value)


def test_joins_that_leave_the_range_of_numbers_are_refused():
    x, y = np.meshgrid([0.0, 1, 2, 3], [0.0, 1, 2, 3], indexing="ij")
    patch = seamwright.BezierPatch(np.stack([x, y, x * y], axis=-1))
    with pytest.raises(ValueError, match="not finite"):
        seamwright.join_rows(patch, "u1", alpha=1, beta=1e308)
