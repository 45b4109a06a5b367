# SPDX-License-Identifier: LGPL-2.1-or-later
"""A gap between two patches closed G1 and G2, and why the difference is visible.

    python3 08_join_patches.py OUT.svg

Two curved patches are 6 mm apart. blend() puts one patch between them, once with common tangent
planes (G1), once with common curvature as well (G2). join_condition() proves the joins from control
points. The picture shows a section in the middle with its curvature as a comb, whose length jumps
where the curvature does. It is written without a drawing library.
"""

import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

x, y = np.meshgrid([0.0, 2, 4, 6], [0.0, 2, 4, 6], indexing="ij")
left = seamwright.BezierPatch(np.stack([x, y, 1.2 - 0.05 * x**2 + 0.02 * (y - 3) ** 2], axis=-1))
right = seamwright.BezierPatch(
    np.stack([12 + x, y, 0.3 + 0.6 * x - 0.08 * x**2 + 0.03 * (y - 3) ** 2], axis=-1)
)

blends = {order: seamwright.blend(left, "u1", right, "u0", order) for order in (1, 2)}
for order, between in blends.items():
    for surface, edge, own in ((left, "u1", "u0"), (right, "u0", "u1")):
        join = seamwright.join_condition(surface, edge, between, own)
        jump = seamwright.enclose_seam(surface, edge, between, own)["curvature_per_mm"]["lower"]
        print(
            f"order {order}, degrees {between.degree_u} by {between.degree_v}: "
            f"{'G2' if join['g2'] else join['verdict']}, "
            f"angle below {join['angle_bound_rad']:.0e} rad, curvature jumps by {jump:.4f} / mm"
        )

WIDTH, HEIGHT, SCALE, COMB = 760, 360, 38, 120


def comb(patch):
    """Yield the points of the section v = 1/2 and the ends of the comb.

    The comb goes along the normal. Its length is the curvature in the direction of u.
    """
    for u in np.linspace(0, 1, 25):
        jet = patch.jet(u, 0.5)
        normal = np.cross(jet.u, jet.v)
        normal /= np.linalg.norm(normal)
        curvature = normal @ jet.uu / (jet.u @ jet.u)
        place = np.array([30 + SCALE * jet.p[0], -SCALE * jet.p[2]])
        yield place, place + COMB * curvature * np.array([-normal[0], normal[2]])


def drawing(patches, height):
    for patch, color in zip(patches, ("#0072b2", "#d55e00", "#0072b2")):
        points = [(p + [0, height], q + [0, height]) for p, q in comb(patch)]
        for p, q in points:
            yield (
                f'<line x1="{p[0]:.1f}" y1="{p[1]:.1f}" x2="{q[0]:.1f}" y2="{q[1]:.1f}" '
                'stroke="#bbb"/>'
            )
        for k, style in ((0, f'stroke="{color}" stroke-width="3"'), (1, 'stroke="#666"')):
            path = " ".join(f"{pair[k][0]:.1f},{pair[k][1]:.1f}" for pair in points)
            yield f'<polyline points="{path}" fill="none" {style}/>'


def picture():
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" '
        'font-size="13">'
    )
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    for row, (order, between) in enumerate(blends.items()):
        yield f'<text x="14" y="{24 + 155 * row}" fill="#222">G{order}</text>'
        yield from drawing((left, between, right), 95 + 155 * row)
    yield "</svg>"


with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write("\n".join(picture()) + "\n")
