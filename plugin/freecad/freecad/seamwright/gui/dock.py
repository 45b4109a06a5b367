# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that holds a task panel."""

import FreeCADGui as Gui

from freecad.seamwright.gui.qt import QtCore, QtWidgets


def dock_of(form):
    """The dock around a form; None where it is not shown."""
    dock = form.parentWidget()
    while dock is not None and not isinstance(dock, QtWidgets.QDockWidget):
        dock = dock.parentWidget()
    return dock


def widen_dock(form, width):
    """Make the dock around a form so wide, in pixels, if the window has room and it is not wider
    already."""
    dock = dock_of(form)
    window = Gui.getMainWindow()
    wanted = min(width, window.width() * 2 // 5)
    if (
        dock is None
        or dock.isFloating()
        or window.dockWidgetArea(dock) == QtCore.Qt.NoDockWidgetArea
    ):
        return  # from 1.1 on FreeCAD lays panels over the view, as wide as the user wants them
    if dock.width() < wanted:
        window.resizeDocks([dock], [wanted], QtCore.Qt.Horizontal)
