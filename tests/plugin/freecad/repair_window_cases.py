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

from window import (
    CANCELLED, PICTURE, PanelWindow, WindowCase, camera, click, click_row, count, messages, picture,
    press_key, report_view, settle, whole_window
)  # fmt: skip

from freecad.seamwright.document import analysis, elements, repair
from freecad.seamwright.gui.base.row_table import RowTable
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import moves, repair_text

REPAIR = "Seamwright_RepairSeams"
LEGEND = QtCore.QRect(0, 0, 420, 160)
MODEL = QtCore.QRect(0, 165, 1200, 635)
BAND = (255, 217, 0)
FEW, MANY = 60, 2000
RESULT = len(repair_text.COLUMNS) - 1


def coloured(image):
    """Pixels in which red is well above blue: those of points that moved."""
    image = image.copy(MODEL)
    step = 3
    places = ((x, y) for x in range(0, image.width(), step) for y in range(0, image.height(), step))
    colours = (image.pixelColor(x, y) for x, y in places)
    return step * step * sum(colour.red() > colour.blue() + 30 for colour in colours)


class RepairWindow(PanelWindow):
    COMMAND = REPAIR
    is_made = staticmethod(repair.is_repair)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.source = models.add(self.doc, models.broken_panel(), "Panel")
        self.source.ViewObject.ShapeColor = (0.5, 0.6, 0.75)
        self.doc.recompute()
        self.fit()

    def start(self, *chosen):
        return self.run_selected(chosen or [(self.source, "")])

    def chosen(self):
        return [(one.ObjectName, one.SubElementNames) for one in Gui.Selection.getSelectionEx()]


class Table(WindowCase):
    def test_the_outcome_is_seen_and_its_reason_needs_no_scrolling(self):
        table = RowTable(repair_text.COLUMNS, 150)
        self.addCleanup(table.close)
        table.resize(520, 200)
        table.show()
        figures = ("\u22641.4e-12 \u2192 0.0122..0.0125",) * 3
        cells = ("Edge30", "10, 24", *figures, "the faces would fold " * 20)
        table.show_rows([repair_text.Row(1, (1,), repair_text.NOT_REPAIRED, cells, "")])
        settle()
        header, room = table.horizontalHeader(), table.viewport().width()
        end = header.sectionViewportPosition(RESULT) + header.sectionSize(RESULT)
        self.assertLessEqual(end, room)
        self.assertLess(table.horizontalScrollBar().maximum(), room)
        table.resize(1100, 200)
        settle()
        self.assertEqual(table.horizontalScrollBar().maximum(), 0)
        self.assertGreater(header.sectionSize(RESULT), 300)


class Repairing(RepairWindow):
    def test_preview_shows_moves_and_figures_and_ok_keeps_it_as_one_step(self):
        steps = self.doc.UndoCount
        obj, panel = self.start()
        self.assertTrue(obj.Shape.isNull())
        self.assertEqual(self.visible(), ["Panel"])
        self.assertEqual(panel.summary.text(), "7 seams to repair to G1.")
        self.assertFalse(any(repair_text.ARROW in text for text in self.column(panel, 2)))
        whole_window("repair-before")
        self.preview(panel)
        whole_window("repair-preview")
        self.assertEqual(self.column(panel, RESULT), ["repaired"] * 7)
        self.assertTrue(all(repair_text.ARROW in text for text in self.column(panel, 2)))
        self.assertEqual((self.visible(), panel.summary.text()), ([obj.Name], obj.Summary))
        self.ok()
        self.assertIsNone(obj.ViewObject.Proxy.panel)
        self.fit()
        whole_window("repair-after")
        self.assertEqual((self.visible(), obj.ViewObject.ShowMoves), ([obj.Name], False))
        self.assertEqual(obj.ViewObject.ShapeColor, self.source.ViewObject.ShapeColor)
        self.assertEqual(obj.ViewObject.Proxy.claimChildren(), [self.source])
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.doc.undo()
        settle()
        self.assertEqual((self.made(), self.visible()), ([], ["Panel"]))
        self.doc.redo()
        settle()
        (again,) = self.made()
        self.assertEqual((again.Repaired, self.visible()), (7, [again.Name]))

    def test_moves_are_coloured_with_a_legend_in_mm(self):
        obj, panel = self.start()
        self.preview(panel)
        self.fit()
        shown = picture("repair-moves")
        for sample, _, _ in moves.legend_entries(1.0):
            self.assertGreater(count(shown, sample.rgb, LEGEND), FEW)
        self.assertGreater(coloured(shown), MANY)
        panel.colours.setCurrentText("None")
        settle()
        self.assertLess(coloured(picture("repair-plain")), FEW)
        panel.colours.setCurrentText("Moves")
        panel.before.setChecked(True)
        settle()
        self.assertEqual(self.visible(), ["Panel"])
        before = picture("repair-source")
        self.assertLess(coloured(before), FEW)
        self.assertEqual(count(before, moves.RAMP[-1][1], LEGEND), 0)
        panel.after.setChecked(True)
        settle()
        self.assertGreater(coloured(picture("repair-again")), MANY)
        self.cancel()

    def test_a_placed_model_is_coloured_and_marked_where_it_stands(self):
        self.source.Placement = App.Placement(
            App.Vector(500, 0, 90), App.Rotation(App.Vector(0, 0, 1), 30)
        )
        self.doc.recompute()
        self.fit()
        obj, panel = self.start()
        self.preview(panel)
        shown = picture("repair-placed")
        panel.colours.setCurrentText("None")
        settle()
        plain = picture("repair-placed-plain")
        white = [count(image, (255, 255, 255), MODEL) for image in (shown, plain)]
        self.assertLess(abs(white[0] - white[1]), 0.01 * white[1])
        self.assertGreater(coloured(shown), MANY)
        click_row(panel.table, 0)
        self.assertGreater(count(picture("repair-placed-row"), BAND), FEW)
        self.cancel()

    def test_ok_without_preview_repairs(self):
        obj, _ = self.start()
        self.ok()
        self.assertEqual((obj.Repaired, self.visible()), (7, [obj.Name]))

    def test_a_click_on_a_row_selects_the_seam_and_zooms_to_it(self):
        obj, panel = self.start()
        for owner in (self.source, obj):
            before = camera()
            click_row(panel.table, 0)
            edge = panel.table.rows[0].edges[0]
            self.assertEqual(self.chosen(), [(owner.Name, ("Edge%d" % edge,))])
            self.assertNotEqual(camera(), before)
            self.assertGreater(count(picture("repair-row-" + owner.Name), BAND), FEW)
            if owner == self.source:
                self.preview(panel)
                self.fit()
        whole_window("repair-row")
        self.ok()
        self.assertEqual((self.chosen(), count(picture("repair-closed"), BAND)), ([], 0))

    def test_cancel_takes_all_of_it_back(self):
        for undo in (1, 0):
            self.doc.UndoMode = undo
            _, panel = self.start()
            self.preview(panel)
            self.cancel()
            self.assertEqual((self.made(), self.visible()), ([], ["Panel"]))
            self.assertFalse(self.doc.HasPendingTransaction)

    def test_cancel_leaves_what_was_hidden_hidden(self):
        for undo in (1, 0):
            self.doc.UndoMode = undo
            first, _ = self.start()
            self.ok()
            _, panel = self.start()
            self.preview(panel)
            self.cancel()
            self.assertEqual(self.visible(), [first.Name])
            self.doc.removeObject(first.Name)

    def test_cancel_of_a_later_change_restores_the_values(self):
        obj, _ = self.start()
        self.ok()
        report = obj.Report
        for undo in (1, 0):
            self.doc.UndoMode = undo
            Gui.activeDocument().setEdit(obj.Name)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.assertEqual(self.column(panel, RESULT), ["repaired"] * 7)
            panel.max_move.setValue(0.01)
            panel.lists["FixedFaces"].set_names(["Face2"])
            self.assertEqual(panel.preview_button.text(), "Update preview")
            self.preview(panel)
            self.assertEqual(
                (obj.MaxMove.Value, elements.names(obj, "FixedFaces")), (0.01, ["Face2"])
            )
            self.assertNotEqual(obj.Report, report)
            self.cancel()
            self.assertEqual((obj.MaxMove.Value, elements.names(obj, "FixedFaces")), (0, []))
            self.assertEqual(
                (obj.Repaired, self.visible(), obj.ViewObject.ShowMoves), (7, [obj.Name], False)
            )

    def test_seams_and_faces_are_picked_in_the_view(self):
        obj, panel = self.start()
        click_row(panel.table, 0)
        edges = panel.lists["Edges"]
        click(edges.add, edges.add.rect().center())
        chosen = "Edge%d" % panel.table.rows[0].edges[0]
        self.assertEqual(edges.names(), [chosen])
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, "Panel", "Face%d" % 6)
        Gui.Selection.addSelection(self.doc.Name, "Panel", "Edge1")
        faces = panel.lists["FixedFaces"]
        click(faces.add, faces.add.rect().center())
        click(faces.add, faces.add.rect().center())
        self.assertEqual(faces.names(), ["Face6"])
        whole_window("repair-picked")
        self.preview(panel)
        self.assertEqual((elements.names(obj, "Edges"), obj.Wanted), ([chosen], 1))
        self.assertNotIn(6, [move["face"] for move in repair.report_of(obj)["moves"]])
        click(edges.remove, edges.remove.rect().center())
        self.assertEqual(edges.names(), [])
        self.ok()
        self.assertEqual((elements.names(obj, "Edges"), obj.Wanted), ([], 7))

    def test_what_could_not_be_repaired_says_why(self):
        obj, panel = self.start()
        panel.max_move.setValue(0.05)
        self.preview(panel)
        results = self.column(panel, RESULT)
        self.assertTrue(any("0.05 mm" in text for text in results), results)
        self.assertEqual(results.count("repaired"), obj.Repaired)
        for place, text in enumerate(results):
            click_row(panel.table, place)
            self.assertEqual(panel.remark.isVisible(), text != "repaired")
            self.assertTrue(text == "repaired" or panel.remark.text().endswith(text))
        click_row(panel.table, 0)
        whole_window("repair-left")
        self.ok()
        self.assertEqual(repair.error_text(obj), "")

    def test_a_cancelled_repair_says_so_and_ok_waits(self):
        obj, panel = self.start()
        with CANCELLED:
            self.preview(panel)
            self.assertEqual(panel.summary.text(), "Cancelled; there are no results yet.")
            self.assertEqual(self.visible(), ["Panel"])
            self.ok()
            self.assertEqual(panel.summary.text(), "Cancelled; there are no results yet.")
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.ok()
        self.assertEqual((repair.error_text(obj), obj.Repaired), ("", 7))

    def test_a_model_without_defects_says_so(self):
        self.source.Shape = models.broken_panel(noise_mm=0.0)
        self.doc.recompute()
        obj, panel = self.start()
        self.assertIn("Nothing to repair", panel.summary.text())
        self.assertEqual(panel.table.rowCount(), 0)
        self.ok()
        self.assertFalse(obj.Changed)


class Steps(RepairWindow):
    def type_number(self, field, text):
        """Type a number into a field, a key each 50 ms."""
        field.setFocus()
        field.selectAll()
        for letter in text:
            press_key(ord(letter.upper()), text=letter)
            settle(0.05)
        settle(0.8)

    def test_undo_takes_back_the_last_change_in_the_panel(self):
        models.add(self.doc, models.broken_panel(), "Other")  # a step of the document before
        before = self.doc.UndoCount
        obj, panel = self.start()
        faces, edges = panel.lists["FixedFaces"], panel.lists["Edges"]
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, "Panel", "Face6")
        click(faces.add, faces.add.rect().center())
        settle(0.8)
        self.type_number(panel.max_move.lineEdit(), "0.05")
        self.assertEqual((panel.max_move.number(), faces.names()), (0.05, ["Face6"]))
        self.preview(panel)
        self.assertEqual(obj.MaxMove.Value, 0.05)
        click_row(panel.table, 0)
        click(edges.add, edges.add.rect().center())
        self.assertEqual(len(edges.names()), 1)
        self.assertEqual(panel.preview_button.text(), "Update preview")
        self.press_undo()
        self.assertEqual((edges.names(), panel.preview_button.text()), ([], "Preview"))
        self.press_undo()
        whole_window("repair-undone")
        self.assertEqual((panel.max_move.number(), faces.names()), (0, ["Face6"]))
        self.assertEqual(panel.preview_button.text(), "Update preview")
        self.press_undo()
        self.press_undo()
        self.assertEqual((panel.max_move.number(), faces.names()), (0, []))
        for _ in range(2):
            press_key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier | QtCore.Qt.ShiftModifier)
            settle()
        self.assertEqual((panel.max_move.number(), faces.names()), (0.05, ["Face6"]))
        self.assertEqual(panel.preview_button.text(), "Preview")
        self.assertEqual(self.made(), [obj])
        self.assertIsNotNone(self.doc.getObject("Other"))
        self.ok()
        self.assertEqual(self.doc.UndoCount, before + 1)


class Choosing(RepairWindow):
    def test_rows_of_an_analysis_and_its_tolerances_are_taken_over(self):
        found, panel = self.analyse()
        panel.tolerances.fields["AngleTolerance"].setValue(1.0)
        panel.recompute()
        click_row(panel.seam_table.table, 1)
        edge = panel.seam_table.model.row(1).edges[0]
        buttons = [
            each
            for each in panel.form.findChildren(QtWidgets.QPushButton)
            if each.text().startswith("Repair")
        ]
        click(buttons[0], buttons[0].rect().center())
        settle()
        (obj,) = self.made()
        self.assertEqual(
            (obj.Source, elements.names(obj, "Edges")), (self.source, ["Edge%d" % edge])
        )
        self.assertEqual((obj.AngleTolerance.Value, obj.Target), (1.0, "G1"))
        self.assertEqual(obj.ViewObject.Proxy.panel.table.rowCount(), 1)
        self.assertIsNone(found.ViewObject.Proxy.panel)
        self.cancel()

    def test_lines_and_legend_of_an_analysis_give_way_to_the_result(self):
        found = analysis.create([self.source])
        settle()
        obj, panel = self.start()
        self.assertEqual(self.visible(), ["Panel", found.Name])
        self.preview(panel)
        whole_window("repair-over-analysis")
        self.assertEqual(self.visible(), [obj.Name])
        panel.before.setChecked(True)
        settle()
        self.assertEqual(self.visible(), ["Panel", found.Name])
        self.cancel()
        self.assertEqual(self.visible(), ["Panel", found.Name])
        obj, panel = self.start()
        self.ok()
        self.assertEqual(self.visible(), [obj.Name])
        self.doc.undo()
        settle()
        self.assertEqual(self.visible(), ["Panel", found.Name])

    def test_edges_of_a_body_are_picked_for_its_analysis_and_its_repair(self):
        body = self.doc.addObject("PartDesign::Body", "Body")
        step = body.newObject("PartDesign::AdditiveBox", "Pad")
        self.doc.recompute()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(body)
        found, panel = self.analyse()
        self.assertEqual(found.Analysed, [body])
        Gui.Selection.addSelection(self.doc.Name, body.Name, step.Name + ".Edge3")
        settle()
        rows = panel.seam_table.chosen_rows()
        self.assertEqual(panel.results.elements(rows), [("Body", "Edge3")])
        panel.reject()
        settle()
        obj, panel = self.start((body, ""))
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, body.Name, step.Name + ".Edge5")
        click(panel.lists["Edges"].add, panel.lists["Edges"].add.rect().center())
        self.assertEqual((obj.Source, panel.lists["Edges"].names()), (body, ["Edge5"]))
        self.cancel()

    def test_what_is_made_from_the_result_is_hidden_while_the_panel_is_open(self):
        obj = repair.create(self.source)
        found = analysis.create([obj])
        found.ViewObject.Visibility = True
        for end in (self.ok, self.cancel):
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            self.assertFalse(found.ViewObject.Visibility)
            end()
            self.assertTrue(found.ViewObject.Visibility and obj.ViewObject.Visibility)
            self.assertFalse(self.doc.HasPendingTransaction)

    def test_lines_of_an_analysis_stand_for_their_edges(self):
        found = analysis.create([self.source], level="G2")
        numbers = [seam["edges"][0] for seam in analysis.report_of(found)["seams"]]
        obj, _ = self.start((found, "Edge2"), (found, "Edge5"))
        self.assertEqual(elements.names(obj, "Edges"), ["Edge%d" % numbers[k] for k in (1, 4)])
        self.assertEqual((obj.Source, obj.Target), (self.source, "G2"))
        self.cancel()
        obj, _ = self.start((found, ""))
        self.assertEqual((obj.Source, elements.names(obj, "Edges")), (self.source, []))
        self.cancel()

    def test_a_link_and_a_part(self):
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = self.source
        link.Placement.Base.z = 100
        self.doc.recompute()
        obj, panel = self.start((link, ""))
        click_row(panel.table, 0)
        self.preview(panel)
        self.assertEqual((obj.Source, obj.Repaired), (link, 7))
        self.assertGreater(obj.Shape.BoundBox.ZMin, 80)
        self.cancel()
        self.doc.removeObject("Link")
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.source)
        part.Placement.Base.z = 200
        self.doc.recompute()
        obj, panel = self.start((part, ""))
        click_row(panel.table, 0)
        self.preview(panel)
        self.assertEqual((obj.Source, obj.Repaired), (self.source, 7))
        self.assertGreater(obj.Shape.BoundBox.ZMin, 180)
        self.ok()

    def test_nothing_selected_takes_the_only_model(self):
        Gui.Selection.clearSelection()
        obj, _ = self.run_command()
        self.assertEqual(obj.Source, self.source)
        self.cancel()

    def test_two_objects_are_one_message(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj, _ = self.start((self.source, ""), (box, ""))
        (text,) = messages()
        self.assertIsNone(obj)
        self.assertIn("Found: Panel, Box.", text)

    def test_a_vertex_is_one_message(self):
        obj, _ = self.start((self.source, "Edge1"), (self.source, "Vertex2"))
        self.assertIsNone(obj)
        self.assertEqual(
            messages(), ["Panel.Vertex2 is a vertex: select edges, or the whole object."]
        )

    def test_a_missing_kernel_is_one_message(self):
        with mock.patch.dict(sys.modules, seamwright=None):
            obj, _ = self.start()
        (text,) = messages()
        self.assertIsNone(obj)
        self.assertIn("It was built for Python", text)


class Staying(RepairWindow):
    def test_deleting_the_repair_or_failing_shows_the_source(self):
        obj, _ = self.start()
        self.ok()
        obj.Edges = (self.source, ["Edge99"])
        self.doc.recompute()
        settle()
        self.assertIn("Panel", self.visible())
        obj.Edges = None
        self.doc.recompute()
        settle()
        self.assertEqual(self.visible(), [obj.Name])
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand("Std_Delete")
        settle()
        self.assertEqual(self.visible(), ["Panel"])

    def test_a_deleted_source_and_closing_while_the_panel_is_open(self):
        obj, panel = self.start()
        self.preview(panel)
        self.doc.removeObject("Panel")
        self.preview(panel)
        self.assertIn("The source was deleted", panel.summary.text())
        panel.before.setChecked(True)
        settle()
        App.closeDocument(self.doc.Name)
        settle()
        self.assertFalse(Gui.Control.activeDialog())
        self.doc = App.newDocument("Again")

    def test_undo_while_the_panel_is_open(self):
        obj, panel = self.start()
        self.preview(panel)
        self.ok()
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        panel.max_move.setValue(0.05)
        self.preview(panel)
        self.doc.undo()
        settle()
        self.doc.undo()
        settle()
        Gui.activeDocument().resetEdit()
        settle()
        self.assertEqual(self.made(), [])
        self.assertFalse(Gui.Control.activeDialog())
        self.start()
        self.doc.undo()
        settle()
        self.assertEqual(self.visible(), ["Panel"])

    def reopen(self, within=contextlib.nullcontext()):
        """Keep a repair whose moves are shown, save the document and open it ``within`` a context;
        the repair there."""
        obj, _ = self.start()
        self.ok()
        obj.ViewObject.ShowMoves = True
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with within:
                self.doc = App.openDocument(path)
                settle()
        (again,) = self.made()
        self.assertNotIn("Touched", again.State)
        self.assertEqual(self.visible(), [again.Name])
        self.assertEqual(again.ViewObject.Proxy.claimChildren(), [self.doc.Panel])
        self.fit()
        return again

    def test_a_saved_repair_opens_with_its_view(self):
        again = self.reopen()
        self.assertGreater(coloured(picture("repair-reopened")), MANY)
        again.ViewObject.Proxy.doubleClicked(again.ViewObject)
        settle()
        self.assertEqual(again.ViewObject.Proxy.panel.summary.text(), again.Summary)
        self.cancel()

    def test_without_the_compiled_part_a_saved_repair_is_shown_without_its_moves(self):
        before = report_view()
        again = self.reopen(within=mock.patch.dict(sys.modules, seamwright=None))
        written = report_view()[len(before) :]
        self.assertIn(
            "the moves of %s are not shown: The compiled part of Seamwright" % again.Name, written
        )
        self.assertNotIn("Traceback", written)
        plain = picture("repair-reopened-plain")
        self.assertLess(coloured(plain), FEW)
        size = PICTURE[0] * PICTURE[1]
        self.assertLess(count(plain, (255, 255, 255)), size - MANY)
        again.ViewObject.ShowMoves = False
        again.ViewObject.ShowMoves = True
        settle()
        self.assertGreater(coloured(picture("repair-reopened-later")), MANY)
