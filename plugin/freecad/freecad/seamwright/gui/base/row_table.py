# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of seams: rows with texts, of which the last has a colour that tells the outcome.

It stands beside the first one, where it is always seen.
"""

from freecad.seamwright.gui.widgets import ink
from freecad.seamwright.gui.widgets.forms import name_columns, show_seams_in
from freecad.seamwright.gui.widgets.qt import QtGui, QtWidgets
from freecad.seamwright.plain import repair_text

#: Text colours of the last column, by the state of a row.
INKS = {repair_text.REPAIRED: ink.GOOD, repair_text.NOT_REPAIRED: ink.BAD}

#: The least width of the outcome, in pixels.
LEAST = 150

#: Rows for which a table that is as high as its rows always has room, and at most.
FEWEST, MOST = 2, 8


class RowTable(QtWidgets.QTableWidget):
    """Rows with ``cells``, a text for each of the columns (heading, tool tip).

    ``detail`` of a row is its tool tip. Its ``state`` is a key of INKS or another state, whose text
    has the default colour. ``height``: the minimum height in pixels; None: as high as the rows.
    """

    def __init__(self, columns, height=None):
        super().__init__(0, len(columns))
        self.rows, self._columns, self._grows = [], columns, height is None
        name_columns(self, self._columns)
        header = self.horizontalHeader()
        header.moveSection(len(columns) - 1, 1)  # far columns may be off the panel
        header.setStretchLastSection(True)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        show_seams_in(self, height or 0)
        self.fit_columns()

    def fit_columns(self):
        """Fit the columns to their texts.

        The outcome gets the room that the others leave, so a long reason is cut off.
        """
        header, outcome = self.horizontalHeader(), self.columnCount() - 1
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        widths = [
            max(self.sizeHintForColumn(column), header.sectionSizeHint(column))
            for column in range(outcome + 1)
            if not self.isColumnHidden(column)
        ]
        whole = widths.pop()
        room = self.viewport().width() - sum(widths)
        header.setSectionResizeMode(outcome, QtWidgets.QHeaderView.Interactive)
        header.resizeSection(outcome, min(whole, max(room, LEAST)))
        if self._grows:
            self._fit_height()

    def _fit_height(self):
        """Be as high as the rows, and a scrollbar below them where the columns need one."""
        header = self.horizontalHeader()
        lines = min(max(self.rowCount(), FEWEST), MOST)
        height = header.sizeHint().height() + lines * self.verticalHeader().defaultSectionSize()
        if header.length() > self.viewport().width():
            height += self.horizontalScrollBar().sizeHint().height()
        self.setFixedHeight(height + 2 * self.frameWidth())

    def resizeEvent(self, event):
        """Fit the columns to the new width."""
        super().resizeEvent(event)
        self.fit_columns()

    def show_rows(self, rows):
        """Show these rows."""
        self.rows = rows
        name_columns(self, self._columns)
        self.clearSelection()
        self.setRowCount(len(rows))
        for line, row in enumerate(rows):
            for column, text in enumerate(row.cells):
                item = QtWidgets.QTableWidgetItem(text)
                item.setToolTip(row.detail)
                if column == len(row.cells) - 1 and row.state in INKS:
                    item.setForeground(QtGui.QBrush(ink.ink(INKS[row.state], self)))
                self.setItem(line, column, item)
        self.fit_columns()

    def chosen(self):
        """Return the selected rows, from top to bottom."""
        lines = sorted({index.row() for index in self.selectionModel().selectedRows()})
        return [self.rows[line] for line in lines]
