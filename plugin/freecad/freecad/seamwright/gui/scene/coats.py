# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn on document objects in place of their own faces and edges.

It changes neither documents nor shapes. A coat follows the position and the visibility of its
object, and is removed with it. Several Coats may each put a coat on one object; the last one is
visible.
"""

import FreeCAD as App
import Part
from pivy import coin

from freecad.seamwright.gui.scene import stripes

NAME = "SeamwrightCoat"


def local_shape(obj):
    """Return the shape of an object relative to its own placement, as its view draws it."""
    shape = Part.getShape(obj)
    if shape.isNull():
        return shape
    shape = shape.copy(False, False)
    placement = getattr(obj, "Placement", App.Placement())
    shape.Placement = placement.inverse() * shape.Placement
    return shape


class Coats:
    """Coats of one kind, at most one for each object.

    ``changed(obj)`` is called when an object with a coat gets another shape.
    """

    def __init__(self, changed):
        self._changed = changed
        self._worn = {}  # (document, object): (root, switch)
        self._follower = None

    def objects(self, doc):
        """Return the objects of a document that have a coat."""
        return [doc.getObject(name) for doc_name, name in self._worn if doc_name == doc.Name]

    def put(self, obj, node):
        """Draw the node in place of the object; the node shows the object's local shape."""
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
        """Remove the coats of the objects, so that these are drawn as usual."""
        for obj in objects:
            self.forget(*key(obj))

    def clear(self):
        """Remove all coats and stop observing documents; must not be called from ``changed``."""
        for place in list(self._worn):
            self.forget(*place)
        if self._follower is not None:
            App.removeDocumentObserver(self._follower)
            self._follower = None

    def wears(self, obj):
        """Return whether an object has a coat."""
        return key(obj) in self._worn

    def follow_visibility(self, obj):
        """Hide the coat of a hidden object."""
        _, switch = self._worn.get(key(obj), (None, None))
        if switch is not None:
            switch.whichChild = coin.SO_SWITCH_ALL if obj.Visibility else coin.SO_SWITCH_NONE

    def follow_shape(self, obj):
        """Report that an object with a coat has a new shape."""
        if self.wears(obj):
            self._changed(obj)

    def forget(self, doc_name, name=None):
        """Remove the coat of an object, or without a name those of all objects of a document."""
        for place in list(self._worn):
            if place[0] == doc_name and name in (None, place[1]):
                root, switch = self._worn.pop(place)
                root.removeChild(switch)


def key(obj):
    """Return the names (document, object) of an object."""
    return obj.Document.Name, obj.Name


def _place(root, own):
    """Return the index at which a coat is inserted.

    It comes before all other coats, since the first coat hides all that follows, and before the
    object's own nodes.
    """
    worn = [
        place
        for place in range(root.getNumChildren())
        if root.getChild(place).getName().getString() == NAME
    ]
    return min([root.findChild(own), *worn])


class _Follower:
    """Observes changes of documents.

    It observes objects only. FreeCAD announces view providers before they have an object, and
    crashes when one of these is asked for its object.
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
        """An object is deleted."""
        self._coats.forget(*key(obj))

    def slotDeletedDocument(self, doc):
        """A document is closed."""
        self._coats.forget(doc.Name)
