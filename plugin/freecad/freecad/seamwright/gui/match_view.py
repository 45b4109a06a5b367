# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Match Surfaces looks: its sources are hidden while it has a shape, as those of a boolean operation are.

The class path is written into documents: neither rename nor move it.
"""

import FreeCADGui as Gui

from freecad.seamwright.document import match
from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.match_panel import MatchPanel


class MatchSurfacesView:
    """Proxy of the view provider of a Match Surfaces."""

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        self.object = vobj.Object
        self.panel = None
        self.created = False  # by the command, in the step that is still open
        self._matched = bool(vobj.Object.Matched)

    def updateData(self, obj, prop):
        """Hide the sources when the faces begin to match, show them when they no longer do."""
        if prop == "Summary" and obj.Matched != self._matched and "Restore" not in obj.State:
            self._matched = obj.Matched
            if self.panel is None:
                show_sources(obj, not obj.Matched)

    def getIcon(self):
        """Icon in the tree."""
        return icon_path("seamwright-match")

    def claimChildren(self):
        """The sources stand below the match in the tree."""
        return match.source_objects(self.object)

    def doubleClicked(self, vobj):
        """Open the task panel."""
        return vobj.Document.setEdit(vobj.Object.Name)

    def setEdit(self, vobj, mode=0):
        """Show the task panel."""
        created, self.created = self.created, False
        self.panel = MatchPanel(vobj.Object, created)
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
        """Show the sources again when the match is deleted."""
        show_sources(vobj.Object, True)
        return True

    def dumps(self):
        """Nothing is kept beside the properties."""
        return None

    def loads(self, state):
        """Nothing is kept beside the properties."""

    # FreeCAD before 0.21.2 asks by these names.
    __getstate__ = dumps
    __setstate__ = loads


def show_sources(obj, shown):
    """Show or hide the objects that the faces come from."""
    for source in match.source_objects(obj):
        source.ViewObject.Visibility = shown


def attach_view(obj):
    """Give a match its view provider if it has none."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, MatchSurfacesView):
        MatchSurfacesView(vobj)
