# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of moves and their legend, by numbers."""

import pytest

from freecad.seamwright.plain import moves


def test_a_quarter_of_the_largest_move_lies_between_yellow_and_orange():
    """0.25 is 2/5 of the way from the stop at 0.15 to that at 0.4."""
    (found,) = moves.colours([0.5], 2.0)
    assert [255 * channel for channel in found] == pytest.approx([253.6, 198.2, 99.6])


def test_colours_go_from_light_grey_over_yellow_to_dark_red():
    stay, yellow, orange, red, dark = (moves.colour(share) for share in (0, 0.15, 0.4, 0.7, 1))
    assert min(stay) > 220 and max(stay) - min(stay) < 10
    assert yellow[0] > yellow[1] > 200 > yellow[2]
    assert orange[0] > 240 > orange[1] > orange[2]
    assert red[0] > 220 and red[1] < 100
    assert 100 < dark[0] < 150 and max(dark[1:]) < 50
    assert moves.colours([0.5], 0.5) == [tuple(channel / 255 for channel in dark)]
    assert moves.colour(-0.5) == stay and moves.colour(1.5) == dark


def test_where_nothing_moved_all_has_the_colour_of_the_legend():
    ((sample, name, _),) = moves.legend_entries(0.0)
    (found,) = moves.colours([0.0], 0.0)
    assert [255 * channel for channel in found] == pytest.approx(sample.rgb)
    assert name == "0 mm" and min(sample.rgb) > 220
    assert moves.colours([1e-9], 0.0) == [found]


def test_the_legend_has_a_line_for_each_quarter_and_a_tenth():
    names = [name for _, name, _ in moves.legend_entries(2.0)]
    assert names == ["2 mm", "1.5 mm", "1 mm", "0.5 mm", "0.2 mm", "0 mm"]
    assert len(moves.legend_entries(0.5)) == 6
    every = [channel for sample, *_ in moves.legend_entries(2.0) for channel in sample.rgb]
    assert {type(channel) for channel in every} == {int}
