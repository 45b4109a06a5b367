# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computations that the user stops, in FreeCAD's window: what the panel says, and what stays; run
by run_freecad.py --window."""

import re
import threading
import time
from unittest import mock

import FreeCADGui as Gui
import models

from window import (
    COMPUTED_S, PanelWindow, WindowCase, analyses, held, pause, press_escape, report_view, settle,
    whole_window
)  # fmt: skip

from freecad.seamwright.document import fill, match, repair
from freecad.seamwright.gui.repair import view as repair_view
from freecad.seamwright.gui.widgets import computation
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.tasks import tasks

SHOWN_S = 2 * computation.LOCK_AFTER_MS / 1000
NO_RESULTS = "Cancelled; there are no results yet."
OLD_RESULTS = "Cancelled; the results are those of the last complete run."
OK = QtWidgets.QDialogButtonBox.Ok


class Repairing(PanelWindow):
    COMMAND = "Seamwright_RepairSeams"
    is_made = staticmethod(repair.is_repair)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.source = models.add(self.doc, models.broken_panel(), "Panel")
        self.doc.recompute()
        self.fit()
        self.obj, self.panel = self.run_selected([(self.source, "")])
        self.before = report_view()

    def tearDown(self):
        written = report_view()[len(self.before) :]
        self.assertNotIn("Traceback", written)
        self.assertNotIn("Recompute failed", written)
        super().tearDown()

    def values(self):
        """All that the document keeps of the repair; objects of FreeCAD without the addresses in
        their names."""
        kept = [name for name in sorted(self.obj.PropertiesList) if name != "Shape"]
        return [re.sub("0x[0-9a-f]+", "", str(getattr(self.obj, name))) for name in kept]

    def test_escape_stops_the_first_run_and_then_closes_the_panel(self):
        before = self.values()
        with held():
            self.panel.preview()
            pause(SHOWN_S)
            press_escape()
            pause()
        self.assertEqual(self.panel.summary.text(), NO_RESULTS)
        self.assertEqual((self.values(), self.visible()), (before, ["Panel"]))
        press_escape()
        settle()
        self.assertEqual((self.made(), self.visible()), ([], ["Panel"]))
        self.assertFalse(self.doc.HasPendingTransaction)

    def test_the_panel_is_locked_while_it_computes_long(self):
        parts = [self.panel.table, self.panel.preview_button, self.button(OK)]
        with held():
            self.panel.preview()
            self.assertTrue(all(part.isEnabled() for part in parts))
            pause(SHOWN_S)
            whole_window("stop-locked")
            self.assertFalse(any(part.isEnabled() for part in parts))
            self.assertTrue(self.panel.max_move.isEnabled())
            self.assertTrue(self.panel.computation.line.isVisible())
            self.assertFalse(self.panel.accept())
            self.panel.computation.stop_button.click()
            pause()
            self.assertTrue(all(part.isEnabled() for part in parts))
            self.assertFalse(self.panel.computation.line.isVisible())
        self.assertEqual(self.panel.summary.text(), NO_RESULTS)

    def test_a_later_run_that_is_stopped_leaves_the_results(self):
        self.panel.preview()
        settle()
        before = self.values()
        self.panel.max_move.setValue(0.05)
        with held():
            self.panel.preview()
            pause()
            self.assertFalse(self.panel.reject())
        self.assertEqual(self.panel.summary.text(), OLD_RESULTS)
        self.assertEqual((self.values(), self.obj.State), (before, ["Up-to-date"]))
        self.assertEqual(self.panel.max_move.value(), 0.05)
        self.assertEqual(self.panel.preview_button.text(), "Update preview")
        self.ok()
        self.assertEqual((self.obj.MaxMove.Value, self.made()), (0.05, [self.obj]))

    def test_escape_while_moves_are_computed_leaves_the_repair(self):
        begun, over = threading.Event(), threading.Event()

        def slow(before, after, moves, go_on):
            begun.set()
            while go_on(0.5) and not over.is_set():
                time.sleep(0.002)

        with mock.patch.object(repair_view, "move_map", slow):
            self.panel.preview()
            end = time.monotonic() + COMPUTED_S
            while not begun.is_set() and time.monotonic() < end:
                pause(0.02)
            pause(SHOWN_S)
            whole_window("stop-moves")
            press_escape()
            pause()
            self.assertTrue(tasks.idle)
            over.set()
        self.assertEqual((self.obj.Repaired, self.visible()), (7, [self.obj.Name]))
        self.ok()
        self.assertEqual((self.made(), repair.error_text(self.obj)), ([self.obj], ""))

    def test_a_model_that_changes_meanwhile_is_reported(self):
        with held():
            self.panel.preview()
            pause()
            self.doc.openTransaction("Move")
            self.source.Placement.Base.z = 5
            self.doc.commitTransaction()
        self.assertIn("The model was changed during the computation", self.panel.summary.text())
        self.panel.preview()
        settle()
        self.assertEqual(self.obj.Repaired, 7)
        self.ok()


class Analysing(WindowCase):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        models.add(self.doc, models.three_classes(), "Prism")
        self.doc.recompute()
        self.fit()

    def test_of_a_first_run_that_is_stopped_nothing_stays(self):
        steps = self.doc.UndoCount
        for stop in ("escape", "button", "close"):
            with self.subTest(stop), held():
                Gui.runCommand("Seamwright_AnalyzeSeams")
                pause(SHOWN_S)
                (obj,) = analyses(self.doc)
                panel = obj.ViewObject.Proxy.panel
                whole_window("stop-analysis")
                if stop == "escape":
                    press_escape()
                elif stop == "button":
                    panel.computation.stop_button.click()
                else:
                    Gui.activeDocument().resetEdit()
                pause()
            self.assertEqual(analyses(self.doc), [])
            self.assertFalse(Gui.Control.activeDialog())
            self.assertFalse(self.doc.HasPendingTransaction)
        self.assertLessEqual(self.doc.UndoCount, steps + 2)

    def test_a_later_run_that_is_stopped_leaves_the_results(self):
        obj, panel = self.analyse()
        before = (obj.Report, obj.Summary, obj.AngleTolerance.Value)
        panel.tolerances.fields["AngleTolerance"].setValue(2.0)
        with held():
            panel.recompute()
            pause(SHOWN_S)
            press_escape()
            pause()
        self.assertEqual(panel.summary.text(), OLD_RESULTS)
        self.assertEqual((obj.Report, obj.Summary, obj.AngleTolerance.Value), before)
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.assertTrue(tasks.idle)


class Outcomes(WindowCase):
    """What did not come about is not a failure: no traceback, no "Recompute failed!"."""

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.before = report_view()

    def assertQuiet(self):
        written = report_view()[len(self.before) :]
        self.assertNotIn("Traceback", written)
        self.assertNotIn("Recompute failed", written)

    def test_not_matched(self):
        left, right = (
            models.add(self.doc, each, name)
            for each, name in zip(models.two_sheets(), ("Left", "Right"))
        )
        obj = match.create((left, "Face1"), (right, "Face1"), max_move_mm=1e-6)
        self.assertEqual(
            (obj.Outcome, obj.Matched, match.error_text(obj)),
            ("without result", False, obj.Summary),
        )
        self.assertEqual(obj.State, ["Up-to-date"])
        self.assertQuiet()

    def test_not_filled(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = fill.create(box)
        self.assertIn("has no hole", fill.error_text(obj))
        self.assertEqual((obj.Outcome, obj.State), ("without result", ["Up-to-date"]))
        self.assertQuiet()
