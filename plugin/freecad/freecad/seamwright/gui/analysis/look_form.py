# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields for what the view shows of an analysis, besides the filter of the table."""

from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets.boxes import ComboBox, SpinBox
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import summary
from freecad.seamwright.plain.language import tr


class Field(QtWidgets.QWidget):
    """A widget with its name."""

    def __init__(self, text, widget):
        super().__init__()
        line = QtWidgets.QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(QtWidgets.QLabel(text))
        line.addWidget(widget, 1)


class LookForm(QtWidgets.QWidget):
    """``changed`` is emitted with the name of a view property and its new value."""

    changed = QtCore.Signal(str, object)

    def __init__(self):
        super().__init__()
        self.colours, self.labels = ComboBox(), SpinBox()
        for name in summary.COLOURS:
            self.colours.addItem(tr(name), name)
        self.colours.setToolTip(tr("What the colours of the seams in the view show"))
        self.colours.activated.connect(
            lambda *_: self.changed.emit("ColourBy", self.colours.currentData())
        )
        self.labels.setRange(0, seam_view.LABELLED_MOST)
        self.labels.setSpecialValueText(tr("none"))
        self.labels.setToolTip(
            tr(
                "At how many of the worst seams that are shown the largest figure is written. It "
                "is always written at the seams of the selected rows."
            )
        )
        self.labels.valueChanged.connect(lambda number: self.changed.emit("WorstLabels", number))
        line = FlowLayout(self)
        for text, widget in ((tr("Colours"), self.colours), (tr("Label the worst"), self.labels)):
            line.add(Field(text, widget), 1)

    def show_look(self, vobj):
        """Show the properties of a view."""
        self.colours.setCurrentIndex(self.colours.findData(vobj.ColourBy))
        self.labels.setValue(vobj.WorstLabels)
