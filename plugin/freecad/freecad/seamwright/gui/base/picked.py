# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection, as links of document objects: the rule that all commands follow."""

import FreeCADGui as Gui

from freecad.seamwright.document import sources


def picked():
    """Return [(object, "Edge3" or ""), ...] of the selection, in the order of picking.

    A group or part that is selected as a whole counts as its contents. What is picked on a body is
    an element of the body, and what is picked in a link to a part one of the link. Raises
    SourceError for a mesh, and for what else has no shape.
    """
    found = []
    for chosen in Gui.Selection.getCompleteSelection(0):  # 0: with the path from the top
        path = chosen.SubElementNames[0]
        if path and not path.endswith("."):
            found.append(meant(chosen.Object, path))
        else:
            whole = _at_end(chosen.Object, path.split(".")[:-1])
            found += [(obj, "") for obj in sources.expand([whole]) or [whole]]
    for obj, _ in found:
        sources.check_kind(obj)
    return list(dict.fromkeys(found))


def picked_on(objects):
    """Return the names of the selected elements of these objects."""
    try:
        return [name for obj, name in picked() if obj in objects and name]
    except sources.SourceError:
        return []


def meant(top, path):
    """Return (object, "Face3") for the path to an element from the top of the document."""
    *names, element = path.split(".")
    owner = top
    for place, name in enumerate(names):
        if owner.isDerivedFrom("App::Link"):
            return owner, sources.element_of_link(owner, ".".join([*names[place:], element]))
        owner = owner.Document.getObject(name) or owner  # newer names of elements are no objects
    body = owner.getParentGeoFeatureGroup() if sources.in_body(owner) else None
    if body is not None and body.Tip == owner:
        owner = body  # which has the elements of its last step
    return owner, element


def _at_end(top, names):
    """Return the object at the end of a path."""
    for name in names:
        top = top.Document.getObject(name) or top
    return top
