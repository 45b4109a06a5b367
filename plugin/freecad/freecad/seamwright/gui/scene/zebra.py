# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zebra stripes on document objects; they change neither documents nor shapes.

The stripes follow the shape, the position and the visibility of their object, and are removed with
it.
"""

import FreeCAD as App

from freecad.seamwright.document.display_mesh import display_mesh, fault_lines
from freecad.seamwright.gui.scene import stripes
from freecad.seamwright.gui.scene.substitutes import Substitutes, key, local_shape
from freecad.seamwright.gui.widgets.progress import progress_dialog
from freecad.seamwright.gui.widgets.qt import QtCore
from freecad.seamwright.plain.language import tr


class Zebra:
    """The stripes of all documents."""

    def __init__(self):
        self._substitutes = Substitutes(self._follow_shape)
        self._stale = set()

    def objects(self, doc):
        """Return the objects of a document that have stripes."""
        return self._substitutes.objects(doc)

    def show(self, objects):
        """Draw stripes on the objects as they are now; return False when the user cancelled."""
        with progress_dialog(tr("Computing zebra stripes\u2026")) as progress:
            for index, obj in enumerate(objects):
                found = display_mesh(
                    local_shape(obj),
                    lambda part, index=index: progress((index + part) / len(objects)),
                )
                if found is None:
                    return False
                self._substitutes.put(obj, stripes.node(found))
                for line in fault_lines(obj.Label, found.faults):
                    App.Console.PrintWarning("Seamwright: %s\n" % line)
        return True

    def hide(self, objects):
        """Remove the stripes of the objects."""
        self._substitutes.remove(objects)

    def redraw(self, doc):
        """Draw the stripes of a document again, as the preferences are now."""
        self.show(self.objects(doc))

    def _follow_shape(self, obj):
        """Redraw the stripes of a changed object, once FreeCAD has finished its recompute."""
        if not self._stale:
            QtCore.QTimer.singleShot(0, self._redraw)
        self._stale.add(key(obj))

    def _redraw(self):
        stale, self._stale = self._stale, set()
        found = [
            App.getDocument(doc).getObject(name)
            for doc, name in stale
            if doc in App.listDocuments()
        ]
        self.show([obj for obj in found if obj is not None and self._substitutes.has(obj)])


zebra = Zebra()
