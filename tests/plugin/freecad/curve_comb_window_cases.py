# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selecting for curves, combs and handles in FreeCAD's window; run by run_freecad.py --window."""

import math
import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
import models
import Part
from curve_cases import wavy
from curve_window_cases import CurveWindow
from PySide import QtCore, QtGui
from window import count, messages, mouse_event, pause, picture, press_key, settle, whole_window

from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.gui.curves.view import COLOUR
from freecad.seamwright.gui.scene.comb import (
    COLOURS,
    EVERY,
    INPUT_COLOURS,
    LONGEST,
    MOST,
    SEEN,
    quills,
)
from freecad.seamwright.gui.scene.handle import COLOUR as HANDLE
from freecad.seamwright.gui.scene.live_curve import STALK_COLOUR
from freecad.seamwright.gui.scene.marker import INK
from freecad.seamwright.gui.widgets.qt import QtWidgets

FEW, MANY = 20, 300


def lit():
    """The name of the object that lights up under the mouse, or ""."""
    found = Gui.Selection.getPreselection()
    return found.ObjectName if found is not None else ""


def drag(start, end, steps=8, held=True, each=lambda: None):
    """Drag with the left button between points of the plane z = 0, in a view from above.

    ``held``: whether the button is pressed. ``each`` is called after each event.
    """
    view = Gui.activeDocument().activeView()
    camera = view.getCameraNode()
    (place,) = [
        each.viewport()
        for each in Gui.getMainWindow().findChildren(QtWidgets.QGraphicsView)
        if each.isVisible() and each.viewport().width() > 400
    ]
    scale = place.height() / camera.height.getValue()
    centre = camera.position.getValue().getValue()

    def at(share):
        x, y = (a + share * (b - a) for a, b in zip(start, end))
        across = place.width() / 2 + (x - centre[0]) * scale
        return QtCore.QPointF(across, place.height() / 2 - (y - centre[1]) * scale)

    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    down = left if held else none
    events = [
        (QtCore.QEvent.MouseMove, 0, none, none),
        (QtCore.QEvent.MouseButtonPress, 0, left, left),
        *((QtCore.QEvent.MouseMove, k / steps, none, down) for k in range(1, steps + 1)),
        (QtCore.QEvent.MouseButtonRelease, 1, left, none),
    ]
    for kind, share, button, buttons in events:
        if held or kind == QtCore.QEvent.MouseMove:
            mouse_event(place, at(share), kind, button, buttons)
            pause(0.03)
            each()


def pixels(colours):
    """The colour of the lines of a comb, 0..255."""
    return [round(255 * each) for each in colours[0]]


class Selecting(CurveWindow):
    def test_points_are_taken_in_the_order_of_picking(self):
        other = models.add(self.doc, Part.Vertex(-9, 0, 0), "Other")
        self.doc.recompute()
        obj, _ = self.start(
            "Spline", (self.points, "Vertex3"), (other, "Vertex1"), (self.points, "Vertex1")
        )
        self.assertEqual(
            curve.links_of(obj),
            [(self.points, "Vertex3"), (other, "Vertex1"), (self.points, "Vertex1")],
        )
        self.cancel()

    def test_a_bad_selection_is_one_sentence_and_changes_nothing(self):
        mesh = self.doc.addObject("Mesh::Feature", "Scan")
        mesh.Mesh = Mesh.createBox(1, 1, 1)
        self.doc.recompute()
        self.doc.clearUndos()
        for kind, chosen, text in (
            ("JoinCurves", [], "Nothing is selected: select two edges."),
            ("Arcs", [mesh], "Scan is a mesh: make a shape of it first, "
             "with Create shape from mesh of the workbench Part."),
            ("Spline", [(self.points, "Vertex1")], "There is only one point: choose two or more."),
            ("BridgeCurve", [self.points], "No edges chosen: choose two."),
        ):
            with self.subTest(text):
                self.start(kind, *chosen)
                self.assertEqual(messages(), [text])
                self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))
                self.assertFalse(self.doc.HasPendingTransaction)
        with mock.patch.dict(sys.modules, seamwright=None):
            self.start("Spline", self.points)
        (text,) = messages()
        self.assertIn("It was built for Python", text)

    def test_more_points_than_three_are_a_spline_of_conics(self):
        obj, _ = self.start("Conic", self.points)
        self.assertEqual(obj.Conics, 8)
        self.cancel()


class Handles(CurveWindow):
    def test_each_end_of_a_bridge_has_its_continuity(self):
        ends = ((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0))
        lines = [
            models.add(self.doc, Part.makeLine(*(App.Vector(*p) for p in pair)), "Line")
            for pair in ends
        ]
        self.doc.recompute()
        obj, panel = self.start("BridgeCurve", *lines)
        first, second = (panel.options.fields[name] for name in ("first_order", "second_order"))
        for field, key, times in ((first, QtCore.Qt.Key_Up, 2), (second, QtCore.Qt.Key_Down, 1)):
            field.widget.setFocus()
            for _ in range(times):
                press_key(key)
                settle()
            self.wait()
        self.fit()
        whole_window("bridge-orders")
        self.assertEqual((obj.FirstOrder, obj.SecondOrder), ("G0", "G3"))
        self.assertEqual(obj.Shape.Edges[0].Curve.Degree, 4)
        self.assertEqual(list(panel._handles), ["second_tension"])
        self.assertFalse(panel.options.fields["first_tension"].widget.isVisible())
        self.press_undo()
        self.wait()
        self.assertEqual((obj.FirstOrder, obj.SecondOrder), ("G0", "G2"))
        self.ok()
        self.assertEqual(obj.Shape.Edges[0].Curve.Degree, 3)

    def test_a_tension_is_dragged_with_the_mouse(self):
        ends = ((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0))
        lines = [
            models.add(self.doc, Part.makeLine(*(App.Vector(*p) for p in pair)), "Line")
            for pair in ends
        ]
        self.doc.recompute()
        obj, panel = self.start("BridgeCurve", *lines)
        view = Gui.activeDocument().activeView()
        view.viewTop()
        view.fitAll()
        settle(0.5)
        whole_window("handles")
        self.assertEqual(sorted(panel._handles), ["first_tension", "second_tension"])
        reach = math.hypot(30, 20) / 3
        drag((10 + reach, 0), (10 + 2 * reach, 0))
        self.wait()
        whole_window("handles-dragged")
        self.assertAlmostEqual(obj.FirstTension, 2, delta=0.1)
        self.assertEqual(obj.SecondTension, 1)
        texts = set()
        panel.summary.setText = lambda text, put=panel.summary.setText: (texts.add(text), put(text))
        drag((10 + 2 * reach, 0), (10 + 1.5 * reach, 0), steps=30)
        self.assertGreater(len(texts), 3, "the text follows the drag")
        self.wait()
        drag((10 + 1.5 * reach, 0), (-5, 0))
        self.wait()
        self.assertAlmostEqual(obj.FirstTension, 1e-3, delta=1e-9)
        self.assertEqual(len(obj.Shape.Edges), 1)
        self.cancel()
        self.assertEqual(self.made(), [])


    def test_a_handle_has_a_line_and_is_seen_and_held_in_a_small_picture(self):
        ends = ((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0))
        lines = [
            models.add(self.doc, Part.makeLine(*(App.Vector(*p) for p in pair)), "Line")
            for pair in ends
        ]
        self.doc.recompute()
        obj, _ = self.start("BridgeCurve", *lines)
        view = Gui.activeDocument().activeView()
        view.viewTop()
        view.fitAll()
        stalk, ball = ([round(255 * each) for each in rgb] for rgb in (STALK_COLOUR, HANDLE))
        self.assertGreater(count(picture("handle-lines"), stalk, reach=40), MANY / 2)
        node = view.getCameraNode()
        node.height.setValue(8 * node.height.getValue())
        settle()
        self.assertGreater(count(picture("small-handles"), ball), 2 * 40)
        pixel_mm = node.height.getValue() / view.getSize()[1]
        ball_x = 10 + math.hypot(30, 20) / 3 + 3 * pixel_mm
        drag((ball_x, 0), (ball_x + 9, 0))
        self.wait()
        self.assertGreater(obj.FirstTension, 1.4)
        self.cancel()

    def test_nothing_lights_up_while_a_handle_is_dragged(self):
        ends = ((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0))
        lines = [
            models.add(self.doc, Part.makeLine(*(App.Vector(*p) for p in pair)), "Line")
            for pair in ends
        ]
        plate = models.add(self.doc, Part.makePlane(100, 100, App.Vector(-20, -50, -1)), "Plate")
        self.doc.recompute()
        _, panel = self.start("BridgeCurve", *lines)
        view = Gui.activeDocument().activeView()
        view.viewTop()
        view.fitAll()
        settle(0.5)
        reach = math.hypot(30, 20) / 3
        hovered = []
        drag((10 + reach, 0), (10 + 2 * reach, 0), steps=20, each=lambda: hovered.append(lit()))
        self.assertNotEqual(hovered[0], "", "before the drag")
        self.assertIn("", hovered)
        self.assertEqual(set(hovered[hovered.index("") : -1]), {""})
        self.wait()
        drag((60, -20), (70, -30), held=False, each=lambda: hovered.append(lit()))
        self.assertEqual(hovered[-1], plate.Name, "after the drag")
        self.cancel()
        drag((60, -20), (70, -30), held=False, each=lambda: hovered.append(lit()))
        self.assertEqual(hovered[-1], plate.Name)


class Combs(CurveWindow):
    def test_the_comb_is_drawn_saved_and_removed(self):
        _, panel = self.start("Spline", self.points)
        rgb = pixels(COLOURS)
        self.assertLess(count(picture("comb-off"), rgb), FEW)
        panel.comb.setChecked(True)
        self.assertGreater(count(picture("comb-on"), rgb), MANY)
        self.ok()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            settle()
            self.fit()
            again = self.made()[0]
            self.assertGreater(count(picture("comb-again"), rgb), MANY)
            again.ViewObject.Visibility = False
            settle()
            self.assertLess(count(picture("comb-hidden"), rgb), FEW)
            again.ViewObject.Proxy.doubleClicked(again.ViewObject)
            settle()
            self.assertTrue(again.ViewObject.Proxy.panel.comb.isChecked())
            self.cancel()

    def test_the_outline_of_the_comb_does_not_cover_the_curve(self):
        lines = [
            models.add(self.doc, Part.makeLine(*(App.Vector(*p) for p in pair)), "Line")
            for pair in (((0, 0, 0), (10, 0, 0)), ((40, 0.5, 9), (50, 0.5, 9)))
        ]
        self.doc.recompute()
        _, panel = self.start("BridgeCurve", *lines)
        rgb = [round(255 * each) for each in COLOUR]
        without = count(picture("comb-without"), rgb)
        panel.comb.setChecked(True)
        panel.comb_scale.show_number(0.01)
        panel.comb_scale.valueChanged.emit(0.01)
        settle()
        self.assertGreater(count(picture("comb-on-curve"), rgb), 0.9 * without)
        self.ok()

    def test_points_are_numbered_while_the_panel_is_open(self):
        obj, panel = self.start("Spline", self.points)
        before = count(picture("numbers-off"), INK)
        self.assertTrue(panel.numbers.isVisible())
        panel.numbers.setChecked(True)
        self.assertGreater(count(picture("numbers-on"), INK), before + MANY)
        settle()
        whole_window("numbers-on")
        self.ok()
        self.assertEqual(len(obj.Proxy.points(report_of(obj))), 5)
        self.assertLess(count(picture("numbers-after"), INK), before + FEW)

    def test_the_comb_of_the_input_is_drawn_while_the_panel_is_open(self):
        edge = models.add(self.doc, wavy(), "Wavy")
        self.doc.recompute()
        obj, panel = self.start("FairCurve", edge)
        panel.compare.setChecked(True)
        panel.comb.setChecked(True)
        Gui.activeDocument().activeView().viewTop()
        settle()
        self.assertGreater(count(picture("comb-compare"), pixels(INPUT_COLOURS)), MANY)
        whole_window("comb-compare")
        self.ok()
        self.assertTrue(obj.ViewObject.ShowComb)
        after = picture("comb-compared")
        self.assertLess(count(after, pixels(INPUT_COLOURS)), FEW)
        self.assertGreater(count(after, pixels(COLOURS)), MANY)

    def test_the_lines_point_outwards_and_grow_with_the_curvature(self):
        for comb in quills(Part.makeCircle(10).Edges):
            for foot, tip in comb:
                self.assertAlmostEqual(App.Vector(*foot).Length, 10, delta=1e-9)
                longest = 10 + LONGEST * Part.makeCircle(10).BoundBox.DiagonalLength
                self.assertAlmostEqual(App.Vector(*tip).Length, longest, delta=1e-6)
        (measured,) = quills(Part.makeCircle(5).Edges, measure=Part.makeCircle(10).Edges)
        foot, tip = measured[0]
        self.assertAlmostEqual((App.Vector(*tip) - App.Vector(*foot)).Length, 2 * (longest - 10))
        self.assertEqual(quills(Part.makeLine(App.Vector(), App.Vector(9, 1, 0)).Edges), [])

    def test_so_many_lines_lie_along_the_curve_and_in_its_bends(self):
        curve = Part.BezierCurve()
        curve.setPoles([App.Vector(*pole) for pole in ((0, 0), (40, 0), (41, 0), (40, 1), (0, 9))])
        edge = curve.toShape()
        (comb,) = quills([edge], 30)
        feet = [App.Vector(*foot) for foot, _ in comb[::EVERY]]
        self.assertEqual(len(feet), 31)
        steps = [one.distanceToPoint(other) for one, other in zip(feet, feet[1:])]
        self.assertLess(max(steps), 1.55 * edge.Length / 30)
        ways = [edge.tangentAt(edge.Curve.parameter(foot)) for foot in feet]
        turns = [one.getAngle(other) for one, other in zip(ways, ways[1:])]
        self.assertLess(max(turns), 1.2 * sum(turns) / 10)

    def test_the_comb_of_edges_beside_a_sharp_bend_is_seen_on_the_same_scale(self):
        bend, other = (Part.makeCircle(radius).Edges for radius in (0.5, 10))
        (sharp,), (flat,) = (quills(each, 40, 1.0, bend, other) for each in (bend, other))
        lengths = [App.Vector(*tip).distanceToPoint(App.Vector(*foot))
                   for foot, tip in (sharp[0], flat[0])]  # fmt: skip
        size = other[0].BoundBox.DiagonalLength
        self.assertAlmostEqual(lengths[0], 20 * lengths[1])
        self.assertAlmostEqual(lengths[0], MOST * size, delta=1e-3 * size)
        (gentle,) = quills(other, 40, 1.0, Part.makeCircle(5).Edges, other)
        length = App.Vector(*gentle[0][1]).distanceToPoint(App.Vector(*gentle[0][0]))
        self.assertGreater(length, SEEN * size)
