# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seamwright for FreeCAD: which seams of a model are smooth, which fall short.

Three rings, each importing only from those before it:

* ``plain``     pure Python: colours, table rows, sentences, export, finding the kernel;
* ``document``  the document object, which needs FreeCAD but no window;
* ``gui``       commands, task panel and view provider.
"""

__version__ = "0.1.0"
