# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects' views: icon, task panel, marks at chosen seams."""

import FreeCADGui as Gui

from freecad.seamwright.document import feature
from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.scene.halo import Halo
from freecad.seamwright.gui.scene.marker import Marker
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.plain import palette


class PanelView:
    """Proxy of a view provider; it stores no state besides the properties."""

    ICON = ""

    #: The open task panel. A class attribute, since FreeCAD reports changes even before ``attach``.
    panel = None
    _follows = False

    #: The line width of a marked seam, in pixels.
    line_width = 6.0

    def make_panel(self, obj, created):
        """Return the task panel; ``created``: the object is new, and Cancel removes it."""
        raise NotImplementedError

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        self.object = vobj.Object
        self.panel = None
        self._follows = False
        self.created = False  # whether the command created the object in the open transaction
        self.halo, self.marker = Halo(), Marker()
        for node in (self.halo.node, self.marker.node):
            # Before the placement of the shape, since marks have world coordinates.
            vobj.RootNode.insertChild(node, 0)

    def updateData(self, obj, prop):
        """Let the panel show the object once all changes are done.

        An undo restores one property at a time.
        """
        if self.panel is not None and not self._follows:
            self._follows = True
            later(obj, self._reload)
        if prop == "Outcome" and "Invalid" in obj.State:
            later(obj, feature.clear_error)

    def _reload(self, obj):
        self._follows = False
        if self.panel is not None:
            self.panel.reload()

    def mark(self, lines, classes, worst, near_mm=0.0):
        """Draw a bright band along lines of seams, which have the given classes; [] removes it.

        A line is a list of points. ``worst`` is a list of (point, label) to be marked; for it and
        ``near_mm`` see Marker.show.
        """
        self.halo.show(lines, [palette.BY_KEY[key].unit_rgb for key in classes], self.line_width)
        self.marker.show(worst, near_mm)

    def getIcon(self):
        """Return the icon in the tree."""
        return icon_path(self.ICON)

    def doubleClicked(self, vobj):
        """Open the task panel."""
        return vobj.Document.setEdit(vobj.Object.Name)

    def setEdit(self, vobj, mode=0):
        """Show the task panel."""
        created, self.created = self.created, False
        Gui.Selection.removeSelection(vobj.Object)  # its colour would cover those of the object
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
        """Return None: the properties keep all state."""
        return None

    def loads(self, state):
        """Do nothing: the properties keep all state."""

    # FreeCAD before 0.21.2 calls these names.
    __getstate__ = dumps
    __setstate__ = loads
