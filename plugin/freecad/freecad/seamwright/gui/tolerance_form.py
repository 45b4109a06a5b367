# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input fields for level and tolerances."""

from freecad.seamwright.document import analysis
from freecad.seamwright.gui.qt import QtCore, QtWidgets

#: property, label, unit shown behind the number, largest value
FIELDS = (
    ("GapTolerance", "Gap", " mm", 1e6),
    ("AngleTolerance", "Angle", "\u00b0", 90.0),
    ("CurvatureTolerance", "Curvature (relative)", "", 1.0),
    ("CreaseAngle", "Crease above", "\u00b0", 90.0),
    ("FlatRadius", "Flat above radius", " mm", 1e12),
)


class NumberField(QtWidgets.QDoubleSpinBox):
    """A number that is written with as many digits as it has, not with a fixed count."""

    def __init__(self, unit, largest):
        super().__init__()
        self.setDecimals(9)
        self.setRange(0.0, largest)
        self.setSuffix(unit)
        self.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)

    def textFromValue(self, value):
        """At most nine significant digits, with the decimal point of the language."""
        return ("%.9g" % value).replace(".", str(self.locale().decimalPoint()))


class ToleranceForm(QtWidgets.QWidget):
    """Fields for the tolerances of an analysis; nothing is written before ``write_to``."""

    changed = QtCore.Signal()

    def __init__(self):
        super().__init__()
        layout = QtWidgets.QFormLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.level = QtWidgets.QComboBox()
        self.level.addItems(analysis.LEVELS)
        self.level.currentIndexChanged.connect(lambda *_: self.changed.emit())
        layout.addRow("Level", self.level)
        self.fields = {}
        tips = {name: tip for name, *_, tip in analysis.TOLERANCES}
        for name, label, unit, largest in FIELDS:
            field = NumberField(unit, largest)
            field.setToolTip(tips[name])
            field.valueChanged.connect(lambda *_: self.changed.emit())
            self.fields[name] = field
            layout.addRow(label, field)

    def read_from(self, obj):
        """Show the tolerances of an analysis."""
        self.level.setCurrentText(obj.Level)
        for name, field in self.fields.items():
            value = getattr(obj, name)
            field.setValue(getattr(value, "Value", value))

    def differs_from(self, obj):
        """Whether a field says something else than the analysis."""
        values = {name: getattr(obj, name) for name in self.fields}
        return self.level.currentText() != obj.Level or any(
            getattr(value, "Value", value) != self.fields[name].value() for name, value in values.items()
        )

    def write_to(self, obj):
        """Set the tolerances of an analysis as the fields say."""
        if obj.Level != self.level.currentText():
            obj.Level = self.level.currentText()
        for name, field in self.fields.items():
            value = getattr(obj, name)
            if getattr(value, "Value", value) != field.value():
                setattr(obj, name, field.value())
