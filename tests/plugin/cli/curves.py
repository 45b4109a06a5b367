# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points, and runs of the command curve, for its tests."""

import csv
import json
import math

from command import run
from schemas import expect_valid, validator

VALIDATOR = validator("curve")
METHODS = ["arcs", "clothoid", "conic", "fair"]
WAVE = [(5 * i, 10 * math.sin(0.5 * i)) for i in range(20)]
CIRCLE = [
    (3 + 10 * math.cos(math.tau * i / 12), 4 + 10 * math.sin(math.tau * i / 12)) for i in range(12)
]


def points_file(folder, points, name="points.csv", header=""):
    path = folder / name
    path.write_text(header + "".join(",".join(map(repr, point)) + "\n" for point in points))
    return path


def curve(method, given, *options, out="out.dxf"):
    """The result, the report and the file written."""
    out, report = given.parent / out, given.parent / "curve.json"
    result = run("curve", method, given, "-o", out, "--json", report, "--overwrite", *options)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(report.read_text())
    expect_valid(report, VALIDATOR)
    return result, report, out


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))
