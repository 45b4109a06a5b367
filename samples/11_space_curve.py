# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a space curve has no Frenet frame, frames that continue there, and its length.

    python3 11_space_curve.py OUT.svg

One curve has an inflection, at which its Frenet normal turns to the other side. Another one has a
cusp. The picture shows normals of both kinds, the points where the Frenet frame is undefined, and
points at equal distances along the curve with the cusp.
"""

import sys
from math import comb

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)


def curve(*powers, at=(0, 0, 0)):
    """Return a curve of degree 4 from coefficients of 1, u, u^2, ... with u = 2 t - 1."""
    poles = np.tile(np.array(at, dtype=float), (5, 1))
    for axis, coefficients in enumerate(powers):
        for power, coefficient in enumerate(coefficients):
            # u^k = ((1 - t) (-1) + t)^k, elevated to degree 4
            for i in range(5):
                share = sum(
                    comb(power, j) * comb(4 - power, i - j) * (-1) ** (power - j)
                    for j in range(max(0, i + power - 4), min(i, power) + 1)
                )
                poles[i, axis] += coefficient * share / comb(4, i)
    return seamwright.BezierCurve(poles)


bend = curve([0, 34], [0, 0, 0, 26], [0, 0, 0, 0, 12])
cusp = curve([0, 0, 40], [0, 0, 0, 22], [0, 0, 0, 0, 14], at=(28, -14, 0))

for name, one in (("bend", bend), ("cusp", cusp)):
    found = seamwright.find_degeneracies(one)
    for place in found["places"]:
        middle, reach = (place["last"] + place["first"]) / 2, (place["last"] - place["first"]) / 2
        print(
            f"{name}: {place['kind']} within {reach:.0e} of t = {middle:.6f}, certainly nowhere "
            "else"
        )

before, after = (seamwright.frenet_frame(bend, t)["normal"] for t in (0.5 - 1e-6, 0.5 + 1e-6))
carried = seamwright.rotation_minimizing_frames(bend, np.linspace(0, 1, 41), normal=[0, -0.3, 1])
rest = seamwright.rotation_minimizing_frames(bend, [0.5 - 1e-6, 0.5 + 1e-6], before)["normals"]
print(
    "across the inflection the Frenet normal turns by %.0f degrees, the moving one by %.0f"
    % tuple(np.degrees(np.arccos(np.clip(a @ b, -1, 1))) for a, b in ((before, after), rest))
)

for tolerance in (1, 1e-4, 1e-11):
    length = seamwright.arc_length(cusp, tolerance)
    print(
        f"length of the cusp's curve: {length['value_mm']:.10f} mm, certain to "
        f"{length['upper_mm'] - length['lower_mm']:.0e}"
    )
steps = np.linspace(0, length["value_mm"], 17)
even = [cusp.point(seamwright.parameter_at_length(cusp, s, 1e-9)) for s in steps]

drawing = Picture("Frames along space curves, and where there are none", view=(0.25, -0.9, 0.85))
drawing.curve(bend, label="an inflection in space")
drawing.curve(cusp, color="#cc79a7", label="a cusp, with points at equal distances along it")
frenet = [
    (bend.point(t), seamwright.frenet_frame(bend, t)["normal"])
    for t in np.linspace(0, 1, 41)
    if abs(t - 0.5) > 1e-9
]
drawing.arrows(
    [point for point, _ in frenet],
    [7 * normal for _, normal in frenet],
    label="Frenet normals: they change sides",
)
drawing.arrows(
    carried["points"],
    7 * carried["normals"],
    label="rotation minimising: carried on",
    color="#009e73",
)
drawing.points(even, color="#cc79a7")
drawing.points([bend.point(0.5), cusp.point(0.5)], label="no Frenet frame")
drawing.write(sys.argv[1])
