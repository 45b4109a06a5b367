# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which tables show lengths: mm, unless the window says another one."""

from typing import Callable, NamedTuple

from freecad.seamwright.plain.language import tr


class Unit(NamedTuple):
    """A unit of length: its ``name``, and its length in mm."""

    name: str
    mm: float


MM = Unit("mm", 1.0)

#: A list of the one callable that returns the Unit of the moment.
_ask = [lambda: MM]


def ask(source: Callable[[], Unit]):
    """Let a callable say the unit each time that it is needed."""
    _ask[0] = source


def unit():
    """Return the Unit of the moment."""
    return _ask[0]()


def shown(length_mm):
    """Return a length in the unit of the moment."""
    return length_mm / unit().mm


def titled(text):
    """Return the translation of a heading or of its tool tip, with the name of the unit in it."""
    return tr(text).format(unit=unit().name)
