# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: an image of fixed size in the top left corner.

It belongs to the scene, so that pictures saved from the view contain it. Several legends of a
document stand below each other.
"""

import weakref

from pivy import coin

from freecad.seamwright.gui.scene.overlay import outside_bounding_box, set_image, unlit_unpickable
from freecad.seamwright.gui.widgets.later import find
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui

MARGIN = 0.02  # of the view's width and height
PANEL = (255, 255, 255, 235)
BORDER = (120, 120, 120)
TEXT = (25, 25, 25)

#: Pixels between two legends.
GAP_PX = 6

#: References to the legends that are shown, the uppermost first.
_shown = []


class Legend:
    """Scene nodes that draw the legend of an object; add ``node`` to the root of its view."""

    def __init__(self, obj):
        self.names = obj.Document.Name, obj.Name
        self._picture, self._place = None, None
        self._image = coin.SoImage()
        self._image.horAlignment = coin.SoImage.LEFT
        self._image.vertAlignment = coin.SoImage.TOP
        self._switch = coin.SoSwitch()
        self._switch.addChild(_overlay(self._image))
        self.node = outside_bounding_box(self._switch)

    def show(self, visible):
        """Show or hide the legend."""
        self._switch.whichChild = coin.SO_SWITCH_ALL if visible else coin.SO_SWITCH_NONE
        before = [each() for each in _shown]
        if visible and self not in before:
            _shown.append(weakref.ref(self))
        elif not visible and self in before:
            del _shown[before.index(self)]
        _stack(self.names[0])

    def update(self, title, entries, footer, text_px):
        """Redraw the legend.

        It has a title, lines of (SeamClass, name, meaning), and the lines of the footer below them.
        """
        self._picture, self._place = draw(title, entries, footer, text_px), None
        _stack(self.names[0])

    def is_seen(self):
        """Return whether the object has this legend; the view of a deleted one is kept for undo."""
        obj = find(*self.names)
        return (
            obj is not None
            and self._picture is not None
            and obj.ViewObject.RootNode.findChild(self.node) >= 0
        )

    def put(self, top):
        """Draw the legend this many pixels lower; return where the next one begins."""
        if self._place != top:
            self._place = top
            set_image(self._image, _lowered(self._picture, top))
        return top + self._picture.height() + GAP_PX


def _stack(doc_name):
    """Put the legends of a document below each other."""
    _shown[:] = [each for each in _shown if each() is not None]
    top = 0
    for legend in [each() for each in _shown]:
        if legend.names[0] == doc_name and legend.is_seen():
            top = legend.put(top)


def _lowered(picture, top):
    """Return a picture with this many transparent lines above it."""
    if not top:
        return picture
    lowered = QtGui.QImage(
        picture.width(), picture.height() + top, QtGui.QImage.Format_ARGB32
    )
    lowered.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(lowered)
    painter.setCompositionMode(QtGui.QPainter.CompositionMode_Source)
    painter.drawImage(0, top, picture)
    painter.end()
    return lowered


def _overlay(child):
    """Return a node that is drawn over everything, in the top left corner of the view."""
    overlay = coin.SoAnnotation()
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.aspectRatio = 1.0
    camera.height = 2.0
    camera.position = (0, 0, 1)
    camera.nearDistance = 0.5
    camera.farDistance = 1.5
    corner = coin.SoTranslation()
    corner.translation = (-1 + 2 * MARGIN, 1 - 2 * MARGIN, 0)
    for node in (*unlit_unpickable(), camera, corner, child):
        overlay.addChild(node)
    return overlay


def draw(title, entries, footer, text_px):
    """Return the legend as a QImage; ``text_px`` is the height of its letters in pixels."""
    font = QtGui.QFont("Sans Serif")
    font.setPixelSize(text_px)
    bold = QtGui.QFont(font)
    bold.setBold(True)
    line = int(1.6 * text_px)
    pad, bar = text_px, 3 * text_px
    name_width = max([_width(bold, name) for _, name, _ in entries] + [0])
    meaning_x = pad + bar + pad + name_width + pad
    meaning_width = max([_width(font, meaning) for _, _, meaning in entries] + [0])
    last = footer.split("\n") if footer else []
    right = max(
        meaning_x + meaning_width,
        pad + _width(bold, title),
        *(pad + _width(font, text) for text in last)
    )
    height = (len(entries) + 1 + len(last)) * line + 2 * pad
    image = QtGui.QImage(right + pad, height, QtGui.QImage.Format_ARGB32)
    image.fill(QtGui.QColor(*PANEL))
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.TextAntialiasing)
    painter.setPen(QtGui.QColor(*BORDER))
    painter.drawRect(0, 0, image.width() - 1, image.height() - 1)
    pen = _Pen(painter, line)
    pen.text(bold, pad, pad, title)
    for index, (seam_class, name, meaning) in enumerate(entries, 1):
        top = pad + index * line
        thick = text_px // 2
        colour = QtGui.QColor(*seam_class.rgb)
        painter.fillRect(pad, top + (line - thick) // 2, bar, thick, colour)
        painter.setPen(QtGui.QColor(*BORDER))
        painter.drawRect(pad, top + (line - thick) // 2, bar, thick)
        pen.text(bold, pad + bar + pad, top, name)
        pen.text(font, meaning_x, top, meaning)
    for index, text in enumerate(last, len(entries) + 1):
        pen.text(font, pad, pad + index * line, text)
    painter.end()
    return image


class _Pen:
    """Writes lines of text of one height."""

    def __init__(self, painter, line):
        self._painter, self._line = painter, line

    def text(self, font, left, top, text):
        self._painter.setFont(font)
        self._painter.setPen(QtGui.QColor(*TEXT))
        area = QtCore.QRect(left, top, _width(font, text) + 2, self._line)
        self._painter.drawText(area, QtCore.Qt.AlignVCenter | QtCore.Qt.AlignLeft, text)


def _width(font, text):
    return QtGui.QFontMetrics(font).boundingRect(text).width() + 2
