# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a curve: its curvature comb and its panel.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document.properties import Adder
from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.curves.panel import CurvePanel
from freecad.seamwright.gui.scene.comb import Comb

COLOUR, WIDTH = (0.0, 0.32, 0.62), 2.0


class CurveView(PanelView):
    """Proxy of the view provider of a curve."""

    comb = None

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        adder = Adder(vobj)
        adder.add_with(
            "App::PropertyBool", "ShowComb", "Curvature comb", "Draw the curvature comb", False
        )
        tip = "Length of the lines of the comb; 1: the longest is 15 % of the size of the curve"
        adder.add_with("App::PropertyFloat", "CombScale", "Curvature comb", tip, 1.0)
        self.comb = Comb()
        vobj.RootNode.insertChild(self.comb.node, 0)
        self._draw_comb(vobj)

    def updateData(self, obj, prop):
        """Draw the comb of a new curve."""
        super().updateData(obj, prop)
        if prop == "Shape":
            self._draw_comb(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """Draw the comb or remove it; it is seen only with its curve."""
        if prop in ("ShowComb", "CombScale", "Visibility"):
            self._draw_comb(vobj)

    def _draw_comb(self, vobj):
        if self.comb is None or "CombScale" not in vobj.PropertiesList:
            return
        shown = vobj.ShowComb and vobj.Visibility and not vobj.Object.Shape.isNull()
        self.comb.show(vobj.Object.Shape.Edges if shown else [], vobj.CombScale)

    def getIcon(self):
        """Return the icon in the tree."""
        self.ICON = self.object.Proxy.ICON
        return super().getIcon()

    def make_panel(self, obj, created):
        """Return the task panel."""
        return CurvePanel(obj, created)


def attach_view(obj):
    """Give a curve its view provider if it has none, and lines that differ from those of edges."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, CurveView):
        vobj.LineColor, vobj.LineWidth = COLOUR, WIDTH
    attach_as(CurveView, obj)
