# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the graphics card runs shaders."""

import functools

from freecad.seamwright.gui.widgets.qt import QtGui


@functools.lru_cache(maxsize=None)
def work():
    """Return whether shaders can be compiled; where Qt cannot tell, they are expected to."""
    program = getattr(QtGui, "QOpenGLShaderProgram", None)
    if program is None or not hasattr(QtGui, "QOffscreenSurface"):
        return True
    before, surface = QtGui.QOpenGLContext.currentContext(), QtGui.QOffscreenSurface()
    surface.create()
    context = QtGui.QOpenGLContext()
    if not context.create() or not context.makeCurrent(surface):
        return False
    try:
        return bool(program.hasOpenGLShaderPrograms(context))
    finally:
        context.doneCurrent()
        if before is not None:
            before.makeCurrent(before.surface())
