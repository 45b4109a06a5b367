# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of tension and bias at each point of a spline."""

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import options
from freecad.seamwright.plain.language import mark, tr

#: The arguments of the columns after that of the number of the point, with their headings.
COLUMNS = (("tension", mark("Tension")), ("bias", mark("Bias")))

HEIGHT = 130


class PointTable(QtWidgets.QTableWidget):
    """One row for each point; ``edited(argument, numbers)`` when the user changes a number."""

    edited = QtCore.Signal(str, list)

    def __init__(self):
        super().__init__(0, 1 + len(COLUMNS))
        self.setHorizontalHeaderLabels([tr("Point"), *(tr(heading) for _, heading in COLUMNS)])
        self.verticalHeader().hide()
        self.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self.setFixedHeight(HEIGHT)
        self.setToolTip(tr("Tension and bias of each point; a bad number is not taken"))
        self._numbers, self._shows = [], False
        self.cellChanged.connect(self._change)

    def show_numbers(self, count, columns):
        """Show numbers of points: for each column one for each point, or one for all."""
        self._numbers = [
            list(each) * count if len(each) == 1 else list(each)[:count] for each in columns
        ]
        self._shows = True
        self.setRowCount(count)
        for column in range(len(COLUMNS)):
            self.setColumnHidden(1 + column, column >= len(columns))
        for row in range(count):
            self._put(row, 0, str(row + 1), QtCore.Qt.ItemIsSelectable)
            for column, numbers in enumerate(self._numbers, 1):
                text = options.numbers_text(numbers[row : row + 1]) if row < len(numbers) else ""
                self._put(row, column, text)
        self._shows = False

    def _put(self, row, column, text, flags=None):
        item = self.item(row, column) or QtWidgets.QTableWidgetItem()
        item.setText(text)
        if flags is not None:
            item.setFlags(flags | QtCore.Qt.ItemIsEnabled)
        if self.item(row, column) is None:
            self.setItem(row, column, item)

    def _change(self, row, column):
        if self._shows or column == 0:
            return
        numbers = list(self._numbers[column - 1])
        try:
            (numbers[row],) = options.parse_numbers(self.item(row, column).text())
        except (ValueError, IndexError):
            self.show_numbers(self.rowCount(), self._numbers)
            return
        self.edited.emit(COLUMNS[column - 1][0], numbers)
