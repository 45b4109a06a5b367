# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing the chosen seams with a wide bright band behind their coloured line."""

from pivy import coin

COLOUR = (1.0, 0.85, 0.0)
WIDTH = 16.0

#: How much nearer than the model the band is drawn, as a part of the depth of the view: more
#: than the model's faces, less than the coloured lines.
BEHIND_SEAMS = 0.0015

#: Deviation of the drawn band from the edge, as a part of the edge's size.
DEFLECTION = 0.001


def nearer(amount):
    """A node after which things are drawn nearer by a part of the depth of the view.

    It lifts lines over the faces and the edges that they lie on.
    """
    depth = coin.SoDepthBuffer()
    depth.range = (0.0, 1.0 - amount)
    return depth


class Halo:
    """Scene nodes of the band; add ``node`` to the root of a view provider."""

    def __init__(self):
        self.node = coin.SoSeparator()
        self._points = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        self._lines.numVertices.setNum(0)
        light, colour = coin.SoLightModel(), coin.SoBaseColor()
        light.model = coin.SoLightModel.BASE_COLOR
        colour.rgb = COLOUR
        style, pick = coin.SoDrawStyle(), coin.SoPickStyle()
        style.lineWidth = WIDTH
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, nearer(BEHIND_SEAMS), light, colour, style, self._points, self._lines):
            self.node.addChild(node)

    def show(self, edges):
        """Draw the band along the edges, which may be none."""
        lines = [_polyline(edge) for edge in edges]
        points = [tuple(point) for line in lines for point in line]
        self._points.point.setNum(0)
        self._points.point.setValues(0, len(points), points)
        self._lines.numVertices.setNum(0)
        self._lines.numVertices.setValues(0, len(lines), [len(line) for line in lines])


def _polyline(edge):
    return edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7))
