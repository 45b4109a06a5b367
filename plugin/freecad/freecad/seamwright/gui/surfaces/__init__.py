# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces: one panel and one view for all of them."""
