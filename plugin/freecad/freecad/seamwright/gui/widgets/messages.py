# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages to the user: in the report view, and in a box that does not block."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets

TITLE = "Seamwright"

STATUS_MS = 10000


def show_error(text):
    """Show what the user has to do otherwise.

    The report view lists it as a message: it would open for an error, and move the 3D view.
    """
    App.Console.PrintMessage("%s: %s\n" % (TITLE, text))
    _show(QtWidgets.QMessageBox.Warning, text)


def show_notice(text):
    """Show a result that is not an error, such as a hole that is not filled."""
    App.Console.PrintMessage("%s: %s\n" % (TITLE, text))
    _show(QtWidgets.QMessageBox.Information, text)


def say(text):
    """Show a text that needs no answer, in the report view and the status bar."""
    App.Console.PrintMessage("%s: %s\n" % (TITLE, text))
    Gui.getMainWindow().statusBar().showMessage(text, STATUS_MS)


def _show(icon, text):
    box = QtWidgets.QMessageBox(icon, TITLE, text, QtWidgets.QMessageBox.Ok, Gui.getMainWindow())
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()


def ask(text, yes, no, answered):
    """Ask a question; ``answered(yes)`` is called with whether the answer was the text ``yes``.

    With Cancel nothing is called.
    """
    box = QtWidgets.QMessageBox(
        QtWidgets.QMessageBox.Question, TITLE, text, QtWidgets.QMessageBox.Cancel,
        Gui.getMainWindow(),
    )  # fmt: skip
    buttons = {
        box.addButton(yes, QtWidgets.QMessageBox.AcceptRole): True,
        box.addButton(no, QtWidgets.QMessageBox.DestructiveRole): False,
    }
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    for button, is_yes in buttons.items():
        button.clicked.connect(
            lambda *_, is_yes=is_yes: QtCore.QTimer.singleShot(0, lambda: answered(is_yes))
        )
    box.setDefaultButton(next(iter(buttons)))
    box.open()
