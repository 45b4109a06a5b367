# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis tools: one panel and one view for all of them."""
