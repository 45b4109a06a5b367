# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computations apart from the document, on FreeCAD's console; run by run_freecad.py."""

import threading

import models
import Part
from document_cases import DocumentCase

from freecad.seamwright.document import analysis, corner, expressions, feature, fill, match, repair
from freecad.seamwright.document.plan import Plan


def run_in_thread(plan):
    """(found, error) of a plan that another thread ran."""
    result = [None, None]

    def work():
        try:
            result[0] = plan.run(lambda fraction: True)
        except Exception as error:
            result[1] = error

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    return result


def figures(obj):
    """All that is kept of a computation and told to the user, with the shape as numbers."""
    kept = {
        name: str(getattr(obj, name))
        for name in obj.PropertiesList
        if obj.getGroupOfProperty(name) == "Result"
    }
    return kept, len(obj.Shape.Faces), len(obj.Shape.Edges), round(obj.Shape.Length, 9)


class Plans(DocumentCase):
    def makers(self):
        """Callables that make one object of each kind, not computed yet."""
        panel = models.add(self.doc, models.broken_panel(), "Panel")
        cube = models.add(self.doc, Part.makeBox(10, 10, 10), "Cube")
        block = models.add(self.doc, models.open_block(1), "Block")
        left, right = (
            models.add(self.doc, each, name)
            for each, name in zip(models.two_sheets(), ("Left", "Right"))
        )
        self.doc.recompute()
        return [
            lambda: analysis.prepare([panel], self.doc),
            lambda: repair.prepare(panel),
            lambda: fill.prepare(block),
            lambda: corner.prepare(cube, "Vertex1"),
            lambda: match.prepare((left, "Face1"), (right, "Face1")),
        ]

    def test_a_thread_finds_what_a_recompute_finds(self):
        for make in self.makers():
            obj = make()
            with self.subTest(obj.Name), self.quiet():
                plan = Plan(obj, {})
                found = run_in_thread(plan)
                self.assertEqual((obj.Report, obj.Outcome), ("", ""))
                plan.apply(*found)
                kept = figures(obj)
                self.assertEqual(
                    (obj.Outcome, obj.State, feature.properties.error_text(obj)),
                    ("done", ["Up-to-date"], ""),
                )
                obj.touch()
                self.doc.recompute()
                self.assertEqual(figures(obj), kept)

    def test_values_are_written_when_it_is_applied(self):
        obj = self.makers()[1]()
        plan = Plan(obj, {"MaxMove": 0.05, "Target": "G1"})
        self.assertEqual(plan.values, {"MaxMove": 0.05})
        found = run_in_thread(plan)
        self.assertEqual(obj.MaxMove.Value, 0)
        plan.apply(*found)
        self.assertEqual((obj.MaxMove.Value, obj.Outcome), (0.05, "done"))
        self.assertLessEqual(obj.LargestMove.Value, 0.05)

    def test_what_expressions_give_counts_more_than_values(self):
        sheet = self.doc.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "0.05 mm")
        obj = self.makers()[4]()
        obj.setExpression("MaxMove", "Sheet.A1 / 3 * 3")
        plan = Plan(obj, {"MaxMove": 7.0, "HoldSides": True})
        self.assertEqual(set(plan.values), {"MaxMove", "HoldSides"})
        self.assertAlmostEqual(plan.values["MaxMove"], 0.05, delta=1e-15)
        found = run_in_thread(plan)
        self.assertTrue(plan.is_current())
        sheet.set("A1", "0.06 mm")
        self.doc.recompute([sheet])
        self.assertFalse(plan.is_current())
        plan = Plan(obj, {"MaxMove": 7.0, "HoldSides": True})
        plan.apply(*run_in_thread(plan))
        self.assertAlmostEqual(obj.MaxMove.Value, 0.06, delta=1e-15)
        self.assertEqual(expressions.expressions(obj), {"MaxMove": "Sheet.A1 / 3 * 3"})
        self.assertIsNone(found[1])

    def test_expressions_are_set_and_computed(self):
        obj = self.makers()[4]()
        obj.setExpression("GapTolerance", "2 um")
        expressions.bind(obj, {"MaxMove": "1 mm", "AngleTolerance": "GapTolerance / 1 mm * 1 deg"})
        self.assertEqual(set(expressions.expressions(obj)), {"MaxMove", "AngleTolerance"})
        self.assertEqual(expressions.numbers(obj, ["MaxMove", "Target"]), {"MaxMove": 1.0})
        expressions.bind(obj, {})
        self.assertEqual(obj.ExpressionEngine, [])
        for text, unit, number in (
            ("2 * 0.05 mm", "mm", 0.1), ("1 cm", "mm", 10), ("1 rad / 2", "deg", 28.6478897565412),
            ("3 + 4", "mm", 7), ("GapTolerance * 2", "mm", 2 * obj.GapTolerance.Value), ("8", "", 8)
        ):  # fmt: skip
            found = expressions.evaluated(obj, text, unit)
            self.assertAlmostEqual(found, number, delta=1e-12, msg=text)
        for text, unit in (
            ("1 kg", "mm"), ("1 mm", ""), ("1 mm", "deg"), ("none.of", "mm"), ("1 +", "mm"),
            ("1 / 0", ""), ("Label", ""), ("HoldSides", ""), ("", "")
        ):  # fmt: skip
            with self.assertRaises(ValueError, msg=text):
                expressions.evaluated(obj, text, unit)

    def test_what_was_found_of_an_older_model_is_not_kept(self):
        obj = self.makers()[0]()
        changes = (
            lambda: setattr(obj.Sources[0], "Shape", models.broken_panel(noise_mm=0.0)),
            lambda: setattr(obj, "AngleTolerance", 4.0),
            lambda: setattr(obj.Sources[0].Placement, "Base", models.App.Vector(0, 0, 9)),
        )
        for change in changes:
            plan = Plan(obj, {})
            found = run_in_thread(plan)
            self.assertTrue(plan.is_current())
            change()
            self.assertFalse(plan.is_current())
            plan.apply(*found)  # the recompute does not take it over
            kept = figures(obj)
            obj.touch()
            self.doc.recompute()
            self.assertEqual(figures(obj), kept)

    def test_an_object_that_is_gone_is_reported(self):
        for make in self.makers():
            obj = make()
            plan = Plan(obj, {})
            name, found = obj.Name, run_in_thread(plan)
            self.doc.removeObject(name)
            self.assertIsNone(found[1])
            self.assertIsNone(plan.object())
            self.assertFalse(plan.is_current())

    def test_a_source_that_is_gone_is_an_error(self):
        obj = self.makers()[1]()
        self.doc.removeObject("Panel")
        plan = Plan(obj, {})
        plan.apply(*run_in_thread(plan))
        self.assertFailed(obj, "The source was deleted")

    def test_no_result_is_no_error(self):
        obj = self.makers()[4]()
        plan = Plan(obj, {"MaxMove": 1e-6})
        with self.quiet():
            plan.apply(*run_in_thread(plan))
        self.assertWithout(obj, "Not matched")
