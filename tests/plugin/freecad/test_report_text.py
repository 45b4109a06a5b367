# SPDX-License-Identifier: LGPL-2.1-or-later
"""A long report is read in parts, so that the window stays alive."""

import json

import pytest
from test_plain import TOLERANCE, seam

from freecad.seamwright.plain import report_text


@pytest.fixture
def lengths(monkeypatch):
    """The lengths of the texts that were parsed at once."""
    found, loads = [], json.loads
    monkeypatch.setattr(json, "loads", lambda text: found.append(len(text)) or loads(text))
    return found


@pytest.mark.parametrize("part", [2000, 5000])
def test_no_part_is_much_longer_than_wanted(monkeypatch, lengths, part):
    report = {"seams": [seam(number) for number in range(1, 41)], "tolerance": TOLERANCE}
    text, one = json.dumps(report), len(json.dumps(report["seams"][-1]))
    monkeypatch.setattr(report_text, "PART", part)
    assert report_text.read(text) == report
    assert max(lengths) <= part + one + len(json.dumps({"tolerance": TOLERANCE, "seams": []}))
    assert len(lengths) >= len(text) / (part + one) > 3


def test_a_short_report_is_read_at_once(lengths):
    text = json.dumps({"seams": [seam(1), seam(2)]})
    assert len(report_text.read(text)["seams"]) == 2 and lengths == [len(text)]
    assert 100_000 <= report_text.PART <= 400_000, "about 5 ms"
