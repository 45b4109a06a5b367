# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a curve: its curvature comb and its panel.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import preferences, sources
from freecad.seamwright.document.curves import curve, inputs, spline
from freecad.seamwright.document.properties import Adder
from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.curves.panel import CurvePanel
from freecad.seamwright.gui.curves.spline_panel import SplinePanel
from freecad.seamwright.gui.scene.comb import CURVE_LIFT, INPUT_COLOURS, Comb
from freecad.seamwright.gui.scene.halo import nearer

COLOUR, WIDTH = (0.0, 0.32, 0.62), 2.0


class CurveView(PanelView):
    """Proxy of the view provider of a curve."""

    comb = None

    #: Whether the comb of the sources is drawn too; the panel says it.
    compares = False

    #: Whether the curve is dragged, and its comb is drawn by the handles.
    drags = False

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        adder = Adder(vobj)
        adder.add_with(
            "App::PropertyBool", "ShowComb", "Curvature comb", "Draw the curvature comb", False
        )
        tip = "Length of the lines of the comb; 1: the longest is 15 % of the size of the curve"
        adder.add_with("App::PropertyFloat", "CombScale", "Curvature comb", tip, 1.0)
        tip = "Number of lines of the comb, on all edges together"
        lines = preferences.comb_lines()
        adder.add_with("App::PropertyInteger", "CombLines", "Curvature comb", tip, lines)
        self.comb, self.input_comb = Comb(), Comb(INPUT_COLOURS)
        for node in (nearer(CURVE_LIFT), self.comb.node, self.input_comb.node):
            vobj.RootNode.insertChild(node, 0)
        self._draw_comb(vobj)

    def updateData(self, obj, prop):
        """Draw the comb of a new curve."""
        super().updateData(obj, prop)
        if prop == "Shape":
            self._draw_comb(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """Draw the comb or remove it; it is seen only with its curve."""
        if prop in ("ShowComb", "CombScale", "CombLines", "Visibility"):
            self._draw_comb(vobj)

    def compare(self, compares):
        """Draw the comb of the sources too, to the same scale, or remove it."""
        self.compares = compares
        self._draw_comb(self.object.ViewObject)

    def drag(self, drags):
        """Remove the comb while the curve is dragged, and draw it again after that."""
        if drags != self.drags:
            self.drags = drags
            self._draw_comb(self.object.ViewObject)

    def _draw_comb(self, vobj):
        if self.comb is None or "CombLines" not in vobj.PropertiesList:
            return
        shown = vobj.ShowComb and vobj.Visibility and not vobj.Object.Shape.isNull()
        shown = shown and not self.drags
        edges = vobj.Object.Shape.Edges if shown else []
        given = _given_edges(vobj.Object) if shown and self.compares else []
        look = max(vobj.CombLines, 2), vobj.CombScale, edges, given
        self.comb.show(edges, *look)
        self.input_comb.show(given, *look)

    def getIcon(self):
        """Return the icon in the tree."""
        self.ICON = self.object.Proxy.ICON
        return super().getIcon()

    def make_panel(self, obj, created):
        """Return the task panel."""
        panel = SplinePanel if isinstance(obj.Proxy, spline.Spline) else CurvePanel
        return panel(obj, created)


def _given_edges(obj):
    try:
        return inputs.edges_of(inputs.shapes_of(curve.links_of(obj)))
    except sources.SourceError:
        return []


def attach_view(obj):
    """Give a curve its view provider if it has none, and lines that differ from those of edges."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, CurveView):
        vobj.LineColor, vobj.LineWidth = COLOUR, WIDTH
    attach_as(CurveView, obj)
