# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input fields of a table of options; numbers may be given by expressions."""

import re

from freecad.seamwright.document import expressions
from freecad.seamwright.gui.widgets import ink
from freecad.seamwright.gui.widgets.boxes import ComboBox
from freecad.seamwright.gui.widgets.forms import Label
from freecad.seamwright.gui.widgets.number_field import (
    ANGLE,
    LENGTH,
    PERCENT,
    PLAIN,
    CountBox,
    NumberField,
)
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import options
from freecad.seamwright.plain.language import description, tr

UNITS = {options.LENGTH: LENGTH, options.ANGLE: ANGLE}

LARGEST = 1e9

#: Letters of a choice that a narrow panel still shows.
LEAST_LETTERS = 9


class Field(QtCore.QObject):
    """The widget of one option of an object; ``changed`` is emitted when its value changes."""

    changed = QtCore.Signal()

    #: Whether the form shows it.
    is_shown = True

    def __init__(self, obj, option):
        super().__init__()
        self.option = option
        self.label = Label(tr(option.label))
        self.widget = self._make(obj)
        for each in (self.label, self.widget):
            each.setToolTip(description(option.tip))

    def _make(self, obj):
        raise NotImplementedError

    def value(self):
        """Return the value of the field. Raises ValueError where there is none."""
        raise NotImplementedError

    def last_value(self):
        """Return the value of the field, or its last one where it has none."""
        return self.value()

    def show_value(self, value):
        """Show a value."""
        raise NotImplementedError

    def show_expression(self):
        """Show the expression that gives the value; return whether it is another than before."""
        return False

    def _emit(self, *_):
        self.changed.emit()


class QuantityField(Field):
    """A length, an angle or a plain number, which may be given by an expression."""

    def _make(self, obj):
        least = max(self.option.least, -LARGEST)
        return self._bound(NumberField(self._unit(), LARGEST, least), obj)

    def _unit(self):
        return PERCENT if self.option.percent else UNITS.get(self.option.kind, PLAIN)

    def _bound(self, widget, obj):
        widget.setSpecialValueText(tr(self.option.zero) if self.option.zero else "")
        widget.bind(obj, self.option.name)
        widget.valueChanged.connect(self._emit)
        return widget

    def value(self):
        """Return the number, in mm or degrees."""
        return self.widget.number()

    def show_value(self, value):
        """Show a number, and the expression that gives it."""
        self.widget.show_number(value)
        self.widget.show_expression()

    def show_expression(self):
        """Show the expression that gives the number; return whether it is another than before."""
        return self.widget.show_expression()

    def drag(self, value):
        """Show a number that the user drags, unless an expression gives it; return whether."""
        return self.widget.suggest(max(float("%.4g" % value), self.option.least))


class CountField(QuantityField):
    """A whole number, which may be given by an expression."""

    def _make(self, obj):
        widget = CountBox()
        widget.setRange(int(max(self.option.least, 0)), options.MOST)
        return self._bound(widget, obj)


class FlagField(Field):
    """A choice between yes and no."""

    def _make(self, obj):
        widget = QtWidgets.QCheckBox()
        widget.toggled.connect(self._emit)
        return widget

    def value(self):
        """Return whether the box is checked."""
        return self.widget.isChecked()

    def show_value(self, value):
        """Check the box or not."""
        self.widget.setChecked(bool(value))


class ChoiceField(Field):
    """One of several texts."""

    def _make(self, obj):
        widget = ComboBox()
        for choice in self.option.choices:
            widget.addItem(tr(choice), choice)
        widget.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        widget.setMinimumContentsLength(LEAST_LETTERS)
        widget.currentIndexChanged.connect(self._emit)
        return widget

    def value(self):
        """Return the text."""
        return self.widget.currentData()

    def show_value(self, value):
        """Show a text."""
        self.widget.setCurrentIndex(self.widget.findData(value))


class NumbersField(Field):
    """Numbers in one line, such as 0; 0; 50. A text that is no list of numbers is red.

    Between semicolons there may be expressions; they are computed once.
    """

    def _make(self, obj):
        self._obj, self._last = obj, self.option.default
        widget = QtWidgets.QLineEdit()
        widget.textChanged.connect(self._emit)
        widget.editingFinished.connect(self._show_computed)
        return widget

    def value(self):
        """Return the numbers."""
        try:
            numbers = self._numbers()
        except ValueError:
            self.widget.setStyleSheet(ink.style(ink.WRONG, self.widget))
            raise
        self.widget.setStyleSheet("")
        self._last = numbers
        return numbers

    def last_value(self):
        """Return the numbers of the last text that was a list of numbers."""
        try:
            return self.value()
        except ValueError:
            return self._last

    def _numbers(self):
        text = self.widget.text()
        try:
            return options.parse_numbers(text)
        except ValueError:
            found = [self._computed(each) for each in text.split(";")]
            if None in found:
                raise
            return found

    def _computed(self, text):
        """Return the number of an expression in mm, in degrees or without a unit, or None."""
        for unit in (LENGTH, ANGLE):
            try:
                return expressions.evaluated(self._obj, text.strip().lstrip("="), unit)
            except ValueError:
                pass
        return None

    def _show_computed(self):
        """Show the numbers instead of expressions."""
        if re.search(r"[^\W\d]|[*/()]", self.widget.text()):
            try:
                self.show_value(self._numbers())
            except ValueError:
                pass  # the text is red

    def show_value(self, value):
        """Show numbers."""
        self.widget.setText(options.numbers_text(value))


class VectorField(Field):
    """A vector or a list of vectors, which the view shows and not the form."""

    is_shown = False

    def _make(self, obj):
        self._value = self.option.default
        return QtWidgets.QLabel()

    def value(self):
        """Return the coordinates, or those of each vector."""
        return self._value

    def show_value(self, value):
        """Keep a value."""
        if value != self._value:
            self._value = value
            self._emit()


FIELDS = {
    options.LENGTH: QuantityField,
    options.ANGLE: QuantityField,
    options.FLOAT: QuantityField,
    options.COUNT: CountField,
    options.FLAG: FlagField,
    options.CHOICE: ChoiceField,
    options.NUMBERS: NumbersField,
    options.VECTOR: VectorField,
    options.VECTORS: VectorField,
}


class OptionForm(QtWidgets.QWidget):
    """Fields for the options of an object; those without an effect are hidden.

    The form changes no property, besides expressions; ``values`` returns the values of its fields.
    """

    changed = QtCore.Signal()

    def __init__(self, obj, table, first=None):
        """``first``: (name, widget) of another field, above those of the options."""
        super().__init__()
        layout = QtWidgets.QGridLayout(self)  # in a QFormLayout hidden rows leave gaps
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setColumnStretch(1, 1)
        self.fields, self._hidden = {}, ()
        if first is not None:
            layout.addWidget(Label(first[0]), 0, 0)
            layout.addWidget(first[1], 0, 1)
        for option in table:
            field = FIELDS[option.kind](obj, option)
            field.changed.connect(self._changed)
            self.fields[option.argument] = field
            layout.addWidget(field.label, layout.rowCount(), 0)
            layout.addWidget(field.widget, layout.rowCount() - 1, 1)

    def show_values(self, values):
        """Show these {argument: value}."""
        for argument, field in self.fields.items():
            field.show_value(values[argument])
        self._show_used()

    def show_expressions(self):
        """Show the expressions of the properties; return whether one is another than before."""
        return any([field.show_expression() for field in self.fields.values()])

    def hide(self, arguments):
        """Hide the fields of these arguments, besides those of options without an effect."""
        self._hidden = arguments
        self._show_used()

    def values(self):
        """Return the {property: value} of the fields. Raises ValueError for a bad text."""
        return {
            field.option.name: field.value()
            for field in self.fields.values()
            if self._is_used(field) or field.option.kind != options.NUMBERS
        }

    def _is_used(self, field):
        used = field.option.used
        return used is None or used(self._choices())

    def _choices(self):
        return {
            argument: field.value()
            for argument, field in self.fields.items()
            if field.option.kind in (options.CHOICE, options.FLAG)
        }

    def _show_used(self):
        for field in self.fields.values():
            used = self._is_used(field) and field.option.argument not in self._hidden
            used = used and field.is_shown
            field.label.setVisible(used)
            field.widget.setVisible(used)

    def _changed(self):
        self._show_used()
        self.changed.emit()
