# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of an object that takes the place of its sources.

The sources are hidden while the object has a result, like those of a boolean operation. In the tree
they are children of the object.
"""

from freecad.seamwright.gui.base.panel_view import PanelView


class ResultView(PanelView):
    """Proxy of a view provider.

    A subclass defines the sources, when there is a result, and the panel.
    """

    def sources(self, obj):
        """Return the objects whose place the result takes."""
        raise NotImplementedError

    def has_result(self, obj):
        """Return whether the object has a shape of its own to show."""
        return not obj.Shape.isNull()

    def first_result(self, obj):
        """Called when there is a result for the first time."""

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        self._had_result = self.has_result(vobj.Object)

    def updateData(self, obj, prop):
        """Hide the sources when a result appears; show them when it disappears."""
        super().updateData(obj, prop)
        if prop != "Summary" or "Restore" in obj.State:  # Summary is written last
            return
        has_result = self.has_result(obj)
        if has_result != self._had_result:
            self._had_result = has_result
            if has_result:
                self.first_result(obj)
            if self.panel is None:
                self.show_sources(obj, not has_result)

    def show_sources(self, obj, shown):
        """Show or hide the sources."""
        for source in self.sources(obj):
            source.ViewObject.Visibility = shown

    def claimChildren(self):
        """Return the sources: they are children of the object in the tree."""
        return self.sources(self.object)

    def onDelete(self, vobj, names):
        """Show the sources again when the object is deleted."""
        self.show_sources(vobj.Object, True)
        return True


def look_like(obj, source):
    """Give the faces of an object the colours of its source."""
    look, vobj = source.ViewObject, obj.ViewObject
    if not hasattr(look, "ShapeColor"):
        return
    vobj.ShapeColor = look.ShapeColor
    if len(look.DiffuseColor) == len(obj.Shape.Faces):
        vobj.DiffuseColor = look.DiffuseColor


def attach_as(view, obj):
    """Give an object a view provider of that class if it has none."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, view):
        view(vobj)
