# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes of fills that were not kept: their faces, and their seams in the colours of what
they miss, with a legend."""

from pivy import coin

from freecad.seamwright.gui.scene.coloured import unpickable
from freecad.seamwright.gui.scene.halo import BAND_LIFT, CORE_LIFT, nearer
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.scene.overlay import pixel_ratio

FACE_COLOUR, LINE_WIDTH, LEGEND_TEXT_PX = (0.45, 0.8, 0.7), 7.0, 13

#: The deviation of the drawn triangles from the faces, as a part of their size.
DEFLECTION = 1e-3


class MissedFill:
    """Puts its nodes at the start of the root of the view provider of ``obj``."""

    def __init__(self, obj):
        self._drawn, self.legend = coin.SoSeparator(), Legend(obj)
        for node in (self._drawn, self.legend.node):
            obj.ViewObject.RootNode.insertChild(node, 0)

    def show(self, faces, lines, legend):
        """Draw a shape, and lines of (points, colours 0..1); ``legend``: see Legend.update."""
        self._drawn.removeAllChildren()
        for node in (unpickable(), _faces(faces), _lines(lines)):
            self._drawn.addChild(node)
        self.legend.update(*legend, LEGEND_TEXT_PX)
        self.legend.show(True)

    def hide(self):
        """Draw nothing."""
        self._drawn.removeAllChildren()
        self.legend.show(False)


def _faces(shape):
    points, triangles = shape.tessellate(DEFLECTION * max(shape.BoundBox.DiagonalLength, 1e-6))
    group, hints, material = coin.SoSeparator(), coin.SoShapeHints(), coin.SoMaterial()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # lit from both sides
    hints.creaseAngle = 0.5
    material.diffuseColor = FACE_COLOUR
    coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    coordinates.point.setValues(0, len(points), [tuple(point) for point in points])
    corners = [number for triangle in triangles for number in (*triangle, -1)]
    faces.coordIndex.setValues(0, len(corners), corners)
    # A fill in place of a face lies close to it, in parts behind it.
    for node in (nearer(BAND_LIFT), hints, material, coordinates, faces):
        group.addChild(node)
    return group


def _lines(lines):
    points = [tuple(point) for line, _ in lines for point in line]
    colours = [colour for _, own in lines for colour in own]
    group, light, style = coin.SoSeparator(), coin.SoLightModel(), coin.SoDrawStyle()
    light.model, style.lineWidth = coin.SoLightModel.BASE_COLOR, LINE_WIDTH * pixel_ratio()
    binding, material = coin.SoMaterialBinding(), coin.SoBaseColor()
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    coordinates, line_set = coin.SoCoordinate3(), coin.SoLineSet()
    if points:
        material.rgb.setValues(0, len(colours), colours)
        coordinates.point.setValues(0, len(points), points)
    line_set.numVertices.setValues(0, len(lines), [len(line) for line, _ in lines])
    if lines:
        for node in (nearer(CORE_LIFT), light, binding, style, material, coordinates, line_set):
            group.addChild(node)
    return group
