# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first panel of a session, as users get it; run by run_freecad.py --window.

The other window tests import the addon's widgets before the first command does. PySide then treats
the items of layouts otherwise, so this module imports nothing of the addon and has its own run.
"""

import time
import unittest

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui


class FirstPanel(unittest.TestCase):
    def test_every_widget_of_the_first_panel_has_its_place(self):
        App.newDocument("First")
        Gui.activateWorkbench("SeamwrightWorkbench")
        Gui.runCommand("Seamwright_Spline", 0)
        end = time.time() + 1.5
        while time.time() < end:
            QtGui.QApplication.processEvents()
        boxes = Gui.getMainWindow().findChildren(QtGui.QGroupBox)
        titles = {box.title(): box for box in boxes if box.isVisible()}
        self.assertTrue({"Points", "Options", "Result"} <= set(titles), titles)
        for title, texts in (("Points", {"Pick points", "Undo"}), ("Result", {"To Sketch"})):
            box = titles[title]
            buttons = [each for each in box.findChildren(QtGui.QPushButton) if each.isVisible()]
            self.assertTrue(texts <= {each.text() for each in buttons}, title)
            for button in buttons:
                with self.subTest(button.text()):
                    self.assertTrue(box.rect().contains(button.geometry()), button.geometry())
