# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Repair Seams: which seams are to be repaired to what, and each of them before and after.

Nothing is repaired before Preview or OK is pressed.
"""

import FreeCADGui as Gui
import Part

from freecad.seamwright.document import analysis, elements, properties, repair
from freecad.seamwright.gui import icon_path, seam_view
from freecad.seamwright.gui.element_list import ElementList
from freecad.seamwright.gui.qt import QtGui, QtWidgets
from freecad.seamwright.gui.result_panel import ResultPanel
from freecad.seamwright.gui.tolerance_form import NumberField, ToleranceForm
from freecad.seamwright.plain import repair_text

TABLE_HEIGHT = 190

PREVIEW, PREVIEW_AGAIN = "Preview", "Preview anew"

CHOSEN = "The seams at these edges:"
ALL_DEFECTS = "All defects; to choose, select rows or edges and add them:"

#: Colours of the last column's text, by the state of a row.
INKS = {repair_text.REPAIRED: (0, 120, 88), repair_text.LEFT: (190, 80, 0)}


class RepairPanel(ResultPanel):
    """Shows and changes one Seam Repair; ``created``: Cancel removes it."""

    DOCK_WIDTH = 600

    def __init__(self, obj, created):
        changeable = ["Target", "MaxMove", *(name for name, *_ in repair.ELEMENTS + repair.TOLERANCES)]
        super().__init__(obj, created, "Edit seam repair", changeable)
        self._rows, self._report, self._due = [], repair.empty_report(obj), False
        self._lines = [each.Name for each in self._analyses() if each.ViewObject.Visibility]
        self._build()
        self._read()
        self._connect()
        if self.has_result():
            self.refresh()
        else:
            self._foresee()

    def sources(self):
        """The object whose seams are repaired."""
        return elements.source_objects(self.obj)

    def _analyses(self):
        """Those of the source: their coloured lines tell how it was before."""
        every = (each for each in self._doc.Objects if analysis.is_analysis(each))
        return [each for each in every if self.obj.Source in each.Analysed]

    def replaced(self):
        """The source, and those of its analyses that were seen when the panel was opened."""
        return self.sources() + [each for each in self._analyses() if each.Name in self._lines]

    def has_result(self):
        """Whether a repair was computed."""
        return not self.obj.Shape.isNull()

    def is_due(self):
        """Whether a field was changed after the last computation."""
        return self._due

    def release(self):
        """Drop the selection, and let the faces look as those of the source."""
        Gui.Selection.clearSelection()
        self.obj.ViewObject.Proxy.mark([], [], [])
        self.obj.ViewObject.ShowMoves = False

    # The window.

    def _build(self):
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle("Repair Seams")
        self.form.setWindowIcon(QtGui.QIcon(icon_path("seamwright-repair")))
        layout = QtWidgets.QVBoxLayout(self.form)
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        layout.addWidget(self.summary)
        layout.addWidget(self._build_table())
        self.note = QtWidgets.QLabel()
        self.note.setWordWrap(True)
        self.note.hide()
        layout.addWidget(self.note)
        layout.addLayout(self._build_show())
        for box in (self._build_seams(), self._build_limits()):
            layout.addWidget(box)

    def _build_table(self):
        self.table = QtWidgets.QTableWidget(0, len(repair_text.COLUMNS))
        self.table.setHorizontalHeaderLabels([heading for heading, _ in repair_text.COLUMNS])
        for place, (_, tip) in enumerate(repair_text.COLUMNS):
            self.table.horizontalHeaderItem(place).setToolTip(tip)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setAlternatingRowColors(True)
        self.table.setWordWrap(False)
        self.table.setMinimumHeight(TABLE_HEIGHT)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(self.table.fontMetrics().height() + 6)
        self.table.horizontalHeader().setHighlightSections(False)
        self._fit_columns()
        return self.table

    def _fit_columns(self):
        """Columns as wide as what they say; the last one to the end of the table where there is room."""
        header, last = self.table.horizontalHeader(), len(repair_text.COLUMNS) - 1
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        if header.length() <= self.table.viewport().width():
            header.setSectionResizeMode(last, QtWidgets.QHeaderView.Stretch)

    def _build_show(self):
        line = QtWidgets.QHBoxLayout()
        line.addWidget(QtWidgets.QLabel("Show"))
        self.before, self.after = QtWidgets.QRadioButton("Before"), QtWidgets.QRadioButton("After")
        self.moves = QtWidgets.QCheckBox("Moves in colour")
        self.moves.setToolTip("Colour each point by how far it moved")
        self.moves.setChecked(True)
        for widget in (self.before, self.after, self.moves):
            line.addWidget(widget)
        line.addStretch(1)
        self.preview_button = QtWidgets.QPushButton(PREVIEW)
        self.preview_button.setToolTip("Repair the seams as the fields say; nothing is kept before OK is pressed")
        line.addWidget(self.preview_button)
        return line

    def _build_seams(self):
        box = QtWidgets.QGroupBox("Seams")
        layout = QtWidgets.QFormLayout(box)
        self.lists = {}
        for name, kind, tip in repair.ELEMENTS:
            self.lists[name] = ElementList(lambda kind=kind: self._picked(kind), self._select, tip)
        self.which = QtWidgets.QLabel()
        layout.addRow("Repair", self.which)
        layout.addRow("", self.lists["Edges"])
        layout.addRow("Keep faces", self.lists["FixedFaces"])
        return box

    def _build_limits(self):
        box = QtWidgets.QGroupBox("Target and limits")
        layout = QtWidgets.QVBoxLayout(box)
        self.tolerances = ToleranceForm(repair.TOLERANCES, ("Target", repair.TARGETS))
        self.max_move = NumberField(" mm", 1e6)
        self.max_move.setSpecialValueText("no limit")
        self.max_move.setToolTip("No pole of a surface may move further")
        self.tolerances.layout().insertRow(1, "Largest move", self.max_move)
        layout.addWidget(self.tolerances)
        return box

    def _connect(self):
        for each in self.lists.values():
            each.changed.connect(self._changed)
        self.max_move.valueChanged.connect(self._changed)
        self.tolerances.changed.connect(self._changed)
        self.preview_button.clicked.connect(lambda *_: self.preview())
        self.table.itemSelectionChanged.connect(self._selection_changed)
        for button in (self.after, self.moves):
            button.toggled.connect(lambda *_: self.show(self.after.isChecked()))

    def _read(self):
        for name, each in self.lists.items():
            each.set_names(elements.names(self.obj, name))
        self.max_move.setValue(properties.number(self.obj, "MaxMove"))
        self.tolerances.read_from(self.obj)
        self.after.setChecked(True)
        self._name_seams()

    # What it does.

    def preview(self):
        """Take over the fields and repair anew."""
        for name, each in self.lists.items():
            if each.names() != elements.names(self.obj, name):
                elements.set_names(self.obj, name, each.names())
        if properties.number(self.obj, "MaxMove") != self.max_move.value():
            self.obj.MaxMove = self.max_move.value()
        self.tolerances.write_to(self.obj)
        self.obj.touch()
        self._doc.recompute()
        self._set_due(False)
        (self.after if self.has_result() else self.before).setChecked(True)
        self.refresh()

    def refresh(self):
        """Show the results as they are stored now."""
        self._fill(repair.report_of(self.obj), repair.error_text(self.obj) or self.obj.Summary)
        self.show(self.after.isChecked())

    def show(self, after):
        """Show the result, with its moves in colour where they are wanted, or the source."""
        after = after and self.has_result()
        self.obj.ViewObject.ShowMoves = after and self.moves.isChecked() and not self._ended
        self.obj.ViewObject.Visibility = after
        for each in self.replaced():
            each.ViewObject.Visibility = not after
        if not self._ended:
            self._selection_changed()

    def _foresee(self):
        """Before the first preview: the seams that would be treated."""
        self._fill(*repair.foresee(self.obj))
        self.before.setChecked(True)
        self.show(False)

    def _fill(self, report, text):
        self._report = report
        self._rows = repair_text.build_rows(report)
        self.summary.setText(text)
        self.table.clearSelection()
        self.table.setRowCount(len(self._rows))
        for line, row in enumerate(self._rows):
            for column, cell in enumerate(row.cells):
                self.table.setItem(line, column, _item(cell, row, column))
        self.table.setColumnHidden(repair_text.CURVATURE_COLUMN, report["target"] != "G2")
        self._fit_columns()
        for widget in (self.after, self.moves):
            widget.setEnabled(self.has_result())

    def _changed(self, *_):
        self._set_due(True)
        self._name_seams()

    def _set_due(self, due):
        self._due = due
        self.preview_button.setText(PREVIEW_AGAIN if due and self.has_result() else PREVIEW)

    def _name_seams(self):
        self.which.setText(CHOSEN if self.lists["Edges"].names() else ALL_DEFECTS)

    def _picked(self, kind):
        """The elements of a kind that are selected, on the source or on the result: they have the same names."""
        own = (self.obj, *self.sources())
        chosen = [each for each in Gui.Selection.getSelectionEx() if each.Object in own]
        return [name for each in chosen for name in each.SubElementNames if name.startswith(kind)]

    def _shown_object(self):
        return self.obj if self.after.isChecked() and self.has_result() else self.sources()[0]

    def _select(self, name):
        if self.sources():
            Gui.Selection.clearSelection()
            seam_view.select(self._doc, self._shown_object().Name, name)

    def _selection_changed(self, *_):
        """Mark the seams of the chosen rows, as they are in what is shown, and zoom to them."""
        places = sorted({index.row() for index in self.table.selectionModel().selectedRows()})
        self._write_note([self._rows[place] for place in places])
        if not places or not self.sources():
            self.obj.ViewObject.Proxy.mark([], [], [])
            return
        shown = self._shown_object()
        which = "after" if shown == self.obj and repair_text.is_done(self._report) else "before"
        by_number = {seam["before"]["id"]: seam[which] for seam in self._report["seams"]}
        chosen = [by_number[self._rows[place].seam] for place in places]
        size = Part.getShape(shown).BoundBox.DiagonalLength
        seam_view.show(self.obj, repair_text.located(self._report, shown.Name), chosen, size)


    def _write_note(self, rows):
        """Why the seams of the chosen rows were not repaired, in full: the column is too narrow for it."""
        reasons = ["%s: %s" % (row.cells[0], row.cells[-1]) for row in rows if row.state == repair_text.LEFT]
        self.note.setText("\n".join(reasons))
        self.note.setVisible(bool(reasons))


def _item(text, row, column):
    item = QtWidgets.QTableWidgetItem(text)
    item.setToolTip(row.detail)
    if column == len(row.cells) - 1 and row.state in INKS:
        item.setForeground(QtGui.QBrush(QtGui.QColor(*INKS[row.state])))
    return item
