# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane of points, with coordinates in it."""

import FreeCAD as App
import numpy

from freecad.seamwright.document.curves.inputs import check_places
from freecad.seamwright.plain.language import tr

#: A normal this near to an axis is that axis; rounding of rotated coordinates is smaller.
AXIS_SLACK = 1e-12

#: Points whose distances from a line are smaller than this part of their extent lie on the line.
LINE_SHARE = 1e-9

#: The axes of planes parallel to two axes of space, by their normal: those of FreeCAD's sketches.
AXES = {
    0: ((0, 1, 0), (0, 0, 1), (1, 0, 0)),
    1: ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    2: ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
}


class Plane:
    """A plane with an origin and a frame (x, y, normal)."""

    def __init__(self, origin, frame):
        self.origin = numpy.asarray(origin, float)
        self.frame = numpy.asarray(frame, float)

    @classmethod
    def through(cls, points):
        """Return the plane of the least squared distances of points (count, 3).

        It has the coordinates of space where it is parallel to two axes. Of points on a line, it
        contains the line and, if that is possible, is level.
        """
        centre = points.mean(axis=0)
        triangle = numpy.linalg.qr(points - centre, mode="r")  # as large for any number of points
        _, sizes, directions = numpy.linalg.svd(triangle, full_matrices=True)
        if len(sizes) < 2 or sizes[1] <= LINE_SHARE * sizes[0]:
            normal = _level_normal(directions[0] if sizes[0] > 0 else numpy.array([1.0, 0, 0]))
        else:
            normal = directions[2]
        for axis, frame in AXES.items():
            if abs(normal[axis]) > 1 - AXIS_SLACK:
                origin = numpy.zeros(3)
                origin[axis] = centre[axis]
                return cls(origin, frame)
        normal = normal * numpy.sign(normal[numpy.argmax(abs(normal))])
        x = numpy.cross(normal, [0, 0, 1.0])
        x = x / numpy.linalg.norm(x)
        return cls(centre, [x, numpy.cross(normal, x), normal])

    def coordinates(self, points):
        """Return (coordinates (count, 2), largest distance from the plane)."""
        local = (numpy.asarray(points, float) - self.origin) @ self.frame.T
        return local[:, :2], float(abs(local[:, 2]).max())

    def space(self, coordinates):
        """Return the points (count, 3) of coordinates (count, 2)."""
        return numpy.asarray(coordinates, float) @ self.frame[:2] + self.origin

    def vector(self, coordinates):
        """Return the point of two coordinates as a vector of FreeCAD."""
        return App.Vector(*self.space([coordinates])[0])

    def placement(self):
        """Return the placement of a sketch in the plane."""
        x, y, normal = (App.Vector(*row) for row in self.frame)
        return App.Placement(App.Vector(*self.origin), App.Rotation(x, y, normal, "ZXY"))

    def to_dict(self):
        """Return the numbers of the plane, for a report."""
        return {"origin": self.origin.tolist(), "frame": self.frame.tolist()}

    @classmethod
    def from_dict(cls, numbers):
        """Return the plane of a report."""
        return cls(numbers["origin"], numbers["frame"])


def _level_normal(direction):
    """Return the normal of the plane that contains a direction and is as level as possible."""
    up = numpy.array([0, 0, 1.0])
    normal = up - (up @ direction) * direction
    if numpy.linalg.norm(normal) < LINE_SHARE:
        return numpy.array([0, 1.0, 0])
    return normal / numpy.linalg.norm(normal)


def plane_of(points, flatness_mm):
    """Return the Plane of points.

    Raises ValueError where a point is too far from it, or is not finite.
    """
    check_places(points)
    plane = Plane.through(points)
    _, distance = plane.coordinates(points)
    if distance > flatness_mm:
        raise ValueError(
            tr(
                "the points or edges are not in one plane: they are up to {distance:.3g} mm off "
                "it, and {flatness_mm:g} mm are allowed"
            ).format(distance=distance, flatness_mm=flatness_mm)
        )
    return plane
