# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in threads of its own; what came of it is told in the thread of the window.

A thread of a task touches neither documents nor widgets. A timer of the window looks at the tasks,
so no thread ever calls into the window.
"""

import contextlib
import gc
import threading

import FreeCAD as App

from freecad.seamwright.gui.qt import QtCore, QtWidgets

LOOK_EVERY_MS = 30


class Task:
    """Work in a thread; ``fraction`` is how much of it is done, 0 to 1."""

    def __init__(self, run, done):
        self.fraction = 0.0
        self.wanted = True
        self._run, self._done = run, done
        self._found = self._error = None
        self._thread = threading.Thread(target=self._work, name="seamwright")

    def start(self):
        """Begin to work."""
        self._thread.start()

    def cancel(self):
        """Stop as soon as the work asks; nothing is told of it any more."""
        self.wanted = False

    def is_over(self):
        """Whether the thread has ended."""
        return not self._thread.is_alive()

    def join(self):
        """Wait until the thread has ended."""
        self._thread.join()

    def tell(self):
        """Say what came of it, to somebody who still wants to know."""
        if self.wanted:
            self._done(self._found, self._error)

    def _work(self):
        try:
            self._found = self._run(self._progress)
        except BaseException as error:  # told in the window's thread
            self._error = error

    def _progress(self, fraction):
        self.fraction = fraction
        return self.wanted


class Tasks:
    """The tasks of the window. Those that were cancelled count until their threads have ended."""

    def __init__(self):
        self._running = []
        self._timer = None
        self._collects = False
        self._held = 0

    @property
    def idle(self):
        """Whether no thread works and nothing is left to be told."""
        return not self._running

    def start(self, run, done):
        """Call ``run(progress)`` in a thread and then, in this one, ``done(found, error)``: what it
        returned, or raised.

        ``done`` is not called after ``cancel`` of the Task, which is returned; nor while a document
        is being recomputed, or a dialog waits for its answer, but after that.
        """
        if self._timer is None:
            self._timer = QtCore.QTimer()
            self._timer.setInterval(LOOK_EVERY_MS)
            self._timer.timeout.connect(self._look)
            QtWidgets.QApplication.instance().aboutToQuit.connect(self.end)
        if not self._running:
            self._collects = gc.isenabled()
            gc.disable()  # a collection in another thread would delete widgets there
        task = Task(run, done)
        self._running.append(task)
        task.start()
        self._timer.start()
        return task

    @contextlib.contextmanager
    def hold(self):
        """Within it nothing is told: work goes on that FreeCAD waits for, and lets the window live
        meanwhile."""
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

    def _look(self):
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
            over[0].tell()

    def _forget(self, tasks):
        self._running = [task for task in self._running if task not in tasks]
        if not self._running:
            self._timer.stop()
            if self._collects:
                gc.enable()


def documents_rest():
    """Whether documents may be changed now: none is within a recompute or a step back, or being
    opened."""
    documents = App.listDocuments().values()
    return not any(doc.Recomputing or doc.Transacting or doc.Restoring for doc in documents)


tasks = Tasks()
