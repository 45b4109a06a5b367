# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames between two outlines: blended pole by pole, and so that every joint stays G2.

    python3 28_blend_curves.py OUT.svg

Both outlines are G2 splines. Left: all poles are blended linearly, and corners appear. Right:
SplineBlend. In a browser the thick curve moves from one outline to the other and back.
"""

import math
import sys

import numpy as np

import seamwright

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

OMEGAS = np.linspace(0, 1, 25)
SHOWN = OMEGAS[::4]  # thin curves
POLE = np.array([[-40, 0, 0], [-25, 50, 0], [25, 50, 0], [40, 0, 0], [25, -45, 0], [-25, -45, 0]])
PEAR = np.array([[-52, -18, 0], [-16, 22, 0], [16, 60, 0], [30, 8, 0], [58, -40, 0], [-34, -52, 0]])
WIDTH, HEIGHT, GAP = 400, 390, 20  # pixels of a half


def outlines():
    first = seamwright.direct_g2_spline(POLE, [0.2, 0.5, 0.2, 0.35, 0.2, 0.45], 0.7, closed=True)
    second = seamwright.direct_g2_spline(PEAR, 0.4, [0.55, 0.9, 0.6, 0.8, 0.7, 0.6], closed=True)
    return first, second


def plain_frame(first, second, omega):
    """The linear blend of all poles and knots."""
    share = lambda a, b: (1 - omega) * np.array(a) + omega * np.array(b)
    return seamwright.BezierSpline(
        first.degree,
        share(first.knots, second.knots),
        share(first.poles, second.poles),
        closed=True,
    )


def path(curve, left):
    """The curve as cubics of SVG, the same number for each curve."""
    pieces = 4  # of a segment; their distance from it is far below a pixel
    words = []
    for i in range(curve.segments):
        segment = curve.segment(i)
        for k in range(pieces):
            (a, da), (b, db) = (segment.derivatives((k + end) / pieces, 1) for end in (0, 1))
            corners = [a, a + da / (3 * pieces), b - db / (3 * pieces), b]
            x, y = np.array(corners).T[:2] * 3.3
            x, y = left + WIDTH / 2 + x, HEIGHT / 2 + 25 - y
            if not words:
                words.append(f"M{x[0]:.2f} {y[0]:.2f}")
            words.append("C" + " ".join(f"{u:.2f} {v:.2f}" for u, v in zip(x[1:], y[1:])))
    return "".join(words) + "Z"


def half(title, curves, left, color):
    """Thin frames, and a curve that moves through all frames and back."""
    text = f'<text x="{left + WIDTH / 2}" y="24" text-anchor="middle">{title}</text>\n'
    for omega, curve in zip(OMEGAS, curves):
        if omega in SHOWN:
            text += f'<path d="{path(curve, left)}" stroke="#bbbbbb" stroke-width="0.8"/>\n'
    frames = [path(curve, left) for curve in [*curves, *curves[-2::-1]]]
    return (
        f'{text}<path d="{frames[len(OMEGAS) // 2]}" stroke="{color}" stroke-width="2.5">\n'
        f'<animate attributeName="d" dur="6s" repeatCount="indefinite" '
        f'values="{";".join(frames)}"/></path>\n'
    )


def largest_angle_deg(curves):
    joints = [joint for curve in curves for joint in curve.measure_joints(1)]
    return math.degrees(max(joint.angle_rad for joint in joints))


def main():
    first, second = outlines()
    blend = seamwright.SplineBlend([first, second])
    frames = [blend.frame_at(omega) for omega in OMEGAS]
    plain = [plain_frame(first, second, omega) for omega in OMEGAS]
    kept = [frame.curve for frame in frames]
    joints = [joint for frame in frames for joint in frame.joints]

    print(f"{len(OMEGAS)} frames of degree {blend.degree} with {len(blend.orders)} joints")
    print(f"linear: angles up to {largest_angle_deg(plain):.1f} degrees")
    defect = max(max(joint.defects) for joint in joints)
    remedies = " and ".join(sorted({joint.remedy for joint in joints}))
    moved = max(joint.moved_mm for joint in joints)
    print(f"kept: order {min(joint.order for joint in joints)}, {remedies}, defects below 1e-10:"
          f" {defect < 1e-10}, poles moved by up to {moved:.2f} mm")

    whole = 2 * WIDTH + GAP
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {whole} {HEIGHT + 30}" '
            'font-family="sans-serif" font-size="15">\n'
            '<rect width="100%" height="100%" fill="white"/>\n<g fill="none">\n'
            + half("poles blended linearly", plain, 0, "#d55e00").replace(
                "<text", '<text fill="black"')
            + half("joints kept G2", kept, WIDTH + GAP, "#0072b2").replace(
                "<text", '<text fill="black"')
            + "</g>\n</svg>\n"
        )


if __name__ == "__main__":
    main()
