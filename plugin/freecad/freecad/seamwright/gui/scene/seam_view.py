# SPDX-License-Identifier: LGPL-2.1-or-later
"""Showing seams of an analysis in the 3D view: select their edges and turn the camera to them."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.seam_results import polyline
from freecad.seamwright.gui.scene import camera
from freecad.seamwright.plain import labels, rows

#: The least height of the view when zooming to a seam, as a part of the size of the model.
CONTEXT = 0.15

#: More edges are not selected, only marked: FreeCAD compares each with all that are selected.
SELECTED_MOST = 1000

#: More worst points are not marked, since their labels would cover each other.
LABELLED_MOST = 50


def show(obj, report, seams, size, look=True, lines=None):
    """Select the edges of seams (dicts of the report) on their objects, and mark them on ``obj``.

    ``size``: of the model, in mm. ``look``: turn and zoom the view to the seams, unless they
    are too many. ``lines``: the
    {edge number: [point, ...]} of the edges, if they are known. Returns whether all edges were
    selected, see ``SELECTED_MOST``.
    """
    lines = _lines_of(obj.Document, report, seams) if lines is None else lines
    numbers = {number: seam["class"] for seam in seams for number in seam["edges"]}
    numbers = {number: key for number, key in numbers.items() if number in lines}
    owners = [rows.owner_of(report, "edges", number) for number in numbers]
    owners = [owner for owner in owners if owner]
    Gui.Selection.clearSelection()
    select_all(obj.Document, owners[:SELECTED_MOST])
    obj.ViewObject.Proxy.mark(
        [lines[number] for number in numbers],
        list(numbers.values()),
        worst_marks(report, seams[:LABELLED_MOST]),
        labels.NEAR * size,
    )
    all_selected = len(owners) <= SELECTED_MOST
    if look and numbers and all_selected:
        look_at(obj, report, seams, size, [lines[number] for number in numbers])
    return all_selected


def look_at(obj, report, seams, size, lines):
    """Turn and zoom the view to seams; ``lines``: of their edges, as lists of points."""
    view = _view_of(obj.Document)
    if view is None:
        return
    box = App.BoundBox()
    for line in lines:
        for point in line:
            box.add(*point)
    camera.look_at(view, box, CONTEXT * size, _location(obj, report, seams[0], lines[0]))


def look_at_edges(source, names):
    """Turn and zoom the view to edges of an object, ["Edge3", ...]."""
    view = _view_of(source.Document)
    if view is None:
        return
    shape = sources.world_shape(source)
    edges = [shape.getElement(name) for name in names]
    box = App.BoundBox()
    for edge in edges:
        box.add(edge.BoundBox)
    beside = [face for face in shape.Faces if any(each.isSame(edges[0]) for each in face.Edges)]
    least_height = CONTEXT * shape.BoundBox.DiagonalLength
    camera.look_at(view, box, least_height, _middle(polyline(edges[0]), beside))


def worst_marks(report, seams):
    """Return [(point, label), ...] of the worst points of seams."""
    return [
        (seam["worst"]["point"], rows.worst_label(seam, report["tolerance"]))
        for seam in seams
        if seam.get("worst")
    ]


def _lines_of(doc, report, seams):
    found = {}
    for number in (number for seam in seams for number in seam["edges"]):
        owner = rows.owner_of(report, "edges", number)
        edge = find(doc, *owner) if owner else None
        if edge is not None:
            found[number] = polyline(edge)
    return found


def select(doc, name, element):
    """Select one sub-element, by its path from the top of the document."""
    select_all(doc, [(name, element)])


def select_all(doc, owners):
    """Select sub-elements, (object name, element) each; the objects that are gone are left out.

    Elements of one object are selected at once, by their paths from the top of the document.
    """
    elements = {}
    for name, element in owners:
        elements.setdefault(name, []).append(element)
    for name, names in elements.items():
        obj = doc.getObject(name)
        if obj is None:
            continue
        if obj.hasExtension("App::LinkBaseExtension"):
            names = sources.paths_in_link(obj, names)
        path = ""
        group = obj.getParentGeoFeatureGroup()
        while group is not None:
            path = "%s.%s" % (obj.Name, path)
            obj, group = group, group.getParentGeoFeatureGroup()
        Gui.Selection.addSelection(obj, [path + element for element in names])


def find(doc, name, element):
    """Return the sub-shape at its position in the model; None when the document lost it."""
    obj = doc.getObject(name)
    if obj is None:
        return None
    try:
        return sources.world_shape(obj).getElement(element)
    except (Part.OCCError, ValueError, IndexError, sources.SourceError):
        return None


def _location(obj, report, seam, line):
    """Return (point, outward normal or None, tangent) at the middle of the line of a seam."""
    owners = [rows.owner_of(report, "faces", number) for number in seam["faces"]]
    faces = [find(obj.Document, *owner) for owner in owners if owner]
    return _middle(line, [face for face in faces if face is not None])


def _middle(line, faces):
    """Return (point, outward normal or None, tangent) at the middle of a line beside faces.

    The normal is the mean of the normals of the faces; None where they cancel or are unknown.
    """
    middle = len(line) // 2
    before, after = App.Vector(*line[middle - 1]), App.Vector(*line[middle])
    point, tangent = (before + after) / 2, after - before
    if tangent.Length > 0:
        tangent.normalize()
    total = App.Vector()
    for face in faces:
        total += _normal(face, point)
    return point, total.normalize() if total.Length > 0.1 else None, tangent


def _normal(face, point):
    try:
        return face.normalAt(*face.Surface.parameter(point))
    except Part.OCCError:  # no normal at a degenerate point
        return App.Vector()


def _view_of(doc):
    gui_document = Gui.getDocument(doc.Name)
    view = gui_document.activeView()
    return view if hasattr(view, "getCameraNode") else None
