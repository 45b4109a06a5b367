# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that make curves."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.curves.kinds import KINDS
from freecad.seamwright.gui.command import Command, begin, open_new
from freecad.seamwright.gui.base.option_panel import sentence
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import kernel


class MakeCurve(Command):
    """Make a curve of one kind from the selection."""

    def __init__(self, kind):
        self.kind = kind
        self.name = "Seamwright_" + kind.Type
        self.menu, self.icon, self.tip = kind.LABEL, kind.ICON, kind.TIP

    def Activated(self):
        """Create the curve as one undoable step, and open its panel, which computes it.

        Where the selection is not usable, say why and change nothing.
        """
        doc, chosen = App.ActiveDocument, picked()
        try:
            given = curve.suggested(self.kind, chosen)
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        step = "Make %s" % self.kind.LABEL.lower()
        open_new(begin(doc, step, lambda: curve.prepare(self.kind, chosen, **given)))


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    commands = [MakeCurve(kind) for kind in KINDS.values()]
    for command in commands:
        Gui.addCommand(command.name, command)
    return [command.name for command in commands]
