# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of values in a panel that can be taken back one by one."""


class ValueSteps:
    """What was before each change; the values themselves are of any kind."""

    def __init__(self):
        self.clear()

    def clear(self):
        """Forget all steps."""
        self.done, self.undone = [], []

    def add(self, before):
        """Remember what was before a change."""
        self.done.append(before)
        self.undone = []

    def move(self, back, now):
        """Return what was before the last change, or what was before it was taken back.

        ``now(value)``: what is in the place of a value that is returned. Returns None where there
        is no step.
        """
        taken, kept = (self.done, self.undone) if back else (self.undone, self.done)
        if not taken:
            return None
        value = taken.pop()
        kept.append(now(value))
        return value
