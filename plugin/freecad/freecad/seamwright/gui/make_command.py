# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the commands that make an object with options from the selection."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.gui.base.option_panel import sentence
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.command import Command, begin, open_new
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import inside, tr


class Make(Command):
    """Make an object of one kind from the selection."""

    def __init__(self, kind):
        self.kind = kind
        self.name = "Seamwright_" + kind.Type
        self.menu, self.icon, self.tip = kind.LABEL, kind.ICON, kind.TIP

    def maker(self, chosen):
        """Return a callable() that adds the object for the links of a selection.

        Raises SourceError or ValueError where they are not usable.
        """
        raise NotImplementedError

    def Activated(self):
        """Create the object as one undoable step, and open its panel, which computes it.

        Where the selection is not usable, say why and change nothing.
        """
        doc = App.ActiveDocument
        try:
            make = self.maker(picked())
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        open_new(begin(doc, tr("Make {label}").format(label=inside(self.kind.LABEL)), make))


def register(commands):
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    for command in commands:
        Gui.addCommand(command.name, command)
    return [command.name for command in commands]
