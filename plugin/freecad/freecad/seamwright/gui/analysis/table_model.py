# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam table as a Qt model; plain.rows has the texts of cells and the sorting of rows."""

from freecad.seamwright.gui.widgets.qt import QtCore, QtGui
from freecad.seamwright.plain import lengths, palette, rows

Qt = QtCore.Qt

_RIGHT = Qt.AlignRight | Qt.AlignVCenter
NUMBERS = _RIGHT.value if hasattr(_RIGHT, "value") else int(_RIGHT)


class SeamTableModel(QtCore.QAbstractTableModel):
    """Rows of one report, sorted and filtered."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._all = []
        self._shown = []
        self._wanted = None
        self._order = None  # (field, descending), or None for worst first

    def set_rows(self, all_rows):
        """Show the rows of another report; sorting and filter stay."""
        self._all = list(all_rows)
        self._arrange()

    def set_filter(self, wanted):
        """Show only the rows that ``rows.filter_rows`` lets pass."""
        if wanted == self._wanted:
            return
        self._wanted = wanted
        self._arrange()

    def row(self, index):
        """Return the Row at an index of the shown rows."""
        return self._shown[index]

    def rows_of_edges(self, numbers):
        """Return the indices of the shown rows whose seam has one of these edges."""
        wanted = set(numbers)
        return [index for index, row in enumerate(self._shown) if not wanted.isdisjoint(row.edges)]

    def rows_of_seams(self, numbers):
        """Return the indices of the shown rows of these seams."""
        return [index for index, row in enumerate(self._shown) if row.seam in numbers]

    def rows_of_names(self, names):
        """Return the indices of the shown rows whose edges have one of these texts."""
        return [index for index, row in enumerate(self._shown) if row.edge_text in names]

    def rowCount(self, parent=None):
        """Return the number of shown rows."""
        return 0 if parent is not None and parent.isValid() else len(self._shown)

    def columnCount(self, parent=None):
        """Return the number of columns."""
        return 0 if parent is not None and parent.isValid() else len(rows.COLUMNS)

    def data(self, index, role=Qt.DisplayRole):
        """Return text, tool tip, alignment or colour mark of a cell."""
        row, column = self._shown[index.row()], rows.COLUMNS[index.column()]
        if role == Qt.DisplayRole:
            return rows.cell_text(row, column)
        if role == Qt.ToolTipRole:
            return "%s, %s\n%s" % (row.edge_text, row.face_text, row.detail)
        if role == Qt.DecorationRole and column.field == "seam_class":
            return QtGui.QColor(*palette.BY_KEY[row.seam_class].rgb)
        if role == Qt.TextAlignmentRole and column.numeric:
            return NUMBERS
        return None

    def headerData(self, section, orientation, role=Qt.DisplayRole):
        """Return the heading of a column or its tool tip."""
        if orientation != Qt.Horizontal:
            return None
        column = rows.COLUMNS[section]
        texts = {Qt.DisplayRole: column.title, Qt.ToolTipRole: column.tip}
        return lengths.titled(texts[role]) if role in texts else None

    def sort(self, column, order=Qt.AscendingOrder):
        """Sort by a column; column -1 means worst first."""
        field = rows.COLUMNS[column].field if column >= 0 else None
        self._order = (field, order == Qt.DescendingOrder) if field else None
        self._arrange()

    def _arrange(self):
        self.beginResetModel()
        shown = rows.filter_rows(self._all, self._wanted)
        self._shown = rows.sort_rows(shown, *self._order) if self._order else shown
        self.endResetModel()
