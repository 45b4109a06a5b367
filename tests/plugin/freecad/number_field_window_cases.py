# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for numbers in FreeCAD's window: units, formulas, digits, expressions."""

import FreeCAD as App
import models
from PySide import QtGui
from surface_cases import at_x, sheet
from window import PanelWindow, settle

from freecad.seamwright.document import analysis
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.gui.widgets.number_field import (
    ANGLE,
    LENGTH,
    PERCENT,
    PLAIN,
    NumberField,
)

INTERNAL, IMPERIAL = 0, 2


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

    def test_a_field_shows_its_expression_and_is_read_only(self):
        source = models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        obj = analysis.create([source], self.doc)
        obj.setExpression("GapTolerance", "4 * 5 um")
        self.doc.recompute()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        panel = obj.ViewObject.Proxy.panel
        field = panel.tolerances.fields["GapTolerance"]
        self.assertTrue(field.isReadOnly())
        self.assertAlmostEqual(field.value(), 0.02, delta=1e-12)
        self.assertIn("5", field.toolTip().rsplit("expression", 1)[1])
        self.assertFalse(panel.tolerances.fields["AngleTolerance"].isReadOnly())
        panel.reject()

    def test_a_panel_keeps_all_digits_of_what_it_does_not_change(self):
        low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        obj, panel = self.run_selected([(low, at_x(low, 30)), (high, at_x(high, 60))])
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
