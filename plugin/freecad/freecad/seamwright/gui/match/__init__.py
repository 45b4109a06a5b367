# SPDX-License-Identifier: LGPL-2.1-or-later
"""Match Surfaces: its view and its panel."""
