# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles with true normals, on FreeCAD's console; run by run_freecad.py."""

import math
import unittest

import FreeCAD as App
import models
import Part

from freecad.seamwright.document.facets import BEND, facets


def corners(found, triangle):
    """The three corners of a triangle and their mean normal."""
    points = [App.Vector(*found.points[place]) for place in triangle]
    normals = [App.Vector(*found.normals[place]) for place in triangle]
    return points, sum(normals, App.Vector()) * (1 / 3)


def area(found):
    """Area of all triangles, those against their normals counted as negative."""
    total = 0.0
    for triangle in found.triangles:
        (a, b, c), normal = corners(found, triangle)
        across = (b - a).cross(c - a)
        total += math.copysign(across.Length / 2, across.dot(normal))
    return total


def rotated(shape):
    """The shape somewhere else, turned."""
    shape.Placement = App.Placement(App.Vector(100, 2, 3), App.Rotation(App.Vector(1, 1, 1), 33))
    return shape


class Facets(unittest.TestCase):
    def test_normals_of_known_surfaces(self):
        ball, tube = Part.makeSphere(5), Part.makeCylinder(5, 10).Faces[0]
        for shape, axis in ((ball, (1, 1, 1)), (tube, (1, 1, 0))):
            found = facets(shape)
            for point, normal in zip(found.points, found.normals):
                outward = App.Vector(*(a * b for a, b in zip(point, axis))) * (1 / 5)
                self.assertLess((App.Vector(*normal) - outward).Length, 1e-6)

    def test_triangles_cover_the_faces_and_look_outward(self):
        block = Part.makeBox(40, 30, 20)
        shapes = {
            "block": rotated(block.makeFillet(4, block.Edges)),
            "torus": Part.makeTorus(10, 3),
            "cone": Part.makeCone(5, 0, 8),
            "pierced": Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 20, App.Vector(5, 5, -5))),
            "sheet": models.sheet(1, 3.0),
            "reversed": models.sheet(1, 3.0).reversed(),
        }
        for name, shape in shapes.items():
            with self.subTest(name):
                self.assertAlmostEqual(area(facets(shape)) / shape.Area, 1.0, delta=2e-3)

    def test_normals_between_corners_are_nearly_those_of_the_surface(self):
        sheet = models.sheet(1, 3.0, bend=-0.04)
        found, surface, worst = facets(sheet), sheet.Surface, 0.0
        for triangle in found.triangles[::7]:
            points, mean = corners(found, triangle)
            middle = (points[0] + points[1] + points[2]) * (1 / 3)
            true = surface.normal(*surface.parameter(middle))
            worst = max(worst, math.acos(min(1.0, abs(true.dot(mean.normalize())))))
        self.assertLess(worst, 2 * BEND)

    def test_a_break_between_faces_stays(self):
        pair = Part.Compound(models.two_sheets())
        found = facets(pair)
        at = [place for place, point in enumerate(found.points) if math.dist(point, (0, -15, 0)) < 1e-6]
        angle = App.Vector(*found.normals[at[0]]).getAngle(App.Vector(*found.normals[at[1]]))
        sine = abs(math.sin(angle))
        self.assertEqual(len(at), 2)
        self.assertGreater(math.degrees(math.asin(sine)), 0.5)

    def test_triangles_have_no_gaps_inside_a_face(self):
        found = facets(models.sheet(1, 3.0))
        edges = {}
        for a, b, c in found.triangles:
            for one, other in ((a, b), (b, c), (c, a)):
                edges.setdefault(frozenset((one, other)), []).append((one, other))
        for pair, uses in edges.items():
            if len(uses) == 1:  # on the boundary of the sheet
                x, y = ([found.points[place][axis] for place in pair] for axis in (0, 1))
                self.assertTrue(
                    x[0] == x[1] == 0 or x[0] == x[1] == models.SHEET_MM or abs(y[0]) == abs(y[1]) == 15, (x, y)
                )
            else:
                self.assertEqual(uses[0], uses[1][::-1])

    def test_the_shape_keeps_its_own_triangles(self):
        sheet = models.sheet(1)
        with self.assertRaises(RuntimeError):
            sheet.getUVNodes()
        facets(sheet)
        with self.assertRaises(RuntimeError):
            sheet.getUVNodes()

    def test_nothing_to_draw_and_stopping(self):
        for shape in (Part.Shape(), Part.makeLine((0, 0, 0), (1, 0, 0))):
            self.assertEqual(facets(shape).triangles, [])
        self.assertIsNone(facets(Part.makeBox(1, 1, 1), lambda part: False))
        seen = []
        facets(Part.makeBox(1, 1, 1), seen.append)
        self.assertEqual((len(seen), seen), (6, sorted(seen)))
