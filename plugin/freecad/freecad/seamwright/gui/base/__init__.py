# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base classes of the task panels and of the view providers."""
