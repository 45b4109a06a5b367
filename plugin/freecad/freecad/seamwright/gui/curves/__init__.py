# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves: their commands, one panel for all of them, their view."""
