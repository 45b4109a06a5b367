# SPDX-License-Identifier: LGPL-2.1-or-later
"""Umbrella Fill, on FreeCAD's console; run by run_freecad.py."""

import contextlib
import itertools
import math
import random
from unittest import mock

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase
from match_cases import text_of

from freecad.seamwright.document import elements, fill
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.plain import fill_misses, fill_text, new_seams


#: The octant of a ball of 4 mm has 33.5 mm3. The volume under a fill of three sides differs from it
#: by less than a twentieth of this.
BALL_DELTA = 1.6


def neighbours(shape, number):
    """The names of the faces that share an edge with a face."""
    own = shape.Faces[number - 1].Edges
    others = (n for n in range(1, len(shape.Faces) + 1) if n != number)
    return {
        "Face%d" % n
        for n in others
        if any(a.isSame(b) for a in own for b in shape.Faces[n - 1].Edges)
    }


def largest_angle(shape, faces):
    """Largest angle of the normals across the edges of some faces, at points of OpenCASCADE, in
    degrees."""
    angles = [0.0]
    for edge in {
        edge.hashCode(): edge for number in faces for edge in shape.Faces[number - 1].Edges
    }.values():
        both = [face for face in shape.Faces if any(edge.isSame(other) for other in face.Edges)]
        low, high = edge.ParameterRange
        for place in range(1, 20):
            point = edge.valueAt(low + (high - low) * place / 20)
            one, other = (face.normalAt(*face.Surface.parameter(point)) for face in both)
            angles.append(math.degrees(math.asin(min(1.0, one.cross(other).Length))))
    return max(angles)


class FillCase(DocumentCase):
    def block(self):
        return models.add(self.doc, models.rounded_block(), "Block")

    def open_block(self, corners=1):
        """A rounded block without some of its corners; its object and the holes' edges as lists of
        names."""
        shape = models.open_block(corners)
        return models.add(self.doc, shape, "Open"), models.open_loops(shape)

    def assertNotFilled(self, obj, text):
        self.assertWithout(obj, text)
        self.assertEqual((obj.Filled, obj.Reached, obj.NewFaces), (0, False, 0))
        self.assertTrue(obj.Shape.isNull())
        self.assertTrue(obj.Summary.startswith("Not filled: "), obj.Summary)
        self.assertIn(text, obj.Summary)


class Holes(FillCase):
    def test_a_hole_is_filled_to_a_solid_tangent_to_its_surroundings(self):
        source, _ = self.open_block()
        obj = fill.create(source)
        self.assertEqual(fill.error_text(obj), "")
        self.assertEqual((obj.Filled, obj.Wanted, obj.NewFaces, obj.Reached), (1, 1, 3, True))
        (entry,) = fill.report_of(obj)["fills"]
        self.assertEqual(
            (len(obj.Shape.Solids), obj.Shape.isValid(), obj.Shape.isClosed()), (1, True, True)
        )
        self.assertLess(largest_angle(obj.Shape, entry["faces"]), 0.01)
        self.assertLessEqual(largest_angle(obj.Shape, entry["faces"]), obj.MaxAngle.Value + 1e-6)
        self.assertAlmostEqual(obj.Shape.Volume, models.rounded_block().Volume, delta=BALL_DELTA)
        self.assertRegex(
            obj.Summary, r"^1 of 1 hole filled with 3 faces; 9 seams, gap at most .*; G1 is met\.$"
        )

    def test_a_hole_of_a_smooth_sheet_is_filled_g2(self):
        source = models.add(self.doc, models.around_a_hole(), "Shell")
        obj = fill.create(source, target="G2", curvature_rel=0.01)
        self.assertEqual((fill.error_text(obj), obj.Reached), ("", True))
        self.assertTrue(obj.Summary.endswith("G2 is met."), obj.Summary)
        self.assertLessEqual(obj.MaxCurvature, 0.01)
        faces = fill.report_of(obj)["fills"][0]["faces"]
        for number in faces:
            for u, v in itertools.product((0.2, 0.5, 0.8), repeat=2):
                face = obj.Shape.Faces[number - 1]
                u0, u1, v0, v1 = face.ParameterRange
                point = face.valueAt(u0 + u * (u1 - u0), v0 + v * (v1 - v0))
                self.assertAlmostEqual(point.z, models.height(point.x, point.y), delta=0.05)

    def test_a_rounded_corner_misses_g2_for_it_does_not_exist(self):
        source, _ = self.open_block()
        obj = fill.create(source, target="G2")
        self.assertNotFilled(obj, "is not G2")
        self.assertNamesTheHole(obj)
        self.assertRegex(
            obj.Summary, r"The best fill needs .*a curvature tolerance of [0-9]+ %; Keep anyway"
        )
        obj.Target = "G1"
        self.doc.recompute()
        self.assertEqual((fill.error_text(obj), obj.Reached), ("", True))
        source.Shape = Part.Compound(source.Shape.Faces[::-1])
        obj.Target = "G2"
        self.doc.recompute()
        self.assertNotFilled(obj, "is not G2")
        self.assertNamesTheHole(obj)

    def assertNamesTheHole(self, obj):
        """Seams of a fill that was not kept name free edges of the source and their faces."""
        faces, edges = obj.Source.Shape.Faces, obj.Source.Shape.Edges
        report = fill.report_of(obj)
        seams, named = report["fills"][0]["seams"], set()
        for seam in seams:
            self.assertEqual((seam["edges"], seam["faces"]), ([], []))
            beside = fill_text.face_beside(seam)
            self.assertEqual(beside is None, "source_edges" not in seam)
            for number in seam.get("source_edges", ()):
                owners = [
                    place
                    for place, face in enumerate(faces, 1)
                    if any(map(edges[number - 1].isSame, face.Edges))
                ]
                self.assertEqual(owners, [beside])
                named.add(number)
        self.assertEqual(len(named), 3)
        built = new_seams.build_rows(seams, report["tolerance"], "G2")
        self.assertTrue(built[0].cells[0].endswith(" (model)"), built[0].cells)

    def test_edges_of_a_loop_in_any_order_and_number_name_their_hole(self):
        source, loops = self.open_block(2)
        for seed, loop in enumerate(loops):
            shuffled = random.Random(seed).sample(loop, len(loop))
            for edges in (loop, loop[::-1], shuffled, loop[1:2]):
                obj = fill.create(source, edges=edges)
                self.assertEqual((fill.error_text(obj), obj.Filled, obj.Reached), ("", 1, True))
                holes, _, _ = fill.holes_of(obj)
                (entry,) = fill.report_of(obj)["fills"]
                numbers = {int(name[4:]) for name in loop}
                self.assertEqual(set(fill_text.edges_of(holes[entry["hole"] - 1])), numbers)
                self.assertEqual(len(models.open_loops(obj.Shape)), 1)

    def test_several_holes_with_the_numbers_of_the_result(self):
        source, loops = self.open_block(4)
        obj = fill.create(source, edges=list(itertools.chain(*loops)))
        self.assertEqual((obj.Filled, obj.NewFaces, obj.Reached), (4, 12, True), obj.Summary)
        self.assertTrue(obj.Shape.isClosed() and obj.Shape.isValid())
        shape, named = obj.Shape, set()
        for entry, loop in zip(fill.report_of(obj)["fills"], loops):
            around = {
                vertex.Point[:]
                for name in loop
                for vertex in source.Shape.getElement(name).Vertexes
            }
            box = App.BoundBox()
            for point in around:
                box.add(App.Vector(point))
            box.enlarge(0.01)
            self.assertEqual(len(entry["faces"]), 3)
            for number in entry["faces"]:
                self.assertTrue(box.isInside(shape.Faces[number - 1].CenterOfMass))
            for seam in entry["seams"]:
                (edge,) = (shape.Edges[number - 1] for number in seam["edges"])
                self.assertAlmostEqual(edge.Length, seam["length_mm"], delta=1e-6)
                for number in seam["faces"]:
                    self.assertTrue(
                        any(edge.isSame(other) for other in shape.Faces[number - 1].Edges)
                    )
            named |= set(entry["faces"])
        self.assertEqual(len(named), 12)

    def test_holes_of_two_shells(self):
        one, other = models.open_block(1), models.open_block(1, size=26.0)
        other.translate(App.Vector(50, 0, 0))
        obj = fill.create(models.add(self.doc, Part.Compound([one, other]), "Two"))
        self.assertEqual((obj.Filled, obj.NewFaces, obj.Reached), (2, 6, True), obj.Summary)
        self.assertEqual((len(obj.Shape.Solids), models.open_loops(obj.Shape)), (2, []))
        for entry in fill.report_of(obj)["fills"]:
            self.assertLess(largest_angle(obj.Shape, entry["faces"]), 0.01)

    def test_rims_are_left_open_unless_chosen(self):
        panel = models.add(self.doc, models.panel_with_hole(), "Panel")
        obj = fill.create(panel)
        self.assertEqual((obj.Filled, obj.Wanted, obj.NewFaces), (1, 1, 4), obj.Summary)
        self.assertEqual(len(models.open_loops(obj.Shape)), 1)
        holes, wanted, text = fill.holes_of(obj)
        self.assertEqual(
            ([hole["longest"] for hole in holes], wanted, text), ([True, False], [2], "")
        )

    def test_holes_as_long_as_one_another_are_all_filled(self):
        tube = models.add(self.doc, Part.makeShell(Part.makeBox(10, 10, 30).Faces[:4]), "Tube")
        obj = fill.create(tube, target="G0")
        self.assertEqual((obj.Filled, obj.Wanted, obj.Reached), (2, 2, True), obj.Summary)
        self.assertAlmostEqual(obj.Shape.Volume, 3000, delta=1e-6)
        holes, wanted, _ = fill.holes_of(obj)
        self.assertEqual(([hole["longest"] for hole in holes], wanted), ([False, False], [1, 2]))
        centres = sorted(tuple(round(each, 9) for each in hole["centre_mm"]) for hole in holes)
        self.assertEqual(centres, [(5, 5, 0), (5, 5, 30)])

    def test_holes_inside_of_a_face_are_no_outer_boundaries(self):
        box = Part.makeBox(40, 40, 10)
        for radius, x in ((8, 12), (4, 30)):
            box = box.cut(Part.makeCylinder(radius, 5, App.Vector(x, 20, 7)))
        tops = [face for face in box.Faces if len(face.Wires) == 3]
        walls = [face for face in box.Faces if len(face.Edges) == 4 and not face.isSame(tops[0])]
        walls = [face for face in walls if face.Surface.TypeId == "Part::GeomPlane"]
        plate = models.add(self.doc, Part.makeShell(tops + walls), "Plate")
        obj = fill.create(plate, target="G0")
        holes, wanted, text = fill.holes_of(obj)
        self.assertEqual((len(holes), wanted, text), (2, [1, 2], ""))
        self.assertEqual((obj.Filled, obj.NewFaces), (2, 2), obj.Summary)
        self.assertAlmostEqual(obj.Shape.Volume, 16000, delta=1e-6)

    def test_both_ends_of_a_tube_of_one_face(self):
        tube = models.add(self.doc, Part.makeCylinder(10, 30).Faces[0], "Tube")
        obj = fill.create(tube, target="G0")
        self.assertEqual((obj.Filled, obj.NewFaces), (2, 2), obj.Summary)
        self.assertAlmostEqual(obj.Shape.Volume, 3000 * math.pi, delta=1e-3)

    def test_outlines_of_separate_faces_are_no_holes(self):
        faces = [each.copy() for each in Part.makeBox(10, 10, 10).Faces]
        loose = models.add(self.doc, Part.Compound(faces), "Loose")
        obj = fill.create(loose)
        self.assertIn("The 6 faces of Loose share no edges", fill.error_text(obj) or obj.Summary)
        self.assertEqual((obj.Filled, obj.Shape.isNull()), (0, True))
        self.assertEqual(fill.create(loose, edges=["Edge1"], target="G0").Wanted, 1)

    def test_a_hole_that_fails_does_not_hold_up_the_others(self):
        sharp = Part.makeShell(
            Part.makeBox(10, 10, 10).Faces[1:]
        )  # no fill is tangent to its sides
        sharp.translate(App.Vector(50, 0, 0))
        both = models.add(self.doc, Part.Compound([sharp, models.open_block(1)]), "Both")
        obj = fill.create(both)
        self.assertEqual(
            (fill.error_text(obj), obj.Filled, obj.Wanted, obj.Reached), ("", 1, 2, False)
        )
        self.assertIn("1 of 2 holes filled", obj.Summary)
        self.assertRegex("".join(fill_text.reasons(fill.report_of(obj))), "^Hole 1: .* 90\u00b0")

    def test_a_round_hole(self):
        can = models.add(self.doc, Part.makeShell(Part.makeCylinder(3, 10).Faces[:2]), "Can")
        obj = fill.create(can)
        self.assertEqual((fill.error_text(obj), obj.Filled, obj.Reached), ("", 1, True))
        self.assertTrue(obj.Shape.isClosed() and obj.Shape.isValid())
        (entry,) = fill.report_of(obj)["fills"]
        self.assertEqual(len(entry["faces"]), len(obj.Shape.Faces) - 2)

    def test_a_face_is_replaced(self):
        block = self.block()
        ball = models.corner_faces(block.Shape)[0]
        obj = fill.create(block, face="Face%d" % ball)
        self.assertEqual((obj.Filled, obj.NewFaces, obj.Reached), (1, 3, True), obj.Summary)
        self.assertTrue(
            obj.Summary.startswith("Face%d replaced with 3 faces; " % ball), obj.Summary
        )
        self.assertTrue(obj.Shape.isClosed() and obj.Shape.isValid())
        self.assertEqual(len(obj.Shape.Faces), len(block.Shape.Faces) + 2)
        self.assertNeighbours(obj, neighbours(block.Shape, ball))
        same = fill.prepare(block, face=ball)
        self.assertEqual(elements.names(same, "Face"), ["Face%d" % ball])
        box = models.add(self.doc, Part.makeBox(10, 10, 10), "Box")
        for number in (1, 4):
            flat = fill.create(box, face="Face%d" % number)
            self.assertNotFilled(flat, "Not filled: Face%d: a seam between Face" % number)
            self.assertNeighbours(flat, neighbours(box.Shape, number))

    def test_each_face_of_a_pad_is_replaced(self):
        outline = Part.makePolygon([(0, 0, 0), (8, 0, 0), (0, 6, 0), (0, 0, 0)])
        pad = models.add(
            self.doc, Part.Face(Part.Wire(outline)).extrude(App.Vector(0, 0, 5)), "Pad"
        )
        for number in range(1, 6):
            obj = fill.create(pad, face=number, target="G0")
            self.assertEqual(fill.error_text(obj), "")
            self.assertAlmostEqual(obj.Shape.Volume, 120, 3)
            self.assertNeighbours(obj, neighbours(pad.Shape, number))

    def assertNeighbours(self, obj, names):
        seams = fill_text.every_seam(fill.report_of(obj))
        found = {seam["between"] for seam in seams} - {fill_text.INSIDE}
        self.assertEqual(found, {"fill, " + name for name in names})

    def test_position_only_and_keep_anyway(self):
        box = models.add(self.doc, Part.makeShell(Part.makeBox(10, 10, 10).Faces[1:]), "Box")
        obj = fill.create(box)
        self.assertNotFilled(obj, "and the fill is not G1")
        self.assertRegex(obj.Summary, "between Face[1-5] and the fill")
        seams = fill_text.every_seam(fill.report_of(obj))
        self.assertTrue(seams and all(seam["edges"] == [] for seam in seams))
        self.assertAlmostEqual(obj.Rejected.Area, 100, delta=1e-6)
        self.assertAlmostEqual(obj.Rejected.BoundBox.DiagonalLength, 200**0.5, delta=1e-6)
        lines = fill_misses.lines(fill.report_of(obj))
        outside = [
            shares for points, shares in lines
            if all(min(abs(at - end) for at in point[1:] for end in (0, 10)) < 1e-6
                   for point in points)
        ]  # fmt: skip
        self.assertEqual(len(outside), 8)
        for shares in outside:  # 90 degrees, and 0.01 are allowed
            self.assertLess(max(abs(share - 9000) for share in shares), 1e-3, shares)
        self.assertAlmostEqual(max(seam["angle_deg"]["upper"] for seam in seams), 90, delta=1e-6)
        obj.KeepAnyway = True
        self.doc.recompute()
        self.assertTrue(obj.Rejected.isNull())
        self.assertEqual((fill.error_text(obj), obj.Filled, obj.Reached), ("", 1, False))
        self.assertTrue(obj.Summary.endswith("G1 is not met, kept anyway."), obj.Summary)
        obj.KeepAnyway, obj.Target = False, "G0"
        self.doc.recompute()
        self.assertEqual((obj.Filled, obj.Reached), (1, True), obj.Summary)
        self.assertAlmostEqual(obj.Shape.Volume, 1000, delta=1e-6)

    def test_the_source_is_left_as_it_was(self):
        source, _ = self.open_block(2)
        self.doc.recompute()
        before = text_of(source.Shape)
        fill.create(source, keep_anyway=True)
        self.assertEqual(text_of(source.Shape), before)

    def test_a_source_in_a_part_is_filled_where_it_stands(self):
        source, _ = self.open_block()
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(source)
        part.Placement = App.Placement(
            App.Vector(100, 20, 3), App.Rotation(App.Vector(1, 2, 3), 40)
        )
        source.Placement.Base = App.Vector(0, 0, 7)
        self.doc.recompute()
        obj = fill.create(source)
        self.assertTrue(obj.Reached, obj.Summary)
        for vertex in source.Shape.Vertexes:
            place = part.Placement.multVec(vertex.Point)
            self.assertLess(min((place - other.Point).Length for other in obj.Shape.Vertexes), 1e-5)

    def test_a_link_is_filled_where_it_stands(self):
        source, _ = self.open_block()
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = source
        link.Placement.Base.z = 100
        self.doc.recompute()
        obj = fill.create(link)
        self.assertTrue(obj.Reached, obj.Summary)
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMin, 100, delta=1e-6)


class Following(FillCase):
    def test_each_change_asks_for_a_recompute(self):
        source, loops = self.open_block()
        obj = fill.create(source)
        changes = {name: 0.5 for name, *_ in fill.TOLERANCES}
        changes.update(
            Target="G0",
            KeepAnyway=True,
            Edges=(source, loops[0]),
            Face=(source, ["Face1"]),
            Source=None,
        )
        for name, value in changes.items():
            with self.subTest(name):
                obj.purgeTouched()
                setattr(obj, name, value)
                self.assertIn("Touched", obj.State)

    def test_a_changed_source_is_followed(self):
        source, _ = self.open_block()
        obj = fill.create(source)
        source.Shape = models.open_block(1, size=30.0)
        self.doc.recompute()
        self.assertEqual((obj.Filled, obj.Reached), (1, True))
        self.assertAlmostEqual(
            obj.Shape.Volume, models.rounded_block(size=30.0).Volume, delta=BALL_DELTA
        )
        source.Shape = models.rounded_block()
        self.doc.recompute()
        self.assertNotFilled(obj, "Open has no hole: no free edges form a closed loop.")
        source.Shape = models.open_block(1)
        self.doc.recompute()
        self.assertEqual((fill.error_text(obj), obj.Filled), ("", 1))

    def test_cancelling_keeps_the_results_and_progress_rises(self):
        source, _ = self.open_block(3)
        obj, seen = fill.create(source), []
        report = obj.Report
        for answer in (lambda share: False, seen.append):
            with mock.patch.object(
                hooks, "progress", lambda text, answer=answer: contextlib.nullcontext(answer)
            ):
                obj.touch()
                self.doc.recompute()
            if not seen:
                self.assertOutdated(obj)
                self.assertEqual(obj.Report, report)
        self.assertEqual((fill.error_text(obj), seen), ("", sorted(seen)))
        self.assertTrue(len(seen) > 2 and 0 <= seen[0] and 0.8 < seen[-1] <= 1, seen)


class Errors(FillCase):
    def test_sources_edges_and_faces_that_are_of_no_use(self):
        block = self.block()
        self.assertNotFilled(fill.create(block), "Block has no hole")
        source, loops = self.open_block()
        inner = next(
            "Edge%d" % n
            for n in range(1, len(source.Shape.Edges) + 1)
            if "Edge%d" % n not in loops[0]
        )
        obj = fill.create(source, edges=[inner])
        self.assertNotFilled(obj, "%s does not belong to a hole" % inner)
        self.assertNotFilled(fill.create(source, edges=["Edge999"]), "Open has no Edge999")
        self.assertNotFilled(fill.create(source, face="Face999"), "Open has no Face999")
        can = models.add(self.doc, Part.makeCylinder(3, 10), "Can")
        self.assertNotFilled(
            fill.create(can, face="Face1"), "Face1: the face bounds the hole on one side only"
        )
        obj = fill.create(block, face="Face1")
        obj.Face = (block, ["Face1", "Face2"])
        self.doc.recompute()
        self.assertNotFilled(obj, "2 faces are chosen: only one can be replaced at a time")
        obj.Face = (source, ["Face1"])
        self.doc.recompute()
        self.assertNotFilled(obj, "Face names Open, which is not the source Block")
        line = models.add(self.doc, Part.makeLine((0, 0, 0), (1, 0, 0)), "Line")
        self.assertNotFilled(fill.create(line), "Line has no faces")
        self.assertEqual(fill.holes_of(fill.create(line))[:2], ([], []))

    def test_a_deleted_source_and_bad_limits(self):
        source, _ = self.open_block()
        obj = fill.create(source)
        obj.AngleTolerance = 0
        self.doc.recompute()
        self.assertTrue(obj.Summary.startswith("Not filled: "), obj.Summary)
        self.assertTrue(obj.Shape.isNull())
        obj.AngleTolerance = 0.01
        self.doc.removeObject(source.Name)
        obj.touch()
        self.doc.recompute()
        self.assertNotFilled(obj, "The source was deleted")

    def test_bad_arguments_leave_nothing_behind(self):
        source, loops = self.open_block()
        for wrong, text in (
            ({"target": "G3"}, "target 'G3'"),
            ({"gap_mm": -1.0}, "gap_mm = -1.0"),
            ({"angle_deg": math.nan}, "angle_deg = nan"),
            ({"corner_deg": math.inf}, "corner_deg = inf"),
            ({"profile": "class-b"}, "profile 'class-b'"),
            ({"edges": loops[0], "face": "Face1"}, "'Face1'"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                fill.create(source, **wrong)
        with self.assertRaisesRegex(TypeError, "'crease_deg'"):
            fill.create(source, crease_deg=1)
        for wrong, text in (
            ({"edges": "Edge1"}, "edges = 'Edge1': a list is needed"),
            ({"edges": [None]}, r"edges\[0\] = None: a name is needed"),
            ({"face": ["Face1"]}, r"face = \['Face1'\]: a name is needed"),
            ({"face": 1.0}, "face = 1.0: a name is needed"),
        ):
            with self.assertRaisesRegex(TypeError, text):
                fill.create(source, **wrong)
        self.assertEqual(self.doc.Objects, [source])


class Saving(FillCase):
    def test_results_survive_without_the_compiled_module_and_undo_is_one_step(self):
        source, loops = self.open_block(2)
        self.assertOneStep(lambda: fill.create(source, edges=loops[1], profile="vda"), [source])
        obj = self.doc.UmbrellaFill
        names = (
            "Report",
            "Summary",
            "Filled",
            "Reached",
            "Target",
            "SeamwrightVersion",
            "NewFaces",
            "MaxCurvature",
        )
        faces = len(obj.Shape.Faces)
        obj.removeProperty("KeepAnyway")
        with self.opened_without_kernel(obj, names, lambda: fill.create(self.doc.Open)) as again:
            self.assertTrue(fill.is_fill(again))
            self.assertEqual((again.GapTolerance.Value, again.KeepAnyway), (0.02, False))
            self.assertEqual(
                (len(again.Shape.Faces), elements.names(again, "Edges")), (faces, loops[1])
            )
        self.doc.Open.Shape = models.open_block(2, size=26.0)
        self.doc.recompute()
        if fill.error_text(
            again
        ):  # FreeCAD 1.1 marks edges that it does not know again in another shape
            self.assertNotFilled(again, "has no ?Edge")
            elements.set_names(again, "Edges", loops[1])
            self.doc.recompute()
        self.assertEqual((fill.error_text(again), again.Filled), ("", 1))
