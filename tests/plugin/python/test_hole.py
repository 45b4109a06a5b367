# SPDX-License-Identifier: LGPL-2.1-or-later
"""Model.holes() and Model.fill(): what the dicts say, and bad arguments."""

import pathlib

import pytest

import seamwright

SHELL = pathlib.Path("/usr/share/opencascade/data/occ/shell1.brep")


@pytest.fixture(scope="module")
def shell():
    if not SHELL.exists():
        pytest.skip("OpenCASCADE's shell1.brep is not installed")
    return seamwright.read(str(SHELL))


def test_a_face_is_replaced(shell):
    fill = shell.fill(face=64)
    assert fill.filled and fill.reached and fill.reason == ""
    assert 0 < fill.largest_angle_deg < 0.01
    assert 0 < fill.largest_gap_mm < 0.001
    report = fill.to_dict()
    assert report["schema"] == "seamwright.fill/1"
    assert len(report["sides"]) == len(report["corners"]) == len(report["faces"]) == len(report["inner"]) == 4
    assert fill.model.face_count == shell.face_count - 1 + 4
    assert "REACHED G1" in fill.to_table()


def test_what_misses_the_target_is_not_kept(shell):
    fill = shell.fill(face=64, angle_deg=1e-9)
    assert not fill.filled and not fill.reached and "does not surely reach G1" in fill.reason
    assert fill.model.face_count == shell.face_count
    assert shell.fill(face=64, angle_deg=1e-9, keep_anyway=True).filled


def test_holes_are_listed(shell):
    for hole in shell.holes():
        assert hole["length_mm"] == pytest.approx(sum(side["length_mm"] for side in hole["sides"]))


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"face": 0}, "face 0"),
        ({"face": 64, "hole": 1}, "both given"),
        ({"hole": 10**6}, "hole is 1000000"),
        ({"face": 64, "target": "G7"}, "G7"),
        ({"face": 64, "target": "G3"}, "G3"),
        ({"face": 64, "gap_mm": float("nan")}, "nan"),
        ({"face": 64, "angle_deg": "wide"}, "angle_deg"),
    ],
)
def test_bad_arguments(shell, arguments, message):
    with pytest.raises(ValueError, match=message):
        shell.fill(**arguments)
