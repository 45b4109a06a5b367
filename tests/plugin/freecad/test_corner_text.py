# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words about corners of several fillets."""

import pytest

from test_plain import TOLERANCE, seam

from freecad.seamwright.plain import corner_text


def test_an_empty_report_says_nothing_was_rounded():
    empty = {**corner_text.EMPTY_REPORT, "reason": "there are no edges."}
    assert corner_text.summary_text(empty) == "Not rounded: there are no edges."
    assert corner_text.filled_text(empty) == ""
    assert corner_text.new_faces(empty) == corner_text.patches(empty) == set()


def test_seams_are_named_by_the_faces_that_meet():
    assert corner_text.BETWEEN == {
        "spoke": "two patches", "section": "patch, fillet", "spring": "patch, face",
        "contact": "fillet, face", "fillets": "two fillets",
    }  # fmt: skip


@pytest.mark.parametrize(
    "edges, text", [([7], "1 edge to round."), ([7, 8, 9], "3 edges to round.")]
)
def test_what_waits_is_counted(edges, text):
    assert corner_text.waiting_text(edges) == text


def test_seams_of_a_corner_that_was_not_kept_have_no_numbers():
    found = {"met": False, "shortfall": "it is too far.", "filled_by": "patches",
             "patches_shortfall": "", "faces": [7], "edges": [],
             "seams": [{**seam(3), "between": "spoke",
                        "worst": {"quantity": "gap", "at": 0, "point": [0, 0, 0]}}]}  # fmt: skip
    made = corner_text.build_report(found, TOLERANCE)
    assert [(each["edges"], each["faces"], each["worst"]) for each in made["seams"]] == [
        ([], [], None)
    ]
    assert set(made) == set(corner_text.EMPTY_REPORT)
