# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces beside faces, on FreeCAD's console; run by run_freecad.py."""

import itertools
import math
import os
import tempfile

import FreeCAD as App
import Mesh
import models
import numpy
import Part
from curve_cases import slot
from document_cases import ABSENT, DocumentCase

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.sources import SourceError
from freecad.seamwright.document.surfaces import kinds
from freecad.seamwright.document.surfaces.chain import tangent_chain


def sheet(x, z, tilt):
    """A bicubic sheet of 30 by 40 mm that begins at x."""
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for i, j in itertools.product(range(4), range(4)):
        u, v = 10 * i, 40 * j / 3
        height = z + tilt * u + 0.002 * (u - 15) ** 2 + 0.003 * (v - 10) ** 2
        surface.setPole(i + 1, j + 1, App.Vector(x + u, v, height))
    return surface.toShape()


def halved(surface):
    """The two faces of a surface before and after the middle of its second parameter."""
    return [surface.toShape(0, 1, low, low + 0.5) for low in (0, 0.5)]


def stadium():
    """A plane face with two straight and two round edges, which are tangent."""
    return Part.Face(slot())


def edge_where(obj, test):
    """The name of the one edge of an object all of whose points pass a test."""
    (name,) = [
        "Edge%d" % number
        for number, edge in enumerate(obj.Shape.Edges, 1)
        if all(test(point) for point in edge.discretize(5))
    ]
    return name


def at_x(obj, x):
    return edge_where(obj, lambda point: abs(point.x - x) < 1e-6)


def largest_x(shape):
    return max(point.x for edge in shape.Edges for point in edge.discretize(40))


def differences(edge, face, other, count=20):
    """The largest angle of the normals of two faces along an edge, in degrees, and the largest
    difference of their mean curvatures, up to the sense of the normals."""
    angles, curvatures = [], []
    for at in numpy.linspace(*edge.ParameterRange, count)[1:-1]:
        figures = []
        for each in (face, other):
            place = each.Surface.parameter(edge.valueAt(at))
            figures.append((each.Surface.normal(*place), each.Surface.curvature(*place, "Mean")))
        (n1, h1), (n2, h2) = figures
        sense = 1 if n1.dot(n2) > 0 else -1
        angles.append(math.degrees(math.asin(min(1.0, n1.cross(n2).Length))))
        curvatures.append(abs(h1 - sense * h2))
    return max(angles), max(curvatures)


class SurfaceCase(DocumentCase):
    def sheets(self):
        low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        return low, high

    def blend(self, **given):
        low, high = self.sheets()
        chosen = [(low, at_x(low, 30)), (high, at_x(high, 60))]
        return kinds.create("BlendSurface", chosen, **given)

    def edge(self, obj, name):
        return obj.Shape.Edges[int(name[4:]) - 1]

    def assertMade(self, obj, reached=True):
        self.assertEqual((kinds.error_text(obj), obj.Outcome), ("", "done"))
        self.assertEqual((obj.Shape.ShapeType, obj.Shape.isValid()), ("Face", True))
        self.assertEqual((obj.Reached, "Every seam has its level" in obj.Summary), (reached,) * 2)

    def refused(self, kind, chosen, text):
        before = self.doc.Objects
        with self.assertRaisesRegex((ValueError, SourceError), text):
            kinds.create(kind, chosen)
        self.assertEqual(self.doc.Objects, before)


class Blends(SurfaceCase):
    def test_each_order_is_what_freecad_measures(self):
        limits = {"G0": (90, 1), "G1": (0.1, 1), "G2": (0.1, 1e-4), "G3": (0.1, 1e-4)}
        for order, (angle, curvature) in limits.items():
            with self.subTest(order):
                obj = self.blend(start_order=order, end_order="G2")
                self.assertMade(obj)
                low, high = obj.Start[0][0], obj.End[0][0]
                start = self.edge(low, obj.Start[0][1][0]), low
                end = self.edge(high, obj.End[0][1][0]), high
                found = [
                    differences(edge, each.Shape.Faces[0], obj.Shape) for edge, each in (start, end)
                ]
                self.assertLess(found[0][0], angle)
                self.assertLess(found[0][1], curvature)
                self.assertLess(found[1][0], 0.1)
                self.assertLess(found[1][1], 1e-4)
                if order == "G0":
                    self.assertGreater(found[0][0], 1)
                if order == "G1":
                    self.assertGreater(found[0][1], 1e-4)
                seams = report_of(obj)["seams"]
                self.assertEqual([seam["target"] for seam in seams], [order, "G2"])
                self.assertLess(obj.MaxAngle.Value, 0.1)
                handles = {"end_tension"} if order == "G0" else {"start_tension", "end_tension"}
                self.assertEqual(set(obj.Proxy.handles(report_of(obj))), handles)

    def test_tension_and_flip_change_the_surface(self):
        obj = self.blend()
        area = obj.Shape.Area
        obj.StartTension = 2
        self.doc.recompute()
        self.assertMade(obj)
        self.assertGreater(abs(obj.Shape.Area - area), 0.5)
        obj.StartTension, obj.Flip = 1, True
        self.doc.recompute()
        self.assertGreater(abs(obj.Shape.Area - area), 0.5)
        obj.setExpression("EndTension", "4 / 2")
        self.doc.recompute()
        self.assertEqual(obj.EndTension, 2)
        obj.StartTension = 0
        self.doc.recompute()
        self.assertWithout(obj, "start_tension = 0.0: at least 0.001")
        self.assertTrue(obj.Shape.isNull())

    def test_four_edges_of_a_hole_are_sides_and_lateral_boundaries(self):
        shell = models.add(self.doc, models.around_a_hole(), "Shell")
        self.doc.recompute()
        inside = [
            "Edge%d" % number
            for number, edge in enumerate(shell.Shape.Edges, 1)
            if all(19.9 < c < 40.1 for p in edge.discretize(3) for c in (p.x, p.y))
        ]
        obj = kinds.create("BlendSurface", [(shell, inside)], lateral_order="G1", angle_deg=0.01)
        self.assertEqual(len(obj.Lateral[0][1]), 2)
        self.assertMade(obj)
        self.assertEqual(len(report_of(obj)["seams"]), 4)
        middle = obj.Shape.Surface.value(0.37, 0.61)
        self.assertAlmostEqual(middle.z, models.height(middle.x, middle.y), delta=0.01)
        area, obj.Flip = obj.Shape.Area, True
        self.doc.recompute()
        self.assertMade(obj)
        self.assertAlmostEqual(obj.Shape.Area, area, delta=1e-9)
        obj.Flip = False
        obj.Lateral = [(shell, inside[0]), (shell, inside[0])]
        self.doc.recompute()
        self.assertWithout(obj, "Shell.%s" % inside[0])
        obj.Lateral = []
        self.doc.recompute()
        self.assertMade(obj)
        self.assertEqual(len(report_of(obj)["seams"]), 2)
        obj.End = [(shell, obj.Start[0][1])]
        self.doc.recompute()
        self.assertWithout(obj, "Shell.%s is in start and in end" % inside[0])

    def test_edges_of_two_objects_that_meet_are_one_side(self):
        low, high = self.sheets()
        parts = []
        for number, part in enumerate(((0, 0.4), (0.4, 1))):
            surface = low.Shape.Faces[0].Surface.copy()
            surface.segment(0, 1, *part)
            parts.append(models.add(self.doc, surface.toShape(), "Part%d" % number))
        self.doc.recompute()
        left = [(part, at_x(part, 30)) for part in parts]
        obj = kinds.create("BlendSurface", [left[0], (high, at_x(high, 60)), left[1]])
        self.assertEqual(({part for part, _ in obj.Start}, obj.Lateral), (set(parts), []))
        self.assertMade(obj)

    def test_a_lateral_boundary_is_a_wire_of_no_face(self):
        flat = Part.makePlane(30, 40), Part.makePlane(30, 40, App.Vector(60, 0, 0))
        left, right = (models.add(self.doc, s, n) for s, n in zip(flat, ("Left", "Right")))
        bow = Part.BezierCurve()
        poles = ((30, 0), (40, 0), (45, -6), (50, 0), (60, 0))
        bow.setPoles([App.Vector(x, y, 0) for x, y in poles])
        wire = models.add(self.doc, bow.toShape(), "Bow")
        self.doc.recompute()
        chosen = {
            "Start": [(left, at_x(left, 30))],
            "End": [(right, at_x(right, 60))],
            "Lateral": [wire],
        }
        obj = kinds.create("BlendSurface", chosen, start_order="G1", end_order="G1")
        self.assertMade(obj)
        far = max(Part.Vertex(p).distToShape(obj.Shape)[0] for p in wire.Shape.discretize(40))
        self.assertLess(far, 0.01)

    def test_an_edge_between_two_faces_needs_a_face(self):
        boxes = [self.doc.addObject("Part::Box", name) for name in ("Box", "Block")]
        boxes[1].Placement.Base = App.Vector(30, 0, 5)
        self.doc.recompute()
        edges = [
            edge_where(box, lambda p, x=x, z=z: abs(p.x - x) + abs(p.z - z) < 1e-6)
            for box, x, z in zip(boxes, (10, 30), (10, 15))
        ]
        tops = [
            "Face%d" % n
            for box in boxes
            for n, face in enumerate(box.Shape.Faces, 1)
            if face.normalAt(0, 0).z > 0.9 and face.CenterOfMass.z > box.Placement.Base.z + 9
        ]
        text = r"Box\.%s lies between Box\.Face\d and Box\.Face\d: select the face to continue"
        self.refused("BlendSurface", list(zip(boxes, edges)), text % edges[0])
        obj = kinds.create("BlendSurface", list(zip(boxes, zip(edges, tops))))
        self.assertMade(obj)
        self.assertEqual(obj.Start[0][1], (edges[0], tops[0]))
        for box, edge, top in zip(boxes, edges, tops):
            face = box.Shape.Faces[int(top[4:]) - 1]
            self.assertLess(differences(self.edge(box, edge), face, obj.Shape)[0], 0.1)
        boxes[0].Height = 14
        self.doc.recompute()
        self.assertMade(obj)
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMin, 14, delta=1e-3)

    def test_parts_place_their_contents(self):
        low, high = self.sheets()
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(high)
        part.Placement.Base = App.Vector(5, 0, 3)
        self.doc.recompute()
        obj = kinds.create("BlendSurface", [(low, at_x(low, 30)), (high, at_x(high, 60))])
        self.assertMade(obj)
        self.assertAlmostEqual(obj.Shape.BoundBox.XMax, 65, delta=1e-3)


class Selections(SurfaceCase):
    def test_what_is_not_usable_is_refused_with_one_sentence(self):
        low, high = self.sheets()
        mesh = self.doc.addObject("Mesh::Feature", "Scan")
        mesh.Mesh = Mesh.createBox(1, 1, 1)
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(0, 40, 0)), "Line")
        self.doc.recompute()
        start, end = (low, at_x(low, 30)), (high, at_x(high, 60))
        self.refused("BlendSurface", [], "nothing is selected: select the edges of two sides")
        self.refused("BlendSurface", [start], "the selection has 1 edge, in 1 chain")
        self.refused("BlendSurface", [start, (mesh, "")], "Scan has no edges: choose edges")
        self.refused("BlendSurface", [start, (high, "")], "High is chosen as a whole: choose edges")
        self.refused("BlendSurface", [start, (high, "Edge9")], "High has no Edge9")
        self.refused("BlendSurface", [start, (high, "Vertex1")], "High.Vertex1 is not an edge or")
        self.refused("BlendSurface", [start, (line, "Edge1")], "Line.Edge1 bounds no face")
        self.refused("ExtendSurface", [(low, "Face1")], "no edge is chosen")
        self.refused("ExtendSurface", {"Side": []}, "Side has no edge")
        with self.assertRaisesRegex(TypeError, "unknown sources 'Sides'"):
            kinds.create("ExtendSurface", {"Sides": [start]})
        with self.assertRaisesRegex(TypeError, "unknown option 'radius'"):
            kinds.create("BlendSurface", [start, end], radius=3)
        with self.assertRaisesRegex(ValueError, "start_order 'G4': choose one of G0, G1, G2, G3"):
            kinds.create("BlendSurface", [start, end], start_order="G4")

    def test_edges_of_two_objects_that_meet_are_one_chain(self):
        whole = sheet(0, 0, 0.3)
        halves = [
            models.add(self.doc, half, "Half%d" % number)
            for number, half in enumerate(halved(whole.Surface), 1)
        ]
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        chain, end = [(half, at_x(half, 30)) for half in halves], (high, at_x(high, 60))
        obj = kinds.create("BlendSurface", [*chain, end])
        self.assertEqual(obj.Proxy.source_objects(obj), [*halves, high])
        self.assertEqual([each for each, _ in obj.Start], halves)
        self.assertEqual([each for each, _ in obj.End], [high])
        self.assertMade(obj)

    def test_a_chain_goes_on_with_its_tangent(self):
        low, _ = self.sheets()
        flat = models.add(self.doc, stadium(), "Stadium")
        pad = models.add(self.doc, stadium().extrude(App.Vector(0, 0, 5)), "Pad")
        self.doc.recompute()
        chain = tangent_chain([(flat, "Edge1")])
        self.assertEqual({name for _, name in chain}, {"Edge1", "Edge2", "Edge3", "Edge4"})
        edge = (low, at_x(low, 30))
        self.assertEqual(tangent_chain([edge]), [edge])
        (top,) = [n for n, face in enumerate(pad.Shape.Faces, 1) if face.CenterOfMass.z > 4.9]
        first = pad.Shape.Faces[top - 1].Edges[0]
        name = next("Edge%d" % n for n, e in enumerate(pad.Shape.Edges, 1) if e.isSame(first))
        found = tangent_chain([(pad, name), (pad, "Face%d" % top)])
        self.assertEqual([element for _, element in found[4:]], ["Face%d" % top])
        self.assertEqual(len(found), 5)
        walls = {n for n, face in enumerate(pad.Shape.Faces, 1) if 2 < face.CenterOfMass.z < 3}
        wall = next(n for n in walls if any(e.isSame(first) for e in pad.Shape.Faces[n - 1].Edges))
        found = tangent_chain([(pad, name), (pad, "Face%d" % wall)])
        self.assertEqual({e for _, e in found[4:]}, {"Face%d" % n for n in walls})
        obj = kinds.create("ExtendSurface", found, length_mm=3)
        self.assertMade(obj)
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, 8, delta=1e-3)


class Extensions(SurfaceCase):
    def test_a_side_is_continued_over_a_length(self):
        low, _ = self.sheets()
        edge = at_x(low, 30)
        for order in ("G1", "G2", "G3"):
            obj = kinds.create("ExtendSurface", [(low, edge)], order=order, length_mm=5)
            self.assertMade(obj)
            angle, curvature = differences(self.edge(low, edge), low.Shape.Faces[0], obj.Shape)
            self.assertLess(angle, 0.1)
            if order != "G1":
                self.assertLess(curvature, 1e-4)
            self.assertAlmostEqual(obj.Shape.Area, 5 * self.edge(low, edge).Length, delta=2)
        obj.Length = 8
        self.doc.recompute()
        self.assertAlmostEqual(obj.Shape.Area, 8 * self.edge(low, edge).Length, delta=4)

    def test_a_side_is_continued_up_to_a_face(self):
        low, _ = self.sheets()
        corners = ((-50, -100), (100, -100), (100, 100), (-50, 100), (-50, -100))
        wall = Part.Face(Part.makePolygon([App.Vector(40, y, z) for y, z in corners]))
        wall = models.add(self.doc, wall, "Wall")
        self.doc.recompute()
        obj = kinds.create("ExtendSurface", [(low, at_x(low, 30)), (wall, "Face1")])
        self.assertEqual((obj.Until, obj.UpTo), ("Face", [(wall, ("Face1",))]))
        self.assertMade(obj)
        self.assertAlmostEqual(largest_x(obj.Shape), 40, delta=1e-3)
        self.assertRegex(obj.Summary, r"poles; 10\.\d to 10\.\d mm long\.$")
        wall.Placement.Base.x += 5
        self.doc.recompute()
        self.assertAlmostEqual(largest_x(obj.Shape), 45, delta=1e-3)
        wall.Placement.Base.z += 900
        self.doc.recompute()
        self.assertWithout(obj, "does not meet Wall.Face1 within")
        wall.Placement.Base.z -= 900
        obj.UpTo = []
        self.doc.recompute()
        self.assertWithout(obj, "there is no face at which the surface ends")

    def test_a_fold_is_told(self):
        ring = Part.makeCylinder(20, 10).cut(Part.makeCylinder(5, 10))
        face = next(f for f in ring.Faces if f.CenterOfMass.z > 9.9)
        obj = models.add(self.doc, face, "Ring")
        self.doc.recompute()
        inner = next(n for n, e in enumerate(obj.Shape.Edges, 1) if abs(e.Curve.Radius - 5) < 1e-6)
        long = kinds.create("ExtendSurface", [(obj, "Edge%d" % inner)], length_mm=8, order="G1")
        self.assertMade(long, reached=False)
        self.assertIn("the surface folds 5 mm from the side", long.Summary)


class Objects(SurfaceCase):
    def extension(self):
        low, _ = self.sheets()
        return kinds.create("ExtendSurface", [(low, at_x(low, 30))])

    def test_each_kind_follows_its_source_and_is_one_step(self):
        for make in (self.blend, self.extension):
            self.sheets()
            before = self.doc.Objects
            self.doc.UndoMode = 1
            obj = make()
            low = obj.Proxy.source_objects(obj)[0]
            top = obj.Shape.BoundBox.ZMax
            for source in obj.Proxy.source_objects(obj):
                source.Placement.Base.z += 4
            self.doc.recompute()
            self.assertMade(obj)
            self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, top + 4, delta=1e-6)
            low.Shape = sheet(0, 0, 0.1)
            self.doc.recompute()
            self.assertMade(obj)
            self.assertEqual(len(before), 2)
            App.closeDocument(self.doc.Name)
            self.doc = App.newDocument("Test")

    def test_an_undo_takes_it_back(self):
        low, high = self.sheets()
        chosen = [(low, at_x(low, 30)), (high, at_x(high, 60))]
        self.assertOneStep(lambda: kinds.create("BlendSurface", chosen), [low, high])

    def test_a_source_that_is_deleted_or_lacks_the_edge_is_an_error(self):
        obj = self.blend()
        high = obj.End[0][0]
        high.Shape = Part.Vertex(0, 0, 0)
        self.doc.recompute()
        self.assertFailed(obj, "High has no Edge")
        self.assertTrue(obj.Shape.isNull())
        self.doc.removeObject(high.Name)
        obj.touch()
        self.doc.recompute()
        advice = "select others and press \u201cUse selection\u201d at \u201cEnd\u201d in the panel"
        self.assertFailed(obj, "the edges of End were deleted: " + advice)

    def test_saved_surfaces_open_without_the_compiled_part(self):
        for make in (self.blend, self.extension):
            obj = make()
            low = obj.Proxy.source_objects(obj)[0]
            names = ("Summary", "Report", "SeamwrightVersion", "Reached")

            def again_made(name=low.Name, edge=at_x(low, 30)):
                kinds.create("ExtendSurface", [(self.doc.getObject(name), edge)])

            with self.opened_without_kernel(obj, names, again_made) as again:
                self.assertTrue(again.Shape.isValid())

    def test_a_reopened_one_is_up_to_date_and_follows_its_source(self):
        obj = self.blend(end_order="G3")
        name, top, high = obj.Name, obj.Shape.BoundBox.ZMax, obj.End[0][0].Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with ABSENT:
                self.doc = App.openDocument(path)
        again = self.doc.getObject(name)
        self.assertNotIn("Touched", again.State)
        self.assertEqual((again.EndOrder, again.Reached), ("G3", True))
        self.doc.getObject(high).Placement.Base.z += 20
        self.doc.recompute()
        self.assertMade(again)
        self.assertGreater(again.Shape.BoundBox.ZMax, top + 15)
