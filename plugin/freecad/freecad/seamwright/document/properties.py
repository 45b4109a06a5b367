# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common properties of the workbench's document objects: tolerances and read-only results."""

import math

import FreeCAD as App

from freecad.seamwright.plain import options, profiles
from freecad.seamwright.plain.language import mark, tr

#: property, argument of the kernel, property type, default, help
TOLERANCES = (
    ("GapTolerance", "gap_mm", "App::PropertyLength", 0.01,
     "Largest distance between the two sides of a seam that meets G0, in mm"),
    ("AngleTolerance", "angle_deg", "App::PropertyAngle", 0.1,
     "Largest angle between the tangent planes of a seam that meets G1, in degrees"),
    ("CurvatureTolerance", "curvature_rel", "App::PropertyFloat", 0.02,
     "Largest relative difference of curvature of a seam that meets G2; 0.02 is 2 %"),
    ("FlatRadius", "flat_radius_mm", "App::PropertyLength", 1e5,
     "A side counts as flat if all its radii of curvature are larger than this, in mm"),
    ("CreaseAngle", "crease_deg", "App::PropertyAngle", 5.0,
     "A seam counts as an intended crease if its angle is larger than this, in degrees"),
)  # fmt: skip

# Values of the property Outcome: how the last computation ended.
DONE, WITHOUT, CANCELLED, OUTDATED = "done", "without result", "cancelled", "outdated"

#: The meaning of each outcome for the user; "" where the Summary tells it.
OUTCOMES = {
    DONE: "",
    WITHOUT: "",
    CANCELLED: mark("Cancelled; there are no results yet."),
    OUTDATED: mark("Cancelled; the results are those of the last complete run."),
}

# Attributes of App::DocumentObject.addProperty.
READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8


class Adder:
    """Adds the properties that an object lacks; existing properties keep their values."""

    def __init__(self, obj):
        self._obj = obj
        self._present = set(obj.PropertiesList)

    def add(self, kind, name, group, tip, attributes=0):
        """Add one property; return True when it is new."""
        if name in self._present:
            return False
        self._obj.addProperty(kind, name, group, tip, attributes)
        return True

    def add_with(self, kind, name, group, tip, default):
        """Add one property with a default value."""
        if self.add(kind, name, group, tip):
            setattr(self._obj, name, default)

    def add_choice(self, name, group, tip, choices, default):
        """Add one property that has one of several values.

        A property of an older version gets the values that it lacks.
        """
        if self.add("App::PropertyEnumeration", name, group, tip):
            setattr(self._obj, name, list(choices))
            setattr(self._obj, name, default)
        elif self._obj.getEnumerationsOfProperty(name) != list(choices):
            kept = getattr(self._obj, name)
            setattr(self._obj, name, list(choices))
            setattr(self._obj, name, kept)

    def add_options(self, table, group):
        """Add the properties of a table of plain.options.Option, with their defaults."""
        for option in table:
            if option.kind == options.CHOICE:
                self.add_choice(option.name, group, option.tip, option.choices, option.default)
            else:
                self.add_with(option.kind, option.name, group, option.tip, option.default)

    def add_tolerances(self, table):
        """Add the properties of a table such as ``TOLERANCES``."""
        for name, _, kind, default, tip in table:
            self.add_with(kind, name, "Tolerances", tip, default)

    def add_results(self, shown, internal):
        """Add read-only properties, shown and internal, from tables of (name, kind, tip)."""
        for name, kind, tip in shown:
            self.add(kind, name, "Result", tip, READ_ONLY | OUTPUT)
        for name, kind, tip in internal:
            self.add(kind, name, "Internal", tip, READ_ONLY | HIDDEN | OUTPUT)


def number(obj, name):
    """Return the value of a property as a number, in mm or degrees where it has a unit."""
    value = getattr(obj, name)
    return float(getattr(value, "Value", value))


def arguments(obj, table):
    """Return the tolerances of an object as arguments of the kernel."""
    return {argument: number(obj, name) for name, argument, *_ in table}


def checked(given, table, choices):
    """Return {property: value} for tolerances that are given as arguments of the kernel.

    ``given`` may also have the key ``profile``. ``choices``: {argument: (property, allowed values)}
    of the arguments that are not numbers. Raises TypeError for another name, ValueError for another
    value.
    """
    given = dict(given)
    names = {argument: name for name, argument, *_ in table}
    values = {}
    for argument, value in {**_of_profile(given.pop("profile", None), names), **given}.items():
        if argument in choices:
            name, allowed = choices[argument]
            if value not in allowed:
                raise ValueError("%s %r: choose one of %s" % (argument, value, ", ".join(allowed)))
            values[name] = value
        elif argument in names:
            values[names[argument]] = _not_negative(argument, value)
        else:
            raise TypeError("unknown tolerance %r" % argument)
    return values


def checked_numbers(argument, given):
    """Return a list of lengths for a number, a list of numbers, or None.

    Raises ValueError for a number that is negative or not finite.
    """
    numbers = [] if given is None else list(given) if isinstance(given, (list, tuple)) else [given]
    return [_not_negative("%s[%d]" % (argument, at), value) for at, value in enumerate(numbers)]


def _not_negative(argument, value):
    number = options.as_number(argument, value)
    if not (number >= 0 and math.isfinite(number)):
        raise ValueError("%s = %r: must be a finite number, not negative" % (argument, value))
    return number


def _of_profile(profile, names):
    """Return the tolerances of a profile that are in ``names``.

    Returns none of them where the profile is None, so that the properties keep their defaults.
    """
    if profile is None:
        return {}
    if profile not in profiles.PROFILES:
        raise ValueError("profile %r: choose one of %s" % (profile, ", ".join(profiles.PROFILES)))
    return {
        argument: value
        for argument, value in profiles.PROFILES[profile].items()
        if argument in names
    }


def error_text(obj):
    """Return why the last computation has no result; "" where it has one."""
    if "Invalid" in obj.State:
        return obj.getStatusString()
    outcome = getattr(obj, "Outcome", "")
    if outcome == WITHOUT:
        return obj.Summary
    meaning = OUTCOMES.get(outcome, "")
    return tr(meaning) if meaning else ""


def plain(value):
    """Return the value of a property in a form to compare: lengths as numbers, links as names."""
    if hasattr(value, "Value"):
        return float(value.Value)
    if hasattr(value, "Name"):
        return value.Name
    if isinstance(value, (list, tuple, App.Vector)):
        return [plain(each) for each in value]
    return value


def differing(obj, values):
    """Return those entries of {property: value} whose values differ from those of the object."""
    return {
        name: value for name, value in values.items() if plain(getattr(obj, name)) != plain(value)
    }
