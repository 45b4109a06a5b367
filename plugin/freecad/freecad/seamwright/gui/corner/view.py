# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a Corner Fillet: its source is hidden while there is a fillet.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import corner
from freecad.seamwright.gui.base.new_faces_view import NewFacesView
from freecad.seamwright.gui.base.result_view import attach_as
from freecad.seamwright.gui.corner.panel import CornerPanel
from freecad.seamwright.plain import corner_text


class CornerFilletView(NewFacesView):
    """Proxy of the view provider of a Corner Fillet."""

    ICON = "seamwright-corner"

    def new_faces(self, obj):
        """Return (numbers of the patches and fillets, None)."""
        return corner_text.new_faces(corner.report_of(obj)), None

    def make_panel(self, obj, created):
        """Return the task panel."""
        return CornerPanel(obj, created)


def attach_view(obj):
    """Give a corner fillet its view provider if it has none."""
    attach_as(CornerFilletView, obj)
