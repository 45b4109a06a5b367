# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points, and runs of the command curve, for its tests."""

import csv
import json
import math

from command import run
from models import curve_text
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


def bezier_model(folder, curves, name="curves.step"):
    """A STEP file of Bézier curves, each given by its poles (x, y) or (x, y, z)."""
    lines, sets = [], []
    for number, poles in enumerate(curves, 1):
        first = 1000 * number
        for i, pole in enumerate(poles):
            place = ",".join(f"{x:.17E}" for x in [*pole, 0.0][:3])
            lines.append(f"#{first + i}=CARTESIAN_POINT('',({place}));")
        names = ",".join(f"#{first + i}" for i in range(len(poles)))
        degree = len(poles) - 1
        lines += [
            f"#{first + 100}=B_SPLINE_CURVE_WITH_KNOTS('',{degree},({names}),.UNSPECIFIED.,.F.,.F.,"
            f"({degree + 1},{degree + 1}),(0.,1.),.UNSPECIFIED.);",
            f"#{first + 101}=TRIMMED_CURVE('',#{first + 100},(#{first},PARAMETER_VALUE(0.)),"
            f"(#{first + degree},PARAMETER_VALUE(1.)),.T.,.PARAMETER.);",
            f"#{first + 102}=GEOMETRIC_CURVE_SET('',(#{first + 101}));",
        ]
        sets.append(f"#{first + 102}")
    path = folder / name
    path.write_text(curve_text(lines, sets))
    return path


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))
