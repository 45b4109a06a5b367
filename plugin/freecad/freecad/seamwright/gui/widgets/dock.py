# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that holds a task panel."""

from typing import Any, NamedTuple

import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets


def dock_of(form):
    """Return the dock around a form; None where the form is not shown in one."""
    dock = form.parentWidget()
    while dock is not None and not isinstance(dock, QtWidgets.QDockWidget):
        dock = dock.parentWidget()
    return dock


def widen_dock(form, width):
    """Widen the dock around a form to a width in pixels, as far as the window has room.

    A dock that is wider already stays as it is. When no panel is open any more, the dock gets its
    width back, unless the user gave it another one.
    """
    dock = dock_of(form)
    window = Gui.getMainWindow()
    wanted = min(width, window.width() * 2 // 5)
    if (
        dock is None
        or dock.isFloating()
        or window.dockWidgetArea(dock) == QtCore.Qt.NoDockWidgetArea
    ):
        return  # from 1.1 on, FreeCAD lays panels over the view; the user sets their width
    if dock.width() < wanted:
        first = _widened[0].before if _widened else dock.width()
        _widened[:] = [_Widened(dock, first, wanted)]
        window.resizeDocks([dock], [wanted], QtCore.Qt.Horizontal)
    form.destroyed.connect(lambda *_: QtCore.QTimer.singleShot(0, _narrow))


class _Widened(NamedTuple):
    """A dock, and its widths in pixels before and after the panels widened it."""

    dock: Any
    before: int
    after: int


#: The _Widened of the open panels, if there is one.
_widened = []

#: Qt may give a dock some pixels more or less.
SLACK_PX = 20


def _narrow():
    if not _widened or Gui.Control.activeDialog():
        return
    dock, before, after = _widened.pop()
    if abs(dock.width() - after) <= SLACK_PX:
        Gui.getMainWindow().resizeDocks([dock], [before], QtCore.Qt.Horizontal)
