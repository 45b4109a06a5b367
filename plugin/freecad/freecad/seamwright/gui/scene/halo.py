# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing chosen seams with a wide bright band behind their coloured lines."""

from pivy import coin

from freecad.seamwright.gui.scene.overlay import pixel_ratio, unlit_unpickable

COLOUR = (1.0, 0.85, 0.0)
WIDTH = 16.0

#: The amounts by which the seams, the band and the lines on the band are drawn nearer than the
#: model, as parts of the depth of the view. Each covers the one before. A face that slopes towards
#: the viewer would cover half of a wide line, so the band is lifted further.
SEAM_LIFT, BAND_LIFT, CORE_LIFT = 0.003, 0.03, 0.0305


def nearer(amount):
    """Return a node that draws the nodes after it nearer by a part of the depth of the view.

    It lifts lines over the faces and edges on which they lie.
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
        binding.value = coin.SoMaterialBinding.PER_FACE  # in a line set: one colour for each line
        band, style = coin.SoBaseColor(), coin.SoDrawStyle()
        band.rgb = COLOUR
        style.lineWidth = WIDTH * pixel_ratio()
        below, above = coin.SoSeparator(), coin.SoSeparator()
        for node in (nearer(BAND_LIFT), band, style, self._lines):
            below.addChild(node)
        for node in (nearer(CORE_LIFT), binding, self._core, self._core_style, self._lines):
            above.addChild(node)
        for node in (*unlit_unpickable(), self._points, below, above):
            self.node.addChild(node)
        self.show([], [], 1.0)

    def show(self, lines, colours, line_width):
        """Draw the band along lines, each a list of points, and on it the lines; [] removes it.

        ``colours`` are the (red, green, blue) of the lines, 0..1; ``line_width`` is in pixels.
        """
        points = [point for line in lines for point in line]
        self._core_style.lineWidth = line_width * pixel_ratio()
        for field, values in (
            (self._points.point, points),
            (self._lines.numVertices, [len(line) for line in lines]),
            (self._core.rgb, list(colours)),
        ):
            field.setNum(0)
            field.setValues(0, len(values), values)
