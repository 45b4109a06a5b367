# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the workbench's commands."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import sources
from freecad.seamwright.gui import icon_path
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.plain import help_pages, kernel
from freecad.seamwright.plain.language import description, tr


class Command:
    """A command; a subclass gives its name and texts and defines what it does."""

    name = menu = tip = icon = ""

    def GetResources(self):
        """Return menu text, tool tip, texts of help and icon."""
        tip = description(self.tip)
        return {
            "MenuText": self.menu,
            "ToolTip": self.tip,
            "StatusTip": help_pages.first_sentence(tip),
            "WhatsThis": '%s <a href="%s">%s</a>' % (tip, self.CmdHelpURL(), tr("Help")),
            "Pixmap": icon_path(self.icon),
        }

    def CmdHelpURL(self):
        """Return the address of the section about the command."""
        return help_pages.address(help_pages.section_of(self.name))

    def IsActive(self):
        """Return whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Run the command; where the selection does not suit it, show why."""
        try:
            self.run(App.ActiveDocument)
        except (sources.SourceError, kernel.KernelUnavailable) as error:
            messages.show_error(str(error))

    def run(self, doc):
        """Run the command in the active document.

        Raises SourceError for an unsuitable object, KernelUnavailable without the compiled part.
        """
        raise NotImplementedError


def begin(doc, step, make):
    """Return the object that ``make()`` creates, in a transaction that stays open for its panel.

    Returns None where the kernel is missing.
    """
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
    """Open the panel of the object that ``begin`` returned.

    The creation belongs to the transaction of the panel, so Cancel removes the object.
    """
    if obj is None:
        return
    _tell_steps(obj)
    obj.ViewObject.Proxy.created = True
    Gui.getDocument(obj.Document.Name).setEdit(obj.Name)


def _tell_steps(obj):
    """Say which sources are earlier steps of a body, whose later steps do not count."""
    for source in obj.Proxy.source_objects(obj):
        if sources.in_body(source) and source.isDerivedFrom("PartDesign::Feature"):
            messages.say(
                tr(
                    "{step} is a step of {body}: later steps do not count. To follow all steps, "
                    "select {body}."
                ).format(step=source.Label, body=source.getParentGeoFeatureGroup().Label)
            )
