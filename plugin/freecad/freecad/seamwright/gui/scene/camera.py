# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the camera of a 3D view to a direction from which a seam is visible."""

import math

import FreeCAD as App
from pivy import coin

#: Height of the view as a multiple of the seam's size, so that its neighbourhood is visible too.
ROOM = 2.5

#: A view is good where the cosine between the direction to the eye and the face normal is at least
#: this ...
FACING = 0.35

#: ... and the cosine between view direction and seam is at most this, so that the seam does not
#: shrink to a point.
ALONG = 0.9

#: Directions tried in this order: (right, up), added to a unit step along the normal.
LEANINGS = ((0.4, 0.5), (-0.4, 0.5), (0.0, 0.0), (0.8, 0.2), (-0.8, 0.2), (0.0, 1.2), (0.3, -0.8))


def look_at(view, box, least_height, location):
    """Show the bounding box ``box`` (App.BoundBox) in a view at least ``least_height`` mm high.

    ``location`` is (point, outward normal or None, tangent) on the seam. The view keeps its
    direction if the point is well visible from there. Else it turns to the first good direction
    of ``LEANINGS``.
    """
    camera = view.getCameraNode()
    _turn(view, camera, *location)
    direction = _direction(camera)
    height = max(ROOM * box.DiagonalLength, least_height)
    distance = max(height, camera.focalDistance.getValue())
    if camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
        distance = height / (2 * math.tan(camera.heightAngle.getValue() / 2))
    else:
        camera.height.setValue(height)
    camera.focalDistance.setValue(distance)
    camera.position.setValue(*(box.Center - direction * distance))


def _turn(view, camera, point, normal, tangent):
    """Turn the camera to a good direction; keep its direction where none is good."""
    if normal is None or _is_good(view, point, normal, tangent, _direction(camera)):
        return
    for right, up in LEANINGS:
        rotation = _facing(normal, right, up)
        direction = rotation.multVec(App.Vector(0, 0, -1))
        if _is_good(view, point, normal, tangent, direction):
            camera.orientation.setValue(*rotation.Q)
            return


def _is_good(view, point, normal, tangent, direction):
    if normal.dot(direction) > -FACING or abs(tangent.dot(direction)) > ALONG:
        return False
    return is_seen(view, point, direction)


def is_seen(view, point, direction):
    """Return whether nothing in the scene hides the point from a distant eye."""
    scene = view.getSceneGraph()
    # The viewer also knows its region. But FreeCAD 1.1 crashes at the close of a view whose viewer
    # was requested.
    region = coin.SbViewportRegion(*view.getSize())
    bounds = coin.SoGetBoundingBoxAction(region)
    bounds.apply(scene)
    box = bounds.getBoundingBox()
    size = math.dist(box.getMin().getValue(), box.getMax().getValue())
    ray = coin.SoRayPickAction(region)
    eye = point - direction * 2 * size
    ray.setRay(coin.SbVec3f(*eye), coin.SbVec3f(*direction))
    ray.apply(scene)
    hit = ray.getPickedPoint()
    if hit is None:
        return True
    return (App.Vector(*hit.getPoint().getValue()) - eye).Length > 1.99 * size


def _direction(camera):
    return App.Vector(*camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())


def _facing(normal, right, up):
    """Return the rotation of an upright camera that looks against ``normal``, with a lean."""
    upright = App.Rotation(App.Vector(), App.Vector(0, 0, 1), normal, "ZYX")
    backward = upright.multVec(App.Vector(right, up, 1))
    return App.Rotation(App.Vector(), App.Vector(0, 0, 1), backward, "ZYX")
