# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a Seam Analysis: coloured lines, labels and a legend.

What is shown are properties of the view, so it stays when the panel closes. The class path is
written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import analysis
from freecad.seamwright.document.properties import Adder
from freecad.seamwright.gui.analysis.line_picks import LinePicks
from freecad.seamwright.gui.analysis.panel import AnalysisPanel
from freecad.seamwright.gui.base.panel_view import PanelView
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.scene.halo import SEAM_LIFT, nearer
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.scene.marker import Marker
from freecad.seamwright.gui.scene.seam_lines import SeamLines
from freecad.seamwright.gui.widgets.later import find, later
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain import filters, labels, rows, summary
from freecad.seamwright.plain.language import inside, tr

LINE_WIDTH = 6.0
POINT_SIZE = 1.0
LEGEND_TEXT_PX = 13

#: The display mode in which the view draws the lines itself.
SEAMS = "Seams"

#: A report of more characters is read in a thread, and drawn only after the recompute that wrote
#: it: else the window would stand still.
AT_ONCE = 1_000_000

DRAWN_ANEW = (
    "Visibility", "ShowLegend", "LegendTextSize", "ColourBy", "Show", "WorstLabels"
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
        """Build the scene; FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        add_properties(vobj)
        self.legend = Legend(vobj.Object)
        self.lines, self.labels = SeamLines(), Marker()
        self._picks = LinePicks(vobj.Object, self.lines)
        self._drawn = self._reading = None
        self.line_width = vobj.LineWidth
        vobj.addDisplayMode(self.lines.node, SEAMS)
        for node in (self.labels.node, nearer(SEAM_LIFT)):
            vobj.RootNode.insertChild(node, 0)
        vobj.RootNode.addChild(self.legend.node)
        later(vobj.Object, self._opened)

    def getDisplayModes(self, vobj):
        """Return the names of the display modes besides those of FreeCAD."""
        return [SEAMS]

    def getDefaultDisplayMode(self):
        """Return the name of the mode in which the view draws the lines itself."""
        return SEAMS

    def setDisplayMode(self, mode):
        """Return the mode of the scene for a display mode."""
        return mode

    def make_panel(self, obj, created):
        """Return the task panel."""
        return AnalysisPanel(obj, created)

    def updateData(self, obj, prop):
        """Update the colours and the legend when the results change."""
        super().updateData(obj, prop)
        if prop in ("Label", "Report"):
            self.refresh_later(obj)
        elif prop == "Summary" and "Restore" not in obj.State and not _is_long(obj):
            self.refresh(obj.ViewObject)  # the Summary is written last

    def onChanged(self, vobj, prop):
        """React to the view properties that say what is drawn."""
        if prop == "LineWidth":
            self.line_width = vobj.LineWidth
            if hasattr(self, "lines"):
                self.lines.set_width(vobj.LineWidth)
        if prop in DRAWN_ANEW and hasattr(self, "legend"):
            self.refresh_later(vobj.Object)
            if self.panel is not None:
                later(vobj.Object, lambda obj: self.panel is not None and self.panel.look_changed())

    def _opened(self, obj):
        """Draw the lines of an object that was restored; earlier versions let FreeCAD draw them."""
        if obj.ViewObject.DisplayMode != SEAMS:
            obj.ViewObject.DisplayMode = SEAMS
        self.refresh(obj.ViewObject)

    def refresh_later(self, obj):
        """Draw once FreeCAD has changed all properties, such as those of an undo."""
        later(obj, lambda found: self.refresh(found.ViewObject))

    def refresh(self, vobj):
        """Draw the stored results; those of a long report once they have been read in a thread."""
        if not vobj.Visibility:
            self.legend.show(False)
            self.labels.show([])
            return
        obj = vobj.Object
        results = self.results(obj)
        if results is None:
            return
        self._draw_lines(vobj, results)
        self._picks.update(obj)
        self._draw_labels(vobj, results)
        self._update_legend(vobj, results.report)

    def results(self, obj):
        """Return the SeamResults of the object; None while a long report is read in a thread.

        Then it is drawn and given to the panel.
        """
        if analysis.known_results(obj) is None and _is_long(obj):
            self._read(obj)
            return None
        return analysis.results_of(obj)

    def _read(self, obj):
        """Read the stored report in a thread, and then show it in the view and in the panel."""
        text, names = obj.Report, (obj.Document.Name, obj.Name)
        if self._reading == text:
            return

        def done(results, error):
            self._reading = None
            if error is not None:
                raise error
            there = find(*names)
            if there is None:
                return
            if there.Report != text:
                self.refresh(there.ViewObject)
                return
            analysis.keep_results(there, results)
            self.refresh(there.ViewObject)
            if self.panel is not None:
                self.panel.refresh()

        self._reading = text
        read = analysis.reader(obj)
        tasks.start(lambda progress: read(), done)

    def _draw_lines(self, vobj, results):
        colours = [entry.unit_rgb for entry in summary.COLOURS[vobj.ColourBy]]
        wanted = (results, vobj.ColourBy, vobj.Show, colours)
        if self._drawn is not None and all(a is b or a == b for a, b in zip(wanted, self._drawn)):
            return
        if self._drawn is None or self._drawn[0] is not results:
            self.lines.set_lines(*results.drawing)
        self._drawn = wanted
        entries = summary.COLOURS[vobj.ColourBy]
        places = {entry.key: place for place, entry in enumerate(entries)}
        keys = summary.edge_keys(results.report, vobj.ColourBy)
        shown = rows.shown_edges(results.report, filters.of(vobj.Show))
        places = [places[key] for key in keys.values()]
        self.lines.paint(colours, places, [number not in shown for number in keys])
        self.lines.set_width(vobj.LineWidth)
        own = [colours[place] for place in places]  # for a FreeCAD without this workbench
        if places and _bytes(own) != _bytes(vobj.LineColorArray):
            vobj.LineColorArray = own  # the document counts as changed

    def _draw_labels(self, vobj, results):
        count = vobj.WorstLabels
        shown = rows.filter_rows(results.rows, filters.of(vobj.Show)) if count else []
        seams = [results.seams[row.seam] for row in shown[:count]]
        marks = seam_view.worst_marks(results.report, seams)
        self.labels.show(marks, labels.NEAR * results.size_mm)

    def _update_legend(self, vobj, report):
        shown = bool(report["seams"]) and vobj.ShowLegend
        self.legend.show(shown)
        if not shown:
            return
        footer = summary.tolerance_text(report)
        if filters.of(vobj.Show) is not None:
            footer += tr("\nShown: {show}").format(show=inside(vobj.Show))
        self.legend.update(
            vobj.Object.Label,
            summary.legend_entries(report, vobj.ColourBy),
            footer,
            vobj.LegendTextSize,
        )


def _bytes(colours):
    """Return colours as documents store them."""
    return [tuple(round(255 * part) for part in colour[:3]) for colour in colours]


def _is_long(obj):
    return len(obj.Report) > AT_ONCE


def add_properties(vobj):
    """Add the view properties that an object lacks."""
    adder = Adder(vobj)
    if adder.add("App::PropertyBool", "ShowLegend", "Legend", "Show the legend in the view"):
        vobj.ShowLegend = True
    tip = "Height of the legend's letters, in pixels"
    if adder.add("App::PropertyIntegerConstraint", "LegendTextSize", "Legend", tip):
        vobj.LegendTextSize = (LEGEND_TEXT_PX, 8, 60, 1)
    tip = "What the colours of the seams show: their class or their level of continuity"
    adder.add_choice("ColourBy", "Seams", tip, list(summary.COLOURS), summary.CLASS)
    tip = "The seams that are shown in the view and in the table"
    adder.add_choice("Show", "Seams", tip, filters.NAMES, filters.NAMES[0])
    tip = "At how many of the worst seams that are shown the largest figure is written"
    if adder.add("App::PropertyIntegerConstraint", "WorstLabels", "Seams", tip):
        vobj.WorstLabels = (0, 0, seam_view.LABELLED_MOST, 1)


def attach_view(obj):
    """Give an analysis its view provider if it has none; then only its legend is shown."""
    vobj = obj.ViewObject
    if vobj is None or isinstance(vobj.Proxy, SeamAnalysisView):
        return
    for other in obj.Document.Objects:
        if other != obj and analysis.is_analysis(other) and hasattr(other.ViewObject, "ShowLegend"):
            other.ViewObject.ShowLegend = False
    SeamAnalysisView(vobj)
    vobj.DisplayMode = SEAMS
