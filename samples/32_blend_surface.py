# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces between two sides of a model, one G1 and one G2, with zebra stripes.

    python3 32_blend_surface.py OUT.svg

The stripes of the G1 surface bend where it meets the faces given, those of the G2 surface run on
smoothly.
"""

import sys

import numpy as np

import seamwright
from grey_png import png

if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)

WIDTH, HEIGHT = 560, 330  # pixels of a picture
SAMPLES = 1000  # of a surface, in each direction: no pixel is left out
STRIPES = 34  # half waves over the directions of the reflected ray
RIGHT = np.array([0.8, 0.6, 0])  # the directions of the picture: right, up, and to the eye
EYE = np.array([0.48, -0.64, 0.6])
UP = np.cross(EYE, RIGHT)


def sheet(start_mm, height_mm, bulge):
    u, v = np.meshgrid(np.linspace(0, 30, 4), np.linspace(0, 40, 4), indexing="ij")
    z = height_mm + bulge * (u - 15) ** 2 / 100 + 0.008 * (v - 20) ** 2
    return seamwright.BezierPatch(np.stack([start_mm + u, v, z], axis=-1))


def edge_at(model, x_mm):
    """The number of the edge in a plane of this x."""
    for edge in range(1, model.edge_count + 1):
        if np.allclose(np.asarray(model.curve(edge).poles)[:, 0], x_mm):
            return edge
    raise ValueError(f"no edge at {x_mm} mm")


def points_of(surface):
    parameters = np.linspace(0, 1, SAMPLES)
    return surface.point(*np.meshgrid(parameters, parameters, indexing="ij"))


def zebra(surfaces):
    """The surfaces with stripes by the direction of the reflected ray."""
    grey, depth = np.full((HEIGHT, WIDTH), 255.0), np.full((HEIGHT, WIDTH), -np.inf)
    every = [points_of(surface) for surface in surfaces]
    seen = np.concatenate([np.stack([p @ RIGHT, p @ UP], axis=-1).reshape(-1, 2) for p in every])
    low, high = seen.min(axis=0), seen.max(axis=0)
    pixels_per_mm = 0.94 * min(np.array([WIDTH, HEIGHT]) / (high - low))
    for points in every:
        normal = np.cross(np.gradient(points, axis=0), np.gradient(points, axis=1))
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        ray = 2 * (normal @ EYE)[..., None] * normal - EYE
        stripe = np.sin(STRIPES * (ray @ np.array([0.3, 0.9, 0.3]))) > 0
        shade = (90 + 165 * abs(normal @ EYE)) * np.where(stripe, 1, 0.3)
        column = WIDTH / 2 + (points @ RIGHT - (low + high)[0] / 2) * pixels_per_mm
        row = HEIGHT / 2 - (points @ UP - (low + high)[1] / 2) * pixels_per_mm
        place = row.astype(int), column.astype(int)
        near = points @ EYE
        np.maximum.at(depth, place, near)
        front = near >= depth[place] - 0.2  # mm: samples of one pixel
        grey[place[0][front], place[1][front]] = shade[front]
    return png(grey.astype(np.uint8))


given = [sheet(0, 0, 1.6), sheet(60, 11, -1.6)]
model = seamwright.Model.from_patches(given)
start, end = edge_at(model, 30), edge_at(model, 60)
images = ""
for k, order in enumerate(("G1", "G2")):
    blend = model.blend_surface(start, end, start_order=order, end_order=order)
    largest = max(seam.curvature_rel.lower for seam in blend.seams)
    print(
        f"{order}: reached {blend.reached}, degrees {blend.surface.degree_u} x "
        f"{blend.surface.degree_v}, curvature differs by {100 * largest:.2f} %"
    )
    faces = [seamwright.BSplineSurface.from_patch(patch) for patch in given]
    images += (
        f'<text x="{WIDTH * (k + 0.5)}" y="22" text-anchor="middle">joined {order}</text>\n'
        f'<image x="{WIDTH * k}" y="30" width="{WIDTH}" height="{HEIGHT}" '
        f'xlink:href="{zebra([*faces, blend.surface])}"/>\n'
    )
with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        f'viewBox="0 0 {2 * WIDTH} {HEIGHT + 40}" font-family="sans-serif" font-size="15">\n'
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n{images}</svg>\n'
    )
