# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between points of the model and pixels of a 3D view, in double precision."""

import math

import numpy
from pivy import coin

#: Axes whose plane is taken where two are equally near to the direction of view: z, y, x.
AXES = numpy.eye(3)[::-1]

#: Two planes are equally near to the view where the cosines differ by less.
EQUAL = 1e-3


class Projection:
    """The projection of a view as it is now. Pixels count from the left and the top."""

    def __init__(self, view):
        """``view``: the 3D view of a document."""
        viewport = view.graphicsView().viewport()
        camera = view.getCameraNode()
        size = numpy.array([viewport.width(), viewport.height()], float)
        matrix = coin.SbMatrix()
        matrix.setRotate(camera.orientation.getValue())
        self._frame = numpy.array(matrix.getValue())[:3, :3]  # right, up, backwards
        self._eye = numpy.array(camera.position.getValue().getValue(), float)
        self._middle = size / 2
        self._is_flat = camera.isOfType(coin.SoOrthographicCamera.getClassTypeId())
        # Of a narrow view, the width holds what the height of the camera says.
        least = min(size)
        if self._is_flat:
            self._scale = least / camera.height.getValue()
        else:
            self._scale = least / 2 / math.tan(camera.heightAngle.getValue() / 2)

    def pixels(self, points):
        """Return the pixels (count, 2) of points (count, 3); nan behind the eye."""
        local = (numpy.asarray(points, float).reshape(-1, 3) - self._eye) @ self._frame.T
        flat = local[:, :2] * self._scale
        if not self._is_flat:
            depth = numpy.where(local[:, 2] < 0, -local[:, 2], numpy.nan)
            flat = flat / depth[:, None]
        return self._middle + flat * [1, -1]

    def nearness(self, points):
        """Return numbers that are the larger, the nearer to the viewer points (count, 3) are."""
        return (numpy.asarray(points, float).reshape(-1, 3) - self._eye) @ self._frame[2]

    def ray(self, pixel):
        """Return (point, direction) of all points that are seen at a pixel."""
        across = (numpy.asarray(pixel, float) - self._middle) * [1, -1] / self._scale
        right, up, back = self._frame
        offset = across[0] * right + across[1] * up
        return (self._eye + offset, -back) if self._is_flat else (self._eye, offset - back)

    def on_plane(self, pixel, point, normal):
        """Return the point of a plane that is seen at a pixel; None where there is none.

        Where the normal is an axis, the point has exactly the coordinate of the plane.
        """
        start, direction = self.ray(pixel)
        slope = direction @ normal
        if abs(slope) < 1e-9:
            return None
        along = (numpy.asarray(point, float) - start) @ normal / slope
        if not self._is_flat and along <= 0:
            return None
        found = start + along * direction
        return found + ((point - found) @ normal) * normal

    def along_line(self, pixel, point, step):
        """Return the number at which point + number step is nearest to what is seen at a pixel."""
        start, direction = self.ray(pixel)
        step, direction = numpy.asarray(step, float), direction / numpy.linalg.norm(direction)
        across = step - (step @ direction) * direction
        square = across @ across
        if square <= 1e-9 * (step @ step):
            return None
        return float((start - point) @ across / square)

    def facing_axis(self):
        """Return the axis of space that is nearest to the direction of view; z first, then y."""
        cosines = abs(AXES @ self._frame[2])
        return AXES[int(numpy.argmax(cosines > cosines.max() - EQUAL))]

    def size_of_pixel_mm(self, point):
        """Return the length that a pixel has at a point, in mm."""
        if self._is_flat:
            return 1 / self._scale
        return abs((numpy.asarray(point, float) - self._eye) @ self._frame[2]) / self._scale
