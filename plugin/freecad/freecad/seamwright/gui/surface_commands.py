# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that make surfaces."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.document.surfaces import kinds
from freecad.seamwright.gui.base.option_panel import sentence
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.command import Command, begin, open_new
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import kernel


class MakeSurface(Command):
    """Make a surface of one kind from the selection."""

    def __init__(self, kind):
        self.kind = kind
        self.name = "Seamwright_" + kind.Type
        self.menu, self.icon, self.tip = kind.LABEL, kind.ICON, kind.TIP

    def Activated(self):
        """Create the surface as one undoable step, and open its panel, which computes it.

        Where the selection is not usable, say why and change nothing.
        """
        doc = App.ActiveDocument
        try:
            chosen, given = kinds.arranged(self.kind, picked())
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        step = "Make %s" % self.kind.LABEL.lower()
        open_new(begin(doc, step, lambda: kinds.prepare(self.kind, chosen, **given)))


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    commands = [MakeSurface(kind) for kind in kinds.KINDS.values()]
    for command in commands:
        Gui.addCommand(command.name, command)
    return [command.name for command in commands]
