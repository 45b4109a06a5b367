# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of an Umbrella Fill: its source is hidden while there is a fill.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import fill
from freecad.seamwright.gui.base.new_faces_view import NewFacesView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.fill.panel import FillPanel
from freecad.seamwright.plain import fill_text


class UmbrellaFillView(NewFacesView):
    """Proxy of the view provider of an Umbrella Fill."""

    ICON = "seamwright-fill"

    def new_faces(self, obj):
        """Return (numbers of the new faces, number of the face that they replace or None)."""
        return fill_text.new_faces(fill.report_of(obj))

    def make_panel(self, obj, created):
        """Return the task panel."""
        return FillPanel(obj, created)


def attach_view(obj):
    """Give a fill its view provider if it has none."""
    attach_as(UmbrellaFillView, obj)
