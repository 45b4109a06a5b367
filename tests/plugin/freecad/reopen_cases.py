# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents with an analysis, opened again in FreeCAD's window; run by run_freecad.py --window."""

import os
import shutil
import subprocess
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
from window import WindowCase, analyses, count, picture, settle
from window_cases import FEW, LEGEND, MODEL

from freecad.seamwright.document import analysis, repair
from freecad.seamwright.document.maps import kinds as maps
from freecad.seamwright.plain import palette, summary

MAKE = """
import sys
sys.path.insert(0, %r)
import FreeCAD, models
from freecad.seamwright.document import analysis
doc = FreeCAD.newDocument("Made")
analysis.create([models.add(doc, models.three_classes(), "Prism")])
doc.saveAs(%r)
"""


class Reopened(WindowCase):
    def setUp(self):
        super().setUp()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "saved.FCStd")

    def open(self):
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(self.path)
        settle()
        self.fit()
        return analyses(self.doc)[0]

    def assertColoured(self, name):
        view = picture(name)
        for seam_class in palette.CLASSES:
            with self.subTest(seam_class.name):
                self.assertGreater(count(view, seam_class.rgb, LEGEND), FEW)
                self.assertGreater(count(view, seam_class.rgb, MODEL), FEW)

    def test_colours_and_legend_come_back_without_the_compiled_module(self):
        models.add(self.doc, models.three_classes(), "Prism")
        analysis.create()
        self.doc.saveAs(self.path)
        with mock.patch.dict(sys.modules, seamwright=None):
            obj = self.open()
            self.assertNotIn("Touched", obj.State)
            self.assertFalse(Gui.getDocument(self.doc.Name).Modified)
            self.assertColoured("reopened")

    def test_opening_changes_nothing(self):
        block = models.add(self.doc, models.broken_block(), "Block")
        for look in summary.COLOURS:
            analysis.create([block]).ViewObject.ColourBy = look
        maps.create("DraftAngle", repair.create(block))
        settle()
        self.doc.saveAs(self.path)
        self.open()
        settle(0.3)
        self.assertFalse(Gui.getDocument(self.doc.Name).Modified)
        self.doc.recompute()
        self.assertEqual([obj.Name for obj in self.doc.Objects if "Touched" in obj.State], [])
        self.assertFalse(Gui.getDocument(self.doc.Name).Modified)

    def test_what_was_made_without_a_window_gets_its_view(self):
        script = os.path.join(self.folder.name, "make.FCMacro")
        with open(script, "w", encoding="utf-8") as file:
            file.write(MAKE % (os.environ["SEAMWRIGHT_TEST_DIR"], self.path))
        program = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
        addon = os.path.abspath(os.path.join(os.path.dirname(analysis.__file__), *[".."] * 3))
        subprocess.run(
            [program, script, "-M", addon], stdin=subprocess.DEVNULL, timeout=60, check=True
        )
        obj = self.open()
        self.assertTrue(obj.ViewObject.ShowLegend)
        for each in self.doc.Objects:  # FreeCAD opens such a document with everything hidden
            each.ViewObject.Visibility = True
        self.fit()
        self.assertColoured("made-without-window")
