# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.gui import export_dialog, icon_path, messages
from freecad.seamwright.plain import kernel


def selected_sources():
    """The selected objects that can be analysed, without repeats."""
    chosen = []
    for obj in Gui.Selection.getSelection():
        if obj not in chosen and not analysis.is_analysis(obj):
            chosen.append(obj)
    return chosen


def selected_analysis():
    """The selected Seam Analysis, else the newest of the document, or None."""
    chosen = [obj for obj in Gui.Selection.getSelection() if analysis.is_analysis(obj)]
    every = [obj for obj in App.ActiveDocument.Objects if analysis.is_analysis(obj)]
    return (chosen or every or [None])[-1]


class AnalyzeSeams:
    """Measure the seams of the selected objects, or of all solids and shells."""

    name = "Seamwright_AnalyzeSeams"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Analyze Seams",
            "ToolTip": "Measure how well the faces of the selected objects join; "
            "with nothing selected, of all solids and shells of the document",
            "Pixmap": icon_path("seamwright-analyze"),
        }

    def IsActive(self):
        """Whether there is a document."""
        return App.ActiveDocument is not None

    def Activated(self):
        """Create the analysis as one step that can be undone, and open its panel."""
        doc = App.ActiveDocument
        doc.openTransaction("Analyze seams")
        try:
            obj = analysis.create(selected_sources(), doc)
        except kernel.KernelUnavailable as error:
            doc.abortTransaction()
            messages.show_error(str(error))
            return
        failure = analysis.error_text(obj)
        if failure:
            doc.abortTransaction()
            messages.show_error(failure)
            return
        doc.commitTransaction()
        Gui.Selection.clearSelection()
        Gui.getDocument(doc.Name).setEdit(obj.Name)


class ExportReport:
    """Write the report of an analysis as CSV or JSON."""

    name = "Seamwright_ExportReport"

    def GetResources(self):
        """Menu text, tool tip and icon."""
        return {
            "MenuText": "Export Seam Report\u2026",
            "ToolTip": "Write the selected seam analysis as a table (CSV) or a report (JSON)",
            "Pixmap": icon_path("seamwright-export"),
        }

    def IsActive(self):
        """Whether there is an analysis."""
        return App.ActiveDocument is not None and selected_analysis() is not None

    def Activated(self):
        """Ask for a file and write it."""
        export_dialog.ask_and_export(selected_analysis())


COMMANDS = (AnalyzeSeams, ExportReport)


def register():
    """Make the commands known to FreeCAD; their names in the order of menu and toolbar."""
    for command in COMMANDS:
        Gui.addCommand(command.name, command())
    return [command.name for command in COMMANDS]
