# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command curve with curves that stop at an end, and with curves that can't be done."""

import math
import re

import numpy as np
import pytest

from command import contents, expect_one_line, run
from curves import METHODS, bezier_model, curve, rows_of

# (t^2, t^3) for t from 0 to 1, times 10: y = 10 (x / 10)^(3/2).
HALF_OF_CUSP = [(0, 0), (0, 0), (10 / 3, 0), (10, 10)]
CUSP = [(40, 0), (50, 10), (40, 10), (50, 0)]
ARCH = [(20, 0), (24, 8), (32, 8), (36, 0)]
SPACE = [(60, 0, 0), (61, 1, 0), (62, 0, 1), (63, 1, 0)]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("backwards", [False, True])
def test_a_curve_may_stop_at_its_ends(tmp_path, method, backwards):
    poles = HALF_OF_CUSP[::-1] if backwards else HALF_OF_CUSP
    result, report, _ = curve(method, bezier_model(tmp_path, [poles]), out="out.step")
    (found,) = report["curves"]
    assert result.returncode == 0 and report["refused"] == []
    assert found["distance_mm"] <= 0.01
    assert found["before"]["length_mm"] == pytest.approx(80 / 27 * (3.25**1.5 - 1))
    assert found["before"]["energy_per_mm"] is None  # the curvature is infinite
    assert found["before"]["extrema"] == found["before"]["inflections"] == 0
    assert found["after"]["length_mm"] == pytest.approx(found["before"]["length_mm"], rel=1e-2)
    assert found["pieces"] < 40


def test_arcs_beside_a_cusp_keep_their_distance(tmp_path):
    rows = rows_of(curve("arcs", bezier_model(tmp_path, [HALF_OF_CUSP]), out="out.csv")[2])
    for row in rows:
        x, y = float(row["x0"]), float(row["y0"])
        across = abs(y - 10 * max(x / 10, 0) ** 1.5) / math.sqrt(1 + 2.25 * max(x / 10, 0))
        assert across < 0.01


@pytest.mark.parametrize("method", METHODS)
def test_drawn_in_handles_are_lines(tmp_path, method):
    """A square as drawing programs write it: both handles of each side lie on its ends."""
    corners = [(1, 2), (11, 2), (11, 12), (1, 12)]
    sides = [[a, a, b, b] for a, b in zip(corners, corners[1:] + corners[:1])]
    result, report, _ = curve(method, bezier_model(tmp_path, sides), out="out.step")
    (found,) = report["curves"]
    assert result.returncode == 0 and found["closed"] and len(found["edges"]) == 4
    for figures in (found["before"], found["after"]):
        assert figures["length_mm"] == pytest.approx(40)
    assert found["before"]["energy_per_mm"] == pytest.approx(0, abs=1e-12)
    if method == "arcs":
        assert found["pieces"] == found["lines"] == 4 and found["corners"] == 4


@pytest.mark.parametrize("out", ["out.step", "out.dxf"])
@pytest.mark.parametrize("method", ["arcs", "clothoid", "fair"])
def test_a_curve_that_cannot_be_done_does_not_stop_the_others(tmp_path, method, out):
    given = bezier_model(tmp_path, [CUSP, ARCH, SPACE, HALF_OF_CUSP])
    result, report, written = curve(method, given, out=out)
    assert result.returncode == 1 and written.exists()
    assert not report["reached"] and result.stdout.endswith("NOT REACHED\n")
    assert [found["edges"] for found in report["curves"]] == [[2], [4]]
    reasons = {found["edges"][0]: found["reason"] for found in report["refused"]}
    assert set(reasons) == {1, 3}
    assert re.search("may stop|turns back", reasons[1]) and "not planar" in reasons[3]
    for edge, reason in reasons.items():
        assert f"Edge{edge}: not done: {reason}\n" in result.stdout


def test_arcs_of_conics_follow_what_they_can(tmp_path):
    given = bezier_model(tmp_path, [SPACE, ARCH])
    result, report, _ = curve("conic", given, out="out.svg")
    assert result.returncode == 1
    assert [found["edges"] for found in report["curves"]] == [[2]]
    assert [found["edges"] for found in report["refused"]] == [[1]]


@pytest.mark.parametrize(
    "curves, message",
    [
        ([CUSP], "curves.step: Edge1: the curve may stop at the parameter 0.5"),
        ([SPACE], "curves.step: Edge1: not planar: 0."),
        ([CUSP, SPACE], "none of its 2 curves can be done"),
    ],
)
def test_without_any_curve_nothing_is_written(tmp_path, curves, message):
    given = bezier_model(tmp_path, curves)
    before = contents(tmp_path)
    options = ["-o", tmp_path / "out.step", "--json", tmp_path / "curve.json"]
    expect_one_line(run("curve", "arcs", given, *options), message)
    assert contents(tmp_path) == before


def test_a_blend_of_curves_that_stop_at_an_end(tmp_path):
    low = bezier_model(tmp_path, [HALF_OF_CUSP], "low.step")
    high = bezier_model(tmp_path, [np.add(HALF_OF_CUSP, (0, 20)).tolist()], "high.step")
    result = run("curve", "blend", low, high, "-o", tmp_path / "out.step")
    assert result.returncode == 0, result.stderr


def test_a_blend_names_the_file_at_fault(tmp_path):
    wave = "".join(f"{i},{math.sin(i)}\n" for i in range(8))
    (tmp_path / "low.csv").write_text(wave)
    ring = [(math.cos(a), math.sin(a)) for a in np.linspace(0, math.tau, 5)]
    (tmp_path / "ring.csv").write_text("".join(f"{x},{y}\n" for x, y in ring[:-1]))
    made = run("curve", "arcs", "ring.csv", "--closed", "-o", "ring.step", cwd=tmp_path)
    assert made.returncode == 0
    options = ["-o", "out.step"]
    result = run("curve", "blend", "low.csv", "ring.step", *options, cwd=tmp_path)
    expect_one_line(result, "key curve 2 (ring.step) is closed, and key curve 1 (low.csv) is open")
