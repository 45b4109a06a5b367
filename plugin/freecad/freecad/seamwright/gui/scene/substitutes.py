# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn on document objects in place of their own faces and edges.

It changes neither documents nor shapes. A substitute follows the position and the visibility of its
object, and is removed with it. If several Substitutes put one on an object, the last is visible.
"""

import FreeCAD as App
import Part
from pivy import coin

from freecad.seamwright.gui.scene import stripes

NAME = "SeamwrightSubstitute"


def local_shape(obj):
    """Return the shape of an object relative to its own placement, as its view draws it."""
    shape = Part.getShape(obj)
    if shape.isNull():
        return shape
    shape = shape.copy(False, False)
    placement = getattr(obj, "Placement", App.Placement())
    shape.Placement = placement.inverse() * shape.Placement
    return shape


class Substitutes:
    """Substitutes of one kind, at most one for each object.

    ``changed(obj)`` is called when an object with a substitute gets another shape, ``turned()``
    when one is shown or hidden.
    """

    def __init__(self, changed, turned=lambda: None):
        self._changed, self._turned = changed, turned
        self._shown = {}  # (document, object): (root, switch)
        self._follower = None

    def objects(self, doc):
        """Return the objects of a document that have a substitute."""
        return [doc.getObject(name) for doc_name, name in self._shown if doc_name == doc.Name]

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
        root.insertChild(switch, first_index(obj))
        self._shown[key(obj)] = (root, switch)
        self.follow_visibility(obj)

    def remove(self, objects):
        """Remove the substitutes of the objects, so that these are drawn as usual."""
        for obj in objects:
            self.forget(*key(obj))

    def clear(self):
        """Remove all substitutes and stop observing documents.

        Must not be called from ``changed``.
        """
        for names in list(self._shown):
            self.forget(*names)
        if self._follower is not None:
            App.removeDocumentObserver(self._follower)
            self._follower = None

    def has(self, obj):
        """Return whether an object has a substitute."""
        return key(obj) in self._shown

    def follow_visibility(self, obj):
        """Hide the substitute of a hidden object."""
        _, switch = self._shown.get(key(obj), (None, None))
        if switch is not None:
            switch.whichChild = coin.SO_SWITCH_ALL if obj.Visibility else coin.SO_SWITCH_NONE
            self._turned()

    def follow_shape(self, obj):
        """Report that an object with a substitute has a new shape."""
        if self.has(obj):
            self._changed(obj)

    def forget(self, doc_name, name=None):
        """Remove the substitute of an object; without a name, all those of a document."""
        for names in list(self._shown):
            if names[0] == doc_name and name in (None, names[1]):
                root, switch = self._shown.pop(names)
                root.removeChild(switch)


def key(obj):
    """Return the names (document, object) of an object."""
    return obj.Document.Name, obj.Name


def first_index(obj):
    """Return the index at which a substitute is inserted into the root of an object's view.

    It comes before all other substitutes, since the first hides all that follows, and before the
    object's own nodes. What is inserted there otherwise is seen beside substitutes.
    """
    root, own = obj.ViewObject.RootNode, obj.ViewObject.SwitchNode
    others = [
        index
        for index in range(root.getNumChildren())
        if root.getChild(index).getName().getString() == NAME
    ]
    return min([root.findChild(own), *others])


class _Follower:
    """Observes changes of documents.

    It observes objects only. FreeCAD announces view providers before they have an object, and
    crashes when one of these is asked for its object.
    """

    def __init__(self, substitutes):
        self._substitutes = substitutes

    def slotChangedObject(self, obj, prop):
        """A property of an object has a new value."""
        if prop == "Shape":
            self._substitutes.follow_shape(obj)
        elif prop == "Visibility":
            self._substitutes.follow_visibility(obj)

    def slotDeletedObject(self, obj):
        """An object is deleted."""
        self._substitutes.forget(*key(obj))

    def slotDeletedDocument(self, doc):
        """A document is closed."""
        self._substitutes.forget(doc.Name)
