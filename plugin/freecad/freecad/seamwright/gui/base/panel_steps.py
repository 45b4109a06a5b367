# SPDX-License-Identifier: LGPL-2.1-or-later
"""The changes of fields and sources in an option panel, which can be taken back one by one."""

from freecad.seamwright.gui.widgets.value_steps import ValueSteps


class PanelSteps(ValueSteps):
    """States of the fields and sources of an OptionPanel.

    What changes until the next computation is one step, and so is one drag of a handle.
    """

    def __init__(self, panel):
        super().__init__()
        self._panel, self.shown = panel, None

    def start(self):
        """Forget all steps: the fields are as the object is."""
        self.clear()
        self.shown = self._state()

    def settle(self):
        """The object has the values that are shown; what it made of them is no step."""
        self.shown = self._state() or self.shown

    def note(self):
        """Remember what was before the last change, unless a drag has not ended."""
        now = self._state()
        if now not in (None, self.shown) and not self._panel.held_handles():
            self.add(self.shown)
            self.shown = now

    def step(self, back):
        """Return the (values, links) to show, before the last change or after it; None: none."""
        if self._panel.held_handles():
            return None
        if back and self._state() is None:  # a text of the panel is no list of numbers
            return self.shown
        self.note()
        found = self.move(back, lambda _: self.shown)
        if found is not None:
            self.shown = found
        return found

    def _state(self):
        """Return the values of the fields and the names of the sources; None for a bad text."""
        panel = self._panel
        try:
            values = panel.field_values()
        except ValueError:
            return None
        links = {name: panel.links(name) for name in panel.link_names()}
        return values, {
            name: [(obj.Name, element) for obj, element in chosen] for name, chosen in links.items()
        }
