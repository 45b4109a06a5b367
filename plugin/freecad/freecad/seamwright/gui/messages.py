# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors told to the user: in the report view, and in a box that blocks nothing."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui.qt import QtCore, QtWidgets

TITLE = "Seamwright"


def show_error(text):
    """Write the text to the report view and show it."""
    App.Console.PrintError("%s: %s\n" % (TITLE, text))
    box = QtWidgets.QMessageBox(
        QtWidgets.QMessageBox.Warning, TITLE, text, QtWidgets.QMessageBox.Ok, Gui.getMainWindow()
    )
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
