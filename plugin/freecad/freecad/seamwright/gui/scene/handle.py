# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles in the 3D view that the user drags along a line to change a number.

A handle is asked for its number by a timer: the callbacks of draggers in Python end FreeCAD, since
they run without Python's lock.
"""

import FreeCAD as App
from pivy import coin

from freecad.seamwright.gui.scene import markers
from freecad.seamwright.gui.scene.live_curve import STALK_COLOUR
from freecad.seamwright.gui.scene.overlay import (
    outside_bounding_box,
    pixel_ratio,
    unlit_unpickable,
)

COLOUR, ACTIVE_COLOUR = (0.0, 0.62, 0.45), (1.0, 0.85, 0.0)

#: Radius of a handle, as a part of the size of the curve.
RADIUS = 0.02


class Handle:
    """A ball at the end of a line; add ``node`` to the root of a view provider."""

    def __init__(self):
        self._unit, self._seen, self._dropped = 1.0, 0.0, False
        self._origin, self._step = App.Vector(), App.Vector()
        self._stand, self._stalk = coin.SoTransform(), coin.SoCoordinate3()
        self.dragger = coin.SoTranslate1Dragger()
        for part, colour in (("translator", COLOUR), ("translatorActive", ACTIVE_COLOUR)):
            self.dragger.setPart(part, _ball(colour))
        for part in ("feedback", "feedbackActive"):
            self.dragger.setPart(part, coin.SoSeparator())
        whole, pick = coin.SoAnnotation(), coin.SoPickStyle()  # seen through faces
        pick.style = coin.SoPickStyle.SHAPE_ON_TOP
        for node in (_line(self._stalk), pick, self._stand, self.dragger):
            whole.addChild(node)
        self.node = outside_bounding_box(whole)

    def show(self, origin, step, value, size):
        """Put the handle to origin + value step; ``size``: that of the curve, in mm."""
        self._origin, self._step = origin, step = App.Vector(*origin), App.Vector(*step)
        radius = RADIUS * size
        rotation = App.Rotation(App.Vector(1, 0, 0), step)
        self._stand.translation = tuple(origin)
        self._stand.rotation = rotation.Q
        self._stand.scaleFactor = (radius, radius, radius)
        self._unit = step.Length / radius
        self._put(value)

    @property
    def held(self):
        """Whether the user is dragging it."""
        return self.dragger.isActive.getValue() and not self._dropped

    def drop(self, value):
        """Take the drag back to this number, and ignore the mouse until it is released."""
        self._put(value)
        self._dropped = True

    def dragged_to(self):
        """Return the number to which the user dragged it since the last call, or None."""
        if self._dropped:
            self._put(self.number())
            self._dropped = self.dragger.isActive.getValue()
            return None
        place = self._place()
        if place == self._seen:
            return None
        self._seen = place
        self._draw_stalk()
        return self.number()

    def number(self):
        """Return the number that was shown or read last."""
        return self._seen / self._unit

    def _put(self, value):
        self.dragger.translation = (value * self._unit, 0.0, 0.0)
        self._seen = self._place()
        self._draw_stalk()

    def _place(self):
        return self.dragger.translation.getValue()[0]

    def _draw_stalk(self):
        ends = self._origin, self._origin + self.number() * self._step
        self._stalk.point.setValues(0, 2, [tuple(end) for end in ends])


def _ball(colour):
    """Return a ball; where the view makes it smaller than a marker, the marker is seen."""
    ball, material, marker = coin.SoSeparator(), coin.SoMaterial(), coin.SoMarkerSet()
    point = coin.SoCoordinate3()
    point.point = (0.0, 0.0, 0.0)
    material.diffuseColor, marker.markerIndex = colour, markers.index(markers.CIRCLE)
    for node in (material, point, marker, coin.SoSphere()):
        ball.addChild(node)
    return ball


def _line(points):
    """Return a thin line between two points, which the mouse does not find."""
    line, colour, style = coin.SoSeparator(), coin.SoBaseColor(), coin.SoDrawStyle()
    colour.rgb, style.lineWidth = STALK_COLOUR, pixel_ratio()
    for node in (*unlit_unpickable(), colour, style, points, coin.SoLineSet()):
        line.addChild(node)
    return line
