# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two patches that meet with a crease, made to join with G1 and G2 by the smallest moves.

    python3 09_nearest_join.py OUT.svg

Both patches are bicubic, 40 mm by 60 mm. Their common edge has a gap of up to 0.2 mm and an angle
of some degrees. The picture shows the sections through the middle before and after, with heights
enlarged five times. It is written without a drawing library.
"""

import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

rows, columns = np.arange(4), np.arange(4)


def patch(sense, crease):
    """Return a patch whose rows go away from the seam, from x = 0 to x = 40 sense."""
    x, y = np.meshgrid(sense * 40 * rows / 3, 20 * columns, indexing="ij")
    height = 0.003 * (40 * np.sin(y / 25) + y * x / 40) - 0.0008 * x**2
    height += crease * np.abs(x) * (1 + y / 60) / 20
    height[0] += 0.2 * crease * np.array([0, 1, 1, 0])
    return seamwright.BezierPatch(np.stack([x, y, height], axis=-1))


def enclosed(a, b):
    figures = seamwright.enclose_seam(
        a, "u0", b, "u0", angle_deg=1e-6, curvature_rel=1e-6, crease_deg=60
    )
    return (
        figures["gap_mm"]["upper"],
        figures["angle_deg"]["upper"],
        figures["curvature_per_mm"]["upper"],
    )


left, right = patch(-1, 0), patch(1, 1)
print("given: gap %.3f mm, angle %.2f deg" % enclosed(left, right)[:2])
joins = {}
for order in (1, 2):
    for moves in ("b", "both"):
        join = joins[order, moves] = seamwright.nearest_join(
            left, "u0", right, "u0", order=order, moves=moves
        )
        gap, angle, curvature = enclosed(join["a"], join["b"])
        text = (
            f"G{order}, {moves:4} moves: {join['status']}, largest move "
            f"{join['largest_move_mm']:.3f} mm"
        )
        print(
            text,
            f"angle < {max(angle, 1e-9):.0e} deg"
            + (f", curvature < {max(curvature, 1e-9):.0e} / mm" if order == 2 else ""),
        )
        assert gap < 1e-7 and angle < 1e-7 and (order == 1 or curvature < 1e-8)

WIDTH, HEIGHT, MIDDLE = 760, 300, 190


def section(surface, style):
    points = [surface.point(u, 0.5) for u in np.linspace(0, 1, 41)]
    line = " ".join(f"{WIDTH / 2 + 9 * p[0]:.2f},{MIDDLE - 9 * 5 * p[2]:.2f}" for p in points)
    return f'<polyline points="{line}" fill="none" {style}/>'


def picture():
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" font-size="12">'
    )
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    yield f'<line x1="{WIDTH / 2}" y1="40" x2="{WIDTH / 2}" y2="{HEIGHT - 20}" stroke="#ddd"/>'
    entries = [
        (left, right, "#888", "given: a crease and a gap"),
        (joins[1, "both"]["a"], joins[1, "both"]["b"], "#0072b2", "G1, both sides moved"),
        (joins[2, "b"]["a"], joins[2, "b"]["b"], "#d55e00", "G2, the right side moved"),
    ]
    for row, (a, b, color, words) in enumerate(entries):
        style = f'stroke="{color}" stroke-width="1.6"'
        yield section(a, style) + section(b, style)
        yield f'<rect x="20" y="{20 + 19 * row}" width="12" height="10" fill="{color}"/>'
        yield f'<text x="39" y="{29 + 19 * row}">{words}</text>'
    yield f'<text x="{WIDTH / 2 + 6}" y="{HEIGHT - 24}" fill="#888">seam</text></svg>'


with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write("\n".join(picture()) + "\n")
