# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of an Umbrella Fill: its source is hidden while there is a fill.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import fill
from freecad.seamwright.gui.base.new_faces_view import NewFacesView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.fill.panel import FillPanel
from freecad.seamwright.gui.scene.missed_fill import MissedFill
from freecad.seamwright.plain import fill_misses, fill_text


class UmbrellaFillView(NewFacesView):
    """Proxy of the view provider of an Umbrella Fill."""

    ICON = "seamwright-fill"

    def attach(self, vobj):
        """FreeCAD calls this for a new view and for a restored one."""
        super().attach(vobj)
        self.missed = MissedFill(vobj.Object)

    def show_missed(self, shown):
        """Draw the fills that were not kept, coloured by what they miss, or remove them."""
        obj = self.object
        if not shown or obj.Rejected.isNull():
            self.missed.hide()
            return
        report = fill.report_of(obj)
        lines = fill_misses.lines(report)
        most = fill_misses.largest(lines)
        coloured = [(points, fill_misses.colours(shares, most)) for points, shares in lines]
        self.missed.show(obj.Rejected, coloured, fill_misses.legend(report, most))

    def new_faces(self, obj):
        """Return (numbers of the new faces, number of the face that they replace or None)."""
        return fill_text.new_faces(fill.report_of(obj))

    def make_panel(self, obj, created):
        """Return the task panel."""
        return FillPanel(obj, created)


def attach_view(obj):
    """Give a fill its view provider if it has none."""
    attach_as(UmbrellaFillView, obj)
