# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object, on FreeCAD's console; run by run_freecad.py."""

import contextlib
import csv
import json
import math
import os
import sys
import tempfile
import unittest
from unittest import mock

import FreeCAD as App
import models
import Part

from freecad.seamwright.document import analysis
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.plain import export, kernel

ABSENT = mock.patch.dict(sys.modules, seamwright=None)


class DocumentCase(unittest.TestCase):
    """Each test has a document of its own."""

    def setUp(self):
        self.doc = App.newDocument("Test")

    def tearDown(self):
        App.closeDocument(self.doc.Name)

    def prism(self):
        return models.add(self.doc, models.three_classes(), "Prism")

    @contextlib.contextmanager
    def opened_without_kernel(self, obj, names, make):
        """The object, saved and opened again where the compiled module is missing: it has the
        properties ``names`` as they were. In the end it cannot be computed, and ``make`` makes no
        other.
        """
        name, kept = obj.Name, {each: getattr(obj, each) for each in names}
        touched = (
            "Touched" in obj.State
        )  # FreeCAD 1.0 marks what was redone as such, whose ever it is
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with ABSENT:
                self.doc = App.openDocument(path)
                again = self.doc.getObject(name)
                self.assertEqual("Touched" in again.State, touched)
                self.assertEqual({each: getattr(again, each) for each in kept}, kept)
                yield again
                again.touch()
                self.doc.recompute()
                self.assertFailed(again, "cannot be loaded")
                with self.assertRaises(kernel.KernelUnavailable):
                    make()

    def assertOneStep(self, make, before):
        """``make`` can be undone and done again as one step; ``before``: the objects that there
        were."""
        self.doc.UndoMode = 1
        steps = self.doc.UndoCount
        self.doc.openTransaction("One step")
        make()
        self.doc.commitTransaction()
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.doc.undo()
        self.assertEqual(self.doc.Objects, before)
        self.doc.redo()

    def assertFailed(self, obj, text):
        """The object is marked as in error, and says why."""
        self.assertIn("Invalid", obj.State)
        self.assertIn(text, analysis.error_text(obj))

    def assertWithout(self, obj, text):
        """The object has no result, and says why."""
        self.assertEqual(obj.Outcome, "without result")
        self.assertIn(text, analysis.error_text(obj))

    def assertOutdated(self, obj):
        """A run was cancelled, which is not an error. The next recompute runs it again."""
        self.assertNotIn("Invalid", obj.State)
        self.assertEqual(
            analysis.error_text(obj), "Cancelled; the results are those of the last complete run."
        )
        self.assertTrue(obj.Proxy.mustExecute(obj))

    @contextlib.contextmanager
    def quiet(self):
        """FreeCAD writes of no failure meanwhile."""
        kept = [os.dup(number) for number in (1, 2)]
        with tempfile.TemporaryFile() as file:
            for number in (1, 2):
                os.dup2(file.fileno(), number)
            try:
                yield
            finally:
                for number, old in zip((1, 2), kept):
                    os.dup2(old, number)
                    os.close(old)
            file.seek(0)
            written = file.read().decode(errors="replace")
        for word in ("Traceback", "Error", "failed"):
            self.assertNotIn(word, written)


class Results(DocumentCase):
    def test_all_three_classes_are_counted(self):
        obj = analysis.create([self.prism()])
        self.assertNotIn("Invalid", obj.State)
        self.assertEqual((obj.Seams, obj.Defects, obj.Creases, obj.OpenEdges), (18, 1, 15, 0))
        self.assertAlmostEqual(obj.MaxAngle.Value, models.KINK_DEG, delta=1e-6)
        self.assertFalse(obj.Passed)
        self.assertTrue(obj.Summary.startswith("18 seams: 1 defect, 15 creases, 2 smooth;"))

    def test_the_shape_is_the_seams_in_the_order_of_the_report(self):
        prism = self.prism()
        obj = analysis.create([prism])
        seams = analysis.report_of(obj)["seams"]
        self.assertEqual(len(obj.Shape.Edges), len(seams))
        for edge, seam in zip(obj.Shape.Edges, seams):
            source = prism.Shape.Edges[seam["edges"][0] - 1]
            self.assertAlmostEqual(edge.Length, source.Length, delta=1e-9)
            self.assertLess((edge.CenterOfMass - source.CenterOfMass).Length, 1e-9)

    def test_numbers_are_those_freecad_shows(self):
        prism = self.prism()
        report = analysis.report_of(analysis.create([prism]))
        defect = next(seam for seam in report["seams"] if seam["class"] == "defect")
        edge = prism.Shape.Edges[defect["edges"][0] - 1]
        self.assertEqual({(vertex.X, vertex.Y) for vertex in edge.Vertexes}, {(10.0, 0.0)})
        for number in defect["faces"]:
            face = prism.Shape.Faces[number - 1]
            self.assertTrue(any(edge.isSame(other) for other in face.Edges))

    def test_the_kernel_is_the_one_of_this_opencascade(self):
        module = kernel.load(Part.OCC_VERSION)
        self.assertEqual(module.OCCT_VERSION, Part.OCC_VERSION)
        self.assertEqual(kernel.built_for()["occt"], Part.OCC_VERSION)
        with self.assertRaisesRegex(kernel.KernelUnavailable, "OpenCASCADE 9.9.9"):
            kernel.load("9.9.9")

    def test_deleted_sources_are_an_error_and_not_everything(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.addObject("Part::Sphere", "Sphere")
        self.doc.recompute()
        obj = analysis.create([box], self.doc)
        self.assertEqual((obj.Seams, analysis.error_text(obj)), (12, ""))
        self.doc.removeObject("Box")
        for _ in range(2):
            obj.touch()
            self.doc.recompute()
            self.assertIn("Box was deleted", analysis.error_text(obj))
            self.assertEqual((obj.Seams, obj.Analysed), (0, []))
        obj.Sources = [self.doc.Sphere]
        self.doc.recompute()
        self.assertEqual((analysis.error_text(obj), obj.Analysed), ("", [self.doc.Sphere]))
        obj.Sources = []
        self.doc.recompute()
        self.assertEqual((analysis.error_text(obj), obj.Analysed), ("", [self.doc.Sphere]))

    def test_the_source_is_left_as_it_was(self):
        prism = self.prism()
        self.doc.recompute()
        before, shape = prism.Shape.exportBrepToString(), prism.Shape
        analysis.create([prism], level="G2")
        self.assertEqual(prism.Shape.exportBrepToString(), before)
        self.assertTrue(prism.Shape.isPartner(shape))


class Tolerances(DocumentCase):
    def test_defaults(self):
        obj = analysis.create([self.prism()])
        self.assertEqual(
            analysis.tolerances(obj),
            {
                "gap_mm": 0.01,
                "angle_deg": 0.1,
                "curvature_rel": 0.02,
                "flat_radius_mm": 1e5,
                "crease_deg": 5.0,
                "match_mm": 0.0,
                "level": "G1",
            },
        )

    def test_a_profile_fills_in_what_is_not_given(self):
        obj = analysis.create([self.prism()], profile="class-a", angle_deg=0.5)
        self.assertEqual((obj.GapTolerance.Value, obj.AngleTolerance.Value), (0.001, 0.5))

    def test_results_count_certainty_and_matches(self):
        obj = analysis.create([self.prism()])
        seams = analysis.report_of(obj)["seams"]
        self.assertEqual(obj.Uncertain, sum(not seam["certified"] for seam in seams))
        self.assertEqual(obj.Matched, 0)

    def test_a_wider_angle_passes(self):
        obj = analysis.create([self.prism()], angle_deg=2.0)
        self.assertEqual((obj.Defects, obj.Passed), (0, True))

    def test_each_change_asks_for_a_recompute(self):
        obj = analysis.create([self.prism()])
        changes = {name: 0.5 for name, *_ in analysis.TOLERANCES}
        for name, value in {**changes, "Level": "G2", "Sources": []}.items():
            with self.subTest(name):
                self.doc.recompute()
                self.assertNotIn("Touched", obj.State)
                setattr(obj, name, value)
                self.assertIn("Touched", obj.State)

    def test_crease_angle_and_level_decide_the_class(self):
        obj = analysis.create([self.prism()], crease_deg=0.5)
        self.assertEqual((obj.Defects, obj.Creases), (0, 16))
        obj.CreaseAngle = 5.0
        obj.Level = "G2"
        self.doc.recompute()
        self.assertEqual(obj.Defects, 3)  # the rounding joins the flat sides without curvature
        self.assertEqual(analysis.report_of(obj)["freecad"]["level"], "G2")

    def test_bad_tolerances_are_refused(self):
        prism = self.prism()
        for value in (-1.0, math.nan, math.inf):
            with self.assertRaisesRegex(ValueError, "gap_mm"):
                analysis.create([prism], gap_mm=value)
        with self.assertRaisesRegex(ValueError, "level 'G9'"):
            analysis.create([prism], level="G9")
        with self.assertRaisesRegex(ValueError, "profile 'class-b'"):
            analysis.create([prism], profile="class-b")
        with self.assertRaisesRegex(TypeError, "'gap'"):
            analysis.create([prism], gap=0.1)
        self.assertEqual(self.doc.Objects, [prism])

    def test_a_bad_property_is_an_error_of_the_object(self):
        obj = analysis.create([self.prism()])
        obj.AngleTolerance = -1.0
        self.doc.recompute()
        self.assertWithout(obj, "-1")
        self.assertEqual((obj.Seams, obj.Passed), (0, False))
        self.assertTrue(obj.Summary.startswith("Not analysed: "))
        obj.AngleTolerance = 0.1
        self.doc.recompute()
        self.assertEqual((obj.Seams, analysis.error_text(obj)), (18, ""))


class Cancelling(DocumentCase):
    def test_a_cancelled_run_keeps_the_results(self):
        obj = analysis.create([self.prism()])
        report = obj.Report
        cancel = contextlib.nullcontext(lambda fraction: False)
        with mock.patch.object(hooks, "progress", lambda text: cancel), self.quiet():
            obj.touch()
            self.doc.recompute()
        self.assertOutdated(obj)
        self.assertEqual(obj.Report, report)
        self.doc.recompute()
        self.assertEqual((obj.Outcome, analysis.error_text(obj), obj.Seams), ("done", "", 18))

    def test_a_cancelled_first_run_says_that_there_are_no_results(self):
        with mock.patch.object(
            hooks, "progress", lambda text: contextlib.nullcontext(lambda fraction: False)
        ):
            with self.quiet():
                obj = analysis.create([self.prism()])
        self.assertEqual((obj.Report, obj.Summary), ("", "Cancelled; there are no results yet."))
        self.assertEqual(analysis.error_text(obj), obj.Summary)
        self.doc.recompute()
        self.assertEqual((obj.Outcome, obj.Seams), ("done", 18))

    def test_progress_rises_to_the_end(self):
        seen = []
        watch = contextlib.nullcontext(seen.append)
        with mock.patch.object(hooks, "progress", lambda text: watch):
            analysis.create([self.prism()])
        self.assertTrue(seen)
        self.assertTrue(all(0 <= fraction <= 1 for fraction in seen))
        self.assertEqual(seen, sorted(seen))


class Saving(DocumentCase):
    def setUp(self):
        super().setUp()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def reopen(self, obj):
        name = obj.Name
        path = os.path.join(self.folder.name, "saved.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        return self.doc.getObject(name)

    def test_results_survive_without_the_compiled_module(self):
        obj = analysis.create([self.prism()], gap_mm=0.05)
        report, names = obj.Report, ("Report", "Summary", "Seams", "SeamwrightVersion")
        with self.opened_without_kernel(obj, names, analysis.create) as again:
            self.assertTrue(analysis.is_analysis(again))
            self.assertEqual((again.GapTolerance.Value, len(again.Shape.Edges)), (0.05, 18))
        self.assertEqual(again.Report, report)
        again.touch()
        self.doc.recompute()
        self.assertEqual((again.Seams, analysis.error_text(again)), (18, ""))

    def test_a_reopened_analysis_follows_its_source(self):
        box = self.doc.addObject("Part::Box", "Box")
        again = self.reopen(analysis.create([box]))
        self.doc.Box.Length = 25
        self.doc.recompute()
        self.assertAlmostEqual(again.Shape.BoundBox.XMax, 25, delta=1e-6)

    def test_missing_properties_are_added(self):
        obj = analysis.create([self.prism()])
        obj.removeProperty("FlatRadius")
        again = self.reopen(obj)
        self.assertEqual(again.FlatRadius.Value, 1e5)
        self.assertEqual(again.Seams, 18)


class Exporting(DocumentCase):
    def test_csv_and_json(self):
        obj = analysis.create([self.prism()])
        report = analysis.report_of(obj)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("seams.csv", "seams.json"):
                export.write(report, os.path.join(folder, name))
            with open(os.path.join(folder, "seams.csv"), encoding="utf-8") as file:
                self.assertEqual(len(list(csv.DictReader(file))), 18)
            with open(os.path.join(folder, "seams.json"), encoding="utf-8") as file:
                self.assertEqual(json.load(file)["schema"], "seamwright.analysis/1")
