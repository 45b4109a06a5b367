# SPDX-License-Identifier: LGPL-2.1-or-later
"""Images of fixed size in the scene, drawn over the model."""

import math

from pivy import coin

from freecad.seamwright.gui.widgets.qt import QtCore, QtGui


def pixel_ratio():
    """Return how many pixels of the screen are one of the window, in quarters."""
    ratio = QtGui.QGuiApplication.instance().devicePixelRatio()
    return max(round(4 * ratio) / 4, 1.0)


def painted(width, height, paint):
    """Return the QImage that ``paint(painter)`` draws on a transparent ground.

    ``width``, ``height`` and what is painted are in pixels of the window; the image has those of
    the screen.
    """
    ratio = pixel_ratio()
    image = QtGui.QImage(
        math.ceil(width * ratio), math.ceil(height * ratio), QtGui.QImage.Format_ARGB32
    )
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.scale(ratio, ratio)
    paint(painter)
    painter.end()
    return image


def set_image(node, picture):
    """Put a QImage into an SoImage."""
    picture = picture.convertToFormat(QtGui.QImage.Format_RGBA8888).mirrored(False, True)
    size = coin.SbVec2s(picture.width(), picture.height())
    node.image.setValue(size, 4, bytes(picture.constBits()))


def unlit_unpickable():
    """Return nodes that make the nodes after them unlit and transparent for the mouse."""
    pick, light = coin.SoPickStyle(), coin.SoLightModel()
    pick.style = coin.SoPickStyle.UNPICKABLE
    light.model = coin.SoLightModel.BASE_COLOR
    return pick, light


def outside_bounding_box(child):
    """Return a group that "fit all" ignores. FreeCAD registers its type with the scene library."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    group.addChild(child)
    return group
