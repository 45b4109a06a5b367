# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines of own points, spirals, continuations and sketches, on FreeCAD's console."""

import math
import os
import tempfile

import FreeCAD as App
import models
import numpy
import Part
from curve_cases import RING, TURNED, WAVE, area_inside, farthest, vertices, wavy
from document_cases import ABSENT, DocumentCase
from surface_cases import SurfaceCase, at_x

from freecad.seamwright.document.curves import arcs
from freecad.seamwright.document.curves import kinds as curves
from freecad.seamwright.document.curves.conic import CHAIN
from freecad.seamwright.document.curves.join import CONTINUATION
from freecad.seamwright.document.curves.log_spiral import ARCS
from freecad.seamwright.document.curves.spline import BETA, NU
from freecad.seamwright.document.surfaces import kinds as surfaces

V = App.Vector


class OwnPoints(DocumentCase):
    def test_a_spline_needs_no_source(self):
        App.setActiveDocument(self.doc.Name)
        obj = curves.create("Spline", [], points_mm=WAVE)
        same = curves.make("Spline", vertices(WAVE))
        self.assertAlmostEqual(obj.Shape.Length, same.shape.Length, delta=1e-9)
        obj.Points = [*obj.Points, V(70, 0, 5)]
        self.doc.recompute()
        self.assertLess(obj.Shape.distToShape(Part.Vertex(70, 0, 5))[0], 1e-9)
        obj.Points = []
        self.doc.recompute()
        self.assertFailed(obj, "there are no sources")

    def test_points_of_sources_are_moved(self):
        source = models.add(self.doc, Part.Compound(vertices(WAVE)), "Points")
        self.doc.recompute()
        moves = [(0, 0, 0), (0, 3, 1), (0, 0, 0), (0, 0, 0), (0, 0, 0)]
        obj = curves.create("Spline", source, moves_mm=moves)
        self.assertLess(obj.Shape.distToShape(Part.Vertex(10, 25, 1))[0], 1e-9)
        source.Placement.Base = V(0, 0, 10)
        self.doc.recompute()
        self.assertLess(obj.Shape.distToShape(Part.Vertex(10, 25, 11))[0], 1e-9)
        source.Shape = Part.Compound(vertices(WAVE[:4]))
        self.doc.recompute()
        self.assertWithout(obj, "5 points were moved, but the sources have 4")

    def test_tangents_of_the_ends(self):
        """The other end stays natural: its curvature is 0 without tension."""
        for family in (NU, BETA):
            made = curves.make(
                "Spline", vertices(WAVE), family=family, start_tangent_mm=(0, -5, 2)
            )
            edge = made.shape.Edges[0]
            self.assertLess(edge.tangentAt(edge.FirstParameter).getAngle(V(0, -5, 2)), 1e-9)
            last = made.shape.Edges[-1]
            self.assertLess(last.curvatureAt(last.LastParameter), 1e-9)
            for point in vertices(WAVE):
                self.assertLess(point.distToShape(made.shape)[0], 1e-9)
        both = curves.make(
            "Spline", vertices(WAVE), start_tangent_mm=(0, -5, 2), end_tangent_mm=(3, 0, 0)
        )
        last = both.shape.Edges[-1]
        self.assertLess(last.tangentAt(last.LastParameter).getAngle(V(1, 0, 0)), 1e-9)

    def test_it_is_saved_padded_swept_and_lofted(self):
        App.setActiveDocument(self.doc.Name)
        curves.create("Spline", [], points_mm=RING, closed=True)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with ABSENT:
                self.doc = App.openDocument(path)
        obj = self.doc.Spline
        self.assertEqual([list(point) for point in obj.Points], [list(point) for point in RING])
        area = area_inside(obj.Shape)
        obj.Points = [2 * point for point in obj.Points]
        self.doc.recompute()
        self.assertAlmostEqual(area_inside(obj.Shape) / area, 4, delta=1e-6)
        pad = self.doc.addObject("PartDesign::Body", "Body").newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = obj, 5
        loft = self.doc.addObject("Part::Loft", "Loft")
        top = models.add(self.doc, Part.Wire(Part.makeCircle(3, V(20, 10, 30))), "Top")
        loft.Sections, loft.Solid = [obj, top], True
        self.doc.recompute()
        self.assertAlmostEqual(pad.Shape.Volume, 20 * area, delta=0.1 * area)
        self.assertGreater(loft.Shape.Volume, 100)


class Spirals(DocumentCase):
    CORNER = [(0, 0, 0), (0, 40, 0), (30, 50, 0)]

    def test_its_radius_grows_by_the_same_factor_with_each_degree(self):
        made = curves.make("LogSpiral", vertices(self.CORNER), tolerance_mm=1e-6)
        (edge,) = made.shape.Edges
        at = numpy.linspace(*edge.ParameterRange, 12)
        radii = numpy.log([1 / edge.curvatureAt(each) for each in at])
        tangents = [edge.tangentAt(each) for each in at]
        turns = numpy.cumsum([0, *(a.getAngle(b) for a, b in zip(tangents, tangents[1:]))])
        slope = (radii[-1] - radii[0]) / (turns[-1] - turns[0])
        self.assertLess(abs(radii - radii[0] - slope * turns).max(), 1e-3)
        self.assertAlmostEqual(math.degrees(turns[-1]), made.report["turn_deg"], delta=1e-4)
        self.assertAlmostEqual(math.exp(radii[0]), made.report["first_radius_mm"], delta=0.01)
        self.assertAlmostEqual(math.exp(radii[-1]), made.report["last_radius_mm"], delta=0.01)
        self.assertLess(tangents[0].getAngle(V(0, 1, 0)), 1e-6)
        self.assertLess(tangents[-1].getAngle(V(3, 1, 0)), 1e-6)

    def test_arcs_of_one_sweep(self):
        made = curves.make("LogSpiral", vertices(self.CORNER), result=ARCS, count=4)
        self.assertEqual(len(made.shape.Edges), 4)
        radii = [edge.Curve.Radius for edge in made.shape.Edges]
        factors = [b / a for a, b in zip(radii, radii[1:])]
        self.assertLess(max(factors) - min(factors), 1e-6)

    def test_it_continues_two_edges(self):
        line = Part.makeLine(TURNED.multVec(V(-10, 0, 0)), TURNED.multVec(V(0, 0, 0)))
        other = Part.makeLine(TURNED.multVec(V(40, 40, 0)), TURNED.multVec(V(35, 60, 0)))
        made = curves.make("LogSpiral", [line, other])
        first, last = made.shape.Edges[0], made.shape.Edges[-1]
        self.assertLess(
            first.tangentAt(first.FirstParameter).getAngle(line.tangentAt(0)), 1e-6
        )
        self.assertLess(last.tangentAt(last.LastParameter).getAngle(other.tangentAt(0)), 1e-6)
        with self.assertRaisesRegex(ValueError, "turns to one side"):
            curves.make("LogSpiral", [line, other], flip_first=True)

    def test_it_follows_its_source_and_is_swept_along(self):
        points = models.add(self.doc, Part.Compound(vertices(self.CORNER)), "Points")
        self.doc.recompute()
        obj = curves.create("LogSpiral", points)
        profile = Part.Wire(Part.makeCircle(2, V(), V(0, 1, 0)))
        sweep = self.doc.addObject("Part::Sweep", "Sweep")
        sweep.Sections = [models.add(self.doc, profile, "Profile")]
        sweep.Spine, sweep.Solid = (obj, []), True
        self.doc.recompute()
        volume = 4 * math.pi * obj.Shape.Length
        self.assertAlmostEqual(sweep.Shape.Volume, volume, delta=0.01 * volume)
        length = obj.Shape.Length
        points.Shape = Part.Compound(vertices([[2 * each for each in p] for p in self.CORNER]))
        self.doc.recompute()
        self.assertAlmostEqual(obj.Shape.Length, 2 * length, delta=0.01)

    def test_other_points_are_refused(self):
        with self.assertRaisesRegex(ValueError, "there are 5 points: a spiral has three"):
            curves.make("LogSpiral", vertices(WAVE))


class Continuations(DocumentCase):
    def test_the_second_edge_continues_the_first(self):
        one, other = Part.BSplineCurve(), Part.BSplineCurve()
        one.interpolate([V(0, 0, 0), V(10, 5, 0), V(20, 0, 3)])
        other.interpolate([V(22, 1, 3), V(30, 9, 0), V(40, 3, 0), V(50, 3, 0)])
        for order in ("G1", "G2", "G3"):
            made = curves.make(
                "JoinCurves", [one.toShape(), other.toShape()], order=order, method=CONTINUATION
            )
            first, second = made.shape.Edges[:2]
            self.assertLess(farthest(one.toShape(), first), 1e-9)
            end, start = first.LastParameter, second.FirstParameter
            self.assertLess(first.valueAt(end).distanceToPoint(second.valueAt(start)), 1e-9)
            self.assertLess(first.tangentAt(end).getAngle(second.tangentAt(start)), 1e-6)
            if order != "G1":
                centres = first.centerOfCurvatureAt(end), second.centerOfCurvatureAt(start)
                self.assertLess(centres[0].distanceToPoint(centres[1]), 1e-6)
            last = made.shape.Edges[-1]
            self.assertLess(last.valueAt(last.LastParameter).distanceToPoint(V(50, 3, 0)), 1e-9)
            moved = farthest(other.toShape(), made.shape)
            self.assertLessEqual(moved, made.report["moved_mm"] + 1e-9)
            self.assertIn("no point moved further", made.summary)


class Sketches(DocumentCase):
    def test_each_planar_curve_becomes_a_sketch_within_the_tolerance(self):
        points = models.add(self.doc, Part.Compound(vertices(WAVE)), "Points")
        edge = models.add(self.doc, wavy(), "Wavy")
        ends = ((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0))
        lines = [
            models.add(self.doc, Part.makeLine(*(V(*p) for p in pair)), "Line") for pair in ends
        ]
        self.doc.recompute()
        chosen = dict.fromkeys(("BlendCurves", "BridgeCurve", "JoinCurves"), lines)
        chosen["FairCurve"] = [edge]
        chosen["LogSpiral"] = [(points, ["Vertex1", "Vertex2", "Vertex3"])]
        for kind in curves.KINDS:
            with self.subTest(kind):
                given = {"points": CHAIN} if kind == "Conic" else {}
                obj = curves.create(kind, chosen.get(kind, [points]), **given)
                sketch = arcs.add_sketch(obj, 0.02)
                self.doc.recompute()
                self.assertLess(farthest(obj.Shape, sketch.Shape), 0.0201)
                self.assertLess(farthest(sketch.Shape, obj.Shape), 0.0201)
                kinds = {each.Curve.TypeId for each in sketch.Shape.Edges}
                self.assertLessEqual(kinds, {"Part::GeomLine", "Part::GeomCircle"})
                self.assertEqual(len(sketch.Shape.Wires), len(obj.Shape.Wires))

    def test_a_closed_curve_in_any_plane_is_padded(self):
        placed = [tuple(TURNED.multVec(V(*point))) for point in RING]
        ring = models.add(self.doc, Part.Compound(vertices(placed)), "Ring")
        obj = curves.create("Spline", ring, closed=True)
        pad = self.doc.addObject("PartDesign::Body", "Body").newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = arcs.add_sketch(obj), 5
        self.doc.recompute()
        flat = curves.make("Spline", vertices(RING), closed=True).shape
        self.assertAlmostEqual(pad.Shape.Volume, 5 * area_inside(flat), delta=20)

    def test_what_is_not_planar_is_refused(self):
        twisted = models.add(self.doc, Part.Compound(vertices([*WAVE, (60, 0, 9)])), "Twisted")
        obj = curves.create("Spline", twisted)
        before = self.doc.Objects
        with self.assertRaisesRegex(ValueError, "not in one plane"):
            arcs.add_sketch(obj)
        self.assertEqual(self.doc.Objects, before)


class DeletedSources(SurfaceCase):
    def walls(self):
        """A blend between two sheets with lateral boundaries of another object."""
        obj = self.blend()
        low, high = obj.Start[0][0], obj.End[0][0]
        edges = []
        for y in (0, 40):
            ends = [
                next(v.Point for v in each.Shape.Vertexes if abs(v.X - x) + abs(v.Y - y) < 1e-6)
                for each, x in ((low, 30), (high, 60))
            ]
            edges.append(Part.makeLine(*ends))
        wall = models.add(self.doc, Part.Compound(edges), "Wall")
        self.doc.recompute()
        obj.StartOrder = obj.EndOrder = "G0"
        obj.Lateral = [(wall, "Edge1"), (wall, "Edge2")]
        self.doc.recompute()
        self.assertMade(obj)
        return obj, wall

    def test_a_deleted_lateral_boundary_is_an_error_until_it_is_forgotten(self):
        obj, wall = self.walls()
        self.doc.UndoMode = 1
        self.doc.openTransaction("Delete")
        self.doc.removeObject(wall.Name)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertFailed(obj, "Wall was deleted: select others and press")
        self.doc.undo()
        self.doc.recompute()
        self.assertMade(obj)
        self.doc.removeObject("Wall")
        self.doc.recompute()
        self.assertFailed(obj, "Wall was deleted")
        obj.Lateral = []
        self.doc.recompute()
        self.assertMade(obj)

    def test_it_is_known_after_a_save(self):
        obj, wall = self.walls()
        self.doc.removeObject(wall.Name)
        name = obj.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
        again = self.doc.getObject(name)
        again.touch()
        self.doc.recompute()
        self.assertFailed(again, "Wall was deleted")

    def test_one_of_two_sources_of_a_curve(self):
        one = models.add(self.doc, Part.Compound(vertices(WAVE[:3])), "One")
        two = models.add(self.doc, Part.Compound(vertices(WAVE[3:])), "Two")
        self.doc.recompute()
        obj = curves.create("Spline", [one, two])
        self.doc.removeObject(two.Name)
        self.doc.recompute()
        self.assertFailed(obj, "Two was deleted: select others and press \u201cUse selection\u201d")
        obj.Sources = [(one, "")]
        self.doc.recompute()
        self.assertEqual(curves.error_text(obj), "")

    def test_sentences_have_degrees_and_labels(self):
        low, high = self.sheets()
        wall = models.add(self.doc, Part.makeLine(V(30, 0, 50), V(60, 0, 8)), "Wall")
        self.doc.recompute()
        obj = surfaces.create(
            "BlendSurface",
            {
                "Start": [(low, at_x(low, 30))],
                "End": [(high, at_x(high, 60))],
                "Lateral": [(wall, "Edge1")],
            },
        )
        self.assertIn("a gap of ", obj.Summary)
        self.assertNotRegex(obj.Summary, "gap_mm|_rad")
