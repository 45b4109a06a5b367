# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures for how long the window does not respond with a large model.

    python3 run_freecad.py --window --mod ADDON --out FOLDER --timeout 900 measure_window

prints, for each action on an analysis of a model with SEAMWRIGHT_FACES faces (20,000), how long it
takes, the longest time for which the event loop of the window stands still, and how much of that
time its thread computes: on a busy machine the rest is waiting for a processor.
"""

import math
import os
import sys
import time

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from PySide import QtCore
from window import WindowCase, analyses

from freecad.seamwright.gui.widgets import tasks
from freecad.seamwright.gui.widgets.qt import QtWidgets

FACES = int(os.environ.get("SEAMWRIGHT_FACES", "20000"))
TICK_MS = 5


def blocks(faces):
    """A compound of rounded blocks of 26 faces, on a grid."""
    block = models.rounded_block(8.0, 1.5)
    count = max(1, round(faces / len(block.Faces)))
    across = math.ceil(math.sqrt(count))
    copies = []
    for place in range(count):
        copies.append(block.copy())
        copies[-1].translate(App.Vector(10 * (place % across), 10 * (place // across), 0))
    return Part.Compound(copies)


class Clock(QtCore.QObject):
    """Counts in the event loop, and keeps the longest gap between two ticks."""

    def __init__(self):
        super().__init__()
        self.longest = self.longest_cpu = 0.0
        self._last, self._last_cpu = time.monotonic(), time.thread_time()
        self._timer = QtCore.QTimer()
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self._tick)
        self._timer.start()

    def _tick(self):
        now, cpu = time.monotonic(), time.thread_time()
        self.longest, self._last = max(self.longest, now - self._last), now
        self.longest_cpu, self._last_cpu = max(self.longest_cpu, cpu - self._last_cpu), cpu


def measure(name, act, rest_s=1.5):
    """Act within the event loop, and print the whole time and the longest block until all rests."""
    loop, clock = QtCore.QEventLoop(), Clock()
    begin = time.monotonic()
    ends = [begin]

    def acted():
        act()
        ends[0] = time.monotonic()
        wait()

    def wait():
        now = time.monotonic()
        if not tasks.tasks.idle:
            ends[0] = now
        if now - ends[0] < rest_s:
            QtCore.QTimer.singleShot(20, wait)
        else:
            loop.quit()

    QtCore.QTimer.singleShot(0, acted)
    loop.exec_() if hasattr(loop, "exec_") else loop.exec()
    clock._timer.stop()
    print(
        "%-22s %6.2f s, longest block %6.2f s (%.2f s computed)"
        % (name, ends[0] - begin, clock.longest, clock.longest_cpu)
    )
    sys.stdout.flush()


class Measure(WindowCase):
    def test_blocks(self):
        source = models.add(self.doc, blocks(FACES), "Blocks")
        self.doc.recompute()
        self.doc.UndoMode = 1
        Gui.activeDocument().activeView().viewIsometric()
        measure("show the model", Gui.activeDocument().activeView().fitAll)
        view = Gui.activeDocument().activeView()
        measure("draw it again", lambda: view.viewIsometric() or view.redraw())
        measure("analyze", lambda: Gui.runCommand("Seamwright_AnalyzeSeams"))
        (obj,) = analyses(self.doc)
        panel = obj.ViewObject.Proxy.panel
        print(obj.Summary)
        table = panel.seam_table.table
        measure("select a row", lambda: table.selectRow(0))
        measure("sort by angle", lambda: table.sortByColumn(2, QtCore.Qt.DescendingOrder))
        measure("show creases", lambda: panel.seam_table.filter.setCurrentIndex(2))
        measure("show all", lambda: panel.seam_table.filter.setCurrentIndex(0))
        measure("select 100 rows", lambda: _select(table, 100))
        measure("select all rows", table.selectAll)
        measure("clear the selection", table.clearSelection)
        measure("hide", lambda: setattr(obj.ViewObject, "Visibility", False))
        measure("show", lambda: setattr(obj.ViewObject, "Visibility", True))
        measure("pick an edge", lambda: Gui.Selection.addSelection(source, "Edge9"))
        measure("close the panel", panel.reject)
        measure("open the panel", lambda: Gui.activeDocument().setEdit(obj.Name))
        measure("undo", self.doc.undo)


def _select(table, count):
    model = table.model()
    chosen = QtCore.QItemSelection(model.index(0, 0), model.index(count - 1, 0))
    flags = QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows
    table.selectionModel().select(chosen, flags)
