# SPDX-License-Identifier: LGPL-2.1-or-later
"""The units that the user set in FreeCAD."""

import FreeCAD as App

from freecad.seamwright.plain import lengths

#: All lengths are shown in the unit of this one in mm, so that they can be compared.
TYPICAL_MM = 10.0


def length():
    """Return the Unit of lengths."""
    _, factor, name = App.Units.Quantity(TYPICAL_MM, App.Units.Length).getUserPreferred()
    return lengths.Unit(name, factor)


def use():
    """Let tables show lengths in the unit of the user."""
    lengths.ask(length)
