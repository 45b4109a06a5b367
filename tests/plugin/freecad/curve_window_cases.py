# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves in FreeCAD's window; run by run_freecad.py --window."""

import math

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from curve_cases import RING, WAVE, slot, vertices, wavy
from PySide import QtCore
from window import PanelWindow, click, messages, press_key, settle, whole_window

from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.curves.kinds import KINDS
from freecad.seamwright.document.curves.spline import BETA
from freecad.seamwright.gui.base.option_panel import PREVIEW_AFTER_MS
from freecad.seamwright.gui.widgets.qt import QtWidgets


class CurveWindow(PanelWindow):
    is_made = staticmethod(curve.is_curve)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.points = models.add(self.doc, Part.Compound(vertices(WAVE)), "Points")
        self.doc.recompute()
        self.doc.clearUndos()

    def start(self, kind, *chosen):
        self.COMMAND = "Seamwright_" + kind
        found = self.run_selected(
            [each if isinstance(each, tuple) else (each, "") for each in chosen]
        )
        if found[0] is not None:
            self.fit()
        return found

    def set_field(self, panel, argument, value):
        panel.options.fields[argument].show_value(value)
        self.wait()

    def wait(self):
        settle(0.1 + PREVIEW_AFTER_MS / 1000)
        while any(panel is not None and panel._timer.isActive() for panel in self.panels()):
            settle(0.05)

    def panels(self):
        return [obj.ViewObject.Proxy.panel for obj in self.made()]


class Panel(CurveWindow):
    def test_enter_in_a_field_keeps_the_number_that_was_typed(self):
        lines = [
            models.add(self.doc, Part.makeLine(App.Vector(*one), App.Vector(*other)), "Line")
            for one, other in (((0, 0, 0), (10, 0, 0)), ((40, 20, 0), (50, 20, 0)))
        ]
        self.doc.recompute()
        obj, panel = self.start("BridgeCurve", *lines)
        field = panel.options.fields["first_tension"].widget
        field.setFocus()
        field.selectAll()
        for letter in "2.5":
            press_key(ord(letter), text=letter)
        press_key(QtCore.Qt.Key_Return)
        settle(1.0)
        self.assertIsNone(obj.ViewObject.Proxy.panel, "FreeCAD's Enter is OK")
        self.assertEqual(obj.FirstTension, 2.5)
        self.assertAlmostEqual(
            obj.Shape.Edges[0].Curve.getPole(2).x - 10, 2.5 * math.hypot(30, 20) / 5, delta=1e-6
        )

    def test_each_kind_is_made_accepted_undone_and_done_again(self):
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(10, 0, 0)), "Line")
        other = models.add(
            self.doc, Part.makeLine(App.Vector(20, 5, 0), App.Vector(30, 5, 9)), "Other"
        )
        edge = models.add(self.doc, wavy(), "Wavy")
        self.doc.recompute()
        chosen = dict.fromkeys(("BlendCurves", "BridgeCurve", "JoinCurves"), [line, other])
        chosen["FairCurve"] = [edge]
        chosen["LogSpiral"] = [(self.points, "Vertex%d" % number) for number in (1, 2, 3)]
        for kind in KINDS:
            with self.subTest(kind):
                steps, before = self.doc.UndoCount, self.doc.Objects
                obj, panel = self.start(kind, *chosen.get(kind, [self.points]))
                self.assertEqual(panel.summary.text(), obj.Summary)
                self.assertTrue(obj.Summary and not obj.Shape.isNull())
                if kind == "JoinCurves":
                    self.assertEqual(panel.options.fields["most_mm"].widget.text(), "no limit")
                panel.comb.setChecked(True)
                settle(0.5)
                whole_window("curve-" + kind)
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

    def test_the_document_follows_the_fields(self):
        obj, panel = self.start("Spline", self.points)
        free = obj.Shape.Length
        self.set_field(panel, "tension", [50.0])
        self.assertEqual(list(obj.Tension), [50.0])
        line = panel.options.fields["tension"].widget
        line.setText("2 * 10; 1 / 4 + 0.25; Points.Shape.Length; 0; 0")
        line.editingFinished.emit()
        self.wait()
        self.assertEqual(list(obj.Tension), [20.0, 0.5, 0, 0, 0])
        self.assertEqual(line.text(), "20; 0.5; 0; 0; 0")
        self.set_field(panel, "tension", [50.0])
        self.assertLess(obj.Shape.Length, free)
        self.assertFalse(panel.options.fields["bias"].widget.isVisible())
        self.set_field(panel, "family", BETA)
        self.assertTrue(panel.options.fields["bias"].widget.isVisible())
        self.assertEqual(obj.Family, BETA)
        panel.options.fields["tension"].widget.setText("1; x")
        self.wait()
        self.assertIn("is not a list of numbers", panel.summary.text())
        self.ok()
        (text,) = messages()
        self.assertIn("is not a list of numbers", text)
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        self.set_field(panel, "tension", [1.0, 2.0])
        self.assertIn("Tension has 2 numbers for 5 points", panel.summary.text())
        self.cancel()
        self.assertEqual(self.made(), [])
        self.assertEqual(self.doc.UndoCount, 0)

    def test_cancel_of_a_later_change_restores_the_values(self):
        obj, _ = self.start("Arcs", self.points)
        self.ok()
        before = obj.Arcs
        for undo in (1, 0):
            self.doc.UndoMode = undo
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.set_field(panel, "tolerance_mm", 1.0)
            self.assertLess(obj.Arcs, before)
            self.cancel()
            self.assertEqual((obj.Tolerance.Value, obj.Arcs), (0.01, before))

    def test_units_and_expressions(self):
        obj, panel = self.start("Arcs", self.points)
        field = panel.options.fields["tolerance_mm"]
        self.assertEqual(field.value(), 0.01)
        line = field.widget.findChild(QtWidgets.QLineEdit)
        line.setText("0.02 cm")
        self.wait()
        self.assertAlmostEqual(obj.Tolerance.Value, 0.2, delta=1e-9)
        obj.setExpression("Tolerance", "100 * 5 um")
        self.doc.recompute()
        settle()
        self.assertEqual((obj.Tolerance.Value, field.value()), (0.5, 0.5))
        self.ok()
        ((name, text),) = obj.ExpressionEngine
        self.assertEqual((name, text.replace(" ", "")), ("Tolerance", "100*5um"))
        self.assertEqual(obj.Tolerance.Value, 0.5)

    def test_other_sources_are_used(self):
        ring = models.add(self.doc, Part.Compound(vertices(RING)), "Ring")
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj, panel = self.start("Spline", self.points)
        self.assertEqual(panel.boxes["Sources"].chosen.text(), "Points")
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, ring.Name)
        click(panel.boxes["Sources"].use, panel.boxes["Sources"].use.rect().center())
        self.assertEqual((panel.boxes["Sources"].chosen.text(), obj.Sources[0][0]), ("Ring", ring))
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, box.Name)
        click(panel.boxes["Sources"].use, panel.boxes["Sources"].use.rect().center())
        self.assertIn("Box has 6 faces", messages()[0])
        self.assertEqual(obj.Sources[0][0], ring)
        self.ok()
        self.assertEqual(obj.Sources[0][0], ring)

    def test_a_curve_leaves_a_sketch(self):
        source = models.add(self.doc, slot(), "Slot")
        self.doc.recompute()
        steps = self.doc.UndoCount
        for undo in (1, 0):
            self.doc.UndoMode = undo
            obj, panel = self.start("Spline", self.points)
            click(panel.sketch, panel.sketch.rect().center())
            self.assertIn(obj.Label + " sketch has ", panel.sketch_text.text())
            self.cancel()
            self.assertEqual(self.doc.Objects, [self.points, source])
        self.doc.UndoMode = 1
        self.assertEqual(self.doc.UndoCount, steps)
        _, panel = self.start("Arcs", source)
        click(panel.sketch, panel.sketch.rect().center())
        self.ok()
        (sketch,) = [each for each in self.doc.Objects if each.Name.endswith("Sketch")]
        self.assertEqual(sketch.GeometryCount, 4)
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.doc.undo()
        settle()
        self.assertEqual(self.doc.Objects, [self.points, source])
