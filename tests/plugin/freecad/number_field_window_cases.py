# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for numbers in FreeCAD's window: units, formulas, digits, expressions."""

import FreeCAD as App
import models
from PySide import QtCore, QtGui
from surface_cases import at_x, sheet
from window import PanelWindow, click, messages, settle, whole_window

from freecad.seamwright.document import analysis, repair
from freecad.seamwright.document.maps import kinds as maps
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.gui.widgets.number_field import (
    ANGLE,
    LENGTH,
    PERCENT,
    PLAIN,
    NumberField,
)
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import rows

INTERNAL, IMPERIAL, INCHES = 0, 2, 3


class Fields(PanelWindow):
    COMMAND = "Seamwright_BlendSurface"
    is_made = staticmethod(surface.is_surface)

    def enter(self, field, text):
        """Type a text and leave the field."""
        field.lineEdit().setText(text)
        field.interpretText()
        return field.value()

    def test_texts_with_units_and_formulas(self):
        field = NumberField(LENGTH, 1e6)
        for text, value in (
            ("0.02 cm", 0.2), ("1 in", 25.4), ("2 * 5 um", 0.01), ("12.5 mm", 12.5)
        ):  # fmt: skip
            self.assertAlmostEqual(self.enter(field, text), value, delta=1e-9, msg=text)
        self.assertEqual(self.enter(field, "3"), 3.0)
        angle = NumberField(ANGLE, 90.0)
        self.assertAlmostEqual(self.enter(angle, "0.1 rad"), 5.729577951, delta=1e-8)
        self.assertEqual(self.enter(angle, "0.00025"), 0.00025)

    def test_ratios_are_in_percent_and_lengths_in_one_unit(self):
        field = NumberField(PERCENT, 1.0)
        field.setValue(0.02)
        self.assertEqual(field.text().replace(" ", ""), "2%")
        for text, value in (("5", 0.05), ("2.5 %", 0.025), ("2 * 3", 0.06), ("10%", 0.1)):
            self.assertAlmostEqual(self.enter(field, text), value, delta=1e-12, msg=text)
        field = NumberField(LENGTH, 1e6)
        for value, text in ((1e-6, "1e-06 mm"), (0.01, "0.01 mm"), (1e5, "100000 mm")):
            field.setValue(value)
            self.assertEqual(field.text(), text)

    def test_what_is_no_such_number_changes_nothing(self):
        for kind in (LENGTH, ANGLE, PLAIN, PERCENT):
            field = NumberField(kind, 100.0 if kind != PERCENT else 8.0)
            field.setValue(7.0)
            for text in ("", "nonsense", "1 kg", "1e9", "-1", "nan", "5 *"):
                state = field.validate(text, 0)[0]
                self.assertEqual(state, QtGui.QValidator.Intermediate, (kind, text))
                self.assertEqual(self.enter(field, text), 7.0, (kind, text))

    def test_a_field_left_with_a_text_that_is_not_allowed_says_so(self):
        _, panel = self.block_analysis()
        field, labels = panel.tolerances.fields["GapTolerance"], panel.look.labels
        for each, texts in ((field, ("abc", "5 kg", "-1")), (labels, ("100000000", "2x"))):
            before = each.value()
            for text in texts:
                panel.form.setFocus()
                each.setFocus()
                each.lineEdit().selectAll()
                for letter in text:
                    self.press_key(each, 0, letter)
                self.assertEqual(each.lineEdit().text(), text)
                self.assertIn("color", each.lineEdit().styleSheet())
                panel.seam_table.setFocus()
                settle()
                self.assertEqual(each.value(), before, text)
                self.assertEqual(each.lineEdit().styleSheet(), "")
                self.assertIn(each.textFromValue(before) + " is kept", QtWidgets.QToolTip.text())
        panel.reject()

    def test_a_number_out_of_range_is_kept_until_it_is_changed(self):
        field = NumberField(PERCENT, 1.0)
        field.show_number(3.0)
        self.assertEqual((field.value(), field.number()), (1.0, 3.0))
        self.assertEqual(self.enter(field, "50 %"), 0.5)
        self.assertEqual(field.number(), 0.5)

    def test_units_follow_freecad(self):
        field = NumberField(LENGTH, 1e6)
        self.addCleanup(App.Units.setSchema, INTERNAL)
        for schema, unit in ((INTERNAL, "mm"), (IMPERIAL, "in|\"")):
            App.Units.setSchema(schema)
            field.setValue(25.4)
            self.assertRegex(field.text(), unit)
            for value in (25.4, 0.0254, 0.001, 1e-6):
                field.setValue(value)
                self.assertEqual(self.enter(field, field.text()), value)

    def test_tables_have_the_unit_of_the_fields(self):
        self.addCleanup(App.Units.setSchema, INTERNAL)
        obj, panel = self.block_analysis()
        panel.reject()
        (place,) = [n for n, each in enumerate(rows.COLUMNS) if each.field == "length_mm"]
        found = {}
        for schema in (INTERNAL, INCHES):
            App.Units.setSchema(schema)
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            whole_window("units-%d" % schema)
            panel = obj.ViewObject.Proxy.panel
            model = panel.seam_table.model
            text = model.data(model.index(0, place))
            found[schema] = model.headerData(place, QtCore.Qt.Horizontal), float(text)
            self.assertIn(panel.tolerances.fields["GapTolerance"].text()[-2:], found[schema][0])
            panel.reject()
            settle()
        (mm, length), (inches, shorter) = found[INTERNAL], found[INCHES]
        self.assertEqual((mm, inches), ("Length mm", "Length in"))
        self.assertAlmostEqual(length / 25.4, shorter, delta=1e-3 * length)
        mended = repair.create(obj.Analysed[0])
        App.Units.setSchema(INCHES)  # FreeCAD 1.1 takes that of the document again
        mended.ViewObject.Proxy.doubleClicked(mended.ViewObject)
        settle()
        heading = mended.ViewObject.Proxy.panel.table.horizontalHeaderItem(3)
        self.assertEqual(heading.text(), "Gap in")
        self.cancel()

    def sheet_with(self, **cells):
        """A spreadsheet with these cells, by their aliases."""
        found = self.doc.addObject("Spreadsheet::Sheet", "Sheet")
        for line, (alias, text) in enumerate(cells.items(), 1):
            found.set("A%d" % line, text)
            found.setAlias("A%d" % line, alias)
        self.doc.recompute()
        return found

    def block_analysis(self):
        source = models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        obj = analysis.create([source], self.doc)
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        return obj, obj.ViewObject.Proxy.panel

    def blend(self):
        low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        return self.run_selected([(low, at_x(low, 30)), (high, at_x(high, 60))])

    def editor(self):
        """FreeCAD's formula editor that is open, and its line."""
        (found,) = (
            each
            for each in QtWidgets.QApplication.topLevelWidgets()
            if each.isVisible() and each.metaObject().className().endswith("DlgExpressionInput")
        )
        return found, found.findChild(QtWidgets.QWidget, "expression")

    def discard(self):
        """Press the button of the open editor that removes the expression."""
        editor, _ = self.editor()
        buttons = QtWidgets.QDialogButtonBox
        box = editor.findChild(buttons)
        if box is None:  # before FreeCAD 1.1
            editor.findChild(QtWidgets.QPushButton, "discardBtn").click()
            return
        removing = (buttons.ResetRole, buttons.DestructiveRole)
        (found,) = (each for each in box.buttons() if box.buttonRole(each) in removing)
        found.click()

    def write(self, text):
        """Write an expression into the open editor, and press its OK."""
        editor, line = self.editor()
        line.setText(text) if hasattr(line, "setText") else line.setPlainText(text)
        settle()
        whole_window("expression-editor")
        self.press_key(line, QtCore.Qt.Key_Return)
        settle(0.8)

    def click_button(self, field):
        """Click the f(x) of a field."""
        (button,) = field.lineEdit().findChildren(QtWidgets.QToolButton)
        click(button, button.rect().center())

    def press_key(self, widget, key, text=""):
        """Press and release a key."""
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, text)
            QtWidgets.QApplication.sendEvent(widget, event)
        settle()

    def type_equals(self, field):
        field.setFocus()
        self.press_key(field, QtCore.Qt.Key_Equal, "=")

    def test_a_text_that_names_a_cell_is_computed_once(self):
        cells = self.sheet_with(tol="0.02 mm", lean="30 deg", plain="4")
        field = NumberField(LENGTH, 1e6, refer_to=cells)
        for text, value in (
            ("Sheet.tol", 0.02), ("=2 * Sheet.tol", 0.04), ("Sheet.plain", 4.0), ("1/16 in", 1.5875)
        ):  # fmt: skip
            self.assertAlmostEqual(self.enter(field, text), value, delta=1e-9, msg=text)
        self.assertEqual(self.enter(field, "Sheet.lean"), field.value())
        for text in ("Sheet.lean", "Sheet.none", "Sheet.Label", "Sheet.tol +", "1 / 0"):
            self.assertEqual(field.validate(text, 0)[0], QtGui.QValidator.Intermediate, text)
        angle = NumberField(ANGLE, 90.0, refer_to=cells)
        self.assertAlmostEqual(self.enter(angle, "Sheet.lean / 2"), 15.0, delta=1e-9)

    def test_an_expression_is_set_shown_undone_and_removed(self):
        cells = self.sheet_with(tol="0.03 mm")
        obj, panel = self.block_analysis()
        field = panel.tolerances.fields["GapTolerance"]
        tip = field.toolTip()
        self.click_button(field)
        self.write("Sheet.tol")
        self.assertEqual(obj.ExpressionEngine, [("GapTolerance", "Sheet.tol")])
        self.assertEqual((field.isReadOnly(), field.number()), (True, 0.03))
        self.assertIn("Sheet.tol", field.toolTip())
        self.assertFalse(panel.tolerances.fields["AngleTolerance"].isReadOnly())
        self.assertIn("changed", panel.recompute_button.text())
        whole_window("expression-bound")
        panel.tolerances.profile.setCurrentIndex(2)
        panel.tolerances.profile.activated.emit(2)  # sets the fields that have no expression
        self.assertEqual(field.number(), 0.03)
        click(panel.recompute_button, panel.recompute_button.rect().center())
        self.assertEqual(obj.GapTolerance.Value, 0.03)
        self.assertNotIn("changed", panel.recompute_button.text())
        cells.set("A1", "0.04 mm")
        self.doc.recompute()
        settle()
        self.assertEqual(field.number(), 0.04)
        self.type_equals(field)
        self.discard()
        settle()
        self.assertEqual((obj.ExpressionEngine, field.isReadOnly()), ([], False))
        self.assertEqual((field.number(), field.toolTip()), (0.04, tip))
        self.doc.undo()
        settle()
        self.assertEqual(obj.ExpressionEngine, [("GapTolerance", "Sheet.tol")])
        self.assertTrue(field.isReadOnly())
        panel.reject()

    def test_live_changes_do_not_overwrite_an_expression(self):
        cells = self.sheet_with(tension="1.2")
        obj, panel = self.blend()
        field = panel.options.fields["start_tension"]
        self.type_equals(field.widget)
        _, line = self.editor()
        self.press_key(line, QtCore.Qt.Key_Escape)
        self.assertEqual((obj.ExpressionEngine, field.value()), ([], 1.0))
        self.assertIs(obj.ViewObject.Proxy.panel, panel)
        self.type_equals(field.widget)
        self.write("Sheet.tension / 1.1")
        self.assertEqual(obj.StartTension, 1.2 / 1.1)
        self.assertTrue(field.widget.isReadOnly())
        self.assertFalse(field.drag(3.0))
        panel.options.fields["end_tension"].show_value(1.5)
        settle(0.8)
        self.assertEqual((obj.StartTension, obj.EndTension), (1.2 / 1.1, 1.5))
        cells.set("A1", "1.3")
        self.doc.recompute()
        settle(0.8)
        self.assertAlmostEqual(field.value(), 1.3 / 1.1, delta=1e-12)
        self.assertNotIn("Touched", obj.State)
        cells.clear("A1")
        self.doc.recompute()
        self.ok()
        (text,) = messages()  # FreeCAD's words about the reference
        self.assertIn("tension", text)
        self.assertIs(obj.ViewObject.Proxy.panel, panel)
        cells.set("A1", "1.3")
        cells.setAlias("A1", "tension")
        self.doc.recompute()
        settle(0.8)
        self.ok()
        self.assertEqual(dict(obj.ExpressionEngine), {"StartTension": "Sheet.tension / 1.1"})

    def test_a_whole_number_follows_an_expression(self):
        cells = self.sheet_with(count="7")
        block = models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        comb = maps.create("CurvatureComb", [(block, "Face1")])
        comb.ViewObject.Proxy.doubleClicked(comb.ViewObject)
        settle()
        box = comb.ViewObject.Proxy.panel.options.fields["count"].widget
        self.click_button(box)
        self.write("Sheet.count + 1")
        self.assertEqual((comb.Count, box.value(), box.isReadOnly()), (8, 8, True))
        cells.set("A1", "4")
        self.doc.recompute()
        settle(0.8)
        self.assertEqual((comb.Count, box.value()), (5, 5))
        self.ok()

    def test_cancel_takes_an_expression_back(self):
        self.sheet_with(tension="1.2")
        obj, _ = self.blend()
        self.ok()
        for undo in (1, 0):
            self.doc.UndoMode = undo
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            field = obj.ViewObject.Proxy.panel.options.fields["start_tension"]
            self.click_button(field.widget)
            self.write("Sheet.tension")
            self.assertEqual((obj.StartTension, field.value()), (1.2, 1.2))
            self.cancel()
            self.assertEqual((obj.StartTension, obj.ExpressionEngine), (1.0, []))

    def test_a_panel_keeps_all_digits_of_what_it_does_not_change(self):
        obj, _ = self.blend()
        self.ok()
        wanted = {"AngleTolerance": 0.00125, "CurvatureTolerance": 0.00375, "StartTension": 1.03125}
        for name, value in wanted.items():
            setattr(obj, name, value)
        self.doc.recompute()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        panel = obj.ViewObject.Proxy.panel
        panel.options.fields["end_tension"].show_value(1.5)
        settle(1.0)
        self.ok()
        for name, value in {**wanted, "EndTension": 1.5}.items():
            self.assertEqual(float(getattr(getattr(obj, name), "Value", getattr(obj, name))), value)
