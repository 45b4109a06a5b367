# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the camera of a 3D view to a seam, to where nothing hides it."""

import math

import FreeCAD as App
from pivy import coin

#: Height of the view as a multiple of the seam's size, so that its neighbourhood is seen too.
ROOM = 2.5

#: A view is good when the faces at the seam are seen less obliquely than this cosine ...
FACING = 0.35

#: ... and steep enough on the seam itself, so that it does not shrink to a point.
ALONG = 0.9

#: Leanings away from the normal, tried in this order: right, up and towards the viewer.
LEANINGS = ((0.4, 0.5), (-0.4, 0.5), (0.0, 0.0), (0.8, 0.2), (-0.8, 0.2), (0.0, 1.2), (0.3, -0.8))


def look_at(view, box, least_height, place):
    """Show the bounding box ``box`` (App.BoundBox), no smaller than ``least_height`` mm high.

    ``place`` is (point, outward normal or None, tangent) on the seam. The view keeps its
    direction if the point is seen well from there; else it is turned to the first that is.
    """
    camera = view.getCameraNode()
    _turn(view, camera, *place)
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
    """Turn the camera to a direction from which the point is seen; leave it if there is none."""
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
    """Whether nothing of the scene lies before the point for an eye far away."""
    scene = view.getSceneGraph()
    # The viewer knows its region too, but FreeCAD 1.1 crashes when a view is closed that was asked
    # for its viewer.
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
    """Rotation of an upright camera that looks against ``normal``, leaning from it."""
    upright = App.Rotation(App.Vector(), App.Vector(0, 0, 1), normal, "ZYX")
    backward = upright.multVec(App.Vector(right, up, 1))
    return App.Rotation(App.Vector(), App.Vector(0, 0, 1), backward, "ZYX")
