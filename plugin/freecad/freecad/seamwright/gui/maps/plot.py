# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot of values along seams, with the bounds of their largest value; drawn by Qt's painter."""

from typing import Any, NamedTuple

from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.ramps import figure
from freecad.seamwright.plain.ticks import ticks

HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 210, 66, 12, 26, 36
PAPER, INK = (255, 255, 255), (40, 40, 40)
CURVE, BOUND, BAND, GRID = (0, 82, 158), (213, 94, 0), (213, 94, 0, 45), (150, 150, 150, 110)

#: Room above the largest value.
ROOM = 1.12


class Line(NamedTuple):
    """Values along one seam: ``lengths`` from its beginning, ``values`` (None: undefined);
    ``lower``, ``upper``: of their largest value, None where it is not known."""

    lengths: Any
    values: Any
    lower: Any
    upper: Any


class Plot(QtWidgets.QWidget):
    """Lines one after the other; ``pointed`` (line, place) is emitted when the mouse moves, -1, -1
    when it leaves."""

    pointed = QtCore.Signal(int, int)

    def __init__(self):
        super().__init__()
        self.setMinimumHeight(HEIGHT)
        self.setMouseTracking(True)
        self.setToolTip(tr("Move the mouse: the point is marked on the seam in the view"))
        self.lines, self._title, self._unit, self._at = [], "", "", None
        self._starts, self._top = [0.0], 1.0

    def show_lines(self, lines, title, unit):
        """Draw these Lines."""
        self.lines, self._title, self._unit, self._at = list(lines), title, unit, None
        self._starts = [0.0]  # where lines begin, and the end of the last one
        for line in self.lines:
            self._starts.append(self._starts[-1] + line.lengths[-1])
        every = [
            each
            for line in self.lines
            for each in (*line.values, line.upper, line.lower)
            if each is not None
        ]
        self._top = ROOM * max(every, default=0.0) or 1.0
        self.update()

    # Positions.

    def _area(self):
        return QtCore.QRectF(self.rect()).adjusted(LEFT, TOP, -RIGHT, -BOTTOM)

    def _place(self, x, y):
        area, whole = self._area(), self._starts[-1] or 1.0
        return QtCore.QPointF(
            area.left() + x / whole * area.width(), area.bottom() - y / self._top * area.height()
        )

    def point_at(self, across):
        """Return (line, place) of the point nearest to a horizontal position in pixels."""
        area, starts = self._area(), self._starts
        x = (across - area.left()) / max(area.width(), 1.0) * starts[-1]
        index = max(k for k in range(len(self.lines)) if k == 0 or starts[k] <= x)
        lengths = self.lines[index].lengths
        return index, min(range(len(lengths)), key=lambda k: abs(starts[index] + lengths[k] - x))

    # What Qt calls.

    def mouseMoveEvent(self, event):
        """Mark the point under the mouse."""
        if not self.lines:
            return
        position = event.position() if hasattr(event, "position") else event.localPos()
        self._at = self.point_at(position.x())
        self.pointed.emit(*self._at)
        self.update()

    def leaveEvent(self, event):
        """Remove the mark."""
        self._at = None
        self.pointed.emit(-1, -1)
        self.update()

    def paintEvent(self, event):
        """Draw axes, bounds and curves."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), QtGui.QColor(*PAPER))
        if self.lines:
            self._draw_axes(painter)
            for start, line in zip(self._starts, self.lines):
                self._draw_bounds(painter, start, line)
                self._draw_values(painter, start, line)
            if self._at is not None:
                self._draw_pointer(painter)
        painter.end()

    def _draw_axes(self, painter):
        area, text = self._area(), QtGui.QColor(*INK)
        grid = QtGui.QPen(QtGui.QColor(*GRID), 1.0, QtCore.Qt.DotLine)
        right = QtCore.Qt.AlignVCenter | QtCore.Qt.AlignRight
        for y in ticks(0.0, self._top, 4):
            spot = self._place(0.0, y)
            painter.setPen(grid)
            painter.drawLine(spot, QtCore.QPointF(area.right(), spot.y()))
            painter.setPen(text)
            box = QtCore.QRectF(0, spot.y() - 10, LEFT - 6, 20)
            painter.drawText(box.toRect(), right, figure(y))
        for x in ticks(0.0, self._starts[-1], 6):
            spot = self._place(x, 0.0)
            painter.setPen(grid)
            painter.drawLine(spot, QtCore.QPointF(spot.x(), area.top()))
            painter.setPen(text)
            box = QtCore.QRectF(spot.x() - 30, area.bottom() + 3, 60, 16)
            painter.drawText(box.toRect(), QtCore.Qt.AlignHCenter, figure(x))
        title = "%s%s" % (self._title, ", %s" % self._unit if self._unit else "")
        painter.drawText(QtCore.QPointF(8, TOP - 9), title)
        box = QtCore.QRectF(area.left(), self.height() - 17, area.width(), 16)
        painter.drawText(box.toRect(), right, tr("along the seam, mm"))
        painter.drawRect(area)

    def _draw_bounds(self, painter, start, line):
        """Draw the band in which the largest value certainly lies."""
        if line.lower is None:
            return
        high = self._top if line.upper is None else line.upper
        low_left = self._place(start, line.lower)
        high_right = self._place(start + line.lengths[-1], high)
        painter.fillRect(QtCore.QRectF(low_left, high_right).normalized(), QtGui.QColor(*BAND))
        painter.setPen(QtGui.QPen(QtGui.QColor(*BOUND), 1.4, QtCore.Qt.DashLine))
        for y in (line.lower, line.upper):
            if y is not None:
                painter.drawLine(self._place(start, y), self._place(start + line.lengths[-1], y))

    def _draw_values(self, painter, start, line):
        painter.setPen(QtGui.QPen(QtGui.QColor(*CURVE), 1.8))
        run = []
        for length, value in [*zip(line.lengths, line.values), (0.0, None)]:
            if value is not None:
                run.append(self._place(start + length, value))
            elif run:
                painter.drawPolyline(QtGui.QPolygonF(run))
                run = []

    def _draw_pointer(self, painter):
        index, place = self._at
        line, area = self.lines[index], self._area()
        spot = self._place(self._starts[index] + line.lengths[place], line.values[place] or 0.0)
        painter.setPen(QtGui.QPen(QtGui.QColor(*INK), 1.0))
        painter.drawLine(
            QtCore.QPointF(spot.x(), area.top()), QtCore.QPointF(spot.x(), area.bottom())
        )
        if line.values[place] is not None:
            painter.setBrush(QtGui.QColor(*CURVE))
            painter.drawEllipse(spot, 4.0, 4.0)
