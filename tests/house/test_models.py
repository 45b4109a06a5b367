# SPDX-License-Identifier: LGPL-2.1-or-later
"""The models of the samples are what they are said to be."""

import os
import subprocess
import sys
from pathlib import Path

SOURCE = Path(os.environ["SEAMWRIGHT_SOURCE"])
MODELS = Path(os.environ["SEAMWRIGHT_MODELS"])
sys.path.insert(0, str(Path(os.environ["SEAMWRIGHT_BUILD"]) / "python"))

import seamwright


def test_two_runs_give_the_same_bytes(tmp_path):
    subprocess.run(
        ["/usr/bin/python3", str(SOURCE / "samples/models/make_models.py"), str(tmp_path)],
        check=True,
    )
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {
        path.name: path.read_bytes() for path in MODELS.iterdir()
    }


def test_rounded_block_is_tangent_everywhere():
    report = seamwright.read(MODELS / "rounded_block.step").analyze()
    assert report.passed
    assert len(report) == 48


def test_broken_block_has_one_defect_of_two_degrees():
    report = seamwright.read(MODELS / "broken_block.step").analyze()
    (defect,) = [seam for seam in report.to_dict()["seams"] if seam["class"] == "defect"]
    assert abs(defect["angle_deg"]["lower"] - 2) < 1e-9
    assert abs(defect["angle_deg"]["at"] - 0.5) < 0.01


def test_the_open_block_lacks_a_corner():
    report = seamwright.read(MODELS / "open_block.step").analyze().to_dict()
    assert len(report["seams"]) == 48 - 3
    assert len(report["open"]) == 3
    assert [seam["class"] for seam in report["seams"]].count("defect") == 1


def test_the_sheet_is_curvature_continuous_everywhere():
    report = seamwright.read(MODELS / "sheet.step").analyze(level="G2")
    assert report.passed
    assert len(report) == 7
