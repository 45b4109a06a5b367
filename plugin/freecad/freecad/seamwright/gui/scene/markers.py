# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bitmaps of handles, as large on every screen; those of Coin have 9 pixels of the screen."""

import numpy
from pivy import coin

from freecad.seamwright.gui.scene.overlay import pixel_ratio

CIRCLE, RING, SQUARE, DIAMOND = "circle", "ring", "square", "diamond"

#: The size of a handle, and the width of the line of a ring, in pixels of the window.
SIZE_PX, LINE_PX = 9, 2

#: {(shape, size in pixels of the screen): index of the marker}.
_known = {}


def index(shape):
    """Return the index of the marker of a shape."""
    ratio = pixel_ratio()
    size = round(SIZE_PX * ratio) | 1  # a marker has a pixel in its middle
    if (shape, size) not in _known:
        found = coin.SoMarkerSet.getNumDefinedMarkers()
        covered = bitmap(shape, size, LINE_PX * ratio).ravel()
        text = "".join("x" if each else " " for each in covered)
        coin.SoMarkerSet.addMarker(found, coin.SbVec2s(size, size), text, False, True)
        _known[shape, size] = found
    return _known[shape, size]


def bitmap(shape, size, line):
    """Return which of size x size pixels a shape covers; ``line``: the width of a ring."""
    across, down = (abs(each - (size - 1) / 2) for each in numpy.indices((size, size)))
    reach = size / 2
    distance = numpy.hypot(across, down)
    return {
        CIRCLE: distance < reach,
        RING: (distance < reach) & (distance >= reach - line),
        SQUARE: numpy.maximum(across, down) < reach - 0.1 * size,
        DIAMOND: across + down < reach,
    }[shape]
