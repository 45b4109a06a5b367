# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mean curvature on triangles, beside what FreeCAD says of it, on FreeCAD's console; run by
run_freecad.py."""

import math
import unittest

import FreeCAD as App
import models
import numpy
import Part

from freecad.seamwright.document.curvature_map import align, curvature_map_later
from freecad.seamwright.plain import curvature


def curvature_map(shape, progress=None):
    return curvature_map_later(shape)(progress)


def inside(mesh, shape):
    """The curvatures at points that lie within the faces of a shape, not at their edges, beside
    those of FreeCAD.

    FreeCAD's follow the surface, and the face may be turned over: they are compared without their
    signs.
    """
    pairs = []
    for point, found in list(zip(mesh.points, mesh.mean_per_mm))[::7]:
        vertex = Part.Vertex(App.Vector(*point))
        face = min(shape.Faces, key=vertex.distToShape)
        if face.distToShape(vertex)[0] > 1e-7 or face.OuterWire.distToShape(vertex)[0] < 1e-3:
            continue
        u, v = face.Surface.parameter(App.Vector(*point))
        pairs.append((abs(found), abs(sum(face.curvatureAt(u, v)) / 2)))
    return pairs


class CurvatureMaps(unittest.TestCase):
    def assert_everywhere(self, shape, expected):
        found = curvature_map(shape).mean_per_mm
        self.assertGreater(len(found), 3)
        self.assertTrue(
            numpy.allclose(found, expected, rtol=1e-9, atol=1e-12), (found.min(), found.max())
        )

    def test_balls_pipes_and_planes(self):
        self.assert_everywhere(Part.makeSphere(25), -1 / 25)
        pipe = Part.makeCylinder(20, 50).Faces[0]
        self.assert_everywhere(pipe, -1 / 40)
        self.assert_everywhere(pipe.toNurbs(), -1 / 40)
        self.assert_everywhere(pipe.reversed(), 1 / 40)
        self.assert_everywhere(Part.makePlane(10, 10), 0.0)

    def test_a_hole_is_hollow(self):
        block = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 20, App.Vector(5, 5, -5)))
        found = curvature_map(block).mean_per_mm
        self.assertAlmostEqual(found.max(), 1 / 6, delta=1e-12)
        self.assertAlmostEqual(found.min(), 0.0, delta=1e-12)

    def test_it_is_as_freecad_says(self):
        shapes = {
            "sheet": models.sheet(1, 3.0),
            "panel": models.broken_panel(),
            "torus": Part.makeTorus(20, 5),
        }
        for name, shape in shapes.items():
            with self.subTest(name):
                pairs = inside(curvature_map(shape), shape)
                self.assertGreater(len(pairs), 20)
                for found, expected in pairs:
                    self.assertAlmostEqual(found, expected, delta=1e-6 * max(1.0, expected))

    def test_closed_faces_have_all_their_triangles(self):
        closed = (
            Part.makeTorus(20, 5),
            Part.makeCone(5, 2, 30),
            Part.makeCylinder(20, 50).Faces[0].toNurbs(),
        )
        for shape in closed:
            mesh = curvature_map(shape)
            self.assertEqual(mesh.faults, [])
            self.assertAlmostEqual(
                curvature.areas(mesh.points, mesh.triangles).sum() / shape.Area, 1.0, delta=0.01
            )

    def test_it_stays_with_place_and_turn(self):
        sheet = models.sheet(1, 3.0)
        here = curvature_map(sheet)
        sheet.Placement = App.Placement(
            App.Vector(10, 20, 30), App.Rotation(App.Vector(1, 2, 3), 50)
        )
        there = curvature_map(sheet)
        for end in (numpy.min, numpy.max):  # the triangles are not quite the same
            self.assertAlmostEqual(end(here.mean_per_mm), end(there.mean_per_mm), delta=1e-4)

    def test_triangles_are_small_where_the_curvature_varies(self):
        sheet = models.sheet(1, 3.0)
        mesh = curvature_map(sheet)
        corners = mesh.points[mesh.triangles]
        longest = max(
            numpy.linalg.norm(corners[:, k] - corners[:, k - 1], axis=1).max() for k in range(3)
        )
        self.assertLess(longest, 0.07 * sheet.BoundBox.DiagonalLength)
        self.assertEqual(len(curvature_map(Part.makeBox(1, 2, 3)).triangles), 12)

    def test_triangles_of_small_faces_are_fewer(self):
        small = models.sheet(1, 3.0)
        far = Part.Compound([small, Part.makePlane(5, 5, App.Vector(1000, 0, 0))])
        self.assertLess(len(curvature_map(far).triangles), len(curvature_map(small).triangles))

    def test_the_tip_of_a_cone_has_no_value_and_the_range_has(self):
        mesh = curvature_map(Part.makeCone(5, 0, 10))
        limit = curvature.limit(mesh.mean_per_mm, curvature.areas(mesh.points, mesh.triangles))
        self.assertTrue(0 < limit < math.inf)

    def test_loose_faces_have_their_normals_on_one_side(self):
        left, right = models.sheet(-1), models.sheet(1)
        ends = []
        for faces in ([left, right], [left.reversed(), right], [left, right.reversed()]):
            mesh = curvature_map(Part.Compound(faces))
            beside = abs(mesh.points[:, 0]) < 1e-9
            self.assertLess(
                numpy.ptp(mesh.mean_per_mm[beside & (abs(mesh.points[:, 1] + 15) < 1e-9)]), 1e-3
            )
            ends.append((mesh.mean_per_mm.min(), mesh.mean_per_mm.max()))
            other = curvature_map(Part.Compound([face.reversed() for face in faces]))
            align(other, mesh)
            self.assertTrue(
                numpy.allclose(sorted(other.mean_per_mm), sorted(mesh.mean_per_mm), atol=1e-3)
            )
        for low, high in ends[1:]:
            self.assertIn(round(low, 6), [round(value, 6) for value in (ends[0][0], -ends[0][1])])

    def test_a_shell_and_a_solid_keep_their_sides(self):
        wedge = Part.Face(
            Part.makePolygon(
                [App.Vector(*p) for p in ((0, 0, 0), (40, 2, 0), (40, -2, 0), (0, 0, 0))]
            )
        )
        for shape in (
            wedge.extrude(App.Vector(0, 0, 10)),
            models.rounded_block(),
            models.open_block(2),
        ):
            mesh = curvature_map(shape)
            self.assertTrue((mesh.mean_per_mm <= 1e-12).all())
            self.assertTrue(
                ((mesh.points - tuple(shape.BoundBox.Center)) * mesh.normals).sum(axis=1).min() > 0
            )

    def test_it_is_of_the_shape_as_it_was(self):
        doc = App.newDocument("Later")
        obj = models.add(doc, Part.makeSphere(25), "Ball")
        work = curvature_map_later(obj.Shape)
        obj.Shape = Part.makeSphere(10)
        self.assertAlmostEqual(work().mean_per_mm.min(), -1 / 25, delta=1e-12)
        App.closeDocument("Later")

    def test_nothing_to_draw_and_stopping(self):
        for shape in (Part.Shape(), Part.makeLine((0, 0, 0), (1, 0, 0))):
            self.assertEqual(len(curvature_map(shape).triangles), 0)
        self.assertIsNone(curvature_map(Part.makeBox(1, 1, 1), lambda part: False))
