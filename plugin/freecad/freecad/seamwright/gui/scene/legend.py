# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: an image of fixed size in the top left corner.

It belongs to the scene, so that pictures saved from the view contain it. Several legends of a
document stand below each other.
"""

import weakref

from pivy import coin

from freecad.seamwright.gui.scene.overlay import (
    outside_bounding_box,
    painted,
    pixel_ratio,
    set_image,
    unlit_unpickable,
)
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

    def update(self, title, entries, footer, text_px, scale=()):
        """Redraw the legend.

        It has a title, lines of (SeamClass, name, meaning), and the lines of the footer below them.
        ``scale``: the colours from the first line to the last one, where they are continuous; then
        lines whose sample is ``apart`` stand below.
        """
        self._picture, self._place = draw(title, entries, footer, text_px, scale), None
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
        """Draw the legend that many pixels of the screen lower; return where the next begins."""
        if self._place != top:
            self._place = top
            set_image(self._image, _lowered(self._picture, top))
        return top + self._picture.height() + round(GAP_PX * pixel_ratio())


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


def draw(title, entries, footer, text_px, scale=()):
    """Return the legend as a QImage; ``text_px`` is the height of its letters in pixels."""
    page = _Page(title, entries, footer, text_px)
    return painted(page.width, page.height, lambda painter: page.paint(painter, scale))


class _Page:
    """The places of the parts of a legend."""

    def __init__(self, title, entries, footer, text_px):
        self.title, self.entries = title, entries
        self.last = footer.split("\n") if footer else []
        self.font = QtGui.QFont("Sans Serif")
        self.font.setPixelSize(text_px)
        self.bold = QtGui.QFont(self.font)
        self.bold.setBold(True)
        self.line, self.pad, self.bar, self.thick = (
            int(1.6 * text_px), text_px, 3 * text_px, text_px // 2
        )  # fmt: skip
        names = max([_width(self.bold, name) for _, name, _ in entries] + [0])
        self.name_x = 2 * self.pad + self.bar
        self.meaning_x = self.name_x + names + self.pad
        right = max(
            self.meaning_x + max([_width(self.font, text) for *_, text in entries] + [0]),
            self.pad + _width(self.bold, title),
            *(self.pad + _width(self.font, text) for text in self.last)
        )
        self.width = right + self.pad
        self.height = (len(entries) + 1 + len(self.last)) * self.line + 2 * self.pad

    def paint(self, painter, scale):
        """Paint the legend; ``scale``: the colours of a continuous one."""
        painter.fillRect(0, 0, self.width, self.height, QtGui.QColor(*PANEL))
        painter.setRenderHint(QtGui.QPainter.TextAntialiasing)
        painter.setPen(QtGui.QColor(*BORDER))
        painter.drawRect(0, 0, self.width - 1, self.height - 1)
        pen = _Pen(painter, self.line)
        pen.text(self.bold, self.pad, self.pad, self.title)
        if len(scale):
            first = self.pad + self.line + self.line // 2
            lines = sum(not sample.apart for sample, *_ in self.entries)
            length = (lines - 1) * self.line
            _draw_scale(painter, QtCore.QRect(self.pad, first, self.bar, length), scale)
        for index, (sample, name, meaning) in enumerate(self.entries, 1):
            top = self.pad + index * self.line
            on_scale = len(scale) and not sample.apart
            self._paint_sample(painter, top, None if on_scale else sample)
            pen.text(self.bold, self.name_x, top, name)
            pen.text(self.font, self.meaning_x, top, meaning)
        for index, text in enumerate(self.last, len(self.entries) + 1):
            pen.text(self.font, self.pad, self.pad + index * self.line, text)

    def _paint_sample(self, painter, top, sample):
        """Paint the colour of an entry, or its mark at a continuous scale."""
        painter.setPen(QtGui.QColor(*BORDER))
        if sample is None:
            middle = top + self.line // 2
            painter.drawLine(self.pad, middle, self.pad + self.bar + self.pad // 2, middle)
            return
        area = QtCore.QRect(self.pad, top + (self.line - self.thick) // 2, self.bar, self.thick)
        painter.fillRect(area, QtGui.QColor(*sample.rgb))
        painter.drawRect(area)


def _draw_scale(painter, area, scale):
    """Fill an area with colours from its top to its bottom."""
    for y in range(area.height()):
        rgb = scale[y * len(scale) // area.height()]
        colour = QtGui.QColor(*(int(round(channel)) for channel in rgb))
        painter.fillRect(area.left(), area.top() + y, area.width(), 1, colour)
    painter.setPen(QtGui.QColor(*BORDER))
    painter.drawRect(area)


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
