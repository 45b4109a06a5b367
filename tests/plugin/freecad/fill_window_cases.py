# SPDX-License-Identifier: LGPL-2.1-or-later
"""Umbrella Fill in FreeCAD's window; run by run_freecad.py --window."""

import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from PySide import QtCore

from window import (
    CANCELLED, PanelWindow, camera, click, click_row, count, messages, picture, press_escape,
    press_key, settle, whole_window
)  # fmt: skip

from freecad.seamwright.document import analysis, elements, fill
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.plain import fill_misses, new_seams

FILL = "Seamwright_UmbrellaFill"
BAND = (255, 217, 0)
FEW, MANY = 60, 1500
LEGEND = QtCore.QRect(0, 0, 420, 160)
MODEL = QtCore.QRect(0, 165, 1200, 635)
RESULT = len(new_seams.COLUMNS) - 1


def tinted(image):
    """Pixels in which green is well above red: those of faces that are new; the model is grey."""
    step = 3
    places = ((x, y) for x in range(0, image.width(), step) for y in range(0, image.height(), step))
    colours = (image.pixelColor(x, y) for x, y in places)
    return step * step * sum(colour.green() > colour.red() + 30 for colour in colours)


class FillWindow(PanelWindow):
    COMMAND = FILL
    is_made = staticmethod(fill.is_fill)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.source = models.add(self.doc, models.open_block(3), "Block")
        self.loops = models.open_loops(self.source.Shape)
        self.source.ViewObject.ShapeColor = (0.7, 0.7, 0.7)
        self.doc.recompute()
        self.fit()

    def start(self, *names, source=None):
        return self.run_selected([(source or self.source, name) for name in names or ("",)])

    def ticked(self, panel):
        return [number - 1 for number in panel.holes.chosen()]


class Filling(FillWindow):
    def test_edges_are_picked_previewed_accepted_and_undone(self):
        steps = self.doc.UndoCount
        obj, panel = self.start(*self.loops[1][::-1])
        self.assertEqual((panel.holes.count(), self.ticked(panel)), (3, [1]))
        self.assertEqual(panel.boxes["Source"].chosen.text(), "Block")
        self.assertEqual((self.visible(), panel.summary.text()), ([obj.Name], obj.Summary))
        self.assertEqual(self.column(panel, RESULT), ["meets G1"] * 9)
        self.assertGreater(tinted(picture("fill-preview")), MANY)
        whole_window("fill-preview")
        panel.zebra.setChecked(True)
        settle()
        self.assertEqual(zebra.objects(self.doc), [obj])
        self.assertEqual(tinted(picture("fill-stripes")), 0)
        whole_window("fill-stripes-window")
        panel.before.setChecked(True)
        settle()
        self.assertEqual(self.visible(), ["Block"])
        self.assertIn(self.source, zebra.objects(self.doc))
        panel.after.setChecked(True)
        settle()
        self.ok()
        self.assertEqual(zebra.objects(self.doc), [])
        self.assertIsNone(obj.ViewObject.Proxy.panel)
        self.assertEqual(
            (self.visible(), obj.ViewObject.Proxy.claimChildren()), ([obj.Name], [self.source])
        )
        self.assertEqual((tinted(picture("fill-after")), obj.Filled, obj.Reached), (0, 1, True))
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.doc.undo()
        settle()
        self.assertEqual((self.made(), self.visible()), ([], ["Block"]))
        self.doc.redo()
        settle()
        (again,) = self.made()
        self.assertEqual((again.Filled, self.visible()), (1, [again.Name]))

    def test_holes_are_chosen_in_the_panel_and_in_the_view(self):
        obj, panel = self.start()
        self.assertEqual(self.ticked(panel), [0, 1, 2])
        self.assertEqual((obj.Filled, obj.NewFaces, obj.Shape.isClosed()), (3, 9, True))
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, "Block", self.loops[2][0])
        click(panel.pick, panel.pick.rect().center())
        self.assertEqual(self.ticked(panel), [2])
        panel.holes.item(2).setCheckState(QtCore.Qt.Unchecked)
        self.assertEqual(self.ticked(panel), [2])  # one hole stays chosen
        self.preview(panel)
        self.assertEqual((elements.names(obj, "Edges"), obj.Filled), ([self.loops[2][0]], 1))
        for place in range(3):
            panel.holes.item(place).setCheckState(QtCore.Qt.Checked)
        self.preview(panel)
        self.assertEqual((elements.names(obj, "Edges"), obj.Filled), ([], 3))
        self.press_undo()
        self.assertEqual((elements.names(obj, "Edges"), obj.Filled), ([self.loops[2][0]], 1))
        self.assertEqual(self.ticked(panel), [2])
        self.press_undo()
        self.assertEqual((elements.names(obj, "Edges"), obj.Filled), ([], 3))
        self.assertEqual(self.ticked(panel), [0, 1, 2])
        panel.before.setChecked(True)
        settle()
        item = panel.holes.item(1)
        click(
            panel.holes.viewport(), panel.holes.visualItemRect(item).center() + QtCore.QPoint(30, 0)
        )
        (chosen,) = Gui.Selection.getSelectionEx()
        self.assertEqual(
            (chosen.ObjectName, set(chosen.SubElementNames)), ("Block", set(self.loops[1]))
        )
        seen = [camera()]
        panel.after.setChecked(True)
        for place in (2, 0):
            item = panel.holes.item(place)
            click(
                panel.holes.viewport(),
                panel.holes.visualItemRect(item).center() + QtCore.QPoint(30, 0),
            )
            seen.append(camera())
        self.assertEqual(len(set(seen)), 3)
        picture("fill-hole")
        self.cancel()
        self.assertEqual((self.made(), self.visible()), ([], ["Block"]))

    def test_a_click_on_a_row_marks_the_seam(self):
        obj, panel = self.start(self.loops[0][0])
        self.preview(panel)
        before = camera()
        click_row(panel.table, 0)
        (chosen,) = Gui.Selection.getSelectionEx()
        self.assertEqual(
            (chosen.ObjectName, list(chosen.SubElementNames)),
            (obj.Name, [self.column(panel, 0)[0]]),
        )
        self.assertNotEqual(camera(), before)
        self.assertGreater(count(picture("fill-row"), BAND), FEW)
        self.ok()
        self.assertEqual(count(picture("fill-closed"), BAND), 0)

    def test_what_misses_the_target_is_left_unless_asked_otherwise(self):
        self.source.Shape = models.panel_with_hole()
        self.doc.recompute()
        obj, panel = self.start()
        panel.tolerances.fields["AngleTolerance"].setValue(1e-9)
        self.preview(panel)
        self.assertEqual(self.visible(), ["Block"])
        self.assertRegex(panel.summary.text(), "is not G1|does not certainly reach G1")
        self.assertIn("\u00b0", panel.summary.text())
        self.assertRegex(" ".join(self.column(panel, RESULT)), "misses G1|G1 uncertain")
        whole_window("fill-left")
        click_row(panel.table, 0)
        self.ok()
        (text,) = messages()
        self.assertRegex(text, "is not G1|does not certainly reach G1")
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        panel.options.fields["keep_anyway"].widget.setChecked(True)
        self.ok()
        self.assertEqual((obj.Filled, obj.Reached, self.visible()), (1, False, [obj.Name]))
        self.assertIn("kept anyway", obj.Summary)

    def test_the_best_fill_is_drawn_and_its_tolerances_are_taken(self):
        self.source.Shape = models.panel_with_hole()
        self.doc.recompute()
        obj, panel = self.start()
        self.assertFalse(panel.allow.isVisible())
        field = panel.tolerances.fields["AngleTolerance"]
        field.lineEdit().setFocus()
        field.lineEdit().selectAll()
        for letter in "1e-9":
            press_key(ord(letter.upper()), text=letter)
        self.preview(panel)
        self.assertEqual((obj.AngleTolerance.Value, obj.Filled), (1e-9, 0))
        self.assertTrue(panel.after.isEnabled() and panel.allow.isVisible())
        self.fit()
        worst = fill_misses.RAMP[-1][1]
        shown = picture("fill-missed")
        self.assertGreater(tinted(shown), MANY)
        self.assertGreater(count(shown, worst, LEGEND), FEW)
        self.assertGreater(count(shown, worst, MODEL, reach=60), FEW)
        whole_window("fill-missed")
        click_row(panel.table, 0)
        marked = picture("fill-missed-row")
        whole_window("fill-missed-row")
        self.assertGreater(count(marked, BAND), FEW)
        panel.table.clearSelection()
        self.fit()
        click(panel.before, panel.before.rect().center())
        plain = picture("fill-missed-before")
        self.assertEqual((tinted(plain), count(plain, worst, LEGEND)), (0, 0))
        click(panel.after, panel.after.rect().center())
        self.assertGreater(tinted(picture("fill-missed-again")), MANY)
        click(panel.allow, panel.allow.rect().center())
        self.preview(panel)
        whole_window("fill-allowed")
        self.assertEqual((obj.Filled, obj.Reached), (1, True), obj.Summary)
        self.assertFalse(panel.allow.isVisible())
        self.assertGreater(obj.AngleTolerance.Value, 1e-9)
        self.assertLess(obj.AngleTolerance.Value, 0.01)
        self.assertEqual(count(picture("fill-allowed-view"), worst, LEGEND), 0)
        self.press_undo()
        self.assertEqual((obj.AngleTolerance.Value, obj.Filled), (1e-9, 0))
        self.assertGreater(tinted(picture("fill-missed-undone")), MANY)
        press_escape()
        settle()
        self.assertEqual(self.made(), [])
        closed = picture("fill-missed-closed")
        self.assertEqual((tinted(closed), count(closed, worst, LEGEND)), (0, 0))

    def test_a_fill_that_misses_is_drawn_over_the_face_that_it_would_replace(self):
        box = models.add(self.doc, Part.makeBox(10, 10, 10), "Cube")
        self.source.ViewObject.Visibility = False
        self.doc.recompute()
        obj, panel = self.start("Face6", source=box)
        panel.tolerances.level.setCurrentText("G2")
        self.preview(panel)
        self.fit()
        self.assertEqual((obj.Filled, self.visible()), (0, ["Cube"]))
        whole_window("fill-missed-face")
        self.assertGreater(tinted(picture("fill-missed-face-view")), MANY)
        self.cancel()

    def test_cancel_takes_all_of_it_back_and_a_later_change_too(self):
        for undo in (1, 0):
            self.doc.UndoMode = undo
            _, panel = self.start()
            self.preview(panel)
            self.cancel()
            self.assertEqual((self.made(), self.visible()), ([], ["Block"]))
        obj, _ = self.start(self.loops[0][0])
        self.ok()
        report = obj.Report
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        self.assertEqual(panel.table.rowCount(), 9)
        panel.tolerances.level.setCurrentText("G0")
        self.preview(panel)
        self.assertNotEqual((obj.Target, obj.Report), ("G1", report))
        self.cancel()
        self.assertEqual((obj.Target, obj.Filled, self.visible()), ("G1", 1, [obj.Name]))

    def test_a_cancelled_fill_says_so(self):
        with CANCELLED:
            obj, panel = self.start()
        self.assertIn("Cancelled", panel.summary.text())
        self.assertEqual(self.visible(), ["Block"])
        self.ok()
        self.assertEqual((fill.error_text(obj), obj.Filled), ("", 3))


class Choosing(FillWindow):
    def test_a_picked_face_is_replaced_and_keeps_colours(self):
        self.source.Shape = models.rounded_block()
        ball = models.corner_faces(self.source.Shape)[0]
        colours = [(0.2, 0.01 * n, 0.5) for n in range(len(self.source.Shape.Faces))]
        self.source.ViewObject.DiffuseColor = colours
        self.doc.recompute()
        obj, panel = self.start("Face%d" % ball)
        self.assertEqual(panel.boxes["Source"].chosen.text(), "Block.Face%d" % ball)
        self.assertFalse(panel.holes.isVisible())
        self.ok()
        self.assertTrue(obj.Summary.startswith("Face%d replaced with 3 faces" % ball), obj.Summary)
        kept = [colour for n, colour in enumerate(colours, 1) if n != ball]
        shown = [colour[:3] for colour in obj.ViewObject.DiffuseColor]
        self.assertEqual(len(shown), len(kept) + 3)
        for one, other in zip(shown, kept):
            self.assertLess(max(abs(a - b) for a, b in zip(one, other)), 0.01)

    def test_an_analysis_stands_for_what_it_analysed(self):
        found = analysis.create([self.source])
        self.without_live_preview()
        obj, panel = self.start(source=found)
        self.assertEqual((obj.Source, panel.summary.text()), (self.source, "3 holes to fill."))
        self.assertEqual((panel.table.rowCount(), obj.Shape.isNull()), (0, True))
        self.press_preview(panel)
        self.assertEqual((panel.table.rowCount(), obj.Filled), (27, 3))
        self.cancel()

    def test_another_model_its_edges_or_its_face_are_picked_instead(self):
        other = models.add(self.doc, models.rounded_block(), "Other")
        ball = "Face%d" % models.corner_faces(other.Shape)[0]
        self.doc.recompute()
        obj, panel = self.start()
        other.ViewObject.Visibility = True
        for chosen, said in (
            ([(other, ball), (other, "Edge1")], "Selected: 1 face, 1 edge."),
            ([(other, ball), (self.source, "Edge1")], "Found: Other, Block."),
        ):
            self.use(panel, "Source", *chosen)
            (text,) = messages()
            self.assertIn(said, text)
        self.use(panel, "Source", (other, ball))
        self.assertEqual((obj.Source, elements.names(obj, "Face")), (other, [ball]))
        self.assertEqual(panel.boxes["Source"].chosen.text(), "Other." + ball)
        self.assertEqual((obj.NewFaces, self.visible()), (3, ["Block", obj.Name]))
        self.assertFalse(panel.holes.isVisible())
        self.use(panel, "Source", (self.source, self.loops[1][0]))
        self.assertEqual((obj.Source, elements.names(obj, "Face")), (self.source, []))
        self.assertEqual((self.ticked(panel), obj.Filled), ([1], 1))
        self.assertEqual(self.visible(), ["Other", obj.Name])
        self.ok()
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        self.use(panel, "Source", (other, ball))
        self.cancel()
        self.assertEqual((obj.Source, obj.Filled), (self.source, 1))
        self.assertEqual(self.visible(), ["Other", obj.Name])

    def test_a_model_without_holes_says_so(self):
        self.source.Shape = models.rounded_block()
        self.doc.recompute()
        self.start()
        self.assertEqual(messages(), ["Block has no hole: no free edges form a closed loop."])
        self.assertEqual(self.made(), [])
        self.assertFalse(self.doc.HasPendingTransaction)
        for shape in (Part.makeCylinder(5, 9), Part.makeSphere(5), Part.makeTorus(9, 2)):
            self.source.Shape = shape
            self.assertTrue(fill.is_closed(self.source))
            self.source.Shape = Part.makeShell(shape.Faces[:1]) if len(shape.Faces) > 1 else shape
            self.assertEqual(fill.is_closed(self.source), len(shape.Faces) == 1)

    def test_what_cannot_be_filled_together_is_one_message(self):
        other = models.add(self.doc, models.rounded_block(), "Other")
        self.doc.recompute()
        Gui.Selection.clearSelection()
        Gui.runCommand(FILL)  # of both
        (text,) = messages()
        self.assertIn("Found: Block, Other.", text)
        for names, found in (
            (("Face1", "Face2"), "Selected: 2 faces, no edges."),
            (("Face1", self.loops[0][0]), "Selected: 1 face, 1 edge."),
        ):
            self.start(*names)
            (text,) = messages()
            self.assertIn(found, text)
        with mock.patch.dict(sys.modules, seamwright=None):
            self.start()
        (text,) = messages()
        self.assertIn("It was built for Python", text)
        self.assertEqual(self.made(), [])

    def test_a_saved_fill_opens_with_its_view(self):
        obj, _ = self.start()
        self.ok()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with mock.patch.dict(sys.modules, seamwright=None):
                self.doc = App.openDocument(path)
                settle()
                (again,) = self.made()
                self.assertNotIn("Touched", again.State)
                self.assertEqual(self.visible(), [again.Name])
                self.assertEqual(again.ViewObject.Proxy.claimChildren(), [self.doc.Block])
            again.ViewObject.Proxy.doubleClicked(again.ViewObject)
            settle()
            self.assertEqual(again.ViewObject.Proxy.panel.summary.text(), again.Summary)
            self.cancel()
            Gui.Selection.addSelection(again)
            Gui.runCommand("Std_Delete")
            settle()
            self.assertEqual(self.visible(), ["Block"])
