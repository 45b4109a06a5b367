# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Seam Repair looks: as its source, or with its points coloured by how far they moved.

The class path is written into documents: neither rename nor move it.
"""

import FreeCAD as App

from freecad.seamwright.document import elements, repair, sources
from freecad.seamwright.document.move_map import move_map
from freecad.seamwright.gui.later import later
from freecad.seamwright.gui.legend import Legend
from freecad.seamwright.gui.move_colours import MoveColours
from freecad.seamwright.gui.progress import progress_dialog
from freecad.seamwright.gui.repair_panel import RepairPanel
from freecad.seamwright.gui.result_view import ResultView, attach_as, look_like
from freecad.seamwright.plain import kernel, moves

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
        self.legend, self.colours = Legend(), MoveColours()
        root = vobj.RootNode
        root.insertChild(self.colours.node, root.findChild(self.halo.node) + 1)  # it hides what comes after it
        root.insertChild(self.legend.node, 0)
        self._drawn = None  # the report whose moves are drawn
        later(vobj.Object, lambda obj: self._draw(obj.ViewObject))

    def sources(self, obj):
        """The object whose seams are repaired."""
        return elements.source_objects(obj)

    def make_panel(self, obj, created):
        """The task panel."""
        return RepairPanel(obj, created)

    def began(self, obj):
        """The repair looks as its source does."""
        look_like(obj, obj.Source)

    def updateData(self, obj, prop):
        """Follow the results."""
        super().updateData(obj, prop)
        if prop == "Summary" and "Restore" not in obj.State:
            self._draw(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """Follow the view properties that concern the colours."""
        if prop in ("ShowMoves", "Visibility") and hasattr(self, "colours"):
            self._draw(vobj)

    def _draw(self, vobj):
        """Show the moves in colour, or no longer."""
        shown = bool(vobj.ShowMoves and vobj.Visibility) and self._map_moves(vobj.Object)
        self.colours.show(shown)
        self.legend.show(shown)

    def _map_moves(self, obj):
        """Draw the moves if they are not drawn yet; False where they cannot be, or the user cancelled."""
        if self._drawn == obj.Report:
            return True
        try:
            before = elements.source_shape(obj)
        except sources.SourceError:
            return False
        if len(before.Faces) != len(obj.Shape.Faces):
            return False
        found = repair.report_of(obj)["moves"]
        try:
            with progress_dialog("Computing moves\u2026") as progress:
                mapped = move_map(before, obj.Shape, found, progress)
        except kernel.KernelUnavailable as error:
            App.Console.PrintWarning("Seamwright: the moves of %s are not shown: %s\n" % (obj.Label, error))
            return False
        if mapped is None:
            return False
        self.colours.update(mapped, obj.Shape.Edges)
        entries = moves.legend_entries(mapped.largest_mm)
        self.legend.update("Moves of points", entries, moves.legend_footer(found, len(before.Faces)), LEGEND_TEXT_PX)
        self._drawn = obj.Report
        return True


def add_properties(vobj):
    """Add the view properties an object lacks."""
    if "ShowMoves" not in vobj.PropertiesList:
        tip = "Colour each point by how far it moved, with a legend"
        vobj.addProperty("App::PropertyBool", "ShowMoves", "Repair", tip)


def attach_view(obj):
    """Give a repair its view provider if it has none."""
    attach_as(SeamRepairView, obj)
