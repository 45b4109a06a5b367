# SPDX-License-Identifier: LGPL-2.1-or-later
"""The changes of fields and sources in a panel, which can be taken back one by one."""

from freecad.seamwright.gui.widgets.value_steps import ValueSteps


class PanelSteps(ValueSteps):
    """States of the fields and sources of a panel.

    ``panel.shown()`` returns the state, or None for a bad text. ``panel.held_handles()`` are those
    that the user is dragging: a drag is one step.
    """

    def __init__(self, panel):
        super().__init__()
        self._panel, self.shown = panel, None

    def start(self):
        """Forget all steps: the fields are as the object is."""
        self.clear()
        self.shown = self._panel.shown()

    def settle(self):
        """The object has the values that are shown; what it made of them is no step."""
        self.shown = self._panel.shown() or self.shown

    def note(self):
        """Remember what was before the last change, unless a drag has not ended."""
        now = self._panel.shown()
        if now not in (None, self.shown) and not self._panel.held_handles():
            self.add(self.shown)
            self.shown = now

    def step(self, back):
        """Return the (values, links) to show, before the last change or after it; None: none."""
        if self._panel.held_handles():
            return None
        if back and self._panel.shown() is None:  # a text of the panel is no list of numbers
            return self.shown
        self.note()
        found = self.move(back, lambda _: self.shown)
        if found is not None:
            self.shown = found
        return found
