# SPDX-License-Identifier: LGPL-2.1-or-later
"""Running something once FreeCAD has finished its current work."""

import FreeCAD as App

from freecad.seamwright.gui.widgets.qt import QtCore
from freecad.seamwright.gui.widgets.tasks import documents_rest

#: The interval of retries while a recompute runs that keeps the window alive.
AGAIN_MS = 50


def find(doc_name, name):
    """Return the object of that name; None when it was deleted or its document was closed."""
    return App.getDocument(doc_name).getObject(name) if doc_name in App.listDocuments() else None


def later(obj, act):
    """Call ``act(obj)`` after FreeCAD has drawn or opened, if the object still exists then."""
    later_named(obj.Document.Name, obj.Name, act)


def later_named(doc_name, name, act):
    """Call ``act`` as ``later`` does, with the object of that name."""

    def act_if_there():
        if not documents_rest():
            QtCore.QTimer.singleShot(AGAIN_MS, act_if_there)
            return
        found = find(doc_name, name)
        if found is not None:
            act(found)

    QtCore.QTimer.singleShot(0, act_if_there)
