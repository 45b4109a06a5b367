# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of an analysis: a line for each seam, with a filter by class and a default order."""

from freecad.seamwright.gui.analysis.table_model import SeamTableModel
from freecad.seamwright.gui.analysis.table_view import SeamTableView
from freecad.seamwright.gui.widgets.boxes import ComboBox
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain import filters, palette, rows
from freecad.seamwright.plain.language import tr


class SeamTable(QtWidgets.QWidget):
    """The lines of one report.

    When lines are selected, ``chosen`` is emitted with the numbers of their seams, and with whether
    the view has to turn to them. It stays where the user picked an edge in the view, and where the
    user moves through the table with the keys. ``filter_chosen`` is emitted with a name of
    filters.NAMES, ``asked`` with the key of an entry of the context menu.
    """

    chosen = QtCore.Signal(list, bool)
    filter_chosen = QtCore.Signal(str)
    asked = QtCore.Signal(str)

    def __init__(self):
        super().__init__()
        self.model = SeamTableModel()
        self._look, self._silent = True, False
        self._kept, self._names = set(), set()
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(self._build_filter())
        layout.addWidget(self._build_table())

    def _build_filter(self):
        line = FlowLayout()
        line.add(QtWidgets.QLabel(tr("Show")))
        self.filter = ComboBox()
        self.filter.setToolTip(tr("The seams in the table and in the view"))
        for name, wanted in filters.FILTERS.items():
            self.filter.addItem(tr(name), wanted)
            if wanted in palette.BY_KEY:
                self.filter.setItemIcon(
                    self.filter.count() - 1, _swatch(palette.BY_KEY[wanted].rgb)
                )
        self.filter.currentIndexChanged.connect(self._filter_changed)
        line.add(self.filter, 1)
        worst = QtWidgets.QPushButton(tr("Worst first"))
        worst.setToolTip(
            tr(
                "Sort by class: defects by how much their figures exceed the tolerances, others by "
                "the figure of the level, such as the angle for G1"
            )
        )
        worst.clicked.connect(self.sort_worst_first)
        line.add(worst)
        return line

    def _build_table(self):
        self.table = SeamTableView(self.model)
        self.table.asked.connect(self._asked)
        self.table.selectionModel().selectionChanged.connect(self._selection_changed)
        self.model.modelAboutToBeReset.connect(self._remember)
        self.model.modelReset.connect(self._recall)
        return self.table

    def show_results(self, results):
        """Show the seams of SeamResults; filter, order and the chosen seams stay.

        Their edges tell which they are: their numbers may differ. An empty table, as before a long
        report has been read, has no choice that could replace the last one.
        """
        if self.model.rowCount():
            self._names = {row.edge_text for row in self.chosen_rows()}
        self._silent = True
        self.table.clearSelection()
        self._silent = False
        self.model.set_rows(results.rows)
        for index, column in enumerate(rows.COLUMNS):
            if column.field in rows.NEEDLESS:
                self.table.setColumnHidden(index, rows.NEEDLESS[column.field](results.rows))
        for index, count in enumerate(filters.counts(results.report)):
            self.filter.setItemText(index, "%s (%d)" % (tr(filters.NAMES[index]), count))
        self.table.fit_columns(new_texts=True)
        self._choose_again()

    def _choose_again(self):
        lines = self.model.rows_of_names(self._names) if self._names else []
        if lines:
            self._look = False
            self._select(lines)
            self._look = True

    def show_filter(self, name):
        """Show the seams of a choice of filters.NAMES."""
        self.filter.setCurrentIndex(filters.NAMES.index(name))

    def chosen_rows(self):
        """Return the selected Rows, in the order of the table."""
        # Qt's list of selected rows takes seconds for 40,000 rows: it asks the model for each cell.
        ranges = self.table.selectionModel().selection()
        lines = {line for each in ranges for line in range(each.top(), each.bottom() + 1)}
        return [self.model.row(line) for line in sorted(lines)]

    def shown_seams(self):
        """Return the numbers of the seams that the filter lets pass, in the order of the table."""
        return [self.model.row(line).seam for line in range(self.model.rowCount())]

    def sort_worst_first(self, *_):
        """Restore the initial order."""
        self.table.horizontalHeader().setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        self.model.sort(-1)

    def select_edges(self, numbers):
        """Select the lines of the seams that have one of the edges; the view stays as it is."""
        lines = self.model.rows_of_edges(numbers)
        if not lines:
            self.filter.setCurrentIndex(0)
            lines = self.model.rows_of_edges(numbers)
        self._look = False
        self._select(lines)
        self._look = True

    def _select(self, lines):
        selection, last = QtCore.QItemSelection(), self.model.columnCount() - 1
        for first, end in _runs(lines):
            selection.select(self.model.index(first, 0), self.model.index(end, last))
        flags = QtCore.QItemSelectionModel.ClearAndSelect
        self.table.selectionModel().select(selection, flags)
        if lines:
            flags = QtCore.QItemSelectionModel.NoUpdate
            self.table.selectionModel().setCurrentIndex(self.model.index(lines[0], 0), flags)
            self.table.scrollTo(self.model.index(lines[0], 0))

    def _filter_changed(self, index):
        self.model.set_filter(self.filter.itemData(index))
        self.table.fit_columns(new_texts=True)
        self.filter_chosen.emit(filters.NAMES[index])

    def _remember(self):
        self._kept = {row.seam for row in self.chosen_rows()}

    def _recall(self):
        """Select the chosen seams again that a new order or filter has left in the table."""
        lines = self.model.rows_of_seams(self._kept) if self._kept else []
        self._silent = len(lines) == len(self._kept)
        self._look = False
        if lines:
            self._select(lines)
        elif self._kept:
            self.chosen.emit([], False)
        self._look, self._silent = True, False

    def _selection_changed(self, *_):
        if not self._silent:
            look = self._look and not self.table.by_keys
            self.chosen.emit([row.seam for row in self.chosen_rows()], look)

    def _asked(self, key):
        if key == "copy":
            QtWidgets.QApplication.clipboard().setText(rows.cells(self.chosen_rows()))
        else:
            self.asked.emit(key)


def _runs(lines):
    """Return [(first, last), ...] of sorted numbers that follow each other."""
    found = []
    for line in lines:
        if found and found[-1][1] == line - 1:
            found[-1][1] = line
        else:
            found.append([line, line])
    return found


def _swatch(rgb):
    pixmap = QtGui.QPixmap(16, 16)
    pixmap.fill(QtGui.QColor(*rgb))
    return QtGui.QIcon(pixmap)
