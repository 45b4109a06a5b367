# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Match Surfaces, on FreeCAD's console; run by run_freecad.py."""

import contextlib
import json
import math
import re
from unittest import mock

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase

from freecad.seamwright.document import match
from freecad.seamwright.document.hooks import hooks

V = App.Vector


class MatchCase(DocumentCase):
    def sheets(self):
        """The two sheets as two objects."""
        self.left, self.right = (
            models.add(self.doc, shape, name)
            for shape, name in zip(models.two_sheets(), ("Left", "Right"))
        )
        self.doc.recompute()

    def match(self, **options):
        return match.create((self.left, "Face1"), (self.right, "Face1"), **options)

    def assertNotMatched(self, obj, text):
        self.assertWithout(obj, text)
        self.assertFalse(obj.Matched)
        self.assertTrue(obj.Shape.isNull())
        self.assertTrue(obj.Summary.startswith("Not matched: "), obj.Summary)
        self.assertIn(text, obj.Summary)


def angle_between(shape):
    """Largest angle of the normals of a shell's two faces at points of their common edge, in
    degrees."""
    first, second = shape.Faces
    (edge,) = [edge for edge in first.Edges if any(edge.isSame(other) for other in second.Edges)]
    low, high = edge.ParameterRange
    worst = 0.0
    for place in range(41):
        point = edge.valueAt(low + (high - low) * place / 40)
        normals = [face.normalAt(*face.Surface.parameter(point)) for face in (first, second)]
        worst = max(worst, abs(math.sin(normals[0].getAngle(normals[1]))))
    return math.degrees(math.asin(worst))


def tilted(x0, x1, y0, y1, rise=0.0):
    """A face of 4 x 4 poles over a rectangle."""
    places = [place / 3 for place in range(4)]
    lines = [
        [V(x0 + (x1 - x0) * s, y0 + (y1 - y0) * t, rise * (x1 - x0) * s) for t in places]
        for s in places
    ]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(lines, [4, 4], [4, 4], [0, 1], [0, 1], False, False, 3, 3)
    return surface.toShape()


def face_at(shape, point):
    """The normal of the face of a shape that is nearest to a point, there."""
    face = min(shape.Faces, key=lambda each: each.distToShape(Part.Vertex(point))[0])
    return face.normalAt(*face.Surface.parameter(point))


def edge_at(obj, point):
    """The name of the edge with its middle at a point."""
    (number,) = [
        number
        for number, edge in enumerate(obj.Shape.Edges, 1)
        if edge.CenterOfMass.distanceToPoint(point) < 1e-6
    ]
    return "Edge%d" % number


def text_of(shape):
    """A shape as text, without the flags of its parts: one says whether a part belongs to another
    shape."""
    return re.sub(r"^[01]{7}$", "", shape.exportBrepToString(), flags=re.M)


def counts(face):
    """The numbers of poles of a face."""
    return [face.Surface.NbUPoles, face.Surface.NbVPoles]


class Results(MatchCase):
    def test_two_objects_are_matched(self):
        self.sheets()
        obj = self.match()
        self.assertEqual(match.error_text(obj), "")
        self.assertTrue(obj.Matched and obj.Exact and obj.Certain, obj.Summary)
        self.assertEqual(
            (obj.LevelBefore, obj.LevelAfter, obj.Shape.ShapeType), ("G0", "G1", "Shell")
        )
        self.assertEqual(len(obj.Shape.Faces), 2)
        self.assertTrue(obj.Shape.isValid())
        self.assertAlmostEqual(obj.AngleBefore.Value, models.SHEETS_DEG, delta=0.01)
        self.assertLess(obj.AngleAfter.Value, 1e-4)
        self.assertLess(angle_between(obj.Shape), 1e-4)
        self.assertGreater(obj.LargestMove.Value, 0.1)
        self.assertLess(
            obj.LargestMove.Value, models.SHEET_MM * math.tan(math.radians(models.SHEETS_DEG))
        )
        self.assertTrue(obj.Summary.startswith("Matched: G1 is met; "), obj.Summary)
        faces = [*self.left.Shape.Faces, *self.right.Shape.Faces, *obj.Shape.Faces]
        poles = [counts(each) for each in faces]
        self.assertEqual(match.report_of(obj)["poles"], [poles[::2], poles[1::2]])

    def test_curvature_is_matched_for_g2(self):
        self.sheets()
        self.right.Shape = models.sheet(1, models.SHEETS_DEG, bend=0.01)
        obj = self.match(target="G2")
        self.assertEqual((obj.Matched, obj.LevelAfter), (True, "G2"))
        self.assertLess(obj.CurvatureAfter, 0.02)
        self.assertGreater(obj.CurvatureBefore, 0.02)

    def test_the_face_that_moves_is_the_one_said(self):
        self.sheets()
        for moves, stays in (
            ("second", (True, False)),
            ("first", (False, True)),
            ("both", (False, False)),
        ):
            with self.subTest(moves):
                obj = self.match(moves=moves)
                self.assertTrue(obj.Matched)
                for face, source, still in zip(obj.Shape.Faces, (self.left, self.right), stays):
                    poles, known = (
                        [pole for line in shape.Surface.getPoles() for pole in line]
                        for shape in (face, source.Shape.Faces[0])
                    )
                    same = (
                        len(poles) == len(known)
                        and max(map(App.Vector.distanceToPoint, poles, known)) < 1e-12
                    )
                    self.assertEqual(same, still)

    def test_two_faces_of_one_object(self):
        pair = models.add(self.doc, Part.Compound(models.two_sheets()), "Pair")
        pair.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 2, 3), 40))
        obj = match.create((pair, "Face1"), (pair, "Face2"))
        self.assertTrue(obj.Matched, obj.Summary)
        self.assertLess((obj.Shape.BoundBox.Center - pair.Shape.BoundBox.Center).Length, 1.0)

    def test_sources_in_a_part_are_matched_where_they_stand(self):
        self.sheets()
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.left)
        part.addObject(self.right)
        part.Placement.Base = App.Vector(100, 0, 0)
        obj = self.match()
        self.assertTrue(obj.Matched, obj.Summary)
        self.assertAlmostEqual(obj.Shape.BoundBox.Center.x, 100, delta=1.0)

    def test_sources_are_left_as_they_were(self):
        self.sheets()
        before = [text_of(source.Shape) for source in (self.left, self.right)]
        self.match(moves="both")
        self.assertEqual([text_of(source.Shape) for source in (self.left, self.right)], before)

    def test_a_common_edge_can_be_chosen(self):
        self.sheets()
        edges = self.right.Shape.Edges
        (at_seam,) = [n for n, edge in enumerate(edges, 1) if abs(edge.CenterOfMass.x) < 1e-6]
        obj = self.match(edge=(self.right, "Edge%d" % at_seam))
        self.assertTrue(obj.Matched, obj.Summary)
        away = next(n for n, edge in enumerate(edges, 1) if abs(edge.CenterOfMass.x) > 15)
        obj.CommonEdge = (self.right, ["Edge%d" % away])
        self.doc.recompute()
        self.assertNotMatched(
            obj, "Right.Edge%d is not a common boundary of the faces; these are: Left.Edge" % away
        )
        other = models.add(self.doc, Part.makeBox(1, 1, 1), "Box")
        obj.CommonEdge = (other, ["Edge1"])
        self.doc.recompute()
        self.assertNotMatched(obj, "Box.Edge1 is not an edge of the two faces")


class Chains(MatchCase):
    def setUp(self):
        super().setUp()
        self.right = models.add(self.doc, tilted(0, 60, 0, 40, 0.02), "Right")
        self.low, self.high = (
            models.add(self.doc, tilted(-30, 0, *ends), name)
            for name, ends in (("Low", (0, 25)), ("High", (25, 40)))
        )
        self.doc.recompute()

    def assertSmooth(self, obj, moved):
        """The tangent planes of the moved face and of the other two agree at points between."""
        self.assertTrue(obj.Matched, obj.Summary)
        self.assertEqual((len(obj.Shape.Faces), obj.LevelBefore), (3, "G0"))
        angles = []
        for y in (1, 12, 24, 26, 33, 39):
            normals = [face_at(obj.Shape, V(x, y, 0)) for x in (-1e-6, 1e-6)]
            angles.append(math.degrees(math.asin(normals[0].cross(normals[1]).Length)))
        self.assertLess(max(angles), 1e-3)
        self.assertIn("%s joins " % moved, obj.Summary)
        self.assertPolesTold(obj, moved)

    def assertPolesTold(self, obj, moved):
        """The Summary names the faces that got other numbers of poles."""
        told, names = match.report_of(obj)["poles"], match.report_of(obj)["faces"]
        self.assertEqual(names[0], moved)
        sources = {each.Label + ".Face1": each for each in (self.right, self.low, self.high)}
        for name, face, (before, after) in zip(names, obj.Shape.Faces, told):
            self.assertLess(face.CenterOfMass.distanceToPoint(sources[name].Shape.CenterOfMass), 9)
            self.assertEqual(before, counts(sources[name].Shape.Face1))
            self.assertEqual(after, counts(face))
            text = "%s has %d x %d poles instead of %d x %d" % (name, *after, *before)
            self.assertEqual(text in obj.Summary, after != before)
        self.assertEqual(len(told), 3)

    def test_a_face_joins_a_chain_of_faces(self):
        first, second, more = (self.low, "Face1"), (self.right, "Face1"), [(self.high, "Face1")]
        for target, moves in (("G1", "second"), ("G2", "second"), ("G1", "both")):
            obj = match.create(first, second, more=more, target=target, moves=moves)
            self.assertSmooth(obj, "Right.Face1")
            self.assertIn(obj.LevelAfter, ("G1", "G2")[("G1", "G2").index(target) :])
            self.assertTrue(target == "G1" or obj.CurvatureAfter < 0.02)
        self.assertSmooth(match.create(second, first, more=more, moves="first"), "Right.Face1")
        self.high.Placement.Base = V(0, 0, 1)
        self.doc.recompute()
        self.assertNotMatched(obj, "High.Face1 has no edge along Right.Face1 within the match")
        self.assertIn("they are 1 mm apart", obj.Summary)
        self.doc.removeObject(self.high.Name)
        self.doc.recompute()
        self.assertNotMatched(obj, "High was deleted: select others and press")

    def test_a_kink_that_makes_the_face_less_fair_needs_a_depth(self):
        surface = Part.BSplineSurface()
        surface.interpolate(
            [[V(8 * i, 10 * j, -6 * i * i) for j in range(5)] for i in range(6)]
        )
        self.right.Shape = surface.toShape()
        self.doc.recompute()
        faces = [(each, "Face1") for each in (self.low, self.high, self.right)]
        first, second, given = match.arranged(faces)
        obj = match.create(first, second, fairness=1.0, **given)
        self.assertNotMatched(obj, "allow a change over a larger Depth, or a larger Fairness")
        obj.Fairness = 1000
        self.doc.recompute()
        self.assertSmooth(obj, "Right.Face1")

    def test_what_is_selected(self):
        faces = [(each, "Face1") for each in (self.low, self.high, self.right)]
        self.assertEqual(match.arranged(faces[:2]), (*faces[:2], {"edge": None}))
        self.assertEqual(match.arranged(faces), (faces[0], faces[2], {"more": [faces[1]]}))
        places = (self.low, 12.5), (self.high, 32.5)
        edges = [(each, edge_at(each, V(0, y, 0))) for each, y in places]
        first, second, given = match.arranged([faces[2], *edges])
        self.assertEqual((first, second, given), (faces[0], faces[2], {"more": edges}))
        self.assertSmooth(match.create(first, second, **given), "Right.Face1")
        across = [(self.high, edge_at(self.high, V(-15, 40, 0)))]
        obj = match.create(first, second, more=across)
        self.assertNotMatched(obj, "High.Face1 has no edge along Right.Face1")
        for wrong in ([], faces[:1], edges):
            with self.assertRaisesRegex(ValueError, "Select two faces"):
                match.arranged(wrong)
        with self.assertRaisesRegex(ValueError, "Right.Face1 would join itself"):
            match.arranged([*faces, faces[2]])


class EdgeAndFace(MatchCase):
    def test_an_edge_of_the_first_face_is_the_common_edge(self):
        self.sheets()
        left, right = ((each, "Face1") for each in (self.left, self.right))
        aim = self.right.Shape.CenterOfMass
        ways = [each.CenterOfMass.distanceToPoint(aim) for each in self.left.Shape.Edges]
        common = (self.left, "Edge%d" % (1 + ways.index(min(ways))))
        arranged = match.arranged([common, right])
        self.assertEqual(arranged, (left, right, {"edge": common}))
        obj = match.create(*arranged[:2], **arranged[2])
        alone = self.match()
        self.assertTrue(obj.Matched)
        for name in ("GapAfter", "AngleAfter", "LargestMove"):
            found, wanted = (getattr(each, name).Value for each in (obj, alone))
            self.assertAlmostEqual(found, wanted, delta=1e-9, msg=name)


class Following(MatchCase):
    def test_a_changed_source_is_followed(self):
        self.sheets()
        obj = self.match()
        before = obj.LargestMove.Value
        self.right.Shape = models.sheet(1, slope_deg=1.0)
        self.doc.recompute()
        self.assertAlmostEqual(obj.AngleBefore.Value, 1.0, delta=0.01)
        self.assertTrue(0 < obj.LargestMove.Value < before)

    def test_each_change_asks_for_a_recompute(self):
        self.sheets()
        obj = self.match()
        changes = {name: 0.5 for name, *_ in match.TOLERANCES}
        changes.update(Target="G2", Moves="Both", MaxMove=5, HoldSides=True, Depth=3, Fairness=2)
        for name, value in changes.items():
            with self.subTest(name):
                self.doc.recompute()
                self.assertNotIn("Touched", obj.State)
                setattr(obj, name, value)
                self.assertIn("Touched", obj.State)

    def test_a_failure_empties_the_result_and_passes_away(self):
        self.sheets()
        obj = self.match()
        obj.MaxMove = 1e-3
        self.doc.recompute()
        self.assertNotMatched(obj, "0.001")
        self.assertAlmostEqual(obj.AngleBefore.Value, models.SHEETS_DEG, delta=0.01)
        self.assertEqual(
            (obj.LevelAfter, obj.AngleAfter.Value, obj.LargestMove.Value), ("", 0.0, 0.0)
        )
        obj.MaxMove = 0
        self.doc.recompute()
        self.assertEqual((obj.Matched, match.error_text(obj)), (True, ""))

    def test_cancelling_keeps_the_results(self):
        self.sheets()
        obj = self.match()
        report = obj.Report
        with mock.patch.object(
            hooks, "progress", lambda text: contextlib.nullcontext(lambda fraction: False)
        ):
            obj.touch()
            self.doc.recompute()
        self.assertOutdated(obj)
        self.assertEqual((obj.Report, obj.Matched, len(obj.Shape.Faces)), (report, True, 2))


class Errors(MatchCase):
    def test_the_same_face_twice(self):
        self.sheets()
        self.assertNotMatched(
            match.create((self.left, "Face1"), (self.left, "Face1")), "Left.Face1 is chosen twice"
        )

    def test_faces_that_cannot_move_are_named(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = match.create((box, "Face1"), (box, "Face3"))
        self.assertNotMatched(obj, "Box.Face3 is a plane")

    def test_no_common_boundary(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        self.assertNotMatched(match.create((box, "Face1"), (box, "Face2")), "no common boundary")

    def test_a_deleted_source(self):
        self.sheets()
        obj = self.match()
        self.doc.removeObject("Right")
        obj.touch()
        self.doc.recompute()
        self.assertNotMatched(obj, "The second face was deleted")

    def test_a_face_that_is_no_more(self):
        self.sheets()
        self.assertNotMatched(
            match.create((self.left, "Face1"), (self.right, "Face7")), "Right has no Face7"
        )
        obj = self.match()
        self.right.Shape = Part.Shape()
        self.doc.recompute()
        self.assertNotMatched(obj, "Right has no shape")

    def test_an_edge_is_no_face(self):
        self.sheets()
        self.assertNotMatched(
            match.create((self.left, "Face1"), (self.right, "Edge1")), "must be faces"
        )

    def test_bad_arguments_leave_nothing_behind(self):
        self.sheets()
        for wrong, text in (
            ({"target": "G3"}, "target 'G3'"),
            ({"moves": "none"}, "moves 'none'"),
            ({"max_move_mm": -1.0}, "max_move_mm"),
            ({"depth_mm": -1.0}, "depth_mm"),
            ({"gap_mm": math.nan}, "gap_mm"),
            ({"gap_mm": "x"}, "gap_mm = 'x' is no number"),
            ({"profile": "class-b"}, "profile 'class-b'"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                self.match(**wrong)
        with self.assertRaisesRegex(TypeError, "'gap'"):
            self.match(gap=0.1)
        for edge in ("Edge1", (self.left,), (None, "Edge1"), (self.left, None)):
            with self.assertRaisesRegex(TypeError, "edge = "):
                self.match(edge=edge)
        right = (self.right, "Face1")
        with self.assertRaisesRegex(TypeError, "first = None: .* is needed"):
            match.create(None, right)
        with self.assertRaisesRegex(TypeError, "second = 'x': an object of a document is needed"):
            match.create(right, ("x", "Face1"))
        self.assertEqual(self.doc.Objects, [self.left, self.right])

    def test_a_bad_property_is_an_error_of_the_object(self):
        self.sheets()
        obj = self.match()
        obj.AngleTolerance = -1.0
        self.doc.recompute()
        self.assertNotMatched(obj, "-1")


class Saving(MatchCase):
    def test_results_survive_without_the_compiled_module(self):
        self.sheets()
        obj = self.match(target="G2", moves="both", max_move_mm=7.0)
        names = ("Report", "Summary", "Matched", "LevelAfter", "Target", "Moves")

        def make():
            match.create((self.doc.Left, "Face1"), (self.doc.Right, "Face1"))

        with self.opened_without_kernel(obj, names, make) as again:
            self.assertTrue(match.is_match(again))
            self.assertEqual((again.MaxMove.Value, len(again.Shape.Faces)), (7.0, 2))
            self.assertEqual(match.link(again, "SecondFace"), (self.doc.Right, "Face1"))
        self.doc.Right.Shape = models.sheet(1, slope_deg=1.0)
        self.doc.recompute()
        self.assertEqual(match.error_text(again), "")
        self.assertAlmostEqual(again.AngleBefore.Value, 1.0, delta=0.01)

    def test_the_report_is_json_with_the_names_of_the_faces(self):
        self.sheets()
        report = json.loads(self.match().Report)
        self.assertEqual(report["faces"], ["Left.Face1", "Right.Face1"])
