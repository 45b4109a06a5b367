# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an object that takes the place of its sources.

OK keeps what is shown; Cancel takes everything back. All changes in the panel are one step that can
be undone.
"""

import FreeCADGui as Gui

from freecad.seamwright.document import expressions
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.document.properties import error_text, plain
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.dock import widen_dock
from freecad.seamwright.gui.widgets.forms import buttons
from freecad.seamwright.gui.widgets.keys import PanelKeys
from freecad.seamwright.gui.widgets.later import find, later, later_named
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.steps import remove, step
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import mark, tr

#: Endings of the text that says why a computation has no result.
NO_RESULTS, OLD_RESULTS = (
    mark("; there are no results yet."),
    mark("; the results are those of the last complete run."),
)


class ResultPanel:
    """Shows and changes one object; a subclass builds ``form`` and describes the object.

    It computes in a thread; the subclass makes ``computation`` when it builds its form. The object
    stays unchanged until the computation has ended.
    """

    DOCK_WIDTH = 440

    def __init__(self, obj, created, title, changeable):
        """``created``: Cancel removes the object.

        ``title``: of the transaction. ``changeable``: names of properties.
        """
        self.obj = obj
        self._created = created
        self._doc = obj.Document
        self._name, self._doc_name = obj.Name, obj.Document.Name
        self._kept = {name: getattr(obj, name) for name in changeable}
        self._kept_expressions = expressions.expressions(obj)
        self._ended = False
        self._edits = self._computed_edits = 0
        self._seen = self._state()
        self._touched = [each.Name for each in self._followers() if "Touched" in each.State]
        self._hidden = [
            each.Name
            for each in self.replaced()
            if not self.has_result() and not each.ViewObject.Visibility
        ]
        if not created:
            self._doc.openTransaction(title)
        self._covering = self._hide_what_covers()

    def _hide_what_covers(self):
        """Hide what is made from the result and lies over it; return the names."""
        over = [
            each
            for each in self.obj.InListRecursive
            if self.replaced()
            and each.isDerivedFrom("Part::Feature")
            and each.ViewObject.Visibility
            and self.obj not in getattr(each, "Group", ())
        ]
        for each in over:
            each.ViewObject.Visibility = False
        return [each.Name for each in over]

    # Methods that a subclass defines.

    def sources(self):
        """Return the objects whose place the result takes."""
        raise NotImplementedError

    def replaced(self):
        """Return the objects that are hidden while the result is shown."""
        return self.sources()

    def has_result(self):
        """Return whether the object has a shape of its own to show."""
        raise NotImplementedError

    def wanted(self):
        """Return the {property: value} of the fields."""
        raise NotImplementedError

    def read_fields(self):
        """Show the values of the object."""
        raise NotImplementedError

    def show_expressions(self):
        """Show the expressions of fields; return whether one is another than before."""
        raise NotImplementedError

    def refresh(self):
        """Show the results as they are stored now."""
        raise NotImplementedError

    def say(self, text):
        """Show this text above the results."""
        raise NotImplementedError

    def show(self, after):
        """Show the result or its sources."""
        raise NotImplementedError

    def release(self):
        """Undo the panel's changes of the view when the panel ends."""
        raise NotImplementedError

    # Methods that FreeCAD calls.

    def getStandardButtons(self):
        """Return OK and Cancel."""
        return buttons("Ok", "Cancel")

    def open(self):
        """Make the dock that holds the panel wide enough for it, and take its keys."""
        widen_dock(self.form, self.DOCK_WIDTH)
        PanelKeys(self)
        self.form.destroyed.connect(lambda *_: self._closed())

    def _closed(self):
        """Another program closed the dialog, which FreeCAD does not tell: end the editing."""
        if self._ended or find(self._doc_name, self._name) is None:
            return
        self._end()

        def end_editing(obj):
            self._settle()
            Gui.getDocument(obj.Document.Name).resetEdit()

        later_named(self._doc_name, self._name, end_editing)

    def accept(self):
        """Keep the result; compute it first where that is due.

        On failure, a message is shown and the panel stays open.
        """
        if self.computation.busy:
            return False
        if self.is_due() or not self.has_result() or error_text(self.obj):
            self.preview(then=self._keep)
            return False
        self._keep()
        return True

    def _keep(self):
        failure = error_text(self.obj)
        if failure:
            messages.show_notice(failure)
            return
        self.show(True)
        self._end()
        self._doc.commitTransaction()
        Gui.getDocument(self._doc.Name).resetEdit()

    def reject(self):
        """Stop a running computation; without one, take back all changes made in the panel."""
        if self.computation.stop():
            return False
        self._end()
        replaced = self.replaced()
        if self._doc.HasPendingTransaction:
            self._doc.abortTransaction()
            self._forget_touches()
        elif not self._created:
            with step(self._doc, tr("Restore")):
                expressions.bind(self.obj, self._kept_expressions)
                for name, value in self._kept.items():
                    setattr(self.obj, name, value)
                self._doc.recompute()
        if self._created:
            remove(self._doc, self._name)
            for each in replaced:
                each.ViewObject.Visibility = each.Name not in self._hidden
        elif self.has_result():
            self.show(True)
        Gui.getDocument(self._doc.Name).resetEdit()
        return True

    def _followers(self):
        return [self.obj, *self.obj.InListRecursive]

    def _forget_touches(self):
        """Let all that is again as before the panel count as up to date, if it did then."""
        if self._doc.getObject(self._name) is None:
            return
        for each in self._followers():
            if "Touched" in each.State and each.Name not in self._touched:
                each.purgeTouched()

    def leave(self):
        """The panel closes, by OK, by Cancel or because FreeCAD ends the editing.

        An object that was never computed is removed.
        """
        if self._ended:
            return
        self._end()
        self._settle()

    def _settle(self):
        self._doc.commitTransaction()
        if self._created and not self.obj.Outcome:
            later(self.obj, lambda obj: remove(obj.Document, obj.Name))

    def _end(self):
        self._ended = True
        self.computation.drop()
        self.release()
        for name in self._covering:
            if self._doc.getObject(name) is not None:
                self._doc.getObject(name).ViewObject.Visibility = True

    # Keys.

    @property
    def ended(self):
        """Whether OK or Cancel was pressed, or FreeCAD ended the editing."""
        return self._ended

    def key(self, name):
        """Esc is Cancel; undo and redo are those of the panel, which stays."""
        if name == "escape":
            if not QtWidgets.QApplication.mouseButtons():
                self.reject()
        else:
            self.step(back=name == "undo")

    def step(self, back):
        """Take the last change in the panel back, or do it again."""

    # Actions.

    def is_due(self):
        """Return whether a field was changed after the last computation."""
        return self._edits != self._computed_edits

    def changed(self, *_):
        """A field differs from what was computed."""
        self._edits += 1

    def preview(self, then=None):
        """Compute with the values of the fields, show the results, and finally call ``then``."""
        try:
            plan = Plan(self.obj, self.wanted())
        except kernel.KernelUnavailable as error:
            messages.show_error(str(error))
            return
        edits = self._edits

        def keep(found, error):
            plan.apply(found, error)
            self._computed_edits, self._seen = edits, self._state()
            self.computed()
            if then is not None:
                then()

        self.computation.follow(plan, keep, self.abandoned)

    def computed(self):
        """Show new results."""
        self.refresh()

    def abandoned(self, why):
        """Say why a computation has no result."""
        self.say(why + tr(OLD_RESULTS if self.has_result() else NO_RESULTS))

    def reload(self):
        """Show the object as it is now, after a change from outside such as an undo."""
        state = self._state()
        if self._ended or state == self._seen:
            return
        if state[0] != self._seen[0]:
            self.read_fields()
            self._computed_edits = self._edits
        elif self.show_expressions():
            self.changed()
        self._seen = state
        self.refresh()

    def _state(self):
        return (
            [plain(getattr(self.obj, name)) for name in self._kept],
            expressions.expressions(self.obj),
            self.obj.Report,
            error_text(self.obj),
        )
