# SPDX-License-Identifier: LGPL-2.1-or-later
"""Umbrella Fill: its view and its panel with the list of holes."""
