# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of an object that stands for its sources: they are hidden while it has a result, as those of a boolean
operation are, and stand below it in the tree.
"""

import FreeCADGui as Gui

from freecad.seamwright.gui import icon_path


class ResultView:
    """Proxy of a view provider; a subclass says what the sources are, when there is a result, and which panel it has."""

    ICON = ""

    def sources(self, obj):
        """The objects that the result stands for."""
        raise NotImplementedError

    def has_result(self, obj):
        """Whether the object has a shape of its own to show."""
        raise NotImplementedError

    def make_panel(self, obj, created):
        """The task panel; ``created``: the object is new, and Cancel removes it."""
        raise NotImplementedError

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        self.object = vobj.Object
        self.panel = None
        self.created = False  # by the command, in the step that is still open
        self._had_result = self.has_result(vobj.Object)

    def updateData(self, obj, prop):
        """Hide the sources when there begins to be a result, show them when there no longer is one."""
        if prop != "Summary" or "Restore" in obj.State:  # the Summary is written last
            return
        has_result = self.has_result(obj)
        if has_result != self._had_result:
            self._had_result = has_result
            if self.panel is None:
                self.show_sources(obj, not has_result)

    def show_sources(self, obj, shown):
        """Show or hide the sources."""
        for source in self.sources(obj):
            source.ViewObject.Visibility = shown

    def getIcon(self):
        """Icon in the tree."""
        return icon_path(self.ICON)

    def claimChildren(self):
        """The sources stand below the object in the tree."""
        return self.sources(self.object)

    def doubleClicked(self, vobj):
        """Open the task panel."""
        return vobj.Document.setEdit(vobj.Object.Name)

    def setEdit(self, vobj, mode=0):
        """Show the task panel."""
        created, self.created = self.created, False
        self.panel = self.make_panel(vobj.Object, created)
        Gui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, vobj, mode=0):
        """Close the task panel."""
        if self.panel is not None:
            self.panel.leave()
        self.panel = None
        Gui.Control.closeDialog()
        return True

    def onDelete(self, vobj, names):
        """Show the sources again when the object is deleted."""
        self.show_sources(vobj.Object, True)
        return True

    def dumps(self):
        """Nothing is kept beside the properties."""
        return None

    def loads(self, state):
        """Nothing is kept beside the properties."""

    # FreeCAD before 0.21.2 asks by these names.
    __getstate__ = dumps
    __setstate__ = loads
