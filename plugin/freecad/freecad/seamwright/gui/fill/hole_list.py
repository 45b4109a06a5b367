# SPDX-License-Identifier: LGPL-2.1-or-later
"""A list of holes with a tick at each hole that is to be filled."""

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import fill_text
from freecad.seamwright.plain.language import tr

LINES = 4


class HoleList(QtWidgets.QListWidget):
    """Holes as dicts of the kernel; at least one hole stays ticked.

    ``changed`` is emitted when other holes are ticked. ``clicked_edges`` is emitted when a hole is
    clicked, with the names of its edges.
    """

    changed = QtCore.Signal()
    clicked_edges = QtCore.Signal(list)

    def __init__(self):
        super().__init__()
        self.holes = []
        self.setToolTip(
            tr("Ticked holes are filled. Click a hole to see it and to select its edges.")
        )
        self.setWordWrap(True)
        self.setFixedHeight(LINES * (self.fontMetrics().height() + 6))
        self.itemChanged.connect(self._ticked)
        self.itemClicked.connect(
            lambda item: self.clicked_edges.emit(self._edges(self.holes[self.row(item)]))
        )

    def set_holes(self, holes, wanted):
        """List the holes, with a tick at those whose numbers are in ``wanted``."""
        self.holes = holes
        self.blockSignals(True)
        self.clear()
        for hole in holes:
            item = QtWidgets.QListWidgetItem(fill_text.hole_text(hole, holes), self)
            item.setToolTip(fill_text.hole_tip(hole))
            _tick(item, hole["id"] in wanted)
        self.blockSignals(False)

    def chosen(self):
        """Return the numbers of the ticked holes."""
        states = (self.item(index).checkState() for index in range(self.count()))
        return [hole["id"] for hole, state in zip(self.holes, states) if state == QtCore.Qt.Checked]

    def choose_by(self, edges):
        """Tick only the holes of these edges, which are given by name.

        Nothing changes where the edges belong to no hole.
        """
        found = [hole["id"] for hole in self.holes if not edges.isdisjoint(self._edges(hole))]
        if found and found != self.chosen():
            self.set_holes(self.holes, found)
            self.changed.emit()

    @staticmethod
    def _edges(hole):
        return ["Edge%d" % number for number in fill_text.edges_of(hole)]

    def _ticked(self, item):
        if not self.chosen():
            self.blockSignals(True)
            _tick(item, True)
            self.blockSignals(False)
        self.changed.emit()


def _tick(item, ticked):
    item.setCheckState(QtCore.Qt.Checked if ticked else QtCore.Qt.Unchecked)
