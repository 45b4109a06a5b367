# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body of revolution halfway between two others, with zebra stripes.

    python3 29_blended_body.py OUT.svg

Each profile is two quintics with a G2 joint. Left: the poles of the profiles are blended linearly;
the stripes break at the joint. Right: SplineBlend keeps G2, and the stripes run on smoothly. Below:
the curvature along both profiles.
"""

import math
import sys

import numpy as np

import seamwright
from grey_png import png

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

OMEGA = 0.5
WIDTH, HEIGHT = 300, 420  # pixels of a body
PIXELS_PER_MM = 3.6
STRIPES = 14  # half waves over the directions of the reflected ray
BACK, PLAIN, KEPT = "#ffffff", "#d55e00", "#0072b2"


def profiles():
    """Two vases as curves (radius, 0, height) from the foot to the mouth."""
    foot = [[26, 0, 0], [36, 0, 8], [40, 0, 20], [38, 0, 32], [31, 0, 44], [25, 0, 54]]
    mouth = [[25, 0, 54], [22, 0, 60], [19, 0, 70], [19, 0, 84], [22, 0, 94], [28, 0, 104]]
    first = joined(foot, mouth, [0.7, 0.3])
    foot = [[14, 0, 0], [15, 0, 12], [17, 0, 24], [21, 0, 38], [27, 0, 48], [33, 0, 54]]
    mouth = [[33, 0, 54], [36, 0, 62], [39, 0, 74], [38, 0, 86], [33, 0, 97], [26, 0, 104]]
    return first, joined(foot, mouth, [1.5, -0.4])


def joined(lower, upper, beta):
    """The lower curve, and the upper one with its first poles moved so that they join with beta."""
    a = seamwright.BezierCurve(lower)
    b = seamwright.curve_joined(a, seamwright.BezierCurve(upper), beta)
    return seamwright.BezierSpline.from_segments([a, b], [0, 1, 2])


def linear(first, second):
    poles = (1 - OMEGA) * first.poles + OMEGA * second.poles
    return seamwright.BezierSpline(first.degree, first.knots, poles)


def samples(profile):
    """Radius, height, slope of the radius by the height, curvature and arc length, densely."""
    rows = []
    for i in range(profile.segments):
        d = profile.segment(i).derivatives(np.linspace(0, 1, 2001), 2)
        (r, _, z), (dr, _, dz), (ddr, _, ddz) = d[:, 0].T, d[:, 1].T, d[:, 2].T
        curvature = (dr * ddz - dz * ddr) / (dr * dr + dz * dz) ** 1.5
        rows.append(np.stack([r, z, dr / dz, curvature], axis=1))
    rows = np.concatenate(rows)
    steps = np.linalg.norm(np.diff(rows[:, :2], axis=0), axis=1)
    return np.column_stack([rows, np.concatenate([[0], np.cumsum(steps)])])


def zebra(profile):
    """The body seen from the front, with stripes by the direction of the reflected ray."""
    r, z, slope, _, _ = samples(profile).T
    column = (np.arange(WIDTH) + 0.5 - WIDTH / 2) / PIXELS_PER_MM
    row = z[-1] - (np.arange(HEIGHT) + 0.5 - 20) / PIXELS_PER_MM
    x, height = np.meshgrid(column, row)
    radius, rise = np.interp(height, z, r), np.interp(height, z, slope)
    inside = (height > z[0]) & (height < z[-1]) & (abs(x) < radius)
    cosine = np.sqrt(np.clip(1 - (x / radius) ** 2, 0, 1))  # towards the eye
    normal = np.stack([x / radius, cosine, -rise]) / np.sqrt(1 + rise**2)
    # The eye looks along -y; its ray is reflected at the normal.
    ray = 2 * normal[1] * normal - np.array([0, 1, 0])[:, None, None]
    stripe = np.sin(STRIPES * (0.6 * ray[0] + 0.8 * ray[2])) > 0
    light = 0.55 + 0.45 * np.clip(0.8 * normal[1] - 0.4 * normal[0] + 0.3 * normal[2], 0, 1)
    grey = np.where(inside, 255 * light * np.where(stripe, 1, 0.25), 255)
    return png(grey.astype(np.uint8))


def plot(curves, top, height, width):
    """The curvatures by arc length."""
    tables = [samples(profile) for profile, _ in curves]
    low = min(table[:, 3].min() for table in tables)
    high = max(table[:, 3].max() for table in tables)
    longest = max(table[-1, 4] for table in tables)
    text = ""
    level = lambda k: top + height - height * (k - low) / (high - low)
    text += f'<path d="M40 {level(0):.1f}H{width - 20}" stroke="#999999"/>\n'
    for table, (_, color) in zip(tables, curves):
        points = " ".join(
            f"{40 + (width - 60) * s / longest:.2f},{level(k):.2f}" for k, s in table[::20, 3:]
        )
        text += f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"/>\n'
    return text


def body(profile, left, title, color):
    middle = left + WIDTH / 2
    return (
        f'<text x="{middle}" y="24" text-anchor="middle" fill="{color}">{title}</text>\n'
        f'<image x="{left}" y="34" width="{WIDTH}" height="{HEIGHT}" '
        f'xlink:href="{zebra(profile)}"/>\n'
    )


def described(name, profile):
    joint = profile.measure_joints(2)[0]
    print(f"{name}: angle {math.degrees(joint.angle_rad):.4f} degrees, curvature jumps by"
          f" {joint.differences[2]:.6f} / mm: G{joint.order_reached}")


def main():
    first, second = profiles()
    blend = seamwright.SplineBlend([first, second])
    frame = blend.frame_at(OMEGA)
    plain, kept = linear(first, second), frame.curve
    described("first profile", first)
    described("second profile", second)
    described("linear blend", plain)
    described("blend that keeps G2", kept)
    print(f"{frame.joints[0].remedy}, poles moved by up to {frame.joints[0].moved_mm:.2f} mm")

    width, plot_top, plot_height = 2 * WIDTH + 40, HEIGHT + 84, 150
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(
            f'<svg xmlns="http://www.w3.org/2000/svg" '
            f'xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 {width} '
            f'{plot_top + plot_height + 20}" font-family="sans-serif" font-size="14">\n'
            f'<rect width="100%" height="100%" fill="{BACK}"/>\n'
            + body(plain, 10, "poles blended linearly", PLAIN)
            + body(kept, WIDTH + 30, "joint kept G2", KEPT)
            + f'<text x="40" y="{plot_top - 12}">curvature along the profile</text>\n'
            + plot([(plain, PLAIN), (kept, KEPT)], plot_top, plot_height, width)
            + "</svg>\n"
        )


if __name__ == "__main__":
    main()
