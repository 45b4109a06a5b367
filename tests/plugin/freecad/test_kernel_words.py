# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the kernel in the words of the panels."""

import pytest

from freecad.seamwright.plain.kernel_words import in_words

SENTENCES = {
    "it ends elsewhere: gap_mm = 0.3 at (1, 2, 3), 0.01 is possible":
        "it ends elsewhere: a gap of 0.3 mm at (1, 2, 3), 0.01 mm is possible",
    "it leaves the plane by angle_rad = 0.1 (5.73 degrees) at (1, 2, 3): G1 allows 0.00175; G0 "
    "allows any":
        "it leaves the plane by 5.73\u00b0 at (1, 2, 3): G1 allows 0.1\u00b0; G0 allows any",
    "the angle from the side is angle_rad = -0.01 (-0.573 degrees), at least 0.0873 is needed":
        "the angle from the side is -0.573\u00b0, at least 5\u00b0 is needed",
    "its curvature is 0.1/mm, at (1, 2, 3): curvature_rel = 0.5, G2 allows 0.02; G1 allows any":
        "its curvature is 0.1/mm, at (1, 2, 3): a difference of curvature of 50 %, G2 allows 2 %; "
        "G1 allows any",
    "the tangent is 1.5707963267948966 rad out of the plane: at most 0.017453292519943295 is "
    "allowed":
        "the tangent is 90\u00b0 out of the plane: at most 1\u00b0 is allowed",
    "planes differ by angle_rad = 0.349 (20 degrees): no surface has bounded curvature there":
        "planes differ by 20\u00b0: no surface has bounded curvature there",
    "tangents differ by angle_rad = 0.1 there": "tangents differ by 5.73\u00b0 there",
    "gap_mm is -1: it must be positive": "\u201cgap\u201d is -1: it must be positive",
    "flat_rad is 0: it must be positive":
        "\u201ctangents in one plane within\u201d is 0: it must be positive",
    "size_mm is -1: it must be positive": "size_mm is -1: it must be positive",
    "length_mm is -1: it must be positive": "\u201cLength\u201d is -1: it must be positive",
    "a point moves 0.3 mm: at most 0.1 is allowed": "a point moves 0.3 mm: at most 0.1 is allowed",
}  # fmt: skip


@pytest.mark.parametrize("given, expected", SENTENCES.items())
def test_names_of_arguments_and_radians_are_words(given, expected):
    assert in_words(given, {"length_mm": "Length"}) == expected


def test_without_labels_there_are_the_words_for_arguments_without_fields():
    assert in_words("gap_mm is -1, it turns by 5 degrees and by 1 degree") == (
        "\u201cgap\u201d is -1, it turns by 5\u00b0 and by 1\u00b0"
    )
    assert in_words("length_mm is -1") == "length_mm is -1"
