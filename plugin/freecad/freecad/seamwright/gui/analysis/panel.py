# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Seam Analysis: summary, seam table with filter, tolerances, export."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.document.properties import plain
from freecad.seamwright.gui.analysis import export_dialog
from freecad.seamwright.gui.analysis.picking import EdgePicker
from freecad.seamwright.gui.analysis.seam_table import SeamTable
from freecad.seamwright.gui.base.result_panel import OLD_RESULTS
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.dock import widen_dock
from freecad.seamwright.gui.widgets.forms import buttons, make_box, make_form, make_text
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.steps import abort, remove
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import kernel

DOCK_WIDTH = 600


class AnalysisPanel:
    """Shows one Seam Analysis.

    A click on a row selects the edge of the seam, marks its worst point and zooms to it. Picking an
    edge in the 3D view selects its row. The panel measures in a thread; the object stays unchanged
    until that has ended.
    """

    def __init__(self, obj, created):
        """``created``: nothing was measured yet.

        The object is removed where the first computation is cancelled or fails.
        """
        self.obj = obj
        self._doc, self._name = obj.Document, obj.Name
        self._created = created
        self.picker = EdgePicker(obj, self._edge_picked)
        self._build()
        self.computation = Computation(self.form)
        self._read_fields()
        self.tolerances.changed.connect(self._tolerances_changed)
        self.refresh()
        self.picker.start()
        if created:
            self._measure()

    # Methods that FreeCAD calls.

    def getStandardButtons(self):
        """Return a close button."""
        return buttons("Close")

    def open(self):
        """Make the dock that holds the panel wide enough for it."""
        widen_dock(self.form, DOCK_WIDTH)

    def reject(self):
        """Stop a running computation; without one, close the panel."""
        if self.computation.stop():
            return self._name is None
        Gui.getDocument(self._doc.Name).resetEdit()
        return True

    # The window.

    def _build(self):
        self.form, layout = make_form("Seam Analysis", "seamwright-analyze")
        self.summary = make_text()
        layout.addWidget(self.summary)
        self.seam_table = SeamTable()
        self.seam_table.chosen.connect(self._show_seams)
        layout.addWidget(self.seam_table)
        layout.addWidget(self._build_tolerances())
        layout.addLayout(self._build_export())

    def _build_tolerances(self):
        self.tolerances = ToleranceForm(analysis.TOLERANCES, ("Level", analysis.LEVELS))
        box, layout = make_box("Level and tolerances", self.tolerances)
        self.recompute_button = QtWidgets.QPushButton("Recompute")
        self.recompute_button.clicked.connect(self.recompute)
        layout.addWidget(self.recompute_button)
        return box

    def _build_export(self):
        line = QtWidgets.QHBoxLayout()
        repair = QtWidgets.QPushButton("Repair\u2026")
        repair.setToolTip(
            "Repair the seams of the selected rows, or all defects if no row is selected"
        )
        repair.clicked.connect(lambda *_: QtCore.QTimer.singleShot(0, _repair))
        line.addWidget(repair)
        for kind in ("csv", "json"):
            button = QtWidgets.QPushButton("Export %s\u2026" % kind.upper())
            button.clicked.connect(
                lambda *_, kind=kind: export_dialog.ask_and_export(self.obj, (kind,))
            )
            line.addWidget(button)
        return line

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        self._shown = self._state()
        self.report, self.seams = seam_view.seams_by_number(self.obj)
        self.picker.report = self.report
        self.seam_table.show_report(self.report)
        self.summary.setText(analysis.error_text(self.obj) or self.obj.Summary)
        self._tolerances_changed()

    def recompute(self, *_):
        """Analyse with the tolerances of the fields, as one step that can be undone."""
        self._measure()

    def reload(self):
        """Show the object as it is now, after a change from outside such as an undo."""
        if self._values() != self._read:
            self._read_fields()
        if self._state() != self._shown:
            self.refresh()

    def _read_fields(self):
        self._read = self._values()
        self.tolerances.read_from(self.obj)

    def _values(self):
        return [plain(getattr(self.obj, name)) for name in self.tolerances.values()]

    def _state(self):
        return self.obj.Report, self.obj.Summary, analysis.error_text(self.obj)

    def _measure(self):
        try:
            plan = Plan(self.obj, self.tolerances.values())
        except kernel.KernelUnavailable as error:
            messages.show_error(str(error))
            return

        def keep(found, error):
            if self._created and error is not None:
                self._withdraw()
                messages.show_error(str(error))
                return
            if not self._created:
                self._doc.openTransaction("Seam tolerances")
            plan.apply(found, error)
            self._doc.commitTransaction()
            self._created = False
            self._read = self._values()
            self.refresh()

        self.computation.follow(plan, keep, self._abandoned)

    def _abandoned(self, why):
        """Say why a computation has no result; the object of the first computation is removed."""
        if self._created:
            self._withdraw()
            messages.say("%s; nothing was analysed." % why)
        else:
            self.summary.setText(why + OLD_RESULTS)

    def _withdraw(self):
        """Remove the object that the command created, and close the panel."""
        name, self._name, self._created = self._name, None, False
        abort(self._doc, name)
        Gui.getDocument(self._doc.Name).resetEdit()

    def leave(self):
        """Clear the selection, and stop computing and observing the view."""
        self.computation.drop()
        self.picker.stop()
        Gui.Selection.clearSelection()
        if self._created:  # FreeCAD ended the editing before anything was measured
            self._doc.commitTransaction()
            later(self.obj, lambda obj: remove(obj.Document, obj.Name))

    def _tolerances_changed(self):
        stale = self.tolerances.differs_from(self.obj)
        text = "Recompute (values were changed)" if stale else "Recompute"
        self.recompute_button.setText(text)

    def _show_seams(self, numbers, look):
        """Show seams in the view; ``look``: turn and zoom the view to them."""
        chosen = [self.seams[number] for number in numbers]
        size = self.obj.Shape.BoundBox.DiagonalLength
        with self.picker.paused():
            seam_view.show(self.obj, self.report, chosen, size, look)

    def _edge_picked(self, number):
        """Select the rows of an edge once FreeCAD has finished its own selection."""

        def act():
            if self.picker.active:
                self.seam_table.select_edge(number)

        QtCore.QTimer.singleShot(0, act)


def _repair():
    Gui.runCommand("Seamwright_RepairSeams")  # closes the panel
