# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a Seam Analysis: coloured edges and a legend.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import analysis
from freecad.seamwright.gui.analysis.panel import AnalysisPanel
from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.scene.halo import SEAM_LIFT, nearer
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.plain import palette, summary

LINE_WIDTH = 6.0
POINT_SIZE = 1.0
LEGEND_TEXT_PX = 13

DRAWN_ANEW = (
    "Visibility", "ShowLegend", "LegendTextSize", "Deviation", "AngularDeflection", "DisplayMode"
)  # fmt: skip


class SeamAnalysisView(PanelView):
    """Proxy of the view provider of a Seam Analysis."""

    ICON = "seamwright-analyze"

    def __init__(self, vobj):
        add_properties(vobj)
        vobj.LineWidth = LINE_WIDTH
        vobj.PointSize = POINT_SIZE
        super().__init__(vobj)

    def attach(self, vobj):
        """Build the legend; FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        add_properties(vobj)
        self.legend = Legend()
        self.line_width = vobj.LineWidth
        vobj.RootNode.insertChild(nearer(SEAM_LIFT), 0)
        vobj.RootNode.addChild(self.legend.node)
        self._refresh_later(vobj.Object)

    def make_panel(self, obj, created):
        """Return the task panel."""
        return AnalysisPanel(obj, created)

    def updateData(self, obj, prop):
        """Update the colours and the legend when the results change."""
        super().updateData(obj, prop)
        if prop in ("Shape", "Label", "Report"):
            self._refresh_later(obj)
        elif prop == "Summary":  # written last, after FreeCAD has drawn the new Shape
            self._refresh(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """React to the view properties that concern the legend or make FreeCAD redraw."""
        if prop == "LineWidth":
            self.line_width = vobj.LineWidth
        if prop in DRAWN_ANEW and hasattr(self, "legend"):
            self._refresh_later(vobj.Object)

    def _refresh_later(self, obj):
        """Refresh once FreeCAD has drawn, since redrawing the edges drops their colours."""
        later(obj, lambda found: self._refresh(found.ViewObject))

    def _refresh(self, vobj):
        report = analysis.report_of(vobj.Object)
        colours = [palette.BY_KEY[key].unit_rgb for key in summary.edge_classes(report).values()]
        if colours:
            vobj.LineColorArray = colours
        self._update_legend(vobj, report)

    def _update_legend(self, vobj, report):
        shown = bool(report["seams"]) and vobj.ShowLegend and vobj.Visibility
        self.legend.show(shown)
        if shown:
            self.legend.update(
                vobj.Object.Label,
                summary.legend_entries(report),
                summary.tolerance_text(report),
                vobj.LegendTextSize,
            )


def add_properties(vobj):
    """Add the view properties that an object lacks."""
    present = vobj.PropertiesList
    if "ShowLegend" not in present:
        vobj.addProperty("App::PropertyBool", "ShowLegend", "Legend", "Show the legend in the view")
        vobj.ShowLegend = True
    if "LegendTextSize" not in present:
        tip = "Height of the legend's letters, in pixels"
        vobj.addProperty("App::PropertyIntegerConstraint", "LegendTextSize", "Legend", tip)
        vobj.LegendTextSize = (LEGEND_TEXT_PX, 8, 60, 1)


def attach_view(obj):
    """Give an analysis its view provider if it has none; then only its legend is shown."""
    vobj = obj.ViewObject
    if vobj is None or isinstance(vobj.Proxy, SeamAnalysisView):
        return
    for other in obj.Document.Objects:
        if other != obj and analysis.is_analysis(other) and hasattr(other.ViewObject, "ShowLegend"):
            other.ViewObject.ShowLegend = False
    SeamAnalysisView(vobj)
