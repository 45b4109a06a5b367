# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's highlight of what is under the mouse, which is switched off during a drag."""

import FreeCADGui as Gui

#: The field of the root of a scene that says what is highlighted; the second name is that of 1.0.
FIELDS = ("highlightMode", "preselectionMode")


class Preselection:
    """The highlights in the 3D views of a document."""

    def __init__(self, doc_name):
        self._doc_name = doc_name
        self._before = []  # (root of the scene, its field, the value of this) of each view

    def pause(self):
        """Remove the highlight, and make no new one until ``resume``."""
        if self._before:
            return
        views = Gui.getDocument(self._doc_name).mdiViewsOfType("Gui::View3DInventor")
        for root in (view.getSceneGraph() for view in views):
            field = _field(root)
            if field is not None:
                self._before.append((root, field, field.get().getString()))
                field.set("OFF")
        Gui.Selection.clearPreselection()

    def resume(self):
        """Highlight as before."""
        before, self._before = self._before, []
        for _, field, value in before:
            field.set(value)


def _field(root):
    found = (root.getField(name) for name in FIELDS)
    return next((field for field in found if field is not None), None)
