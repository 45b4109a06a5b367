# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object that is computed when the user presses Preview or OK.

It has a summary, a table of seams, and a choice to show the model before or after.
"""

import Part

from freecad.seamwright.document.properties import differing
from freecad.seamwright.gui.base.panel_steps import PanelSteps
from freecad.seamwright.gui.base.result_panel import ResultPanel
from freecad.seamwright.gui.base.row_table import RowTable
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.forms import (
    make_form, make_show_line, make_summary, make_text, offer_after
)  # fmt: skip
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import mark, tr

TABLE_HEIGHT = 190

#: Changes that follow each other faster are one step: the digits of a number.
STEP_AFTER_MS = 500

PREVIEW, PREVIEW_AGAIN = mark("Preview"), mark("Update preview")


class PreviewPanel(ResultPanel):
    """Shows and changes one object; a subclass defines its fields and the rows of the RowTable."""

    DOCK_WIDTH = 600
    TITLE = ICON = PREVIEW_TIP = ""
    COLUMNS = ()  # heading, tool tip

    def __init__(self, obj, created, title, changeable):
        super().__init__(obj, created, title, changeable)
        self.steps, self._step_timer = PanelSteps(self), QtCore.QTimer()
        self._step_timer.setSingleShot(True)
        self._step_timer.setInterval(STEP_AFTER_MS)
        self._step_timer.timeout.connect(self.steps.note)
        self._build()
        self.computation = Computation(self.form)
        self.read_fields()
        self.connect_fields()
        self._connect()
        if self.has_result():
            self.refresh()
        else:
            self.begin()

    # Methods that a subclass defines.

    def build_boxes(self):
        """Return the widgets below the table."""
        raise NotImplementedError

    def connect_fields(self):
        """Call ``changed`` when a field changes."""
        raise NotImplementedError

    def shown(self):
        """Return the values of the fields as ``show_values`` takes them."""
        raise NotImplementedError

    def show_values(self, values):
        """Show the values of fields."""
        raise NotImplementedError

    def begin(self):
        """Show what is known before anything was computed."""
        raise NotImplementedError

    def stored(self):
        """Return (rows, text) of the results as they are stored now."""
        raise NotImplementedError

    def marked(self, rows, shown):
        """Return (report, seams) of rows for ``seam_view.show``, as they are in the shown object.

        Returns no seams where the shown object does not have them.
        """
        raise NotImplementedError

    def note(self, rows):
        """Return the text below the table about the chosen rows."""
        return ""

    # What the base asks for.

    def release(self):
        """Remember no more steps."""
        self._step_timer.stop()

    def held_handles(self):
        """Return no handles: the panel has none."""
        return {}

    # The window.

    def _build(self):
        self.form, layout = make_form(tr(self.TITLE), self.ICON)
        self.summary, self.remark = make_summary(), make_text()
        self.table = RowTable(self.COLUMNS, TABLE_HEIGHT)
        self.remark.hide()
        for widget in (self.summary, self.table, self.remark):
            layout.addWidget(widget)
        layout.addLayout(self._build_show())
        for box in self.build_boxes():
            layout.addWidget(box)

    def _build_show(self):
        self.show_line, self.before, self.after = make_show_line()
        self.preview_button = QtWidgets.QPushButton(tr(PREVIEW))
        self.preview_button.setToolTip(
            tr("{preview_tip}; nothing is kept until OK is pressed").format(
                preview_tip=tr(self.PREVIEW_TIP)
            )
        )
        self.show_line.add(self.preview_button)
        return self.show_line

    def _connect(self):
        self.preview_button.clicked.connect(lambda *_: self.preview())
        self.table.itemSelectionChanged.connect(self._selection_changed)
        self.after.toggled.connect(lambda *_: self.show(self.after.isChecked()))

    # Actions.

    def has_result(self):
        """Return whether the object was computed."""
        return not self.obj.Shape.isNull()

    def computed(self):
        """Show the results, or the source where there are none."""
        (self.after if self.has_result() else self.before).setChecked(True)
        self.refresh()

    def say(self, text):
        """Show this text above the table."""
        self.summary.setText(text)

    def refresh(self):
        """Show the results as they are stored now."""
        self.fill(*self.stored())
        self.show(self.after.isChecked())
        self._name_preview()

    def show(self, after):
        """Show the result or the source."""
        after = after and self.has_result()
        self.obj.ViewObject.Visibility = after
        for each in self.replaced():
            each.ViewObject.Visibility = not after
        if not self._ended:
            self._selection_changed()

    def fill(self, built, text):
        """Show these rows, and the text above them."""
        self.summary.setText(text)
        self.table.show_rows(built)
        offer_after(self.before, self.after, self.has_result())

    def show_before(self):
        """Show the source, since there is no result yet."""
        self.before.setChecked(True)
        self.show(False)

    def changed(self, *_):
        """A field differs from what was computed."""
        super().changed()
        self._step_timer.start()
        self._name_preview()

    def step(self, back):
        """Take the last change of a field back, or do it again; nothing is computed."""
        found = None if self.computation.busy else self.steps.step(back)
        if found is not None:
            self.show_values(found)
            if not differing(self.obj, self.wanted()):
                self._computed_edits = self._edits
            self._name_preview()

    def _name_preview(self):
        self.preview_button.setText(
            tr(PREVIEW_AGAIN if self.is_due() and self.has_result() else PREVIEW)
        )

    def shown_object(self):
        """Return the visible object: the result or its source."""
        return self.obj if self.after.isChecked() and self.has_result() else self.sources()[0]

    def _selection_changed(self):
        """Mark the seams of the chosen rows as they are in the shown object, and zoom to them."""
        rows = self.table.chosen()
        remark = self.note(rows)
        self.remark.setText(remark)
        self.remark.setVisible(bool(remark))
        shown = self.shown_object() if rows and self.sources() else None
        report, seams = self.marked(rows, shown) if shown is not None else ({}, [])
        if not seams:
            self.obj.ViewObject.Proxy.mark([], [], [])
            return
        size = Part.getShape(shown).BoundBox.DiagonalLength
        seam_view.show(self.obj, report, seams, size)
