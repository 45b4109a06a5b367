# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asking for the file of a report, and writing it."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import export
from freecad.seamwright.plain.language import inside, mark, tr

FILTERS = {"csv": mark("Table (*.csv)"), "json": mark("Report (*.json)")}


def ask_and_export(obj, kinds=("csv", "json"), shown=None):
    """Let the user choose a file of one of the kinds and export the report of an analysis.

    ``shown``: the numbers of the seams that a table has, see ``export_to``.
    """
    filters = ";;".join(tr(FILTERS[kind]) for kind in kinds)
    path, chosen = QtWidgets.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), tr("Export seam report"), obj.Label + "." + kinds[0], filters
    )
    if not path:
        return
    if not path.lower().endswith((".csv", ".json")):
        path += ".json" if chosen == tr(FILTERS["json"]) else ".csv"
    export_to(obj, path, shown)


def export_to(obj, path, shown=None):
    """Export the report of an analysis; failures are shown, not raised.

    ``shown``: the numbers of the seams to be the lines of a CSV, in this order; None for all of
    the report. Returns whether the file was written.
    """
    report = analysis.report_of(obj)
    every = report.get("seams", [])
    if shown is not None and path.lower().endswith(".csv"):
        seams = {seam["id"]: seam for seam in every}
        report = {**report, "seams": [seams[number] for number in shown]}
    try:
        export.write(report, path)
    except export.ExportError as error:
        messages.show_error(str(error))
        return False
    messages.say(_done_text(obj, len(report.get("seams", [])), len(every), path))
    return True


def _done_text(obj, written, every, path):
    if written == every:
        return tr("{written} of {every} seams are written to {path}.").format(
            written=written, every=every, path=path
        )
    return tr("{written} of {every} seams ({show}) are written to {path}.").format(
        written=written, every=every, show=inside(obj.ViewObject.Show), path=path
    )
