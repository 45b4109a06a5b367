# SPDX-License-Identifier: LGPL-2.1-or-later
"""enclose_seam, arc_length_derivatives and measure_joint against closed forms."""

import math

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierPatch, BezierTriangle
from seeds import seed_of_test

SLOPE = 0.01


def level():
    return BezierPatch([[[-1, 0, 0], [-1, 1, 0]], [[0, 0, 0], [0, 1, 0]]])


def bent(sense=1):
    """Height SLOPE 4 v (1 - v) x: it meets the level along x = 0 at an angle of at most
    atan(SLOPE), at v = 1/2."""
    y = np.array([0, 0.5, 1])
    return BezierPatch(
        [
            np.stack([0 * y, y, 0 * y], axis=-1),
            np.stack([0 * y + sense, y, [0, 2 * SLOPE, 0]], axis=-1),
        ]
    )


def encloses(figure, value, noise=0.0):
    return figure["lower"] <= value + noise and value <= figure["upper"] <= 1.01 * value + noise


def test_figures_and_verdict():
    angle = math.degrees(math.atan(SLOPE))
    seam = seamwright.enclose_seam(level(), "u1", bent(), "u0")
    assert seam["gap_mm"]["upper"] < 1e-11
    assert encloses(seam["angle_deg"], angle, 1e-13) and seam["angle_deg"]["at"] == pytest.approx(
        0.5, abs=0.1
    )
    assert (seam["level"], seam["class"], seam["certified"], seam["note"]) == (
        "G0",
        "defect",
        True,
        "",
    )
    accepted = seamwright.enclose_seam(level(), "u1", bent(), "u0", angle_deg=2 * angle)
    assert (accepted["level"], accepted["class"], accepted["certified"]) == ("G1", "smooth", True)


def triangle(sense, slope):
    """On the edge from (0, 0, 0) to (0, 1, 0), l0; its third corner lies in the direction of x."""
    return BezierTriangle([[0, 1, 0], [0, 0, 0], [sense, 0, slope]])


# Planes that meet at 180 degrees less atan(slope) agree as well as those of a smooth seam: only the
# note tells.
@pytest.mark.parametrize("slope", [0, 1e-4, 0.05])
def test_a_fold_is_told_of_patches_and_triangles(slope):
    flap = BezierPatch([[[0, 0, 0], [0, 1, 0]], [[-1, 0, slope], [-1, 1, slope]]])
    onward = BezierPatch([[[0, 0, 0], [0, 1, 0]], [[1, 0, slope], [1, 1, slope]]])
    sides = [(level(), "u1"), (triangle(-1, 0), "l0")]
    for a, edge_a in sides:
        for b, edge_b in ((flap, "u0"), (triangle(-1, slope), "l0")):
            seam = seamwright.enclose_seam(a, edge_a, b, edge_b)
            assert encloses(seam["angle_deg"], math.degrees(math.atan(slope)), 1e-5)
            assert (seam["level"], seam["class"], seam["certified"]) == ("G0", "crease", True)
            assert seam["note"] == "the faces fold back on one another"
        for b, edge_b in ((onward, "u0"), (triangle(1, slope), "l0")):
            seam = seamwright.enclose_seam(a, edge_a, b, edge_b)
            assert seam["class"] != "crease" and seam["note"] == ""


def test_curvature_of_a_rational_patch():
    radius, w = 2.0, math.sqrt(0.5)
    arc = np.array(
        [[[x, y, z] for y in (0, 1)] for x, z in ((0, radius), (radius, radius), (radius, 0))]
    )
    cylinder = BezierPatch(arc, weights=[[1, 1], [w, w], [1, 1]])
    flat = BezierPatch([[[-1, 0, radius], [-1, 1, radius]], [[0, 0, radius], [0, 1, radius]]])
    seam = seamwright.enclose_seam(flat, "u1", cylinder, "u0", level="G2")
    assert encloses(seam["curvature_per_mm"], 1 / radius, 1e-9) and encloses(
        seam["curvature_rel"], 1, 1e-9
    )
    assert (seam["level"], seam["class"], seam["certified"]) == ("G1", "defect", True)


def test_other_edges_and_senses():
    a, b = level(), bent()
    usual = seamwright.enclose_seam(a, "u1", b, "u0")
    swapped = seamwright.enclose_seam(b.transposed(), "v0", a.transposed(), "v1")
    assert swapped["angle_deg"]["lower"] == pytest.approx(usual["angle_deg"]["lower"], rel=1e-2)
    poles = b.poles[:, ::-1]
    turned = seamwright.enclose_seam(a, "u1", BezierPatch(poles), "u0", reversed=True)
    assert turned["level"] == usual["level"] and turned["gap_mm"]["upper"] < 1e-11
    assert seamwright.enclose_seam(a, "u1", BezierPatch(poles), "u0")["gap_mm"][
        "lower"
    ] == pytest.approx(1)


def test_a_point_without_tangent_plane_is_named():
    corner = BezierPatch([[[0, 0, 0], [0, 0.5, 0], [0, 1, 0]], [[0, 0, 0], [1, 0.5, 0], [1, 1, 0]]])
    seam = seamwright.enclose_seam(level(), "u1", corner, "u0")
    (point,) = seam["degenerate"]
    assert point["at"] < 1e-6 and (point["side_a"], point["side_b"]) == ("none", "vanishing normal")


def test_what_figures_leave_out_is_listed():
    seam = seamwright.enclose_seam(level(), "u1", bent(), "u0")
    assert seam["left_out"] == {"angle_deg": [], "curvature_per_mm": [], "curvature_rel": []}
    corner = BezierPatch([[[0, 0, 0], [0, 0.5, 0], [0, 1, 0]], [[0, 0, 0], [1, 0.5, 0], [1, 1, 0]]])
    seam = seamwright.enclose_seam(level(), "u1", corner, "u0")
    assert seam["left_out"]["angle_deg"] == []
    ((first, last),) = seam["left_out"]["curvature_rel"]
    assert first == 0 and 2**-22 < last <= 2**-20
    assert seam["left_out"]["curvature_per_mm"] == [[first, last]]
    assert f"the curvature leaves out the first {last:.3g}" in seam["note"]


@pytest.mark.parametrize(
    "arguments, word",
    [
        (("u2", "u0", {}), "u2"),
        (("u1", 3, {}), "edge_b"),
        (("u1", "u0", {"angle_deg": -1}), "-1"),
        (("u1", "u0", {"level": "G4"}), "G4"),
        (("u1", "u0", {"gap_mm": "wide"}), "wide"),
    ],
)
def test_bad_arguments(arguments, word):
    edge_a, edge_b, keywords = arguments
    with pytest.raises(ValueError, match=word):
        seamwright.enclose_seam(level(), edge_a, bent(), edge_b, **keywords)


def test_arc_length_of_a_circle_at_any_speed():
    radius, speed = 2.5, 7.0
    by_angle = [
        [radius * math.cos(k * math.pi / 2), radius * math.sin(k * math.pi / 2), 0]
        for k in range(6)
    ]
    found = seamwright.arc_length_derivatives(
        [np.array(d) * speed**k for k, d in enumerate(by_angle)]
    )
    expected = [np.array(d) / radius**k for k, d in enumerate(by_angle)]
    assert found == pytest.approx(np.array(expected), abs=1e-14)
    assert seamwright.arc_length_derivatives([[0, 0, 0], [0, 0, 0]]) is None


def test_arc_length_of_a_curve():
    curve = BezierCurve(
        [[0, 0, 0], [1, 0, 0], [2, 0.5, 0]]
    )  # (2 t, t^2 / 2): curvature 2 / 8 at t = 0
    found = seamwright.arc_length_derivatives(curve.derivatives(0, 2))
    assert found == pytest.approx(np.array([[0, 0, 0], [1, 0, 0], [0, 0.25, 0]]))


def test_a_joint_has_no_crease():
    a = seamwright.BezierCurve([[0, 0, 0], [1, 0, 0]])
    b = seamwright.BezierCurve([[1, 0, 0], [2, 0.1, 0]])
    assert seamwright.measure_joint(a, b, angle_deg=10)["order_reached"] >= 1
    assert seamwright.measure_joint(a, b, angle_deg=1)["order_reached"] == 0


def test_joint_of_halves_and_of_a_line_with_a_parabola():
    whole = BezierCurve(np.random.default_rng(seed_of_test()).normal(size=(6, 3)))
    joint = seamwright.measure_joint(*whole.split(0.3), order=4)
    assert joint["order_reached"] == 4 and len(joint["differences"]) == len(joint["sizes"]) == 5
    line, parabola = BezierCurve([[-1, 0, 0], [0, 0, 0]]), BezierCurve(
        [[0, 0, 0], [1, 0, 0], [2, 0.5, 0]]
    )
    joint = seamwright.measure_joint(line, parabola)
    assert (joint["gap_mm"], joint["angle_rad"], joint["order_reached"]) == (0, 0, 1)
    assert joint["differences"][2] == pytest.approx(0.25)
    assert seamwright.measure_joint(line, parabola, flat_radius_mm=2)["order_reached"] >= 2
    apart = BezierCurve([[0, 0.5, 0], [1, 0.5, 0]])
    assert seamwright.measure_joint(line, apart)["order_reached"] == -1
    assert seamwright.measure_joint(line, apart, gap_mm=1)["order_reached"] == 3
