# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pure Python: everything here runs and is tested without FreeCAD."""
