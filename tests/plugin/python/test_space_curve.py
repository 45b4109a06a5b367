# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames, degeneracies and lengths of curves, through Python."""

import math

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve

CUSP = BezierCurve(
    [[1, -1, 0], [-1 / 3, 1, 0], [-1 / 3, -1, 0], [1, 1, 0]]
)  # (u^2, u^3), u = 2 t - 1
S = BezierCurve([[0, 0, 0], [1, 2, 0], [2, -2, 0], [3, 0, 0]])
QUARTER = BezierCurve([[2, 0, 0], [2, 2, 0], [0, 2, 0]], [1, math.sqrt(0.5), 1])
SPACE = BezierCurve([[0, 0, 0], [2, 0, 0], [2, 2, 1], [0, 3, 2], [1, 4, 4]])


def test_frame_of_a_circle():
    for t in np.linspace(0, 1, 11):
        frame = seamwright.frenet_frame(QUARTER, t)
        assert frame["kind"] == "regular"
        assert frame["curvature_per_mm"] == pytest.approx(0.5, rel=1e-14)
        assert (
            abs(frame["torsion_per_mm"]) < 1e-14 and abs(frame["curvature_change_per_mm2"]) < 1e-13
        )
        assert np.abs(frame["normal"] + QUARTER.point(t) / 2).max() < 1e-14
        assert np.abs(frame["binormal"] - [0, 0, 1]).max() < 1e-14


def test_frame_in_space():
    frame = seamwright.frenet_frame(SPACE, 0.3)
    matrix = np.array([frame[name] for name in ("tangent", "normal", "binormal")])
    assert np.abs(matrix @ matrix.T - np.eye(3)).max() < 1e-15 and np.linalg.det(
        matrix
    ) == pytest.approx(1)
    x = SPACE.derivatives(0.3, 3)
    cross = np.cross(x[1], x[2])
    assert frame["curvature_per_mm"] == pytest.approx(
        np.linalg.norm(cross) / np.linalg.norm(x[1]) ** 3
    )
    assert frame["torsion_per_mm"] == pytest.approx(cross @ x[3] / (cross @ cross))


def test_torsion_of_uneven_weights():
    """Seven orders of magnitude of weight; the values are known to 40 digits."""
    weights = np.array([1, 1 / 256, 64, 1 / 128])
    poles = [
        [0.015625, 0.828125, 0.453125],
        [0.0118408203125, -0.00579833984375, -0.00494384765625],
        [406, 61, -18],
        [0.0697021484375, -0.0103759765625, 0.0155029296875],
    ]
    frame = seamwright.frenet_frame(BezierCurve(np.array(poles) / weights[:, None], weights), 1)
    assert frame["kind"] == "regular"
    for name, value in (
        ("curvature", 1.180200257723693100558e-9),
        ("torsion", 0.002210790547637762394),
        ("curvature_change", -8.62085063599967789724733842558e-10),
    ):
        unit = "_per_mm2" if name == "curvature_change" else "_per_mm"
        assert abs(frame[name + unit] - value) <= frame[name + "_error" + unit] < 1e-11 * abs(value)
    assert frame["tangent_error_rad"] < 1e-13 and frame["binormal_error_rad"] < 1e-12
    assert frame["speed_error"] < 1e-13 * frame["speed"]


def test_where_there_is_no_frame():
    flat = seamwright.frenet_frame(S, 0.5)
    assert flat["kind"] == "inflection" and flat["curvature_per_mm"] == 0
    assert flat["normal"] is None and flat["torsion_per_mm"] is None and flat["tangent"] is not None
    cusp = seamwright.frenet_frame(CUSP, 0.5)
    assert cusp["kind"] == "cusp" and cusp["curvature_per_mm"] is None
    assert np.abs(cusp["tangent"] - [1, 0, 0]).max() < 1e-15
    assert seamwright.frenet_frame(BezierCurve([[1, 1, 1]] * 3), 0.2)["kind"] == "point"


def test_degeneracies():
    (place,) = seamwright.find_degeneracies(S)["places"]
    assert (
        place["kind"] == "inflection"
        and place["first"] <= 0.5 <= place["last"] < place["first"] + 1e-8
    )
    found = seamwright.find_degeneracies(CUSP)
    assert [place["kind"] for place in found["places"]] == ["cusp"] and found["speed_lower"] == 0
    found = seamwright.find_degeneracies(SPACE, resolution=1e-6)
    assert found["places"] == [] and not found["straight"]
    slowest = min(np.linalg.norm(SPACE.derivatives(t, 1)[1]) for t in np.linspace(0, 1, 2001))
    assert 0.4 * slowest < found["speed_lower"] <= slowest
    assert seamwright.find_degeneracies(BezierCurve([[0, 0, 0], [1, 2, 3]]))["straight"]


@pytest.mark.parametrize("bad", [math.inf, math.nan, 0.0, True, 1j, "1", np.array([1.0])])
def test_tolerances_that_are_none(bad):
    with pytest.raises(ValueError, match="tolerance"):
        seamwright.arc_length(SPACE, bad)
    with pytest.raises(ValueError, match="tolerance"):
        seamwright.parameter_at_length(SPACE, 1, bad)


def test_length():
    wanted = 2 * (13 * math.sqrt(13) - 8) / 27
    for tolerance in (1e-2, 1e-6, 1e-12):
        length = seamwright.arc_length(CUSP, tolerance)
        assert length["reached"] and length["lower_mm"] <= wanted <= length["upper_mm"]
        assert length["upper_mm"] - length["lower_mm"] <= tolerance
    half = seamwright.arc_length(QUARTER, 1e-12, last=0.5)
    assert half["value_mm"] == pytest.approx(math.pi / 2, rel=1e-14)
    part = seamwright.arc_length(QUARTER, 1e-12, first=0.5)
    assert part["value_mm"] == pytest.approx(math.pi / 2, rel=1e-14)
    assert not seamwright.arc_length(QUARTER, 1e-30)["reached"]


def test_parameter_at_length():
    assert seamwright.parameter_at_length(QUARTER, math.pi / 2, 1e-12) == pytest.approx(
        0.5, abs=1e-11
    )
    t = seamwright.parameter_at_length(SPACE, 2, 1e-10)
    assert seamwright.arc_length(SPACE, 1e-12, 0, t)["value_mm"] == pytest.approx(2, abs=1e-10)


def test_moving_frames():
    frames = seamwright.rotation_minimizing_frames(SPACE, np.linspace(0, 1, 2001), normal=[0, 0, 1])
    matrices = np.stack([frames[name] for name in ("tangents", "normals", "binormals")], axis=1)
    assert matrices.shape == (2001, 3, 3)
    assert np.abs(matrices @ matrices.transpose(0, 2, 1) - np.eye(3)).max() < 1e-14
    assert np.abs(frames["points"][1000] - SPACE.point(0.5)).max() == 0
    # The normal changes along the tangent only.
    rate = np.diff(frames["normals"], axis=0)
    about = (rate * (frames["binormals"][1:] + frames["binormals"][:-1])).sum(axis=1)
    assert np.abs(about).max() < 1e-8 < np.abs(rate).max()
    through = seamwright.rotation_minimizing_frames(S, [0, 0.3, 0.5, 0.9], [0, 0, 3])
    assert np.abs(through["normals"] - [0, 0, 1]).max() < 1e-15
    assert seamwright.rotation_minimizing_frames(S, [])["points"].shape == (0, 3)


@pytest.mark.parametrize(
    "call, text",
    [
        (
            lambda: seamwright.frenet_frame(S, "x"),
            "t is 'x': a number or an array of numbers is needed",
        ),
        (lambda: seamwright.frenet_frame(S, math.nan), "t is nan: it must be finite"),
        (lambda: seamwright.find_degeneracies(S, 0), "resolution is 0"),
        (lambda: seamwright.arc_length(S, 0), "tolerance is 0"),
        (lambda: seamwright.arc_length(S, None), "tolerance_mm is None"),
        (lambda: seamwright.arc_length(S, 1, 0.5, 2), "range is 0.5 .. 2"),
        (
            lambda: seamwright.parameter_at_length(S, 100, 1e-6),
            "length is 100: the curve has 0 .. ",
        ),
        (lambda: seamwright.parameter_at_length(S, math.inf, 1e-6), "length_mm is inf"),
        (lambda: seamwright.rotation_minimizing_frames(S, [0, 0]), "parameter 1 is 0"),
        (lambda: seamwright.rotation_minimizing_frames(S, 0.5), "parameters is 0.5"),
        (lambda: seamwright.rotation_minimizing_frames(S, [0, 1], [1, 2]), r"normal is \[1, 2\]"),
        (
            lambda: seamwright.rotation_minimizing_frames(S, [0, 1], [0, 0, math.nan]),
            "coordinate 2 of the normal is nan",
        ),
        (
            lambda: seamwright.rotation_minimizing_frames(S, [0, 1], [1, 2, 0]),
            "must not lie along it",
        ),
        (lambda: seamwright.rotation_minimizing_frames(CUSP, [0, 0.5, 1]), "cusp at parameter 0.5"),
        (lambda: seamwright.rotation_minimizing_frames(CUSP, [0, 1]), "cusp at parameter 0.5"),
    ],
)
def test_bad_arguments(call, text):
    with pytest.raises(ValueError, match=text):
        call()


def test_what_is_no_curve():
    with pytest.raises(TypeError):
        seamwright.frenet_frame([[0, 0, 0], [1, 0, 0]], 0.5)
