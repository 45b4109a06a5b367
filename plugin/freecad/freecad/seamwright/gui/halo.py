# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing the chosen seams with a wide bright band behind their coloured line."""

from pivy import coin

from freecad.seamwright.gui.overlay import unlit_unpickable

COLOUR = (1.0, 0.85, 0.0)
WIDTH = 16.0

#: How much nearer than the model the seams, the band and the lines on the band are drawn, as
#: parts of the depth of the view: each covers the one before. A face that slopes towards the viewer
#: rises over half of a wide line, so the band, of few seams, is lifted further.
SEAM_LIFT, BAND_LIFT, CORE_LIFT = 0.003, 0.03, 0.0305

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
        self._points, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        self._core, self._core_style = coin.SoBaseColor(), coin.SoDrawStyle()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE  # of a line set: one colour a line
        band, style = coin.SoBaseColor(), coin.SoDrawStyle()
        band.rgb = COLOUR
        style.lineWidth = WIDTH
        below, above = coin.SoSeparator(), coin.SoSeparator()
        for node in (nearer(BAND_LIFT), band, style, self._lines):
            below.addChild(node)
        for node in (nearer(CORE_LIFT), binding, self._core, self._core_style, self._lines):
            above.addChild(node)
        for node in (*unlit_unpickable(), self._points, below, above):
            self.node.addChild(node)
        self.show([], [], 1.0)

    def show(self, edges, colours, line_width):
        """Draw the band along the edges, which may be none, and on it their lines.

        ``colours`` are the (red, green, blue) of the lines, 0..1; ``line_width`` is in pixels.
        """
        lines = [_polyline(edge) for edge in edges]
        points = [tuple(point) for line in lines for point in line]
        self._core_style.lineWidth = line_width
        for field, values in (
            (self._points.point, points),
            (self._lines.numVertices, [len(line) for line in lines]),
            (self._core.rgb, list(colours)),
        ):
            field.setNum(0)
            field.setValues(0, len(values), values)


def _polyline(edge):
    return edge.discretize(Deflection=max(DEFLECTION * edge.BoundBox.DiagonalLength, 1e-7))
