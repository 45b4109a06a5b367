# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets in a line that goes on in a further line where the panel is narrow."""

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets


class FlowLayout(QtWidgets.QLayout):
    """A row of widgets that is broken where it is wider than its place."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._items, self._stretches = [], []
        self.setContentsMargins(0, 0, 0, 0)
        self.setSpacing(6)

    def add(self, widget, stretch=0):
        """Add a widget; ``stretch``: the share of what is left of its line.

        The item is made here: PySide can lose one that ``addWidget`` makes, and then the line is
        empty.
        """
        self.addChildWidget(widget)
        self.addItem(QtWidgets.QWidgetItem(widget))
        self._stretches[-1] = stretch

    # Methods that Qt calls.

    def addItem(self, item):
        """Take an item."""
        self._items.append(item)
        self._stretches.append(0)

    def count(self):
        """Return the number of widgets."""
        return len(self._items)

    def itemAt(self, place):
        """Return the item at a place; None where there is none."""
        return self._items[place] if 0 <= place < len(self._items) else None

    def takeAt(self, place):
        """Remove and return the item at a place; None where there is none."""
        if not 0 <= place < len(self._items):
            return None
        del self._stretches[place]
        return self._items.pop(place)

    def expandingDirections(self):
        """Return that the line wants no more height than it needs."""
        return QtCore.Qt.Orientations(QtCore.Qt.Horizontal)

    def hasHeightForWidth(self):
        """Return that a narrow line is higher."""
        return True

    def heightForWidth(self, width):
        """Return the height of the lines in this width."""
        return self._arrange(QtCore.QRect(0, 0, width, 0), False)

    def sizeHint(self):
        """Return the size of one line."""
        sizes = [item.sizeHint() for item, _ in self._shown()]
        width = sum(size.width() + self.spacing() for size in sizes) - self.spacing()
        return self._with_margins(max(width, 0), max([size.height() for size in sizes] + [0]))

    def minimumSize(self):
        """Return the size of the widest widget."""
        sizes = [item.minimumSize() for item, _ in self._shown()]
        return self._with_margins(
            max([size.width() for size in sizes] + [0]),
            max([size.height() for size in sizes] + [0]),
        )

    def setGeometry(self, area):
        """Put the widgets into this area."""
        super().setGeometry(area)
        self._arrange(area, True)

    def _with_margins(self, width, height):
        margins = self.contentsMargins()
        return QtCore.QSize(
            width + margins.left() + margins.right(), height + margins.top() + margins.bottom()
        )

    def _shown(self):
        return [
            (item, stretch)
            for item, stretch in zip(self._items, self._stretches)
            if _is_seen(item)
        ]

    def _lines(self, width):
        """Return lists of (item, stretch, least width) that fit into lines of this width."""
        lines, used = [], 0
        for item, stretch in self._shown():
            least = (item.minimumSize() if stretch else item.sizeHint()).width()
            least = min(least, width)
            if not lines or used + self.spacing() + least > width:
                lines.append([])
                used = -self.spacing()
            lines[-1].append((item, stretch, least))
            used += self.spacing() + least
        return lines

    def _arrange(self, area, moves):
        """Return the height of the lines; ``moves``: whether the widgets are put there."""
        margins = self.contentsMargins()
        left, top = area.left() + margins.left(), area.top() + margins.top()
        width = area.width() - margins.left() - margins.right()
        lines = self._lines(width)
        for number, line in enumerate(lines):
            rest = width - sum(least for *_, least in line) - self.spacing() * (len(line) - 1)
            shares = sum(stretch for _, stretch, _ in line)
            widths = [least + (rest * own // shares if own else 0) for _, own, least in line]
            heights = [_height(item, own) for (item, *_), own in zip(line, widths)]
            height, x = max(heights), left
            for (item, *_), own, high in zip(line, widths, heights):
                if moves:
                    middle = top + (height - high) // 2
                    item.setGeometry(QtCore.QRect(x, middle, own, high))
                x += own + self.spacing()
            top += height + (self.spacing() if number < len(lines) - 1 else 0)
        return top - area.top() + margins.bottom()


def _is_seen(item):
    try:
        return not item.isEmpty()
    except RuntimeError:  # Qt is deleting the panel, and has deleted the item
        return False


def _height(item, width):
    return item.heightForWidth(width) if item.hasHeightForWidth() else item.sizeHint().height()
