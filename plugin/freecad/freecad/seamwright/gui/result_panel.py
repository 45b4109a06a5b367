# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object that stands for its sources: OK keeps what is seen, Cancel takes all of it back.

What is done in the panel is one step that can be undone.
"""

import FreeCADGui as Gui

from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui import messages
from freecad.seamwright.gui.dock import widen_dock
from freecad.seamwright.gui.forms import buttons


class ResultPanel:
    """Shows and changes one object; a subclass builds ``form`` and says what the object is like."""

    DOCK_WIDTH = 440

    def __init__(self, obj, created, step, changeable):
        """``created``: Cancel removes the object. ``step``: name of the step. ``changeable``: names of properties."""
        self.obj = obj
        self._created = created
        self._doc = obj.Document
        self._name = obj.Name
        self._kept = {name: getattr(obj, name) for name in changeable}
        self._ended = False
        self._hidden = [each.Name for each in self.replaced() if not self.has_result() and not each.ViewObject.Visibility]
        if not created:
            self._doc.openTransaction(step)

    # What a subclass says.

    def sources(self):
        """The objects that the result stands for."""
        raise NotImplementedError

    def replaced(self):
        """The objects that are hidden while the result is shown."""
        return self.sources()

    def has_result(self):
        """Whether the object has a shape of its own to show."""
        raise NotImplementedError

    def is_due(self):
        """Whether the fields say something else than what was computed."""
        raise NotImplementedError

    def preview(self):
        """Take over the fields and compute anew."""
        raise NotImplementedError

    def show(self, after):
        """Show the result or its sources."""
        raise NotImplementedError

    def release(self):
        """The panel ends: take back what it changed in the view."""
        raise NotImplementedError

    # What FreeCAD asks of a task panel.

    def getStandardButtons(self):
        """OK and Cancel."""
        return buttons("Ok", "Cancel")

    def open(self):
        """Make the dock that holds the panel wide enough for it."""
        widen_dock(self.form, self.DOCK_WIDTH)

    def accept(self):
        """Keep the result; a failure is said, and the panel stays."""
        if self.is_due() or not self.has_result() or error_text(self.obj):
            self.preview()
        failure = error_text(self.obj)
        if failure:
            messages.show_error(failure)
            return False
        self.show(True)
        self._end()
        self._doc.commitTransaction()
        Gui.getDocument(self._doc.Name).resetEdit()
        return True

    def reject(self):
        """Take back what was done since the panel was opened."""
        self._end()
        replaced = self.replaced()
        if self._doc.HasPendingTransaction:
            self._doc.abortTransaction()
        elif not self._created:
            for name, value in self._kept.items():
                setattr(self.obj, name, value)
            self._doc.recompute()
        if self._created:
            if self._doc.getObject(self._name) is not None:
                self._doc.removeObject(self._name)
            for each in replaced:
                each.ViewObject.Visibility = each.Name not in self._hidden
        elif self.has_result():
            self.show(True)
        Gui.getDocument(self._doc.Name).resetEdit()
        return True

    def leave(self):
        """The panel closes, by OK, by Cancel or because FreeCAD ends the editing."""
        if not self._ended:
            self._end()
            self._doc.commitTransaction()

    def _end(self):
        self._ended = True
        self.release()
