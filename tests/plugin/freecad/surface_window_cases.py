# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces in FreeCAD's window; run by run_freecad.py --window."""

import os
import tempfile

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from curve_cases import slot
from free_surface_cases import rim, spoke
from PySide import QtCore
from surface_cases import at_x, sheet
from window import (
    PanelWindow,
    click,
    click_row,
    count,
    messages,
    mouse_event,
    pause,
    picture,
    press_escape,
    press_key,
    settle,
    whole_window,
)

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.document.surfaces.kinds import KINDS
from freecad.seamwright.gui.base.option_panel import PREVIEW_AFTER_MS
from freecad.seamwright.gui.scene.handle import COLOUR as HANDLE
from freecad.seamwright.gui.scene.marker import INK
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.surfaces.view import COLOUR
from freecad.seamwright.plain import surface_text

RESULT = len(surface_text.COLUMNS) - 1
BALL = [round(255 * each) for each in HANDLE]


class SurfaceWindow(PanelWindow):
    is_made = staticmethod(surface.is_surface)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        self.high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        self.doc.clearUndos()
        self.start_edge = self.low, at_x(self.low, 30)
        self.end_edge = self.high, at_x(self.high, 60)

    def start(self, kind, *chosen):
        self.COMMAND = "Seamwright_" + kind
        found = self.run_selected(chosen)
        if found[0] is not None:
            self.fit()
        return found

    def blend(self):
        return self.start("BlendSurface", self.start_edge, self.end_edge)

    def select(self, *chosen):
        Gui.Selection.clearSelection()
        for obj, name in chosen:
            Gui.Selection.addSelection(self.doc.Name, obj.Name, name)

    def set_field(self, panel, argument, value):
        panel.options.fields[argument].show_value(value)
        settle(0.1 + PREVIEW_AFTER_MS / 1000)

    def check_table_shows(self, table, rows):
        """All rows and columns are seen, the result second, and nothing is empty below."""
        self.assertEqual((table.rowCount(), table.visualColumn(RESULT)), (rows, 1))
        bars = table.horizontalScrollBar(), table.verticalScrollBar()
        self.assertEqual([bar.isVisible() for bar in bars], [False, False])
        room = table.viewport().height() - rows * table.rowHeight(0)
        self.assertLess(abs(room), table.rowHeight(0) / 2)

    def use(self, panel, name):
        click(panel.boxes[name].use, panel.boxes[name].use.rect().center())


class Panel(SurfaceWindow):
    def test_each_kind_is_made_accepted_undone_and_done_again(self):
        spokes = models.add(self.doc, Part.Compound([spoke(k) for k in range(5)]), "Spokes")
        self.doc.recompute()
        chosen = {"ExtendSurface": [self.start_edge], "Umbrella": [(spokes, "")]}
        for kind in KINDS:
            with self.subTest(kind):
                steps, before = self.doc.UndoCount, self.doc.Objects
                obj, panel = self.start(kind, *chosen.get(kind, [self.start_edge, self.end_edge]))
                self.assertEqual(panel.summary.text(), obj.Summary)
                self.assertTrue(obj.Reached and not obj.Shape.isNull())
                whole_window("surface-" + kind)
                self.ok()
                self.assertIsNone(obj.ViewObject.Proxy.panel)
                self.assertEqual(self.doc.UndoCount, steps + 1)
                self.doc.undo()
                settle()
                self.assertEqual(self.doc.Objects, before)
                self.doc.redo()
                settle()
                (again,) = [each for each in self.doc.Objects if each not in before]
                self.assertFalse(again.Shape.isNull())
                self.doc.removeObject(again.Name)

    def test_an_umbrella_shows_a_row_for_each_edge_and_follows_the_fields(self):
        spokes = models.add(self.doc, Part.Compound([spoke(k) for k in range(5)]), "Spokes")
        self.doc.recompute()
        obj, panel = self.start("Umbrella", (spokes, ""))
        self.assertEqual(sorted(self.column(panel, 1)), ["Edge %d" % k for k in range(1, 6)])
        self.assertEqual(set(self.column(panel, RESULT)), {"G1 is met"})
        self.assertFalse(panel.options.fields["curvature_rel"].widget.isVisible())
        self.assertEqual(panel.options.fields["degree"].widget.text(), "automatic")
        before = count(picture("umbrella"), INK)
        click_row(panel.table, 1)
        self.assertGreater(count(picture("umbrella-row"), INK), before + 20)
        panel.zebra.setChecked(True)
        settle()
        self.check_table_shows(panel.table, 5)
        self.assertEqual(zebra.objects(self.doc), [obj])  # the edges of the sources stay seen
        whole_window("umbrella")
        self.set_field(panel, "open", True)
        self.assertEqual((panel.table.rowCount(), len(obj.Shape.Faces)), (3, 4))
        self.ok()
        self.assertEqual(len(obj.Shape.Faces), 4)

    def test_an_umbrella_gets_curvature_and_an_outer_boundary(self):
        spokes = models.add(self.doc, Part.Compound([spoke(2 * k, 10) for k in range(5)]), "Spokes")
        rims = Part.Compound([rim(k, side) for k in range(5) for side in (1, -1)])
        outer = models.add(self.doc, rims, "Rims")
        self.doc.recompute()
        obj, panel = self.start("Umbrella", (spokes, ""))
        self.set_field(panel, "order", "G2")
        settle(1.0)
        self.assertEqual(set(self.column(panel, RESULT)), {"G2 is met"})
        self.assertTrue(panel.options.fields["curvature_rel"].widget.isVisible())
        self.assertIn("curvature at most", panel.summary.text())
        self.select(*((outer, "Edge%d" % number) for number in range(1, 11)))
        self.use(panel, "Boundary")
        settle(1.0)
        self.assertIn("with G2 the outer boundary is found", panel.summary.text())
        self.set_field(panel, "order", "G1")
        settle(1.0)
        self.assertEqual(set(self.column(panel, RESULT)), {"G1 is met"})
        self.assertTrue(panel.summary.text().endswith("; the outer boundary stays."))
        whole_window("umbrella-boundary")
        self.select()
        self.use(panel, "Boundary")
        settle(1.0)
        self.assertNotIn("boundary", panel.summary.text())
        self.ok()
        self.assertEqual((obj.Order, obj.Boundary), ("G1", []))

    def test_a_deleted_lateral_boundary_is_forgotten_by_an_empty_selection(self):
        obj, panel = self.blend()
        ends = [
            min(
                (vertex.Point for vertex in each.Shape.Vertexes if abs(vertex.X - x) < 1e-6),
                key=lambda point: point.y,
            )
            for each, x in ((self.low, 30), (self.high, 60))
        ]
        wall = models.add(self.doc, Part.makeLine(*ends), "Wall")
        self.doc.recompute()
        self.set_field(panel, "start_order", "G0")
        self.set_field(panel, "end_order", "G0")
        self.select((wall, "Edge1"))
        self.use(panel, "Lateral")
        self.assertEqual(len(obj.Lateral), 1)
        self.ok()
        self.doc.removeObject(wall.Name)
        self.doc.recompute()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle(0.5)
        panel = obj.ViewObject.Proxy.panel
        self.assertIn("Wall was deleted", panel.summary.text())
        self.select()
        self.use(panel, "Lateral")
        self.assertIn("Every seam has its level", panel.summary.text())
        self.ok()
        self.assertFalse(obj.Shape.isNull())

    def test_the_figures_follow_the_fields(self):
        obj, panel = self.blend()
        self.assertEqual(self.column(panel, 0), ["Start", "End"])
        names = ["%s.%s" % (each.Label, name) for each, name in (self.start_edge, self.end_edge)]
        self.assertEqual(self.column(panel, 1), names)
        self.assertEqual(self.column(panel, RESULT), ["G2 is met", "G2 is met"])
        self.check_table_shows(panel.table, 2)
        self.assertTrue(panel.table.isColumnHidden(surface_text.CHANGE))
        self.assertTrue(panel.options.fields["start_tension"].widget.isVisible())
        self.set_field(panel, "start_order", "G0")
        self.assertFalse(panel.options.fields["start_tension"].widget.isVisible())
        self.assertEqual(obj.StartOrder, "G0")
        self.assertEqual(self.column(panel, RESULT), ["G0 is met", "G2 is met"])
        self.assertGreater(float(self.column(panel, 3)[0].split("..")[0]), 1)
        before = count(picture("surface-row-off"), INK)
        click_row(panel.table, 1)
        self.assertGreater(count(picture("surface-row-on"), INK), before + 50)
        self.set_field(panel, "end_order", "G3")
        self.assertEqual(self.column(panel, RESULT)[1], "G3 is met")
        self.assertFalse(panel.table.isColumnHidden(surface_text.CHANGE))
        change = self.column(panel, surface_text.CHANGE)
        self.assertEqual([text == "\u2013" for text in change], [True, False])
        self.check_table_shows(panel.table, 2)
        whole_window("surface-change")
        area = obj.Shape.Area
        self.set_field(panel, "end_tension", 2.0)
        self.assertGreater(abs(obj.Shape.Area - area), 0.5)
        self.set_field(panel, "gap_mm", 1e-12)
        self.assertFalse(obj.Reached)
        self.assertIn("Not reached", panel.summary.text())
        self.cancel()
        self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))

    def test_a_surface_that_folds_over_is_a_warning(self):
        far = models.add(self.doc, sheet(60, 40, 0.3), "Far")
        self.doc.recompute()
        obj, panel = self.start("BlendSurface", self.start_edge, (far, at_x(far, 60)))
        self.assertEqual(panel.summary.styleSheet(), "")
        for name in ("start_tension", "end_tension"):
            self.set_field(panel, name, 5.0)
        self.assertIn("but the surface turns back", panel.summary.text())
        self.assertIn("color", panel.summary.styleSheet())
        whole_window("surface-fold")
        for name in ("start_tension", "end_tension"):
            self.set_field(panel, name, 1.0)
        self.assertEqual((panel.summary.text(), panel.summary.styleSheet()), (obj.Summary, ""))
        self.cancel()

    def test_cancel_of_a_later_change_restores_the_values(self):
        obj, _ = self.blend()
        self.ok()
        for undo in (1, 0):
            self.doc.UndoMode = undo
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.set_field(panel, "start_order", "G0")
            self.select((self.high, at_x(self.high, 90)))
            self.use(panel, "End")
            self.assertEqual(obj.End, [(self.high, (at_x(self.high, 90),))])
            self.cancel()
            self.assertEqual((obj.StartOrder, obj.End), ("G2", [(self.high, (self.end_edge[1],))]))
            self.assertTrue(obj.Reached)

    def test_cancel_and_the_undo_of_a_deletion_leave_no_mark_in_the_tree(self):
        obj, panel = self.blend()
        self.ok()
        Gui.getDocument(self.doc.Name).setEdit(obj.Name)
        settle()
        self.set_field(obj.ViewObject.Proxy.panel, "start_order", "G1")
        self.assertEqual(obj.StartOrder, "G1")
        self.cancel()
        self.assertEqual((obj.StartOrder, obj.State), ("G2", ["Up-to-date"]))
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.high.Name)
        self.doc.recompute()
        self.doc.commitTransaction()
        settle()
        self.assertIn("Invalid", obj.State)
        self.doc.undo()
        settle()
        self.assertEqual((obj.State, self.doc.RedoCount), (["Up-to-date"], 1))
        self.assertFalse(obj.Shape.isNull())
        obj.StartOrder = "G1"
        self.doc.recompute()
        self.assertEqual(report_of(obj)["seams"][0]["target"], "G1")

    def test_a_tension_is_changed_by_its_handle(self):
        obj, panel = self.blend()
        self.assertEqual(sorted(panel._handles), ["end_tension", "start_tension"])
        self.assertFalse(obj.ViewObject.Selectable)
        handle = panel._handles["start_tension"]
        handle.dragger.translation = (2 * handle._unit, 0.0, 0.0)
        settle(0.2 + PREVIEW_AFTER_MS / 1000)
        self.assertAlmostEqual(obj.StartTension, 2, delta=1e-6)
        self.assertTrue(obj.Reached)
        self.ok()
        self.assertEqual(panel._handles, {})
        self.assertTrue(obj.ViewObject.Selectable)

    def test_a_document_that_is_saved_meanwhile_opens_with_its_view(self):
        obj, _ = self.blend()
        name = obj.Name
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            settle()
        again = self.doc.getObject(name)
        self.assertTrue(again.ViewObject.Selectable)
        for one, other in zip(again.ViewObject.ShapeColor, COLOUR):
            self.assertAlmostEqual(one, other, delta=1 / 255)  # saved as a byte
        self.assertNotIn("Touched", again.State)
        again.ViewObject.Proxy.doubleClicked(again.ViewObject)
        settle()
        panel = again.ViewObject.Proxy.panel
        self.assertEqual(self.column(panel, RESULT), ["G2 is met", "G2 is met"])
        self.set_field(panel, "start_order", "G1")
        self.ok()
        self.assertEqual((again.StartOrder, again.Reached), ("G1", True))

    def test_stripes_are_drawn_while_the_panel_is_open(self):
        obj, panel = self.blend()
        panel.zebra.setChecked(True)
        settle()
        self.assertEqual(set(zebra.objects(self.doc)), {obj, self.low, self.high})
        self.assertGreater(count(picture("surface-stripes-balls"), BALL, reach=60), 50)
        whole_window("surface-stripes")
        self.set_field(panel, "start_order", "G1")
        settle()
        whole_window("surface-stripes-g1")
        panel.zebra.setChecked(False)
        self.assertEqual(zebra.objects(self.doc), [])
        panel.zebra.setChecked(True)
        self.ok()
        self.assertEqual(zebra.objects(self.doc), [])


class Keys(SurfaceWindow):
    def press_keys(self, key, *modifiers):
        held = QtCore.Qt.KeyboardModifiers()
        for each in modifiers:
            held |= each
        press_key(key, held)
        settle(0.1 + PREVIEW_AFTER_MS / 1000)

    def undo(self):
        self.press_keys(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)

    def redo(self):
        self.press_keys(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier, QtCore.Qt.ShiftModifier)

    def slide(self, panel, value):
        handle = panel._handles["start_tension"]
        handle.dragger.translation = (value * handle._unit, 0.0, 0.0)
        settle(0.2 + PREVIEW_AFTER_MS / 1000)

    def mouse(self, kind, place, button, held):
        target = Gui.activeDocument().activeView().graphicsView().viewport()
        mouse_event(target, QtCore.QPointF(*place), kind, button, held)
        pause(0.03)

    def places(self, obj, *values):
        """The pixels of the start's handle for some values."""
        origin, step = (App.Vector(*each) for each in report_of(obj)["handles"]["start_tension"])
        projection = Projection(Gui.activeDocument().activeView())
        return projection.pixels([tuple(origin + step * value) for value in values])

    def grab(self, start, end):
        """Press the left button at a place, and go most of the way to another one."""
        left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
        self.mouse(QtCore.QEvent.MouseMove, start, none, none)
        self.mouse(QtCore.QEvent.MouseButtonPress, start, left, left)
        for share in (0.25, 0.5, 0.75):
            self.mouse(QtCore.QEvent.MouseMove, start + share * (end - start), none, left)
        settle(0.2 + PREVIEW_AFTER_MS / 1000)

    def release(self, place):
        left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
        self.mouse(QtCore.QEvent.MouseMove, place, none, left)
        self.mouse(QtCore.QEvent.MouseButtonRelease, place, left, none)
        settle(0.2 + PREVIEW_AFTER_MS / 1000)

    def test_undo_takes_the_last_change_back_and_the_panel_stays(self):
        obj, panel = self.blend()
        first = obj.StartTension
        self.undo()  # nothing to take back
        self.slide(panel, 2.0)
        self.slide(panel, 1.5)
        self.set_field(panel, "end_order", "G1")
        self.select((self.high, at_x(self.high, 90)))
        self.use(panel, "End")
        self.undo()
        self.assertEqual(obj.End, [(self.high, (self.end_edge[1],))])
        self.assertEqual(panel.boxes["End"].chosen.text(), "High." + self.end_edge[1])
        panel.options.fields["gap_mm"].widget.setFocus()  # wherever the key is pressed
        self.undo()
        self.assertEqual((obj.EndOrder, round(obj.StartTension, 6)), ("G2", 1.5))
        self.undo()
        self.assertAlmostEqual(obj.StartTension, 2, delta=1e-6)
        self.undo()
        self.undo()  # no step is left
        self.assertEqual(obj.StartTension, first)
        for _ in range(4):
            self.redo()
        self.assertEqual((obj.EndOrder, round(obj.StartTension, 6)), ("G1", 1.5))
        self.assertEqual(obj.End, [(self.high, (at_x(self.high, 90),))])
        self.assertEqual(obj.ViewObject.Proxy.panel, panel)
        self.ok()
        self.assertEqual(self.doc.UndoCount, 1)

    def test_a_handle_behind_a_face_is_seen_and_dragged(self):
        obj, panel = self.blend()
        roof = models.add(self.doc, Part.makePlane(100, 60, App.Vector(-5, -10, 60)), "Roof")
        self.doc.recompute()
        Gui.activeDocument().activeView().viewTop()
        Gui.activeDocument().activeView().fitAll()
        settle()
        self.assertGreater(count(picture("handle-behind"), BALL, reach=60), 50)
        start, end = self.places(obj, 1, 2)
        self.grab(start, end)
        self.release(end)
        self.assertGreater(obj.StartTension, 1.3)
        self.assertTrue(roof.ViewObject.Visibility)
        self.cancel()

    def test_escape_takes_a_drag_back_and_then_is_cancel(self):
        obj, panel = self.blend()
        self.slide(panel, 1.5)
        start, end = self.places(obj, 1.5, 3)
        self.grab(start, end)
        self.assertGreater(obj.StartTension, 2)
        press_escape()
        settle()
        self.release(end)
        self.assertEqual(obj.ViewObject.Proxy.panel, panel)
        self.assertAlmostEqual(obj.StartTension, 1.5, delta=1e-6)
        self.assertAlmostEqual(panel._handles["start_tension"].number(), 1.5, delta=1e-6)
        for focus in (panel.options.fields["gap_mm"].widget, None):
            if focus is not None:
                focus.setFocus()
            else:
                _, panel = self.blend()
                Gui.activeDocument().activeView().graphicsView().setFocus()
            press_escape()
            settle(0.5)
            self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))


class Picking(SurfaceWindow):
    def test_a_bad_selection_is_one_sentence_and_changes_nothing(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        self.doc.clearUndos()
        for kind, chosen, text in (
            ("BlendSurface", [], "Nothing is selected: select the edges of two sides"),
            ("BlendSurface", [self.start_edge], "The selection has 1 edge, in 1 chain: select"),
            ("ExtendSurface", [(box, "Edge1")], "Box.Edge1 lies between Box.Face"),
        ):
            with self.subTest(text):
                self.start(kind, *chosen)
                (found,) = messages()
                self.assertTrue(found.startswith(text) and found.count(". ") == 0, found)
                self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))
                self.assertFalse(self.doc.HasPendingTransaction)

    def test_a_side_is_picked_again_and_a_bad_pick_is_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj, panel = self.blend()
        self.assertEqual(panel.boxes["Lateral"].chosen.text(), "nothing")
        self.select((box, "Edge1"))
        self.use(panel, "Start")
        self.assertIn("lies between", messages()[0])
        self.select((self.high, at_x(self.high, 90)))
        self.use(panel, "End")
        self.assertEqual(panel.boxes["End"].chosen.text(), "High." + at_x(self.high, 90))
        self.select((obj, "Edge1"))
        self.use(panel, "End")
        self.assertIn("No edge is chosen", messages()[0])
        self.ok()
        self.assertEqual(obj.End, [(self.high, (at_x(self.high, 90),))])

    def test_four_edges_around_a_hole(self):
        shell = models.add(self.doc, models.around_a_hole(), "Shell")
        for each in (self.low, self.high):
            each.ViewObject.Visibility = False
        self.doc.recompute()
        inside = [
            (shell, "Edge%d" % number)
            for number, edge in enumerate(shell.Shape.Edges, 1)
            if all(19.9 < c < 40.1 for p in edge.discretize(3) for c in (p.x, p.y))
        ]
        obj, panel = self.start("BlendSurface", *inside)
        self.set_field(panel, "lateral_order", "G1")
        self.assertEqual(sorted(self.column(panel, 0)), ["End", "Lateral", "Lateral", "Start"])
        self.assertTrue(obj.Reached)
        whole_window("surface-hole")
        fields = panel.options.fields
        seen = [fields[each].widget.isVisible() for each in ("lateral_order", "flip")]
        self.assertEqual(seen, [True, False])
        self.select()
        self.use(panel, "Lateral")
        self.assertEqual((obj.Lateral, self.column(panel, 0)), ([], ["Start", "End"]))
        seen = [fields[each].widget.isVisible() for each in ("lateral_order", "flip")]
        self.assertEqual(seen, [False, True])
        self.cancel()

    def test_a_chain_is_added_with_one_click(self):
        face = models.add(self.doc, Part.Face(slot()), "Slot")
        for each in (self.low, self.high):
            each.ViewObject.Visibility = False
        self.doc.recompute()
        obj, panel = self.start("ExtendSurface", (face, "Edge1"))
        click(panel.boxes["Side"].chain, panel.boxes["Side"].chain.rect().center())
        self.assertEqual(len(obj.Side[0][1]), 4)
        self.assertTrue(obj.Reached)
        self.assertEqual(len(self.column(panel, 0)), 4)
        whole_window("surface-chain")
        self.ok()

    def test_an_extension_ends_at_a_face(self):
        obj, panel = self.start("ExtendSurface", self.start_edge)
        self.assertEqual(list(panel._handles), ["length_mm"])
        wall = models.add(self.doc, Part.makePlane(300, 300), "Wall")
        wall.Placement.Base.z = 13
        wall.Placement.Base.x = wall.Placement.Base.y = -100
        self.doc.recompute()
        self.select((wall, "Face1"))
        self.use(panel, "UpTo")
        self.assertEqual((obj.Until, obj.UpTo), ("Face", [(wall, ("Face1",))]))
        self.assertFalse(panel.options.fields["length_mm"].widget.isVisible())
        self.assertEqual((panel.summary.text(), panel._handles), (obj.Summary, {}))
        self.assertTrue(obj.Reached, obj.Summary)
        panel.key("undo")
        settle()
        self.assertEqual((obj.Until, obj.UpTo), ("Length", []))
        panel.key("redo")
        settle()
        self.assertEqual((obj.Until, obj.UpTo), ("Face", [(wall, ("Face1",))]))
        self.select()
        self.use(panel, "UpTo")
        self.assertEqual((obj.Until, obj.UpTo), ("Length", []))
        self.assertTrue(panel.options.fields["length_mm"].widget.isVisible())
        self.ok()
