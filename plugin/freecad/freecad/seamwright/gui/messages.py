# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages to the user: in the report view, and in a box that blocks nothing."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui.qt import QtCore, QtWidgets

TITLE = "Seamwright"


def show_error(text):
    """Write the text to the report view and show it."""
    App.Console.PrintError("%s: %s\n" % (TITLE, text))
    _show(QtWidgets.QMessageBox.Warning, text)


def show_note(text):
    """Write the text to the report view and show it."""
    App.Console.PrintMessage("%s: %s\n" % (TITLE, text))
    _show(QtWidgets.QMessageBox.Information, text)


def _show(icon, text):
    box = QtWidgets.QMessageBox(icon, TITLE, text, QtWidgets.QMessageBox.Ok, Gui.getMainWindow())
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()
