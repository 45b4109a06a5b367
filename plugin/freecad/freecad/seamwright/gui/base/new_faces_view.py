# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of an object whose shape is its source with new faces.

It looks like the source. While its panel is open, the new faces are tinted.
"""

from freecad.seamwright.document import elements
from freecad.seamwright.gui.base.result_view import ResultView

TINT = (0.45, 0.8, 0.7)

#: The distance that a corner of a face may have from its surface, as a part of the size of the
#: face. Corners lie on surfaces only within the tolerances of edges.
SAME_POSITION = 1e-3


class NewFacesView(ResultView):
    """Proxy of a view provider; a subclass says which faces are new, and has a panel."""

    def new_faces(self, obj):
        """Return (numbers of the new faces, number of the face of the source that they replace).

        The second number is None where they replace no face.
        """
        raise NotImplementedError

    def sources(self, obj):
        """Return the object to which the new faces belong."""
        return elements.source_objects(obj)

    def updateData(self, obj, prop):
        """Update the colours when the results change."""
        super().updateData(obj, prop)
        if prop == "Summary" and "Restore" not in obj.State and self.panel is None:
            self.paint(tinted=False)

    def paint(self, tinted):
        """Colour the faces like those of the source; new faces may be tinted instead."""
        obj = self.object
        if not self.has_result(obj) or not hasattr(
            getattr(obj.Source, "ViewObject", None), "ShapeColor"
        ):
            return
        look, vobj = obj.Source.ViewObject, obj.ViewObject
        new, replaced = self.new_faces(obj)
        whole = look.ShapeColor[:3]
        kept = iter(_kept_colours(obj, look, new, replaced))
        vobj.ShapeColor = look.ShapeColor
        vobj.DiffuseColor = [
            (TINT if tinted else whole) if number in new else next(kept, whole)
            for number in range(1, len(obj.Shape.Faces) + 1)
        ]


def _kept_colours(obj, look, new, replaced):
    """Return the colours of the kept faces in their order.

    Returns no colours where all faces have the same one, or where the order of the faces changed.
    """
    colours = [colour[:3] for colour in look.DiffuseColor]
    before = elements.source_shape(obj).Faces
    if len(colours) != len(before) or len(set(colours)) == 1:
        return []
    old = [
        (face, colour) for n, (face, colour) in enumerate(zip(before, colours), 1) if n != replaced
    ]
    kept = [face for n, face in enumerate(obj.Shape.Faces, 1) if n not in new]
    in_order = len(kept) == len(old) and all(
        _lies_on(face, other) for face, (other, _) in zip(kept, old)
    )
    return [colour for _, colour in old] if in_order else []


def _lies_on(face, other):
    """Return whether the corners of a face lie on the surface of another face."""
    reach = SAME_POSITION * max(1.0, face.BoundBox.DiagonalLength)
    feet = (other.Surface.value(*other.Surface.parameter(vertex.Point)) for vertex in face.Vertexes)
    return all((foot - vertex.Point).Length <= reach for foot, vertex in zip(feet, face.Vertexes))
