# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of an analysis tool: what it draws, and its panel.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.properties import DONE, OUTDATED
from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.maps.drawing import drawing_of
from freecad.seamwright.gui.maps.panel import ToolPanel
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.plain import kernel


class ToolView(PanelView):
    """Proxy of the view provider of an analysis tool."""

    drawing = None
    _scheduled = False

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        self.drawing, self._scheduled = None, False
        self.schedule()

    def updateData(self, obj, prop):
        """Draw again where something changed on which the drawing depends."""
        super().updateData(obj, prop)
        if prop in ("Shape", "Report", "Outcome", *getattr(obj.Proxy, "INPUTS", ())):
            self.schedule()

    def onChanged(self, vobj, prop):
        """Draw or remove what is drawn."""
        if prop == "Visibility":
            self.schedule()

    def schedule(self):
        """Draw once all changes are done."""
        if not self._scheduled:
            self._scheduled = True
            later(self.object, self._draw)

    def _draw(self, obj):
        self._scheduled = False
        if self.drawing is None:
            self.drawing = drawing_of(obj)
        shown = obj.ViewObject.Visibility and obj.Outcome in (DONE, OUTDATED)
        self.mark([], [], obj.Proxy.marks(feature.report_of(obj)) if shown else [])
        if self.drawing is None:
            return
        try:
            if shown:
                self.drawing.refresh(obj)
                return
        except (sources.SourceError, ValueError, kernel.KernelUnavailable):
            pass  # the object says why there is nothing to draw
        self.drawing.cancel()
        self.drawing.clear()

    def unsetEdit(self, vobj, mode=0):
        """Close the task panel; what is drawn stays."""
        super().unsetEdit(vobj, mode)
        self.schedule()
        return True

    def getIcon(self):
        """Return the icon in the tree."""
        self.ICON = self.object.Proxy.ICON
        return super().getIcon()

    def make_panel(self, obj, created):
        """Return the task panel."""
        return ToolPanel(obj, created)


def attach_view(obj):
    """Give a tool its view provider if it has none."""
    attach_as(ToolView, obj)
