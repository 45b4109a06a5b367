# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round numbers on the axes of a plot."""

import pytest

from freecad.seamwright.plain import ticks


@pytest.mark.parametrize(
    "low, high, count, found",
    [
        (0, 10, 5, [0, 2, 4, 6, 8, 10]),
        (0, 10, 10, list(range(11))),
        (100, 110, 5, [100, 102, 104, 106, 108, 110]),
        (-0.3, 0.3, 6, [-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3]),
        (0.7, 3.9, 4, [1, 2, 3]),
        (57, 83, 3, [60, 70, 80]),
        (0, 0.6, 6, [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6]),
        (0, 7, 1, [0]),
        (0, 10, 0, [0, 10]),
        (5, 5, 4, [5]),
        (5, 4, 4, [5]),
    ],
)
def test_steps_are_of_one_two_or_five(low, high, count, found):
    assert ticks.ticks(low, high, count) == pytest.approx(found, abs=1e-12)
