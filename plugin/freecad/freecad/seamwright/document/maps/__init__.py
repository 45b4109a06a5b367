# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis tools: maps on faces, curvature combs and plots along seams."""
