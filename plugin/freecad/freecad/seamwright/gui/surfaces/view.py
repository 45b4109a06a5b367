# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a surface: its panel.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.surfaces.panel import SurfacePanel

COLOUR = (0.45, 0.8, 0.7)


class SurfaceView(PanelView):
    """Proxy of the view provider of a surface."""

    def getIcon(self):
        """Return the icon in the tree."""
        self.ICON = self.object.Proxy.ICON
        return super().getIcon()

    def make_panel(self, obj, created):
        """Return the task panel."""
        return SurfacePanel(obj, created)


def attach_view(obj):
    """Give a surface its view provider if it has none, and a colour of its own.

    One that was saved while its panel was open can be selected again.
    """
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, SurfaceView):
        vobj.ShapeColor = COLOUR
    if vobj is not None:
        vobj.Selectable = True
    attach_as(SurfaceView, obj)
