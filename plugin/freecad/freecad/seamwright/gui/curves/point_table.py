# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of the points of a spline: their coordinates, tension and bias."""

import math

from freecad.seamwright.document import expressions
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import lengths, options
from freecad.seamwright.plain.language import mark, tr

AXES = ("X", "Y", "Z")

#: The arguments of the columns after the coordinates, with their headings.
COLUMNS = (("tension", mark("Tension")), ("bias", mark("Bias")))

#: The points that are seen at once.
LINES = 6


class PointTable(QtWidgets.QTableWidget):
    """One row for each point.

    When the user changes a number, it emits ``moved(row, point in mm)`` or
    ``edited(argument, numbers of all points)``.
    """

    moved = QtCore.Signal(int, list)
    edited = QtCore.Signal(str, list)

    def __init__(self, obj):
        """``obj``: the spline; texts may be expressions that name what it can refer to."""
        super().__init__(0, len(AXES) + len(COLUMNS))
        self._obj = obj
        self._points, self._numbers, self._shows = (), [], False
        self.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        self.horizontalHeader().setMinimumSectionSize(1)
        line = self.fontMetrics().height() + 6
        self.verticalHeader().setDefaultSectionSize(line)
        heading = self.horizontalHeader().sizeHint().height()
        self.setFixedHeight(heading + LINES * line + 2 * self.frameWidth())
        self.setToolTip(
            tr("Coordinates, tension and bias of each point; a bad number is not taken")
        )
        self.cellChanged.connect(self._change)
        self._refused = None  # the index of a cell, and what it did not take
        self._later = QtCore.QTimer(self)  # a tooltip ends when the editor of a cell closes
        self._later.setSingleShot(True)
        self._later.timeout.connect(self._say_refused)

    def show_points(self, points, columns):
        """Show points in mm, and numbers: for each column one for each point, or one for all."""
        count = len(points)
        self._points = points
        self._numbers = [
            list(each) * count if len(each) == 1 else list(each)[:count] for each in columns
        ]
        self._shows = True
        self.setRowCount(count)
        unit = lengths.unit()
        self.setHorizontalHeaderLabels(
            ["%s %s" % (axis, unit.name) for axis in AXES]
            + [tr(heading) for _, heading in COLUMNS]
        )
        for column in range(len(COLUMNS)):
            self.setColumnHidden(len(AXES) + column, column >= len(columns))
        for row in range(count):
            for axis in range(len(AXES)):
                self._put(row, axis, "%.7g" % (points[row][axis] / unit.mm))
            for column, numbers in enumerate(self._numbers, len(AXES)):
                self._put(row, column, "%.5g" % numbers[row] if row < len(numbers) else "")
        self._shows = False

    def _put(self, row, column, text):
        item = self.item(row, column)
        if item is None:
            item = QtWidgets.QTableWidgetItem()
            self.setItem(row, column, item)
        item.setText(text)

    def _change(self, row, column):
        if self._shows:
            return
        text = self.item(row, column).text()
        try:
            if column < len(AXES):
                point = [float(each) for each in self._points[row]]
                point[column] = self._length_mm(text)
                self.moved.emit(row, point)
                return
            name, _ = COLUMNS[column - len(AXES)]
            numbers = list(self._numbers[column - len(AXES)])
            (numbers[row],) = options.parse_numbers(text)
        except (ValueError, IndexError):
            self.show_points(self._points, self._numbers)
            said = tr("\u201c{text}\u201d is no such number: {kept} is kept.").format(
                text=text, kept=self.item(row, column).text()
            )
            self._refused = self.model().index(row, column), said
            self._later.start(0)
            return
        self.edited.emit(name, numbers)

    def _say_refused(self):
        index, text = self._refused
        place = self.viewport().mapToGlobal(self.visualRect(index).bottomLeft())
        QtWidgets.QToolTip.showText(place, text, self)

    def _length_mm(self, text):
        """Return the length of a number in the unit of the user, or of an expression."""
        text = text.strip().replace(str(self.locale().decimalPoint()), ".")
        try:
            length_mm = float(text) * lengths.unit().mm
        except ValueError:
            length_mm = expressions.evaluated(self._obj, text.lstrip("="), "mm")
        if not math.isfinite(length_mm):
            raise ValueError(tr("must be finite"))
        return length_mm
