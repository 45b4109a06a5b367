# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option panel of an object whose shape is its source with new faces.

Its result is a table of the new seams.
"""

import FreeCADGui as Gui

from freecad.seamwright.gui.base.replacing_panel import ReplacingPanel
from freecad.seamwright.gui.base.row_table import RowTable
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets.forms import make_box, make_summary, make_text
from freecad.seamwright.plain import new_seams, rows
from freecad.seamwright.plain.language import tr

TABLE_HEIGHT = 190

SOURCE = "Source"


class NewSeamsPanel(ReplacingPanel):
    """Shows and changes one object; ``created``: Cancel removes it.

    A subclass lists the parts of its source that it changes, and returns the seams of its report.
    """

    DOCK_WIDTH = 600

    # Methods that a subclass defines.

    def seams(self):
        """Return (seams as in new_seams, tolerances, target) as they are stored now."""
        raise NotImplementedError

    def list_parts(self):
        """List the parts of the source that can be changed."""
        raise NotImplementedError

    def suit_parts(self):
        """Give the fields values that suit other parts than before."""

    def waiting_text(self):
        """Return what will be computed, or why nothing can be."""
        raise NotImplementedError

    def note(self, chosen):
        """Return the text below the table about the chosen rows."""
        return ""

    def elements_of(self, chosen):
        """Return {property: links} for elements of one object."""
        raise NotImplementedError

    # What the base asks for.

    def release(self):
        """Stop computing, clear the selection, and draw the new faces like the others."""
        super().release()
        Gui.Selection.clearSelection()
        self.obj.ViewObject.Proxy.paint(tinted=False)

    # The window.

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box, layout = make_box(tr("Result"))
        self.summary, self.remark = make_summary(), make_text()
        self.table = RowTable(new_seams.COLUMNS, TABLE_HEIGHT)
        self.remark.hide()
        for widget in (self.summary, self.table, self.remark):
            layout.addWidget(widget)
        layout.addLayout(self.build_show())
        return box

    def _connect(self):
        super()._connect()
        self.table.itemSelectionChanged.connect(self.mark_chosen)

    def read_fields(self):
        """Show the values of the object."""
        super().read_fields()
        self.list_parts()
        self.steps.start()

    # Actions.

    def take(self, name, chosen):
        """Let the object have another source, with these elements of it; compute."""
        self._links = {SOURCE: [(chosen[0][0], "")], **self.elements_of(chosen)}
        self.list_parts()
        self.suit_parts()
        super().take(SOURCE, self._links[SOURCE])

    def link_names(self):
        """Return the names of the properties with sources that the panel changes."""
        return [SOURCE, *self.elements_of([])]

    def show_field_values(self, values):
        """Show the values of fields, for the parts of the source that is chosen."""
        self.list_parts()
        super().show_field_values(values)

    def computed(self):
        """Show new results, and the parts of the source as they are found now.

        Fields that the user changed meanwhile stay.
        """
        self._links = {}
        if not self.is_due():
            self.list_parts()
        super().computed()

    def refresh(self):
        """Show the results as they are stored now, with tinted new faces."""
        self.table.show_rows(new_seams.build_rows(*self.seams()) if self.obj.Report else [])
        super().refresh()
        self.obj.ViewObject.Proxy.paint(tinted=True)
        if not self.obj.Outcome:
            self.say(self.waiting_text())

    def show(self, after):
        """Show the result or its source."""
        super().show(after)
        if not self._ended:
            self.mark_chosen()

    def select_in_source(self, names):
        """Select edges of the source, if the source is shown."""
        if not self.obj.ViewObject.Visibility:
            self._select([(self.links(SOURCE)[0][0], name) for name in names])

    def mark_chosen(self):
        """Mark the seams of the chosen rows if the result is shown, and zoom to them.

        New faces that were not kept have no seams in it.
        """
        chosen = self.table.chosen()
        remark = self.note(chosen)
        self.remark.setText(remark)
        self.remark.setVisible(bool(remark))
        wanted = []
        if chosen and self.obj.ViewObject.Visibility:
            seams, tolerance, _ = self.seams()
            wanted = [seams[row.index] for row in chosen if seams[row.index]["edges"]]
        if not wanted:
            self.obj.ViewObject.Proxy.mark([], [], [])
            return
        report = rows.located(wanted, tolerance, self.obj.Name)
        seam_view.show(self.obj, report, wanted, self.obj.Shape.BoundBox.DiagonalLength)
