# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object whose shape is its source with new faces: a table of their seams."""

import FreeCADGui as Gui

from freecad.seamwright.document import elements
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.preview_panel import PreviewPanel
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.plain import new_seams, rows


class NewSeamsPanel(PreviewPanel):
    """Shows and changes one object; a subclass returns the seams of its report."""

    COLUMNS = new_seams.COLUMNS

    def seams(self):
        """Return (seams as in new_seams, tolerances, target) as they are stored now."""
        raise NotImplementedError

    def sources(self):
        """Return the object to which the new faces belong."""
        return elements.source_objects(self.obj)

    def release(self):
        """Clear the selection, and draw the new faces like the others."""
        Gui.Selection.clearSelection()
        self.obj.ViewObject.Proxy.paint(tinted=False)

    def refresh(self):
        """Show the results as they are stored now, with tinted new faces."""
        super().refresh()
        self.obj.ViewObject.Proxy.paint(tinted=True)

    def stored(self):
        """Return (rows, text) of the results as they are stored now."""
        return new_seams.build_rows(*self.seams()), error_text(self.obj) or self.obj.Summary

    def marked(self, chosen, shown):
        """Return (report, seams) of the chosen rows.

        There are none where the source is shown, or where the new faces were not kept.
        """
        seams, tolerance, _ = self.seams()
        wanted = [seams[row.index] for row in chosen if seams[row.index]["edges"]]
        if shown != self.obj:
            return {}, []
        return rows.located(wanted, tolerance, self.obj.Name), wanted

    def select_in_source(self, names):
        """Select edges of the source, if the source is shown."""
        if self.sources() and self.shown_object() != self.obj:
            Gui.Selection.clearSelection()
            for name in names:
                seam_view.select(self._doc, self.obj.Source.Name, name)
