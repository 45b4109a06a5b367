# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn on document objects in place of their own faces and edges: it changes neither
documents nor shapes.

A coat follows the place and the visibility of its object, and ends with it. An object may wear
several, of several wardrobes: the one put on last is seen.
"""

import FreeCAD as App
import Part
from pivy import coin

from freecad.seamwright.gui import stripes

NAME = "SeamwrightCoat"


def local_shape(obj):
    """The shape of an object relative to the object's own placement, as its view draws it."""
    shape = Part.getShape(obj)
    if shape.isNull():
        return shape
    shape = shape.copy(False, False)
    placement = getattr(obj, "Placement", App.Placement())
    shape.Placement = placement.inverse() * shape.Placement
    return shape


class Coats:
    """Coats of one kind, at most one an object. ``changed(obj)`` is called when the shape of an
    object that wears one changed."""

    def __init__(self, changed):
        self._changed = changed
        self._worn = {}  # (document, object): (root, switch)
        self._follower = None

    def objects(self, doc):
        """The objects of a document that wear a coat."""
        return [doc.getObject(name) for doc_name, name in self._worn if doc_name == doc.Name]

    def put(self, obj, node):
        """Draw the node, of the object's local shape, in place of the object."""
        if self._follower is None:
            self._follower = _Follower(self)
            App.addDocumentObserver(self._follower)
        self.forget(*key(obj))
        root, switch = obj.ViewObject.RootNode, coin.SoSwitch()
        switch.setName(NAME)
        switch.addChild(node)
        switch.addChild(stripes.unseen())
        root.insertChild(switch, _place(root, obj.ViewObject.SwitchNode))
        self._worn[key(obj)] = (root, switch)
        self.follow_visibility(obj)

    def take_off(self, objects):
        """Let the objects look as they do themselves."""
        for obj in objects:
            self.forget(*key(obj))

    def clear(self):
        """Take off all coats, and follow documents no longer; not to be called while ``changed``
        is."""
        for place in list(self._worn):
            self.forget(*place)
        if self._follower is not None:
            App.removeDocumentObserver(self._follower)
            self._follower = None

    def wears(self, obj):
        """Whether an object wears a coat."""
        return key(obj) in self._worn

    def follow_visibility(self, obj):
        """Hide the coat of a hidden object."""
        _, switch = self._worn.get(key(obj), (None, None))
        if switch is not None:
            switch.whichChild = coin.SO_SWITCH_ALL if obj.Visibility else coin.SO_SWITCH_NONE

    def follow_shape(self, obj):
        """Tell of an object that wears a coat of another shape than it has."""
        if self.wears(obj):
            self._changed(obj)

    def forget(self, doc_name, name=None):
        """An object wears no coat any more, or with no name all of a document."""
        for place in list(self._worn):
            if place[0] == doc_name and name in (None, place[1]):
                root, switch = self._worn.pop(place)
                root.removeChild(switch)


def key(obj):
    """(document, object): their names."""
    return obj.Document.Name, obj.Name


def _place(root, own):
    """Where a coat goes: before all others, as the first one hides what comes after it, and before
    the object's own nodes."""
    worn = [
        place
        for place in range(root.getNumChildren())
        if root.getChild(place).getName().getString() == NAME
    ]
    return min([root.findChild(own), *worn])


class _Follower:
    """Hears of changes from FreeCAD.

    Of objects only: view providers are announced before they have an object, and asking one for it
    then ends FreeCAD.
    """

    def __init__(self, coats):
        self._coats = coats

    def slotChangedObject(self, obj, prop):
        """A property of an object has a new value."""
        if prop == "Shape":
            self._coats.follow_shape(obj)
        elif prop == "Visibility":
            self._coats.follow_visibility(obj)

    def slotDeletedObject(self, obj):
        """An object goes away."""
        self._coats.forget(*key(obj))

    def slotDeletedDocument(self, doc):
        """A document is closed."""
        self._coats.forget(doc.Name)
