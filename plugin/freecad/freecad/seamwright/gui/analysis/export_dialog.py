# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asking for the file of a report, and writing it."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import export
from freecad.seamwright.plain.language import mark, tr

FILTERS = {"csv": mark("Table (*.csv)"), "json": mark("Report (*.json)")}


def ask_and_export(obj, kinds=("csv", "json")):
    """Let the user choose a file of one of the kinds and export the report of an analysis."""
    filters = ";;".join(tr(FILTERS[kind]) for kind in kinds)
    path, chosen = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), tr("Export seam report"), obj.Label + "." + kinds[0], filters
    )
    if not path:
        return
    if not path.lower().endswith((".csv", ".json")):
        path += ".json" if chosen == tr(FILTERS["json"]) else ".csv"
    export_to(obj, path)


def export_to(obj, path):
    """Export the report of an analysis; failures are shown, not raised.

    Returns whether the file was written.
    """
    try:
        export.write(analysis.report_of(obj), path)
    except export.ExportError as error:
        messages.show_error(str(error))
        return False
    messages.say(tr("All seams are written to {path}.").format(path=path))
    return True
