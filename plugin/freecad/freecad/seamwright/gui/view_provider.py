# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Seam Analysis looks: coloured edges and a legend.

The class path is written into documents: neither rename nor move it.
"""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.legend import Legend
from freecad.seamwright.gui.task_panel import TaskPanel
from freecad.seamwright.plain import palette, summary

LINE_WIDTH = 6.0
POINT_SIZE = 1.0
LEGEND_TEXT_PX = 15

#: Chord error of drawn curves, in percent of the model's size, and their angle in degrees:
#: finer than FreeCAD's default, so that the edges do not dip under the faces.
DEVIATION, ANGULAR_DEFLECTION = 0.05, 5.0


class SeamAnalysisView:
    """Proxy of the view provider of a Seam Analysis."""

    def __init__(self, vobj):
        add_properties(vobj)
        vobj.LineWidth = LINE_WIDTH
        vobj.PointSize = POINT_SIZE
        vobj.Deviation = DEVIATION
        vobj.AngularDeflection = ANGULAR_DEFLECTION
        vobj.Proxy = self

    def attach(self, vobj):
        """Build the legend; FreeCAD calls this for a new view and for a restored one."""
        add_properties(vobj)
        self.legend = Legend()
        self.panel = None
        vobj.RootNode.addChild(self.legend.node)
        self._refresh(vobj)

    def updateData(self, obj, prop):
        """Follow the results: colours with the Shape, panel with the Summary, written last."""
        if prop == "Shape":
            self._refresh(obj.ViewObject)
        elif prop == "Summary" and self.panel is not None:
            self.panel.refresh()

    def onChanged(self, vobj, prop):
        """Follow the view properties that concern the legend."""
        if prop in ("Visibility", "ShowLegend", "LegendTextSize") and hasattr(self, "legend"):
            self._update_legend(vobj, analysis.report_of(vobj.Object))

    def getIcon(self):
        """Icon in the tree."""
        return icon_path("seamwright-analyze")

    def doubleClicked(self, vobj):
        """Open the task panel."""
        return vobj.Document.setEdit(vobj.Object.Name)

    def setEdit(self, vobj, mode=0):
        """Show the task panel."""
        self.panel = TaskPanel(vobj.Object)
        Gui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, vobj, mode=0):
        """Close the task panel."""
        if self.panel is not None:
            self.panel.leave()
        self.panel = None
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

    def _refresh(self, vobj):
        report = analysis.report_of(vobj.Object)
        colours = [
            palette.BY_KEY[key].unit_rgb for key in summary.edge_classes(report).values()
        ]
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
    """Add the view properties an object lacks."""
    present = vobj.PropertiesList
    if "ShowLegend" not in present:
        vobj.addProperty("App::PropertyBool", "ShowLegend", "Legend", "Show the legend in the view")
        vobj.ShowLegend = True
    if "LegendTextSize" not in present:
        tip = "Height of the legend's letters, in pixels"
        vobj.addProperty("App::PropertyIntegerConstraint", "LegendTextSize", "Legend", tip)
        vobj.LegendTextSize = (LEGEND_TEXT_PX, 8, 60, 1)


def attach_view(obj):
    """Give an analysis its view provider if it has none; only its legend is shown from now on."""
    vobj = obj.ViewObject
    if vobj is None or isinstance(vobj.Proxy, SeamAnalysisView):
        return
    for other in obj.Document.Objects:
        if other != obj and analysis.is_analysis(other) and hasattr(other.ViewObject, "ShowLegend"):
            other.ViewObject.ShowLegend = False
    SeamAnalysisView(vobj)
