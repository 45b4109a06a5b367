# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option panel of an object that takes the place of its sources.

It has a choice to show the model before or after.
"""

from freecad.seamwright.gui.base.option_panel import OptionPanel
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.forms import make_show_line, offer_after
from freecad.seamwright.plain.language import tr


class ReplacingPanel(OptionPanel):
    """Shows and changes one object; ``created``: Cancel removes it.

    A subclass puts ``build_show()`` into the box of the result.
    """

    def __init__(self, obj, created):
        self._covered = []  # names of the objects in whose place the result was shown
        super().__init__(obj, created)

    # What the base asks for.

    def replaced(self):
        """Return the sources: the result takes their place."""
        return self.sources()

    def wants_result(self):
        """Return whether the view shows the model after."""
        return self.after.isChecked()

    def reject(self):
        """Stop a running computation; without one, take back all changes made in the panel."""
        replaced = self.sources()
        if not super().reject():
            return False
        if not self._created:
            self._uncover([each.Name for each in replaced])
        return True

    def has_after(self):
        """Return whether there is something to show as the model after."""
        return self.has_result()

    # The window.

    def build_show(self):
        """Return the line with the choice of what the view shows."""
        self.show_line, self.before, self.after = make_show_line()
        return self.show_line

    def _connect(self):
        super()._connect()
        self.after.toggled.connect(lambda *_: self.show(self.wants_result()))

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        offer_after(self.before, self.after, self.has_after())
        super().refresh()

    def show(self, after):
        """Show the result or its sources."""
        after = after and self.has_result()
        self.obj.ViewObject.Visibility = after
        for source in self.sources():
            source.ViewObject.Visibility = not after
            self._covered.append(source.Name)
        self._covered = self._uncover(self._covered)

    def _uncover(self, names):
        """Show the objects of these names that are no sources any more; return the others."""
        kept = [each.Name for each in self.sources()]
        for name in set(names).difference(kept):
            found = self._doc.getObject(name)
            if found is not None:
                found.ViewObject.Visibility = True
        return kept

    def use(self, name, chosen):
        """Let a property have these links, or say why it cannot; compute."""
        if chosen and all(each == self.obj for each, _ in chosen):
            messages.show_error(
                tr("The result itself is selected. Show Before, and select in the model.")
            )
            return
        super().use(name, chosen)

    def take(self, name, chosen):
        """Let a property have these links, which are usable; compute, and show the result."""
        if self.after.isEnabled():
            self.after.setChecked(True)
        super().take(name, chosen)
