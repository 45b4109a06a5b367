# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Match Surfaces: an option panel, with the seam before and after."""

from freecad.seamwright.document import match
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.gui.base.replacing_panel import ReplacingPanel
from freecad.seamwright.gui.widgets.forms import make_box, make_summary
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import match_text
from freecad.seamwright.plain.language import tr

#: The button to exchange the faces stands beside the second one.
FIRST, SECOND = match.FACES
EDGE = "CommonEdge"

#: Lines of the summary with all that it may tell of two faces.
SUMMARY_LINES = 4


class MatchPanel(ReplacingPanel):
    """Shows and changes one Match Surfaces; ``created``: Cancel removes it."""

    DOCK_WIDTH = 480

    def has_result(self):
        """Return whether the faces match."""
        return bool(self.obj.Matched)

    # The window.

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        box = super().build_sources(name, title, tip)
        if name == SECOND:
            self.swap = QtWidgets.QPushButton(tr("Swap"))
            self.swap.setToolTip(
                tr("Exchange the first and the second face, so that the other one moves")
            )
            self.swap.clicked.connect(self._swap)
            box.line.add(self.swap)
        return box

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box, layout = make_box(tr("Result"))
        self.summary = make_summary(SUMMARY_LINES)
        layout.addWidget(self.summary)
        count = len(match_text.table(report_of(self.obj)))
        self.table = QtWidgets.QTableWidget(count, 2)
        self.table.setHorizontalHeaderLabels([tr("Before"), tr("After")])
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        height = self.table.fontMetrics().height() + 8
        self.table.verticalHeader().setDefaultSectionSize(height)
        self.table.setFixedHeight((count + 1) * height + 8)
        layout.addWidget(self.table)
        layout.addLayout(self.build_show())
        return box

    # Actions.

    def complete(self, chosen):
        """Return the links that are meant by those of a selection."""
        return match.completed(chosen)

    def check(self, name, chosen):
        """Raise ValueError where a property cannot have these links."""
        match.check(name, chosen)

    def take(self, name, chosen):
        """Let a property have these links; other faces have another common edge."""
        if name != EDGE and self.links(EDGE):
            self._links[EDGE] = []
        super().take(name, chosen)

    def refresh(self):
        """Show the results as they are stored now."""
        lines = match_text.table(report_of(self.obj))
        self.table.setVerticalHeaderLabels([heading for heading, *_ in lines])
        for line, (_, *cells) in enumerate(lines):
            for column, text in enumerate(cells):
                self.table.setItem(line, column, QtWidgets.QTableWidgetItem(text))
        super().refresh()

    def _swap(self, *_):
        self._links.update({FIRST: self.links(SECOND), SECOND: self.links(FIRST)})
        self._list_sources()
        self._edits += 1
        self.preview()
