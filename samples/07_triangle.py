# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Bezier triangle as patches that a CAD kernel can hold, and back, as a picture.

    python3 07_triangle.py OUT.svg

A dome of degree 4 over a triangle becomes one patch with a collapsed edge, and also three regular
patches. The seams between the three patches are enclosed. The triangle is recovered from the one
patch. The picture is written without a drawing library.
"""

import math
import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

DEGREE = 4
CORNERS = 20.0 * np.array(
    [[math.cos(a), math.sin(a), 0] for a in (math.pi / 2, 7 * math.pi / 6, 11 * math.pi / 6)]
)


def dome():
    """Return a triangle above the plane triangle of the corners.

    Its poles are (i, j), i = 0..n, j = 0..n-i. They are higher between the corners.
    """
    poles = []
    for i in range(DEGREE + 1):
        for j in range(DEGREE + 1 - i):
            l = np.array([i, j, DEGREE - i - j]) / DEGREE
            poles.append(
                l @ CORNERS + [0, 0, 30 * l[0] * l[1] + 12 * l[2] * l[0] + 150 * (l[1] * l[2]) ** 2]
            )
    return seamwright.BezierTriangle(poles)


triangle = dome()
one, three = triangle.to_patch(), triangle.to_patches()

seams = [
    seamwright.enclose_seam(
        three[k],
        "u1",
        three[(k + 1) % 3],
        "v1",
        level="G2",
        gap_mm=1e-9,
        angle_deg=1e-7,
        curvature_rel=1e-6,
    )
    for k in range(3)
]
back = seamwright.BezierTriangle.from_patch(one)

WIDTH, HEIGHT = 760, 330
COLORS = ("#d55e00", "#0072b2", "#009e73")


def projected(point, middle):
    x, y, z = point
    return middle + 9 * (x + 0.15 * y), 185 - 9 * (0.7 * y + 0.7 * z)


def polyline(points, middle, style):
    places = " ".join("%.1f,%.1f" % projected(point, middle) for point in points)
    return f'<polyline points="{places}" fill="none" {style}/>'


def lines(patch, middle, color):
    along = np.linspace(0, 1, 25)
    for fixed in np.linspace(0, 1, 9):
        style = f'stroke="{color}" stroke-width="{2 if fixed in (0, 1) else 0.8}"'
        yield polyline([patch.point(fixed, t) for t in along], middle, style)
        yield polyline([patch.point(t, fixed) for t in along], middle, style)


def picture():
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" '
        'font-size="13" text-anchor="middle">'
    )
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    yield from lines(one, 190, "#555")
    for patch, color in zip(three, COLORS):
        yield from lines(patch, 570, color)
    for middle, words in ((190, "one patch, an edge collapsed"), (570, "three regular patches")):
        yield f'<text x="{middle}" y="{HEIGHT - 10}" fill="#222">{words}</text>'
        for name, corner in zip(("P0", "P1", "P2"), CORNERS):
            x, y = projected(corner, middle)
            yield (
                f'<text x="{x:.1f}" y="{y + (-8 if name == "P0" else 20):.1f}" '
                f'fill="#222">{name}</text>'
            )
    yield "</svg>"


with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write("\n".join(picture()) + "\n")
print(
    "seams of the three:",
    ", ".join("%s %s" % (s["level"], "certain" if s["certified"] else "open") for s in seams),
)
print(
    "found in the one: degree %d, poles %s"
    % (
        back.degree,
        "as they were" if np.allclose(back.poles, triangle.poles, rtol=0, atol=1e-12) else "moved",
    )
)
