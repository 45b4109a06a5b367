# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hole of five sides between bicubic patches, filled with five biquartic ones.

    python3 20_n_sided_fill.py OUT.svg

The patches around the hole are parts of one surface. So the fill can be compared with that surface,
and the corners of the hole are compatible. The picture shows the net of parameter lines before and
after. It is written without a drawing library.
"""

import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

SIDES = 5
ANGLES = 2 * np.pi * (np.arange(SIDES) + 0.25) / SIDES
STRETCH = np.array([1.0, 1.12, 0.95, 1.05, 0.9])


def height(x, y):
    return 14 - 0.012 * x**2 - 0.008 * y**2 + 0.00012 * (x**3 - 2 * x * y**2) + 0.03 * x


def lifted(corners):
    """Return the bicubic patch above a quadrilateral with corners (u, v) = 00, 01, 10, 11.

    The patch interpolates the height at 4 by 4 parameters.
    """
    t = np.arange(4) / 3
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=-1)
    u, v = np.meshgrid(t, t, indexing="ij")
    shares = np.stack([(1 - u) * (1 - v), (1 - u) * v, u * (1 - v), u * v], axis=-1)
    xy = shares @ np.asarray(corners)
    values = np.concatenate([xy, height(xy[..., 0], xy[..., 1])[..., None]], axis=-1)
    inverse = np.linalg.inv(basis)
    return seamwright.BezierPatch(np.einsum("ai,bj,ijc->abc", inverse, inverse, values))


inner = 30 * STRETCH[:, None] * np.stack([np.cos(ANGLES), np.sin(ANGLES)], axis=-1)
outer = 1.6 * inner
around = [
    lifted([inner[k], inner[(k + 1) % SIDES], outer[k], outer[(k + 1) % SIDES]])
    for k in range(SIDES)
]

fill = seamwright.n_sided_fill([(patch, "u0") for patch in around])
patches = fill["patches"]
degree = len(patches[0].poles) - 1
print(
    f"{len(patches)} patches of degree {degree} by {degree}, regular: {fill['regular']}, "
    f"corners exact: {all(corner['exact'] for corner in fill['corners'])}"
)


def halves(patch):
    """Split the neighbour at the middle of its edge u0.

    One patch of the fill meets each half.
    """
    poles = np.asarray(patch.poles)
    levels = [poles]
    while levels[-1].shape[1] > 1:
        levels.append((levels[-1][:, :-1] + levels[-1][:, 1:]) / 2)
    first = np.stack([level[:, 0] for level in levels], axis=1)
    second = np.stack([level[:, -1] for level in reversed(levels)], axis=1)
    return seamwright.BezierPatch(first), seamwright.BezierPatch(second)


def worst(seams):
    figures = [
        seamwright.enclose_seam(*seam, reversed=seam[3] == "v1", angle_deg=1e-8, curvature_rel=0.01)
        for seam in seams
    ]
    return max(f["angle_deg"]["upper"] for f in figures), max(
        f["curvature_per_mm"]["upper"] for f in figures
    )


spokes = [(patches[k], "u0", patches[(k + 1) % SIDES], "v0") for k in range(SIDES)]
sides = []
for k, patch in enumerate(around):
    first, second = halves(patch)
    sides += [(first, "u0", patches[k], "v1"), (second, "u0", patches[(k + 1) % SIDES], "u1")]
for name, seams in (("between the patches", spokes), ("to the surroundings", sides)):
    angle, curvature = worst(seams)
    print(
        f"{name}: angle below {max(angle, 1e-8):.0e} degrees, curvature jumps by up to "
        f"{curvature:.4f} / mm"
    )
    assert angle < 1e-8

points = np.array(
    [
        patch.point(u, v)
        for patch in patches
        for u in np.linspace(0, 1, 21)
        for v in np.linspace(0, 1, 21)
    ]
)
off = np.abs(points[:, 2] - height(points[:, 0], points[:, 1])).max()
print(f"at most {off:.3f} mm from the surface, on {np.ptp(inner[:, 0]):.0f} mm")

WIDTH, HEIGHT = 760, 330


def projected(points, left):
    x, y, z = np.asarray(points).T
    return np.stack([left + 3.3 * (x + 0.2 * y), 150 - 3.3 * (0.65 * y + 0.7 * (z - 5))], axis=-1)


def lines(patch, left, color):
    places = np.linspace(0, 1, 13)
    for fixed in np.linspace(0, 1, 7):
        width = 1.8 if fixed in (0, 1) else 0.6
        for line in (
            [patch.point(fixed, s) for s in places],
            [patch.point(s, fixed) for s in places],
        ):
            text = " ".join(f"{a:.1f},{b:.1f}" for a, b in projected(line, left))
            yield f'<polyline points="{text}" fill="none" stroke="{color}" stroke-width="{width}"/>'


with open(sys.argv[1], "w", encoding="utf-8") as file:
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        file=file,
    )
    print(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>', file=file)
    for left, words in (
        (190, "a hole between five bicubic patches"),
        (570, "filled with five biquartic patches, G1 everywhere"),
    ):
        for patch in around:
            print(*lines(patch, left, "#888"), sep="\n", file=file)
        if left > 200:
            for patch in patches:
                print(*lines(patch, left, "#0072b2"), sep="\n", file=file)
        print(f'<text x="{left}" y="{HEIGHT - 12}" text-anchor="middle">{words}</text>', file=file)
    print("</svg>", file=file)
