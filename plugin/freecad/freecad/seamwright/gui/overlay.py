# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures in the scene: images of fixed size that lie over the model."""

from pivy import coin

from freecad.seamwright.gui.qt import QtGui


def set_image(node, picture):
    """Put a QImage into an SoImage."""
    picture = picture.convertToFormat(QtGui.QImage.Format_RGBA8888).mirrored(False, True)
    size = coin.SbVec2s(picture.width(), picture.height())
    node.image.setValue(size, 4, bytes(picture.constBits()))


def unlit_unpickable():
    """Nodes after which things are drawn in their own colours and let the mouse through."""
    pick, light = coin.SoPickStyle(), coin.SoLightModel()
    pick.style = coin.SoPickStyle.UNPICKABLE
    light.model = coin.SoLightModel.BASE_COLOR
    return pick, light


def outside_bounding_box(child):
    """A group that "fit all" does not see. FreeCAD registers it with the scene library."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    group.addChild(child)
    return group
