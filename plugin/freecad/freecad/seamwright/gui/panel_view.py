# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the views of the document objects have in common: an icon, a task panel, and marks at chosen
seams."""

import FreeCADGui as Gui

from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.halo import Halo
from freecad.seamwright.gui.later import later
from freecad.seamwright.gui.marker import Marker
from freecad.seamwright.plain import palette


class PanelView:
    """Proxy of a view provider; nothing is kept beside the properties."""

    ICON = ""

    #: The open task panel; FreeCAD tells of changes also before ``attach``.
    panel = None
    _follows = False

    #: Of a marked seam, in pixels.
    line_width = 6.0

    def make_panel(self, obj, created):
        """The task panel; ``created``: the object is new, and Cancel removes it."""
        raise NotImplementedError

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        self.object = vobj.Object
        self.panel = None
        self._follows = False
        self.created = False  # by the command, in the step that is still open
        self.halo, self.marker = Halo(), Marker()
        for node in (self.halo.node, self.marker.node):
            vobj.RootNode.insertChild(
                node, 0
            )  # before the placement of the shape: what they show stands in the model

    def updateData(self, obj, prop):
        """Let the panel show the object as it is once all of it has changed: a step back restores
        one property at a time."""
        if self.panel is not None and not self._follows:
            self._follows = True
            later(obj, self._reload)

    def _reload(self, obj):
        self._follows = False
        if self.panel is not None:
            self.panel.reload()

    def mark(self, edges, classes, worst):
        """Draw a bright band along the edges, which have the given classes; [] takes it away.

        ``worst`` is a list of (point, label) to be marked.
        """
        self.halo.show(edges, [palette.BY_KEY[key].unit_rgb for key in classes], self.line_width)
        self.marker.show(worst)

    def getIcon(self):
        """Icon in the tree."""
        return icon_path(self.ICON)

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
        self.mark([], [], [])
        Gui.Control.closeDialog()
        return True

    def dumps(self):
        """Nothing is kept beside the properties."""
        return None

    def loads(self, state):
        """Nothing is kept beside the properties."""

    # FreeCAD before 0.21.2 asks by these names.
    __getstate__ = dumps
    __setstate__ = loads
