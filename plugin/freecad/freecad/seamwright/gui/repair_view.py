# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Seam Repair looks: as its source, or with its points coloured by how far they moved.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import elements, repair, sources
from freecad.seamwright.document.move_map import move_map
from freecad.seamwright.gui.halo import Halo
from freecad.seamwright.gui.later import later
from freecad.seamwright.gui.legend import Legend
from freecad.seamwright.gui.marker import Marker
from freecad.seamwright.gui.move_colours import MoveColours
from freecad.seamwright.gui.progress import progress_dialog
from freecad.seamwright.gui.repair_panel import RepairPanel
from freecad.seamwright.gui.result_view import ResultView
from freecad.seamwright.plain import moves, palette

SEAM_WIDTH = 6.0
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
        self.legend, self.halo, self.marker, self.colours = Legend(), Halo(), Marker(), MoveColours()
        for node in (self.colours.node, self.halo.node, self.marker.node, self.legend.node):
            vobj.RootNode.insertChild(node, 0)  # before the placement of the shape: what they show stands in the model
        self._drawn = None  # the report whose moves are drawn
        later(vobj.Object, lambda obj: self._draw(obj.ViewObject))

    def sources(self, obj):
        """The object whose seams are repaired."""
        return elements.source_objects(obj)

    def has_result(self, obj):
        """Whether a repair was computed."""
        return not obj.Shape.isNull()

    def make_panel(self, obj, created):
        """The task panel."""
        return RepairPanel(obj, created)

    def updateData(self, obj, prop):
        """Follow the results."""
        had_result = self._had_result
        super().updateData(obj, prop)
        if prop == "Summary" and "Restore" not in obj.State:
            if self._had_result and not had_result:
                _look_like_source(obj)
            self._draw(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """Follow the view properties that concern the colours."""
        if prop in ("ShowMoves", "Visibility") and hasattr(self, "colours"):
            self._draw(vobj)

    def mark(self, edges, classes, worst):
        """Draw a bright band along the edges, which have the given classes; [] takes it away.

        ``worst`` is a list of (point, label) to be marked.
        """
        self.halo.show(edges, [palette.BY_KEY[key].unit_rgb for key in classes], SEAM_WIDTH)
        self.marker.show(worst)

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
        with progress_dialog("Computing moves\u2026") as progress:
            mapped = move_map(before, obj.Shape, found, progress)
        if mapped is None:
            return False
        self.colours.update(mapped, obj.Shape.Edges)
        entries = moves.legend_entries(mapped.largest_mm)
        self.legend.update("Moves of points", entries, moves.legend_footer(found, len(before.Faces)), LEGEND_TEXT_PX)
        self._drawn = obj.Report
        return True


def _look_like_source(obj):
    """Give the faces the colours of the source."""
    look, vobj = obj.Source.ViewObject, obj.ViewObject
    if not hasattr(look, "ShapeColor"):
        return
    vobj.ShapeColor = look.ShapeColor
    if len(look.DiffuseColor) == len(obj.Shape.Faces):
        vobj.DiffuseColor = look.DiffuseColor


def add_properties(vobj):
    """Add the view properties an object lacks."""
    if "ShowMoves" not in vobj.PropertiesList:
        tip = "Colour each point by how far it moved, with a legend"
        vobj.addProperty("App::PropertyBool", "ShowMoves", "Repair", tip)


def attach_view(obj):
    """Give a repair its view provider if it has none."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, SeamRepairView):
        SeamRepairView(vobj)
