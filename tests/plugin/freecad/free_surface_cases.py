# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces made of curves, on FreeCAD's console; run by run_freecad.py."""

import math
import os
import tempfile

import FreeCAD as App
import models
import numpy
import Part
from document_cases import ABSENT, DocumentCase

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.surfaces import kinds

V = App.Vector


def spoke(number, count=5, turn_deg=0.0):
    """A Bezier curve from the origin, which is flat there."""
    angle = 2 * math.pi * number / count + math.radians(turn_deg)
    curve = Part.BezierCurve()
    curve.setPoles(
        [
            V(along * math.cos(angle), along * math.sin(angle), height)
            for along, height in ((0, 0), (3, 0), (6, -1), (9, -3 - number % 2))
        ]
    )
    return curve.toShape()


def meridian(number, count=3, radius=20.0):
    """An arc on a sphere from its top."""
    angle = 2 * math.pi * number / count

    def at(turn):
        out = radius * math.sin(turn)
        return V(out * math.cos(angle), out * math.sin(angle), radius * (math.cos(turn) - 1))

    return Part.Arc(at(0), at(0.4), at(0.8)).toShape()


def bowl(number, count=5):
    """A Bezier curve from the origin; no surface has the curvatures of five of them there."""
    angle = 2 * math.pi * number / count
    x, y = math.cos(angle), math.sin(angle)
    curve = Part.BezierCurve()
    heights = 0, 0, 1.5 + x, 4 + 2 * x + number % 2
    curve.setPoles([V(along * x, along * y, z) for along, z in zip((0, 3, 6, 9), heights)])
    return curve.toShape()


def rim(number, side, count=5):
    """A Bezier curve from the end of an even spoke to the corner on one side of it."""

    def out(turn, radius, z):
        angle = 2 * math.pi * turn / count
        return V(radius * math.cos(angle), radius * math.sin(angle), z)

    begin, corner = out(number, 9, -3), out(number + side / 2, 12, -4)
    right = V(0, 0, side).cross(out(number, 1, 0))
    curve = Part.BezierCurve()
    curve.setPoles([begin, begin + 2 * right, (begin + 2 * corner) / 3, corner])
    return curve.toShape()


def section(height, bend):
    curve = Part.BSplineCurve()
    places = (0, 0, height), (10, bend, height), (20, 1, height + 2), (30, 4, height)
    curve.interpolate([V(*place) for place in places])
    return curve.toShape()


def angle_along(edge, one, other):
    """The largest angle of the normals of two faces along an edge, in degrees."""
    angles = []
    for at in numpy.linspace(*edge.ParameterRange, 22)[1:-1]:
        point = edge.valueAt(at)
        a, b = (f.Surface.normal(*f.Surface.parameter(point)) for f in (one, other))
        angles.append(math.degrees(math.asin(min(1.0, a.cross(b).Length))))
    return max(angles)


def curvature_along(edge, one, other):
    """The largest difference of Gauss' and of mean curvature of two faces along an edge, by the
    largest of either."""
    gauss, mean = [], []
    for at in numpy.linspace(*edge.ParameterRange, 22)[1:-1]:
        point = edge.valueAt(at)
        both = [f.curvatureAt(*f.Surface.parameter(point)) for f in (one, other)]
        gauss.append([low * high for low, high in both])
        mean.append([abs(low + high) for low, high in both])
    return max(numpy.ptp(each, axis=1).max() / numpy.abs(each).max() for each in (gauss, mean))


def joints(shape):
    """Edges between two faces of a shape: (edge, face, face)."""
    found = []
    for edge in shape.Edges:
        beside = [face for face in shape.Faces if any(each.isSame(edge) for each in face.Edges)]
        if len(beside) == 2:
            found.append((edge, *beside))
    return found


def distance_from(edge, shape, count=30):
    return max(
        Part.Vertex(edge.valueAt(at)).distToShape(shape)[0]
        for at in numpy.linspace(*edge.ParameterRange, count)
    )


class FreeSurfaceCase(DocumentCase):
    def add(self, shapes):
        found = [models.add(self.doc, shape, "Curve") for shape in shapes]
        self.doc.recompute()
        return found

    def assertMade(self, obj, faces):
        self.assertEqual((kinds.error_text(obj), obj.Outcome, obj.Reached), ("", "done", True))
        self.assertEqual((obj.Shape.isValid(), len(obj.Shape.Faces)), (True, faces))


class Umbrellas(FreeSurfaceCase):
    def spokes(self, count=5):
        return self.add([spoke(number, count) for number in range(count)])

    def test_faces_share_the_edges_with_one_tangent_plane(self):
        sources = self.spokes()
        for members, faces, seams in (("Four-sided", 5, 5), ("Three-sided", 15, 25)):
            obj = kinds.create("Umbrella", [sources[k] for k in (0, 3, 1, 4, 2)], members=members)
            self.assertMade(obj, faces)
            found = joints(obj.Shape)
            self.assertEqual(len(found), seams)
            self.assertLess(max(angle_along(*each) for each in found), 1e-4)
            for source in sources:
                self.assertLess(distance_from(source.Shape, obj.Shape), 1e-9)
            named = {seam["name"] for seam in report_of(obj)["seams"] if seam["side"] == "Edge"}
            self.assertEqual(named, {"Edge %d" % number for number in range(1, 6)})

    def test_a_sector_stays_open(self):
        obj = kinds.create("Umbrella", self.spokes(), open=True)
        self.assertMade(obj, 4)
        sources = self.add([spoke(number, 6) for number in range(4)])
        half = kinds.create("Umbrella", sources)
        self.assertTrue(half.Open)
        self.assertMade(half, 3)
        self.assertEqual(len(joints(half.Shape)), 2)

    def test_arcs_become_curves_within_the_tolerance(self):
        arcs = self.add([meridian(number) for number in range(3)])
        obj = kinds.create("Umbrella", arcs)
        self.assertMade(obj, 3)
        for arc in arcs:
            self.assertLess(distance_from(arc.Shape, obj.Shape), 1e-3)
        obj.Fit = 1e-9
        self.doc.recompute()
        self.assertWithout(obj, "Not made: a curve of degree 9 is")

    def test_arcs_stay_arcs(self):
        arcs = self.add([meridian(number, 5) for number in range(5)])
        for members, faces in (("Four-sided", 5), ("Three-sided", 15)):
            obj = kinds.create("Umbrella", arcs, rational=True, members=members, fit_mm=1e-9)
            self.assertMade(obj, faces)
            for arc in arcs:
                self.assertLess(distance_from(arc.Shape, obj.Shape), 1e-7)

    def test_faces_have_one_curvature_along_the_edges(self):
        sources = self.add([bowl(number) for number in range(5)])
        plain = kinds.create("Umbrella", sources)
        self.assertGreater(max(curvature_along(*each) for each in joints(plain.Shape)), 0.1)
        for leave_open, faces in ((False, 5), (True, 4)):
            obj = kinds.create("Umbrella", sources, order="G2", open=leave_open)
            self.assertMade(obj, faces)
            self.assertLess(max(angle_along(*each) for each in joints(obj.Shape)), 1e-4)
            self.assertLess(max(curvature_along(*each) for each in joints(obj.Shape)), 1e-3)
            self.assertLess(obj.MaxCurvature, 1e-3)
            self.assertRegex(obj.Summary, r"every seam is G2, .* curvature at most .* edge \d most")
            self.assertEqual({seam["target"] for seam in report_of(obj)["seams"]}, {"G2"})
        self.assertEqual(plain.MaxCurvature, 0)
        kept = kinds.create("Umbrella", self.spokes(), order="G2", max_move_mm=1e-9)
        self.assertMade(kept, 5)

    def test_what_faces_with_one_curvature_cannot_have(self):
        sources = self.add([bowl(number) for number in range(5)])
        edge = self.add([rim(0, 1)])
        limited = kinds.create("Umbrella", sources, order="G2", max_move_mm=0.01)
        self.assertWithout(limited, "the curvature of one surface at the point: poles would move")
        self.assertRegex(limited.Summary, r"by 1 mm, edge \d most, and 0.01 mm are allowed")
        three = kinds.create("Umbrella", sources, order="G2", members="Three-sided")
        self.assertWithout(three, "three-sided faces join with G1 only")
        bounded = kinds.create(
            "Umbrella", {"Sources": sources, "Boundary": edge}, order="G2"
        )
        self.assertWithout(bounded, "with G2 the outer boundary is found")
        bounded.Boundary = []
        self.doc.recompute()
        self.assertMade(bounded, 5)

    def test_the_faces_end_at_a_given_outer_boundary(self):
        sources = self.add([spoke(2 * number, 10) for number in range(5)])
        rims = self.add([rim(number, side) for side in (-1, 1) for number in (3, 0, 4, 1, 2)])
        obj = kinds.create("Umbrella", {"Sources": sources, "Boundary": rims})
        self.assertMade(obj, 5)
        self.assertTrue(obj.Summary.endswith("; the outer boundary stays."), obj.Summary)
        for source in [*sources, *rims]:
            self.assertLess(distance_from(source.Shape, obj.Shape), 1e-7)
        self.assertLess(max(angle_along(*each) for each in joints(obj.Shape)), 1e-4)
        rims[0].Placement.Base = V(0, 0, 0.5)
        self.doc.recompute()
        self.assertWithout(obj, "of the outer boundary does not lead from the end of an edge")
        self.assertIn("it ends 0.5 mm from the nearest end", obj.Summary)
        self.doc.removeObject(rims[0].Name)
        self.doc.recompute()
        self.assertFailed(obj, "in the panel, or select nothing")

    def test_an_edge_that_no_single_curve_follows_is_named(self):
        def wavy(edge):
            curve, turn = Part.BSplineCurve(), V(0, 0, 1)
            points = edge.discretize(9)
            curve.interpolate([p + (k % 2) * turn for k, p in enumerate(points)])
            return curve.toShape()

        sources = self.add([spoke(2 * number, 10) for number in range(5)])
        rims = self.add([rim(number, side) for side in (-1, 1) for number in (3, 0, 4, 1, 2)])
        rims[6].Shape = wavy(rims[6].Shape)
        obj = kinds.create("Umbrella", {"Sources": sources, "Boundary": rims})
        self.assertWithout(obj, r" mm from edge 7 of the outer boundary, and 0.001 mm are allowed")
        sources[3].Shape = wavy(sources[3].Shape)
        self.doc.recompute()
        self.assertWithout(obj, r" mm from edge 4, and 0.001 mm are allowed")

    def test_one_outer_edge_makes_a_three_sided_face(self):
        sources = self.add([spoke(2 * number, 10) for number in range(5)])
        tips = [source.Shape.valueAt(source.Shape.LastParameter) for source in sources]
        for end, text in ((2, "edge 1 of the outer boundary leads from edge 1 to edge 3"), (1, "")):
            chord = self.add([Part.makeLine(tips[0], tips[end])])
            obj = kinds.create("Umbrella", {"Sources": sources, "Boundary": chord})
            if text:
                self.assertWithout(obj, text)
        self.assertMade(obj, 7)
        self.assertLess(distance_from(chord[0].Shape, obj.Shape), 1e-7)

    def test_edges_of_one_object_that_meet_in_a_vertex(self):
        obj = kinds.create("Umbrella", self.add([Part.Compound([spoke(k) for k in range(5)])]))
        self.assertMade(obj, 5)

    def test_what_is_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        corner = box.Shape.Vertexes[0]
        at_corner = [
            "Edge%d" % number
            for number, edge in enumerate(box.Shape.Edges, 1)
            if any(vertex.isSame(corner) for vertex in edge.Vertexes)
        ]
        for names, text in (
            (["Edge1", "Edge2"], "2 edges chosen: choose three or more"),
            (["Edge1", "Edge2", "Edge5", "Edge9"], "the 4 edges do not end in one point"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                kinds.create("Umbrella", [(box, names)])
        obj = kinds.create("Umbrella", [(box, at_corner)])
        self.assertWithout(obj, "the tangent of edge ")
        self.assertIn("90\u00b0 out of the plane", obj.Summary)
        self.assertNotIn("rad ", obj.Summary)


def ring(a, b, height, count=12):
    """A closed spline through points of an ellipse."""
    angles = [2 * math.pi * number / count for number in range(count)]
    curve = Part.BSplineCurve()
    curve.interpolate(
        [V(a * math.cos(t), b * math.sin(t), height) for t in angles], PeriodicFlag=True
    )
    return curve.toShape()


class Lofts(FreeSurfaceCase):
    def sections(self):
        return self.add([section(height, bend) for height, bend in ((0, 5), (15, 8), (40, 3))])

    def test_the_surface_goes_through_the_curves(self):
        sources = self.sections()
        obj = kinds.create("FrameLoft", sources)
        self.assertMade(obj, 1)
        for source in sources:
            self.assertLess(distance_from(source.Shape, obj.Shape), obj.Distance.Value)
        self.assertLessEqual(obj.Distance.Value, 1e-3)
        rows = report_of(obj)["seams"]
        self.assertTrue(rows)
        self.assertTrue(all(row["target"] == "G2" for row in rows))

    def test_it_has_faces_between_corners(self):
        square = Part.makePolygon([V(*p) for p in ((-9, -9), (9, -9), (9, 9), (-9, 9), (-9, -9))])
        circle = Part.makeCircle(5, V(0, 0, 20))
        obj = kinds.create("FrameLoft", self.add([square, circle]))
        self.assertEqual((kinds.error_text(obj), len(obj.Shape.Faces)), ("", 4))

    def test_closed_splines_whose_curvature_jumps_where_they_close(self):
        """OpenCASCADE's periodic interpolation is only C1 at its first point."""
        for radii in ([(30, 20)] * 3, [(30, 20), (25, 15), (20, 10)]):
            curves = [ring(*each, 20 * place) for place, each in enumerate(radii)]
            ends = curves[0].ParameterRange
            jump = abs(curves[0].curvatureAt(ends[0]) - curves[0].curvatureAt(ends[1]))
            self.assertGreater(jump, 1e-3)
            obj = kinds.create("FrameLoft", self.add(curves))
            self.assertMade(obj, 1)
            for curve in curves:
                self.assertLess(distance_from(curve, obj.Shape), 1e-3)
            self.assertTrue(all(row["target"] == "G2" for row in report_of(obj)["seams"]))

    def test_one_curve_is_refused(self):
        with self.assertRaisesRegex(ValueError, "only one curve: choose two or more"):
            kinds.create("FrameLoft", self.sections()[:1])


class Objects(FreeSurfaceCase):
    def made(self):
        yield kinds.create("Umbrella", self.add([spoke(number) for number in range(5)])), 5
        yield kinds.create("FrameLoft", self.add([section(0, 5), section(20, 8)])), 1

    def test_they_follow_their_sources_and_are_one_step(self):
        for obj, faces in self.made():
            sources = obj.Proxy.source_objects(obj)
            top = obj.Shape.BoundBox.ZMax
            for source in sources:
                source.Placement.Base = V(0, 0, 4)
            self.doc.recompute()
            self.assertMade(obj, faces)
            self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, top + 4, delta=1e-6)
            self.doc.removeObject(obj.Name)
            before = self.doc.Objects
            self.assertOneStep(lambda: kinds.create(obj_type(faces), sources), before)

    def test_a_source_that_is_deleted_is_an_error(self):
        for obj, _ in self.made():
            gone = obj.Proxy.source_objects(obj)[1]
            label = gone.Label
            self.doc.removeObject(gone.Name)
            self.doc.recompute()
            self.assertFailed(obj, "%s was deleted: select others and press" % label)
            self.assertTrue(obj.Shape.isNull())
            self.doc.removeObject(obj.Name)

    def test_saved_ones_open_and_follow(self):
        for obj, faces in self.made():
            name, top = obj.Name, obj.Shape.BoundBox.ZMax
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "saved.FCStd")
                self.doc.saveAs(path)
                App.closeDocument(self.doc.Name)
                with ABSENT:
                    self.doc = App.openDocument(path)
            again = self.doc.getObject(name)
            self.assertNotIn("Touched", again.State)
            for source in again.Proxy.source_objects(again):
                source.Placement.Base = V(0, 0, 7)
            self.doc.recompute()
            self.assertMade(again, faces)
            self.assertAlmostEqual(again.Shape.BoundBox.ZMax, top + 7, delta=1e-6)
            App.closeDocument(self.doc.Name)
            self.doc = App.newDocument("Again")

    def test_other_objects_use_them(self):
        for obj, _ in self.made():
            thick = self.doc.addObject("Part::Extrusion", "Thick")
            thick.Base, thick.LengthFwd, thick.Dir = obj, 5, V(0, 0, 5)
            thick.DirMode, thick.Solid = "Custom", False
            self.doc.recompute()
            self.assertTrue(thick.Shape.Faces)
            self.assertNotIn("Invalid", thick.State)


def obj_type(faces):
    return "Umbrella" if faces == 5 else "FrameLoft"
