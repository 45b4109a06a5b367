# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seamwright for FreeCAD: which seams of a model are smooth and which fall short.

The package has three layers. Each imports only from those before it:

* ``plain``     pure Python: colours, table rows, sentences, export, finding the kernel;
* ``document``  the document objects, which need FreeCAD but no window;
* ``gui``       commands, task panels and view providers.
"""

__version__ = "0.1.0"
