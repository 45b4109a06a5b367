# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seam Repair: its view and its panel."""
