# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corner Fillet: its view and its panel with a radius for each edge."""
