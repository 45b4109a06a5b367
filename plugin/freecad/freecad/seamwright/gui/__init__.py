# SPDX-License-Identifier: LGPL-2.1-or-later
"""What needs FreeCAD's window: commands, task panels and view providers.

A folder imports only from those before it in this list:

* ``widgets``   fields, forms, messages, progress, threads, steps that can be undone;
* ``scene``     what is drawn in the 3D view;
* ``base``      base classes of panels and view providers;
* ``analysis``, ``repair``, ``match``, ``fill``, ``corner``   panel and view of one document object;
* ``curves``    panel and view of all curves;
* ``maps``      panel and view of all analysis tools.

The commands in ``commands.py``, ``curve_commands.py``, ``surface_commands.py`` and
``analysis_commands.py``, the help in ``help_window.py`` and the page of the preferences in
``preferences_page.py`` use all of them.
"""

import os

ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")


def icon_path(name):
    """Return the path of an icon of the workbench."""
    return os.path.join(ICONS, name + ".svg")
