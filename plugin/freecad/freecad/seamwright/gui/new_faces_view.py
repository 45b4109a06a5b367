# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of an object that is its source with new faces: as the source, the new ones tinted while its panel is open."""

from freecad.seamwright.document import elements
from freecad.seamwright.gui.result_view import ResultView

TINT = (0.45, 0.8, 0.7)


class NewFacesView(ResultView):
    """Proxy of a view provider; a subclass says which faces are new, and has a panel."""

    def new_faces(self, obj):
        """(numbers of the new faces, number of the source's face that they replace or None)."""
        raise NotImplementedError

    def sources(self, obj):
        """The object that the new faces belong to."""
        return elements.source_objects(obj)

    def updateData(self, obj, prop):
        """Follow the results."""
        super().updateData(obj, prop)
        if prop == "Summary" and "Restore" not in obj.State and self.panel is None:
            self.paint(tinted=False)

    def paint(self, tinted):
        """Colour the faces as those of the source; the new ones alike, or tinted."""
        obj = self.object
        if not self.has_result(obj) or not hasattr(getattr(obj.Source, "ViewObject", None), "ShapeColor"):
            return
        look, vobj = obj.Source.ViewObject, obj.ViewObject
        new, replaced = self.new_faces(obj)
        fresh = TINT if tinted else look.ShapeColor[:3]
        kept = _colours(look, replaced)
        vobj.ShapeColor = look.ShapeColor
        vobj.DiffuseColor = [fresh if n in new else next(kept) for n in range(1, len(obj.Shape.Faces) + 1)]


def _colours(look, replaced):
    """The colours of the faces of an object, one after the other but for one that is gone; then that of the whole."""
    own = [colour[:3] for colour in look.DiffuseColor]
    if len(own) == 1:
        own = []
    yield from (colour for n, colour in enumerate(own, 1) if n != replaced)
    while True:
        yield look.ShapeColor[:3]
