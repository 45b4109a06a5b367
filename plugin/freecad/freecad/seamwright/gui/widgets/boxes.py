# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that leave the mouse wheel to the panel unless they have the focus.

Else a panel that is scrolled would change the field under the pointer. The text of a field of
numbers is red while it is not allowed, and the field keeps the key Enter, which would close the
panel with the last number. A field that is left with such a text says so.
"""

from freecad.seamwright.gui.widgets import ink
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
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


class NumberBox(LeavesWheel):
    """A field of numbers that shows and says when its text is not allowed."""

    def __init__(self, *args):
        super().__init__(*args)
        self._before, self._is_wrong = self.value(), False
        self._later = QtCore.QTimer(self)  # a tooltip ends when another field takes the focus
        self._later.setSingleShot(True)
        self._later.timeout.connect(self._say_kept)
        self.lineEdit().textChanged.connect(self._colour)
        self.valueChanged.connect(self._colour)

    def keyPressEvent(self, event):
        """Say what is allowed, or take the key."""
        enters = event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)
        if not enters or self.hasAcceptableInput():
            super().keyPressEvent(event)
        else:
            self._say(self._allowed())

    def focusInEvent(self, event):
        """Note the number, to which a text that is not allowed will be set back."""
        if event.reason() != QtCore.Qt.PopupFocusReason:
            self._before = self.value()
        super().focusInEvent(event)

    def focusOutEvent(self, event):
        """Set a text that is not allowed back to the number from before, and say so."""
        wrong = not self.hasAcceptableInput() and event.reason() != QtCore.Qt.PopupFocusReason
        super().focusOutEvent(event)
        if wrong:
            self.setValue(self._before)
            self._colour()  # a text that the field sets itself emits no signal
            self._later.start(0)

    def _say_kept(self):
        kept = tr("{number} is kept.").format(number=self.textFromValue(self.value()))
        self._say("%s %s" % (self._allowed(), kept))

    def _allowed(self):
        return tr("Not allowed: enter a number from {least} to {largest}.").format(
            least=self.textFromValue(self.minimum()), largest=self.textFromValue(self.maximum())
        )

    def _say(self, text):
        if self.isVisible():
            place = self.mapToGlobal(self.rect().bottomLeft())
            QtWidgets.QToolTip.showText(place, text, self)

    def _colour(self, *_):
        wrong = not self.hasAcceptableInput()
        if wrong != self._is_wrong:
            self._is_wrong = wrong
            self.lineEdit().setStyleSheet(ink.style(ink.WRONG, self) if wrong else "")


class SpinBox(NumberBox, QtWidgets.QSpinBox):
    """A whole number in a panel."""

    def validate(self, text, place):
        """Accept whole numbers within the range; anything else may become one."""
        state, *_ = super().validate(text, place)
        if state != QtGui.QValidator.Acceptable:
            state = QtGui.QValidator.Intermediate
        return state, text, place


class DoubleSpinBox(NumberBox, QtWidgets.QDoubleSpinBox):
    """A number in a panel."""
