# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches around a point that join with common tangent planes.

    python3 19_umbrella.py OUT.svg

Left: five spokes with three patches and two triangles between them. Right: an umbrella that needs
no spokes; it fills a boundary of five sides. The picture shows lines at constant u and v, and thick
spokes. enclose_seam() certifies the seam at every spoke.
"""

import sys

import numpy as np

import seamwright
from seamwright.picture import Picture

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)


def around(k, n):
    return np.array([np.cos(2 * np.pi * k / n), np.sin(2 * np.pi * k / n)])


def spoke(k):
    """Return a spoke from (0, 0, 4) outwards and down.

    It starts along the plane z = 4. The spokes have different shapes.
    """
    reach = (13, 10, 12, 9, 11)[k]
    plane = around(k + 0.15 * (-1) ** k, 5)[None, :] * reach * np.array([[0], [0.3], [0.7], [1]])
    return np.column_stack([plane, (4, 4, 3, (0, 2.5, 0.5, 2, 1)[k])])


def side(k):
    """Return a curve from corner k to corner k + 1, bent upwards and inwards."""
    begin, end = 12 * around(k, 5), 12 * around(k + 1, 5)
    plane = [begin, 0.9 * (2 * begin + end) / 3, 0.9 * (begin + 2 * end) / 3, end]
    height = (0, 4, 2, 3, 1)
    return np.column_stack([plane, (height[k], 5, 5, height[(k + 1) % 5])])


def certified(umbrella):
    """Return an upper bound of the angle between tangent planes along the spokes, in rad."""
    largest = 0
    for i, after in enumerate(umbrella["members"]):
        before = umbrella["members"][i - 1]
        edges = [
            names[isinstance(member, seamwright.BezierTriangle)]
            for member, names in ((before, ("u0", "l0")), (after, ("v0", "l1")))
        ]
        backwards = isinstance(before, seamwright.BezierTriangle)
        seam = seamwright.enclose_seam(
            before, edges[0], after, edges[1], reversed=backwards, angle_deg=1e-8
        )
        assert seam["certified"]
        largest = max(largest, np.radians(seam["angle_deg"]["upper"]))
    return largest


COLORS = {"patch": "#0072b2", "triangle": "#009e73", "spoke": "#d55e00"}


def labels():
    """Return a function that returns the label of a kind of line, but only at its first use."""
    words = {kind: kind for kind in COLORS}
    return lambda kind: words.pop(kind, None)


def draw(umbrella, move, label):
    for member in umbrella["members"]:
        triangle = isinstance(member, seamwright.BezierTriangle)
        kind = "triangle" if triangle else "patch"
        color = COLORS[kind]
        for fixed in np.linspace(0, 1, 9)[1:]:
            free = np.linspace(0, 1 - fixed if triangle else 1, 25)
            picture.line(
                [member.point(fixed, x) + move for x in free], color=color, label=label(kind)
            )
            picture.line([member.point(x, fixed) + move for x in free], color=color)
        if triangle:
            picture.line(
                [member.point(x, 1 - x) + move for x in np.linspace(0, 1, 25)], color=color
            )
    for curve in umbrella["spokes"]:
        picture.curve(
            seamwright.BezierCurve(curve.poles + move),
            COLORS["spoke"],
            label=label("spoke"),
            width=2.5,
        )


picture = Picture("Umbrellas: around given spokes, and inside a boundary", view=(0.1, -0.9, 1.2))

mixed = seamwright.umbrella(
    [spoke(k) for k in range(5)], kinds=["patch", "patch", "triangle", "patch", "triangle"]
)
label = labels()
draw(mixed, [0, 0, 0], label)
print(
    f"around 5 spokes: members of degree {mixed['members'][0].degree_u}, angle below "
    f"{certified(mixed):.0e} rad, "
    f"condition {mixed['condition']:.1f}"
)

filled = seamwright.umbrella_inside([side(k) for k in range(5)])
draw(filled, [28, 0, 0], label)
print(
    f"inside 5 sides: members of degree {filled['members'][0].degree_u}, angle below "
    f"{certified(filled):.0e} rad, "
    f"sectors of {np.degrees(filled['angles_rad']).round().astype(int)} degrees"
)

picture.write(sys.argv[1])
