# SPDX-License-Identifier: LGPL-2.1-or-later
"""Observing what the user picks in the 3D view, to find its seam in the table."""

import contextlib

import FreeCADGui as Gui

from freecad.seamwright.plain import rows


class EdgePicker:
    """Calls ``picked(edge number)`` when an edge of an analysis or of its sources is selected.

    Numbers are those of ``report``. The picker observes FreeCAD's selection between ``start`` and
    ``stop``, except within ``paused``.
    """

    def __init__(self, obj, picked):
        self.report = {}
        self._obj = obj
        self._picked = picked
        self._paused = False
        self.active = False

    def start(self):
        """Start to observe the selection."""
        self.active = True
        Gui.Selection.addObserver(self)

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
        if self._paused or doc_name != self._obj.Document.Name:
            return
        *path, element = element.split(".")
        name = path[-1] if path else name
        number = rows.edge_number(self.report, self._obj.Name, name, element)
        if number is not None:
            self._picked(number)
