# SPDX-License-Identifier: LGPL-2.1-or-later
"""A narrow crease that samples miss and enclosures find, as a picture.

    python3 06_hidden_crease.py OUT.svg

A level strip meets a spline strip of 128 spans along the line x = 0. The angle between them is 0.05
degrees along most of the seam. One pole is raised a little, which makes the angle 0.3 degrees over
four spans. These lie between two of the positions that a checker with 21 points samples. The
picture shows the enclosure of each span beside the samples of the checker. It is written without a
drawing library.
"""

import math
import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

SPANS = 128
HIGH_POLE = 69  # it affects spans 66 to 69, from 0.516 to 0.547 of the seam
ACCEPTED_DEG = 0.1


def slopes():
    """Yield the slope across the seam in each span of a uniform cubic B-spline.

    The slope is given by its four Bezier coefficients.
    """
    poles = np.full(SPANS + 3, math.tan(math.radians(0.05)))
    poles[HIGH_POLE] = math.tan(math.radians(0.45))
    for i in range(SPANS):
        a, b, c, d = poles[i : i + 4]
        yield np.array([(a + 4 * b + c) / 6, (2 * b + c) / 3, (b + 2 * c) / 3, (b + 4 * c + d) / 6])


def strip(span, x_to, heights):
    """Return a strip of degree 1 across the seam and 3 along it.

    It goes from x = 0, at height 0, to x_to at the given heights.
    """
    y = (span + np.linspace(0, 1, 4)) / SPANS
    level = np.stack([0 * y, y, 0 * y], axis=-1)
    far = np.stack([0 * y + x_to, y, heights], axis=-1)
    return seamwright.BezierPatch([level, far])


def angle_at(flat, bent, t):
    return math.degrees(seamwright.measure_pair(flat.jet(0, t), bent.jet(0, t))["angle_rad"])


pairs = [(strip(i, -1, np.zeros(4)), strip(i, 1, slope)) for i, slope in enumerate(slopes())]
bounds = [
    seamwright.enclose_seam(flat, "u0", bent, "u0", angle_deg=ACCEPTED_DEG)["angle_deg"]
    for flat, bent in pairs
]
checked = []
for k in range(21):
    span = min(k * SPANS // 20, SPANS - 1)
    checked.append((k / 20, angle_at(*pairs[span], k / 20 * SPANS - span)))
curve = [
    ((i + t) / SPANS, angle_at(*pair, t))
    for i, pair in enumerate(pairs)
    for t in np.linspace(0, 1, 9)
]

WIDTH, HEIGHT, LEFT, TOP = 760, 300, 50, 16
HIGHEST = 0.35


def x_of(s):
    return LEFT + s * (WIDTH - LEFT - 16)


def y_of(degrees):
    return TOP + (1 - degrees / HIGHEST) * (HEIGHT - TOP - 40)


def text(x, y, words, anchor="start", color="#222"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}">{words}</text>'


def line(x1, y1, x2, y2, style):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}/>'


def legend():
    entries = [
        ("#d55e00", "largest angle of each span, enclosed: [lower, upper]"),
        ("#222", "the angle itself"),
        ("#0072b2", "what a checker with 21 points sees"),
        ("#009e73", "accepted: 0.1°"),
    ]
    for row, (color, words) in enumerate(entries):
        yield (
            f'<rect x="{LEFT + 14}" y="{TOP + 8 + 19 * row}" width="12" height="10" '
            f'fill="{color}"/>'
        )
        yield text(LEFT + 33, TOP + 17 + 19 * row, words)


def picture():
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" '
        'font-size="12">'
    )
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    for degrees in (0, 0.1, 0.2, 0.3):
        yield line(LEFT, y_of(degrees), x_of(1), y_of(degrees), 'stroke="#ddd"')
        yield text(LEFT - 6, y_of(degrees) + 4, f"{degrees:g}°", "end")
    for s in (0, 0.25, 0.5, 0.75, 1):
        yield text(x_of(s), y_of(0) + 18, f"{s:g}", "middle")
    yield text(x_of(0.5), HEIGHT - 6, "place on the seam", "middle")
    yield line(
        LEFT,
        y_of(ACCEPTED_DEG),
        x_of(1),
        y_of(ACCEPTED_DEG),
        'stroke="#009e73" stroke-dasharray="6 4"',
    )
    for i, bound in enumerate(bounds):
        left, top, bottom = x_of(i / SPANS), y_of(bound["upper"]), y_of(bound["lower"])
        yield (
            f'<rect x="{left:.1f}" y="{top - 1:.1f}" width="{x_of(1 / SPANS) - LEFT:.1f}" '
            f'height="{bottom - top + 2:.1f}" fill="#d55e00"/>'
        )
    yield (
        f'<polyline points="{" ".join(f"{x_of(s):.1f},{y_of(a):.1f}" for s, a in curve)}" '
        'fill="none" stroke="#222"/>'
    )
    for s, degrees in checked:
        yield f'<circle cx="{x_of(s):.1f}" cy="{y_of(degrees):.1f}" r="4" fill="#0072b2"/>'
    yield from legend()
    yield "</svg>"


with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write("\n".join(picture()) + "\n")
lower, upper = max(b["lower"] for b in bounds), max(b["upper"] for b in bounds)
print(
    f"21 points see {max(a for _, a in checked):.3g} deg, the largest angle is {lower:.6g} to "
    f"{upper:.6g} deg"
)
