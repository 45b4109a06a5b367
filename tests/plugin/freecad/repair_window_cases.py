# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair Seams in FreeCAD's window; run by run_freecad.py --window."""

import contextlib
import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
from PySide import QtCore
from window import WindowCase, camera, click, click_row, count, messages, picture, settle, whole_window

from freecad.seamwright.document import repair
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.gui.qt import QtWidgets
from freecad.seamwright.plain import moves, repair_text

REPAIR = "Seamwright_RepairSeams"
LEGEND = QtCore.QRect(0, 0, 420, 160)
MODEL = QtCore.QRect(0, 165, 1200, 635)
BAND = (255, 217, 0)
FEW = 60


class RepairWindow(WindowCase):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.panel_source = models.add(self.doc, models.broken_panel(), "Panel")
        self.panel_source.ViewObject.ShapeColor = (0.75, 0.80, 0.85)
        self.doc.recompute()
        self.fit()

    def start(self, *chosen):
        """Select elements, run the command; the repair it made and its open panel."""
        Gui.Selection.clearSelection()
        for obj, name in chosen or ((self.panel_source, ""),):
            Gui.Selection.addSelection(self.doc.Name, obj.Name, name)
        Gui.runCommand(REPAIR)
        settle()
        found = self.repairs()
        return (found[-1], found[-1].ViewObject.Proxy.panel) if found else (None, None)

    def repairs(self):
        return [obj for obj in self.doc.Objects if repair.is_repair(obj)]

    def visible(self):
        return [obj.Name for obj in self.doc.Objects if obj.ViewObject.Visibility]

    def press(self, which):
        """Press OK or Cancel of the task panel."""
        boxes = Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        (button,) = [box.button(which) for box in boxes if box.isVisible() and box.button(which)]
        click(button, button.rect().center())

    def ok(self):
        self.press(QtWidgets.QDialogButtonBox.Ok)

    def cancel(self):
        self.press(QtWidgets.QDialogButtonBox.Cancel)

    def preview(self, panel):
        click(panel.preview_button, panel.preview_button.rect().center())

    def column(self, panel, place):
        return [panel.table.item(line, place).text() for line in range(panel.table.rowCount())]


class Repairing(RepairWindow):
    def test_preview_shows_moves_and_figures_and_ok_keeps_it_as_one_step(self):
        steps = self.doc.UndoCount
        obj, panel = self.start()
        self.assertTrue(obj.Shape.isNull())
        self.assertEqual(self.visible(), ["Panel"])
        whole_window("repair-before")
        self.assertEqual(panel.summary.text(), "7 seams to repair to G1.")
        self.assertFalse(any(repair_text.ARROW in text for text in self.column(panel, 2)))
        self.preview(panel)
        whole_window("repair-preview")
        self.assertEqual(self.column(panel, 5), ["repaired"] * 7)
        self.assertTrue(all(repair_text.ARROW in text for text in self.column(panel, 2)))
        self.assertEqual((self.visible(), panel.summary.text()), ([obj.Name], obj.Summary))
        self.fit()
        shown = picture("repair-moves")
        for sample, _, _ in moves.legend_entries(1.0):
            self.assertGreater(count(shown, sample.rgb, LEGEND), FEW)
        click_row(panel.table, 0)
        whole_window("repair-row")
        self.ok()
        self.fit()
        whole_window("repair-after")
