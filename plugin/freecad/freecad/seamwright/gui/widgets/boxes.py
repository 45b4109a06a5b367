# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that leave the mouse wheel to the panel unless they have the focus.

Else a panel that is scrolled would change the field under the pointer. Fields of numbers keep the
key Enter while their text is not allowed: it would close the panel with the last number.
"""

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import tr


class LeavesWheel:
    """A field of Qt that takes the wheel only while it has the focus."""

    def __init__(self, *args):
        super().__init__(*args)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)  # the wheel gives no focus

    def wheelEvent(self, event):
        """Change the value, or let the panel scroll."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class ComboBox(LeavesWheel, QtWidgets.QComboBox):
    """A choice in a panel."""


class HoldsEnter(LeavesWheel):
    """A field of numbers that answers Enter with what is allowed, while its text is not."""

    def keyPressEvent(self, event):
        """Say what is allowed, or take the key."""
        enters = event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)
        if not enters or self.hasAcceptableInput():
            super().keyPressEvent(event)
            return
        text = tr("Not allowed: enter a number from {least} to {largest}.").format(
            least=self.textFromValue(self.minimum()), largest=self.textFromValue(self.maximum())
        )
        place = self.mapToGlobal(self.rect().bottomLeft())
        QtWidgets.QToolTip.showText(place, text, self)


class SpinBox(HoldsEnter, QtWidgets.QSpinBox):
    """A whole number in a panel."""


class DoubleSpinBox(HoldsEnter, QtWidgets.QDoubleSpinBox):
    """A number in a panel."""
