# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seam Analysis: its view, its panel with the seam table, and the export of its report."""
