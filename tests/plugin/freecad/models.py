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


#: Largest angle of ``two_sheets``, and how far each reaches.
SHEETS_DEG, SHEET_MM = 3.0, 20.0


def sheet(side, slope_deg=0.0, bend=-0.02):
    """A bicubic sheet z = slope |x| + bend x^2 / 2 + g(y), to the left (-1) or right (1) of the plane x = 0."""
    slope = math.tan(math.radians(slope_deg))
    heights = [0, slope / 3, 2 * slope / 3 + bend * SHEET_MM / 6, slope + bend * SHEET_MM / 2]
    across = [0, 4, 4, -1]
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for i in range(4):
        for j in range(4):
            z = SHEET_MM * heights[i] + across[j]
            surface.setPole(i + 1, j + 1, App.Vector(side * SHEET_MM * i / 3, 10 * j - 15, z))
    return surface.toShape()


def two_sheets():
    """Two sheets that meet at x = 0 with an angle of ``SHEETS_DEG`` where g is level, and less elsewhere."""
    return [sheet(-1), sheet(1, slope_deg=SHEETS_DEG)]


def point(x, y, z):
    """A vertex."""
    return Part.Vertex(x, y, z)


def add(doc, shape, name):
    """A document object that holds the shape."""
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj
