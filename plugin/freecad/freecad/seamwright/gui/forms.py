# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels have in common: their form, their tables of seams, their buttons."""

from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.qt import QtGui, QtWidgets


def make_form(title, icon):
    """(widget with title and icon of a panel, its layout from top to bottom)."""
    form = QtWidgets.QWidget()
    form.setWindowTitle(title)
    form.setWindowIcon(QtGui.QIcon(icon_path(icon)))
    return form, QtWidgets.QVBoxLayout(form)


def make_box(title, content=None):
    """(group box with a title, its layout from top to bottom), which may hold a widget already."""
    box = QtWidgets.QGroupBox(title)
    layout = QtWidgets.QVBoxLayout(box)
    if content is not None:
        layout.addWidget(content)
    return box, layout


def make_text():
    """A label whose text is broken into lines."""
    label = QtWidgets.QLabel()
    label.setWordWrap(True)
    return label


def show_seams_in(table, height):
    """Let a table show a seam a line: whole lines are chosen, and it is at least so high, in
    pixels."""
    table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
    table.setAlternatingRowColors(True)
    table.setWordWrap(False)
    table.setMinimumHeight(height)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + 6)
    table.horizontalHeader().setHighlightSections(False)


def buttons(*names):
    """What getStandardButtons returns, for names such as "Ok"."""
    flags = QtWidgets.QDialogButtonBox.NoButton
    for name in names:
        flags = flags | getattr(QtWidgets.QDialogButtonBox, name)
    return flags if hasattr(flags, "value") else int(flags)  # PySide2 wants the number
