# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alpha-curves: four poles and a shape that pulls the curve to its polygon.

    python3 16_alpha_curve.py OUT.svg

Above: one polygon with shapes from 0 to 1, and the cubic Bézier curve of the same poles. In the
middle: the shapes of least energy. Below: a spline of eight poles with its curvature comb; its five
segments have shapes of their own and are joined with C2.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

polygon = np.array([[0, 0, 0], [14, 30, 0], [46, 30, 0], [60, 0, 0]], float)
picture = Picture("One polygon, many shapes", width=760)

picture.polygon(polygon, "polygon")
for a, color in zip(
    (0, 0.25, 0.5, 0.75, 1), ("#bcd6ea", "#8fbbdc", "#5c9bcb", "#2f7fbb", "#005a94")
):
    picture.curve(seamwright.alpha_curve(polygon, a), color, f"shape {a:g}", width=1.6)
picture.curve(
    seamwright.BezierCurve(polygon), "#e69f00", "cubic Bézier curve of these poles", width=1.2
)

aside = polygon + [72, 0, 0]
picture.polygon(aside)
for energy, color in (
    ("length", "#009e73"),
    ("curvature", "#cc79a7"),
    ("curvature variation", "#000000"),
):
    best = seamwright.energy_optimal_alpha(polygon, energy)
    picture.curve(
        seamwright.alpha_curve(aside, best["a"]),
        color,
        f"least energy of {energy}: shape {best['a']:.3f}",
        width=1.6,
    )
    print(f"least energy of {energy}: a = {best['a']:.4f}")

poles = np.array(
    [
        [0, -68, 0],
        [8, -38, 0],
        [34, -34, 0],
        [52, -70, 0],
        [78, -74, 0],
        [92, -38, 0],
        [120, -36, 0],
        [132, -62, 0],
    ],
    float,
)
shapes = [1, 0.7, 1, 0.6, 1]
spline = seamwright.alpha_spline(poles, shapes)
picture.polygon(poles)
picture.curve(
    spline, "#d55e00", "five segments of shapes 1, 0.7, 1, 0.6, 1, joined with C2", comb=True
)
picture.points(
    np.array([spline.segment(i).point(0) for i in range(1, spline.segments)]), "joints", "#d55e00"
)
third = []
for i in range(spline.segments - 1):
    joint = seamwright.measure_joint(spline.segment(i), spline.segment(i + 1), 3)
    assert max(joint["differences"][:3]) < 1e-12
    third.append(joint["differences"][3])
print(
    "spline: C%d, curvature continuous, its change jumps by up to %.4f / mm^2: not G3"
    % (spline.continuity(), max(third))
)

fair = seamwright.alpha_spline(poles, [1, 0.7, 1, 0.75, 1], order=3)
joints = [
    seamwright.measure_joint(fair.segment(i), fair.segment(i + 1), 3)
    for i in range(fair.segments - 1)
]
print(
    "order 3: G3, jumps of the change of curvature below 1e-12:",
    max(joint["differences"][3] for joint in joints) < 1e-12,
)

picture.write(sys.argv[1])
