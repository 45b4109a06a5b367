# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option panel of an object that takes the place of its sources.

It has a choice to show the model before or after, and zebra stripes on what is shown.
"""

from freecad.seamwright.gui.base.option_panel import OptionPanel
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.forms import make_show_line, offer_after
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain.language import tr


class ReplacingPanel(OptionPanel):
    """Shows and changes one object; ``created``: Cancel removes it.

    A subclass puts ``build_show()`` into the box of the result.
    """

    def __init__(self, obj, created):
        self._covered = []  # names of the objects in whose place the result was shown
        self._striped = []  # names of those that got stripes
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

    def release(self):
        """Stop computing, and remove the stripes."""
        super().release()
        self._unstripe()

    # The window.

    def build_show(self):
        """Return the line with the choice of what the view shows."""
        self.show_line, self.before, self.after = make_show_line()
        self.zebra = QtWidgets.QCheckBox(tr("Zebra stripes"))
        self.show_line.add(self.zebra)
        return self.show_line

    def _connect(self):
        super()._connect()
        for choice in (self.after, self.zebra):
            choice.toggled.connect(lambda *_: self.show(self.wants_result()))

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        offer_after(self.before, self.after, self.has_after())
        super().refresh()

    def show(self, after):
        """Show the result or its sources, with stripes if they are wanted."""
        after = after and self.has_result()
        self.obj.ViewObject.Visibility = after
        for source in self.sources():
            source.ViewObject.Visibility = not after
            self._covered.append(source.Name)
        self._covered = self._uncover(self._covered)
        if self.zebra.isChecked() and not self._ended:
            self._stripe([self.obj] if after else self.sources())
        else:
            self._unstripe()

    def _stripe(self, seen):
        fresh = [each for each in seen if each not in zebra.objects(self._doc)]
        if fresh and zebra.show(fresh):
            self._striped += [each.Name for each in fresh]

    def _unstripe(self):
        zebra.hide([obj for obj in map(self._doc.getObject, self._striped) if obj is not None])
        self._striped = []

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
