# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the task panels: forms, tables of seams, buttons."""

import FreeCADGui as Gui

from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import lengths
from freecad.seamwright.plain.language import tr

#: Width of a field for a number in a narrow dock.
LEAST_WIDTH = 90


def make_form(title, icon):
    """Return (widget with title and icon of a panel, its vertical layout)."""
    form = QtWidgets.QWidget()
    form.setWindowTitle(title)
    form.setWindowIcon(Gui.getIcon(icon_path(icon)))
    return form, QtWidgets.QVBoxLayout(form)


def make_box(title, content=None):
    """Return (group box with a title, its vertical layout); ``content`` is put into the box."""
    box = QtWidgets.QGroupBox(title)
    layout = QtWidgets.QVBoxLayout(box)
    if content is not None:
        layout.addWidget(content)
    return box, layout


def make_show_line():
    """Return (line, buttons Before and After): what the view shows; After is chosen."""
    line = FlowLayout()
    line.add(QtWidgets.QLabel(tr("Show")))
    before = QtWidgets.QRadioButton(tr("Before"))
    after = QtWidgets.QRadioButton(tr("After"))
    after.setChecked(True)
    for widget in (before, after):
        line.add(widget)
    return line, before, after


def offer_after(before, after, there):
    """Let After be chosen while there is something to show, and choose it when that appears.

    Else Before is chosen.
    """
    if there != after.isEnabled():
        after.setEnabled(there)
        (after if there else before).setChecked(True)


class Label(QtWidgets.QLabel):
    """A text beside a field: in one line where there is room, else in several."""

    def __init__(self, text):
        super().__init__(text)
        self.setWordWrap(True)

    def sizeHint(self):
        """Return the size of the text in one line."""
        margins = self.contentsMargins()
        width = self.fontMetrics().boundingRect(self.text()).width() + 4
        return QtCore.QSize(width + margins.left() + margins.right(), super().sizeHint().height())


def make_text():
    """Return a label whose text is broken into lines."""
    label = QtWidgets.QLabel()
    label.setWordWrap(True)
    return label


def make_summary(lines=2):
    """Return a label for a text of about so many lines: what is below stays where it is."""
    label = make_text()
    label.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
    label.setText("\n".join("x" * lines))
    label.setMinimumHeight(label.sizeHint().height())
    label.clear()
    return label


def name_columns(table, columns):
    """Write headings and tool tips, (text, text) each, with the unit of lengths of the moment."""
    table.setHorizontalHeaderLabels([lengths.titled(heading) for heading, _ in columns])
    for column, (_, tip) in enumerate(columns):
        table.horizontalHeaderItem(column).setToolTip(lengths.titled(tip))


def show_seams_in(table, height):
    """Set up a table with one seam in each line.

    The user selects whole lines. ``height``: the minimum height in pixels.
    """
    table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
    table.setAlternatingRowColors(True)
    table.setWordWrap(False)
    table.setMinimumHeight(height)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + 6)
    table.horizontalHeader().setHighlightSections(False)


def buttons(*names):
    """Return the value for getStandardButtons, for names such as "Ok"."""
    flags = QtWidgets.QDialogButtonBox.NoButton
    for name in names:
        flags = flags | getattr(QtWidgets.QDialogButtonBox, name)
    return flags if hasattr(flags, "value") else int(flags)  # PySide2 needs the number
