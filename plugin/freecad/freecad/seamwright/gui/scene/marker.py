# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks at the worst points of chosen seams: a ring and a label that nothing hides."""

from pivy import coin

from freecad.seamwright.gui.scene.overlay import (
    outside_bounding_box,
    painted,
    set_image,
    unlit_unpickable,
)
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui
from freecad.seamwright.plain import labels

RING_PX, TEXT_PX = 23, 13
INK, PAPER = (20, 20, 20), (255, 255, 255)

#: The distance between the ring and its label.
GAP_PX = 4


class Marker:
    """Scene nodes of the marks; add ``node`` to the root of a view provider."""

    def __init__(self):
        self._marks = coin.SoSeparator()
        overlay = coin.SoAnnotation()  # drawn last, over everything
        for node in (*unlit_unpickable(), self._marks):
            overlay.addChild(node)
        self.node = outside_bounding_box(overlay)

    @property
    def count(self):
        """The number of marks that are shown."""
        return self._marks.getNumChildren()

    def show(self, marks, near_mm=0.0):
        """Show only these marks, each (point, label); the coordinates of the point are in mm.

        The first is drawn over the others. Labels of points within ``near_mm`` are written below
        each other.
        """
        self._marks.removeAllChildren()
        ring = _image(draw_ring(), coin.SoImage.CENTER, coin.SoImage.HALF) if marks else None
        lines = labels.lines_below([point for point, _ in marks], near_mm)
        for (point, label), line in reversed(list(zip(marks, lines))):
            mark, position = coin.SoSeparator(), coin.SoTranslation()
            position.translation = tuple(point)
            mark.addChild(position)
            mark.addChild(ring)
            if label:
                picture = draw_label(label, line)
                mark.addChild(_image(picture, coin.SoImage.LEFT, coin.SoImage.HALF))
            self._marks.addChild(mark)


def _image(picture, horizontal, vertical):
    node = coin.SoImage()
    node.horAlignment, node.vertAlignment = horizontal, vertical
    set_image(node, picture)
    return node


def draw_ring():
    """Return a QImage of a dark ring between two light ones, visible on any background."""
    middle = QtCore.QPointF(RING_PX / 2, RING_PX / 2)

    def paint(painter):
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        for colour, width in ((PAPER, 6), (INK, 2.5)):
            painter.setPen(QtGui.QPen(QtGui.QColor(*colour), width))
            painter.drawEllipse(middle, RING_PX / 2 - 4, RING_PX / 2 - 4)

    return painted(RING_PX, RING_PX, paint)


def draw_label(text, line=0):
    """Return a QImage of the text on a light background, to the right of the ring.

    ``line``: the number of lines by which the text is lower than the ring.
    """
    font = QtGui.QFont("Sans Serif")
    font.setPixelSize(TEXT_PX)
    font.setBold(True)
    width = QtGui.QFontMetrics(font).boundingRect(text).width() + TEXT_PX
    left, height = RING_PX // 2 + GAP_PX, int(1.6 * TEXT_PX)
    box = QtCore.QRect(left, 2 * line * height, width - 1, height - 1)

    def paint(painter):
        painter.setFont(font)
        painter.setPen(QtGui.QColor(*INK))
        painter.fillRect(box, QtGui.QColor(*PAPER))
        painter.drawRect(box)
        painter.drawText(box, QtCore.Qt.AlignCenter, text)

    return painted(left + width, (2 * line + 1) * height, paint)
