# SPDX-License-Identifier: LGPL-2.1-or-later
"""The box of a task panel that names the sources of one property."""

from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.forms import LEAST_WIDTH
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.summary import counted

#: Names of sources that are listed; of more the number is told.
LISTED = 6


class ChosenText(QtWidgets.QLabel):
    """The names of sources; a click, or the space bar, says ``clicked``."""

    clicked = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.setWordWrap(True)
        self.setFocusPolicy(QtCore.Qt.TabFocus)
        self.setCursor(QtCore.Qt.PointingHandCursor)

    def mouseReleaseEvent(self, event):
        """Qt calls this when a button of the mouse is released."""
        self.clicked.emit()

    def keyPressEvent(self, event):
        """Qt calls this when a key is pressed."""
        if event.key() == QtCore.Qt.Key_Space:
            self.clicked.emit()
        else:
            super().keyPressEvent(event)


class SourceBox(QtWidgets.QGroupBox):
    """The sources of one property: their names, and a button to use the selection instead."""

    def __init__(self, title, tip):
        super().__init__(title)
        self.chosen = ChosenText()
        self.use = QtWidgets.QPushButton(tr("Use selection"))
        self.use.setToolTip(tip)
        self.line = FlowLayout(self)
        self.line.setContentsMargins(9, 10, 9, 4)
        self.chosen.setMinimumWidth(LEAST_WIDTH)
        self.line.add(self.chosen, 1)
        self.line.add(self.use)

    def show_links(self, chosen):
        """Show the names of [(object, "Edge3" or ""), ...]."""
        names = [".".join(filter(None, (obj.Label, name))) for obj, name in chosen]
        text = ", ".join(names[:LISTED]) or tr("nothing")
        more = len(names) - LISTED
        self.chosen.setText(text + (tr(" and {more} more").format(more=more) if more > 0 else ""))
        self.chosen.setToolTip(
            "%s: %s\n%s"
            % (
                counted(len(names), "source"),
                ", ".join(names),
                tr("A click selects them in the view"),
            )
        )
