# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences of the workbench: their names, defaults and the values that are allowed."""

import math
import numbers
from typing import Any, NamedTuple

from freecad.seamwright.plain import palette, profiles
from freecad.seamwright.plain.language import mark, tr

STANDARD = profiles.PROFILES["default"]

#: Prefix of the name of a colour.
COLOUR = "Colour"


class Preference(NamedTuple):
    """One preference; a number lies between ``least`` and ``largest``.

    ``argument``: of the kernel, if it is a tolerance.
    """

    name: str
    default: Any
    label: str
    least: float = -math.inf
    largest: float = math.inf
    argument: str = ""


TOLERANCES = (
    Preference("GapTolerance", STANDARD["gap_mm"], mark("Gap tolerance"), 1e-9, 1e6, "gap_mm"),
    Preference("AngleTolerance", STANDARD["angle_deg"], mark("Angle tolerance"),
               1e-9, 90.0, "angle_deg"),
    Preference("CurvatureTolerance", STANDARD["curvature_rel"], mark("Curvature tolerance"),
               1e-9, 1.0, "curvature_rel"),
    Preference("FlatRadius", STANDARD["flat_radius_mm"], mark("Flat above radius"),
               1e-3, 1e12, "flat_radius_mm"),
    Preference("CreaseAngle", STANDARD["crease_deg"], mark("Crease angle"),
               1e-9, 90.0, "crease_deg"),
)  # fmt: skip

THREADS = Preference("Threads", 0, mark("Threads"), 0, 256)
COMB_LINES = Preference("CombLines", 40, mark("Lines of a comb"), 2, 1000)
ZEBRA_STRIPES = Preference("ZebraStripes", 16, mark("Zebra stripes on a ball"), 2, 200)
LIVE_PREVIEW = Preference("LivePreview", True, mark("Preview while fields are changed"))

#: Red, green and blue in one number, as FreeCAD stores colours: 0xrrggbb00.
COLOURS = tuple(
    Preference(
        COLOUR + entry.key.capitalize(),
        palette.packed(entry.standard_rgb),
        entry.name,
        0,
        2**32 - 1,
    )
    for entry in (*palette.CLASSES, *palette.LEVELS)
)

ALL = (*TOLERANCES, THREADS, COMB_LINES, ZEBRA_STRIPES, LIVE_PREVIEW, *COLOURS)


def is_allowed(preference, value):
    """Return whether a preference can have this value."""
    if isinstance(preference.default, bool):
        return isinstance(value, bool)
    if not (isinstance(value, numbers.Real) and math.isfinite(value)):
        return False
    if isinstance(preference.default, int) and value != int(value):
        return False
    return preference.least <= value <= preference.largest


def check(values):
    """Raise ValueError for the first of {name: value} that is not allowed.

    ``values`` has all tolerances, since they depend on each other. Raises TypeError for another
    name.
    """
    known = {each.name: each for each in ALL}
    for name in values:
        if name not in known:
            raise TypeError("unknown preference %r: choose from %s" % (name, ", ".join(known)))
    for name, value in values.items():
        if not is_allowed(known[name], value):
            raise ValueError(_refused(known[name], value))
    if values["CreaseAngle"] <= values["AngleTolerance"]:
        raise ValueError(
            tr(
                "The crease angle, {crease:g}\u00b0, must be larger than the angle tolerance, "
                "{angle:g}\u00b0"
            ).format(crease=values["CreaseAngle"], angle=values["AngleTolerance"])
        )


def _refused(preference, value):
    name = tr(preference.label)
    if isinstance(preference.default, bool):
        return tr("{name} cannot be {value!r}: choose True or False").format(
            name=name, value=value
        )
    return tr("{name} cannot be {value}: choose from {least:g} to {largest:g}").format(
        name=name,
        value="%g" % value if isinstance(value, numbers.Real) else repr(value),
        least=preference.least,
        largest=preference.largest,
    )


def usable(stored):
    """Return {name: value} of all preferences for those that are stored.

    A value that is not allowed counts as not stored; so do all tolerances that contradict each
    other.
    """
    values = {
        each.name: stored[each.name] if is_allowed(each, stored[each.name]) else each.default
        for each in ALL
    }
    try:
        check(values)
    except ValueError:
        values.update({each.name: each.default for each in TOLERANCES})
    return values


def defaults():
    """Return {name: value} of all preferences as they are at first."""
    return {each.name: each.default for each in ALL}
