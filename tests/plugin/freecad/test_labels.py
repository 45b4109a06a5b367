# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels at nearly the same point have lines of their own."""

import pytest

from freecad.seamwright.plain import labels


@pytest.mark.parametrize(
    "points, found",
    [
        ([], []),
        ([(0, 0, 0), (9, 0, 0)], [0, 0]),
        ([(0, 0, 0), (0.5, 0, 0), (0, 0, 0)], [0, 1, 2]),
        ([(0, 0, 0), (9, 0, 0), (0, 1, 0), (9, 0, 1), (9, 1, 0)], [0, 0, 1, 1, 1]),
        ([(0, 0, 0), (0.9, 0, 0), (1.8, 0, 0)], [0, 1, 0]),
    ],
)
def test_near_labels_have_different_lines(points, found):
    assert labels.lines_below(points, 1.0) == found


def test_only_equal_points_are_near_without_a_distance():
    assert labels.lines_below([(0, 0, 0), (0, 0, 1e-9), (0, 0, 0)], 0.0) == [0, 0, 1]


def test_the_size_of_points():
    assert labels.size([(1, 5, 0), (4, 1, 0), (2, 2, 12)]) == 13
    assert labels.size([]) == 0
