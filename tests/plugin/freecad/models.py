# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models made by FreeCAD itself, for the tests inside FreeCAD."""

import math

import FreeCAD as App
import Part

#: Angle of the one seam of ``three_classes`` that is neither smooth nor a crease.
KINK_DEG = 1.0


def three_classes():
    """A prism with one kink of 1 degree (a defect), one rounded corner (smooth) and creases.

    Its 18 seams: the kink, 2 at the rounding, and 15 creases.
    """
    rise = 10 * math.tan(math.radians(KINK_DEG))
    outline = [(0, 0), (10, 0), (20, -rise), (20, 20), (0, 20), (0, 0)]
    face = Part.Face(Part.makePolygon([App.Vector(x, y, 0) for x, y in outline]))
    prism = face.extrude(App.Vector(0, 0, 10))
    corner = [
        edge
        for edge in prism.Edges
        if all(abs(vertex.X - 20) + abs(vertex.Y - 20) < 1e-6 for vertex in edge.Vertexes)
    ]
    return prism.makeFillet(3.0, corner)


def point(x, y, z):
    """A vertex."""
    return Part.Vertex(x, y, z)


def add(doc, shape, name):
    """A document object that holds the shape."""
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj
