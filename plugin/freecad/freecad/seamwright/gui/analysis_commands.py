# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that draw analyses: combs, maps, lines, deviations, plots."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.document.maps import tool
from freecad.seamwright.document.maps.kinds import KINDS
from freecad.seamwright.document.maps.seam_plot import SeamPlot
from freecad.seamwright.document.maps.surface_map import SurfaceMap
from freecad.seamwright.gui.base.option_panel import sentence
from freecad.seamwright.gui.base.picked import picked
from freecad.seamwright.gui.command import Command, begin, open_new
from freecad.seamwright.gui.selected import picked_seams, visible_with_faces
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import inside, tr


class UseTool(Command):
    """Make a tool of one kind for the selection."""

    def __init__(self, kind):
        self.kind = kind
        self.name = "Seamwright_" + kind.Type
        self.menu, self.icon, self.tip = kind.LABEL, kind.ICON, kind.TIP

    def Activated(self):
        """Create the tool as one undoable step, and open its panel, which computes it.

        Where the selection is not usable, say why and change nothing.
        """
        doc = App.ActiveDocument
        try:
            chosen = self.kind.arranged(self._chosen(doc))
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return

        def make():
            obj = tool.prepare(self.kind, chosen)
            hide_others(obj)
            return obj

        open_new(begin(doc, tr("Make {label}").format(label=inside(self.kind.LABEL)), make))

    def _chosen(self, doc):
        chosen = picked_seams(doc) if self.kind is SeamPlot else picked()
        if chosen or not self.kind.TAKES_ALL:
            return chosen
        return [(obj, "") for obj in visible_with_faces(doc) if not tool.is_tool(obj)]


def hide_others(obj):
    """Hide the other maps on the faces of a new map: one face has the colours of one map."""
    if not isinstance(obj.Proxy, SurfaceMap):
        return
    coloured = {each for each, _ in tool.links_of(obj)}
    for other in obj.Document.Objects:
        if other != obj and tool.is_tool(other) and isinstance(other.Proxy, SurfaceMap):
            if coloured & {each for each, _ in tool.links_of(other)}:
                other.ViewObject.Visibility = False


def register():
    """Make the commands known to FreeCAD; return their names in the order of menu and toolbar."""
    commands = [UseTool(kind) for kind in KINDS.values()]
    for command in commands:
        Gui.addCommand(command.name, command)
    return [command.name for command in commands]
