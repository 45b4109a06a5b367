# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of an object that stands for its sources: they are hidden while it has a result, as
those of a boolean operation are, and stand below it in the tree.
"""

from freecad.seamwright.gui.panel_view import PanelView


class ResultView(PanelView):
    """Proxy of a view provider; a subclass says what the sources are, when there is a result, and
    which panel it has."""

    def sources(self, obj):
        """The objects that the result stands for."""
        raise NotImplementedError

    def has_result(self, obj):
        """Whether the object has a shape of its own to show."""
        return not obj.Shape.isNull()

    def began(self, obj):
        """There is a result for the first time."""

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        self._had_result = self.has_result(vobj.Object)

    def updateData(self, obj, prop):
        """Hide the sources when there begins to be a result, show them when there no longer is
        one."""
        super().updateData(obj, prop)
        if prop != "Summary" or "Restore" in obj.State:  # the Summary is written last
            return
        has_result = self.has_result(obj)
        if has_result != self._had_result:
            self._had_result = has_result
            if has_result:
                self.began(obj)
            if self.panel is None:
                self.show_sources(obj, not has_result)

    def show_sources(self, obj, shown):
        """Show or hide the sources."""
        for source in self.sources(obj):
            source.ViewObject.Visibility = shown

    def claimChildren(self):
        """The sources stand below the object in the tree."""
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
