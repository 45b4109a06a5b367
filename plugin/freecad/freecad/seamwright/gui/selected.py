# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection, in the form that the commands need.

All commands follow one rule: they take what is selected or, with nothing selected, everything in
the document that suits them. An analysis counts as the objects that it analysed, a group as its
contents. An object that does not suit is refused with a sentence, as SourceError; it is never
left out in silence.
"""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import analysis, sources
from freecad.seamwright.gui.base.picked import picked, picked_objects
from freecad.seamwright.plain import rows
from freecad.seamwright.plain.language import tr


def selected_sources(doc):
    """Return the selected objects to analyse, without repeats; a group stays what it is.

    Without a selection these are all objects that can be analysed. Raises SourceError where an
    object has no faces, or the document has none.
    """
    chosen = _with_analysed(picked_objects()) or sources.everything(doc)
    _parts(chosen)
    if not chosen:
        sources.Model([])
    return chosen


def selected_analysis():
    """Return the selected Seam Analysis, else the newest of the document, or None."""
    chosen = [obj for obj in Gui.Selection.getSelection() if analysis.is_analysis(obj)]
    every = [obj for obj in App.ActiveDocument.Objects if analysis.is_analysis(obj)]
    return (chosen or every or [None])[-1]


def selected_elements(kind):
    """Return [(object, "Face3"), ...] of the selected elements of a kind, in the order of picking.

    ``kind``: "Face", "Edge" or "Vertex". An object that is selected as a whole counts as its face
    if it has just one. Raises SourceError for an object without faces.
    """
    chosen = picked()
    for obj, _ in chosen:
        if not analysis.is_analysis(obj):
            sources.world_shape(obj)
    chosen = [(obj, name or _only_face(obj)) for obj, name in chosen]
    return [(obj, name) for obj, name in chosen if name.startswith(kind)]


def _only_face(obj):
    return "Face1" if len(Part.getShape(obj).Faces) == 1 else ""


def selected_seams(doc):
    """Return [(object, "Edge3" or ""), ...]: the selection for a repair; "" means all of an object.

    The lines of an analysis count as the edges on which they lie, and the rows that are chosen in
    its panel as their edges. Without a selection, these are all that suit. Raises SourceError for
    an object without faces, and for a vertex.
    """
    return picked_seams(doc) or [(obj, "") for obj in sources.everything(doc)]


def picked_seams(doc):
    """Return what ``selected_seams`` does for a selection; without one, nothing."""
    rest = _chosen_rows(doc)
    if rest:
        return rest
    found = []
    for obj, names in _picked_names().items():
        edges = [name for name in names if name.startswith("Edge")]
        if analysis.is_analysis(obj):
            found += _edges_of_lines(obj, edges) or [(each, "") for each in obj.Analysed]
        else:
            sources.world_shape(obj)
            _refuse_vertices(obj, names)
            found += [(obj, edge) for edge in edges or [""]]
    return found


def _refuse_vertices(obj, names):
    for name in names:
        if name.startswith("Vertex"):
            raise sources.SourceError(
                tr("{name} is a vertex: select edges, or the whole object.").format(
                    name="%s.%s" % (obj.Label, name)
                )
            )


def _picked_names():
    """Return {object: [names of its selected elements]} of the selection."""
    found = {}
    for obj, name in picked():
        found.setdefault(obj, []).extend([name] if name else [])
    return found


def _chosen_rows(doc):
    """Return the edges of rows of an open panel if they are too many to be selected."""
    for obj in doc.Objects:
        panel = obj.ViewObject.Proxy.panel if analysis.is_analysis(obj) else None
        if panel is not None and panel.chosen_elements():
            return panel.chosen_elements()
    return []


def _edges_of_lines(found, lines):
    numbers = analysis.results_of(found).numbers_on(found.Name)
    report = analysis.report_of(found)
    numbers = [numbers.get((found.Name, line)) for line in lines]
    owners = [rows.owner_of(report, "edges", number) for number in numbers if number is not None]
    return [
        (found.Document.getObject(name), edge)
        for name, edge in (owner for owner in owners if owner)
    ]


def selected_parts(doc):
    """Return {object: [names of its selected elements]}; without a selection, all that suit.

    Raises SourceError for an object without faces.
    """
    found = {}
    for obj, names in _picked_names().items():
        if analysis.is_analysis(obj):
            found.update({each: found.get(each, []) for each in obj.Analysed})
        else:
            sources.world_shape(obj)
            found.setdefault(obj, []).extend(names)
    return found or {obj: [] for obj in sources.everything(doc)}


def selected_with_faces():
    """Return the selected objects. Raises SourceError for an object without faces."""
    return _parts(_with_analysed(picked_objects()))


def visible_with_faces(doc):
    """Return the visible objects with faces; a body counts instead of its steps."""
    return [
        obj
        for obj in doc.Objects
        if obj.ViewObject.Visibility
        and not sources.in_body(obj)
        and sources.has_shape(obj)
        and Part.getShape(obj).Faces
    ]


def _with_analysed(objects):
    """Return the objects without repeats; those that it analysed take the place of an analysis."""
    found = {}
    for obj in objects:
        found.update(dict.fromkeys(obj.Analysed if analysis.is_analysis(obj) else [obj]))
    return list(found)


def _parts(objects):
    """Return the objects with faces that the objects contain. Raises SourceError without faces."""
    found = [part for obj in objects for part in sources.expand([obj]) or [obj]]
    for obj in found:
        sources.world_shape(obj)
    return list(dict.fromkeys(found))
