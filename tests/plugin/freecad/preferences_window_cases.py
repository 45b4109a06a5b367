# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the preferences, and what it changes in the window; run by run_freecad.py."""

from unittest import mock

import FreeCADGui as Gui
import models
import Part
import window
from PySide import QtCore
from surface_cases import at_x, sheet
from window import PanelWindow, click, count, picture, settle, whole_window

from freecad.seamwright.document import preferences
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.gui.preferences_page import PreferencesPage
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import palette
from freecad.seamwright.plain import preferences as table


class PageCase(PanelWindow):
    COMMAND = "Seamwright_BlendSurface"
    is_made = staticmethod(surface.is_surface)

    def setUp(self):
        super().setUp()
        preferences.reset()
        self.addCleanup(palette.use, {})
        self.addCleanup(preferences.reset)

    def in_dialog(self, act):
        """Open FreeCAD's preferences at the page, and call act(form, dialog) in it."""
        failed = self.look_later(act)
        Gui.showPreferences("Seamwright", 0)
        settle()
        if failed:
            raise failed[0]

    def look_later(self, act):
        """Call act(form, dialog) soon, in the dialog that is open then; a list for its errors."""
        failed = []

        def now():
            dialog = QtWidgets.QApplication.activeModalWidget()
            try:
                forms = [
                    each
                    for each in dialog.findChildren(QtWidgets.QPushButton)
                    if each.text() == "Defaults of this page" and "at first" in each.toolTip()
                ]
                act(dialog, forms)
            except Exception as error:
                failed.append(error)
            finally:
                dialog.close()

        QtCore.QTimer.singleShot(1500, now)
        return failed

    def test_freecad_shows_the_page_and_stores_it(self):
        def change(dialog, resets):
            whole_window("preferences")
            (box,) = [
                each
                for each in dialog.findChildren(QtWidgets.QSpinBox)
                if each.specialValueText() == "one for each processor"
            ]
            self.assertEqual(len(resets), 1)
            box.setValue(2)
            (buttons,) = dialog.findChildren(QtWidgets.QDialogButtonBox)
            buttons.button(QtWidgets.QDialogButtonBox.Ok).click()

        self.in_dialog(change)
        self.assertEqual(preferences.values(), {**table.defaults(), "Threads": 2})
        self.assertNotIn("preferences-seamwright", window.report_view())

    def test_what_is_refused_is_shown_again(self):
        seen = []

        def press_ok(dialog):
            (buttons,) = dialog.findChildren(QtWidgets.QDialogButtonBox)
            buttons.button(QtWidgets.QDialogButtonBox.Ok).click()

        def fields(resets):
            page = resets[0].parent()
            said = [each.text() for each in page.findChildren(QtWidgets.QLabel) if each.isVisible()]
            said = [text for text in said if "must be larger" in text]
            return page.findChildren(QtWidgets.QDoubleSpinBox), said

        def see_again(dialog, resets):
            numbers, said = fields(resets)
            whole_window("preferences-refused")
            seen.append(([each.value() for each in numbers[:4]], len(said)))
            numbers[3].setValue(7.0)
            seen.append(fields(resets)[1])
            press_ok(dialog)

        def change(dialog, resets):
            numbers, said = fields(resets)
            self.assertEqual((numbers[3].value(), said), (5.0, []))
            numbers[0].setValue(0.03)
            numbers[3].setValue(0.05)
            self.assertEqual(len(fields(resets)[1]), 1)
            self.look_later(see_again)
            press_ok(dialog)

        self.in_dialog(change)
        settle(3.0)
        self.assertEqual(seen, [([0.03, 0.1, 0.02, 0.05], 1), []])
        expected = {**table.defaults(), "GapTolerance": 0.03, "CreaseAngle": 7.0}
        self.assertEqual(preferences.values(), expected)

    def test_reset_and_refusal(self):
        page = PreferencesPage()
        page.loadSettings()
        page.tolerances.fields["GapTolerance"].setValue(0.5)
        page.saveSettings()
        self.assertEqual(preferences.values()["GapTolerance"], 0.5)
        page.tolerances.fields["CreaseAngle"].setValue(0.05)
        self.assertIn("The crease angle, 0.05\u00b0, must be larger", page.problem.text())
        with mock.patch.object(Gui, "showPreferences") as shown:
            page.saveSettings()
            settle()
        shown.assert_called_once_with("Seamwright", 0)
        self.assertEqual(preferences.values()["CreaseAngle"], 5.0)
        page.reset_button.click()
        self.assertEqual(preferences.values()["GapTolerance"], 0.5)  # not before OK
        page.saveSettings()
        self.assertEqual(preferences.values(), table.defaults())

    def test_profiles_fill_in_the_fields(self):
        page = PreferencesPage()
        page.loadSettings()
        combo = page.tolerances.profile
        combo.setCurrentIndex(combo.findData("class-a"))
        combo.activated.emit(combo.currentIndex())
        page.saveSettings()
        self.assertEqual(preferences.values()["GapTolerance"], 0.001)

    def test_seams_are_drawn_in_the_colours(self):
        models.add(self.doc, models.broken_panel(), "Panel")
        self.doc.recompute()
        self.fit()
        _, panel = self.analyse()
        old, new = palette.DEFECT.rgb, (250, 0, 250)
        self.assertGreater(count(picture("colours_before"), old), 200)
        page = PreferencesPage()
        page.loadSettings()
        page.colours["ColourDefect"].show_rgb(new)
        page.saveSettings()
        settle()
        image = picture("colours_after")
        self.assertGreater(count(image, new), 200)
        self.assertLess(count(image, old), 20)
        panel.reject()

    def test_zebra_stripes_follow_the_number(self):
        models.add(self.doc, Part.makeSphere(9), "Ball")
        self.doc.recompute()
        self.fit()
        Gui.runCommand("Seamwright_ZebraStripes")
        settle()
        before = picture("stripes_before")
        page = PreferencesPage()
        page.loadSettings()
        page.stripes.setValue(5)
        page.saveSettings()
        settle()
        self.assertEqual(preferences.zebra_stripes(), 5)
        self.assertNotEqual(picture("stripes_after"), before)
        Gui.runCommand("Seamwright_ZebraStripes")

    def sides(self):
        low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        return [(low, at_x(low, 30)), (high, at_x(high, 60))]

    def test_without_live_preview_only_the_button_computes(self):
        preferences.store({**table.defaults(), "LivePreview": False})
        obj, panel = self.run_selected(self.sides())
        self.assertEqual(obj.Outcome, "")
        button = panel._timer.button
        self.assertTrue(button.isVisible())
        click(button, button.rect().center())
        self.assertEqual(obj.Outcome, "done")
        panel.options.fields["start_tension"].show_value(1.5)
        settle(1.0)
        self.assertEqual(obj.StartTension, 1.0)
        self.ok()  # computes what is due
        self.assertEqual(obj.StartTension, 1.5)

    def test_with_live_preview_there_is_no_button(self):
        obj, panel = self.run_selected(self.sides())
        self.assertFalse(panel._timer.button.isVisible())
        self.assertEqual(obj.Outcome, "done")
        self.cancel()
