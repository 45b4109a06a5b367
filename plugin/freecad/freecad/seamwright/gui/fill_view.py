# SPDX-License-Identifier: LGPL-2.1-or-later
"""The name under which documents of version 0.1.0 find this class; do not remove it."""

from freecad.seamwright.gui.fill.view import UmbrellaFillView

__all__ = ["UmbrellaFillView"]
