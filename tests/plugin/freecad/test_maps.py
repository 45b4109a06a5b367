# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of maps, their colours, seams at points, nearest points: pure numpy."""

import math

import numpy
import pytest

from freecad.seamwright.plain import (
    curvature, map_text, maps, nearest, ramps, seam_profile, seam_text, ticks
)  # fmt: skip

DIRECTIONS = numpy.array([(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, 0.6, 0.8)], float)


@pytest.fixture
def random():
    return numpy.random.default_rng(20261127)


def test_curvatures_of_a_torus_a_saddle_and_a_plane():
    principal = numpy.array([(0.1, -0.2), (0.3, -0.3), (0.0, 0.0), (math.nan, math.nan)])
    wanted = {
        maps.MEAN: [-0.05, 0.0, 0.0],
        maps.GAUSSIAN: [-0.02, -0.09, 0.0],
        maps.LARGEST: [0.2, 0.3, 0.0],
        maps.RADIUS: [5.0, 1 / 0.3, math.inf],
    }
    for quantity, values in wanted.items():
        found = maps.curvature_values(quantity, principal)
        assert found[:3] == pytest.approx(values, rel=1e-12)
        assert math.isnan(found[3])


def test_draft_and_isophote_angles_are_complements():
    draft = maps.draft_angles_deg(DIRECTIONS, (0, 0, 2))
    assert draft == pytest.approx([90, -90, 0, math.degrees(math.asin(0.8))])
    angles = maps.isophote_angles_deg(DIRECTIONS, (0, 0, 2))
    assert angles == pytest.approx(90 - draft)
    assert math.isnan(maps.draft_angles_deg(numpy.zeros((1, 3)), (0, 0, 1))[0])


@pytest.mark.parametrize("bad", [(0, 0, 0), (1, 2), (math.nan, 0, 1)])
def test_a_bad_direction_is_named(bad):
    with pytest.raises(ValueError, match="Pull = .*three numbers"):
        maps.unit(bad, "Pull")


def test_highlight_lines_of_a_plane_have_the_spacing_of_the_lamps(random):
    points = random.uniform(-50, 50, (40, 3)) * (1, 1, 0)
    normals = numpy.tile((0.0, 0.0, 1.0), (40, 1))
    found = maps.highlight_positions(points, normals, (1, 0, 0), (0, 0, 1), 100.0, 5.0)
    assert abs(found) == pytest.approx(abs(points[:, 1]) / 5)


def test_highlight_lines_of_a_cylinder_meet_the_lamps(random):
    """The normal at the angle a of a cylinder about x reaches the height h at h tan a."""
    angles = random.uniform(-1.2, 1.2, 50)
    normals = numpy.stack([0 * angles, numpy.sin(angles), numpy.cos(angles)], axis=1)
    for radius in (3.0, 40.0):
        found = maps.highlight_positions(radius * normals, normals, (1, 0, 0), (0, 0, 1), 60.0, 7.0)
        assert abs(found) == pytest.approx(abs(60 * numpy.tan(angles)) / 7)


def test_highlight_lines_where_there_are_none():
    points, normals = numpy.zeros((2, 3)), numpy.array([(1.0, 0, 0), (0, 1.0, 0)])
    found = maps.highlight_positions(points, normals, (1, 0, 0), (0, 0, 1), 60.0, 7.0)
    assert numpy.isnan(found).all()
    with pytest.raises(ValueError, match="the lights run in the direction"):
        maps.highlight_positions(points, normals, (0, 0, 1), (0, 0, 2), 60.0, 7.0)


def test_extremes_leave_out_what_is_undefined():
    points = numpy.arange(12.0).reshape(4, 3)
    found = maps.extremes(numpy.array([math.nan, 3.0, -1.0, math.inf]), points)
    assert (found["least"], found["largest"]) == (-1.0, 3.0)
    assert (found["least_at"], found["largest_at"]) == ([6, 7, 8], [3, 4, 5])
    assert maps.extremes(numpy.array([math.nan]), points)["largest"] is None


@pytest.mark.parametrize(
    "least, largest, text",
    [
        (-0.153, 0.0, "\u22120.153 to 0 1/mm, the strongest at (1, 2, 3)"),
        (-0.1, 0.2, "\u22120.1 to 0.2 1/mm, the strongest at (4, 5, 6)"),
        (0.0, 0.0, "0 1/mm everywhere"),
    ],
)
def test_the_summary_has_the_place_of_the_strongest_curvature(least, largest, text):
    report = {"quantity": "Mean", "unit": "1/mm", "undefined": False, "least": least,
              "largest": largest, "least_at": [1, 2, 3], "largest_at": [4, 5, 6],
              "faces": 2, "points": 9, "faults": []}  # fmt: skip
    assert map_text.curvature_text(report) == "Mean curvature %s. 2 faces, 9 points." % text


def rgb_at(look, index):
    place = look.places[index]
    return tuple(look.row[min(int(place * ramps.PIXELS), ramps.PIXELS - 1)].round())


def test_mean_curvature_is_white_at_zero_and_has_one_scale_for_both_signs():
    values = numpy.array([-0.1, 0.0, 0.1, math.nan])
    look = ramps.curvature_look(maps.MEAN, values, numpy.ones(4), None)
    assert look.places[:3] == pytest.approx([0, 0.5, 1])
    assert math.isnan(look.places[3])
    assert rgb_at(look, 0) == curvature.RAMP[0][1] and rgb_at(look, 2) == curvature.RAMP[-1][1]
    title, entries, _ = look.legend
    assert title == "Mean curvature" and entries[0][1] == "+0.1 1/mm"
    assert entries[2][0].rgb == pytest.approx((250, 250, 250), abs=2)


def test_ranges_that_are_given():
    values = numpy.array([-2.0, 0.0, 1.0, 9.0])
    look = ramps.curvature_look(maps.MEAN, values, numpy.ones(4), (-1.0, 3.0))
    assert look.places == pytest.approx([0, 0.25, 0.5, 1])
    assert rgb_at(look, 1) == pytest.approx((250, 250, 250), abs=2), "white stays zero"
    look = ramps.curvature_look(maps.RADIUS, 1 / numpy.array([0.2, 0.1, 0.05]), values, (5, 20))
    assert look.places == pytest.approx([1, 1 / 3, 0]), "colours go with the curvature"
    with pytest.raises(ValueError, match="Lowest = 0"):
        ramps.curvature_look(maps.RADIUS, values, values, (0.0, 20.0))


def test_gaussian_curvature_of_a_large_ball_is_not_flat():
    values = numpy.full(9, 1e-8)  # radius 10 m
    assert ramps.curvature_look(maps.GAUSSIAN, values, numpy.ones(9), None).places[0] == (
        pytest.approx(1.0, abs=1e-6)
    )


def test_draft_colours_change_exactly_at_the_limits():
    angles = numpy.array([3.1, 2.9, -2.9, -3.1, 0.0])
    look = ramps.draft_look(angles, 3.0, 3.0)
    wanted = [ramps.TOWARDS, ramps.STEEP, ramps.STEEP, ramps.AWAY, ramps.STEEP]
    assert [rgb_at(look, k) for k in range(5)] == wanted


def test_pictures_have_a_row_for_what_is_undefined():
    look = ramps.stripes_look(numpy.array([0.0, 2.5, math.nan]), 0.25)
    width, height, data = ramps.image(look)
    pixels = numpy.frombuffer(data, numpy.uint8).reshape(height, width, 3)
    assert tuple(pixels[0, 0]) == ramps.DARK and tuple(pixels[0, width // 2]) == ramps.LIGHT
    assert (pixels[height // 2 :] == ramps.UNDEFINED).all() and width == height
    assert abs((pixels[0] == ramps.DARK).all(axis=1).mean() - 0.25) < 1.5 / width
    assert ramps.texture_places(look).tolist() == [[0, 0.25], [2.5, 0.25], [0, 0.75]]


def cylinder_side(angles, heights, radius):
    """Points and derivatives of a cylinder about z, by its angle and its height."""
    c, s, zero = numpy.cos(angles), numpy.sin(angles), 0 * angles
    points = numpy.stack([radius * c, radius * s, heights], axis=1)
    su = radius * numpy.stack([-s, c, zero], axis=1)
    sv = numpy.tile((0.0, 0.0, 1.0), (len(angles), 1))
    suu = -radius * numpy.stack([c, s, zero], axis=1)
    return seam_profile.side(points, (su, sv), (suu, 0 * suu, 0 * suu))


def test_crossed_cylinders_differ_although_their_curvatures_are_equal():
    """Radius 10 about z, and about y: where both touch x = 10 they differ by 0.1 per mm."""
    one = cylinder_side(numpy.zeros(3), numpy.zeros(3), 10.0)
    swap = numpy.array([(1.0, 0, 0), (0, 0, 1), (0, 1, 0)])
    other = seam_profile.Side(
        one.points, -(one.normals @ swap.T), -(swap @ one.tensors @ swap.T)
    )
    for first, second in ((one, other), (other, one)):
        found = seam_profile.profile(first, second, 1e5, 5.0)
        assert found["gap_mm"] == pytest.approx(0, abs=1e-12)
        assert found["angle_deg"] == pytest.approx(0, abs=1e-9)
        assert found["curvature_per_mm"] == pytest.approx(0.1)
        assert found["curvature_rel"] == pytest.approx(1.0)


def test_gap_angle_and_what_a_kink_leaves_out():
    one = cylinder_side(numpy.zeros(2), numpy.array([0.0, 5.0]), 10.0)
    for degrees in (3.0, 8.0):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        turn = numpy.array([(c, -s, 0), (s, c, 0), (0, 0, 1)])
        other = seam_profile.Side(
            one.points + (0.3, 0, 0.4), one.normals @ turn.T, turn @ one.tensors @ turn.T
        )
        found = seam_profile.profile(one, other, 1e5, 5.0)
        assert found["gap_mm"] == pytest.approx(0.5)
        assert found["angle_deg"] == pytest.approx(degrees)
        if degrees > 5:
            assert numpy.isnan(found["curvature_per_mm"]).all()
        else:
            assert found["curvature_per_mm"] == pytest.approx(0, abs=1e-12), "a kink counts once"


def test_planes_at_a_right_angle():
    flat = numpy.zeros((1, 3, 3))
    normals = [numpy.array([each]) for each in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0))]
    one, other = (seam_profile.Side(numpy.zeros((1, 3)), each, flat) for each in normals)
    assert seam_profile.profile(one, other, 1e5, 5.0)["angle_deg"] == pytest.approx(90)


def test_a_flat_radius_makes_curvatures_equal():
    one, other = (cylinder_side(numpy.zeros(2), numpy.zeros(2), r) for r in (2e5, 9e5))
    assert seam_profile.profile(one, other, 1e5, 5.0)["curvature_rel"].tolist() == [0, 0]


def test_nearest_points_of_triangles_against_dense_samples(random):
    corners = random.normal(size=(120, 1, 3)) * 3 + random.normal(size=(120, 3, 3))
    points = random.normal(size=(150, 3)) * 4
    found = nearest.nearest(points, corners)
    steps = numpy.linspace(0, 1, 61)
    weights = numpy.array([(1 - a - b, a, b) for a in steps for b in steps if a + b <= 1 + 1e-12])
    samples = (weights @ corners).reshape(-1, 3)
    for point, distance in zip(points, found.distances):
        sampled = numpy.linalg.norm(samples - point, axis=1).min()
        assert distance <= sampled + 1e-12 and sampled - distance < 0.08
    feet = (found.weights[:, :, None] * corners[found.triangles]).sum(axis=1)
    assert numpy.linalg.norm(points - feet, axis=1) == pytest.approx(found.distances)
    assert (found.weights >= -1e-12).all()


def test_nearest_points_can_be_stopped_and_triangles_may_have_no_area():
    corners = numpy.array([[(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(9, 9, 9)] * 3], float)
    points = numpy.array([(1.5, 2, 0), (9, 9, 10)], float)
    assert nearest.nearest(points, corners).distances == pytest.approx([2, 1])
    assert nearest.nearest(points, corners, lambda share: False) is None


def test_ticks_are_round():
    assert ticks.ticks(0, 1, 4) == pytest.approx([0, 0.5, 1])
    assert ticks.ticks(0, 0.034, 4) == pytest.approx([0, 0.01, 0.02, 0.03])
    assert ticks.ticks(3, 3, 4) == [3]


def seam(**bounds):
    none = dict.fromkeys(("gap_mm", "angle_deg", "curvature_per_mm", "curvature_rel"))
    return {"name": "Box.Edge3", "level": "G1", "bounds": {**none, **bounds}}


def test_bounds_say_whether_they_are_proven():
    proven = seam(angle_deg={"lower": 1.2, "upper": 1.5, "at": 0.5})
    assert seam_text.bound_line(proven, "angle_deg") == (
        "Box.Edge3: the largest value is 1.2..1.5\u00b0, proven."
    )
    seen = seam(angle_deg={"lower": 1.2, "upper": None, "at": 0.5})
    assert "seen, without an upper bound" in seam_text.bound_line(seen, "angle_deg")
    assert "not measured" in seam_text.bound_line(seen, "curvature_rel")
    bent = seam(curvature_rel={"lower": 0.12, "upper": 0.15, "at": 0.5})
    assert seam_text.bound_line(bent, "curvature_rel").endswith("is 12..15 %, proven.")


def test_quantities_and_their_units():
    assert maps.UNITS == {
        "Mean": "1/mm", "Gaussian": "1/mm\u00b2", "Largest": "1/mm", "Smallest radius": "mm"
    }  # fmt: skip
    assert list(maps.UNITS) == list(maps.QUANTITIES)


def test_normals_that_are_a_little_too_long_have_angles():
    normals = numpy.array([(0, 0, 1), (0, 0, -1)]) * (1 + 1e-15)
    assert maps.draft_angles_deg(normals, (0, 0, 1)) == pytest.approx([90, -90])
    assert maps.isophote_angles_deg(normals, (0, 0, 1)) == pytest.approx([0, 180])


def test_a_normal_almost_along_the_lights_has_no_highlight():
    normals = numpy.array([(0, 1, 1e-12), (0, 0.6, 0.8)])
    found = maps.highlight_positions(numpy.zeros((2, 3)), normals, (1, 0, 0), (0, 0, 1), 8.0, 3.0)
    assert math.isnan(found[0]) and abs(found[1]) == pytest.approx(2), "6 mm beside, of 3"


#: A triangle with x from 0 over 1 to 4; the apex at x = 1 is 3 high: its section at x is 3 x up to
#: there and 4 - x beyond.
SLOPE = numpy.array([(4, 0, 5), (0, 0, 5), (1, 3, 5)], float)


@pytest.mark.parametrize(
    "limit, area",
    [(-1, 6), (0, 6), (0.5, 6 - 0.375), (1, 4.5), (2, 2), (3, 0.5), (4, 0), (5, 0)],
)
@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 2, 0)])
def test_the_area_above_a_limit_is_that_of_the_section(limit, area, order):
    for shift in (0.0, 7.0, -30.0):
        found = maps.area_above(SLOPE, numpy.array([order]), SLOPE[:, 0] + shift, limit + shift)
        assert found == pytest.approx((area, 6))


def test_areas_of_all_triangles_that_are_known_are_added():
    points = numpy.concatenate([SLOPE, [(4, 0, 8), (0, 1, 5)]])
    values = numpy.array([4, 0, 1, math.nan, 0.0])
    triangles = numpy.array([(0, 1, 2), (1, 2, 4), (0, 2, 3)])
    # the second has the base 1 at x = 0 and the height 1: 0.25 of its 0.5 lie beyond x = 0.5
    assert maps.area_above(points, triangles, values, 0.5) == pytest.approx((5.625 + 0.125, 6.5))
    level = numpy.full(3, 2.0)
    for limit, area in ((1.9, 6), (2.0, 6), (2.1, 0)):
        assert maps.area_above(SLOPE, numpy.array([(0, 1, 2)]), level, limit) == pytest.approx(
            (area, 6)
        )


def test_a_surface_that_twists_has_a_mixed_curvature():
    """z = x y at the origin, its parameters a tenth as large: nothing along x and y, 1 across."""
    row = [numpy.array([each], float) for each in ((0.1, 0, 0), (0, 0.1, 0))]
    still = numpy.zeros((1, 3))
    found = seam_profile.side(still, row, (still, numpy.array([(0, 0, 0.01)]), still))
    assert found.normals == pytest.approx(numpy.array([(0, 0, 1)]))
    assert found.tensors[0] == pytest.approx(numpy.array([(0, 1, 0), (1, 0, 0), (0, 0, 0)]))
    still = seam_profile.side(still, (row[0], row[0]), (still, still, still))
    assert numpy.isnan(still.normals).all() and numpy.isnan(still.tensors).all()


def test_the_other_sense_of_the_normal_is_no_difference(random):
    """Also where the sides meet at an angle, about any axis along the seam or across it."""
    one = cylinder_side(numpy.zeros(1), numpy.zeros(1), 10.0)
    for axis in random.normal(size=(6, 3)):
        axis[0] = 0  # across the normal (1, 0, 0), so that the angle is that of the turn
        x, y, z = axis / numpy.linalg.norm(axis)
        cross = numpy.array([(0, -z, y), (z, 0, -x), (-y, x, 0)])
        angle = math.radians(4)
        turn = numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
        frame = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
        for sign in (1, -1):
            other = seam_profile.Side(
                one.points, sign * one.normals @ turn.T, sign * turn @ one.tensors @ turn.T
            )
            sides = (
                seam_profile.Side(
                    each.points @ frame.T, each.normals @ frame.T, frame @ each.tensors @ frame.T
                )
                for each in (one, other)
            )
            found = seam_profile.profile(*sides, 1e5, 5.0)
            assert found["angle_deg"] == pytest.approx(4)
            assert found["curvature_per_mm"] == pytest.approx(0, abs=1e-12)
            assert found["curvature_rel"] == pytest.approx(0, abs=1e-12)


def test_radii_below_the_flat_one_differ():
    one, other = (cylinder_side(numpy.zeros(1), numpy.zeros(1), r) for r in (0.8e5, 0.9e5))
    found = seam_profile.profile(one, other, 1e5, 5.0)["curvature_rel"]
    assert found == pytest.approx(1 - 0.8 / 0.9)


def test_directions_of_lights_need_no_unit_length_and_no_right_angle():
    """At the angle a of a cylinder about x the height 60 is reached at 60 tan a, 7 apart."""
    angles = numpy.array([-0.5, 0.3, 1.0])
    normals = numpy.stack([0 * angles, numpy.sin(angles), numpy.cos(angles)], axis=1)
    wanted = 60 * numpy.tan(angles) / 7
    for along, towards in (((3, 0, 0), (0, 0, 5)), ((2, 0, 0), (3, 0, 1)), ((1, 0, 0), (-9, 0, 4))):
        for sense in (1, -1):
            found = maps.highlight_positions(normals, sense * normals, along, towards, 60.0, 7.0)
            assert found * numpy.sign(found[2]) == pytest.approx(wanted), "a line has no sense"


def test_a_direction_that_is_none_is_named():
    said = " = 0; 0; 0: three numbers are needed, not all zero"
    none, up = (0, 0, 0), (0, 0, 1)
    for name, along, towards in (("along", none, up), ("towards", up, none)):
        with pytest.raises(ValueError) as caught:
            maps.highlight_positions(DIRECTIONS, DIRECTIONS, along, towards, 60.0, 7.0)
        assert str(caught.value) == name + said
    with pytest.raises(ValueError) as caught:
        maps.isophote_angles_deg(DIRECTIONS, none)
    assert str(caught.value) == "direction" + said


def test_without_finite_values_there_are_no_extremes():
    found = maps.extremes(numpy.array([math.inf, math.nan]), numpy.zeros((2, 3)))
    assert found == dict.fromkeys(("least", "largest", "least_at", "largest_at"))


@pytest.mark.parametrize("least, largest, wanted", [
    (-0.25, 0.125, (-0.25, 0.25)),
    (0.012345, 2.0, (0.0123, 2.0)),
    (-3.0, -1.0, (-3.0, -1.0)),
    (0.5, 0.5, ()),
])
def test_a_range_of_the_user_begins_with_the_values_found(least, largest, wanted):
    assert maps.given_range({"least": least, "largest": largest}) == wanted


def test_no_sampled_value_is_above_its_proven_bound():
    values = numpy.array([0.5, 1.2, numpy.nan, 88.0])
    bound = {"lower": 1.0, "upper": 1.25}
    found = seam_profile.within(values, bound, False)
    numpy.testing.assert_array_equal(found, [0.5, 1.2, numpy.nan, 1.25])
    found = seam_profile.within(values, bound, True)
    numpy.testing.assert_array_equal(found, [0.5, 1.2, numpy.nan, numpy.nan])
    for unknown in (None, {"lower": 1.0, "upper": None}):
        assert seam_profile.within(values, unknown, True) is values
