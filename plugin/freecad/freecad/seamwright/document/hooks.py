# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls from document objects to a window; without a window they do nothing."""

import contextlib


class Hooks:
    """The two calls from document objects to a window.

    ``attach_view(obj)`` gives the object its view provider. ``progress(text)`` is a context manager
    that yields None or a callable(fraction), which returns False to cancel.
    """

    def __init__(self):
        self.attach_view = lambda obj: None
        self.progress = lambda text: contextlib.nullcontext()


hooks = Hooks()
