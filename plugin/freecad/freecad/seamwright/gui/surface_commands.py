# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that make surfaces."""

from freecad.seamwright.document.surfaces import kinds
from freecad.seamwright.gui import make_command


class MakeSurface(make_command.Make):
    """Make a surface of one kind from the selection."""

    def maker(self, chosen):
        """Return a callable() that adds the surface."""
        arranged, given = kinds.arranged(self.kind, chosen)
        return lambda: kinds.prepare(self.kind, arranged, **given)


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    return make_command.register([MakeSurface(kind) for kind in kinds.KINDS.values()])
