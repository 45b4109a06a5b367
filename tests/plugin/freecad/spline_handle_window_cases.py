# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles and picked points of splines in FreeCAD's window; run by run_freecad.py --window."""

import math
import time

import FreeCAD as App
import FreeCADGui as Gui
import models
import numpy
import Part
from curve_cases import WAVE, vertices
from curve_window_cases import CurveWindow
from PySide import QtCore, QtGui
from window import click, count, messages, mouse_event, pause, picture, settle, whole_window

from freecad.seamwright.document.curves import kinds
from freecad.seamwright.document.curves.spline import BETA
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.option_feature import links_of
from freecad.seamwright.gui.scene.live_curve import LINE_COLOUR, TANGENT, TENSION
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.widgets.qt import QtWidgets

#: Updates in a second that 50 points must have.
LEAST_RATE = 30


def view():
    return Gui.activeDocument().activeView()


def viewport():
    return view().graphicsView().viewport()


def mouse(kind, point, button=QtCore.Qt.NoButton, held=QtCore.Qt.NoButton, aside=(0, 0)):
    """Send one event of the mouse at a point of the model, some pixels aside."""
    ((x, y),) = Projection(view()).pixels([point])
    local = QtCore.QPointF(x + aside[0], y + aside[1])
    mouse_event(viewport(), local, kind, button, held)
    pause(0.02)


def grab(point):
    mouse(QtCore.QEvent.MouseMove, point)
    mouse(QtCore.QEvent.MouseButtonPress, point, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton)


def pass_over(start, end, steps=6):
    start, end = numpy.array(start, float), numpy.array(end, float)
    for k in range(1, steps + 1):
        at = start + (end - start) * k / steps
        mouse(QtCore.QEvent.MouseMove, at, held=QtCore.Qt.LeftButton)


def drop(point):
    mouse(QtCore.QEvent.MouseButtonRelease, point, QtCore.Qt.LeftButton)


def drag(start, end):
    grab(start)
    pass_over(start, end)
    drop(end)


def click_at(point, aside=(0, 0)):
    left = QtCore.Qt.LeftButton
    mouse(QtCore.QEvent.MouseMove, point, aside=aside)
    mouse(QtCore.QEvent.MouseButtonPress, point, left, left, aside)
    mouse(QtCore.QEvent.MouseButtonRelease, point, left, aside=aside)


def key(which, modifiers=QtCore.Qt.NoModifier):
    """Press a key as the window gets it, with the question whether it is a shortcut before."""
    target = Gui.getMainWindow().windowHandle()
    for kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, which, modifiers))
    pause(0.05)


class SplineWindow(CurveWindow):
    def top(self):
        view().viewTop()
        view().fitAll()
        settle(0.4)

    def spline(self, **given):
        obj, panel = self.start("Spline", self.points)
        for argument, value in given.items():
            self.set_field(panel, argument, value)
        self.top()
        return obj, panel

    def place(self, panel, kind, number):
        return panel.editor.drawing.places[kind][number]

    def made_points(self, obj):
        return numpy.array(report_of(obj)["points_mm"])


class Projections(SplineWindow):
    def test_pixels_are_those_of_freecad(self):
        models.add(self.doc, Part.makeBox(10, 20, 30), "Box")
        self.doc.recompute()
        points = numpy.array([(0, 0, 0), (10, 20, 30), (-5, 12, 3.5)], float)
        for camera in ("Orthographic", "Perspective"):
            view().setCameraType(camera)
            for turn in ("viewTop", "viewFront", "viewIsometric"):
                with self.subTest((camera, turn)):
                    getattr(view(), turn)()
                    view().fitAll()
                    settle(0.3)
                    projection = Projection(view())
                    pixels = projection.pixels(points)
                    on_screen = getattr(view(), "getPointOnViewport", None)
                    on_screen = on_screen or view().getPointOnScreen
                    for point, pixel in zip(points, pixels):
                        # FreeCAD counts pixels of the screen, from the bottom.
                        found = numpy.array(on_screen(App.Vector(*point)))
                        x, y = found / viewport().devicePixelRatioF()
                        self.assertLess(abs(pixel[0] - x), 2)
                        self.assertLess(abs(viewport().height() - pixel[1] - y), 2)
                        axis = projection.facing_axis()
                        back = projection.on_plane(pixel, point, axis)
                        numpy.testing.assert_allclose(back, point, atol=1e-4)
                        line = projection.along_line(pixel, point - [3, 1, 2], (3.0, 1.0, 2.0))
                        self.assertAlmostEqual(line, 1, delta=1e-4)
                    self.assertEqual(tuple(axis), (0, 1, 0) if turn == "viewFront" else (0, 0, 1))
        view().setCameraType("Orthographic")


class Drags(SplineWindow):
    def test_a_point_is_dragged_undone_and_done_again(self):
        obj, panel = self.spline()
        target = (30, 26, 0)
        panel.comb.setChecked(True)
        grab(WAVE[2])
        pass_over(WAVE[2], target)
        self.assertEqual(list(obj.Moves), [])  # the document waits until the drag ends
        self.assertGreater(count(picture("drag"), [round(255 * c) for c in LINE_COLOUR]), 300)
        whole_window("spline-drag")
        drop(target)
        self.wait()
        expected = numpy.array(WAVE, float)
        expected[2] = target
        numpy.testing.assert_allclose(self.made_points(obj), expected, atol=0.05)
        self.assertEqual(self.made_points(obj)[2][2], 0)
        self.assertLess(obj.Shape.distToShape(Part.Vertex(*self.made_points(obj)[2]))[0], 1e-7)
        whole_window("spline-dragged")
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj), WAVE, atol=1e-12)
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier | QtCore.Qt.ShiftModifier)
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj), expected, atol=0.05)
        click(panel.box.undo, panel.box.undo.rect().center())
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj), WAVE, atol=1e-12)
        self.assertTrue(panel.box.redo.isEnabled())
        click(panel.box.redo, panel.box.redo.rect().center())
        self.wait()
        self.ok()
        self.assertEqual(self.doc.UndoCount, 1)
        self.assertEqual(len(obj.Moves), 5)
        self.doc.undo()
        settle()
        self.assertEqual(self.made(), [])
        self.doc.redo()
        settle()
        numpy.testing.assert_allclose(self.made_points(self.made()[0]), expected, atol=0.05)

    def test_a_drag_of_a_later_edit_is_one_undo_step_and_cancel_takes_it_back(self):
        obj, _ = self.spline()
        self.ok()
        for accepted in (True, False):
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle(0.5)
            drag(WAVE[1], (12, 27, 0))
            self.wait()
            self.assertGreater(abs(self.made_points(obj)[1] - WAVE[1]).max(), 4)
            (self.ok if accepted else self.cancel)()
            self.assertEqual(self.doc.UndoCount, 2 if accepted else 1)
            if accepted:
                self.doc.undo()
                settle()
            numpy.testing.assert_allclose(self.made_points(obj), WAVE, atol=1e-12)
            self.assertEqual(list(obj.Moves), [])

    def test_escape_takes_a_drag_back(self):
        obj, panel = self.spline()
        length = obj.Shape.Length
        grab(WAVE[3])
        pass_over(WAVE[3], (34, 20, 0))
        key(QtCore.Qt.Key_Escape)
        drop((34, 20, 0))
        self.wait()
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.assertEqual((obj.Shape.Length, list(obj.Moves)), (length, []))
        self.assertFalse(panel.box.undo.isEnabled())
        self.cancel()

    def test_a_tension_is_dragged_for_its_point_alone(self):
        for family, sign in ((None, 1), (BETA, -1)):
            obj, panel = self.spline(**({"family": family} if family else {}))
            start = self.place(panel, TENSION, 1)
            self.assertGreater(start[1], 22)  # outside of the bend
            drag(start, start + [0, 4, 0])
            self.wait()
            tension = list(obj.Tension)
            self.assertEqual([tension[k] for k in (0, 2, 3, 4)], [0] * 4)
            self.assertGreater(sign * tension[1], 0)
            self.assertAlmostEqual(float(panel.table.item(1, 3).text()), tension[1])
            drag(self.place(panel, TENSION, 1), WAVE[1])
            self.wait()
            if sign > 0:
                self.assertEqual(obj.Tension[1], 0)
            self.cancel()

    def test_a_tangent_of_an_end_is_dragged_and_freed(self):
        obj, panel = self.spline()
        free = obj.Shape.Length
        start = self.place(panel, TANGENT, 0)
        drag(start, (8, -4, 0))
        self.wait()
        self.assertLess((obj.StartTangent - App.Vector(8, -4, 0)).Length, 0.1)
        edge = obj.Shape.Edges[0]
        tangent = edge.tangentAt(edge.FirstParameter)
        self.assertLess(tangent.getAngle(obj.StartTangent), 1e-9)
        self.assertEqual(tuple(obj.EndTangent), (0, 0, 0))
        click(panel.box.free, panel.box.free.rect().center())
        self.wait()
        self.assertAlmostEqual(obj.Shape.Length, free, delta=1e-9)
        self.cancel()

    def test_numbers_of_the_table(self):
        obj, panel = self.spline(family=BETA)
        self.assertEqual(panel.table.rowCount(), 5)
        self.assertEqual(panel.table.verticalScrollBar().maximum(), 0)  # all points are seen
        panel.table.item(2, 4).setText("2.5")
        self.wait()
        self.assertEqual(list(obj.Bias), [1, 1, 2.5, 1, 1])
        panel.table.item(2, 3).setText("x")
        self.wait()
        self.assertEqual(panel.table.item(2, 3).text(), "0")
        self.assertIn("is no such number: 0 is kept", QtWidgets.QToolTip.text())
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        self.wait()
        self.assertEqual(list(obj.Bias), [1])
        panel.table.item(2, 4).setText("2.3359371603065335")
        self.wait()
        self.assertEqual(panel.table.item(2, 4).text(), "2.3359")
        whole_window("point-table")
        self.set_field(panel, "family", "Polygon, gamma")
        self.assertTrue(panel.table.isColumnHidden(3) and panel.table.isColumnHidden(4))
        self.cancel()

    def test_coordinates_of_the_table_move_points_of_sources_and_own_ones(self):
        obj, panel = self.spline()
        for text, y in (("27.5", 27.5), ("1 in", 25.4), ("=10 mm + 5 mm", 15.0)):
            panel.table.item(1, 1).setText(text)
            self.wait()
            moved = self.made_points(obj)[1]
            numpy.testing.assert_allclose(moved, (WAVE[1][0], y, 0), atol=1e-12)
        others = [tuple(each) for place, each in enumerate(obj.Moves) if place != 1]
        self.assertEqual(others, [(0, 0, 0)] * 4)
        for text in ("x", "nan", "inf", "2 kg", ""):
            panel.table.item(1, 1).setText(text)
            self.wait()
            self.assertEqual(panel.table.item(1, 1).text(), "15")
            self.assertEqual(self.made_points(obj)[1][1], 15)
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        self.wait()
        self.assertEqual(panel.table.item(1, 1).text(), "25.4")
        panel.options.fields["points_mm"].show_value([tuple(map(float, each)) for each in WAVE])
        panel.changed()
        self.wait()
        panel.table.item(4, 2).setText("3")
        self.wait()
        self.assertEqual(tuple(obj.Points[4]), (*WAVE[4][:2], 3))
        self.cancel()

    def test_a_point_on_another_one_can_be_corrected_in_the_table(self):
        obj, panel = self.spline()
        for axis, text in enumerate(map(str, WAVE[0])):
            panel.table.item(1, axis).setText(text)
        self.wait()
        self.assertEqual(panel.table.rowCount(), 5)
        self.assertTrue(panel.table.isVisible())
        panel.table.item(1, 0).setText("7")
        self.wait()
        self.assertEqual(self.made_points(obj)[1][0], 7)
        self.cancel()

    def test_without_handles_the_points_stay_in_the_table_and_are_picked_on(self):
        obj, panel = self.spline()
        panel.box.handles.setChecked(False)
        self.assertTrue(panel.table.isVisible())
        self.assertEqual(len(panel.editor.drawing.places), 0)
        panel.pick.setChecked(True)
        click_at((20, 2, 0))
        key(QtCore.Qt.Key_Return)
        self.wait()
        self.assertEqual(len(self.made_points(obj)), 6)
        self.cancel()

    def test_a_point_snaps_to_vertices_edges_and_the_grid(self):
        models.add(self.doc, Part.Vertex(20, 30, 7), "Aim")
        self.doc.recompute()
        obj, panel = self.spline()
        drag(WAVE[1], (20.2, 30.2, 0))
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj)[1], (20, 30, 7), atol=1e-9)
        panel.box.snaps.setChecked(True)
        panel.box.grid.setValue(5.0)
        circle = Part.makeCircle(8, App.Vector(40, 30, 3))
        models.add(self.doc, circle, "Circle")
        self.doc.recompute()
        drag(WAVE[3], (32.2, 30.2, 0))
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj)[3], (32, 30, 3), atol=1e-9)
        there = App.Vector(40, 30, 3) + App.Vector(8, 0, 0) * 0.6 + App.Vector(0, -8, 0) * 0.8
        drag((32, 30, 3), tuple(there + App.Vector(0.1, -0.1, 0)))
        self.wait()
        found = App.Vector(*self.made_points(obj)[3])
        self.assertLess(Part.Vertex(found).distToShape(circle)[0], 1e-9)
        self.assertLess(found.distanceToPoint(there), 0.3)
        click(panel.box.back, panel.box.back.rect().center())
        self.wait()
        drag(WAVE[3], (36, 12, 0))
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj)[3], (35, 10, 0), atol=1e-9)
        click(panel.box.back, panel.box.back.rect().center())
        self.wait()
        self.assertEqual(list(obj.Moves), [])
        self.cancel()

    def test_a_bad_text_leaves_table_and_handles(self):
        obj, panel = self.spline()
        for text in ("0; 1; -3", "0; x"):  # of a wrong number, and no numbers
            panel.options.fields["tension"].widget.setText(text)
            self.wait()
            self.assertEqual(len(panel.editor.points), len(WAVE))
        self.assertTrue(panel.table.isVisible())
        drag(WAVE[1], (12, 27, 0))
        self.wait()
        self.assertIn("is not a list of numbers", panel.summary.text())
        self.assertEqual(list(obj.Moves), [])
        self.set_field(panel, "tension", [0.0])
        self.wait()
        numpy.testing.assert_allclose(self.made_points(obj)[1], (12, 27, 0), atol=0.5)
        self.cancel()

    def test_other_sources_replace_own_points(self):
        obj, panel = self.spline()
        click(panel.pick, panel.pick.rect().center())
        click_at((30, 20, 0))
        key(QtCore.Qt.Key_Enter)
        self.wait()
        self.assertEqual(len(obj.Points), 6)
        use = panel.boxes["Sources"].use
        Gui.Selection.clearSelection()
        click(use, use.rect().center())
        self.assertIn("Nothing is selected", messages()[0])
        self.assertEqual(len(obj.Points), 6)
        Gui.Selection.addSelection(self.doc.Name, self.points.Name)
        click(use, use.rect().center())
        self.wait()
        self.assertEqual((len(obj.Points), obj.Sources[0][0]), (0, self.points))
        self.ok()

    def test_handles_can_be_hidden(self):
        obj, panel = self.spline()
        panel.box.handles.setChecked(False)
        drag(WAVE[1], (12, 27, 0))
        self.wait()
        self.assertEqual(list(obj.Moves), [])
        self.cancel()

    def test_30_updates_a_second_of_50_points(self):
        places = [(4 * k, 10 * math.sin(k), 3 * math.cos(2 * k)) for k in range(50)]
        obj = kinds.create("Spline", [], points_mm=places, tension=[0.1] * 50)
        obj.ViewObject.ShowComb = True
        self.fit()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle(0.5)
        editor = obj.ViewObject.Proxy.panel.editor
        values = editor.panel.spline_values()
        times, drawn = [], []
        for k in range(60):
            points = list(values["points_mm"])
            points[20] = (80, 10 + k / 10, 0)
            begun = time.perf_counter()
            self.assertTrue(editor.update({**values, "points_mm": points}))
            times.append(time.perf_counter() - begun)
            view().redraw()
            QtWidgets.QApplication.processEvents()
            drawn.append(time.perf_counter() - begun)
        begun = time.perf_counter()
        view().redraw()
        QtWidgets.QApplication.processEvents()
        alone = time.perf_counter() - begun
        found = numpy.median(times), max(times), numpy.median(drawn)
        print(
            "one update of 50 points: median %.2f ms, largest %.2f ms; with drawing %.2f ms, "
            "drawing alone %.2f ms"
            % tuple(1e3 * each for each in (*found, alone)),
            flush=True,
        )
        # Other programs of a busy machine slow single updates down.
        self.assertLess(numpy.percentile(times, 25), 1 / LEAST_RATE)
        self.cancel()


class Picks(SplineWindow):
    CLICKS = ((0, 0, 0), (10, 20, 0), (30, 20, 0), (40, 0, 0))

    def begin(self):
        """An empty spline whose panel waits for clicks, in a view from above."""
        self.top()
        return self.start_empty()

    def start_empty(self):
        Gui.Selection.clearSelection()
        self.COMMAND = "Seamwright_Spline"
        found = self.run_command()
        settle(0.3)
        return found

    def test_points_are_picked_with_mouse_and_keys(self):
        obj, panel = self.begin()
        self.assertTrue(panel.pick.isChecked())
        self.assertEqual(panel.summary.text(), "")
        panel.box.grid.setValue(1.0)
        for number, point in enumerate(self.CLICKS, 1):
            click_at(point, aside=(1, 1))
            said = panel.box.picked.text()
            self.assertRegex(said, r"^%d points?: \([^)]*\), (on the grid|\S+)\. " % number)
        self.assertNotIn("1 points", said)
        mouse(QtCore.QEvent.MouseMove, (50, 10, 0))
        whole_window("spline-picking")
        self.assertEqual(list(obj.Points), [])
        key(QtCore.Qt.Key_Backspace)
        click_at(WAVE[3], aside=(3, 0))  # a vertex of another object
        key(QtCore.Qt.Key_Return)
        self.wait()
        expected = [*self.CLICKS[:3], WAVE[3]]
        self.assertEqual([tuple(point) for point in obj.Points], [tuple(p) for p in expected])
        self.assertFalse(panel.pick.isChecked())
        self.assertTrue(obj.Shape.isValid())
        whole_window("spline-picked")
        drag(self.CLICKS[1], (10, 25, 0))
        self.wait()
        self.assertEqual(tuple(obj.Points[1]), (10, 25, 0))
        self.ok()
        self.assertEqual(self.doc.UndoCount, 1)

    def test_a_spline_through_picked_vertices_follows_them(self):
        box = self.doc.addObject("Part::Box", "Box")
        box.Placement.Base = App.Vector(0, 40, 0)
        self.doc.recompute()
        self.doc.clearUndos()
        obj, panel = self.begin()
        for point in WAVE[:3]:
            click_at(point, aside=(3, 0))
        key(QtCore.Qt.Key_Return)
        self.wait()
        own = [(self.points, "Vertex%d" % number) for number in (1, 2, 3)]
        self.assertEqual((links_of(obj), list(obj.Points)), (own, []))
        click(panel.pick, panel.pick.rect().center())
        click_at((0, 40, 10), aside=(3, 0))
        key(QtCore.Qt.Key_Return)
        self.wait()
        whole_window("spline-vertices")
        self.assertEqual(list(obj.Points), [])
        self.assertEqual([source for source, _ in links_of(obj)], [self.points] * 3 + [box])
        numpy.testing.assert_allclose(self.made_points(obj), [*WAVE[:3], (0, 40, 10)], atol=1e-9)
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        self.wait()
        self.assertEqual(links_of(obj), own)
        key(QtCore.Qt.Key_Y, QtCore.Qt.ControlModifier)
        self.wait()
        self.ok()
        box.Placement.Base.x = 7
        self.doc.recompute()
        numpy.testing.assert_allclose(self.made_points(obj)[3], (7, 40, 10), atol=1e-9)
        self.assertEqual(self.doc.UndoCount, 1)

    def test_a_vertex_of_what_is_made_from_the_spline_is_copied(self):
        obj = kinds.create("Spline", [(self.points, "Vertex%d" % number) for number in (1, 2)])
        made = self.doc.addObject("Part::Extrusion", "Made")
        made.Base, made.Dir, made.LengthFwd = obj, App.Vector(0, 0, 1), 30
        made.DirMode = "Custom"
        self.doc.recompute()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        panel = obj.ViewObject.Proxy.panel
        view().viewIsometric()
        view().fitAll()
        settle(0.4)
        click(panel.pick, panel.pick.rect().center())
        click_at((*WAVE[0][:2], 30))
        key(QtCore.Qt.Key_Return)
        self.wait()
        self.assertEqual((len(obj.Points), obj.Sources), (3, []))
        numpy.testing.assert_allclose(tuple(obj.Points[2]), (*WAVE[0][:2], 30), atol=1e-9)
        self.cancel()

    def test_a_click_on_the_first_point_closes(self):
        obj, panel = self.begin()
        for point in (*self.CLICKS, self.CLICKS[0]):
            click_at(point)
        self.wait()
        self.assertTrue(obj.Closed and obj.Shape.isClosed())
        self.assertEqual(len(obj.Points), 4)
        self.assertFalse(panel.pick.isChecked())
        self.cancel()
        self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))

    def test_buttons_work_while_points_are_picked(self):
        _, panel = self.begin()
        click_at(self.CLICKS[0])
        click(panel.comb, QtCore.QPoint(8, panel.comb.height() // 2))
        self.assertTrue(panel.comb.isChecked())
        self.assertEqual(len(panel.editor.picker.points), 1)
        self.press(QtWidgets.QDialogButtonBox.Cancel)
        self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))

    def test_escape_takes_the_points_back_and_the_panel_stays(self):
        obj, panel = self.begin()
        for point in self.CLICKS:
            click_at(point)
        key(QtCore.Qt.Key_Escape)
        self.wait()
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.assertEqual(list(obj.Points), [])
        self.assertIn("There are no points", panel.summary.text())
        self.cancel()
        self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))

    def test_points_are_added_to_those_of_sources_which_become_own(self):
        obj, panel = self.spline(tension=[0, 1, 0, 0, 0])
        click(panel.pick, panel.pick.rect().center())
        click_at((30, 20, 0))
        key(QtCore.Qt.Key_Enter)
        self.wait()
        self.assertEqual((len(obj.Points), obj.Sources), (6, []))
        self.assertEqual(list(obj.Tension), [0, 1, 0, 0, 0, 0])
        numpy.testing.assert_allclose(self.made_points(obj)[:5], WAVE, atol=1e-12)
        key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        self.wait()
        self.assertEqual((len(obj.Points), obj.Sources[0][0]), (0, self.points))
        key(QtCore.Qt.Key_Y, QtCore.Qt.ControlModifier)
        self.wait()
        self.assertEqual((len(obj.Points), obj.Sources), (6, []))
        self.cancel()


class ClosedElsewhere(CurveWindow):
    def test_a_panel_that_another_program_closes_gives_the_keys_back(self):
        for chosen in ([], [self.points]):
            obj, panel = self.start("Spline", *chosen)
            if not chosen:
                self.assertIsNotNone(panel.editor.picker)
                key(QtCore.Qt.Key_Escape)
                self.assertIsNone(panel.editor.picker)
            Gui.Control.closeDialog()
            settle(0.4)
            self.assertIsNone(Gui.ActiveDocument.getInEdit())
            self.assertEqual(bool(chosen), bool(self.made()))
            self.assertTrue(panel.ended)
            undo = QtGui.QKeyEvent(
                QtCore.QEvent.ShortcutOverride, QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier
            )
            undo.ignore()
            QtWidgets.QApplication.sendEvent(Gui.getMainWindow().windowHandle(), undo)
            self.assertFalse(undo.isAccepted())
