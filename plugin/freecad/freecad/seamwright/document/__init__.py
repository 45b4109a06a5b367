# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects: they need FreeCAD, but no window."""
