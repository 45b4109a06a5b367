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
