# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of an analysis: a line for each seam, with a filter by class and a default order."""

from freecad.seamwright.gui.analysis.table_model import SeamTableModel
from freecad.seamwright.gui.widgets.forms import show_seams_in
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain import palette, rows, summary

HEIGHT = 260


class SeamTable(QtWidgets.QWidget):
    """The lines of one report.

    When lines are selected, ``chosen`` is emitted with the numbers of their seams, and with whether
    the view has to turn to them. It stays where the user picked an edge in the view.
    """

    chosen = QtCore.Signal(list, bool)

    def __init__(self):
        super().__init__()
        self.model = SeamTableModel()
        self._look = True
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(self._build_filter())
        layout.addWidget(self._build_table())

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
        worst.setToolTip("Sort by class, then by how much the figures exceed the tolerances")
        worst.clicked.connect(self.sort_worst_first)
        line.addWidget(worst)
        return line

    def _build_table(self):
        self.table = QtWidgets.QTableView()
        self.table.setModel(self.model)
        show_seams_in(self.table, HEIGHT)
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.table.setSortingEnabled(True)
        self.table.selectionModel().selectionChanged.connect(self._selection_changed)
        return self.table

    def show_report(self, report):
        """Show the seams of a report; filter and order stay."""
        built = rows.build_rows(report)
        self.model.set_rows(built)
        for index, column in enumerate(rows.COLUMNS):
            if column.field == "curvature_change_rel":
                self.table.setColumnHidden(index, not rows.has_values(built, column.field))
        self._count(report)
        self.table.resizeColumnsToContents()

    def _count(self, report):
        """Write into the filter how many seams each class has."""
        counts = summary.class_counts(report)
        self.filter.setItemText(0, "All seams (%d)" % sum(counts.values()))
        for index, seam_class in enumerate(palette.CLASSES, 1):
            text = "%s (%d)" % (seam_class.name, counts[seam_class.key])
            self.filter.setItemText(index, text)
            self.filter.setItemIcon(index, _swatch(seam_class.rgb))
        text = "Uncertain (%d)" % summary.uncertain(report)
        self.filter.setItemText(self.filter.count() - 1, text)

    def sort_worst_first(self, *_):
        """Restore the initial order."""
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.model.sort(-1)

    def select_edge(self, number):
        """Select the lines of the seams that have an edge; the view stays as it is."""
        lines = self.model.rows_of_edge(number)
        if not lines:
            self.filter.setCurrentIndex(0)
            lines = self.model.rows_of_edge(number)
        selection = QtCore.QItemSelection()
        for line in lines:
            index = self.model.index(line, 0)
            selection.select(index, index)
        self._look = False
        flags = QtCore.QItemSelectionModel.ClearAndSelect | QtCore.QItemSelectionModel.Rows
        self.table.selectionModel().select(selection, flags)
        self._look = True
        if lines:
            self.table.scrollTo(self.model.index(lines[0], 0))

    def _filter_changed(self, index):
        self.model.set_filter(self.filter.itemData(index))
        self.table.resizeColumnsToContents()

    def _selection_changed(self, *_):
        lines = [index.row() for index in self.table.selectionModel().selectedRows()]
        if lines:
            self.chosen.emit([self.model.row(line).seam for line in lines], self._look)


def _swatch(rgb):
    pixmap = QtGui.QPixmap(16, 16)
    pixmap.fill(QtGui.QColor(*rgb))
    return QtGui.QIcon(pixmap)
