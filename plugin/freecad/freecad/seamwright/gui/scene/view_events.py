# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouse and keys over a 3D view, before FreeCAD gets them.

Callbacks of Coin's draggers end FreeCAD when they are written in Python, and the styles of
navigation use different buttons. So the mouse is taken from the widget of the view, and keys from
the window, which gets them whatever has the focus.
"""

import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets

#: Fields that use keys themselves.
TYPING = (QtWidgets.QLineEdit, QtWidgets.QAbstractSpinBox, QtWidgets.QTextEdit)

KEYS = (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease)


class ViewEvents(QtCore.QObject):
    """Passes mouse and keys to a tool until ``end`` is called.

    The tool has ``press(pixel)``, ``move(pixel, held)``, ``release(pixel)`` and ``key(name)``.
    Each returns whether the event ends there. ``key`` gets "escape", "enter", "backspace", "undo"
    or "redo"; only "escape" while the user types in a field.
    """

    def __init__(self, view, tool):
        super().__init__()
        self._tool = tool
        self._viewport = view.graphicsView().viewport()
        self._window = Gui.getMainWindow().windowHandle()
        self._is_down, self._taken = False, set()
        self._had_tracking = self._viewport.hasMouseTracking()
        self._viewport.setMouseTracking(True)
        for target in (self._viewport, self._window):
            target.installEventFilter(self)

    def end(self):
        """Let FreeCAD have all events again."""
        try:
            self._viewport.setMouseTracking(self._had_tracking)
            self._viewport.removeEventFilter(self)
        except RuntimeError:  # the view was closed
            pass
        self._window.removeEventFilter(self)

    def point_with(self, cursor):
        """Show a cursor over the view; None: the usual one."""
        if cursor is None:
            self._viewport.unsetCursor()
        else:
            self._viewport.setCursor(cursor)

    def eventFilter(self, target, event):
        """Return whether the event ends here."""
        kind = event.type()
        if target is self._window:
            return kind in KEYS and self._key(event)
        if kind == QtCore.QEvent.MouseMove:
            return bool(self._tool.move(_pixel(event), self._is_down)) or self._is_down
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            if event.button() == QtCore.Qt.LeftButton:
                self._is_down = bool(self._tool.press(_pixel(event)))
                return self._is_down
        if kind == QtCore.QEvent.MouseButtonRelease and event.button() == QtCore.Qt.LeftButton:
            was_down, self._is_down = self._is_down, False
            if was_down:
                self._tool.release(_pixel(event))
            return was_down
        return False

    def _key(self, event):
        name = _name_of(event)
        if name is None or (name != "escape" and _is_typing()):
            return False
        if event.type() == QtCore.QEvent.ShortcutOverride:
            wanted = self._tool.wants(name)
            if wanted:
                event.accept()
            return wanted
        if event.type() == QtCore.QEvent.KeyRelease:
            taken = event.key() in self._taken
            self._taken.discard(event.key())
            return taken
        taken = bool(self._tool.key(name))
        if taken:
            self._taken.add(event.key())
        return taken


def _pixel(event):
    place = event.pos()
    return place.x(), place.y()


def _is_typing():
    return isinstance(QtWidgets.QApplication.focusWidget(), TYPING)


def _name_of(event):
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
