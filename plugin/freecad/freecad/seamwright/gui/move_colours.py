# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes that draw a model with its points coloured by how far they moved, instead of its own faces and edges."""

from pivy import coin

from freecad.seamwright.gui import stripes
from freecad.seamwright.plain import moves

EDGE_COLOUR, EDGE_WIDTH = (0.1, 0.1, 0.1), 1.5

#: Deviation of the drawn edges from the model's, as a part of their size.
DEFLECTION = 1e-3


class MoveColours:
    """Add ``node`` at the start of the root of a view provider: what comes after it is not drawn while it shows."""

    def __init__(self):
        self.node = coin.SoSwitch()
        self._drawn = coin.SoSeparator()
        self.node.addChild(self._drawn)
        self.node.addChild(stripes.unseen())

    def show(self, visible):
        """Draw it or not."""
        self.node.whichChild = coin.SO_SWITCH_ALL if visible else coin.SO_SWITCH_NONE

    def update(self, move_map, edges):
        """Draw another ShownMesh with moves and the edges of its shape."""
        self._drawn.removeAllChildren()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, _faces(move_map), _edges(edges)):
            self._drawn.addChild(node)


def _faces(move_map):
    group, hints, offset = coin.SoSeparator(), coin.SoShapeHints(), coin.SoPolygonOffset()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # with an unknown type of shape: lit from both sides
    binding, material = coin.SoMaterialBinding(), coin.SoMaterial()
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    colours = moves.colours(move_map.moves_mm, move_map.largest_mm)
    material.diffuseColor.setValues(0, len(colours), colours)
    for node in (hints, offset, binding, material, *stripes.mesh(move_map)):
        group.addChild(node)
    return group


def _edges(edges):
    lines = [edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7)) for edge in edges]
    points = [tuple(point) for line in lines for point in line]
    group, light, colour, style = coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb, style.lineWidth = EDGE_COLOUR, EDGE_WIDTH
    places, line_set = coin.SoCoordinate3(), coin.SoLineSet()
    places.point.setValues(0, len(points), points)
    line_set.numVertices.setValues(0, len(lines), [len(line) for line in lines])
    for node in (light, colour, style, places, line_set):
        group.addChild(node)
    return group
