# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles in the 3D view that the user drags along a line to change a number.

A handle is asked for its number by a timer: the callbacks of draggers in Python end FreeCAD, since
they run without Python's lock.
"""

import FreeCAD as App
from pivy import coin

from freecad.seamwright.gui.scene.overlay import outside_bounding_box

COLOUR, ACTIVE_COLOUR = (0.0, 0.62, 0.45), (1.0, 0.85, 0.0)

#: Radius of a handle, as a part of the size of the curve.
RADIUS = 0.02


class Handle:
    """A ball on a line; add ``node`` to the root of a view provider."""

    def __init__(self):
        self._unit, self._seen, self._dropped = 1.0, 0.0, False
        self._stand = coin.SoTransform()
        self.dragger = coin.SoTranslate1Dragger()
        for part, colour in (("translator", COLOUR), ("translatorActive", ACTIVE_COLOUR)):
            self.dragger.setPart(part, _ball(colour))
        for part in ("feedback", "feedbackActive"):
            self.dragger.setPart(part, coin.SoSeparator())
        whole, pick = coin.SoAnnotation(), coin.SoPickStyle()  # seen through faces
        pick.style = coin.SoPickStyle.SHAPE_ON_TOP
        for node in (pick, self._stand, self.dragger):
            whole.addChild(node)
        self.node = outside_bounding_box(whole)

    def show(self, origin, step, value, size):
        """Put the handle to origin + value step; ``size``: that of the curve, in mm."""
        origin, step = App.Vector(*origin), App.Vector(*step)
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
        return self.number()

    def number(self):
        """Return the number that was shown or read last."""
        return self._seen / self._unit

    def _put(self, value):
        self.dragger.translation = (value * self._unit, 0.0, 0.0)
        self._seen = self._place()

    def _place(self):
        return self.dragger.translation.getValue()[0]


def _ball(colour):
    ball, material = coin.SoSeparator(), coin.SoMaterial()
    material.diffuseColor = colour
    for node in (material, coin.SoSphere()):
        ball.addChild(node)
    return ball
