# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seam Repair, on FreeCAD's console; run by run_freecad.py."""

import contextlib
import itertools
import json
import math
import os
import tempfile
from unittest import mock

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase
from match_cases import text_of

from freecad.seamwright.document import analysis, elements, repair, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.plain import repair_text


def seam_angles(shape):
    """{edge number: largest angle of the normals of its two faces at points of it, in degrees}."""
    found = {}
    for number, edge in enumerate(shape.Edges, 1):
        faces = [face for face in shape.Faces if any(edge.isSame(other) for other in face.Edges)]
        if len(faces) == 2:
            low, high = edge.ParameterRange
            points = [edge.valueAt(low + (high - low) * place / 60) for place in range(61)]
            found[number] = max(_angle_deg(faces, point) for point in points)
    return found


def _angle_deg(faces, point):
    one, other = (face.normalAt(*face.Surface.parameter(point)) for face in faces)
    return math.degrees(math.asin(min(1.0, one.cross(other).Length)))


def candidates(obj):
    """(report, text) of the seams that a repair would treat."""
    plan = Plan(obj, {}, repair.candidates_job)
    plan.end(plan.run(None), None)
    return plan.results()


def poles_of(face):
    return [pole for line in face.Surface.getPoles() for pole in line]


class RepairCase(DocumentCase):
    def panel(self, **options):
        obj = models.add(self.doc, models.broken_panel(**options), "Panel")
        self.doc.recompute()
        return obj

    def assertNotRepaired(self, obj, text):
        self.assertWithout(obj, text)
        self.assertFalse(obj.Changed)
        self.assertTrue(obj.Shape.isNull())
        self.assertTrue(obj.Summary.startswith("Not repaired: "), obj.Summary)
        self.assertIn(text, obj.Summary)


class Results(RepairCase):
    def test_all_defects_are_repaired(self):
        panel = self.panel()
        before = seam_angles(panel.Shape)
        obj = repair.create(panel)
        self.assertEqual(repair.error_text(obj), "")
        self.assertEqual(
            (obj.Wanted, obj.Repaired, obj.DefectsBefore, obj.DefectsAfter), (7, 7, 7, 0)
        )
        self.assertTrue(obj.Changed)
        self.assertEqual(obj.Shape.ShapeType, "Shell")
        self.assertTrue(obj.Shape.isValid())
        self.assertAlmostEqual(obj.MaxAngleBefore.Value, max(before.values()), delta=0.02)
        after = seam_angles(obj.Shape)
        self.assertEqual(len(after), 7)
        self.assertLess(max(after.values()), 0.1)
        self.assertLessEqual(max(after.values()), obj.MaxAngleAfter.Value + 1e-5)
        self.assertTrue(
            obj.Summary.startswith("7 of 7 seams repaired to G1; 6 faces moved, poles by up to 0."),
            obj.Summary,
        )

    def test_faces_and_edges_keep_their_numbers(self):
        panel = self.panel()
        obj = repair.create(panel)
        for kind in ("Faces", "Edges"):
            old, new = getattr(panel.Shape, kind), getattr(obj.Shape, kind)
            self.assertEqual(len(old), len(new))
            for one, other in zip(old, new):
                self.assertLess((one.CenterOfMass - other.CenterOfMass).Length, 1.0)

    def test_no_pole_moves_further_than_allowed(self):
        panel = self.panel()
        obj = repair.create(panel, max_move_mm=0.05)
        self.assertEqual(repair.error_text(obj), "")
        self.assertLess(obj.Repaired, obj.Wanted)
        self.assertLessEqual(obj.LargestMove.Value, 0.05)
        reasons = [
            seam["reason"] for seam in repair.report_of(obj)["seams"] if not seam["repaired"]
        ]
        self.assertTrue(reasons and all(reasons))
        obj.MaxMove = 0  # by the size of the face
        self.doc.recompute()
        self.assertEqual(obj.Repaired, 7)
        self.assertGreater(obj.LargestMove.Value, 0.05)

    def test_chosen_seams_alone(self):
        panel = self.panel()
        angles = seam_angles(panel.Shape)
        chosen = max(angles, key=angles.get)
        obj = repair.create(panel, edges=["Edge%d" % chosen])
        self.assertEqual((obj.Wanted, obj.Repaired), (1, 1))
        self.assertLess(seam_angles(obj.Shape)[chosen], obj.AngleTolerance.Value)
        (seam,) = repair.report_of(obj)["seams"]
        self.assertEqual(seam["before"]["edges"], [chosen])
        same = repair.prepare(panel, edges=[chosen], fixed_faces=(1,))
        self.assertEqual(elements.names(same, "Edges"), ["Edge%d" % chosen])
        self.assertEqual(elements.names(same, "FixedFaces"), ["Face1"])

    def test_fixed_faces_stay(self):
        panel = self.panel()
        obj = repair.create(panel, fixed_faces=["Face3", "Face4"])
        self.assertGreater(obj.Repaired, 0)
        moved = {move["face"] for move in repair.report_of(obj)["moves"]}
        self.assertTrue(moved)
        for number, (old, new) in enumerate(zip(panel.Shape.Faces, obj.Shape.Faces), 1):
            same = len(poles_of(old)) == len(poles_of(new)) and all(
                one.isEqual(other, 1e-12) for one, other in zip(poles_of(old), poles_of(new))
            )
            self.assertEqual(same, number not in moved, number)
        self.assertFalse(moved & {3, 4})
        between = next(
            seam for seam in repair.report_of(obj)["seams"] if seam["before"]["faces"] == [3, 4]
        )
        self.assertFalse(between["repaired"])
        self.assertTrue(between["reason"])

    def test_curvature_for_g2(self):
        obj = repair.create(self.panel(across=2, along=1), target="G2", max_move_mm=2.0)
        self.assertEqual((obj.Wanted, obj.Repaired), (1, 1), obj.Summary)
        (seam,) = repair.report_of(obj)["seams"]
        self.assertLessEqual(seam["after"]["curvature_rel"]["upper"], 0.02)

    def test_a_model_without_defects_is_unchanged_and_says_so(self):
        for shape, text in (
            (models.broken_panel(noise_mm=0.0), "no seam falls short of G1"),
            (Part.makeBox(1, 2, 3), "no seam falls short of G1"),
            (Part.makePlane(1, 1), "no two faces share an edge"),
        ):
            with self.subTest(text, shape=shape.ShapeType):
                source = models.add(self.doc, shape, "Good")
                obj = repair.create(source)
                self.assertEqual(repair.error_text(obj), "")
                self.assertIn(text, obj.Summary)
                self.assertEqual((obj.Changed, obj.Wanted, obj.MovedFaces), (False, 0, 0))
                self.assertTrue(obj.Shape.isPartner(source.Shape))

    def test_seams_that_nothing_can_mend_keep_their_reason(self):
        prism = self.prism()  # its one defect lies between planes
        obj = repair.create(prism)
        self.assertEqual(repair.error_text(obj), "")
        self.assertEqual((obj.Wanted, obj.Repaired, obj.Changed), (1, 0, False))
        (row,) = repair_text.build_rows(repair.report_of(obj))
        self.assertRegex(row.cells[-1], r"Face\d+.*plane")
        self.assertTrue(obj.Shape.isPartner(prism.Shape))

    def test_the_source_is_left_as_it_was(self):
        panel = self.panel()
        before = text_of(panel.Shape)
        repair.create(panel)
        self.assertEqual(text_of(panel.Shape), before)

    def test_a_source_in_a_part_is_repaired_where_it_stands(self):
        panel = self.panel()
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(panel)
        part.Placement = App.Placement(
            App.Vector(100, 20, 3), App.Rotation(App.Vector(1, 2, 3), 40)
        )
        panel.Placement.Base = App.Vector(0, 0, 7)
        self.doc.recompute()
        obj = repair.create(panel)
        self.assertEqual(obj.Repaired, 7, obj.Summary)
        for old, new in zip(panel.Shape.Vertexes, obj.Shape.Vertexes):
            self.assertLess((part.Placement.multVec(old.Point) - new.Point).Length, 1.0)

    def test_a_placed_solid_stays_a_solid_where_it_stands(self):
        block = models.add(self.doc, models.broken_block(), "Block")
        block.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 2, 3), 50))
        self.doc.recompute()
        obj = repair.create(block, max_move_mm=1.0)
        self.assertEqual((obj.Wanted, obj.Repaired, obj.MovedFaces), (1, 1, 1), obj.Summary)
        self.assertEqual(obj.Shape.ShapeType, "Solid")
        self.assertTrue(obj.Shape.isValid() and obj.Shape.isClosed())
        for old, new in zip(block.Shape.Vertexes, obj.Shape.Vertexes):
            self.assertLess((old.Point - new.Point).Length, 1e-2, "within the gap tolerance")
        block.Placement.Base.x = 50
        self.doc.recompute()
        self.assertAlmostEqual(obj.Shape.CenterOfMass.x, block.Shape.CenterOfMass.x, delta=0.1)


class Options(RepairCase):
    def test_defaults_are_those_of_the_kernel(self):
        obj = repair.create(self.panel())
        self.assertEqual(
            (obj.Target, obj.MaxMove.Value, repair.tolerances(obj)["match_mm"]), ("G1", 0.0, 0.0)
        )

    def test_each_change_asks_for_a_recompute(self):
        panel = self.panel()
        obj = repair.create(panel)
        changes = {name: 0.5 for name, *_ in repair.TOLERANCES}
        changes.update(
            Target="G2",
            MaxMove=5,
            Edges=(panel, ["Edge1"]),
            FixedFaces=(panel, ["Face1"]),
            Source=None,
        )
        for name, value in changes.items():
            with self.subTest(name):
                obj.purgeTouched()
                setattr(obj, name, value)
                self.assertIn("Touched", obj.State)

    def test_a_changed_source_is_followed(self):
        panel = self.panel()
        obj = repair.create(panel)
        panel.Shape = models.broken_panel(noise_mm=0.1, seed=3)
        self.doc.recompute()
        self.assertEqual(obj.Repaired, obj.Wanted)
        self.assertLess(max(seam_angles(obj.Shape).values()), obj.AngleTolerance.Value)
        self.assertAlmostEqual(
            obj.MaxAngleBefore.Value, max(seam_angles(panel.Shape).values()), delta=0.02
        )
        panel.Shape = models.broken_panel(noise_mm=0.0)
        self.doc.recompute()
        self.assertIn("Nothing to repair", obj.Summary)

    def test_an_edited_option_is_followed(self):
        panel = self.panel()
        obj = repair.create(panel)
        obj.AngleTolerance = 4.0
        self.doc.recompute()
        self.assertEqual((obj.Wanted, obj.Changed), (0, False))
        obj.CreaseAngle = 0.05  # FreeCAD accepts what the kernel does not
        self.doc.recompute()
        self.assertNotRepaired(obj, "0.05")

    def test_candidates_are_those_that_are_treated(self):
        panel = self.panel()
        for edges in ((), ("Edge1", "Edge5")):
            obj = repair.prepare(panel, edges=edges, crease_deg=60.0, angle_deg=1.0)
            report, text = candidates(obj)
            self.assertEqual(obj.Report, "")
            self.doc.recompute()
            done = repair.report_of(obj)
            if repair.error_text(obj):  # an edge of the border is not a seam
                continue
            self.assertEqual(
                [seam["before"] for seam in report["seams"]],
                [seam["before"] for seam in done["seams"]],
            )
            self.assertIn("to repair to G1", text)

    def test_cancelling_keeps_the_results(self):
        obj = repair.create(self.panel())
        report = obj.Report
        with mock.patch.object(
            hooks, "progress", lambda text: contextlib.nullcontext(lambda fraction: False)
        ):
            obj.touch()
            self.doc.recompute()
        self.assertOutdated(obj)
        self.assertEqual((obj.Report, obj.Repaired, len(obj.Shape.Faces)), (report, 7, 6))

    def test_progress_rises_to_the_end(self):
        seen = []
        with mock.patch.object(hooks, "progress", lambda text: contextlib.nullcontext(seen.append)):
            repair.create(self.panel(across=2, along=1))
        self.assertTrue(seen)
        self.assertEqual((seen, seen[-1]), (sorted(seen), 1.0))


class Errors(RepairCase):
    def test_a_deleted_source(self):
        obj = repair.create(self.panel())
        self.doc.removeObject("Panel")
        obj.touch()
        self.doc.recompute()
        self.assertNotRepaired(obj, "The source was deleted")

    def test_a_source_without_shape_or_faces_and_back(self):
        panel = self.panel()
        obj = repair.create(panel)
        line = Part.makeLine((0, 0, 0), (1, 0, 0))
        for shape, text in ((Part.Shape(), "Panel has no shape"), (line, "Panel has no faces")):
            panel.Shape = shape
            self.doc.recompute()
            self.assertNotRepaired(obj, text)
            self.assertEqual(
                (obj.Wanted, obj.LargestMove.Value, obj.MaxAngleBefore.Value), (0, 0.0, 0.0)
            )
        panel.Shape = models.broken_panel()
        self.doc.recompute()
        self.assertEqual((repair.error_text(obj), obj.Repaired), ("", 7))

    def test_faces_and_edges_that_are_not_there(self):
        panel, box = self.panel(), self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = repair.create(panel, edges=["Edge99"])
        self.assertNotRepaired(obj, "Panel has no Edge99")
        with self.assertRaisesRegex(sources.SourceError, "Panel has no Edge99"):
            candidates(obj)
        self.assertNotRepaired(
            repair.create(panel, fixed_faces=["Edge1"]),
            "Edge1 is not a face: name one, such as Face1",
        )
        self.assertNotRepaired(
            repair.create(panel, edges=["Face1"]),
            "Face1 is not an edge: name one, such as Edge1",
        )
        obj.Edges = (box, ["Edge1"])
        self.doc.recompute()
        self.assertNotRepaired(obj, "Edges names Box, which is not the source Panel")

    def test_an_edge_that_is_no_seam(self):
        panel = self.panel()
        border = next(n for n in range(1, 18) if n not in seam_angles(panel.Shape))
        self.assertNotRepaired(repair.create(panel, edges=["Edge%d" % border]), "Edge%d" % border)

    def test_bad_arguments_leave_nothing_behind(self):
        panel = self.panel()
        for wrong, text in (
            ({"target": "G3"}, "target 'G3'"),
            ({"max_move_mm": -1.0}, "max_move_mm"),
            ({"max_move_mm": math.inf}, "max_move_mm"),
            ({"gap_mm": math.nan}, "gap_mm"),
            ({"profile": "class-b"}, "profile 'class-b'"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                repair.create(panel, **wrong)
        with self.assertRaisesRegex(TypeError, "'gap'"):
            repair.create(panel, gap=0.1)
        for name in ("edges", "fixed_faces"):
            for wrong, text in (
                ("Edge1", "%s = 'Edge1': a list is needed"),
                (1, "%s = 1: a list is needed"),
                (None, "%s = None: a list is needed"),
                ([1, 2.5], r"%s\[1\] = 2.5: a name is needed"),
                ([True], r"%s\[0\] = True: a name is needed"),
                ([("Edge1",)], r"%s\[0\] = \('Edge1',\): a name is needed"),
            ):
                with self.assertRaisesRegex(TypeError, text % name):
                    repair.create(panel, **{name: wrong})
        self.assertEqual(self.doc.Objects, [panel])


class Saving(RepairCase):
    def test_results_survive_without_the_compiled_module(self):
        obj = repair.create(self.panel(), fixed_faces=["Face1"], max_move_mm=1.0)
        names = (
            "Report",
            "Summary",
            "Changed",
            "Wanted",
            "Repaired",
            "Target",
            "SeamwrightVersion",
        )
        report = obj.Report
        with self.opened_without_kernel(obj, names, lambda: repair.create(self.doc.Panel)) as again:
            self.assertTrue(repair.is_repair(again))
            self.assertEqual((again.MaxMove.Value, len(again.Shape.Faces)), (1.0, 6))
            self.assertEqual(elements.names(again, "FixedFaces"), ["Face1"])
        self.doc.Panel.Shape = models.broken_panel(seed=11)
        self.doc.recompute()
        self.assertEqual(repair.error_text(again), "")
        self.assertNotEqual(again.Report, report)

    def test_missing_properties_are_added(self):
        obj = repair.create(self.panel())
        obj.removeProperty("MaxMove")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
        self.assertEqual(self.doc.SeamRepair.MaxMove.Value, 0)

    def test_undo_takes_the_repair_away_as_one_step(self):
        panel = self.panel()
        self.assertOneStep(lambda: repair.create(panel), [panel])
        self.assertEqual(self.doc.SeamRepair.Repaired, 7)

    def test_an_analysis_of_the_repair_agrees(self):
        obj = repair.create(self.panel())
        found = analysis.create([obj])
        self.assertEqual((found.Defects, found.Passed), (0, True))
        self.assertAlmostEqual(found.MaxAngle.Value, obj.MaxAngleAfter.Value, delta=1e-9)
        report = json.loads(obj.Report)
        seams = {tuple(seam["edges"]): seam for seam in analysis.report_of(found)["seams"]}
        for seam, name in itertools.product(report["seams"], ("gap_mm", "angle_deg")):
            again = seams[tuple(seam["after"]["edges"])]
            self.assertAlmostEqual(seam["after"][name]["upper"], again[name]["upper"], delta=1e-9)
