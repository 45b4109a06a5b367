# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands of the workbench have in common."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui import icon_path, messages
from freecad.seamwright.plain import kernel


class Command:
    """A command; a subclass says what it is called and does it."""

    name = menu = tip = icon = ""

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {"MenuText": self.menu, "ToolTip": self.tip, "Pixmap": icon_path(self.icon)}

    def IsActive(self):
        """Whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Do it; errors are told to the user."""
        raise NotImplementedError


def begin(doc, step, make):
    """The object that ``make()`` creates, in a step that stays open for its panel; None where the
    kernel is missing."""
    Gui.getDocument(doc.Name).resetEdit()
    doc.openTransaction(step)
    try:
        obj = make()
    except kernel.KernelUnavailable as error:
        doc.abortTransaction()
        messages.show_error(str(error))
        return None
    Gui.Selection.clearSelection()
    return obj


def open_new(obj):
    """Open the panel of what ``begin`` returned; its creation belongs to the panel's step: Cancel
    removes it."""
    if obj is None:
        return
    obj.ViewObject.Proxy.created = True
    Gui.getDocument(obj.Document.Name).setEdit(obj.Name)
