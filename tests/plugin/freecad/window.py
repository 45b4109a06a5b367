# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handling FreeCAD's window in tests: waiting, clicking, looking at pictures."""

import contextlib
import os
import shutil
import subprocess
import threading
import time
import unittest
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import numpy
from PySide import QtCore, QtGui

from freecad.seamwright.document import analysis, preferences
from freecad.seamwright.gui.widgets import tasks
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import preferences as table

#: Panels compute as if the kernel said that the user cancelled.
CANCELLED = mock.patch.object(tasks.Task, "_progress", lambda self, fraction: False)

#: The longest that a panel may compute.
COMPUTED_S = 120

OUT = os.environ["SEAMWRIGHT_TEST_OUT"]
PICTURE = (1200, 800)


def pause(seconds=0.2):
    """Let FreeCAD handle what is pending."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        Gui.updateGui()
        time.sleep(0.01)


def settle(seconds=0.2):
    """Let FreeCAD handle what is pending, and panels end what they compute."""
    pause(seconds)
    end = time.monotonic() + COMPUTED_S
    while not tasks.tasks.idle:
        assert time.monotonic() < end, "something is computed for more than %d s" % COMPUTED_S
        pause(0.05)


@contextlib.contextmanager
def held():
    """Within it, what panels compute goes on until it is stopped."""

    def hold(self, fraction):
        self.fraction = fraction
        while self.wanted and not over.is_set():
            time.sleep(0.002)
        return self.wanted

    over = threading.Event()
    with mock.patch.object(tasks.Task, "_progress", hold):
        try:
            yield
        finally:
            over.set()
    settle()


def press_key(key, modifiers=QtCore.Qt.NoModifier, text=""):
    """Press a key: the window gives it to what has the focus."""
    target = Gui.getMainWindow().windowHandle()
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, key, modifiers, text)
        QtWidgets.QApplication.postEvent(target, event)


def press_escape():
    """Press Esc."""
    press_key(QtCore.Qt.Key_Escape)


def report_view():
    """What FreeCAD has written into its report view."""
    return Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view").toPlainText()


def mouse_event(widget, position, kind, button=QtCore.Qt.NoButton, held=QtCore.Qt.NoButton):
    """Send one event of the mouse at a position of a widget.

    The window gets it, as from a real mouse, and gives it to what lies under the pointer.
    """
    window = widget.window()
    place = QtCore.QPointF(widget.mapTo(window, QtCore.QPointF(position).toPoint()))
    everywhere = QtCore.QPointF(window.mapToGlobal(place.toPoint()))
    event = QtGui.QMouseEvent(kind, place, everywhere, button, held, QtCore.Qt.NoModifier)
    QtWidgets.QApplication.sendEvent(window.windowHandle(), event)


def mouse(widget, position):
    """Press and release the left button at a position of a widget."""
    left = QtCore.Qt.LeftButton
    mouse_event(widget, position, QtCore.QEvent.MouseButtonPress, left, left)
    mouse_event(widget, position, QtCore.QEvent.MouseButtonRelease, left)


def scroll_to(widget):
    """Scroll the panel that holds a widget until it is in sight."""
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, QtWidgets.QScrollArea):
            around.ensureWidgetVisible(widget)
        around = around.parentWidget()


def click(widget, position):
    """Click a position of a widget, and wait for what that does."""
    scroll_to(widget)
    mouse(widget, position)
    settle()


def click_row(table, place, column=0):
    """Click a cell of a table."""
    index = table.model().index(place, column)
    table.scrollTo(index)
    click(table.viewport(), table.visualRect(index).center())


def picture(name):
    """Save the active 3D view on white and return it as an image."""
    path = os.path.join(OUT, name + ".png")
    Gui.activeDocument().activeView().saveImage(path, *PICTURE, "White")
    image = QtGui.QImage(path)
    assert not image.isNull(), path
    return image


def whole_window(name):
    """Save what is on the screen, where ImageMagick is installed."""
    if shutil.which("import"):
        path = os.path.join(OUT, name + ".png")
        subprocess.run(["import", "-window", "root", path], check=True, timeout=60)


def count(image, rgb, area=None, reach=12):
    """Pixels of a colour, give or take ``reach`` in each channel, within an area (QRect)."""
    area = area or image.rect()
    part = image.copy(area).convertToFormat(QtGui.QImage.Format_RGBA8888)
    pixels = numpy.frombuffer(bytes(part.constBits()), numpy.uint8).reshape(-1, 4)[:, :3]
    return int((abs(pixels.astype(int) - rgb) <= reach).all(axis=1).sum())


def messages():
    """Texts of the message boxes that are open; closes them."""
    boxes = [
        widget
        for widget in QtWidgets.QApplication.topLevelWidgets()
        if isinstance(widget, QtWidgets.QMessageBox) and widget.isVisible()
    ]
    texts = [box.text() for box in boxes]
    for box in boxes:
        box.close()
    settle()
    return texts


def camera():
    """Where the active view is seen from: position, orientation and height of its camera."""
    node = Gui.activeDocument().activeView().getCameraNode()
    return (
        node.position.getValue().getValue(),
        node.orientation.getValue().getValue(),
        node.height.getValue(),
    )


def analyses(doc):
    """The Seam Analyses of a document."""
    return [obj for obj in doc.Objects if analysis.is_analysis(obj)]


class WindowCase(unittest.TestCase):
    """Each test has a document of its own with a view from above, and no message left over."""

    def setUp(self):
        Gui.activateWorkbench("SeamwrightWorkbench")
        for dock in Gui.getMainWindow().findChildren(QtWidgets.QDockWidget):
            dock.setVisible(dock.objectName() in ("Combo View", "Model", "Tasks"))
        Gui.getMainWindow().showMaximized()
        self.doc = App.newDocument("Window")
        settle()

    def tearDown(self):
        self.assertEqual(messages(), [])
        if self.doc.Name in App.listDocuments():
            Gui.getDocument(self.doc.Name).resetEdit()
            App.closeDocument(self.doc.Name)
        settle(0.1)

    def fit(self):
        view = Gui.activeDocument().activeView()
        view.viewIsometric()
        view.fitAll()
        settle()

    def analyse(self):
        """Run the command; the analysis it made and its open panel."""
        Gui.runCommand("Seamwright_AnalyzeSeams")
        settle()
        obj = analyses(self.doc)[-1]
        return obj, obj.ViewObject.Proxy.panel

    def visible(self):
        return [obj.Name for obj in self.doc.Objects if obj.ViewObject.Visibility]

    def button(self, which):
        """OK or Cancel of the open task panel; boxes of closed panels can still exist, hidden."""
        boxes = Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
        (button,) = [box.button(which) for box in boxes if box.isVisible() and box.button(which)]
        return button

    def press(self, which):
        button = self.button(which)
        click(button, button.rect().center())
        settle()

    def ok(self):
        self.press(QtWidgets.QDialogButtonBox.Ok)

    def cancel(self):
        self.press(QtWidgets.QDialogButtonBox.Cancel)


class PanelWindow(WindowCase):
    """A command that makes an object and opens its panel: COMMAND is its name, is_made tells its
    objects."""

    COMMAND = ""
    is_made = None

    def run_selected(self, chosen):
        """Select elements, (object, name) each, and run the command; the object it made and its
        open panel."""
        Gui.Selection.clearSelection()
        for obj, name in chosen:
            Gui.Selection.addSelection(self.doc.Name, obj.Name, name)
        return self.run_command()

    def run_command(self):
        Gui.runCommand(self.COMMAND)
        settle()
        found = self.made()
        return (found[-1], found[-1].ViewObject.Proxy.panel) if found else (None, None)

    def made(self):
        return [obj for obj in self.doc.Objects if self.is_made(obj)]

    def press_undo(self):
        """Press Ctrl+Z, and wait for the panel."""
        press_key(QtCore.Qt.Key_Z, QtCore.Qt.ControlModifier)
        settle(0.8)

    def preview(self, panel):
        """Press the button Preview; a live panel is awaited."""
        if hasattr(panel, "preview_button"):
            click(panel.preview_button, panel.preview_button.rect().center())
        else:
            settle(0.8)

    def without_live_preview(self):
        """Panels that are opened from now on in this test compute when Preview is pressed."""
        self.addCleanup(preferences.reset)
        preferences.store({**table.defaults(), "LivePreview": False})

    def press_preview(self, panel):
        """Press Preview of a panel that is not live."""
        (button,) = (
            each
            for each in panel.form.findChildren(QtWidgets.QPushButton)
            if each.isVisible() and each.text() == "Preview"
        )
        click(button, button.rect().center())

    def use(self, panel, name, *chosen):
        """Select elements, (object, name) each, and let a box of sources use them."""
        Gui.Selection.clearSelection()
        for obj, element in chosen:
            Gui.Selection.addSelection(self.doc.Name, obj.Name, element)
        box = panel.boxes[name]
        click(box.use, box.use.rect().center())

    def column(self, panel, place):
        return [panel.table.item(line, place).text() for line in range(panel.table.rowCount())]
