# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Seam Analysis: summary, seam table with filter, tolerances, export."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.document.properties import plain
from freecad.seamwright.gui.analysis import export_dialog
from freecad.seamwright.gui.analysis.picking import EdgePicker
from freecad.seamwright.gui.analysis.table_model import SeamTableModel
from freecad.seamwright.gui.base.result_panel import OLD_RESULTS
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.dock import widen_dock
from freecad.seamwright.gui.widgets.forms import (
    buttons,
    make_box,
    make_form,
    make_text,
    show_seams_in,
)
from freecad.seamwright.gui.widgets.later import later
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.gui.widgets.steps import remove, take_back
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import kernel, palette, rows, summary

TABLE_HEIGHT = 260
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
        self.model = SeamTableModel()
        self.picker = EdgePicker(obj, self._edge_picked)
        self._look = True
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
        layout.addLayout(self._build_filter())
        layout.addWidget(self._build_table())
        layout.addWidget(self._build_tolerances())
        layout.addLayout(self._build_export())

    def _build_filter(self):
        line = QtWidgets.QHBoxLayout()
        line.addWidget(QtWidgets.QLabel("Show"))
        self.filter = QtWidgets.QComboBox()
        self.filter.addItem("All seams", None)
        for seam_class in palette.CLASSES:
            self.filter.addItem("", seam_class.key)
        self.filter.addItem("", rows.UNCERTAIN)
        self.filter.currentIndexChanged.connect(self._filter_changed)
        line.addWidget(self.filter, 1)
        worst = QtWidgets.QPushButton("Worst first")
        worst.setToolTip("Sort by class, then by how far the figures are from the tolerances")
        worst.clicked.connect(self.sort_worst_first)
        line.addWidget(worst)
        return line

    def _build_table(self):
        self.table = QtWidgets.QTableView()
        self.table.setModel(self.model)
        show_seams_in(self.table, TABLE_HEIGHT)
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.table.setSortingEnabled(True)
        self.table.selectionModel().selectionChanged.connect(self._selection_changed)
        return self.table

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
        repair.setToolTip("Repair the seams of the chosen rows; with none chosen, all defects")
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
        built = rows.build_rows(self.report)
        self.model.set_rows(built)
        for place, column in enumerate(rows.COLUMNS):
            if column.field == "curvature_change_rel":
                self.table.setColumnHidden(place, not rows.has_values(built, column.field))
        failure = analysis.error_text(self.obj)
        self.summary.setText(failure or self.obj.Summary)
        counts = summary.class_counts(self.report)
        self.filter.setItemText(0, "All seams (%d)" % sum(counts.values()))
        for place, seam_class in enumerate(palette.CLASSES, 1):
            text = "%s (%d)" % (seam_class.name, counts[seam_class.key])
            self.filter.setItemText(place, text)
            self.filter.setItemIcon(place, _swatch(seam_class.rgb))
        text = "Not certain (%d)" % summary.uncertain(self.report)
        self.filter.setItemText(self.filter.count() - 1, text)
        self.table.resizeColumnsToContents()
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

        self.computation.follow(plan, keep, self._left)

    def _left(self, why):
        """Say why a computation has no result; the object of the first computation is removed."""
        if self._created:
            self._withdraw()
            messages.say("%s; nothing was analysed." % why)
        else:
            self.summary.setText(why + OLD_RESULTS)

    def _withdraw(self):
        """Remove the object that the command created, and close the panel."""
        name, self._name, self._created = self._name, None, False
        take_back(self._doc, name)
        Gui.getDocument(self._doc.Name).resetEdit()

    def sort_worst_first(self, *_):
        """Restore the initial order of the table."""
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.model.sort(-1)

    def leave(self):
        """Clear the selection, and stop computing and observing the view."""
        self.computation.drop()
        self.picker.stop()
        Gui.Selection.clearSelection()
        if self._created:  # FreeCAD ended the editing before anything was measured
            self._doc.commitTransaction()
            later(self.obj, lambda obj: remove(obj.Document, obj.Name))

    def _filter_changed(self, place):
        self.model.set_filter(self.filter.itemData(place))
        self.table.resizeColumnsToContents()

    def _tolerances_changed(self):
        stale = self.tolerances.differs_from(self.obj)
        text = "Recompute (the results are for other values)" if stale else "Recompute"
        self.recompute_button.setText(text)

    def _selection_changed(self, *_):
        places = [index.row() for index in self.table.selectionModel().selectedRows()]
        if places:
            chosen = [self.seams[self.model.row(place).seam] for place in places]
            with self.picker.paused():
                seam_view.show(
                    self.obj,
                    self.report,
                    chosen,
                    self.obj.Shape.BoundBox.DiagonalLength,
                    self._look,
                )

    def _edge_picked(self, number):
        """Select the rows of an edge once FreeCAD has finished its own selection."""
        QtCore.QTimer.singleShot(0, lambda: self.picker.active and self.select_edge(number))

    def select_edge(self, number):
        """Select the rows of the seams that have an edge; the view stays as it is."""
        places = self.model.places_of_edge(number)
        if not places:
            self.filter.setCurrentIndex(0)
            places = self.model.places_of_edge(number)
        chosen = QtCore.QItemSelection()
        for place in places:
            index = self.model.index(place, 0)
            chosen.select(index, index)
        self._look = False
        flags = QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows
        self.table.selectionModel().select(chosen, flags)
        self._look = True
        if places:
            self.table.scrollTo(self.model.index(places[0], 0))


def _repair():
    Gui.runCommand("Seamwright_RepairSeams")  # closes the panel


def _swatch(rgb):
    pixmap = QtGui.QPixmap(16, 16)
    pixmap.fill(QtGui.QColor(*rgb))
    return QtGui.QIcon(pixmap)
