# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that leave the mouse wheel to the panel unless they have the focus.

Else a panel that is scrolled would change the field under the pointer.
"""

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets


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


class SpinBox(LeavesWheel, QtWidgets.QSpinBox):
    """A whole number in a panel."""


class DoubleSpinBox(LeavesWheel, QtWidgets.QDoubleSpinBox):
    """A number in a panel."""
