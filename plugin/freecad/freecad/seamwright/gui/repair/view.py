# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a Seam Repair: like its source, or with points coloured by how far they moved.

The class path is written into documents: neither rename nor move it.
"""

import FreeCAD as App

from freecad.seamwright.document import elements, repair, sources
from freecad.seamwright.document.move_map import move_map
from freecad.seamwright.gui.base.result_view import ResultView, attach_as, look_like
from freecad.seamwright.gui.repair.panel import RepairPanel
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.scene.move_colours import MoveColours
from freecad.seamwright.gui.widgets.later import find, later
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain import kernel, moves
from freecad.seamwright.plain.language import tr

LEGEND_TEXT_PX = 13


class SeamRepairView(ResultView):
    """Proxy of the view provider of a Seam Repair."""

    ICON = "seamwright-repair"

    def __init__(self, vobj):
        super().__init__(vobj)
        add_properties(vobj)

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        add_properties(vobj)
        self.legend, self.colours = Legend(vobj.Object), MoveColours()
        root = vobj.RootNode
        # The colours hide all nodes after them.
        root.insertChild(self.colours.node, root.findChild(self.halo.node) + 1)
        root.insertChild(self.legend.node, 0)
        self._drawn = None  # the report whose moves are drawn
        self._stopped = None  # the report whose moves are not drawn, since the user stopped it
        self._task = self._mapped = None  # the task that maps moves, and the report of these moves
        later(vobj.Object, lambda obj: self._draw(obj.ViewObject))

    def sources(self, obj):
        """Return the object whose seams are repaired."""
        return elements.source_objects(obj)

    def make_panel(self, obj, created):
        """Return the task panel."""
        return RepairPanel(obj, created)

    def first_result(self, obj):
        """Give the repair the look of its source."""
        look_like(obj, obj.Source)

    def updateData(self, obj, prop):
        """Update the colours when the results change."""
        super().updateData(obj, prop)
        if prop == "Summary" and "Restore" not in obj.State:
            self._draw(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """React to the view properties that concern the colours."""
        if prop in ("ShowMoves", "Visibility") and hasattr(self, "colours"):
            self._draw(vobj)

    def _draw(self, vobj):
        """Show or hide the colours of moves; unknown moves are computed in a thread."""
        wanted, report = bool(vobj.ShowMoves and vobj.Visibility), vobj.Object.Report
        shown = wanted and self._drawn == report
        self.colours.show(shown)
        self.legend.show(shown)
        if not vobj.ShowMoves:
            self._stopped = None
        working = self._task is not None and self._task.wanted and self._mapped == report
        if wanted and not shown and not working and self._stopped != report:
            self._map_moves(vobj.Object)

    def _map_moves(self, obj):
        """Compute the moves in a thread, on copies of the shapes, and then draw them.

        Does nothing where source and result cannot be compared.
        """
        try:
            before = elements.source_shape(obj)
        except sources.SourceError:
            return
        if len(before.Faces) != len(obj.Shape.Faces):
            return
        report, found, count = obj.Report, repair.report_of(obj)["moves"], len(before.Faces)
        before, after, names = before.copy(), obj.Shape.copy(), (obj.Document.Name, obj.Name)

        def done(mapped, error):
            self._task = None
            if isinstance(error, kernel.KernelUnavailable):
                self._stopped = report
                App.Console.PrintWarning(
                    tr("Seamwright: the moves of {names} are not shown: {error}\n").format(
                        names=names[1], error=error
                    )
                )
                return
            if error is not None:
                raise error
            there = find(*names)
            if there is not None and there.Report == report and mapped is not None:
                self._show_moves(there, mapped, found, count)

        self._mapped = report
        self._task = self._start(
            lambda progress: move_map(before, after, found, progress), done, report
        )

    def _start(self, run, done, report):
        """Let the panel show the progress, if one is open and has nothing else to show."""
        if self.panel is None or self.panel.computation.busy:
            return tasks.start(run, done)

        def stopped():
            self._stopped = report

        return self.panel.computation.start(
            tr("Computing moves\u2026"), run, done, stopped, locks=False
        )

    def _show_moves(self, obj, mapped, found, count):
        self.colours.update(mapped, obj.Shape.Edges)
        entries = moves.legend_entries(mapped.largest_mm)
        self.legend.update(
            tr("Moves of points"), entries, moves.legend_footer(found, count), LEGEND_TEXT_PX
        )
        self._drawn = obj.Report
        self._draw(obj.ViewObject)


def add_properties(vobj):
    """Add the view properties that an object lacks."""
    if "ShowMoves" not in vobj.PropertiesList:
        tip = "Colour each point by how far it moved, with a legend"
        vobj.addProperty("App::PropertyBool", "ShowMoves", "Repair", tip)


def attach_view(obj):
    """Give a repair its view provider if it has none."""
    attach_as(SeamRepairView, obj)
