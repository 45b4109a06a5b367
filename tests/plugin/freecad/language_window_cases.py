# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests of the workbench in other languages."""

import contextlib
import math

import FreeCADGui as Gui
import models
import numpy
from window import WindowCase, settle, whole_window

from freecad.seamwright.gui.scene import legend
from freecad.seamwright.plain import curvature, maps, ramps
from freecad.seamwright.plain.language import description, tr
from freecad.seamwright.plain.summary import counted


@contextlib.contextmanager
def language(wanted):
    """Within it, FreeCAD speaks the language of this code; then it speaks English."""
    Gui.setLocale(next(name for name, code in Gui.supportedLocales().items() if code == wanted))
    settle()
    try:
        yield
    finally:
        Gui.setLocale("English")
        settle()


class Languages(WindowCase):
    def test_menu_texts_and_tool_tips_follow_the_language_of_freecad(self):
        (one,) = Gui.Command.get("Seamwright_AnalyzeSeams").getAction()
        self.assertEqual(one.text().replace("&", ""), "Analyze Seams")
        with language("de"):
            self.assertEqual(one.text().replace("&", ""), "Nähte analysieren")
            self.assertIn("Misst Spalt, Winkel und Krümmung", one.toolTip())
        self.assertEqual(one.text().replace("&", ""), "Analyze Seams")

    def test_counts_have_singular_and_plural(self):
        with language("de"):
            found = [counted(number, "face") for number in (0, 1, 2)]
            self.assertEqual(found, ["keine Flächen", "1 Fläche", "2 Flächen"])
        self.assertEqual(counted(2, "face"), "2 faces")

    def test_descriptions_of_properties_are_stored_in_english(self):
        models.add(self.doc, models.three_classes(), "Prism")
        with language("de"):
            obj, panel = self.analyse()
            text = obj.getDocumentationOfProperty("Passed")
            self.assertEqual(text, "Whether no seam is a defect")
            self.assertEqual(description(text), "Ob keine Naht ein Fehler ist")
            panel.reject()
            settle()

    def test_choices_are_shown_translated_and_stored_in_english(self):
        models.add(self.doc, models.three_classes(), "Prism")
        with language("de"):
            obj, panel = self.analyse()
            colours = panel.look.colours
            self.assertEqual([colours.itemText(k) for k in (0, 1)], ["Klasse", "Stufe"])
            colours.setCurrentIndex(1)
            colours.activated.emit(1)
            panel.seam_table.filter.setCurrentIndex(1)
            settle()
            self.assertEqual(obj.ViewObject.ColourBy, "Level")
            self.assertEqual(obj.ViewObject.Show, "Not smooth")
            self.assertIn("Nicht glatt", panel.seam_table.filter.currentText())
            self.assertIn("ist nicht erreicht", obj.Summary)
            panel.reject()
            settle()

    def test_files_are_there_for_all_languages(self):
        for code, word in (("de", "Naht"), ("zh-CN", "接缝")):
            with self.subTest(code), language(code):
                self.assertEqual(tr("Seam"), word)
        self.assertEqual(tr("Seam"), "Seam")

    def test_legends_fit_a_small_view(self):
        values = numpy.array([-0.0123, 0.0123, math.nan])
        for code in ("en", "de", "zh-CN", "fr", "ja"):
            with self.subTest(code), language(code):
                signed = ramps.signed_look(
                    values, 0.0123, tr("Deviation"), "mm", (tr("outside"), tr("inside")),
                    tr("sampled at the points of the mesh"),
                )  # fmt: skip
                left_out = tr("left out"), tr("beyond the edges of the other shape")
                looks = [
                    ramps.curvature_look(maps.GAUSSIAN, values[:2], numpy.ones(2), None),
                    ramps.with_undefined(signed, *left_out),
                    ramps.draft_look(values, 3.0, 3.0),
                ]
                for known in (*(look.legend for look in looks), curvature.legend(0.0123)):
                    drawn = legend.draw(*known, 13)
                    self.assertLess(drawn.width(), 640 - 150, "beside the cube of the view")
                    self.assertLess(drawn.height(), 420)

    def test_the_panel_of_an_analysis_opens_in_each_language(self):
        models.add(self.doc, models.three_classes(), "Prism")
        for code in ("de", "zh-CN", "fr", "ja"):
            with self.subTest(code), language(code):
                obj, panel = self.analyse()
                whole_window("language-" + code)
                panel.reject()
                settle()
                self.doc.removeObject(obj.Name)
