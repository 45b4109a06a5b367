# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in separate threads; its results are delivered in the thread of the window.

The thread of a task accesses neither documents nor widgets. A timer of the window polls the tasks,
so no thread ever calls into the window.
"""

import contextlib
import gc
import threading

import FreeCAD as App

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets

POLL_EVERY_MS = 30


class Task:
    """Work in a thread; ``fraction`` is the part that is done, 0 to 1."""

    def __init__(self, run, done):
        self.fraction = 0.0
        self.wanted = True
        self._run, self._done = run, done
        self._found = self._error = None
        self._thread = threading.Thread(target=self._work, name="seamwright")

    def start(self):
        """Start the work."""
        self._thread.start()

    def cancel(self):
        """Stop when the work next reports progress; its result is not delivered."""
        self.wanted = False

    def is_over(self):
        """Return whether the thread has ended."""
        return not self._thread.is_alive()

    def join(self):
        """Wait until the thread has ended."""
        self._thread.join()

    def deliver(self):
        """Deliver the result, unless the task was cancelled."""
        if self.wanted:
            self._done(self._found, self._error)

    def _work(self):
        try:
            self._found = self._run(self._progress)
        except BaseException as error:  # delivered in the window's thread
            self._error = error

    def _progress(self, fraction):
        self.fraction = fraction
        return self.wanted


class Tasks:
    """The tasks of the window; a cancelled task counts until its thread has ended."""

    def __init__(self):
        self._running = []
        self._timer = None
        self._collects = False
        self._held = 0

    @property
    def idle(self):
        """Whether no thread works and no result waits for delivery."""
        return not self._running

    def start(self, run, done):
        """Call ``run(progress)`` in a thread and then ``done(found, error)`` in this one.

        ``found`` and ``error`` are the return value of ``run`` and the error that it raised.
        Returns the Task. ``done`` is not called after ``cancel`` of the Task. While a document is
        being recomputed or a dialog waits for its answer, the call is delayed.
        """
        if self._timer is None:
            self._timer = QtCore.QTimer()
            self._timer.setInterval(POLL_EVERY_MS)
            self._timer.timeout.connect(self._poll)
            QtWidgets.QApplication.instance().aboutToQuit.connect(self.end)
        if not self._running:
            self._collects = gc.isenabled()
            gc.disable()  # a garbage collection in another thread would delete widgets there
        task = Task(run, done)
        self._running.append(task)
        task.start()
        self._timer.start()
        return task

    @contextlib.contextmanager
    def hold(self):
        """Delay all results while FreeCAD waits for work that keeps the window alive."""
        self._held += 1
        try:
            yield
        finally:
            self._held -= 1

    def end(self):
        """Cancel all tasks and wait for their threads."""
        for task in self._running:
            task.cancel()
        for task in self._running:
            task.join()
        self._forget(self._running)

    def _poll(self):
        if self._collects and gc.get_count()[0] > gc.get_threshold()[0] > 0:
            gc.collect(1)
        self._forget([task for task in self._running if task.is_over() and not task.wanted])
        while (
            not self._held
            and documents_rest()
            and QtWidgets.QApplication.activeModalWidget() is None
        ):
            over = [task for task in self._running if task.is_over()]
            if not over:
                return
            self._forget(over[:1])
            over[0].deliver()

    def _forget(self, tasks):
        self._running = [task for task in self._running if task not in tasks]
        if not self._running:
            self._timer.stop()
            if self._collects:
                gc.enable()


def documents_rest():
    """Return whether documents may be changed now.

    No document may be within a recompute or an undo, or being opened.
    """
    documents = App.listDocuments().values()
    return not any(doc.Recomputing or doc.Transacting or doc.Restoring for doc in documents)


tasks = Tasks()
