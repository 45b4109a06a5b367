# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corner of a box where three fillets meet, filled with three triangles.

    python3 23_three_sided_fill.py OUT.svg

The fillets are cubic approximations of quarter cylinders, so the corner should be an eighth of a
sphere. Facets of the picture are shaded by their normals. It is written without a drawing library.
"""

import itertools
import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

RADIUS, LENGTH, HANDLE = 10.0, 9.0, 0.5522847498307936
AXES = np.eye(3)


def fillet(k):
    """Return the fillet that starts with edge u0, the arc between axes k and k + 1.

    It goes away from the corner.
    """
    a, b, along = AXES[k], AXES[(k + 1) % 3], AXES[(k + 2) % 3]
    arc = RADIUS * np.array([a, a + HANDLE * b, HANDLE * a + b, b])
    return seamwright.BezierPatch(np.stack([arc, arc - LENGTH * along]))


fillets = [fillet(k) for k in range(3)]
fill = seamwright.three_sided_fill([(patch, "u0") for patch in fillets])
triangles = fill["triangles"]
print(f"{len(triangles)} triangles of degree {triangles[0].degree}, regular: {fill['regular']}")

seams = [(triangles[k], "l1", triangles[k - 1], "l0") for k in range(3)]
sides = [(triangles[k], "l2", fillets[k], "u0") for k in range(3)]
for name, pairs, against in (
    ("between the triangles", seams, True),
    ("to the fillets", sides, False),
):
    angles = [
        seamwright.enclose_seam(*pair, reversed=against, angle_deg=1e-8)["angle_deg"]["upper"]
        for pair in pairs
    ]
    print(f"{name}: angle below {max(*angles, 1e-8):.0e} degrees")
    assert max(angles) < 1e-8

places = [(i / 12, j / 12) for i in range(13) for j in range(13 - i)]
off = [
    abs(np.linalg.norm(triangle.point(u, v)) - RADIUS) for triangle in triangles for u, v in places
]
print(
    f"at most {max(off):.3f} mm from the sphere of {RADIUS:.0f} mm; the arcs are "
    f"{RADIUS * 2.73e-4:.3f} mm from it"
)

WIDTH, HEIGHT, SCALE = 760, 310, 10.0
VIEW = np.array([1, 1, 1]) / 3**0.5
RIGHT = np.array([-1, 1, 0]) / 2**0.5
UP = np.cross(VIEW, RIGHT)
LIGHT = np.array([0.75, 0.25, 0.6])


def projected(points, left):
    return [
        f"{left + SCALE * (p @ RIGHT):.1f},{HEIGHT / 2 - 10 - SCALE * (p @ UP):.1f}"
        for p in np.asarray(points)
    ]


def facet(points, left, color):
    normal = np.cross(points[1] - points[0], points[2] - points[0])
    shade = 0.35 + 0.65 * abs(normal @ LIGHT) / np.linalg.norm(normal)
    fill_color = "rgb({:.0f},{:.0f},{:.0f})".format(*(np.clip(shade, 0, 1) * np.array(color)))
    return (
        f'<polygon points="{" ".join(projected(points, left))}" fill="{fill_color}" '
        f'stroke="{fill_color}" stroke-width="0.5"/>'
    )


def line(points, left, width):
    return (
        f'<polyline points="{" ".join(projected(points, left))}" fill="none" stroke="#222" '
        f'stroke-width="{width}"/>'
    )


def shaded_patch(patch, left, color):
    places = np.linspace(0, 1, 25)
    for a, b in itertools.pairwise(places):
        yield facet([patch.point(u, v) for u, v in ((0, a), (1, a), (1, b), (0, b))], left, color)
    for edge in (
        [patch.point(0, t) for t in places],
        [patch.point(t, 0) for t in (0, 1)],
        [patch.point(t, 1) for t in (0, 1)],
    ):
        yield line(edge, left, 1)


def shaded_triangle(triangle, left, color):
    steps = 14
    for i in range(steps):
        for j in range(steps - i):
            halves = [((i, j), (i + 1, j), (i, j + 1))]
            if i + j + 2 <= steps:
                halves.append(((i + 1, j + 1), (i, j + 1), (i + 1, j)))
            for half in halves:
                yield facet([triangle.point(u / steps, v / steps) for u, v in half], left, color)


def web(triangle, left):
    """Yield lines along the side, lines to the centre, and the spoke."""
    for out in np.arange(1, 5) / 5:
        yield line(
            [triangle.point(out * (1 - t), out * t) for t in np.linspace(0, 1, 13)], left, 0.3
        )
    for along in np.arange(0, 6) / 6:
        yield line(
            [triangle.point(t * (1 - along), t * along) for t in np.linspace(0, 1, 13)],
            left,
            0.3 if along else 1.2,
        )


with open(sys.argv[1], "w", encoding="utf-8") as file:
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        file=file,
    )
    print(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>', file=file)
    for left, words in (
        (190, "three fillets end at a hole"),
        (570, "filled with three triangles, G1 everywhere"),
    ):
        for patch in fillets:
            print(*shaded_patch(patch, left, (225, 225, 225)), sep="\n", file=file)
        if left > 200:
            for triangle in triangles:
                print(*shaded_triangle(triangle, left, (120, 190, 240)), sep="\n", file=file)
            for triangle in triangles:
                print(*web(triangle, left), sep="\n", file=file)
        print(f'<text x="{left}" y="{HEIGHT - 8}" text-anchor="middle">{words}</text>', file=file)
    print("</svg>", file=file)
