# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection, as links of document objects."""

import FreeCADGui as Gui

from freecad.seamwright.document import sources


def picked():
    """Return [(object, "Edge3" or ""), ...] of the selection, in the order of picking.

    A group or part that is selected as a whole counts as its contents. Raises SourceError for a
    mesh, and for what else has no shape.
    """
    found = []
    for chosen in Gui.Selection.getCompleteSelection():
        if chosen.SubElementNames:
            found += [(chosen.Object, name) for name in chosen.SubElementNames]
        else:
            members = [chosen.Object]
            if not sources.has_shape(chosen.Object):
                members = sources.expand(members) or members
            found += [(obj, "") for obj in members]
    for obj, _ in found:
        sources.check_kind(obj)
    return found
