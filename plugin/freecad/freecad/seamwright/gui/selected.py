# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection, in the form that the commands need."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import analysis, sources
from freecad.seamwright.plain import rows


def selected_sources():
    """Return the selected objects that can be analysed, without repeats."""
    chosen = []
    for obj in Gui.Selection.getSelection():
        if obj not in chosen and not analysis.is_analysis(obj):
            chosen.append(obj)
    return chosen


def selected_analysis():
    """Return the selected Seam Analysis, else the newest of the document, or None."""
    chosen = [obj for obj in Gui.Selection.getSelection() if analysis.is_analysis(obj)]
    every = [obj for obj in App.ActiveDocument.Objects if analysis.is_analysis(obj)]
    return (chosen or every or [None])[-1]


def selected_elements(kind):
    """Return [(object, "Face3"), ...] of the selected elements of a kind, in the order of picking.

    ``kind``: "Face", "Edge" or "Vertex". An object that is selected as a whole counts as its face
    if it has just one.
    """
    return [
        (chosen.Object, name)
        for chosen in Gui.Selection.getSelectionEx()
        if sources.has_shape(chosen.Object)
        for name in chosen.SubElementNames or _only_face(chosen.Object)
        if name.startswith(kind)
    ]


def _only_face(obj):
    return ("Face1",) if len(Part.getShape(obj).Faces) == 1 else ()


def selected_seams():
    """Return [(object, "Edge3" or ""), ...]: the selection for a repair; "" means all of an object.

    The lines of an analysis count as the edges on which they lie. An analysis that is selected as a
    whole counts as the objects that it analysed.
    """
    found = []
    for chosen in Gui.Selection.getSelectionEx():
        edges = [name for name in chosen.SubElementNames if name.startswith("Edge")]
        if analysis.is_analysis(chosen.Object):
            found += _edges_of_lines(chosen.Object, edges) or [
                (obj, "") for obj in chosen.Object.Analysed
            ]
        else:
            found += [
                (obj, edge) for obj in sources.expand([chosen.Object]) for edge in edges or [""]
            ]
    return found


def _edges_of_lines(found, lines):
    report = analysis.report_of(found)
    numbers = [rows.edge_number(report, found.Name, found.Name, line) for line in lines]
    owners = [rows.owner_of(report, "edges", number) for number in numbers if number is not None]
    return [
        (found.Document.getObject(name), edge)
        for name, edge in (owner for owner in owners if owner)
    ]


def selected_parts(doc):
    """Return {object: [names of its selected elements]}.

    Without a selection, these are all solids and shells of the document. An analysis counts as the
    objects that it analysed.
    """
    found = {}
    for chosen in Gui.Selection.getSelectionEx():
        if analysis.is_analysis(chosen.Object):
            parts = {obj: () for obj in chosen.Object.Analysed}
        else:
            parts = {obj: chosen.SubElementNames for obj in sources.expand([chosen.Object])}
        for obj, names in parts.items():
            found.setdefault(obj, []).extend(names)
    return found or {obj: [] for obj in sources.solids_and_shells(doc)}
