# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of maps, their legends, and the pictures that are put on faces."""

import math

import numpy
import pytest
from test_plain import SIGHTS, lab, linear

from freecad.seamwright.plain import curvature, maps, palette, ramps

WHITE, MOST, LEAST = (250, 250, 250), curvature.RAMP[-1][1], curvature.RAMP[0][1]
BEYOND = "values beyond have the end colours"


def texts(look):
    title, entries, footer = look.legend
    return title, [(text, meaning) for _, text, meaning in entries], footer


def rgb(look, share):
    """The colour of a place, as a point there gets it."""
    return look.row[min(int(share * 1024), 1023)]


def shown(look):
    """The colours of the legend."""
    return [sample.rgb for sample, *_ in look.legend[1]]


def values_to(limit, count=1000):
    return numpy.full(count, limit), numpy.ones(count)


# Ramps


@pytest.mark.parametrize("sight", sorted(SIGHTS))
def test_the_sequential_ramp_grows_darker_for_every_eye(sight):
    row = ramps.row_of(ramps.SEQUENTIAL)[::32]
    seen = [
        lab([sum(m * c for m, c in zip(line, linear(rgb))) for line in SIGHTS[sight]])[0]
        for rgb in row
    ]
    assert all(one > other for one, other in zip(seen, seen[1:]))
    assert seen[0] > 90 and seen[-1] < 20


def test_the_sequential_ramp_goes_over_green_to_blue_in_equal_steps():
    places, colours = zip(*ramps.SEQUENTIAL)
    assert places == pytest.approx([0, 0.2, 0.4, 0.6, 0.8, 1])
    assert min(colours[0]) >= 240, "white"
    assert all(green > max(red, blue) for red, green, blue in colours[1:3])
    assert all(blue > green > red for red, green, blue in colours[3:])


def test_a_row_passes_through_its_stops():
    row = ramps.row_of([(0.0, (0, 0, 0)), (0.5, (100, 0, 0)), (1.0, (100, 200, 0))])
    assert row.shape == (1024, 3)
    assert row[[0, 256, 511, 768, 1023]] == pytest.approx(
        numpy.array([(0, 0, 0), (50, 0, 0), (100, 0, 0), (100, 100, 0), (100, 200, 0)]), abs=0.3
    )


# Curvature


def test_mean_curvature_has_equal_steps_to_both_sides():
    look = ramps.curvature_look(maps.MEAN, *values_to(-0.04), None)
    title, entries, footer = texts(look)
    assert (title, footer) == (
        "Mean curvature", "seen from the side of the normals\n" + BEYOND
    )  # fmt: skip
    assert entries == [
        ("+0.04 1/mm", "concave"), ("+0.02 1/mm", "concave"), ("0 1/mm", ""),
        ("\u22120.02 1/mm", "convex"), ("\u22120.04 1/mm", "convex"),
    ]  # fmt: skip
    concave, _, flat, _, convex = shown(look)
    assert concave == MOST and convex == LEAST
    assert flat == pytest.approx(WHITE, abs=2)
    assert concave[0] > concave[2] and convex[2] > convex[0], "orange and blue"
    # 0.02 is half of the limit: between the colours of 0.4 and 0.6, both ways
    assert shown(look)[1] == pytest.approx((238, 157, 60), abs=2)
    assert shown(look)[3] == pytest.approx((106, 172, 208), abs=2)
    assert not look.repeats and look.smooth


def test_gaussian_curvature_tells_bowls_from_saddles():
    values = numpy.array([0.0004, -0.0004, 0.0, -0.0001])
    look = ramps.curvature_look(maps.GAUSSIAN, values, numpy.ones(4), None)
    assert look.places == pytest.approx([1, 0, 0.5, 0.375])
    title, entries, footer = texts(look)
    assert (title, footer) == ("Gaussian curvature", BEYOND)
    assert [meaning for _, meaning in entries] == [
        "as a bowl or a dome", "as a bowl or a dome", "", "as a saddle", "as a saddle"
    ]  # fmt: skip
    assert entries[0][0] == "+4e-4 1/mm\u00b2", "the square of 0.02 1/mm"


def test_the_largest_curvature_goes_from_none_with_radii_beside_it():
    values, weights = values_to(0.02)
    values[:500] = 0.005
    look = ramps.curvature_look(maps.LARGEST, values, weights, None)
    assert look.places[[0, -1]] == pytest.approx([0.25, 1])
    assert texts(look) == (
        "Largest curvature",
        [
            ("0.02 1/mm", "radius 50 mm"), ("0.015 1/mm", "radius 66.7 mm"),
            ("0.01 1/mm", "radius 100 mm"), ("0.005 1/mm", "radius 200 mm"), ("0 1/mm", "flat"),
        ],
        BEYOND,
    )  # fmt: skip
    assert shown(look)[0] == pytest.approx((8, 29, 88), abs=1)
    assert shown(look)[-1] == pytest.approx((250, 250, 240), abs=1)
    assert not look.repeats and look.smooth


def test_radii_are_told_with_their_curvature():
    radii, weights = values_to(50.0)
    radii[:10], radii[10:500] = math.inf, 200.0
    look = ramps.curvature_look(maps.RADIUS, radii, weights, None)
    assert look.places[[0, 10, -1]] == pytest.approx([0, 0.25, 1]), "as 1 / radius"
    assert texts(look) == (
        "Smallest radius of curvature",
        [
            ("radius 50 mm", "0.02 1/mm"), ("radius 66.7 mm", "0.015 1/mm"),
            ("radius 100 mm", "0.01 1/mm"), ("radius 200 mm", "0.005 1/mm"), ("flat", "0 1/mm"),
        ],
        BEYOND,
    )  # fmt: skip


def test_radii_of_a_given_range():
    radii = numpy.array([0.5, 2.0, 4.0])
    look = ramps.curvature_look(maps.RADIUS, radii, numpy.ones(3), (0.5, 4.0))
    assert look.places == pytest.approx([1, 1 / 7, 0]), "2, 0.5 and 0.25 1/mm"
    assert [text for text, _ in texts(look)[1]][::4] == ["radius 0.5 mm", "radius 4 mm"]
    with pytest.raises(ValueError, match="^Lowest = -1: a radius is larger than 0$"):
        ramps.curvature_look(maps.RADIUS, radii, numpy.ones(3), (-1.0, 4.0))


@pytest.mark.parametrize("quantity, lines", [
    (maps.MEAN, [("0 1/mm", "")]),
    (maps.GAUSSIAN, [("0 1/mm\u00b2", "")]),
    (maps.LARGEST, [("0 1/mm", "flat")]),
])  # fmt: skip
def test_of_a_plane_the_legend_has_one_line_and_all_is_white(quantity, lines):
    look = ramps.curvature_look(quantity, *values_to(0.0, 3), None)
    assert texts(look)[1] == lines
    assert len(set(look.places)) == 1
    assert rgb(look, look.places[0]) == pytest.approx(shown(look)[0], abs=1)
    assert min(shown(look)[0]) >= 240


def test_a_given_range_has_its_own_numbers():
    values = numpy.array([-1.0, 0.5, 3.0, math.nan])
    look = ramps.curvature_look(maps.GAUSSIAN, values, numpy.ones(4), (-1.0, 3.0))
    assert texts(look) == (
        "Gaussian curvature",
        [(each + " 1/mm\u00b2", "") for each in ("3", "2", "1", "0", "\u22121")],
        BEYOND,
    )
    assert shown(look)[0] == pytest.approx(MOST, abs=2)
    assert shown(look)[-1] == pytest.approx(LEAST, abs=2)
    assert shown(look)[3] == pytest.approx(WHITE, abs=2)
    assert math.isnan(look.places[3])


@pytest.mark.parametrize("low, high", [(-1.0, 3.0), (-3.0, 1.0), (-1.0, 1.0)])
def test_white_is_zero_of_a_range_and_each_side_has_its_whole_ramp(low, high):
    stops = ramps.stops_between(low, high)
    zero = -low / (high - low)
    places = [place for place, _ in stops]
    assert places[::5] == pytest.approx([0, zero, 1])
    assert places[3] == pytest.approx(zero * 3 / 5)  # -0.4 of -1: 3 of 5 steps
    assert places[8] == pytest.approx(zero + (1 - zero) * 3 / 5)
    assert [rgb for _, rgb in stops] == [rgb for _, rgb in curvature.RAMP]


@pytest.mark.parametrize("low, high", [(0.0, 3.0), (0.5, 0.75), (-3.0, 0.0), (-1.0, -0.5)])
def test_a_range_to_one_side_goes_from_white_to_blue(low, high):
    assert ramps.stops_between(low, high) == ramps.SEQUENTIAL


def test_an_empty_range_has_one_line():
    look = ramps.range_look(numpy.array([2.0, 3.0]), 2.0, 2.0, "Title", "mm", lambda value: "")
    assert look.places.tolist() == [0, 0]
    assert texts(look) == ("Title", [("2 mm", "")], "")


# Draft angles


def test_draft_angles_have_the_words_and_limits_of_the_panel():
    look = ramps.draft_look(numpy.array([-90.0, -45.0, 0.0, 90.0, math.nan]), 3.0, 5.0)
    assert look.places[:4] == pytest.approx([0, 0.25, 0.5, 1]) and math.isnan(look.places[4])
    assert texts(look) == (
        "Draft angle",
        [
            ("\u2265 3\u00b0", "drafts towards the pull"),
            ("between", "too steep"),
            ("\u2264 \u22125\u00b0", "drafts away from the pull"),
        ],
        "",
    ), "the lower limit is negative"
    assert not look.repeats and not look.smooth


def test_draft_colours_are_cyan_purple_and_sand():
    look = ramps.draft_look(numpy.zeros(1), 3.0, 5.0)
    assert shown(look) == [(136, 204, 238), (170, 68, 153), (221, 204, 119)]
    colour_of = {0.0: 1, 2.9: 1, 3.1: 0, 89.0: 0, -4.9: 1, -5.1: 2, -89.0: 2}
    for angle, entry in colour_of.items():
        assert tuple(rgb(look, (angle + 90) / 180)) == shown(look)[entry], angle
    # The limits lie within half a pixel of 180/1024 degrees of their places.
    for name, wanted in ((0, 87 / 180), (2, 85 / 180)):
        share = (look.row == shown(look)[name]).all(axis=1).mean()
        assert share == pytest.approx(wanted, abs=0.51 / 1024)


def test_draft_colours_are_not_those_of_seams():
    for draft in (ramps.TOWARDS, ramps.STEEP, ramps.AWAY):
        for seam in (*palette.CLASSES, *palette.LEVELS):
            assert math.dist(draft, seam.standard_rgb) > 60, seam.name


# Undefined values


def test_grey_is_in_the_legend_where_points_have_it():
    look = ramps.signed_look(numpy.array([0.1, math.nan]), 0.1, "Title", "mm", ("out", "in"))
    entries = ramps.with_undefined(look, "left out", "beyond").legend[1]
    assert [sample.apart for sample, *_ in entries] == [False] * 5 + [True]
    assert entries[-1] == (curvature.Sample((128, 128, 128), True), "left out", "beyond")
    known = ramps.signed_look(numpy.array([0.1]), 0.1, "Title", "mm", ("out", "in"))
    assert ramps.with_undefined(known, "left out", "beyond") is known
    stripes = ramps.stripes_look(numpy.array([math.nan]), 0.25)
    assert ramps.with_undefined(stripes, "left out", "beyond") is stripes


# Pictures


def test_stripes_are_dark_on_light_and_lie_at_whole_numbers():
    assert max(ramps.DARK) < 30 and min(ramps.LIGHT) > 240
    assert len(set(ramps.DARK)) == len(set(ramps.LIGHT)) == 1, "grey"
    look = ramps.stripes_look(numpy.zeros(1), 0.25)
    dark = (look.row == ramps.DARK).all(axis=1)
    assert dark.tolist() == [True] * 32 + [False] * 192 + [True] * 32
    assert look.repeats and look.smooth and look.legend is None


def test_a_row_that_does_not_repeat_is_shown_half_a_pixel_inside():
    look = ramps.Look(ramps.row_of(ramps.SEQUENTIAL), numpy.array([0, 0.5, 1, math.nan]),
                      False, True, None)  # fmt: skip
    width, height, data = ramps.image(look)
    assert (width, height) == (1024, 4) and len(data) == 3 * 1024 * 4
    pixels = numpy.frombuffer(data, numpy.uint8).reshape(height, width, 3)
    assert (pixels[:2] == numpy.rint(look.row)).all()
    assert (pixels[2:] == 128).all(), "grey is for what is undefined"
    places = ramps.texture_places(look)
    assert places[:3, 0] * 1024 == pytest.approx([0.5, 512, 1023.5])
    assert places[:, 1].tolist() == [0.25, 0.25, 0.25, 0.75]


def test_what_lies_beyond_the_limit_has_the_end_colour():
    values = numpy.zeros(1000)
    values[:500], values[500:980] = 0.04, -0.04
    values[980:990], values[990:] = 9.0, -9.0
    look = ramps.curvature_look(maps.MEAN, values, numpy.ones(1000), None)
    assert look.places[[0, 500, 980, 990]] == pytest.approx([1, 0, 1, 0])
    look = ramps.curvature_look(maps.LARGEST, abs(values), numpy.ones(1000), (0.01, 0.02))
    assert set(look.places) == {1.0}
    below = ramps.curvature_look(maps.LARGEST, abs(values), numpy.ones(1000), (10.0, 20.0))
    assert set(below.places) == {0.0}


def test_the_largest_curvature_is_sequential_in_any_range():
    look = ramps.curvature_look(maps.LARGEST, numpy.zeros(2), numpy.ones(2), (-1.0, 1.0))
    assert shown(look)[-1] == pytest.approx((250, 250, 240), abs=1)
    assert shown(look)[0] == pytest.approx((8, 29, 88), abs=1)
    assert {type(channel) for rgb in shown(look) for channel in rgb} == {int}
