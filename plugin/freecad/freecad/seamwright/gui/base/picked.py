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
    for chosen, path in _selected():
        if not chosen.SubElementNames[0]:
            found += [(obj, "") for obj in sources.expand([chosen.Object]) or [chosen.Object]]
        else:
            own = _in_link(path.Object, path.SubElementNames[0])
            found.append(own or (_whole_body(chosen.Object), chosen.SubElementNames[0]))
    for obj, _ in found:
        sources.check_kind(obj)
    return list(dict.fromkeys(found))


def _selected():
    """Return (what was picked, the same as a path from the top of the document) for each pick."""
    return zip(Gui.Selection.getCompleteSelection(1), Gui.Selection.getCompleteSelection(0))


def _whole_body(obj):
    """Return the body of its last step, which has the same elements; else the object itself."""
    body = obj.getParentGeoFeatureGroup() if sources.in_body(obj) else None
    return body if body is not None and body.Tip == obj else obj


def _in_link(top, path):
    """Return (link, "Face3") where the path to an element goes through a link, else None."""
    owner, names = top, path.split(".")
    for place, name in enumerate(names[:-1]):
        if owner.isDerivedFrom("App::Link"):
            return owner, sources.element_of_link(owner, ".".join(names[place:]))
        owner = owner.Document.getObject(name)
        if owner is None:
            return None
    return None
