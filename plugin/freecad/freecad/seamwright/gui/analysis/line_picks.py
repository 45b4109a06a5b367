# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of an analysis in the way of the mouse: they are picked only where no edge is seen.

A line lies on the edge that it shows. FreeCAD then picks neither of them, but a face beside.
"""

import weakref

import FreeCAD as App

from freecad.seamwright.gui.widgets.later import find, later

#: The display modes in which the edges of an object cannot be picked.
WITHOUT_EDGES = ("Shaded", "Points")


class LinePicks:
    """Lets the lines of an analysis be picked while none of its sources shows edges."""

    def __init__(self, obj, lines):
        self._names, self._lines, self._due = (obj.Document.Name, obj.Name), lines, False
        _follower.add(self)

    def update(self, obj):
        """Look which sources show edges now."""
        self._due = False
        self._lines.set_pickable(not any(map(_shows_edges, obj.Analysed)))

    def follow(self, doc_name):
        """An object of a document was shown or hidden."""
        obj = find(*self._names) if doc_name == self._names[0] else None
        if obj is not None and not self._due:
            self._due = True
            later(obj, self.update)


def _shows_edges(obj):
    return obj.Visibility and getattr(obj.ViewObject, "DisplayMode", "") not in WITHOUT_EDGES


class _Follower:
    """Observes which objects are shown."""

    def __init__(self):
        self._followed = weakref.WeakSet()
        self._observes = False

    def add(self, picks):
        """Tell a LinePicks what is shown or hidden."""
        if not self._observes:
            App.addDocumentObserver(self)
            self._observes = True
        self._followed.add(picks)

    def slotChangedObject(self, obj, prop):
        """A property of an object has a new value."""
        if prop == "Visibility":
            for picks in list(self._followed):
                picks.follow(obj.Document.Name)


_follower = _Follower()
