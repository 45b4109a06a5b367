# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that holds a task panel."""

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

    A dock that is wider already stays as it is.
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
        window.resizeDocks([dock], [wanted], QtCore.Qt.Horizontal)
