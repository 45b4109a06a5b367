# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of mean curvature, their range and their legend."""

import math

import numpy
import pytest
from test_plain import SIGHTS, lab, linear

from freecad.seamwright.plain import curvature

SQUARE = numpy.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)], float), numpy.array(
    [(0, 1, 2), (0, 2, 3)]
)


def seen(sight, share):
    rgb = 255 * curvature.colours(numpy.array([share]), 1.0)[0]
    return lab([sum(m * c for m, c in zip(row, linear(rgb))) for row in SIGHTS[sight]])


@pytest.mark.parametrize("sight", sorted(SIGHTS))
@pytest.mark.parametrize("side", (-1, 1))
def test_more_curvature_is_darker_for_every_eye(sight, side):
    lightness = [seen(sight, side * k / 50)[0] for k in range(51)]
    assert all(one > other for one, other in zip(lightness, lightness[1:]))
    assert lightness[0] - lightness[-1] > 50


@pytest.mark.parametrize("sight", sorted(SIGHTS))
def test_hollow_and_bulging_differ_for_every_eye(sight):
    for k in range(25, 101, 5):
        assert math.dist(seen(sight, k / 100), seen(sight, -k / 100)) > 20


def test_colours_pass_through_the_ramp_and_stop_at_its_ends():
    shares, rgb = zip(*curvature.RAMP)
    assert curvature.colours(0.03 * numpy.array(shares), 0.03) * 255 == pytest.approx(
        numpy.array(rgb, float)
    )
    low, high = curvature.colours(numpy.array([-7.0, 7.0]), 0.03) * 255
    assert (tuple(low), tuple(high)) == (pytest.approx(rgb[0]), pytest.approx(rgb[-1]))


def test_a_point_without_curvature_has_a_colour_of_its_own():
    found = curvature.colours(numpy.array([math.nan, 0.0]), 1.0) * 255
    assert tuple(found[0]) == pytest.approx(curvature.UNDEFINED)
    assert curvature.limit(numpy.array([math.nan, 0.5]), numpy.ones(2)) == 0.5


def test_areas_of_points_are_thirds_of_the_triangles_around_them():
    assert curvature.areas(*SQUARE) == pytest.approx([4 / 3, 2 / 3, 4 / 3, 2 / 3])


def test_quantiles_count_area_and_not_points():
    values, weights = numpy.array([5.0, 1.0, 3.0]), numpy.array([1.0, 97.0, 2.0])
    assert list(curvature.quantiles(values, weights, (0.02, 0.5, 0.96, 0.98, 1.0))) == [
        1.0,
        1.0,
        1.0,
        3.0,
        5.0,
    ]
    assert list(curvature.quantiles(values, numpy.zeros(3), (0.5, 1.0))) == [0.0, 0.0]
    even = numpy.linspace(-1, 1, 2001)
    assert curvature.quantiles(even, numpy.ones(2001), (0.02, 0.5, 0.98)) == pytest.approx(
        [-0.96, 0.0, 0.96], abs=1e-3
    )


def test_the_limit_leaves_out_little_and_is_a_round_figure():
    values = numpy.concatenate([numpy.full(990, -0.0041), numpy.full(10, 7.0)])
    assert curvature.limit(values, numpy.ones(1000)) == pytest.approx(0.005)
    assert curvature.limit(-values, numpy.ones(1000)) == pytest.approx(0.005)
    assert curvature.limit(numpy.array([0.02]), numpy.ones(1)) == pytest.approx(0.02)
    for value in numpy.geomspace(1e-6, 1e3, 200):
        assert 0.999 <= curvature.limit(numpy.array([value]), numpy.ones(1)) / value <= 1.35


def test_a_little_bend_in_a_large_plane_counts():
    values = numpy.concatenate([numpy.zeros(999), [-0.1]])
    assert curvature.limit(values, numpy.ones(1000)) == pytest.approx(0.1)
    assert curvature.limit(numpy.full(5, 1e-12), numpy.ones(5)) == 0.0
    assert curvature.limit(numpy.empty(0), numpy.empty(0)) == 0.0


def test_the_legend_has_curvatures_and_radii_from_the_most_concave():
    entries = curvature.legend_entries(0.02)
    assert [name for _, name, _ in entries][::4] == ["+0.02 1/mm", "0 1/mm", "\u22120.02 1/mm"]
    assert [meaning for *_, meaning in entries][::4] == [
        "as a sphere of radius 50 mm", "flat, or a saddle", "as a sphere of radius 50 mm"
    ]  # fmt: skip
    assert [entries[0][0].rgb, entries[-1][0].rgb] == [curvature.RAMP[-1][1], curvature.RAMP[0][1]]
    assert "beyond \u00b10.02 1/mm" in curvature.legend_footer(0.02)


def test_of_a_plane_the_legend_has_one_line():
    ((sample, name, meaning),) = curvature.legend_entries(0.0)
    assert (name, meaning) == ("0 1/mm", "flat, or a saddle")
    assert "beyond" not in curvature.legend_footer(0.0)
    assert curvature.colours(numpy.zeros(2), 0.0) * 255 == pytest.approx(
        numpy.array([sample.rgb] * 2)
    )


def test_areas_do_not_depend_on_the_place():
    points = numpy.array([(7, 1, 2), (9, 1, 2), (7, 4, 2), (7, 4, 9)], float)
    assert curvature.areas(points, numpy.array([(0, 1, 2)])) == pytest.approx([1, 1, 1, 0])


def test_more_than_two_percent_of_the_area_is_not_left_out():
    for beyond, wanted in ((15, 0.005), (25, 8.0)):
        values = numpy.full(1000, 0.0045)
        values[:beyond] = 8.0
        assert curvature.limit(values, numpy.full(1000, 1e-4)) == pytest.approx(wanted)


@pytest.mark.parametrize("radius_mm, limit", [(1e7, 1e-7), (0.84e7, 1.2e-7), (1.01e7, 0)])
def test_radii_above_ten_kilometres_are_flat(radius_mm, limit):
    found = curvature.limit(numpy.array([1 / radius_mm, 0.0]), numpy.array([1.0, 1e-9]))
    assert found == pytest.approx(limit, rel=0.01)


def test_the_ramp_has_equal_steps_from_blue_over_white_to_orange():
    shares, colours = zip(*curvature.RAMP)
    assert shares == pytest.approx([k / 5 for k in range(-5, 6)])
    assert all(blue > green > red for red, green, blue in colours[:5])
    assert all(red > green > blue for red, green, blue in colours[6:])
    assert len(set(colours[5])) == 1 and colours[5][0] > 240


def test_the_whole_legend():
    title, entries, footer = curvature.legend(0.02)
    assert title == "Mean curvature"
    assert {type(channel) for sample, *_ in entries for channel in sample.rgb} == {int}
    assert entries[3][0].rgb == (254, 214, 161), "a quarter of the way from 0.2 to 0.4: 253.75"
    assert [(name, meaning.split("radius ")[-1]) for _, name, meaning in entries] == [
        ("+0.02 1/mm", "50 mm"), ("+0.015 1/mm", "66.7 mm"), ("+0.01 1/mm", "100 mm"),
        ("+0.005 1/mm", "200 mm"), ("0 1/mm", "flat, or a saddle"),
        ("\u22120.005 1/mm", "200 mm"), ("\u22120.01 1/mm", "100 mm"),
        ("\u22120.015 1/mm", "66.7 mm"), ("\u22120.02 1/mm", "50 mm"),
    ]  # fmt: skip
    assert footer == (
        "+ concave, \u2212 convex, seen from the side of the normals\n"
        "values beyond \u00b10.02 1/mm have the end colours"
    )
    assert curvature.legend_footer(0.0) == (
        "+ concave, \u2212 convex, seen from the side of the normals"
    )
