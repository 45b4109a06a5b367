# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD provides it; before 1.0 its widgets are in QtGui."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets"]
