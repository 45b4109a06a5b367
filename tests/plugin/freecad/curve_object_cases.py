# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves as document objects, on FreeCAD's console; run by run_freecad.py."""

import os
import tempfile

import Draft
import FreeCAD as App
import Mesh
import models
import Part
import Sketcher
from curve_cases import RING, WAVE, area_inside, vertices, wavy
from document_cases import ABSENT, DocumentCase

from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.curves import kinds as curves
from freecad.seamwright.document.sources import SourceError


class Inputs(DocumentCase):
    def refused(self, kind, chosen, text):
        before = [obj.Name for obj in self.doc.Objects]
        with self.assertRaisesRegex((ValueError, SourceError), text):
            curve.suggested(curves.KINDS[kind], chosen)
        self.assertEqual([obj.Name for obj in self.doc.Objects], before)

    def test_what_is_not_usable_is_refused_with_one_sentence(self):
        mesh = self.doc.addObject("Mesh::Feature", "Scan")
        mesh.Mesh = Mesh.createBox(1, 1, 1)
        box = self.doc.addObject("Part::Box", "Box")
        twisted = [(0, 0, 0), (10, 0, 0), (10, 10, 3), (0, 10, 0)]
        twisted = models.add(self.doc, Part.Compound(vertices(twisted)), "Twisted")
        double = models.add(self.doc, Part.Compound(vertices([WAVE[0], *WAVE])), "Double")
        point = models.add(self.doc, Part.Vertex(1, 2, 3), "Point")
        self.doc.recompute()
        self.refused("Spline", [], "nothing is selected: select points, edges, a wire or a sketch")
        self.refused("Spline", [mesh], "Scan is a mesh: choose points, edges, wires or sketches")
        self.refused("Arcs", [box], "Box has 6 faces: choose some of its edges, or one face")
        self.refused("Arcs", [twisted], r"not in one plane: they are up to 0\.\d+ mm off it")
        self.refused("Spline", [double], r"points 1 and 2 are the same, \(0, 0, 0\)")
        self.refused("Spline", [point], "there is only one point: choose two or more")
        self.refused("Spline", [(box, "Edge1"), point], "points and edges are chosen")
        self.refused("Spline", [(box, ["Edge1", "Edge7"])], "2 separate curves")
        self.refused("Spline", [(box, "Edge99")], "Box has no Edge99")
        self.refused("BridgeCurve", [(box, ["Edge1", "Edge2", "Edge3"])], "3 edges chosen")
        with self.assertRaisesRegex(TypeError, "unknown option 'radius'"):
            curves.create("Arcs", [(box, "Face1")], radius=3)
        with self.assertRaisesRegex(ValueError, "tolerance_mm = -1"):
            curves.create("Arcs", [(box, "Face1")], tolerance_mm=-1)

    def test_sketches_draft_wires_faces_and_bodies(self):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(App.Vector(0, 0, 0), App.Vector(10, 0, 0)))
        sketch.addGeometry(Part.LineSegment(App.Vector(10, 0, 0), App.Vector(10, 10, 0)))
        sketch.addConstraint(Sketcher.Constraint("Coincident", 0, 2, 1, 1))
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.addObject(sketch)
        body.Placement.Base = App.Vector(0, 0, 7)
        dots = self.doc.addObject("Sketcher::SketchObject", "Dots")
        for point in WAVE:
            dots.addGeometry(Part.Point(App.Vector(*point)))
        bezier = Part.BezierCurve()
        bezier.setPoles([App.Vector(*point) for point in WAVE[:4]])
        bezier = models.add(self.doc, bezier.toShape(0.2, 0.7), "Bezier")
        wire = Draft.make_wire([App.Vector(*point) for point in WAVE], closed=True)
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        in_body = curves.create("Spline", sketch)
        self.assertTrue(in_body.Summary.startswith("Through 3 points, "))
        self.assertAlmostEqual(in_body.Shape.BoundBox.ZMin, 7, delta=1e-9)
        closed = curves.create("Spline", wire)
        self.assertTrue(closed.Shape.isClosed())
        face = curves.create("Arcs", [(box, "Face1")])
        self.assertEqual((face.Lines, face.Shape.isClosed()), (4, True))
        self.assertTrue(curves.create("Spline", dots).Summary.startswith("Through 5 points, "))
        near = curves.create("Arcs", bezier)
        self.assertLess(abs(near.Shape.Length - bezier.Shape.Length), 0.01)
        picked = curves.create("Spline", [(box, "Vertex1"), (wire, "Vertex2"), (box, "Vertex8")])
        self.assertAlmostEqual(
            (picked.Shape.Vertexes[0].Point - box.Shape.Vertexes[0].Point).Length, 0, delta=1e-9
        )


class Objects(DocumentCase):
    def source(self):
        return models.add(self.doc, Part.Compound(vertices(WAVE)), "Points")

    def test_a_bridge_with_one_order_for_both_ends_gets_two(self):
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(10, 0, 0)), "Line")
        other = Part.makeLine(App.Vector(20, 5, 0), App.Vector(30, 5, 0))
        obj = curves.create("BridgeCurve", [line, models.add(self.doc, other, "Other")])
        for name in ("FirstOrder", "SecondOrder"):
            obj.removeProperty(name)
        obj.addProperty("App::PropertyEnumeration", "Order")
        obj.Order = ["G1", "G2", "G3"]
        obj.Order = "G3"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
        obj = self.doc.getObject("BridgeCurve")
        self.assertNotIn("Order", obj.PropertiesList)
        self.assertEqual((obj.FirstOrder, obj.SecondOrder), ("G3", "G3"))
        obj.SecondOrder = "G0"
        self.doc.recompute()
        self.assertEqual(obj.Shape.Edges[0].Curve.Degree, 4)

    def test_each_kind_follows_its_source_and_is_one_step(self):
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(10, 0, 0)), "Line")
        other = models.add(
            self.doc, Part.makeLine(App.Vector(20, 5, 0), App.Vector(30, 5, 0)), "Other"
        )
        edge = models.add(self.doc, wavy(), "Wavy")
        chosen = {
            "BlendCurves": [line, other],
            "BridgeCurve": [line, other],
            "JoinCurves": [line, other],
            "FairCurve": [edge],
            **{
                kind: [(self.source(), ["Vertex1", "Vertex2", "Vertex3"])]
                for kind in ("Conic", "LogSpiral")
            },
        }
        for kind in curves.KINDS:
            with self.subTest(kind):
                sources = chosen.get(kind, [self.source()])
                before = self.doc.Objects
                self.assertOneStep(lambda: curves.create(kind, sources), before)
                obj = self.doc.Objects[-1]
                self.assertEqual((curves.error_text(obj), obj.Outcome), ("", "done"))
                self.assertTrue(obj.Shape.isValid() and obj.Summary)
                height = obj.Shape.BoundBox.ZMax
                self.lift(obj, 4)
                self.doc.recompute()
                self.assertNotIn("Invalid", obj.State)
                self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, height + 4, delta=1e-6)
                self.lift(obj, -4)

    def lift(self, obj, height):
        for source in obj.Proxy.source_objects(obj):
            shape = source.Shape.copy()
            shape.translate(App.Vector(0, 0, height))
            source.Shape = shape

    def test_a_source_that_is_moved_is_followed(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = curves.create("Spline", [(box, ["Vertex1", "Vertex3", "Vertex8"])])
        before = [vertex.Point for vertex in obj.Shape.Vertexes]
        box.Placement.Base = App.Vector(1, 2, 3)
        self.doc.recompute()
        for old, new in zip(before, (vertex.Point for vertex in obj.Shape.Vertexes)):
            self.assertLess((new - old - App.Vector(1, 2, 3)).Length, 1e-9)
        box.Length = 30
        self.doc.recompute()
        self.assertAlmostEqual(obj.Shape.BoundBox.XMax, 31, delta=1e-6)

    def test_a_change_of_an_option_and_an_expression(self):
        obj = curves.create("Arcs", [self.source()], tolerance_mm=0.01)
        many = obj.Arcs
        obj.Tolerance = "0.5 mm"
        self.doc.recompute()
        self.assertLess(obj.Arcs, many)
        obj.setExpression("Tolerance", "2 * 5 um")
        self.doc.recompute()
        self.assertAlmostEqual(obj.Tolerance.Value, 0.01, delta=1e-12)
        self.assertEqual(obj.Arcs, many)

    def test_a_bad_value_leaves_no_shape_and_says_why(self):
        obj = curves.create("Spline", [self.source()])
        obj.Tension = [1.0, 2.0]
        self.doc.recompute()
        self.assertWithout(obj, "Not made: Tension has 2 numbers for 5 points")
        self.assertTrue(obj.Shape.isNull())
        obj.Tension = [0.0]
        self.doc.recompute()
        self.assertEqual((curves.error_text(obj), obj.Shape.isNull()), ("", False))

    def test_a_deleted_source_is_an_error(self):
        obj = curves.create("Spline", [self.source()])
        self.doc.removeObject("Points")
        obj.touch()
        self.doc.recompute()
        self.assertFailed(obj, "the sources were deleted")
        self.assertTrue(obj.Shape.isNull())

    def test_saved_curves_open_without_the_compiled_part(self):
        for kind in ("Spline", "Arcs", "Clothoid"):
            with self.subTest(kind):
                obj = curves.create(kind, [self.source()])
                names = ("Summary", "Report", "SeamwrightVersion")
                with self.opened_without_kernel(
                    obj, names, lambda: curves.create(kind, self.doc.Objects[:1])
                ) as again:
                    self.assertTrue(again.Shape.isValid())
                    self.assertEqual(len(again.Shape.Wires), 1)

    def test_a_reopened_curve_follows_its_source(self):
        obj = curves.create("Arcs", [self.source()])
        name, edges = obj.Name, obj.Shape.Length
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with ABSENT:
                self.doc = App.openDocument(path)
        again = self.doc.getObject(name)
        self.assertTrue(curve.is_curve(again))
        self.assertNotIn("Touched", again.State)
        self.doc.Points.Shape = Part.Compound(vertices([(2 * x, 2 * y, z) for x, y, z in WAVE]))
        self.doc.recompute()
        self.assertAlmostEqual(again.Shape.Length, 2 * edges, delta=0.1)

    def test_a_closed_curve_can_be_padded_swept_and_lofted(self):
        ring = models.add(self.doc, Part.Compound(vertices(RING)), "Ring")
        obj = curves.create("Spline", ring, closed=True)
        body = self.doc.addObject("PartDesign::Body", "Body")
        pad = body.newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = obj, 5
        binder = body.newObject("PartDesign::SubShapeBinder", "Binder")
        binder.Support = [(obj, ("",))]
        self.doc.recompute()
        bound = body.newObject("PartDesign::Pad", "Bound")
        bound.Profile, bound.Length = (binder, ["Face1"]), 5
        self.doc.recompute()
        area = area_inside(obj.Shape)
        for each in (pad, bound):
            self.assertTrue(each.Shape.isValid())
            self.assertAlmostEqual(each.Shape.Volume, 5 * area, delta=0.02 * area)
        extrusion = self.doc.addObject("Part::Extrusion", "Extrusion")
        extrusion.Base, extrusion.Solid, extrusion.LengthFwd = obj, True, 5
        extrusion.DirMode = "Normal"
        self.doc.recompute()
        self.assertAlmostEqual(extrusion.Shape.Volume, 5 * area, delta=0.02 * area)
        profile = models.add(
            self.doc,
            Part.Wire(Part.makeCircle(0.5, App.Vector(*WAVE[0]), App.Vector(1, 2, 0))),
            "Profile",
        )
        spine = curves.create("Clothoid", [self.source()])
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections = [profile]
        sweep.Spine = (spine, [])
        loft = self.doc.addObject("Part::Loft", "Loft")
        other = models.add(self.doc, Part.Wire(Part.makeCircle(3, App.Vector(20, 10, 30))), "Top")
        loft.Sections, loft.Solid = [obj, other], True
        self.doc.recompute()
        self.assertTrue(sweep.Shape.Faces)
        self.assertGreater(loft.Shape.Volume, 100)
