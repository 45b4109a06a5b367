# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for numbers: with all their digits, in the units that the user set in FreeCAD.

FreeCAD's own field shows as many digits as the preferences say, often two, and rounds to them. A
tolerance of 0.001 degrees would be lost.
"""

import FreeCAD as App

from freecad.seamwright.document import expressions, units
from freecad.seamwright.gui.widgets.binding import Binding
from freecad.seamwright.gui.widgets.boxes import DoubleSpinBox, SpinBox
from freecad.seamwright.gui.widgets.forms import LEAST_WIDTH
from freecad.seamwright.gui.widgets.qt import QtGui, QtWidgets

#: The kinds of numbers: a length in mm, an angle in degrees, a number without a unit, a ratio that
#: is shown in percent.
LENGTH, ANGLE, PLAIN, PERCENT = "mm", "deg", "", "%"

#: All angles are shown in the unit of this one in degrees, so that they can be compared.
TYPICAL_DEG = 10.0


class Bindable:
    """A spin box whose number may be given by an expression of a property."""

    _binding = None
    _exact = _rounded = None

    def number(self):
        """Return the number; the one that was shown, as long as the user does not change it.

        A spin box rounds to its decimals, and shows the nearest number that it allows.
        """
        found = self.value()
        return self._exact if found == self._rounded else found

    def show_number(self, value):
        """Show a number, or the nearest one that is allowed."""
        self.setValue(min(max(value, self.minimum()), self.maximum()))
        self._rounded, self._exact = self.value(), value

    def bind(self, obj, name):
        """Let the field be that of a property of an object."""
        self._binding = Binding(self, obj, name, self.unit)

    @property
    def is_bound(self):
        """Whether an expression gives the number."""
        return self._binding is not None and self._binding.shown is not None

    def show_expression(self):
        """Show the expression of the property, where there is one, and its number.

        Returns whether it is another one than before.
        """
        if self._binding is None:
            return False
        changed = self._binding.refresh()
        number = self._binding.number()
        if number is not None:
            self.show_number(number)
        return changed

    def suggest(self, value):
        """Show a number, unless an expression gives it; return whether it is shown."""
        if not self.is_bound:
            self.show_number(value)
        return not self.is_bound


class CountBox(Bindable, SpinBox):
    """A whole number."""

    unit = PLAIN


class NumberField(Bindable, DoubleSpinBox):
    """``number`` is in mm or degrees. The text has any unit, or a formula such as 2 * 5 um.

    With an object, it may also be an expression that names what FreeCAD finds from there, such as
    Spreadsheet.width; it is computed once.
    """

    def __init__(self, unit, largest, least=0.0, refer_to=None):
        super().__init__()
        self.unit = PLAIN if unit == PERCENT else unit
        self._percent = unit == PERCENT
        self._obj = refer_to
        self.setDecimals(9)
        self.setRange(least, largest)
        self.setMinimumWidth(LEAST_WIDTH)  # a narrow dock cuts off long numbers, not the field
        self.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)

    def bind(self, obj, name):
        """Let the field be that of a property of an object."""
        self._obj = obj
        super().bind(obj, name)

    def _shown_in(self):
        """Return (mm or degrees of one shown unit, its name)."""
        if self.unit == PLAIN:
            return (0.01, "%") if self._percent else (1.0, "")
        if self.unit == LENGTH:
            name, factor = units.length()
            return factor, name
        _, factor, name = App.Units.Quantity(TYPICAL_DEG, App.Units.Angle).getUserPreferred()
        return factor, name

    def textFromValue(self, value):
        """Return at most nine significant digits, with the decimal point of the language."""
        factor, name = self._shown_in()
        number = ("%.9g" % (value / factor)).replace(".", str(self.locale().decimalPoint()))
        return number + (name if name == "\u00b0" else (" " + name).rstrip())

    def _parsed(self, text):
        """Return the number of a text. Raises ValueError for anything else."""
        text = text.strip().replace(str(self.locale().decimalPoint()), ".")
        factor = 1.0
        if self._percent:
            text, factor = text.removesuffix("%").strip(), self._shown_in()[0]
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
            if self._obj is None:
                raise ValueError(str(error)) from None
            return factor * expressions.evaluated(self._obj, text.lstrip("="), self.unit)
        if found.Unit != App.Units.Quantity("1 " + self.unit if self.unit else "1").Unit:
            raise ValueError("not in %s" % self.unit)
        return factor * float(found.Value)

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
