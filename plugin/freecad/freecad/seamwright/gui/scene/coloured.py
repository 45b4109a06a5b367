# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes of triangles with a colour at each point, and of the edges between their faces."""

from pivy import coin

from freecad.seamwright.gui.scene import stripes
from freecad.seamwright.gui.scene.halo import nearer

EDGE_COLOUR, EDGE_WIDTH = (0.1, 0.1, 0.1), 1.5

#: The amount by which edges are drawn nearer than the faces, see halo, and less than seams. The
#: lines leave the sides of the triangles by more than the offset of the faces, and would be broken.
EDGE_LIFT = 0.002

#: Deviation of the drawn edges from those of the model, as a part of the size of an edge.
DEFLECTION = 1e-3


def polylines(edges):
    """Return the edges as lists of points."""
    lines = [
        edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7))
        for edge in edges
    ]
    return [[tuple(point) for point in line] for line in lines]


def unpickable():
    """Return a node that makes the nodes after it transparent for the mouse."""
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    return pick


def faces(shown, colours, lit=True):
    """Return a separator that draws a ShownMesh in the colours of its points.

    Colours are (red, green, blue), each 0..1. ``lit``: the faces are lit from both sides, so that
    their form is visible. Unlit faces have exactly the colours of the legend.
    """
    group, hints, offset = coin.SoSeparator(), coin.SoShapeHints(), coin.SoPolygonOffset()
    # With an unknown shape type, this means lit from both sides.
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    light, binding, material = coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoMaterial()
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    light.model = coin.SoLightModel.PHONG if lit else coin.SoLightModel.BASE_COLOR
    material.diffuseColor.setValues(0, len(colours), colours)
    for node in (hints, offset, light, binding, material, *stripes.mesh(shown)):
        group.addChild(node)
    return group


def lines(polylines):
    """Return a separator that draws dark lines through lists of points."""
    points = [point for line in polylines for point in line]
    group, light, colour, style = (
        coin.SoSeparator(),
        coin.SoLightModel(),
        coin.SoBaseColor(),
        coin.SoDrawStyle(),
    )
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb, style.lineWidth = EDGE_COLOUR, EDGE_WIDTH
    coordinates, line_set = coin.SoCoordinate3(), coin.SoLineSet()
    coordinates.point.setValues(0, len(points), points)
    line_set.numVertices.setValues(0, len(polylines), [len(line) for line in polylines])
    for node in (nearer(EDGE_LIFT), light, colour, style, coordinates, line_set):
        group.addChild(node)
    return group
