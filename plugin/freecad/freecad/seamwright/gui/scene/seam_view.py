# SPDX-License-Identifier: LGPL-2.1-or-later
"""Showing seams of an analysis in the 3D view: select their edges and turn the camera to them."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document import analysis, sources
from freecad.seamwright.gui.scene import camera
from freecad.seamwright.plain import rows

#: The least height of the view when zooming to a seam, as a part of the size of the model.
CONTEXT = 0.15


def show(obj, report, seams, size, look=True):
    """Select the edges of seams (dicts of the report) on their objects, and mark them on ``obj``.

    ``size``: of the model, in mm. ``look``: turn and zoom the view to the seams.
    """
    Gui.Selection.clearSelection()
    edges, classes = [], []
    for seam in seams:
        for number in seam["edges"]:
            owner = rows.owner_of(report, "edges", number)
            edge = find(obj.Document, *owner) if owner else None
            if edge is not None:
                select(obj.Document, *owner)
                edges.append(edge)
                classes.append(seam["class"])
    worst = [
        (seam["worst"]["point"], rows.worst_label(seam, report["tolerance"]))
        for seam in seams
        if seam.get("worst")
    ]
    obj.ViewObject.Proxy.mark(edges, classes, worst)
    view = _view_of(obj.Document)
    if not look or not edges or view is None:
        return
    box = App.BoundBox()
    for edge in edges:
        box.add(edge.BoundBox)
    camera.look_at(view, box, CONTEXT * size, _location(obj, report, seams[0], edges[0]))


def select(doc, name, element):
    """Select one sub-element, by its path from the top of the document."""
    obj = doc.getObject(name)
    path = element
    group = obj.getParentGeoFeatureGroup()
    while group is not None:
        path = "%s.%s" % (obj.Name, path)
        obj, group = group, group.getParentGeoFeatureGroup()
    Gui.Selection.addSelection(doc.Name, obj.Name, path)


def find(doc, name, element):
    """Return the sub-shape at its position in the model; None when the document lost it."""
    obj = doc.getObject(name)
    if obj is None:
        return None
    try:
        return sources.world_shape(obj).getElement(element)
    except (Part.OCCError, sources.SourceError):
        return None


def _location(obj, report, seam, edge):
    """Return (point, outward normal or None, tangent) at the middle of a seam's edge.

    The normal is the mean of the normals of the faces; None where they cancel or are unknown.
    """
    middle = sum(edge.ParameterRange) / 2
    point, tangent = edge.valueAt(middle), edge.tangentAt(middle)
    owners = [rows.owner_of(report, "faces", number) for number in seam["faces"]]
    faces = [find(obj.Document, *owner) for owner in owners if owner]
    total = App.Vector()
    for face in faces:
        if face is not None:
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


def seams_by_number(obj):
    """Return (report, {seam number: seam}) of an analysis."""
    report = analysis.report_of(obj)
    return report, {seam["id"]: seam for seam in report["seams"]}
