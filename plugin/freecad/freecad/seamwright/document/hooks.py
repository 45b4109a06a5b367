# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window adds to the document objects; without a window these do nothing."""

import contextlib


class Hooks:
    """The two calls from document objects out to a window.

    ``attach_view(obj)`` gives the object its view provider. ``progress(text)`` is a context
    manager that yields a callable(fraction) -> False to cancel, or None.
    """

    def __init__(self):
        self.attach_view = lambda obj: None
        self.progress = lambda text: contextlib.nullcontext()


hooks = Hooks()
