# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of the window: fields, forms, messages, progress, threads, steps that can be undone."""
