# SPDX-License-Identifier: LGPL-2.1-or-later
"""The computations of a task panel, one at a time, with a progress bar and a stop button.

Fields stay enabled, so that a value can be typed while the panel computes; all else is locked.
"""

import traceback

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.dock import dock_of
from freecad.seamwright.gui.widgets.fields import OptionForm
from freecad.seamwright.gui.widgets.number_field import Bindable
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain.language import mark, tr

#: Shorter computations do not lock the panel, since it would flicker.
LOCK_AFTER_MS = 300

#: Parts of a panel that hold one of these stay enabled.
FIELDS = (OptionForm, ToleranceForm, Bindable)

STEPS = 1000

CANCELLED = mark("Cancelled")
CHANGED = mark("The model was changed during the computation")


class _Keys(QtCore.QObject):
    """Lets Esc stop a computation wherever the key is pressed in the window.

    The window does not get this key event. Otherwise the view would end the editing, both when the
    key is pressed and when it is released. Letters and digits that are typed on the button Stop,
    which has the focus of a locked part, are no shortcuts of FreeCAD.
    """

    def __init__(self, computation, parent):
        super().__init__(parent)
        self._computation = computation
        self._is_down = False

    def eventFilter(self, window, event):
        """Return whether the event ends here."""
        if event.type() == QtCore.QEvent.ShortcutOverride:
            typed = bool(event.text().strip()) and self._computation.stop_button.hasFocus()
            if typed:
                event.accept()
            return typed
        if event.type() not in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            return False
        if event.key() != QtCore.Qt.Key_Escape:
            return False
        taken = self._is_down
        if event.type() == QtCore.QEvent.KeyRelease:
            self._is_down = False
        elif self._computation.runs:
            self._is_down = taken = True
            QtCore.QTimer.singleShot(0, self._computation.stop)
        return taken


class Computation:
    """The progress line at the top of a panel's form, and the task that it shows."""

    def __init__(self, form):
        """``form``: the widget of the panel; the progress line is added to its layout."""
        self._form = form
        self._task = self._stopped = None
        self._locks, self._ok_is_off = True, False
        self._locked, self._focus = [], None
        self._build()
        Gui.getMainWindow().windowHandle().installEventFilter(_Keys(self, self.line))
        form.destroyed.connect(lambda *_: self._abandon())
        self._timer = QtCore.QTimer(self.line)
        self._timer.setInterval(LOCK_AFTER_MS)
        self._timer.timeout.connect(self.show)

    def _build(self):
        self.line = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(self.line)
        layout.setContentsMargins(0, 0, 0, 0)
        self.text, self.bar = QtWidgets.QLabel(), QtWidgets.QProgressBar()
        self.bar.setRange(0, STEPS)
        self.stop_button = QtWidgets.QPushButton(tr("Stop"))
        self.stop_button.setToolTip(tr("Stop and keep the earlier results. Esc does the same."))
        self.stop_button.clicked.connect(lambda *_: self.stop())
        for widget, stretch in ((self.text, 0), (self.bar, 1), (self.stop_button, 0)):
            layout.addWidget(widget, stretch)
        room = self.line.sizePolicy()
        room.setRetainSizeWhenHidden(True)  # the fields stay under the mouse
        self.line.setSizePolicy(room)
        self.line.hide()
        self._form.layout().insertWidget(0, self.line)  # the bottom of a long form may be hidden

    @property
    def runs(self):
        """Whether a computation runs."""
        return self._task is not None

    @property
    def busy(self):
        """Whether a computation runs for which the panel has to wait."""
        return self._task is not None and self._locks

    def start(self, text, run, done, stopped, locks=True):
        """Run what ``tasks.start`` takes in a thread; a running computation is dropped.

        Calls ``done(found, error)``, or ``stopped()`` where the user stopped the computation.
        ``locks``: the panel waits for it. Returns the Task.
        """
        self.drop()
        self._locks = locks

        def over(found, error):
            self._end()
            done(found, error)

        self._task, self._stopped = tasks.start(run, over), stopped
        self.text.setText(text)
        self._timer.start()
        return self._task

    def follow(self, plan, keep, abandoned):
        """Compute a plan.Plan in a thread, then call ``keep(found, error)``.

        The arguments are those of ``apply``. Where there is nothing to keep, ``abandoned(why)``
        is called instead. Where the object was deleted, nothing is called.
        """

        def done(found, error):
            if plan.object() is None:
                return
            if isinstance(error, plan.cancelled):
                abandoned(tr(CANCELLED))
            elif error is not None and not isinstance(error, plan.failures):
                App.Console.PrintError(
                    "".join(traceback.format_exception(type(error), error, error.__traceback__))
                )
                abandoned(tr("Failed: {error}").format(error=error))
            elif not plan.is_current():
                abandoned(tr(CHANGED))
            else:
                keep(found, error)

        self.start(plan.text, plan.run, done, lambda: abandoned(tr(CANCELLED)))

    def stop(self):
        """Stop for the user; return False where nothing is computed."""
        if self._task is None:
            return False
        stopped = self._stopped
        self.drop()
        stopped()
        return True

    def drop(self):
        """Stop without calling anything."""
        if self._task is not None:
            self._task.cancel()
            self._end()

    def _abandon(self):
        """Stop, since the panel and its widgets are gone."""
        if self._task is not None:
            self._task.cancel()
        self._task = self._stopped = None
        self._timer.stop()

    def _end(self):
        self._task = self._stopped = None
        self._timer.stop()
        stopping = self.stop_button.hasFocus()  # the user did not go to a field meanwhile
        self.line.hide()
        if self._ok_is_off:
            self._enable_ok(True)
        for widget in self._locked:
            widget.setEnabled(True)
        if self._focus is not None and stopping:
            self._focus.setFocus()
        self._locked, self._focus = [], None

    def show(self):
        """Lock the panel and show the progress; a timer calls it when it takes long."""
        if self.line.isHidden():
            if self._locks:
                self._lock()
            self.line.show()
            if self._focus is not None:
                self.stop_button.setFocus()  # so that the panel still gets Esc
        if self._locks:
            self._enable_ok(False)  # FreeCAD makes the button after the panel
        self.bar.setValue(int(self._task.fraction * STEPS))

    def _lock(self):
        children = self._form.findChildren(QtWidgets.QWidget)
        parts = [
            each for each in children if each.parentWidget() == self._form and each != self.line
        ]
        self._locked = [each for each in parts if each.isEnabled() and not _holds_field(each)]
        focus = QtWidgets.QApplication.focusWidget()
        self._focus = focus if any(_is_in(focus, each) for each in self._locked) else None
        for widget in self._locked:
            widget.setEnabled(False)

    def _enable_ok(self, enabled):
        """Enable or disable OK of the dock that holds the panel.

        The button is not stored, since FreeCAD deletes it without PySide noticing.
        """
        self._ok_is_off = not enabled
        dock = dock_of(self._form)
        for box in dock.findChildren(QtWidgets.QDialogButtonBox) if dock is not None else ():
            ok = box.button(QtWidgets.QDialogButtonBox.Ok)
            if ok is not None:
                ok.setEnabled(enabled)


def _holds_field(part):
    return any(isinstance(each, FIELDS) for each in (part, *part.findChildren(QtWidgets.QWidget)))


def _is_in(widget, part):
    return widget is not None and (widget is part or part.isAncestorOf(widget))
