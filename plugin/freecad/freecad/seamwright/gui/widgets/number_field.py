# SPDX-License-Identifier: LGPL-2.1-or-later
"""A field for a number that shows all its digits, in the units that the user set in FreeCAD.

FreeCAD's own field shows as many digits as the preferences say, often two, and rounds to them. A
tolerance of 0.001 degrees would be lost.
"""

import FreeCAD as App

from freecad.seamwright.gui.widgets.forms import LEAST_WIDTH
from freecad.seamwright.gui.widgets.qt import QtGui, QtWidgets
from freecad.seamwright.plain.language import tr

#: The kinds of numbers: a length in mm, an angle in degrees, a number without a unit, a ratio that
#: is shown in percent.
LENGTH, ANGLE, PLAIN, PERCENT = "mm", "deg", "", "%"

#: All lengths are shown in the unit of this one in mm, so that they can be compared.
TYPICAL = 10.0


class NumberField(QtWidgets.QDoubleSpinBox):
    """``value`` is in mm or degrees; the text has any unit, or a formula such as 2 * 5 um."""

    def __init__(self, unit, largest):
        super().__init__()
        self._unit = unit
        self._tip = ""
        self.setDecimals(9)
        self.setRange(0.0, largest)
        self.setMinimumWidth(LEAST_WIDTH)  # a narrow dock cuts off long numbers, not the field
        self.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)

    def _shown_in(self):
        """Return (mm or degrees of one shown unit, its name)."""
        if self._unit in (PLAIN, PERCENT):
            return (0.01, "%") if self._unit == PERCENT else (1.0, "")
        unit = App.Units.Length if self._unit == LENGTH else App.Units.Angle
        _, factor, name = App.Units.Quantity(TYPICAL, unit).getUserPreferred()
        return factor, name

    def textFromValue(self, value):
        """Return at most nine significant digits, with the decimal point of the language."""
        factor, name = self._shown_in()
        number = ("%.9g" % (value / factor)).replace(".", str(self.locale().decimalPoint()))
        return number + (name if name == "\u00b0" else (" " + name).rstrip())

    def _parsed(self, text):
        """Return the number of a text. Raises ValueError for anything else."""
        text = text.strip().replace(str(self.locale().decimalPoint()), ".")
        if self._unit == PERCENT:
            text = text.removesuffix("%").strip()
        try:
            number = float(text)
        except ValueError:
            pass
        else:
            return number * self._shown_in()[0]
        if not text:
            raise ValueError("no number")
        try:
            found = App.Units.Quantity(text)
        except (ValueError, OSError, SyntaxError, OverflowError) as error:
            raise ValueError(str(error)) from None
        unit = self._unit.removesuffix(PERCENT)
        if found.Unit != App.Units.Quantity("1 " + unit if unit else "1").Unit:
            raise ValueError("not in %s" % self._unit)
        return float(found.Value) * (1.0 if unit else self._shown_in()[0])

    def valueFromText(self, text):
        """Return the number of a text; that of the shown text is exact."""
        if text == self.textFromValue(self.value()):
            return self.value()
        try:
            return self._parsed(text)
        except ValueError:
            return self.value()

    def validate(self, text, place):
        """Accept numbers within the range; anything else may become one."""
        state = QtGui.QValidator.Intermediate
        if text and text == self.specialValueText():
            state = QtGui.QValidator.Acceptable
        else:
            try:
                if self.minimum() <= self._parsed(text) <= self.maximum():
                    state = QtGui.QValidator.Acceptable
            except ValueError:
                pass
        return state, text, place

    def show_expression(self, expression):
        """Let the field be read-only while an expression gives the number; None: it does not."""
        if self.isReadOnly() == (expression is not None):
            return
        if expression is None:
            self.setToolTip(self._tip)
        else:
            self._tip = self.toolTip()
            said = tr("Set by the expression {expression}").format(expression=expression)
            self.setToolTip("%s\n%s" % (self._tip, said))
        self.setReadOnly(expression is not None)
