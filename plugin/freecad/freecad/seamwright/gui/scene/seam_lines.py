# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of all seams of an analysis, as one set of lines in the scene."""

from pivy import coin


class SeamLines:
    """Scene nodes of the lines; ``node`` is a display mode of a view provider.

    However many lines there are, the number of nodes is the same. A hidden line stays in the set
    as a line without length, so that the number of a picked line is that of its edge.
    """

    def __init__(self):
        self.node = coin.SoSeparator()
        light, binding = coin.SoLightModel(), coin.SoMaterialBinding()
        light.model = coin.SoLightModel.BASE_COLOR
        # In a set of lines: one colour for each line.
        binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        self._colours, self._style = coin.SoBaseColor(), coin.SoDrawStyle()
        self._points, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        self._pick = coin.SoPickStyle()
        for node in (light, binding, self._pick, self._colours, self._style):
            self.node.addChild(node)
        for node in (self._points, self._lines):
            self.node.addChild(node)
        self.set_lines([], [])
        self.paint([], [], [])

    def set_lines(self, points, spans):
        """Take lines; ``paint`` draws them.

        ``points``: of all lines in a row. ``spans``: (index of the first point, number of points)
        of each line.
        """
        self._spans = spans
        _set(self._points.point, points)

    def paint(self, palette, colours, hidden):
        """Draw the lines.

        ``palette``: (red, green, blue), each 0..1. ``colours``: for each line its index in the
        palette. ``hidden``: for each line whether it is not drawn.
        """
        indices = []
        for (begin, count), away in zip(self._spans, hidden):
            indices += (begin, begin) if away else range(begin, begin + count)
            indices.append(-1)
        _set(self._lines.coordIndex, ())
        _set(self._colours.rgb, palette)
        _set(self._lines.materialIndex, colours)
        _set(self._lines.coordIndex, indices)

    def set_pickable(self, pickable):
        """Let the mouse pick the lines, or what lies behind them."""
        style = coin.SoPickStyle
        self._pick.style = style.SHAPE if pickable else style.UNPICKABLE

    def set_width(self, width):
        """Draw the lines with this width in pixels."""
        self._style.lineWidth = width


def _set(field, values):
    field.setNum(len(values))
    if values:
        field.setValues(0, len(values), values)
