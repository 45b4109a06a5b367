# SPDX-License-Identifier: LGPL-2.1-or-later
"""A list of faces or edges that the user fills by picking them in the view."""

from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.forms import LEAST_WIDTH
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import description, tr

#: The lines that are seen at once, and the room of a line beside its letters, in pixels.
LINES, ROOM = 2, 6


class ElementList(QtWidgets.QWidget):
    """Names such as "Face3" with buttons to add selected elements and to remove elements.

    ``picked``: a callable that returns the names of the selected elements. ``select``: a callable
    that selects a name in the view.
    """

    changed = QtCore.Signal()

    def __init__(self, picked, select, tip):
        super().__init__()
        self._picked = picked
        layout = FlowLayout(self)
        self.list = QtWidgets.QListWidget()
        self.list.setToolTip(description(tip))
        self.list.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.list.setMinimumWidth(LEAST_WIDTH // 2)
        self.list.setFlow(QtWidgets.QListView.LeftToRight)
        self.list.setWrapping(True)
        self.list.setResizeMode(QtWidgets.QListView.Adjust)
        self.list.setSpacing(1)
        line = self.list.fontMetrics().height() + ROOM
        self.list.setFixedHeight(LINES * line + 2 * self.list.frameWidth())
        self.list.itemClicked.connect(lambda item: select(item.text()))
        self.add = QtWidgets.QPushButton(tr("Add selected"))
        self.remove = QtWidgets.QPushButton(tr("Remove"))
        self.add.setToolTip(tr("Add what is selected in the view to the list"))
        self.remove.setToolTip(
            tr("Remove the selected names from the list, or all names if none is selected")
        )
        self.add.clicked.connect(self._add)
        self.remove.clicked.connect(self._remove)
        layout.add(self.list, 1)
        layout.add(self.add)
        layout.add(self.remove)

    def names(self):
        """Return the names in the list, in the order in which they were added."""
        return [self.list.item(row).text() for row in range(self.list.count())]

    def set_names(self, names):
        """Show these names."""
        self.list.clear()
        self.list.addItems(list(dict.fromkeys(names)))
        self.remove.setEnabled(bool(names))
        self.changed.emit()

    def _add(self, *_):
        self.set_names(self.names() + self._picked())

    def _remove(self, *_):
        chosen = {item.text() for item in self.list.selectedItems()} or set(self.names())
        self.set_names([name for name in self.names() if name not in chosen])
