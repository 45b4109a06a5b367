# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of different structure as keys of a blend. The oracles are the given curves, and
derivatives of Bezier polynomials by differences of their poles."""

import copy
import math
import pickle

import numpy as np
import pytest
import seamwright
from seamwright import BezierCurve, SplineBlend, results

WAVE = [[3 * k, 4 * math.sin(k), 0] for k in range(6)]
HILL = [[4 * k, 6 * math.sin(0.8 * k), 10] for k in range(5)]
NAN = float("nan")


def through(points, closed=False):
    points = np.array(points, float)
    ends = "periodic" if closed else "natural"
    return seamwright.nu_spline(points, ends=ends).curve


def pair():
    return through(WAVE), through(HILL)


def ring(count, turn=0.0, z=0.0):
    angles = turn + math.tau * np.arange(count + 1) / count
    points = [[10 * math.cos(a), 6 * math.sin(a), z] for a in angles]
    points[-1] = points[0]
    return through(points, closed=True)


def dense(curve, count=400):
    knots = np.array(curve.knots)
    return curve.point(np.linspace(knots[0], knots[-1], count))


def farthest(points, polygon):
    """The largest distance of the points from the polygon."""
    starts, sides = polygon[:-1], np.diff(polygon, axis=0)
    squares = np.einsum("ij,ij->i", sides, sides)

    def distance(point):
        shares = np.clip(np.einsum("ij,ij->i", point - starts, sides) / squares, 0, 1)
        return np.linalg.norm(starts + shares[:, None] * sides - point, axis=1).min()

    return max(map(distance, points))


def test_matched_curves_are_the_same_curves():
    keys = pair()
    matched = seamwright.match_pieces(keys, closeness=0)
    assert isinstance(matched, results.MatchedCurves)
    assert len({(curve.degree, len(curve.knots)) for curve in matched.curves}) == 1
    for key, curve in zip(keys, matched.curves):
        t = np.linspace(key.knots[0], key.knots[-1], 101)
        assert np.abs(key.point(t) - curve.point(t)).max() < 1e-12
        assert set(np.round(key.knots, 9)) <= set(np.round(curve.knots, 9))
    summary = matched.summary
    assert summary.pieces_before == [len(key.knots) - 1 for key in keys] == [5, 4]
    # No joint is shared, so each curve gets those of the other.
    assert summary.pieces_after == len(matched.curves[0].knots) - 1 == 8 and summary.merged == 0
    assert summary.reversed == [False, False] and summary.largest_ratio >= 1
    frame = SplineBlend(matched.curves).frame_at(0.5)
    assert all(joint.order == 2 for joint in frame.joints)


def test_given_parameters_are_at_one_joint():
    keys = pair()
    p, q = keys[0].knots[2] + 0.1, keys[1].knots[1] + 0.2
    matched = seamwright.match_pieces(keys, given=[[p], np.array([q])])
    assert matched.summary.matched_features == 1
    at = [np.abs(np.array(curve.knots) - x).argmin() for curve, x in zip(matched.curves, (p, q))]
    assert at[0] == at[1]
    for curve, x in zip(matched.curves, (p, q)):
        assert curve.knots[at[0]] == pytest.approx(x, abs=1e-12)


def test_features_are_found_and_matched():
    peak = BezierCurve([[-1, 1, 0], [0, -1, 0], [1, 1, 0]])
    aside = BezierCurve([[-0.8, 0.64, 1], [0.1, -0.8, 1], [1, 1, 1]])  # y = x^2 again
    matched = seamwright.match_pieces([peak, aside], by="features")
    assert matched.summary.features == [1, 1] and matched.summary.matched_features == 1
    for curve in matched.curves:  # the vertex of the parabola
        assert np.abs(curve.point(curve.knots[1])[:2]).max() < 1e-8


def test_closed_curves_start_and_run_alike():
    first, turned = ring(8), ring(8, turn=math.tau / 4, z=5)
    backwards = turned.reversed() if hasattr(turned, "reversed") else turned
    matched = seamwright.match_pieces([first, backwards], find_start=True, find_direction=True)
    start = [curve.point(curve.knots[0])[:2] for curve in matched.curves]
    assert np.linalg.norm(start[0] - start[1]) < 1.5
    assert len(matched.summary.reversed) == len(matched.summary.start) == 2


def test_common_knots_are_near_and_fair():
    keys = pair()
    common = seamwright.common_knots(keys, tolerance_mm=1e-4)
    assert isinstance(common, results.CommonKnots) and common.reached
    assert max(common.distance_mm) <= 1e-4
    first, second = common.curves
    assert first.degree == 5 and list(first.knots) == list(second.knots)
    assert (first.knots[0], first.knots[-1]) == (0, 1)
    for key, curve in zip(keys, common.curves):
        assert farthest(dense(curve, 60), dense(key, 5000)) < 1.1e-4
    # Blending poles linearly keeps G2: first and second derivatives agree on both sides.
    n, steps = first.degree, np.diff(first.knots)
    poles = (np.array(first.poles) + np.array(second.poles)) / 2
    for i in range(1, len(steps)):
        before, after = poles[(i - 1) * n : i * n + 1], poles[i * n : (i + 1) * n + 1]
        for order in (1, 2):
            a = np.diff(before, order, axis=0)[-1] / steps[i - 1] ** order
            b = np.diff(after, order, axis=0)[0] / steps[i] ** order
            assert np.abs(a - b).max() < 1e-11 * np.abs(poles).max() / steps.min() ** order
    coarse = seamwright.common_knots(keys, tolerance_mm=1e-4, max_segments=4)
    assert not coarse.reached and max(coarse.distance_mm) > 1e-4


def pickled(value):
    return pickle.loads(pickle.dumps(value))


def test_results_are_read_only_and_can_be_copied():
    for result in (seamwright.match_pieces(pair()), seamwright.common_knots(pair())):
        for made in (copy.copy(result), copy.deepcopy(result), pickled(result)):
            assert made == result and type(made) is type(result)
        assert isinstance(result.summary, results.MatchSummary)
        assert repr(result).startswith(f"{type(result).__name__}(curves=")
        with pytest.raises(AttributeError):
            result.curves = []


LINE = BezierCurve([[0, 0, 0], [1, 0, 0]])
POINT = BezierCurve([[0, 0, 0], [0, 0, 0]])


@pytest.mark.parametrize("call", [seamwright.match_pieces, seamwright.common_knots])
@pytest.mark.parametrize(
    "keys, options, message",
    [
        ([LINE], {}, "frames 1"),
        (LINE, {}, "keys is <BezierCurve"),
        ([LINE, 3], {}, r"keys\[1\] is 3"),
        ([LINE, POINT], {}, "frame 1"),
        ([LINE, LINE], {"by": "given"}, "by is 'given': known are 'length' and 'features'"),
        ([LINE, LINE], {"given": 0.5}, "given is 0.5: a sequence"),
        ([LINE, LINE], {"given": [[0.5], "x"]}, r"given\[1\] is 'x'"),
        ([LINE, LINE], {"given": [[0.5]]}, "frames 2, lists of given parameters 1"),
        ([LINE, LINE], {"given": [[0.5], [2]]}, "frame 1.* 2"),
        ([LINE, LINE], {"given": [[0.5], [0.5]], "find_direction": True}, "direction"),
        ([LINE, LINE], {"corner_rad": NAN}, "corner_rad is nan"),
        ([LINE, LINE], {"prominence": 1}, "prominence is 1"),
        ([LINE, LINE], {"reach": -1}, "reach is -1"),
        ([LINE, LINE], {"find_start": 1}, "find_start is 1"),
    ],
)
def test_bad_arguments(call, keys, options, message):
    with pytest.raises((ValueError, TypeError), match=message):
        call(keys, **options)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: seamwright.match_pieces(pair(), closeness=2), "closeness is 2"),
        (lambda: seamwright.common_knots(pair(), tolerance_mm=0), "tolerance"),
        (lambda: seamwright.common_knots(pair(), tolerance_mm=NAN), "tolerance"),
        (lambda: seamwright.common_knots(pair(), max_segments=1.5), "max_segments is 1.5"),
    ],
)
def test_bad_numbers(call, message):
    with pytest.raises(ValueError, match=message):
        call()
