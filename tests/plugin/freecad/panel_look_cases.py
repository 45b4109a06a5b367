# SPDX-License-Identifier: LGPL-2.1-or-later
"""All panels in the window that run_freecad.py sets up: its style sheet, its screen, its scale.

A panel is no wider than its dock, no text is cut off, and every text has a colour that can be read.
"""

import os
import pathlib
import shutil
import unittest

import FreeCAD as App
import FreeCADGui as Gui
import models
from make_workbench_0_1_0 import NAME as SAVED
from PySide import QtCore, QtGui
from window import OUT, WindowCase, settle, whole_window

from freecad.seamwright.document.maps import kinds as maps
from freecad.seamwright.gui import ICONS
from freecad.seamwright.gui.preferences_page import PreferencesPage
from freecad.seamwright.gui.widgets.dock import dock_of
from freecad.seamwright.gui.widgets.qt import QtWidgets

HERE = pathlib.Path(__file__).resolve()
SAMPLES = HERE.parents[3] / "samples"

#: The least contrast of a text, as the Web Content Accessibility Guidelines define it for large
#: texts and parts of a window.
CONTRAST = 3.0

#: The width of FreeCAD's dock of tasks, in pixels.
NARROW = 300


def luminance(colour):
    """The relative luminance of a QColor, 0 to 1."""
    parts = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4
        for part in (colour.redF(), colour.greenF(), colour.blueF())
    ]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


def contrast(one, other):
    """The contrast of two QColors, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def seen_contrast(screen, widget):
    """The contrast of what the screen shows within a widget with its background."""
    area = QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())
    scale = screen.devicePixelRatio()
    image = screen.copy(*(round(scale * part) for part in area.getRect())).toImage()
    counts = {}
    for x in range(0, image.width()):
        for y in range(0, image.height()):
            pixel = image.pixel(x, y)
            counts[pixel] = counts.get(pixel, 0) + 1
    background = QtGui.QColor(max(counts, key=counts.get))
    return max(contrast(QtGui.QColor(pixel), background) for pixel in counts)


class Panels(WindowCase):
    def setUp(self):
        super().setUp()
        if os.environ["SEAMWRIGHT_TEST_STYLE"]:
            self.assertTrue(QtWidgets.QApplication.instance().styleSheet())

    def check(self, form, name):
        """Look at a panel that is open, and at the panel in a dock as FreeCAD makes it."""
        self.check_as_it_is(form, name)
        Gui.getMainWindow().resizeDocks([dock_of(form)], [NARROW], QtCore.Qt.Horizontal)
        self.check_as_it_is(form, name + "_narrow")

    def check_as_it_is(self, form, name):
        settle(0.5)
        whole_window("look_%s" % name)
        screen = QtWidgets.QApplication.primaryScreen().grabWindow(0)
        area = form.parentWidget()
        while not isinstance(area, QtWidgets.QScrollArea):
            area = area.parentWidget()
        self.assertLessEqual(form.minimumSizeHint().width(), area.viewport().width(), name)
        self.assertEqual(area.horizontalScrollBar().maximum(), 0, name)
        for each in form.findChildren(QtWidgets.QWidget):
            if each.isVisible() and isinstance(each, (QtWidgets.QLabel, QtWidgets.QAbstractButton)):
                self.check_text(screen, each, name)
        for table in form.findChildren(QtWidgets.QTableWidget):
            self.check_cells(table, name)

    def check_cells(self, table, name):
        """The texts of cells with a colour of their own stand out from the ground of the table."""
        ground = table.viewport().grab().toImage().pixelColor(2, table.viewport().height() - 3)
        for line in range(table.rowCount()):
            item = table.item(line, table.columnCount() - 1)
            if item is not None and item.foreground().style() != QtCore.Qt.NoBrush:
                seen = contrast(item.foreground().color(), ground)
                self.assertGreaterEqual(seen, CONTRAST, "%s: %s" % (name, item.text()))

    def check_text(self, screen, widget, name):
        text = widget.text()
        if not text:
            return
        if not getattr(widget, "wordWrap", lambda: False)():
            self.assertGreaterEqual(
                widget.width(), widget.minimumSizeHint().width(), "%s: %s" % (name, text)
            )
        if widget.isEnabled() and widget.visibleRegion().boundingRect() == widget.rect():
            seen = seen_contrast(screen, widget)
            self.assertGreaterEqual(seen, CONTRAST, "%s: %s" % (name, text))

    def look_at(self, names):
        for name in names:
            obj = self.doc.getObject(name)
            with self.subTest(obj.Proxy.Type):
                Gui.Selection.clearSelection()
                obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
                panel = obj.ViewObject.Proxy.panel
                settle(0.5)
                self.assertIsNotNone(dock_of(panel.form))
                self.check(panel.form, obj.Proxy.Type)
                panel.reject()
                Gui.getDocument(self.doc.Name).resetEdit()
                settle()

    def ours(self):
        found = {}
        for obj in self.doc.Objects:
            if hasattr(getattr(obj, "Proxy", None), "Type"):
                found.setdefault(obj.Proxy.Type, obj.Name)
        return list(found.values())

    def test_seams(self):
        App.closeDocument(self.doc.Name)
        path = str(shutil.copy(HERE.parents[2] / "data" / SAVED, OUT))
        self.doc = App.openDocument(path)
        settle()
        self.look_at(self.ours())

    def run_sample(self, sample):
        App.closeDocument(self.doc.Name)
        exec((SAMPLES / (sample + ".FCMacro")).read_text(), {"__name__": "__main__"})
        self.doc = App.ActiveDocument
        settle()

    def test_curves(self):
        self.run_sample("33_curves")
        self.look_at(self.ours())

    def test_surfaces(self):
        self.run_sample("34_surfaces")
        self.look_at(self.ours())

    def test_maps(self):
        left, right = (
            models.add(self.doc, shape, name)
            for shape, name in zip(models.two_sheets(), ("Left", "Right"))
        )
        block = models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        chosen = {"SeamPlot": [(block, "Edge3")], "Deviation": [(left, ""), (right, "")]}
        for kind in maps.KINDS:
            maps.create(kind, chosen.get(kind, [(block, "")]))
        self.look_at(self.ours())

    def test_preferences(self):
        page = PreferencesPage()
        page.loadSettings()
        dialog = QtWidgets.QDialog(Gui.getMainWindow())
        self.addCleanup(dialog.close)
        QtWidgets.QVBoxLayout(dialog).addWidget(page.form)
        dialog.show()
        settle()
        screen = QtWidgets.QApplication.primaryScreen().grabWindow(0)
        self.assertLessEqual(page.form.minimumSizeHint().width(), 640)
        for each in page.form.findChildren(QtWidgets.QLabel):
            self.check_text(screen, each, "preferences")
        page.form.grab().save(os.path.join(OUT, "look_preferences.png"))


class Icons(unittest.TestCase):
    """At 16 pixels, each icon has about as much to see on dark ground as on light ground."""

    SIZE, SEEN, LEAST = 16, 1.8, 20

    def pixels(self, path, ground):
        """The number of pixels that stand out from the ground."""
        image = QtGui.QImage(self.SIZE, self.SIZE, QtGui.QImage.Format_ARGB32)
        image.fill(ground)
        painter = QtGui.QPainter(image)
        Gui.getIcon(path).paint(painter, image.rect())
        painter.end()
        places = [(x, y) for x in range(self.SIZE) for y in range(self.SIZE)]
        return sum(contrast(image.pixelColor(*place), ground) >= self.SEEN for place in places)

    def test_each_icon_is_seen_on_light_and_dark_ground(self):
        paths = sorted(pathlib.Path(ICONS).glob("*.svg"))
        self.assertGreater(len(paths), 20)
        for path in paths:
            light, dark = (
                self.pixels(str(path), QtGui.QColor(name)) for name in ("#f0f0f0", "#2a2e32")
            )
            with self.subTest(path.name, light=light, dark=dark):
                self.assertGreaterEqual(min(light, dark), self.LEAST)
                self.assertGreaterEqual(dark, 0.7 * light)
