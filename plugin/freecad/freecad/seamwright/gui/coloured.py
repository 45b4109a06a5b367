# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene nodes of triangles with a colour at each point, and of the edges between their faces."""

from pivy import coin

from freecad.seamwright.gui import stripes

EDGE_COLOUR, EDGE_WIDTH = (0.1, 0.1, 0.1), 1.5

#: Deviation of the drawn edges from the model's, as a part of their size.
DEFLECTION = 1e-3


def polylines(edges):
    """The edges as lists of points."""
    lines = [
        edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7))
        for edge in edges
    ]
    return [[tuple(point) for point in line] for line in lines]


def unpickable():
    """A node after which things let the mouse through."""
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    return pick


def faces(shown, colours, lit=True):
    """A separator that draws a ShownMesh in the colours (red, green, blue, 0..1) of its points.

    ``lit``: from both sides, so that its form is seen; else the colours are just those of the
    legend.
    """
    group, hints, offset = coin.SoSeparator(), coin.SoShapeHints(), coin.SoPolygonOffset()
    hints.vertexOrdering = (
        coin.SoShapeHints.COUNTERCLOCKWISE
    )  # with an unknown type of shape: lit from both sides
    light, binding, material = coin.SoLightModel(), coin.SoMaterialBinding(), coin.SoMaterial()
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    light.model = coin.SoLightModel.PHONG if lit else coin.SoLightModel.BASE_COLOR
    material.diffuseColor.setValues(0, len(colours), colours)
    for node in (hints, offset, light, binding, material, *stripes.mesh(shown)):
        group.addChild(node)
    return group


def lines(polylines):
    """A separator that draws dark lines through lists of points."""
    points = [point for line in polylines for point in line]
    group, light, colour, style = (
        coin.SoSeparator(),
        coin.SoLightModel(),
        coin.SoBaseColor(),
        coin.SoDrawStyle(),
    )
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb, style.lineWidth = EDGE_COLOUR, EDGE_WIDTH
    places, line_set = coin.SoCoordinate3(), coin.SoLineSet()
    places.point.setValues(0, len(points), points)
    line_set.numVertices.setValues(0, len(polylines), [len(line) for line in polylines])
    for node in (light, colour, style, places, line_set):
        group.addChild(node)
    return group
