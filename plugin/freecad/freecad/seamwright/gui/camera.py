# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the camera of a 3D view to a seam."""

import math

import FreeCAD as App
from pivy import coin

#: Height of the view as a multiple of the seam's size, so that its neighbourhood is seen too.
ROOM = 2.5

#: A seam is turned towards the camera when its faces look away by more than this cosine.
FACING = 0.25


def look_at(camera, box, least_height, normal):
    """Show the bounding box ``box`` (App.BoundBox), no smaller than ``least_height`` mm high.

    The view keeps its direction unless ``normal`` (outward, or None) points away from it.
    """
    direction = _direction(camera)
    if normal is not None and normal.dot(direction) > -FACING:
        camera.orientation.setValue(*_facing(normal).Q)
        direction = _direction(camera)
    height = max(ROOM * box.DiagonalLength, least_height)
    distance = max(height, camera.focalDistance.getValue())
    if camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
        distance = height / (2 * math.tan(camera.heightAngle.getValue() / 2))
    else:
        camera.height.setValue(height)
    camera.focalDistance.setValue(distance)
    camera.position.setValue(*(box.Center - direction * distance))


def _direction(camera):
    return App.Vector(*camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())


def _facing(normal):
    """Rotation of a camera that looks against ``normal``, a little from above, upright."""
    backward = App.Vector(normal).normalize() + App.Vector(0.3, -0.3, 0.4)
    return App.Rotation(App.Vector(), App.Vector(0, 0, 1), backward, "ZYX")
