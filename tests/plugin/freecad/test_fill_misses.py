# SPDX-License-Identifier: LGPL-2.1-or-later
"""What fills miss that are not kept: shares of tolerances, their colours and legend."""

import json
import math

import pytest

from freecad.seamwright.plain import fill_misses, palette

LIMITS = {"gap_mm": 0.001, "angle_deg": 0.01, "curvature_rel": 0.02, "corner_deg": 15.0}
NAN = math.nan


@pytest.mark.parametrize(
    "target, figures, shares",
    (
        ("G0", {"gap_mm": [0.0, 0.004]}, [0, 4]),
        ("G1", {"gap_mm": [0.0, 0.004], "angle_deg": [0.02, 0.01]}, [2, 4]),
        ("G1", {"gap_mm": [0.0] * 4, "angle_deg": [NAN, 0.01, NAN, 0.03]}, [1, 1, 2, 3]),
        ("G1", {"gap_mm": [0.002, 0.0], "angle_deg": [NAN, NAN]}, [2, 0]),
        (
            "G2",
            {"gap_mm": [0.0] * 2, "angle_deg": [0.01] * 2, "curvature_rel": [0.1, NAN]},
            [5, 1],
        ),
    ),
)
def test_the_largest_share_of_the_figures_that_decide_counts(target, figures, shares):
    assert fill_misses.shares(figures, LIMITS, target) == pytest.approx(shares)


def test_a_tolerance_of_zero_leaves_shares_finite():
    (share,) = fill_misses.shares({"gap_mm": [1e-5]}, {"gap_mm": 0.0}, "G0")
    assert 1 < share < math.inf


def test_colours_go_with_the_share_and_those_of_the_legend_are_among_them():
    met, little, most = fill_misses.colours([1.0, 1.001, 50.0], 50.0)
    assert met == palette.SMOOTH.unit_rgb
    for found, (_, rgb) in ((little, fill_misses.RAMP[0]), (most, fill_misses.RAMP[-1])):
        assert [255 * channel for channel in found] == pytest.approx(rgb, abs=1)
    title, entries, footer = fill_misses.legend({"target": "G1", "tolerance": LIMITS}, 49.0)
    assert [name for _, name, _ in entries] == ["49 \u00d7", "7 \u00d7", "\u2264 1 \u00d7"]
    assert entries[0][0].rgb == fill_misses.RAMP[-1][1]
    assert footer == "G1: gap \u2264 0.001 mm, angle \u2264 0.01\u00b0"


def fill(angle_deg, code="misses_target", gap_mm=1e-5):
    figures = {"gap_mm": gap_mm, "angle_deg": angle_deg}
    seam = {name: {"lower": each / 2, "upper": each} for name, each in figures.items()}
    return {"filled": False, "reason_code": code, "seams": [seam]}


def allowed(*fills):
    return fill_misses.allowed({"target": "G1", "tolerance": LIMITS, "fills": list(fills)})


def test_all_fills_are_allowed_or_none():
    assert allowed() == {}
    assert allowed(fill(0.0512)) == {"angle_deg": 0.052}
    assert allowed(fill(0.0512), fill(0.3, gap_mm=0.0123)) == {"angle_deg": 0.3, "gap_mm": 0.013}
    assert allowed(fill(0.0512), fill(0.3, code="may_fold")) == {}
    assert allowed(fill(89.0)) == {}


@pytest.mark.parametrize("curvature, found", ((0.3, {"curvature_rel": 0.3}), (1.0, {}), (1.1, {})))
def test_a_curvature_that_differs_wholly_is_no_tolerance(curvature, found):
    missed = fill(0.001)
    missed["seams"][0]["curvature_rel"] = {"lower": curvature / 2, "upper": curvature}
    report = {"target": "G2", "tolerance": LIMITS, "fills": [missed]}
    assert fill_misses.allowed(report) == found


def test_the_worst_point_of_a_seam():
    along = [
        {"points": [[0, 0, 0], [1, 0, 0]], "shares": [0.5, 2.0]},
        {"points": [[1, 0, 0], [2, 0, 0]], "shares": [12.34, 0.1]},
    ]
    assert fill_misses.worst({"along": along}) == ([1, 0, 0], "12.3 \u00d7")


def test_lines_are_those_of_all_seams_that_have_points():
    points = [[[0, 0, 0]], [[1, 0, 0]], [[2, 0, 0]]]
    seams = [
        {"along": [{"points": points[0], "shares": [0.5]}, {"points": points[1], "shares": [2.0]}]},
        {},
        {"along": [{"points": points[2], "shares": [3.0]}]},
    ]
    found = fill_misses.lines({"fills": [{"seams": seams[:1]}, {"seams": seams[1:]}]})
    assert found == [(points[0], [0.5]), (points[1], [2.0]), (points[2], [3.0])]
    assert fill_misses.largest(found) == 3.0
    assert fill_misses.largest(found[:1]) == 1.0, "the tolerance itself"
    assert fill_misses.largest([]) == 1.0


def test_the_square_root_of_the_largest_share_is_vermillion():
    yellow, middle, dark = (rgb for _, rgb in fill_misses.RAMP)
    assert yellow[0] > yellow[1] > 150 > yellow[2]
    assert middle == (213, 94, 0), "that of the palette of Okabe and Ito"
    assert 80 < dark[0] < 140 and max(dark[1:]) < 50
    for most in (49.0, 1.21):
        (found,) = fill_misses.colours([math.sqrt(most)], most)
        assert [255 * channel for channel in found] == pytest.approx(middle, abs=1)
    (found,) = fill_misses.colours([1.0 + 1e-12], 1.0)
    assert [255 * channel for channel in found] == pytest.approx(yellow, abs=1)


def test_the_words_of_the_legend():
    title, entries, _ = fill_misses.legend({"target": "G1", "tolerance": LIMITS}, 49.0)
    assert title == "Fill that is not kept"
    assert [meaning for *_, meaning in entries] == [
        "the tolerance", "the tolerance", "within the tolerances"
    ]
    assert entries[1][0].rgb == pytest.approx((213, 94, 0), abs=1)
    assert entries[2][0].rgb == (0, 158, 115)
    _, entries, _ = fill_misses.legend({"target": "G1", "tolerance": LIMITS}, 1.21)
    assert [name for _, name, _ in entries][:2] == ["1.21 \u00d7", "1.1 \u00d7"]
    _, entries, _ = fill_misses.legend({"target": "G1", "tolerance": LIMITS}, 1.0)
    assert [name for _, name, _ in entries] == ["\u2264 1 \u00d7"]


@pytest.mark.parametrize("angle_deg, found", ((5.0, {"angle_deg": 5.0}), (5.01, {}), (0.01, {})))
def test_faces_that_meet_at_more_than_five_degrees_are_not_allowed(angle_deg, found):
    assert allowed(fill(angle_deg)) == found


def test_only_a_gap_may_be_missed():
    assert allowed(fill(0.001, gap_mm=0.5)) == {"gap_mm": 0.5}


def test_shares_can_be_stored():
    for angles in ([0.02, NAN], [NAN, NAN]):
        found = fill_misses.shares({"gap_mm": [0.0, 0.0], "angle_deg": angles}, LIMITS, "G1")
        assert json.loads(json.dumps(found)) == found


def test_the_footer_of_the_legend_has_the_tolerances_of_the_target():
    *_, footer = fill_misses.legend({"target": "G2", "tolerance": LIMITS}, 4.0)
    assert footer == "G2: gap \u2264 0.001 mm, angle \u2264 0.01\u00b0, curvature \u2264 2 %"
