# SPDX-License-Identifier: LGPL-2.1-or-later
"""nu_spline, beta_spline, knots_of: shapes, keywords and errors; the conditions of joints by the
curve's own derivatives."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierSpline, beta_spline, knots_of, nu_spline

POINTS = np.array([[0, 0, 0], [3, 2, 1], [5, -1, 2], [8, 1, 0], [9, 5, -1], [4, 7, 2]], dtype=float)
RING = np.vstack([POINTS, POINTS[:1]])


def at_joint(curve, i):
    """X, X', X'' by the parameter just before and just after knot i."""
    before, after = curve.segment((i or curve.segments) - 1), curve.segment(i % curve.segments)
    lengths = np.diff(curve.knots)
    scale = lambda h: np.array([[1], [1 / h], [1 / h**2]])
    return (
        before.derivatives(1, 2) * scale(lengths[i - 1]),
        after.derivatives(0, 2) * scale(lengths[i % curve.segments]),
    )


@pytest.mark.parametrize("ends", ["natural", "clamped", "periodic"])
def test_nu_spline_keeps_its_joints(ends):
    points = RING if ends == "periodic" else POINTS
    nu = np.linspace(0.5, 20, len(points))
    given = (
        {"start_derivative": [1, 2, 3], "end_derivative": (0.5, 0, -1)} if ends == "clamped" else {}
    )
    result = nu_spline(points, nu=nu, ends=ends, **given)
    curve = result["curve"]
    assert (
        isinstance(curve, BezierSpline)
        and curve.degree == 3
        and curve.closed == (ends == "periodic")
    )
    assert curve.knots == knots_of(points)
    assert result["derivatives"].shape == points.shape and result["stationary"] == []
    for i in range(0 if ends == "periodic" else 1, curve.segments):
        a, b = at_joint(curve, i)
        tension = nu[i] + (nu[-1] if i == 0 else 0)
        assert np.abs(b[0] - points[i]).max() < 1e-13
        assert (
            np.abs(b[1] - a[1]).max() < 1e-12
            and np.abs(b[1] - result["derivatives"][i]).max() < 1e-12
        )
        assert np.abs(b[2] - a[2] - tension * b[1]).max() < 1e-10
    if ends == "clamped":
        assert np.abs(curve.derivatives(0, 1)[1] - [1, 2, 3]).max() < 1e-13
    assert all(joint["order_reached"] >= 2 for joint in curve.measure_joints(2))


def test_tension_pulls_into_the_polygon():
    sizes = [np.abs(nu_spline(POINTS, nu=nu)["derivatives"]).max() for nu in (0, 5, 50, 5000)]
    assert sizes == sorted(sizes, reverse=True) and sizes[-1] < 1e-2
    one = nu_spline(POINTS, [0, 1, 2, 3, 4, 5], nu=[0, 0, 1e4, 0, 0, 0])["derivatives"]
    assert np.linalg.norm(one[2]) < 1e-2 < np.linalg.norm(one[1])
    with pytest.raises(ValueError, match="knot"):
        nu_spline(POINTS, nu=1)["curve"].to_bspline(2)
    assert nu_spline(POINTS)["curve"].to_bspline(2).degree == 3


def test_beta_spline():
    bias, tension = [1, 1.5, 0.8, 1.2, 2, 0.7, 1.4], [0, -1, 0.5, 0, -3, -2, -1]
    curve = beta_spline(RING, bias, tension, ends="periodic")["curve"]
    for i in range(1, 7):
        a, b = curve.segment(i - 1).derivatives(1, 2), curve.segment(i % 6).derivatives(0, 2)
        assert np.abs(a[1] - bias[i] * b[1]).max() < 1e-12
        assert np.abs(a[2] - bias[i] ** 2 * b[2] - tension[i] * b[1]).max() < 1e-11
    assert all(joint["order_reached"] == 2 for joint in curve.measure_joints(2))
    plain, uniform = (
        beta_spline(POINTS, start_nu=2)["curve"],
        nu_spline(POINTS, range(6), nu=[2, 0, 0, 0, 0, 0])["curve"],
    )
    assert plain.knots == uniform.knots and np.abs(plain.poles - uniform.poles).max() < 1e-13
    start = beta_spline(
        POINTS, 1.1, ends="clamped", start_derivative=[1, 0, 0], end_derivative=[0, 1, 0]
    )
    assert np.abs(start["derivatives"][[0, -1]] - [[1, 0, 0], [0, 1, 0]]).max() < 1e-15


def test_knots_of():
    points = [[0, 0, 0], [3, 4, 0], [3, 4, 16]]
    assert knots_of(points, 0) == [0, 1, 2]
    assert knots_of(points, 1) == [0, 5, 21]
    assert knots_of(points)[2] == pytest.approx(5**0.5 + 4)


def test_stationary_points_are_named():
    to_and_fro = np.array([[0, 0, 0], [1, 2, 3], [4, -4, 0.5], [1, 2, 3], [0, 0, 0]])
    assert nu_spline(to_and_fro, range(5), nu=1, ends="periodic")["stationary"] == [0, 2, 4]


@pytest.mark.parametrize(
    "arguments, text",
    [
        ({"points": POINTS[:1]}, "points 1: at least 2"),
        ({"points": POINTS[:, :2]}, r"points have shape \(6, 2\)"),
        ({"points": np.where(POINTS == 9, np.nan, POINTS)}, r"point 4 is \(nan, 5, -1\)"),
        ({"points": POINTS[[0, 1, 1, 2]]}, "points 1 and 2"),
        ({"knots": [0, 1, 2, 2, 3, 4]}, "knot 3 is 2 after 2"),
        ({"knots": [0, 1]}, "knot has 2 numbers for 6 points"),
        ({"knots": "abc"}, "knots is 'abc'"),
        ({"nu": [1, 2]}, "nu has 2 numbers"),
        ({"nu": True}, "nu is True"),
        ({"nu": float("inf")}, "nu 0 is inf"),
        ({"ends": "free"}, "ends is 'free': known are"),
        ({"ends": 3}, "ends is 3"),
        ({"ends": "clamped"}, "start_derivative is None"),
        ({"start_derivative": [1, 2, 3]}, r"start_derivative is \[1, 2, 3\]"),
        (
            {"ends": "clamped", "start_derivative": [1, 2], "end_derivative": [1, 2, 3]},
            "start_derivative is",
        ),
        ({"ends": "periodic"}, r"point 5 is \(4, 7, 2\)"),
        (
            {"points": POINTS[:2], "knots": [0, 2], "nu": -1},
            "the 2 equations are singular: pivot 1 is 0",
        ),
    ],
)
def test_bad_arguments(arguments, text):
    with pytest.raises(ValueError, match=text):
        nu_spline(**{"points": POINTS} | arguments)


def test_shrinking_lengths_lose_digits_in_the_knots_alone():
    spline = beta_spline(POINTS, 20)["curve"]
    assert spline.continuity() == 0
    assert all(joint["order_reached"] == 2 for joint in spline.measure_joints(2))
    assert beta_spline(POINTS[::-1], 1 / 20)["curve"].continuity() == 2


def test_bad_beta_arguments():
    with pytest.raises(ValueError, match="bias 2 is -1"):
        beta_spline(POINTS, [1, 1, -1, 1, 1, 1])
    with pytest.raises(ValueError, match="start_nu is 'x'"):
        beta_spline(POINTS, start_nu="x")
    for name in ("start_nu", "end_nu"):
        with pytest.raises(
            ValueError, match=f"{name} is 5: it has no meaning but with natural ends"
        ):
            beta_spline(RING, ends="periodic", **{name: 5})
    with pytest.raises(ValueError, match="exponent is 'a'"):
        seamwright.knots_of(POINTS, "a")
    with pytest.raises(ValueError, match="the 6 equations are singular"):
        beta_spline(RING, (3 + 5**0.5) / 2, ends="periodic")
    with pytest.raises(ValueError, match="exponent is 2"):
        seamwright.knots_of(POINTS, 2)
