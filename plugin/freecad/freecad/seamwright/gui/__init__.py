# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands, task panels and view providers, which need FreeCAD's window."""

import os

ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")


def icon_path(name):
    """Return the path of an icon of the workbench."""
    return os.path.join(ICONS, name + ".svg")
