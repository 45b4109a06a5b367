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
