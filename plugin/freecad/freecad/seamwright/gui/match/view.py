# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a Match Surfaces: its sources are hidden while it has a shape.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document import match
from freecad.seamwright.gui.base.result_view import ResultView, attach_as
from freecad.seamwright.gui.match.panel import MatchPanel


class MatchSurfacesView(ResultView):
    """Proxy of the view provider of a Match Surfaces."""

    ICON = "seamwright-match"

    def sources(self, obj):
        """Return the objects to which the faces belong."""
        return match.source_objects(obj)

    def has_result(self, obj):
        """Return whether the faces match."""
        return bool(obj.Matched)

    def make_panel(self, obj, created):
        """Return the task panel."""
        return MatchPanel(obj, created)


def attach_view(obj):
    """Give a match its view provider if it has none."""
    attach_as(MatchSurfacesView, obj)
