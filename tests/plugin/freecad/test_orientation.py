# SPDX-License-Identifier: LGPL-2.1-or-later
"""One side for the normals of loose faces."""

import itertools

import numpy
import pytest

from freecad.seamwright.plain import orientation


def strip(turned, angles_deg, count=5):
    """Squares in a row, each turned by its angle against the one before; normals turned over where
    ``turned`` is -1."""
    points, normals, first, at, slope = [], [], [0], numpy.zeros(3), 0.0
    for sign, angle in zip(turned, angles_deg):
        slope += numpy.radians(angle)
        along = numpy.array([numpy.cos(slope), 0, numpy.sin(slope)])
        normal = numpy.array([-numpy.sin(slope), 0, numpy.cos(slope)])
        for u, v in itertools.product(numpy.linspace(0, 1, count), repeat=2):
            points.append(at + u * along + v * numpy.array([0.0, 1.0, 0.0]))
            normals.append(sign * normal)
        first.append(len(points))
        at = at + along
    return numpy.array(points), numpy.array(normals), numpy.array(first)


@pytest.mark.parametrize("turned", list(itertools.product((1, -1), repeat=4)))
def test_loose_faces_come_to_one_side(turned):
    points, normals, first = strip(turned, [0, 3, -5, 2])
    found = orientation.signs(points, normals, first, range(4)) * turned
    assert len(set(found)) == 1
    if abs(sum(turned)) > 0:
        assert found[0] == numpy.sign(sum(turned))  # the smaller part is turned over


def test_faces_of_a_shell_stay_together():
    points, normals, first = strip((1, -1, -1, -1), [0, 3, -5, 2])
    assert list(orientation.signs(points, normals, first, [7, 7, 3, 3])) in (
        [1, 1, 1, 1],
        [-1, -1, 1, 1],
    )
    assert list(orientation.signs(points, normals, first, [7, 7, 7, 7])) == [1, 1, 1, 1]


def test_beyond_an_edge_nothing_is_reported():
    points, normals, first = strip((1, -1), [0, 80])
    assert list(orientation.signs(points, normals, first, range(2))) == [1, 1]


def test_the_numbers_do_not_depend_on_the_place():
    points, normals, first = strip((1, -1, 1), [0, 3, -5])
    for shift in numpy.random.default_rng(3).uniform(-1e4, 1e4, (20, 3)):
        assert list(orientation.signs(points + shift, normals, first, range(3))) == [1, -1, 1]


def test_nothing():
    none = numpy.empty((0, 3))
    for faces in (0, 1, 3):
        assert (
            list(orientation.signs(none, none, numpy.zeros(faces + 1, int), range(faces)))
            == [1] * faces
        )
    points, normals, first = strip((1,), [0])
    assert list(orientation.signs(points, normals, first, [0])) == [1]


def test_the_same_faces_agree_with_another_model():
    _, normals, first = strip((1, -1, 1), [0, 3, -5])
    _, others, other_first = strip((1, 1, -1), [0, 3, -5], count=9)
    assert list(orientation.agreeing(normals, first, others, other_first)) == [1, -1, -1]
    round_about = numpy.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)], float)
    ends = numpy.array([0, 4])
    assert list(orientation.agreeing(round_about, ends, -round_about, ends)) == [1]


def test_two_faces_that_meet_at_less_than_sixty_degrees_are_turned():
    """The cosine of the angle between their normals decides from one half on."""
    for angle, found in ((0, [1, -1]), (50, [1, -1]), (58, [1, -1]), (62, [1, 1])):
        points, normals, first = strip((1, -1), [0, angle])
        points, normals, first = points[:-5], normals[:-5], first - [0, 0, 5]
        assert list(orientation.signs(points, normals, first, range(2))) == found, angle


@pytest.mark.parametrize("size", (1e-3, 1.0, 1e5))
def test_points_are_equal_up_to_a_part_of_the_size(size):
    points, normals, first = strip((1, -1), [0, 0])
    moved = numpy.concatenate([points[:25], points[25:] + (1e-6, 1e-6, 1e-6)])
    assert list(orientation.signs(size * moved, normals, first, range(2))).count(-1) == 1
    apart = numpy.concatenate([points[:25], points[25:] + (1e-3, 0, 0)])
    assert list(orientation.signs(size * apart, normals, first, range(2))) == [1, 1]


def meeting(*products):
    """Faces of one point each: the points of a pair are equal, and their normals have a product."""
    points, normals, owners = [], [], []
    for place, (one, other, product) in enumerate(products):
        points += [(place, place % 2, 0)] * 2
        normals += [(0, 0, 1), (0, (1 - product**2) ** 0.5, product)]
        owners += [one, other]
    order = numpy.argsort(owners, kind="stable")
    first = numpy.concatenate([[0], numpy.cumsum(numpy.bincount(owners))])
    return numpy.array(points, float)[order], numpy.array(normals, float)[order], first


@pytest.mark.parametrize("weak", ((0, 1), (1, 2), (0, 2)))
@pytest.mark.parametrize("clear", (1.0, -1.0))
def test_what_is_least_clear_of_a_contradiction_does_not_count(weak, clear):
    """Three faces of which each two meet; with the pair that is least clear they contradict."""
    pairs = ((0, 1), (1, 2), (0, 2))
    given = [(*pair, -0.6 if pair == weak else clear) for pair in pairs]
    points, normals, first = meeting(*given)
    found = list(orientation.signs(points, normals, first, range(3)))
    middle = ({0, 1, 2} - set(weak)).pop()  # the face of both clear pairs
    assert found == [clear if face == middle else 1 for face in range(3)]


def test_the_part_with_fewer_points_is_turned_although_it_has_more_faces():
    large, other, ends = strip((1,), [0], count=9)
    small, normals, first = strip((1, 1, 1), [0, 0, 0], count=3)
    points = numpy.concatenate([large - (1, 0, 0), small])
    normals = numpy.concatenate([other, -normals])
    ends = numpy.concatenate([ends, ends[-1] + first[1:]])
    assert list(orientation.signs(points, normals, ends, range(4))) == [1, -1, -1, -1]


def test_a_closed_face_with_many_points_decides_nothing():
    at = numpy.linspace(0, 2 * numpy.pi, 1000, endpoint=False)
    ring = numpy.stack([numpy.cos(at), numpy.sin(at), 0 * at + 0.05], axis=1)
    ends = numpy.array([0, 1000])
    assert list(orientation.agreeing(ring, ends, -ring, ends)) == [1], "mean normals of 0.05"
    ring[:, 2] = 0.2
    assert list(orientation.agreeing(ring, ends, -ring, ends)) == [-1]
    one = numpy.array([(0, 0, 0.12)])
    assert list(orientation.agreeing(one, numpy.array([0, 1]), -one, numpy.array([0, 1]))) == [-1]


@pytest.mark.parametrize("product, turned", [(0.6, 1), (-0.6, -1)])
def test_one_point_is_enough_for_two_faces_to_meet(product, turned):
    points, normals, first = meeting((0, 1, product), (0, 2, 1.0))
    assert list(orientation.signs(points, normals, first, range(3))) == [1, turned, 1]
