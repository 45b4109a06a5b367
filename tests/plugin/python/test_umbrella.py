# SPDX-License-Identifier: LGPL-2.1-or-later
"""Umbrellas: around spokes and inside boundaries, against the join conditions and closed forms."""

import numpy as np
import pytest

import seamwright
from seamwright import BezierCurve, BezierPatch, BezierTriangle
from seeds import seed_of_test

RANDOM = None


@pytest.fixture(autouse=True)
def random_numbers():
    global RANDOM
    RANDOM = np.random.default_rng(seed_of_test())


def spokes_of(count, closed=True, degree=3, bend=1.0):
    """Curves from (1, 2, 3) along the plane z = 3 at nearly equal angles, bent at random."""
    members = count if closed else count - 1
    angles = (
        (np.arange(count) + RANDOM.uniform(-0.2, 0.2, count))
        * (2 * np.pi if closed else 4)
        / members
    )
    net = (
        np.linspace(0, 10, degree + 1)[None, :, None]
        * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)[:, None, :]
    )
    net[:, 2:] += RANDOM.uniform(-bend, bend, net[:, 2:].shape)
    return net + [1, 2, 3]


def pairs(umbrella, closed=True):
    """For each inner spoke (member before, its edge, member behind, its edge, reversed,
    connection)."""
    members = umbrella["members"]
    for i, connection in enumerate(umbrella["connections"]):
        if connection is None:
            continue
        before, after = members[i - 1], members[i]
        triangle = isinstance(before, BezierTriangle)
        yield (
            before,
            "l0" if triangle else "u0",
            after,
            "l1" if isinstance(after, BezierTriangle) else "v0",
            triangle,
            connection,
        )


@pytest.mark.parametrize("kinds", ["patch", "triangle", "mixed"])
@pytest.mark.parametrize("closed", [True, False])
def test_every_spoke_is_certified_g1(kinds, closed):
    for count in (3, 4, 5, 8):
        m = count if closed else count - 1
        names = [("patch", "triangle")[k % 2] if kinds == "mixed" else kinds for k in range(m)]
        umbrella = seamwright.umbrella(spokes_of(count, closed), closed=closed, kinds=names)
        assert [isinstance(member, BezierTriangle) for member in umbrella["members"]] == [
            n == "triangle" for n in names
        ]
        inner = list(pairs(umbrella, closed))
        assert len(inner) == (m if closed else m - 1)
        for a, edge_a, b, edge_b, backwards, connection in inner:
            condition = seamwright.join_condition(a, edge_a, b, edge_b, reversed=backwards)
            assert condition["verdict"] == "G1" and condition["gap_bound_mm"] < 1e-12
            seam = seamwright.enclose_seam(a, edge_a, b, edge_b, reversed=backwards, angle_deg=1e-7)
            assert seam["certified"] and seam["angle_deg"]["upper"] < np.degrees(1e-9)


def test_connections_are_those_of_the_joins():
    """Row 1 of a member follows from its neighbour and the connection: seamwright.join_rows is
    other code."""
    umbrella = seamwright.umbrella(spokes_of(5))
    for before, edge, after, _, _, connection in pairs(umbrella):
        poles, _ = seamwright.join_rows(before, edge, degree_across=3, degree=3, **connection)
        assert poles[0] == pytest.approx(after.poles[:, 0], abs=1e-12)
        assert poles[1] == pytest.approx(after.poles[:, 1], abs=1e-10)


def test_members_given_come_back():
    spokes = spokes_of(5)
    first = seamwright.umbrella(spokes)
    again = seamwright.umbrella(first["spokes"], members=first["members"])
    assert again["member_move_mm"] < 1e-11 and again["spoke_move_mm"] < 1e-13
    moved = [
        BezierPatch(member.poles + RANDOM.uniform(-0.1, 0.1, (4, 4, 3)))
        for member in first["members"]
    ]
    near = seamwright.umbrella(spokes, members=moved)
    change = [
        sum(np.sum((a.poles - b.poles) ** 2) for a, b in zip(umbrella["members"], moved))
        for umbrella in (near, first)
    ]
    assert 0 < change[0] < change[1]


def test_spokes_of_a_sphere_make_the_normal_of_the_sphere():
    """Spokes that share the tangent plane and the normal curvature of a sphere: of an even fan
    nothing has to change."""
    angles = np.array([0, 0.9, 2.1, 3.0, 4.4, 5.3])
    out = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)
    step = 2.0
    poles = np.stack(
        [
            0 * out,
            step * out,
            2 * step * out + [0, 0, -1.5 * step**2 / 20],
            3 * step * out + [0, 0, -4],
        ],
        axis=1,
    )
    umbrella = seamwright.umbrella(poles)
    assert umbrella["second_change_mm"] < 1e-12
    assert abs(umbrella["normal"]) == pytest.approx([0, 0, 1])
    turned = poles.copy()
    turned[0, 2, 2] += 1
    assert seamwright.umbrella(turned)["second_change_mm"] > 0.1
    shaped = seamwright.umbrella(turned, form=-np.diag([1, 1, 0]) / 20 * umbrella["normal"][2])
    curvatures = [
        curve.derivatives(0, 2)[2] @ umbrella["normal"] / (9 * step**2)
        for curve in shaped["spokes"]
    ]
    assert curvatures == pytest.approx([-umbrella["normal"][2] / 20] * 6)


def test_a_regular_vertex_has_four_spokes_that_continue_each_other():
    """The item is `crossing`; `regular` is an earlier name of the attribute."""

    def crossing_at(angle):
        turns = [0, np.pi / 2, np.pi, angle]
        return seamwright.umbrella(
            [np.linspace([0, 0, 0], [np.cos(t), np.sin(t), 0], 4) for t in turns]
        )

    for umbrella, expected in (
        (crossing_at(3 * np.pi / 2), True),
        (crossing_at(3 * np.pi / 2 + 0.1), False),
        (seamwright.umbrella(spokes_of(5)), False),
    ):
        assert umbrella.regular_vertex is expected
        for name in ("regular_vertex", "crossing", "regular"):
            assert umbrella[name] is expected
        assert umbrella.regular is expected


def test_inside_a_boundary():
    for n in range(3, 9):
        turn = 2 * np.pi * np.arange(n + 1) / n
        corners = 10 * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=-1)
        sides = [np.linspace(corners[k], corners[k + 1], 4) for k in range(n)]
        for side in sides:
            side[1:3] += RANDOM.uniform(-1, 1, (2, 3))
        umbrella = seamwright.umbrella_inside(sides)
        assert umbrella["angles_rad"].sum() == pytest.approx(2 * np.pi)
        for k, member in enumerate(umbrella["members"]):
            for t in np.linspace(0, 1, 5):
                assert member.point(1, t) == pytest.approx(
                    BezierCurve(sides[k]).point((1 + t) / 2), abs=1e-12
                )
                assert member.point(t, 1) == pytest.approx(
                    BezierCurve(sides[(k + 1) % n]).point((1 - t) / 2), abs=1e-12
                )
        for a, edge_a, b, edge_b, _, _ in pairs(umbrella):
            assert seamwright.join_condition(a, edge_a, b, edge_b)["angle_bound_rad"] < 1e-9


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({"closed": 1}, "closed is 1: True or False is needed"),
        (
            {"kinds": ["patch", "plane", "patch"]},
            "kind 1 is 'plane': 'patch' and 'triangle' are known",
        ),
        ({"kinds": ["patch"]}, "1 kinds for 3 sectors"),
        ({"members": [1]}, "member 0 is 1: a BezierPatch or a BezierTriangle is needed"),
        ({"degree": 2}, "degree 2 of the members"),
        ({"degree": 3.5}, "degree is 3.5: a whole number is needed"),
        ({"slopes": [0, 0]}, "2 values of lambda for 3 spokes"),
        ({"slopes": [0, float("nan"), 0]}, "lambda of spoke 1 is nan"),
        ({"form": np.eye(2)}, "shape"),
        ({"gap_mm": -1}, "gap_mm is -1"),
        ({"flat_rad": "0.1"}, "flat_rad is '0.1'"),
    ],
)
def test_bad_arguments(arguments, words):
    with pytest.raises(ValueError) as error:
        seamwright.umbrella(spokes_of(3), **arguments)
    assert words in str(error.value)


def test_bad_spokes():
    spokes = list(spokes_of(4))
    for change, words in (
        ((2, slice(None), np.nan), "not finite"),
        ((2, 0, 9.0), "spoke 2 begins"),
        ((1, 1, spokes[1][0]), "tangent of spoke 1 has length 0"),
        ((1, 1, spokes[1][1] + [0, 0, 1]), "out of the plane"),
        ((1, 1, spokes[0][1]), "sector 0, from spoke 0 to 1, has no angle"),
    ):
        bad = [np.array(poles) for poles in spokes]
        bad[change[0]][change[1]] = change[2]
        with pytest.raises(ValueError) as error:
            seamwright.umbrella(bad)
        assert words in str(error.value)
    with pytest.raises(ValueError, match="2 sides"):
        seamwright.umbrella_inside([spokes[0], spokes[0][::-1]])


def spokes_to_second_order(umbrella):
    """Tangents and second derivatives of the spokes, and a'(0), b'(0) of their connections."""
    first, second, slopes, cross_slopes = [], [], [], []
    for spoke, connection in zip(umbrella["spokes"], umbrella["connections"]):
        poles, n = spoke.poles, spoke.degree
        first.append(n * (poles[1] - poles[0]))
        second.append(n * (n - 1) * (poles[2] - 2 * poles[1] + poles[0]))
        a, b = ([0], [0]) if connection is None else (connection["beta"], -connection["alpha"])
        slopes.append((len(a) - 1) * (a[min(1, len(a) - 1)] - a[0]))
        cross_slopes.append((len(b) - 1) * (b[min(1, len(b) - 1)] - b[0]))
    return np.array(first), np.array(second), np.array(slopes), np.array(cross_slopes)


@pytest.mark.parametrize("count, closed", [(3, True), (5, True), (4, True), (6, True), (4, False)])
def test_twists_are_the_mixed_derivatives_of_the_members(count, closed):
    umbrella = seamwright.umbrella(spokes_of(count, closed), closed=closed)
    first, second, slopes, cross_slopes = spokes_to_second_order(umbrella)
    found = seamwright.umbrella_twists(
        first, second, closed=closed, slopes=slopes, cross_slopes=cross_slopes
    )
    assert np.abs(found.closing_defect_mm).max() < 1e-10
    assert found.second_derivatives == pytest.approx(second, abs=1e-9)
    mixed = np.array([member.jet(0, 0).uv for member in umbrella["members"]])
    difference = mixed - found.twists
    if found.direction is None:
        assert closed and count % 2 == 1
    else:
        along = found.direction / np.linalg.norm(found.direction)
        difference = difference - np.outer(along, along @ difference)
    assert np.abs(difference).max() < 1e-9 * np.abs(mixed).max()


def test_twists_of_spokes_that_do_not_close():
    angles = np.radians([0, 80, 170, 240])
    tangents = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=-1)
    second = np.array([[0, 0, 0.1], [0, 0, 0.2], [0, 0, 0.1], [0, 0, 0.2]])
    found = seamwright.umbrella_twists(tangents, second)
    assert abs(found.closing_defect_mm[2]) > 1e-3
    again = seamwright.umbrella_twists(
        tangents, found.second_derivatives, slopes=found.slopes, cross_slopes=found.cross_slopes
    )
    assert np.abs(again.closing_defect_mm).max() < 1e-14
    assert again.twists == pytest.approx(found.twists)
    for i in range(4):
        expected = (
            found.alpha[i] * found.second_derivatives[i]
            + found.slopes[i] * tangents[i]
            + found.cross_slopes[i] * tangents[i - 1]
        )
        assert found.twists[i] - found.beta[i] * found.twists[i - 1] == pytest.approx(expected)
    shaped = seamwright.umbrella_twists(tangents, second, form=np.diag([0.3, -0.1, 0]))
    assert np.abs(shaped.closing_defect_mm[2]) < 1e-15
    assert shaped.form == pytest.approx(np.diag([0.3, -0.1, 0]))
    with pytest.raises(ValueError, match="form is not symmetric"):
        seamwright.umbrella_twists(tangents, second, form=[[0, 1, 0], [0, 0, 0], [0, 0, 0]])
    with pytest.raises(ValueError, match="3 rows for 4 tangents"):
        seamwright.umbrella_twists(tangents, second[:3])
    with pytest.raises(ValueError, match="values of lambda"):
        seamwright.umbrella_twists(tangents, second, slopes=[1, 2])


@pytest.mark.parametrize("count, closed", [(3, True), (4, True), (5, True), (6, True), (5, False)])
def test_g2_umbrellas_have_no_jump(count, closed):
    umbrella = seamwright.g2_umbrella(spokes_of(count, closed, bend=0.5), closed=closed)
    for before, edge, after, edge_after, _, connection in pairs(umbrella, closed):
        seam = seamwright.enclose_seam(before, edge, after, edge_after, curvature_rel=1e-6)
        assert seam["certified"] and seam["curvature_per_mm"]["upper"] < 1e-7
        poles, _ = seamwright.join_rows(
            before, edge, degree_across=3, degree=3, order=2, **connection
        )
        for row in range(3):
            assert poles[row] == pytest.approx(after.poles[:, row], abs=1e-8)
    again = seamwright.g2_umbrella(umbrella.spokes, closed=closed, members=umbrella)
    assert again.member_move_mm < 1e-8
    with pytest.raises(ValueError, match="is a BezierTriangle"):
        seamwright.g2_umbrella(umbrella.spokes, members=[BezierTriangle(np.eye(3))] * count)


def test_a_given_boundary_is_kept():
    first = seamwright.umbrella(spokes_of(5))
    boundary = [(member.poles[-1], member.poles[:, -1]) for member in first.members]
    across = [
        (3 * (member.poles[-1] - member.poles[-2]), 3 * (member.poles[:, -1] - member.poles[:, -2]))
        for member in first.members
    ]
    for more in ({}, {"across": across}):
        umbrella = seamwright.umbrella(first.spokes, boundary=boundary, **more)
        for member, (u1, v1) in zip(umbrella.members, boundary):
            for t in np.linspace(0, 1, 5):
                assert member.point(1, t) == pytest.approx(BezierCurve(u1).point(t), abs=1e-11)
                assert member.point(t, 1) == pytest.approx(BezierCurve(v1).point(t), abs=1e-11)
        for a, edge_a, b, edge_b, _, _ in pairs(umbrella):
            assert seamwright.join_condition(a, edge_a, b, edge_b)["angle_bound_rad"] < 1e-8
    with pytest.raises(ValueError, match="2 boundaries for 5 sectors"):
        seamwright.umbrella(first.spokes, boundary=boundary[:2])


def test_weights_of_spokes():
    spokes = [BezierCurve(poles, [1, 0.97, 0.95, 0.92]) for poles in spokes_of(5, bend=0.1)]
    umbrella = seamwright.umbrella(spokes)
    for a, edge_a, b, edge_b, _, connection in pairs(umbrella):
        assert seamwright.join_condition(a, edge_a, b, edge_b)["verdict"] == "G1"
        assert len(connection["e1"]) > 0
