# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input fields for level and tolerances."""

from freecad.seamwright.document import properties
from freecad.seamwright.gui.widgets.boxes import ComboBox
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.number_field import ANGLE, LENGTH, PERCENT, NumberField
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import profiles
from freecad.seamwright.plain.language import description, mark, tr

#: property, label, kind of number, largest value
FIELDS = (
    ("GapTolerance", mark("Gap"), LENGTH, 1e6),
    ("AngleTolerance", mark("Angle"), ANGLE, 90.0),
    ("CurvatureTolerance", mark("Curvature (relative)"), PERCENT, 1.0),
    ("CreaseAngle", mark("Crease above"), ANGLE, 90.0),
    ("FlatRadius", mark("Flat above radius"), LENGTH, 1e12),
    ("MatchDistance", mark("Match free edges within"), LENGTH, 1e6),
    ("CornerAngle", mark("Corner of a hole above"), ANGLE, 180.0),
    ("SectionTolerance", mark("Gap of patch to fillet"), LENGTH, 0.1),
)

#: The choices beside which the profiles stand.
CHOICES = (mark("Level"), mark("Target"))

#: Fields whose zero switches the function off.
OFF_AT_ZERO = ("MatchDistance",)

CUSTOM = mark("Custom")


class ToleranceForm(QtWidgets.QWidget):
    """Fields for the tolerances of an object, from a table of its module.

    The form changes no object, besides the expressions of its properties; ``values`` returns the
    values of its fields. ``choice``: (property for the level of continuity, its values), or None
    without one. ``obj``: the object, or None where the fields are no properties. ``level_apart``:
    ``level`` gets its place elsewhere in the panel.
    """

    changed = QtCore.Signal()

    def __init__(self, table, choice=None, obj=None, level_apart=False):
        super().__init__()
        self._level_name, levels = choice or ("", ())
        self._arguments = {name: argument for name, argument, *_ in table}
        layout = QtWidgets.QFormLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self.level = ComboBox()
        self.level.addItems(levels)
        self.level.currentIndexChanged.connect(lambda *_: self.changed.emit())
        profile = self._build_profile()
        if choice and not level_apart:
            first_line = FlowLayout()
            for widget, stretch in (
                (self.level, 1),
                (QtWidgets.QLabel(tr("Tolerances")), 0),
                (profile, 2),
            ):
                first_line.add(widget, stretch)
            layout.addRow(tr(self._level_name), first_line)
        else:
            layout.addRow(tr("Tolerances"), profile)
        self.fields = {}
        tips = {name: tip for name, *_, tip in table}
        for name, label, unit, largest in (field for field in FIELDS if field[0] in tips):
            field = NumberField(unit, largest)
            field.setToolTip(description(tips[name]))
            if name in OFF_AT_ZERO:
                field.setSpecialValueText(tr("off"))
            field.valueChanged.connect(self._field_changed)
            if obj is not None:
                field.bind(obj, name)
            self.fields[name] = field
            layout.addRow(tr(label), field)

    def _build_profile(self):
        self.profile = ComboBox()
        for name in profiles.PROFILES:
            self.profile.addItem(tr(profiles.LABELS[name][0]), name)
            tip = profiles.tip(name)
            self.profile.setItemData(self.profile.count() - 1, tip, QtCore.Qt.ToolTipRole)
        self.profile.addItem(tr(CUSTOM), None)
        self.profile.setToolTip(tr("Fill in the usual tolerances of one kind of work"))
        self.profile.activated.connect(self._profile_chosen)
        return self.profile

    def _profile_chosen(self, index):
        name = self.profile.itemData(index)
        if name is not None:
            for field_name, field in self.fields.items():
                values = profiles.PROFILES[name]
                field.suggest(values.get(self._arguments[field_name], field.number()))
        self._field_changed()  # choosing "Custom" changes nothing

    def _field_changed(self, *_):
        values = {self._arguments[name]: field.number() for name, field in self.fields.items()}
        self.profile.setCurrentIndex(self.profile.findData(profiles.name_of(values)))
        self.changed.emit()

    def read_from(self, obj):
        """Show the tolerances of an object."""
        if self._level_name:
            self.level.setCurrentText(getattr(obj, self._level_name))
        for name, field in self.fields.items():
            field.show_number(properties.number(obj, name))
            field.show_expression()
        self._field_changed()

    def show_expressions(self):
        """Show the expressions of the properties; return whether one is another than before."""
        return any([field.show_expression() for field in self.fields.values()])

    def show_values(self, values):
        """Show the tolerances of {property: value}, and the level if it is among them."""
        if self._level_name in values:
            self.level.setCurrentText(values[self._level_name])
        for name, field in self.fields.items():
            field.show_number(values[name])
        self._field_changed()

    def differs_from(self, obj):
        """Return whether the value of a field differs from that of the object."""
        return bool(properties.differing(obj, self.values()))

    def values(self):
        """Return the {property: value} of the fields."""
        level = {self._level_name: self.level.currentText()} if self._level_name else {}
        return {**level, **{name: field.number() for name, field in self.fields.items()}}
