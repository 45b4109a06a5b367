# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that make curves."""

from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.curves.kinds import KINDS
from freecad.seamwright.gui import make_command


class MakeCurve(make_command.Make):
    """Make a curve of one kind from the selection."""

    def maker(self, chosen):
        """Return a callable() that adds the curve; of picked points where nothing is chosen."""
        given = {}
        if chosen or not self.kind.PICKS:
            given = curve.suggested(self.kind, chosen)
        return lambda: curve.prepare(self.kind, chosen, **given)


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    return make_command.register([MakeCurve(kind) for kind in KINDS.values()])
