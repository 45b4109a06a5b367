# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys and the mouse wheel in panels, in FreeCAD's window; run by run_freecad.py --window."""

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from PySide import QtCore, QtGui
from window import PanelWindow, held, pause, press_key, settle

from freecad.seamwright.document import corner
from freecad.seamwright.gui.corner.panel import RADIUS
from freecad.seamwright.gui.widgets import computation
from freecad.seamwright.gui.widgets.qt import QtWidgets

SHOWN_S = 2 * computation.LOCK_AFTER_MS / 1000


def type_text(text):
    """Type into the window, "\\t" is Tab; return the letters that would be shortcuts of FreeCAD."""
    target, lost = Gui.getMainWindow().windowHandle(), ""
    for letter in text:
        key = QtCore.Qt.Key_Tab if letter == "\t" else ord(letter)
        event = QtGui.QKeyEvent(
            QtCore.QEvent.ShortcutOverride, key, QtCore.Qt.NoModifier, letter
        )
        event.ignore()
        QtWidgets.QApplication.sendEvent(target, event)
        if letter != "\t" and not event.isAccepted():
            lost += letter
        else:
            press_key(key, text=letter)
        pause(0.05)
    return lost


def turn_wheel(widget, degrees):
    """Turn the wheel over a widget; return whether it took that, else what is around it gets it."""
    place = QtCore.QPointF(widget.rect().center())
    event = QtGui.QWheelEvent(
        place, QtCore.QPointF(widget.mapToGlobal(place.toPoint())), QtCore.QPoint(),
        QtCore.QPoint(0, 8 * degrees), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
        QtCore.Qt.NoScrollPhase, False
    )  # fmt: skip
    QtWidgets.QApplication.sendEvent(widget, event)
    pause(0.1)
    return event.isAccepted()


class Typing(PanelWindow):
    COMMAND = "Seamwright_CornerFillet"
    is_made = staticmethod(corner.is_corner)

    def setUp(self):
        super().setUp()
        self.source = models.add(self.doc, Part.makeBox(10, 10, 10), "Cube")
        self.doc.recompute()
        self.fit()
        points = [vertex.Point for vertex in self.source.Shape.Vertexes]
        name = "Vertex%d" % (1 + points.index(App.Vector(10, 0, 10)))
        self.obj, self.panel = self.run_selected([(self.source, name)])
        Gui.getMainWindow().activateWindow()

    def focus(self, field):
        field.setFocus()
        field.selectAll()
        pause(0.1)

    def radii(self):
        return [field.value() for field in self.panel.fields[RADIUS]]

    def test_numbers_typed_while_the_panel_computes_reach_their_fields(self):
        with held():
            self.focus(self.panel.fields[RADIUS][0])
            lost = type_text("2\t")
            pause(SHOWN_S)
            self.assertTrue(self.panel.computation.line.isVisible())
            lost += type_text("\t1.5\t")
            pause(SHOWN_S)
            self.assertTrue(self.panel.computation.busy)
        settle(0.8)
        self.assertEqual((self.radii()[:2], lost), ([2.0, 1.5], ""))
        self.assertEqual(self.obj.Radii[:2], [2.0, 1.5])
        self.cancel()

    def test_keys_on_the_stop_button_are_no_shortcuts(self):
        button = next(iter(self.panel.boxes.values())).use
        with held():
            self.panel.fields[RADIUS][0].setValue(2.5)
            button.setFocus()
            pause(3 * SHOWN_S)
            self.assertTrue(self.panel.computation.stop_button.hasFocus())
            self.assertEqual(type_text("5"), "")
            self.panel.fields[RADIUS][1].setFocus()
        settle(0.5)
        self.assertTrue(self.panel.fields[RADIUS][1].hasFocus())
        self.cancel()

    def test_the_wheel_changes_only_a_field_that_has_the_focus(self):
        form = self.panel.tolerances
        field = next(iter(form.fields.values()))
        self.panel.fields[RADIUS][0].setFocus()
        values = form.values()
        for each in (field, form.profile, *self.panel.fields[RADIUS][1:]):
            self.assertFalse(turn_wheel(each, 15))
        self.assertEqual((form.values(), len(set(self.radii()))), (values, 1))
        self.focus(field)
        self.assertTrue(turn_wheel(field, 15))
        self.assertNotEqual(form.values(), values)
        self.cancel()

    def test_enter_keeps_the_panel_while_a_number_is_not_allowed(self):
        field = self.panel.fields[RADIUS][0]
        for text in ("-5", "x", "1 kg"):
            self.focus(field)
            type_text(text)
            press_key(QtCore.Qt.Key_Return)
            pause(0.2)
            least = field.textFromValue(field.minimum())
            self.assertIn("from %s to " % least, QtWidgets.QToolTip.text())
            self.assertIsNotNone(self.obj.ViewObject.Proxy.panel)
            self.assertEqual(field.lineEdit().text(), text)
        self.focus(field)
        type_text("1.5")
        press_key(QtCore.Qt.Key_Return)
        settle(0.8)
        self.assertEqual(self.obj.Radii[0], 1.5)
        if Gui.Control.activeDialog():
            self.cancel()


class Docks(PanelWindow):
    COMMAND = "Seamwright_AnalyzeSeams"

    def widths(self):
        docks = Gui.getMainWindow().findChildren(QtWidgets.QDockWidget)
        return {each.objectName(): each.width() for each in docks if each.isVisible()}

    def test_docks_get_their_width_back(self):
        models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        before = self.widths()
        for command in ("Seamwright_AnalyzeSeams", "Seamwright_DraftAngle"):
            Gui.Selection.addSelection(self.doc.Block)
            Gui.runCommand(command)
            settle(0.5)
            during = self.widths()
            Gui.Control.closeDialog()
            settle(0.5)
            after = self.widths()
            for name in before:
                self.assertAlmostEqual(after[name], before[name], delta=2, msg=name)
            if not before.keys() & {"Tasks"}:
                self.assertGreater(max(during.values()), max(before.values()))
