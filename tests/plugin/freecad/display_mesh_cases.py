# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles with true normals, on FreeCAD's console; run by run_freecad.py."""

import math
import unittest

import FreeCAD as App
import models
import Part

from freecad.seamwright.document.display_mesh import display_mesh, fault_lines


def area(found):
    """Area of all triangles, those against their normals counted as negative."""
    total = 0.0
    for triangle in found.triangles:
        a, b, c = (App.Vector(*found.points[place]) for place in triangle)
        normal = App.Vector(*found.normals[triangle].sum(axis=0))
        across = (b - a).cross(c - a)
        total += math.copysign(across.Length / 2, across.dot(normal))
    return total


class DisplayMesh(unittest.TestCase):
    def test_triangles_cover_the_faces_where_they_are(self):
        block = Part.makeBox(40, 30, 20)
        block = block.makeFillet(4, block.Edges)
        block.Placement = App.Placement(
            App.Vector(100, 2, 3), App.Rotation(App.Vector(1, 1, 1), 33)
        )
        shapes = {
            "block": block,
            "pierced": Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 20, App.Vector(5, 5, -5))),
            "sheet": models.sheet(1, 3.0),
            "reversed": models.sheet(1, 3.0).reversed(),
        }
        for name, shape in shapes.items():
            with self.subTest(name):
                found = display_mesh(shape)
                self.assertEqual(found.faults, [])
                self.assertAlmostEqual(area(found) / shape.Area, 1.0, delta=5e-3)
                box = shape.BoundBox
                box.enlarge(1e-6)
                self.assertTrue(all(box.isInside(App.Vector(*point)) for point in found.points))

    def test_a_break_between_faces_stays(self):
        found = display_mesh(Part.Compound(models.two_sheets()))
        at = [
            place
            for place, point in enumerate(found.points)
            if math.dist(point, (0, -15, 0)) < 1e-9
        ]
        one, other = (App.Vector(*found.normals[place]) for place in at)
        self.assertGreater(math.degrees(math.asin(one.cross(other).Length)), 0.5)

    def test_the_shape_keeps_its_own_triangles(self):
        sheet = models.sheet(1)
        display_mesh(sheet)
        with self.assertRaises(RuntimeError):
            sheet.getUVNodes()

    def test_a_face_without_triangles_is_told_by_number(self):
        corners = [(0, 0, 0), (10, 10, 0), (10, 0, 0), (0, 10, 0), (0, 0, 0)]
        crossed = Part.Face(
            Part.Plane(), Part.makePolygon([App.Vector(*corner) for corner in corners])
        )
        found = display_mesh(Part.Compound([Part.makePlane(5, 5, App.Vector(0, 0, 3)), crossed]))
        self.assertAlmostEqual(area(found), 25.0, delta=1e-9)
        (line,) = fault_lines("Sheet", found.faults)
        self.assertIn("Sheet: Face2 ", line)

    def test_nothing_to_draw_and_stopping(self):
        for shape in (Part.Shape(), Part.makeLine((0, 0, 0), (1, 0, 0))):
            self.assertEqual(len(display_mesh(shape).triangles), 0)
        self.assertIsNone(display_mesh(Part.makeBox(1, 1, 1), lambda part: False))
