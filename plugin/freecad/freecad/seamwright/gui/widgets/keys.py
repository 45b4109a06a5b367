# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys that are taken from the window, whatever has the focus in it."""

import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets

KEYS = (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease)

#: Fields that use keys themselves.
TYPING = (QtWidgets.QLineEdit, QtWidgets.QAbstractSpinBox, QtWidgets.QTextEdit,
          QtWidgets.QPlainTextEdit)  # fmt: skip

#: The keys of a panel.
OF_PANEL = ("escape", "undo", "redo")


def name_of(event):
    """Return "escape", "enter", "backspace", "undo" or "redo"; None for another key."""
    qt = QtCore.Qt
    plain = {
        qt.Key_Escape: "escape",
        qt.Key_Return: "enter",
        qt.Key_Enter: "enter",
        qt.Key_Backspace: "backspace",
    }
    if event.key() in plain:
        return plain[event.key()]
    modifiers = event.modifiers()
    if not modifiers & qt.ControlModifier:
        return None
    if event.key() == qt.Key_Z:
        return "redo" if modifiers & qt.ShiftModifier else "undo"
    return "redo" if event.key() == qt.Key_Y else None


def is_typing():
    """Return whether a field that uses keys itself has the focus."""
    return isinstance(QtWidgets.QApplication.focusWidget(), TYPING)


class PanelKeys(QtCore.QObject):
    """Gives Esc, undo and redo to ``panel.key(name)`` until the form of the panel is deleted.

    ``keys``: which of them the panel takes.

    FreeCAD does not get them: its view ends the editing at Esc, and its undo takes the whole object
    back. A text field outside of the panel keeps its keys.
    """

    def __init__(self, panel, keys=OF_PANEL):
        super().__init__(panel.form)
        self._panel, self._keys, self._taken = panel, keys, set()
        Gui.getMainWindow().windowHandle().installEventFilter(self)

    def eventFilter(self, window, event):
        """Return whether the event ends here."""
        if event.type() not in KEYS:
            return False
        name = name_of(event)
        if name not in self._keys:
            return False
        if event.type() == QtCore.QEvent.KeyRelease:
            taken = event.key() in self._taken
            self._taken.discard(event.key())
            return taken
        if self._panel.ended or self._is_typing_elsewhere():
            return False
        if event.type() == QtCore.QEvent.ShortcutOverride:
            event.accept()
        else:
            self._taken.add(event.key())
            QtCore.QTimer.singleShot(0, lambda: self._pass(name))
        return True

    def _pass(self, name):
        if not self._panel.ended:
            self._panel.key(name)

    def _is_typing_elsewhere(self):
        focus = QtWidgets.QApplication.focusWidget()
        return is_typing() and not self._panel.form.isAncestorOf(focus)
