# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Seam Repair looks: as its source, or with the faces coloured by how far they moved.

The class path is written into documents: neither rename nor move it.
"""

import FreeCAD as App

from freecad.seamwright.document import repair
from freecad.seamwright.gui.halo import Halo
from freecad.seamwright.gui.legend import Legend
from freecad.seamwright.gui.marker import Marker
from freecad.seamwright.gui.qt import QtCore
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
        self.legend, self.halo, self.marker = Legend(), Halo(), Marker()
        for node in (self.halo.node, self.marker.node, self.legend.node):
            vobj.RootNode.insertChild(node, 0)  # before the placement of the shape: what they show stands in the model
        self._draw_later(vobj.Object)

    def sources(self, obj):
        """The object whose seams are repaired."""
        return repair.source_objects(obj)

    def has_result(self, obj):
        """Whether a repair was computed."""
        return not obj.Shape.isNull()

    def make_panel(self, obj, created):
        """The task panel."""
        return RepairPanel(obj, created)

    def updateData(self, obj, prop):
        """Follow the results."""
        super().updateData(obj, prop)
        if prop == "Summary" and hasattr(self, "legend") and "Restore" not in obj.State:
            self._draw(obj.ViewObject)

    def onChanged(self, vobj, prop):
        """Follow the view properties that concern the colours."""
        if prop in ("ShowMoves", "Visibility") and hasattr(self, "legend"):
            self._draw(vobj) if prop == "ShowMoves" else self._show_legend(vobj)

    def mark(self, edges, classes, worst):
        """Draw a bright band along the edges, which have the given classes; [] takes it away.

        ``worst`` is a list of (point, label) to be marked.
        """
        self.halo.show(edges, [palette.BY_KEY[key].unit_rgb for key in classes], SEAM_WIDTH)
        self.marker.show(worst)

    def _draw_later(self, obj):
        """Draw once FreeCAD has opened the document."""
        doc_name, name = obj.Document.Name, obj.Name
        QtCore.QTimer.singleShot(0, lambda: self._draw_if_there(doc_name, name))

    def _draw_if_there(self, doc_name, name):
        obj = App.getDocument(doc_name).getObject(name) if doc_name in App.listDocuments() else None
        if obj is not None:
            self._show_legend(obj.ViewObject)

    def _draw(self, vobj):
        """Colour the faces by their moves, or as those of the source."""
        obj = vobj.Object
        if obj.Shape.isNull():
            return
        if vobj.ShowMoves:
            bands = moves.face_bands(len(obj.Shape.Faces), repair.report_of(obj)["moves"])
            vobj.DiffuseColor = [(*(channel / 255 for channel in band.rgb), 0.0) for band in bands]
        else:
            _look_like(vobj, obj)
        self._show_legend(vobj)

    def _show_legend(self, vobj):
        obj = vobj.Object
        shown = bool(vobj.ShowMoves and vobj.Visibility and not obj.Shape.isNull())
        self.legend.show(shown)
        if shown:
            bands = moves.face_bands(len(obj.Shape.Faces), repair.report_of(obj)["moves"])
            self.legend.update(obj.Label, moves.legend_entries(bands), "largest move of a face", LEGEND_TEXT_PX)


def _look_like(vobj, obj):
    """Give the faces the colours of the source."""
    look = obj.Source.ViewObject if obj.Source is not None else None
    if not hasattr(look, "ShapeColor"):
        return
    vobj.ShapeColor = look.ShapeColor
    if len(look.DiffuseColor) == len(obj.Shape.Faces):
        vobj.DiffuseColor = look.DiffuseColor


def add_properties(vobj):
    """Add the view properties an object lacks."""
    if "ShowMoves" not in vobj.PropertiesList:
        tip = "Colour each face by how far it moved, with a legend"
        vobj.addProperty("App::PropertyBool", "ShowMoves", "Repair", tip)


def attach_view(obj):
    """Give a repair its view provider if it has none."""
    vobj = obj.ViewObject
    if vobj is not None and not isinstance(vobj.Proxy, SeamRepairView):
        SeamRepairView(vobj)
