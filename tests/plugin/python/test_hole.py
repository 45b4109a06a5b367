# SPDX-License-Identifier: LGPL-2.1-or-later
"""Model.holes() and Model.fill(): what the dicts say, and bad arguments."""

import pathlib
import sys

import numpy as np
import pytest

import seamwright

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from models import OCCT_DATA, installed, reader_that_finds, roof_text  # noqa: E402


@pytest.fixture(scope="module")
def shell():
    return seamwright.read(str(installed(OCCT_DATA / "occ/shell1.brep")))


def test_a_face_is_replaced(shell):
    fill = shell.fill(face=64)
    assert fill.filled and fill.reached and fill.reason == ""
    assert 0 < fill.largest_angle_deg < 0.01
    assert 0 < fill.largest_gap_mm < 0.001
    report = fill.to_dict()
    seams = report["outer"] + report["inner"]
    assert (
        fill.largest_curvature_rel
        == report["largest_curvature_rel"]
        == max(seam["curvature_rel"]["upper"] for seam in seams)
    )
    assert fill.curvature_jump_per_mm == report["curvature_jump_per_mm"] > 0
    assert report["schema"] == "seamwright.fill/1"
    assert (
        len(report["sides"])
        == len(report["corners"])
        == len(report["faces"])
        == len(report["inner"])
        == 4
    )
    assert fill.model.face_count == shell.face_count - 1 + 4
    assert "REACHED G1" in fill.to_table()


def test_faces_are_replaced_together(shell):
    one, list_of_one = shell.fill(face=64), shell.fill(face=[64])
    assert one.method == list_of_one.method == one.to_dict()["method"] == "patches"
    assert list_of_one.largest_angle_deg == one.largest_angle_deg
    assert one.removed_curvature_per_mm == one.to_dict()["removed_curvature_per_mm"] > 0
    assert 0 < one.curvature_per_mm < 10 * one.removed_curvature_per_mm
    assert one.around_curvature_per_mm == one.to_dict()["around_curvature_per_mm"] > 0
    assert one.waves is None and one.to_dict()["waves"] is None
    assert 0 <= one.both_ways_per_mm < 2 * one.around_curvature_per_mm
    for wrong, message in (([], "no face"), ([64, 999], "999"), (["64"], "whole number")):
        with pytest.raises(ValueError, match=message):
            shell.fill(face=wrong)


def test_jumps_of_curvature_are_told_where_they_were_looked_at(shell):
    fill = shell.fill(face=64, target="G2", keep_anyway=True)
    assert fill.curvature_jump_per_mm == fill.to_dict()["curvature_jump_per_mm"] > 0
    plain = shell.fill(face=64)
    assert 0 < fill.largest_curvature_rel <= plain.largest_curvature_rel
    flat = shell.fill(face=64, target="G0")
    assert flat.curvature_jump_per_mm is flat.to_dict()["curvature_jump_per_mm"] is None


def test_what_is_written_is_read_back(shell, tmp_path):
    fill = shell.fill(face=64)
    shares = []
    written = fill.write(tmp_path / "out.step", progress=shares.append)
    model = fill.model.analyze().to_dict()["model"]
    assert written["output"] == {
        "path": str(tmp_path / "out.step"),
        "format": "STEP",
        "edges": model["edges"],
        "faces": model["faces"],
        "open_edges": written["output"]["open_edges"],
        "defects": 0,
        "only_in_file": [],
        "spoilt_by_writing": None,
    }
    assert seamwright.read(tmp_path / "out.step").face_count == fill.model.face_count
    assert shares == sorted(shares) and shares[-1] == 1
    with pytest.raises(seamwright.ModelError, match="overwrite"):
        fill.write(tmp_path / "out.step")
    for stop in (0, 0.3, 0.7):
        with pytest.raises(seamwright.Cancelled):
            fill.write(tmp_path / "other.step", progress=lambda share: share < stop)
    assert [path.name for path in tmp_path.iterdir()] == ["out.step"]


def test_defects_in_the_file_are_reported(shell, tmp_path):
    fill = shell.fill(face=64, angle_deg=1e-9, keep_anyway=True)
    assert fill.write(tmp_path / "out.brep")["output"]["defects"] > 0


def test_the_file_is_judged_not_the_model(shell, tmp_path, monkeypatch):
    found = list((pathlib.Path(seamwright.__file__).parents[2] / "bin").glob("seamwright-read-*"))
    assert found, "no reader beside this module"
    fill = shell.fill(face=64)
    other = tmp_path / "other.step"
    other.write_text(roof_text(1))
    monkeypatch.setenv("SEAMWRIGHT_READER", str(reader_that_finds(other, tmp_path, found[0])))
    written = fill.write(tmp_path / "out.step")
    assert written["output"]["faces"] == 2 and written["differences"].startswith("read back: ")
    monkeypatch.setenv(
        "SEAMWRIGHT_READER", str(reader_that_finds(tmp_path / "none.step", tmp_path, found[0]))
    )
    before = sorted(tmp_path.iterdir())
    with pytest.raises(seamwright.ModelError, match="can't be read back, so it is not written"):
        fill.write(tmp_path / "another.step")
    assert sorted(tmp_path.iterdir()) == before


def test_what_misses_the_target_is_not_kept(shell):
    fill = shell.fill(face=64, angle_deg=1e-9)
    assert not fill.filled and not fill.reached and " is not G1: " in fill.reason
    assert fill.model.face_count == shell.face_count
    assert shell.fill(face=64, angle_deg=1e-9, keep_anyway=True).filled


def test_a_model_without_its_fill_is_written_as_it_was(shell, tmp_path):
    fill = shell.fill(face=64, target="G0", gap_mm=1e-9)
    assert not fill.filled
    assert max(fill.to_dict()["faces"]) > shell.face_count
    written = fill.write(tmp_path / "out.brep")
    assert (written["output"]["faces"], written["output"]["edges"]) == (
        shell.face_count,
        shell.edge_count,
    )
    assert (written["changed_faces"], written["differences"]) == (0, "")
    assert (tmp_path / "out.brep").read_bytes() == (OCCT_DATA / "occ/shell1.brep").read_bytes()


def test_holes_are_listed(shell):
    for hole in shell.holes():
        assert hole["length_mm"] == pytest.approx(sum(side["length_mm"] for side in hole["sides"]))
        assert len(hole["centre_mm"]) == 3


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
        ({"face": 64, "angle_deg": 0}, "angle tolerance is 0 deg"),
        (
            {"face": 64, "corner_deg": 200},
            "corner angle is 200 degrees: it must be above 0 and below 180",
        ),
    ],
)
def test_bad_arguments(shell, arguments, message):
    with pytest.raises(ValueError, match=message):
        shell.fill(**arguments)


def test_a_bad_corner_angle_of_holes_is_told_in_degrees(shell):
    with pytest.raises(
        ValueError, match="corner angle is 500 degrees: it must be above 0 and below 180"
    ):
        shell.holes(corner_deg=500)


def ring_with_a_kink(kink_mm, patch=(0, 1), pole=(3, 1), flat=False):
    """Eight patches of one surface around a hole, but for a kink in a seam that ends there.

    The pole that is moved is one on the edge of the hole, beside its corner.
    """
    patches = []
    for i, j in ((i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)):
        poles = np.array([[pole_of_a_quadric(i, j, p, q) for q in range(4)] for p in range(4)])
        if flat:
            poles[..., 2] = 0
        if (i, j) == patch:
            poles[pole][2] += kink_mm
        patches.append(seamwright.BezierPatch(poles))
    return seamwright.Model.from_patches(patches, sew_mm=1e-5)


def pole_of_a_quadric(i, j, p, q):
    """The pole (p, q) of a bicubic patch over the square (i, j) of 10 mm, by blossoms."""
    x, y = 10 * (i + p / 3), 10 * (j + q / 3)
    square_x = 100 * (i * i + 2 * i * p / 3 + p * (p - 1) / 6)
    square_y = 100 * (j * j + 2 * j * q / 3 + q * (q - 1) / 6)
    return [x, y, 0.01 * square_x - 0.008 * square_y + 0.004 * x * y]


def test_seams_that_end_at_a_hole_are_repaired_first():
    model = ring_with_a_kink(0.006)
    hole = next(h for h in model.holes() if not h.longest)
    plain = model.fill(hole=hole)
    assert not plain.filled and plain.around is None
    assert "neighbours_contradict" in [cause["code"] for cause in plain.causes]
    fill = model.fill(hole=hole, repair_first=True)
    assert fill.reached and fill.largest_angle_deg < 0.01
    assert fill.around["treated"] >= 1 and fill.around["repaired"] == fill.around["treated"]
    assert 0 < fill.around["largest_move_mm"] < 0.01
    assert len(fill.around["edges"]) == 8  # two at each corner
    assert fill.around["left"] == [] and fill.around["used"]
    assert "repaired first" in fill.to_table()


def test_a_repair_that_spoils_the_fill_is_left_out():
    # The hole lies in a plane. The kink vanishes towards it, so a plane fills it G2. The repair
    # makes the seam G2 by moves of poles beside the hole, which then lies in no plane.
    model = ring_with_a_kink(0.1, patch=(0, 0), pole=(2, 1), flat=True)
    hole = next(h for h in model.holes() if not h.longest)
    plain = model.fill(hole=hole, target="G2")
    fill = model.fill(hole=hole, target="G2", repair_first=True)
    assert plain.reached and fill.reached and fill.filled
    assert fill.around["repaired"] > 0 and not fill.around["used"]
    assert "without them one does: left out" in fill.to_table()
    for face in set(range(1, fill.model.face_count + 1)) - set(fill.to_dict()["faces"]):
        assert np.array_equal(fill.model.surface(face).poles, plain.model.surface(face).poles)


def test_without_a_kink_nothing_is_repaired_first():
    model = ring_with_a_kink(0)
    hole = next(h for h in model.holes() if not h.longest)
    fill = model.fill(hole=hole, repair_first=True)
    assert fill.reached and fill.around["treated"] == 0 and fill.around["largest_move_mm"] == 0


def test_without_a_fill_the_model_is_the_given_one():
    model = ring_with_a_kink(0.006)
    hole = next(h for h in model.holes() if not h.longest)
    fill = model.fill(hole=hole, repair_first=True, gap_mm=1e-12, angle_deg=1e-6)
    assert not fill.filled
    edges = range(1, model.edge_count + 1)
    assert all(np.array_equal(fill.model.curve(e).poles, model.curve(e).poles) for e in edges)
