# SPDX-License-Identifier: LGPL-2.1-or-later
"""Doing something once FreeCAD is done with what it is doing."""

import FreeCAD as App

from freecad.seamwright.gui.qt import QtCore


def later(obj, act):
    """Call ``act(obj)`` after FreeCAD has drawn or opened, if the document object is still there then."""
    doc_name, name = obj.Document.Name, obj.Name

    def act_if_there():
        found = App.getDocument(doc_name).getObject(name) if doc_name in App.listDocuments() else None
        if found is not None:
            act(found)

    QtCore.QTimer.singleShot(0, act_if_there)
