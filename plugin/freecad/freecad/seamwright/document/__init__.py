# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects: they need FreeCAD, but no window."""

import FreeCAD

from freecad.seamwright.plain import language

language.translate = FreeCAD.Qt.translate
