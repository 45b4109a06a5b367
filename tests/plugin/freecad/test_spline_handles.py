# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places of the handles of a spline, and its comb."""

import numpy
import pytest

from freecad.seamwright.plain import spline_handles

WAVE = numpy.array([(0, 0, 0), (10, 22, 0), (26, 18, 0), (34, 2, 0), (52, 6, 0)], float)


@pytest.mark.parametrize(
    "by_length, tensions", [(True, (0, 0.1, 3, 200)), (False, (1, 0, -2, -50))]
)
def test_a_place_of_a_handle_is_that_of_its_tension(by_length, tensions):
    slides = spline_handles.slides(WAVE, False, by_length)
    for tension in tensions:
        places = slides.places(numpy.full(len(WAVE), tension, float))
        for number, (place, point) in enumerate(zip(places, WAVE)):
            along = (place - point) @ slides.directions[number]
            assert slides.tension(number, along) == pytest.approx(tension, abs=1e-12)


@pytest.mark.parametrize("by_length, sign", [(True, 1), (False, -1)])
def test_tighter_is_further_out_and_out_is_outside_of_the_bend(by_length, sign):
    slides = spline_handles.slides(WAVE, False, by_length)
    loose, tight = (slides.places(numpy.full(5, sign * each)) for each in (0.1, 5.0))
    assert (numpy.linalg.norm(tight - WAVE, axis=1) > numpy.linalg.norm(loose - WAVE, axis=1)).all()
    for number in (1, 2, 3):
        to_middle = (WAVE[number - 1] + WAVE[number + 1]) / 2 - WAVE[number]
        assert slides.directions[number] @ to_middle < 0


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize(
    "points", [WAVE, [(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 0, 0), (0, 0, 5)], WAVE * [1, 0, 1]]
)
def test_directions_are_unit_vectors_also_on_a_line(points, closed):
    slides = spline_handles.slides(numpy.array(points, float), closed and len(points) > 3, True)
    assert numpy.linalg.norm(slides.directions, axis=1) == pytest.approx(1)
    assert numpy.isfinite(slides.places(numpy.zeros(len(points)))).all()


def test_vectors_of_a_circle_point_to_its_centre():
    at = numpy.linspace(0, 3, 9)
    circle = 5 * numpy.column_stack([numpy.cos(at), numpy.sin(at), 0 * at])
    first = 5 * numpy.column_stack([-numpy.sin(at), numpy.cos(at), 0 * at])
    vectors = spline_handles.curvature_vectors(first, -circle)
    numpy.testing.assert_allclose(vectors, -circle / 25, atol=1e-15)
    numpy.testing.assert_array_equal(spline_handles.curvature_vectors(0 * first, circle), 0)
    factor = spline_handles.comb_factor(circle, vectors, 0.15, 2.0)
    assert factor * 0.2 == pytest.approx(0.3 * numpy.linalg.norm(numpy.ptp(circle, axis=0)))
    assert spline_handles.comb_factor(circle, 0 * vectors, 0.15, 1.0) == 0


def test_the_nearest_pixel():
    pixels = [(0, 0), (10, 0), (10, 0), (numpy.nan, 3)]
    assert spline_handles.nearest(pixels, (9, 1), 5) == 2
    assert spline_handles.nearest(pixels, (5, 20), 5) is None
    assert spline_handles.nearest([], (0, 0), 5) is None


def test_the_nearest_point_of_lines():
    lines = numpy.array([[(0, 0), (10, 0), (20, 0)], [(0, 9), (0, 30), (0, 30)]], float)
    assert spline_handles.nearest_on_lines(lines, (13, 2), 5) == (0, 1, pytest.approx(0.3))
    assert spline_handles.nearest_on_lines(lines, (-3, 19.5), 5) == (1, 0, pytest.approx(0.5))
    assert spline_handles.nearest_on_lines(lines, (13, 9), 5) is None
    lines[0, 1] = numpy.nan
    assert spline_handles.nearest_on_lines(lines, (13, 2), 5) is None
    assert spline_handles.nearest_on_lines(numpy.zeros((0, 3, 2)), (0, 0), 5) is None


def test_grid_and_steps():
    numpy.testing.assert_allclose(
        spline_handles.rounded((1.26, -2.4, 7.77), numpy.array([0, 0, 1.0]), 0.5), (1.5, -2.5, 7.77)
    )
    assert tuple(spline_handles.rounded((1.26, 2, 3), numpy.array([1.0, 0, 0]), 0)) == (1.26, 2, 3)
    found = [spline_handles.fair_step(length) for length in (0.011, 0.02, 3, 7, 100)]
    assert found == pytest.approx([0.02, 0.02, 5, 10, 100])


#: A roof: its size is 20, its chords are 10 sqrt 2 long, and 20 sqrt 2 where it is closed.
ROOF = numpy.array([(0, 0, 0), (10, 10, 0), (20, 0, 0)], float)
CHORD = 200**0.5


def test_directions_halve_the_bends():
    found = spline_handles.slides(ROOF, False, True).directions
    assert found[1] == pytest.approx([0, 1, 0])
    # At the ends there is one neighbour: across the polygon, in its plane.
    assert abs(found[[0, 2]] @ (1, 1, 0)) == pytest.approx([0, CHORD / 10])
    assert abs(found[[0, 2]] @ (1, -1, 0)) == pytest.approx([CHORD / 10, 0])
    closed = spline_handles.slides(ROOF, True, True).directions
    # The way from one neighbour of the first point to the other is that from (20, 0) to (10, 10).
    assert closed[0] == pytest.approx([-(0.5**0.5), -(0.5**0.5), 0])
    assert closed[2] == pytest.approx([0.5**0.5, -(0.5**0.5), 0])


@pytest.mark.parametrize("points", [[(0, 0, 0), (5, 0, 0), (0, 0, 0)], [(0, 0, 0), (5, 0, 0)]])
def test_where_the_polygon_goes_back_the_way_it_came_handles_go_on(points):
    closed = len(points) == 2
    slides = spline_handles.slides(numpy.array(points, float), closed, True)
    assert slides.directions[1] == pytest.approx([1, 0, 0])
    assert numpy.linalg.norm(slides.directions, axis=1) == pytest.approx(1)


@pytest.mark.parametrize("far", [1.0, 40.0])
def test_handles_rest_at_a_part_of_the_size_or_of_the_distance_of_neighbours(far):
    """Of points 2 apart, the last one ``far`` away: parts of 6 % and 4 % of the size, at most 45 %
    and 30 % of the mean distance of the neighbours."""
    points = numpy.array([(0, 0, 0), (2, 0, 0), (4, 0, 0), (4 + 2 * far, 0, 0)])
    size = 4 + 2 * far
    chords = numpy.array([2, 2, 1 + far, 2 * far])
    slides = spline_handles.slides(points, False, True)
    assert slides.rest_mm == pytest.approx(numpy.minimum(0.06 * size, 0.45 * chords))
    assert slides.unit_mm == pytest.approx(numpy.minimum(0.04 * size, 0.3 * chords))
    assert slides.scale == pytest.approx(1 / chords)
    assert spline_handles.slides(points, False, False).scale == pytest.approx([-1] * 4)
    along = (slides.places(numpy.zeros(4)) - points) @ slides.directions[0]
    assert along == pytest.approx(slides.rest_mm), "no tension"


def test_tension_grows_as_the_hyperbolic_sine_of_the_way():
    slides = spline_handles.slides(ROOF, False, True)
    rest, unit = slides.rest_mm[1], slides.unit_mm[1]
    assert rest == pytest.approx(0.06 * 500**0.5) and unit == pytest.approx(0.04 * 500**0.5)
    assert slides.tension(1, rest) == 0
    assert slides.tension(1, rest + 2 * unit) == pytest.approx(3.6268604 / CHORD)  # sinh 2
    assert slides.tension(1, rest - 2 * unit) == pytest.approx(-3.6268604 / CHORD)


@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0])
def test_handles_on_a_line_point_up_in_its_plane(angle):
    """The side does not depend on the place: the largest part of the normal is positive."""
    line = numpy.outer(numpy.arange(3.0), (numpy.cos(angle), numpy.sin(angle), 0.0))
    for shift in ((0, 0, 0), (50, -20, 0), (-1e3, 1e3, 5)):
        found = spline_handles.slides(line + shift, False, True).directions
        assert found @ line[1] == pytest.approx(0, abs=1e-9)
        assert found == pytest.approx(numpy.tile(found[0], (3, 1)))


def test_curvature_does_not_depend_on_how_a_curve_is_run_through():
    """The parabola y = x^2 / 2 at x = 1, its parameter with speed 3 and acceleration 5."""
    first = numpy.array([(3, 3, 0)], float)
    second = numpy.array([(5, 5 + 9, 0)], float)
    (found,) = spline_handles.curvature_vectors(first, second)
    size = 2**-1.5
    assert found == pytest.approx([-size / 2**0.5, size / 2**0.5, 0])
    (small,) = spline_handles.curvature_vectors(first / 10, second / 100)
    assert small == pytest.approx(found)


def test_a_curve_that_is_straight_up_to_rounding_has_no_comb():
    points = numpy.array([(0, 0, 0), (100, 0, 0)], float)
    bent = numpy.array([(0, 1, 0), (0, 0, 0)], float)
    assert spline_handles.comb_factor(points, 0.9e-11 * bent, 0.15, 1.0) == 0
    found = spline_handles.comb_factor(points, 1.1e-11 * bent, 0.15, 1.0)
    assert found * 1.1e-11 == pytest.approx(15)


def test_the_reach_itself_is_reached():
    assert spline_handles.nearest([(0, 0), (9, 9)], (3, 4), 5) == 0
    assert spline_handles.nearest([(0, 0), (9, 9), (9, 9)], (9, 8), 5) == 2
    lines = numpy.array([[(0, 0), (10, 0)]], float)
    assert spline_handles.nearest_on_lines(lines, (5, 5), 5) == (0, 0, pytest.approx(0.5))


@pytest.mark.parametrize("size", [0.01, 1.0, 1e4])
@pytest.mark.parametrize("place", [(0, 0, 0), (100, -50, 7)])
def test_handles_go_with_the_size_and_not_with_the_place(size, place):
    points = numpy.array([(0, 0, 0), (2, 0, 0), (4, 0, -1e-7), (6, 0, 0), (10, 3, 0)], float)
    found = spline_handles.slides(size * (points + place), False, True)
    # A straight part points to the left, seen from the side to which the plane looks.
    assert found.directions[1:3] == pytest.approx(numpy.array([(0, 1, 0)] * 2), abs=1e-5)
    # At the bend from (2, 0) to (4, 3): across the way (6, 3) from neighbour to neighbour.
    assert found.directions[3] == pytest.approx([5**-0.5, -2 * 5**-0.5, 0], abs=1e-6)
    chords = numpy.array([2, 2, 2, 3.5, 5])
    assert found.rest_mm == pytest.approx(size * numpy.minimum(0.06 * 109**0.5, 0.45 * chords))
    assert found.scale == pytest.approx(1 / (size * chords))


@pytest.mark.parametrize("number", range(12))
def test_handles_of_a_straight_part_lie_to_its_left(number):
    """Whichever way the polygon turns: its plane looks to the side of its largest coordinate."""
    random = numpy.random.default_rng(number)
    points = numpy.concatenate([random.uniform(-9, 9, (4, 2)), numpy.zeros((4, 1))], axis=1)
    points[2] = (points[1] + points[3]) / 2
    way = points[3] - points[1]
    left = numpy.array([-way[1], way[0], 0]) / numpy.linalg.norm(way)
    for shift in range(3):  # planes across z, x and y
        turned = numpy.roll(points, shift, axis=1)
        found = spline_handles.slides(turned, False, True).directions[2]
        assert found == pytest.approx(numpy.roll(left, shift))
