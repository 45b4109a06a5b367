# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observing what the user picks in the 3D view, to find its seam in the table."""

import contextlib

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui.base.picked import owner_of
from freecad.seamwright.gui.widgets.qt import QtCore


class EdgePicker:
    """Calls ``picked(edge numbers)`` when edges of an analysis or of its sources are selected.

    ``numbers``: {(object name, "Edge3"): edge number}. The picker observes FreeCAD's selection
    between ``start`` and ``stop``, except within ``paused``. It tells all edges at once that are
    selected in one go, when FreeCAD has finished its own selection.
    """

    def __init__(self, obj, picked):
        self.numbers = {}
        self._doc_name = obj.Document.Name
        self._picked = picked
        self._found = []
        self._paused = False
        self.active = False

    def start(self):
        """Start to observe the selection."""
        self.active = True
        Gui.Selection.addObserver(self, 0)  # with paths from the top of the document

    def stop(self):
        """Stop observing the selection."""
        self.active = False
        Gui.Selection.removeObserver(self)

    @contextlib.contextmanager
    def paused(self):
        """Ignore selections that the program itself makes."""
        before, self._paused = self._paused, True
        try:
            yield
        finally:
            self._paused = before

    def addSelection(self, doc_name, name, element, position):
        """FreeCAD calls this when an element is added to the selection."""
        if self._paused or doc_name != self._doc_name:
            return
        number = self._number(App.getDocument(doc_name).getObject(name), element)
        if number is None:
            return
        if not self._found:
            QtCore.QTimer.singleShot(0, self._tell)
        self._found.append(number)

    def _number(self, top, path):
        *_, element = path.split(".")
        if not element.startswith("Edge"):
            return None
        obj, element = owner_of(top, path)
        return self.numbers.get((obj.Name, element))

    def _tell(self):
        found, self._found = self._found, []
        if self.active:
            self._picked(found)
