# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zebra stripes on document objects: a way of looking that changes neither document nor shapes.

The stripes follow the shape, the place and the visibility of their object, and end with it.
"""

import FreeCAD as App
import Part
from pivy import coin

from freecad.seamwright.document.display_mesh import display_mesh, fault_lines
from freecad.seamwright.gui import stripes
from freecad.seamwright.gui.progress import progress_dialog
from freecad.seamwright.gui.qt import QtCore


def local_shape(obj):
    """The shape of an object relative to the object's own placement, as its view draws it."""
    shape = Part.getShape(obj)
    if shape.isNull():
        return shape
    shape = shape.copy(False, False)
    placement = getattr(obj, "Placement", App.Placement())
    shape.Placement = placement.inverse() * shape.Placement
    return shape


class Zebra:
    """The stripes of all documents."""

    def __init__(self):
        self._shown = {}  # (document, object): (root, switch)
        self._stale = set()
        self._follows = False

    def objects(self, doc):
        """The objects of a document that are striped."""
        return [doc.getObject(name) for doc_name, name in self._shown if doc_name == doc.Name]

    def show(self, objects):
        """Draw stripes on the objects, as their shapes are now; False when the user cancelled."""
        if not self._follows:
            App.addDocumentObserver(_Follower(self))
            self._follows = True
        with progress_dialog("Computing zebra stripes\u2026") as progress:
            for place, obj in enumerate(objects):
                found = display_mesh(
                    local_shape(obj), lambda part, place=place: progress((place + part) / len(objects))
                )
                if found is None:
                    return False
                self._draw(obj, stripes.node(found))
                for line in fault_lines(obj.Label, found.faults):
                    App.Console.PrintWarning("Seamwright: %s\n" % line)
        return True

    def hide(self, objects):
        """Take the stripes off the objects."""
        for obj in objects:
            self._drop(_key(obj))

    def _draw(self, obj, node):
        self._drop(_key(obj))
        root, switch = obj.ViewObject.RootNode, coin.SoSwitch()
        switch.addChild(node)
        switch.addChild(stripes.unseen())
        root.insertChild(switch, root.findChild(obj.ViewObject.SwitchNode))
        self._shown[_key(obj)] = (root, switch)
        self.follow_visibility(obj)

    def _drop(self, key):
        if key in self._shown:
            root, switch = self._shown.pop(key)
            root.removeChild(switch)

    def follow_visibility(self, obj):
        """Hide the stripes of a hidden object."""
        _, switch = self._shown.get(_key(obj), (None, None))
        if switch is not None:
            switch.whichChild = coin.SO_SWITCH_ALL if obj.Visibility else coin.SO_SWITCH_NONE

    def follow_shape(self, obj):
        """Draw the stripes of a changed object anew, once FreeCAD is done with its recompute."""
        if _key(obj) in self._shown:
            if not self._stale:
                QtCore.QTimer.singleShot(0, self._redraw)
            self._stale.add(_key(obj))

    def _redraw(self):
        stale, self._stale = self._stale, set()
        self.show([App.getDocument(key[0]).getObject(key[1]) for key in stale if key in self._shown])

    def forget(self, doc_name, name=None):
        """An object is no more, or with no name a whole document."""
        for key in list(self._shown):
            if key[0] == doc_name and name in (None, key[1]):
                self._drop(key)


def _key(obj):
    return obj.Document.Name, obj.Name


class _Follower:
    """Hears of changes from FreeCAD.

    Of objects only: view providers are announced before they have an object, and asking one for it then ends FreeCAD.
    """

    def __init__(self, zebra):
        self._zebra = zebra

    def slotChangedObject(self, obj, prop):
        """A property of an object has a new value."""
        if prop == "Shape":
            self._zebra.follow_shape(obj)
        elif prop == "Visibility":
            self._zebra.follow_visibility(obj)

    def slotDeletedObject(self, obj):
        """An object goes away."""
        self._zebra.forget(*_key(obj))

    def slotDeletedDocument(self, doc):
        """A document is closed."""
        self._zebra.forget(doc.Name)


zebra = Zebra()
