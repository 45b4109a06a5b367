# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proposed match distance at the borders of its rules."""

import pytest

from freecad.seamwright.plain import match_distance


@pytest.mark.parametrize(
    "gaps, expected",
    [
        ((0.02, 0.58), 2.0),  # 29 times as large: of one kind, and twice 0.58 is 1.16
        ((0.02, 0.62), 0.05),  # 31 times
        ((0.01, 0.28, 8.0), 10.0),  # from gap to gap: 28 and 29 times
        ((8.9,), 10.0),
        ((9.0,), None),  # cut off at 0.9 of what was tried
        ((0.1,), 0.2), ((0.05,), 0.1), ((0.025,), 0.05), ((0.0251,), 0.1),
        ((8.0, 0.02, 0.03), 0.1),  # in any order
        ((None, 0.1), 0.2),  # a seam that was not measured
    ],
)  # fmt: skip
def test_the_borders_of_the_rules(gaps, expected):
    seams = [{"gap_mm": gap and {"lower": gap, "upper": None}} for gap in gaps]
    found = match_distance.proposed(seams, 10.0, 0.01)
    assert found == (expected if expected is None else pytest.approx(expected))
