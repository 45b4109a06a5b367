# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a shape with the normals of its surfaces, fine enough for reflections.

The kernel makes them. Faces share no points, so that a break at a seam stays visible.
"""

import numpy
import Part

from freecad.seamwright.document import preferences
from freecad.seamwright.plain import curvature, kernel
from freecad.seamwright.plain.language import tr


class ShownMesh:
    """Arrays to draw.

    ``points`` and ``normals`` have the shape (n, 3), ``triangles`` (m, 3), ``moves_mm`` and
    ``mean_per_mm`` (n,) or empty. ``mean_per_mm``: the mean curvatures in 1/mm, positive where the
    face bends towards its normal; nan where it has none. ``principal_per_mm`` (n, 2): the principal
    curvatures, the larger first. ``parameters`` (n, 2): of the surface. The points of face k, from
    1, are those from ``first_nodes[k - 1]`` to ``first_nodes[k]``. ``faults``: dicts of face, from
    1, and reason, for the faces whose triangles are missing or do not cover them.
    """

    def __init__(self):
        self.points = self.normals = numpy.empty((0, 3))
        self.triangles = numpy.empty((0, 3), numpy.int32)
        self.moves_mm = self.mean_per_mm = numpy.empty(0)
        self.principal_per_mm = self.parameters = numpy.empty((0, 2))
        self.first_nodes = numpy.zeros(1, int)
        self.faults = []
        self._areas = None

    @classmethod
    def of(cls, mesh):
        """Return what is drawn of a DisplayMesh of the kernel."""
        shown = cls()
        shown.points, shown.normals, shown.triangles = mesh.points, mesh.normals, mesh.triangles
        shown.first_nodes = numpy.asarray(mesh.first_nodes, int)
        shown.principal_per_mm, shown.parameters = mesh.principal_curvatures, mesh.parameters
        shown.moves_mm, shown.mean_per_mm, shown.faults = (
            mesh.moves_mm,
            mesh.mean_curvature,
            mesh.faults,
        )
        return shown

    def turn(self, signs):
        """Reverse the normals of the faces with sign -1.

        This also reverses the signs of their curvatures.
        """
        each = numpy.repeat(signs, numpy.diff(self.first_nodes))
        self.normals, self.mean_per_mm = self.normals * each[:, None], self.mean_per_mm * each
        if len(self.principal_per_mm):
            turned = -self.principal_per_mm[:, ::-1]
            self.principal_per_mm = numpy.where(each[:, None] < 0, turned, self.principal_per_mm)

    def placed(self, placement):
        """Return the same mesh at a placement; ``unplaced`` of the result is this one."""
        found = ShownMesh()
        found.__dict__.update(self.__dict__, unplaced=self)
        matrix = numpy.array(placement.Matrix.A).reshape(4, 4)
        found.points = self.points @ matrix[:3, :3].T + matrix[:3, 3]
        found.normals = self.normals @ matrix[:3, :3].T
        return found

    @property
    def areas(self):
        """The area of each point: a third of that of the triangles around it."""
        if self._areas is None:
            self._areas = curvature.areas(self.points, self.triangles)
        return self._areas

    @property
    def largest_mm(self):
        """The largest move of a point."""
        return float(self.moves_mm.max(initial=0.0))


def display_mesh(shape, progress=None):
    """Return the ShownMesh of all faces of a Part.Shape, which stays unchanged.

    ``progress`` is a callable(fraction) that returns False to stop; then the result is None. Raises
    KernelUnavailable when the compiled part is missing.
    """
    module = kernel.load(Part.OCC_VERSION)
    if shape.isNull() or not shape.Faces:
        return ShownMesh()
    try:
        return ShownMesh.of(
            module.Model.from_freecad(shape).display_mesh(
                curvatures=False, jobs=preferences.threads(), progress=progress
            )
        )
    except module.Cancelled:
        return None


def fault_lines(label, faults):
    """Return a line for the user for each fault."""
    return [
        tr("{label}: Face{face} is not drawn correctly: {reason}").format(
            label=label, face=fault["face"], reason=fault["reason"]
        )
        for fault in faults
    ]
