# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nearest points of many triangles: what may be left out of the search, and what may not."""

import numpy
import pytest

from freecad.seamwright.plain import nearest


@pytest.fixture
def random():
    return numpy.random.default_rng(20261128)


def apart(points, others):
    return numpy.linalg.norm(points[:, None] - others[None], axis=2)


@pytest.mark.parametrize("spread", [(60, 60, 0.1), (1, 1, 1), (200, 0.01, 0.01)])
def test_triangles_of_one_point_are_found_in_a_model_far_away(random, spread):
    """The nearest of them is that with the least distance, whatever part of the points it is."""
    away = numpy.array([1000.0, -500.0, 300.0])
    corners = random.uniform(-1, 1, (500, 3)) * spread + away
    points = random.uniform(-1, 1, (300, 3)) * spread + away
    found = nearest.nearest(points, numpy.repeat(corners[:, None], 3, axis=1))
    distances = apart(points, corners)
    assert found.distances == pytest.approx(distances.min(axis=1), abs=1e-9)
    assert (found.triangles == distances.argmin(axis=1)).all()


def test_a_large_triangle_far_away_hides_no_small_one(random):
    """Heights over one large triangle in z = 0, and a few small triangles above it."""
    large = numpy.array([[(-900, -900, 0), (900, -900, 0), (0, 1800, 0)]], float)
    small = random.uniform(-40, 40, (60, 1, 3)) * (1, 1, 0) + (0, 0, 5) + numpy.array(
        [(0, 0, 0), (4, 0, 0), (0, 4, 0)]
    )
    points = random.uniform(-40, 40, (200, 3)) * (1, 1, 0) + (0, 0, 3)
    found = nearest.nearest(points, numpy.concatenate([small, large]))
    over = found.triangles == 60
    assert found.distances[over] == pytest.approx(3)
    assert 0 < over.sum() < 200 and (found.distances[~over] < 3).all()
    # where a triangle lies right above, it is 2 mm away
    beside = points[:, None, :2] - small[None, :, 0, :2]
    under = ((beside >= 0).all(axis=2) & (beside.sum(axis=2) <= 4)).any(axis=1)
    assert found.distances[under] == pytest.approx(2) and under.any()


def test_no_points_have_no_nearest():
    found = nearest.nearest(numpy.zeros((0, 3)), numpy.zeros((1, 3, 3)))
    assert [len(each) for each in found] == [0, 0, 0]


def test_equal_points_are_one_place():
    found = nearest.nearest(numpy.full((3, 3), 2.0), numpy.eye(3)[None] * 3)
    assert found.distances == pytest.approx(numpy.sqrt(3)), "x + y + z = 3"
    assert found.weights == pytest.approx(numpy.full((3, 3), 1 / 3))


def test_the_share_of_the_work_is_told():
    told = []
    points = numpy.zeros((300, 3))
    nearest.nearest(points, numpy.zeros((1, 3, 3)), lambda share: told.append(share) or True)
    assert told[0] == 0 and told == sorted(told) and 0.5 < told[-1] < 1
