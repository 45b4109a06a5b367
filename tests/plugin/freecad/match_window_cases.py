# SPDX-License-Identifier: LGPL-2.1-or-later
"""Match Surfaces and Zebra Stripes in FreeCAD's window; run by run_freecad.py --window."""

import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import numpy
import Part
from match_cases import tilted
from PySide import QtCore, QtGui
from window import (
    CANCELLED, OUT, PanelWindow, click, held, messages, pause, picture, settle, whole_window
)  # fmt: skip

from freecad.seamwright.document import match
from freecad.seamwright.gui.scene.zebra import zebra

MATCH, ZEBRA = "Seamwright_MatchSurfaces", "Seamwright_ZebraStripes"
MANY = 5000  # pixels of a face


def greys(image):
    """The picture's brightness, 0..255, as lines of pixels; colours count as 128."""
    image = image.convertToFormat(QtGui.QImage.Format_RGBA8888)
    pixels = numpy.frombuffer(bytes(image.constBits()), numpy.uint8).reshape(
        image.height(), image.width(), 4
    )
    rgb = pixels[:, :, :3].astype(int)
    return numpy.where(rgb.max(axis=2) - rgb.min(axis=2) <= 6, rgb[:, :, 0], 128)


def dark_count(image):
    """Pixels of dark stripes."""
    return int((greys(image) < 40).sum())


def area_count(mask):
    """Pixels of areas of a mask; lines of up to 4 pixels, as edges that are smoothed, are none."""
    far = 2
    inner = mask[far:-far, far:-far]
    beside = (mask[2 * far :, far:-far], mask[: -2 * far, far:-far],
              mask[far:-far, 2 * far :], mask[far:-far, : -2 * far])  # fmt: skip
    return int(numpy.logical_and.reduce([inner, *beside]).sum())


class MatchWindow(PanelWindow):
    COMMAND = MATCH
    is_made = staticmethod(match.is_match)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.left, self.right = (
            models.add(self.doc, shape, name)
            for shape, name in zip(models.two_sheets(), ("Left", "Right"))
        )
        self.doc.recompute()
        self.fit()

    def tearDown(self):
        zebra.hide(zebra.objects(self.doc))
        super().tearDown()

    def start(self, *chosen):
        return self.run_selected(chosen or [(self.left, "Face1"), (self.right, "Face1")])

    def faces(self, panel):
        return [panel.boxes[name].chosen.text() for name in match.FACES]

    def field(self, panel, argument):
        return panel.options.fields[argument].widget

    def cells(self, panel):
        return [
            [panel.table.item(line, column).text() for column in (0, 1)]
            for line in range(panel.table.rowCount())
        ]


class Matching(MatchWindow):
    def test_the_command_matches_and_ok_keeps_it_as_one_step(self):
        before = self.doc.UndoCount
        obj, panel = self.start()
        self.assertIsNotNone(panel)
        self.assertTrue(obj.Matched)
        whole_window("match")
        self.assertEqual(self.faces(panel), ["Left.Face1", "Right.Face1"])
        self.assertEqual(panel.summary.text(), obj.Summary)
        gap, angle, _, level, certain = self.cells(panel)
        self.assertEqual((angle[0], level, certain), ("3", ["G0", "G1"], ["yes", "yes"]))
        self.assertTrue(gap[1].startswith("\u2264") and angle[1].startswith("\u2264"))
        panel.tolerances.level.setCurrentText("G2")
        settle(0.8)
        self.assertEqual((obj.Target, obj.LevelAfter), ("G2", "G2"))
        self.ok()
        self.assertIsNone(obj.ViewObject.Proxy.panel)
        self.assertEqual(self.visible(), [obj.Name])
        self.assertEqual(self.doc.UndoCount, before + 1)
        self.doc.undo()
        settle()
        self.assertEqual(self.made(), [])
        self.assertEqual(self.visible(), ["Left", "Right"])
        self.doc.redo()
        settle()
        (again,) = self.made()
        self.assertEqual((again.LevelAfter, self.visible()), ("G2", [again.Name]))
        Gui.activeDocument().setEdit(again.Name)
        settle()
        self.assertEqual(again.ViewObject.Proxy.panel.tolerances.level.currentText(), "G2")
        self.cancel()

    def test_the_last_of_more_faces_joins_the_others(self):
        low, high = (
            models.add(self.doc, tilted(-30, 0, *ends), name)
            for name, ends in (("Low", (-20, 5)), ("High", (5, 20)))
        )
        moving = models.add(self.doc, tilted(0, 60, -20, 20, 0.02), "Moving")
        self.doc.recompute()
        obj, panel = self.start((low, "Face1"), (high, "Face1"), (moving, "Face1"))
        self.assertTrue(obj.Matched, obj.Summary)
        self.assertIn("Moving.Face1 joins Low.Face1, High.Face1", panel.summary.text())
        self.assertFalse(high.ViewObject.Visibility)
        self.assertEqual(panel.links("MoreFaces"), [(high, "Face1")])
        for chosen, faces in (((), 2), (((high, "Face1"),), 3)):
            self.use(panel, "MoreFaces", *chosen)
            settle(1.0)
            self.assertEqual(len(obj.Shape.Faces), faces)
        self.ok()
        self.assertEqual(len(obj.Shape.Faces), 3)

    def test_cancel_takes_all_of_it_back(self):
        obj, panel = self.start()
        panel.zebra.setChecked(True)
        settle()
        self.cancel()
        self.assertEqual(self.made(), [])
        self.assertEqual((self.visible(), zebra.objects(self.doc)), (["Left", "Right"], []))
        self.assertFalse(self.doc.HasPendingTransaction)

    def test_cancel_without_undo(self):
        self.doc.UndoMode = 0
        self.start()
        self.cancel()
        self.assertEqual((self.made(), self.visible()), ([], ["Left", "Right"]))
        obj, _ = self.start()
        self.ok()
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        self.field(panel, "moves").setCurrentText("Both")
        settle(0.8)
        self.assertEqual(obj.Moves, "Both")
        self.cancel()
        self.assertEqual((obj.Moves, self.visible()), ("Second", [obj.Name]))

    def test_cancel_of_a_later_change_restores_the_values(self):
        obj, _ = self.start()
        self.ok()
        report, steps = obj.Report, self.doc.UndoCount
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        panel.tolerances.level.setCurrentText("G2")
        self.field(panel, "moves").setCurrentText("First")
        settle(0.8)
        self.assertEqual((obj.Target, obj.Moves), ("G2", "First"))
        self.cancel()
        self.assertEqual((obj.Target, obj.Moves, obj.Report), ("G1", "Second", report))
        self.assertEqual((self.visible(), self.doc.UndoCount), ([obj.Name], steps))
        self.assertTrue(obj.Matched)

    def test_undo_and_closing_while_the_panel_is_open(self):
        obj, panel = self.start()
        panel.zebra.setChecked(True)
        panel.preview()
        self.ok()
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        panel.zebra.setChecked(True)
        panel.tolerances.level.setCurrentText("G2")
        self.doc.undo()
        settle(0.8)
        self.doc.undo()
        settle()
        Gui.activeDocument().resetEdit()
        settle()
        self.assertEqual(self.made(), [])
        self.assertFalse(Gui.Control.activeDialog())
        _, panel = self.start()
        panel.zebra.setChecked(True)
        self.field(panel, "max_move_mm").setValue(5.0)
        App.closeDocument(self.doc.Name)
        settle(0.8)
        self.assertFalse(Gui.Control.activeDialog())
        self.doc = App.newDocument("Again")

    def test_swap_lets_the_other_face_move(self):
        obj, panel = self.start()
        click(panel.swap, panel.swap.rect().center())
        self.assertEqual(self.faces(panel), ["Right.Face1", "Left.Face1"])
        self.assertTrue(obj.Matched)
        moved = obj.Shape.Faces[1].Surface.getPoles()
        self.assertLess(moved[-1][0].x, -10)
        first = panel.boxes["FirstFace"].chosen
        click(first, first.rect().center())
        (chosen,) = Gui.Selection.getSelectionEx()
        self.assertEqual((chosen.ObjectName, chosen.SubElementNames), ("Right", ("Face1",)))
        self.ok()

    def test_before_and_after_with_stripes(self):
        obj, panel = self.start()
        plain = dark_count(picture("match-plain"))
        panel.zebra.setChecked(True)
        settle()
        after = picture("match-after")
        self.assertEqual((self.visible(), zebra.objects(self.doc)), ([obj.Name], [obj]))
        self.assertGreater(dark_count(after), plain + MANY)
        panel.before.setChecked(True)
        settle()
        before = picture("match-before")
        self.assertEqual(self.visible(), ["Left", "Right"])
        self.assertGreater(dark_count(before), plain + MANY)
        self.assertGreater(int((abs(greys(before) - greys(after)) > 100).sum()), MANY)
        self.ok()
        self.assertEqual((self.visible(), zebra.objects(self.doc)), ([obj.Name], []))

    def test_a_limit_too_small_is_said_and_ok_waits(self):
        obj, panel = self.start()
        self.field(panel, "max_move_mm").setValue(0.001)
        settle(0.8)
        self.assertIn("0.001", panel.summary.text())
        self.assertEqual([line[1] for line in self.cells(panel)], ["\u2013"] * 5)
        self.assertEqual(self.visible(), ["Left", "Right"])
        self.ok()
        (text,) = messages()
        self.assertIn("0.001", text)
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.field(panel, "max_move_mm").setValue(0.0)
        self.assertEqual(self.field(panel, "max_move_mm").text(), "no limit")
        self.ok()
        self.assertEqual((obj.Matched, self.visible()), (True, [obj.Name]))

    def test_a_cancelled_preview_says_so(self):
        obj, panel = self.start()
        with CANCELLED:
            panel.preview()
            settle()
        self.assertIn("Cancelled", panel.summary.text())
        self.ok()
        self.assertEqual(match.error_text(obj), "")

    def test_wrong_selections_are_one_message(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        for chosen in (
            [(self.left, "Face1")],
            [(self.left, "Edge1"), (self.right, "Edge1")],
            [(box, "Edge1"), (box, "Edge2"), (box, "Edge3")],
        ):
            obj, _ = self.start(*chosen)
            (text,) = messages()
            self.assertIsNone(obj)
            self.assertIn("Select two faces", text)
        self.assertEqual(self.doc.UndoCount, 0)

    def test_whole_objects_of_one_face_can_be_selected(self):
        obj, _ = self.start((self.left, ""), (self.right, ""))
        self.assertEqual(match.link(obj, "SecondFace"), (self.right, "Face1"))
        self.cancel()

    def test_faces_that_cannot_be_matched_say_why(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        for names, text in (
            (("Face1", "Face2"), "no common boundary"),
            (("Face1", "Face3"), "Box.Face3 is a plane"),
        ):
            obj, panel = self.start(*((box, name) for name in names))
            self.assertIn(text, panel.summary.text())
            self.assertNotIn("Traceback", panel.summary.text())
            self.assertFalse(panel.after.isEnabled())
            self.assertTrue(panel.before.isChecked())
            self.assertTrue(box.ViewObject.Visibility)
            whole_window("match-without-result")
            self.use(panel, "FirstFace", (self.left, "Face1"))
            self.use(panel, "SecondFace", (self.right, "Face1"))
            settle(0.8)
            self.assertTrue(obj.Matched, obj.Summary)
            self.assertTrue(panel.after.isEnabled() and panel.after.isChecked())
            self.cancel()
            self.assertEqual(self.made(), [])

    def test_the_target_is_the_first_option(self):
        _, panel = self.start()
        level, moves = panel.tolerances.level, self.field(panel, "moves")
        self.assertTrue(panel.options.isAncestorOf(level))
        self.assertLess(level.y(), moves.y())
        self.assertEqual(level.x(), moves.x())
        whole_window("match-target")
        each = level.nextInFocusChain()
        while not (each.isVisible() and each.focusPolicy() & QtCore.Qt.TabFocus):
            each = each.nextInFocusChain()
        self.assertIs(each, moves)
        self.cancel()

    def test_nothing_moves_under_the_mouse(self):
        _, panel = self.start()

        def places():
            parts = (panel.options, panel.table, panel.before, *panel.tolerances.fields.values())
            return [part.mapTo(panel.form, QtCore.QPoint(0, 0)).y() for part in parts]

        before = places()
        for level in ("G2", "G1"):
            with held():
                panel.tolerances.level.setCurrentText(level)
                pause(1.5)
                self.assertTrue(panel.computation.line.isVisible())
                self.assertEqual(places(), before)
                whole_window("match-computes")
            settle(0.8)
            self.assertEqual(places(), before)
        whole_window("match-computed")
        self.cancel()

    def test_a_missing_kernel_is_one_message(self):
        with mock.patch.dict(sys.modules, seamwright=None):
            obj, _ = self.start()
        (text,) = messages()
        self.assertIsNone(obj)
        self.assertIn("It was built for Python", text)

    def test_deleting_the_match_or_failing_shows_the_sources(self):
        obj, _ = self.start()
        self.ok()
        obj.MaxMove = 0.001
        self.doc.recompute()
        settle()
        self.assertEqual(set(self.visible()) - {obj.Name}, {"Left", "Right"})
        obj.MaxMove = 0
        self.doc.recompute()
        settle()
        self.assertEqual(self.visible(), [obj.Name])
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand("Std_Delete")
        settle()
        self.assertEqual(self.visible(), ["Left", "Right"])

    def test_a_saved_match_opens_with_its_view(self):
        obj, _ = self.start()
        self.ok()
        self.left.ViewObject.Visibility = True
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with mock.patch.dict(sys.modules, seamwright=None):
                self.doc = App.openDocument(path)
                settle()
            (again,) = self.made()
            self.assertNotIn("Touched", again.State)
            self.assertEqual(self.visible(), ["Left", again.Name])
            self.assertEqual(
                again.ViewObject.Proxy.claimChildren(), [self.doc.Left, self.doc.Right]
            )
            again.ViewObject.Proxy.doubleClicked(again.ViewObject)
            settle()
            self.assertEqual(again.ViewObject.Proxy.panel.summary.text(), again.Summary)
            self.cancel()


    def test_faces_and_edge_are_picked_again(self):
        other = models.add(self.doc, models.two_sheets()[0], "Other")
        other.Placement = App.Placement(App.Vector(0, 0, 0.02), App.Rotation())
        other.ViewObject.Visibility = False
        self.doc.recompute()
        obj, panel = self.start()
        for chosen, said in (
            ((obj, "Face1"), "Show Before"),
            ((self.left, "Edge1"), "Choose one face"),
        ):
            self.use(panel, "FirstFace", chosen)
            (text,) = messages()
            self.assertRegex(text, said)
        self.assertEqual(match.link(obj, "FirstFace"), (self.left, "Face1"))
        self.use(panel, "FirstFace", (other, ""))  # as a whole: it has one face
        self.assertEqual(self.faces(panel), ["Other.Face1", "Right.Face1"])
        self.assertEqual((match.link(obj, "FirstFace"), obj.Matched), ((other, "Face1"), True))
        self.assertEqual(self.visible(), ["Left", obj.Name])
        at_seam = [abs(each.CenterOfMass.x) < 1e-6 for each in other.Shape.Edges]
        edge = other, "Edge%d" % (1 + at_seam.index(True))
        self.use(panel, "CommonEdge", edge)
        self.assertEqual((match.link(obj, "CommonEdge"), obj.Matched), (edge, True))
        click(panel.swap, panel.swap.rect().center())
        self.assertEqual((match.link(obj, "CommonEdge"), obj.Matched), (edge, True))
        whole_window("match-picked")
        panel.tolerances.level.setCurrentText("G2")
        settle(0.8)
        self.assertEqual(obj.Target, "G2")
        self.press_undo()
        self.assertEqual(obj.Target, "G1")
        self.press_undo()
        self.assertEqual(self.faces(panel), ["Other.Face1", "Right.Face1"])
        self.press_undo()
        self.assertIsNone(match.link(obj, "CommonEdge"))
        self.cancel()
        self.assertEqual(self.made(), [])
        self.assertEqual(self.visible(), ["Left", "Right", "Other"])


class Stripes(MatchWindow):
    def test_the_command_draws_and_takes_off(self):
        steps, modified = self.doc.UndoCount, Gui.getDocument(self.doc.Name).Modified
        nodes = self.left.ViewObject.RootNode.getNumChildren()
        without = picture("zebra-without")
        Gui.runCommand(ZEBRA)
        settle()
        self.assertEqual(zebra.objects(self.doc), [self.left, self.right])
        shown = picture("zebra")
        whole_window("zebra-window")
        self.assertGreater(dark_count(shown), dark_count(without) + MANY)
        self.assertGreater(area_count(abs(greys(shown) - greys(without)) > 30), MANY)
        Gui.runCommand(ZEBRA)
        settle()
        self.assertEqual(zebra.objects(self.doc), [])
        changed = abs(greys(picture("zebra-off")) - greys(without)) > 30
        self.assertEqual(area_count(changed), 0)
        self.assertEqual(self.left.ViewObject.RootNode.getNumChildren(), nodes)
        self.assertEqual(
            (self.doc.UndoCount, Gui.getDocument(self.doc.Name).Modified), (steps, modified)
        )

    def test_stripes_can_be_removed_whatever_is_selected(self):
        mesh = self.doc.addObject("Mesh::Feature", "Mesh")
        zebra.show([self.left])
        Gui.Selection.addSelection(mesh)
        Gui.runCommand(ZEBRA)
        self.assertEqual((zebra.objects(self.doc), messages()), ([], []))
        Gui.runCommand(ZEBRA)
        self.assertIn("Mesh is a mesh", messages()[0])

    def test_the_selected_object_alone(self):
        Gui.Selection.addSelection(self.left)
        Gui.runCommand(ZEBRA)
        settle()
        self.assertEqual(zebra.objects(self.doc), [self.left])
        self.assertEqual(Gui.Selection.getSelection(), [])
        Gui.Selection.addSelection(self.left)
        Gui.Selection.addSelection(self.right)
        Gui.runCommand(ZEBRA)
        self.assertEqual(zebra.objects(self.doc), [self.left, self.right])

    def test_stripes_on_a_hidden_object_are_refused(self):
        self.left.ViewObject.Visibility = False
        Gui.Selection.addSelection(self.left)
        Gui.runCommand(ZEBRA)
        self.assertEqual(messages(), ["Hidden: Left. Show what is to have stripes."])
        self.assertEqual(zebra.objects(self.doc), [])

    def test_stripes_break_at_a_kink_and_run_on_over_a_smooth_seam(self):
        view = Gui.activeDocument().activeView()
        jumps = []
        for slope in (models.SHEETS_DEG, 0.0):
            self.right.Shape = models.sheet(1, slope)
            self.doc.recompute()
            zebra.show([self.left, self.right])
            view.viewTop()
            view.fitAll()
            settle()
            lines = greys(picture("zebra-seam-%g" % slope))
            # The seam is near the middle: fitAll() centres by some pixels differently in different
            # releases.
            middle, inside = lines.shape[1] // 2, slice(
                lines.shape[0] // 2 - 150, lines.shape[0] // 2 + 150
            )
            near = range(middle - 20, middle + 20)
            jumps.append(
                max(
                    int((abs(lines[inside, x - 1] - lines[inside, x + 1]) > 150).sum())
                    for x in near
                )
            )
        self.assertGreater(jumps[0], 3 * jumps[1] + 20)

    def test_stripes_follow_shape_place_and_visibility(self):
        Gui.Selection.addSelection(self.left)
        Gui.runCommand(ZEBRA)
        first = picture("zebra-first")
        self.left.Shape = models.sheet(-1, bend=0.05)
        settle()
        self.assertGreater(
            int((abs(greys(picture("zebra-changed")) - greys(first)) > 100).sum()), MANY
        )
        self.left.ViewObject.Visibility = False
        settle()
        hidden = dark_count(picture("zebra-hidden"))
        zebra.hide([self.left])
        self.assertEqual(dark_count(picture("zebra-hidden-off")), hidden)
        zebra.show([self.left])
        self.assertEqual(dark_count(picture("zebra-hidden-on")), hidden)
        self.left.ViewObject.Visibility = True
        self.left.Placement = App.Placement(App.Vector(0, 40, 0), App.Rotation())
        settle()
        self.fit()
        self.assertGreater(dark_count(picture("zebra-moved")), hidden + MANY)
        self.doc.removeObject("Left")
        settle()
        self.assertEqual(zebra.objects(self.doc), [])

    def test_stripes_on_a_body_a_link_and_a_part(self):
        Gui.runCommand(ZEBRA)
        zebra.hide(
            zebra.objects(self.doc)
        )  # from now on changes are followed, also those of the new objects below
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.addObject(self.doc.addObject("PartDesign::AdditiveSphere", "Ball"))
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(models.add(self.doc, models.sheet(1), "Inner"))
        link = self.doc.addObject("App::Link", "Twin")
        link.LinkedObject = self.right
        for moved in (part, link):
            moved.Placement = App.Placement(App.Vector(0, 60, 0), App.Rotation())
        self.doc.recompute()
        for chosen, striped in ((body, "Body"), (part, "Inner"), (link, "Twin")):
            with self.subTest(striped):
                for obj in self.doc.Objects:
                    obj.ViewObject.Visibility = obj.Name in (chosen.Name, striped)
                settle()
                self.fit()
                without = dark_count(picture("zebra-%s-off" % striped))
                Gui.Selection.clearSelection()
                Gui.Selection.addSelection(chosen)
                Gui.runCommand(ZEBRA)
                settle()
                self.assertEqual([obj.Name for obj in zebra.objects(self.doc)], [striped])
                self.assertGreater(dark_count(picture("zebra-%s" % striped)), without + MANY)
                zebra.hide(zebra.objects(self.doc))
        for obj in self.doc.Objects:
            obj.ViewObject.Visibility = True
        Gui.Selection.clearSelection()
        Gui.runCommand(ZEBRA)
        self.assertEqual(
            {obj.Name for obj in zebra.objects(self.doc)},
            {"Left", "Right", "Body", "Inner", "Twin"},
        )

    def test_a_closed_document_takes_its_stripes_along(self):
        other = App.newDocument("Other")
        models.add(other, models.sheet(1), "Sheet")
        Gui.runCommand(ZEBRA)
        self.assertEqual(len(zebra.objects(other)), 1)
        App.closeDocument("Other")
        settle()
        again = App.newDocument("Other")
        self.assertEqual(zebra.objects(again), [])
        App.closeDocument("Other")
        App.setActiveDocument(self.doc.Name)

    def test_faces_can_still_be_picked(self):
        Gui.runCommand(ZEBRA)
        settle()
        view = Gui.activeDocument().activeView()
        hit = view.getObjectInfo(view.getPointOnScreen(App.Vector(-10, 3, 1)))
        self.assertEqual((hit["Object"], hit["Component"]), ("Left", "Face1"))

    def test_nothing_to_stripe_is_one_message(self):
        line = models.add(self.doc, Part.makeLine((0, 0, 0), (1, 0, 0)), "Line")
        Gui.Selection.addSelection(line)
        Gui.runCommand(ZEBRA)
        settle()
        (text,) = messages()
        self.assertIn("has no faces", text)
        self.left.ViewObject.Visibility = self.right.ViewObject.Visibility = False
        Gui.Selection.clearSelection()
        Gui.runCommand(ZEBRA)
        settle()
        (text,) = messages()
        self.assertIn("No visible object", text)


os.makedirs(OUT, exist_ok=True)
