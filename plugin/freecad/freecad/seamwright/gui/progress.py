# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of a long analysis, with a button to cancel it."""

import contextlib
import threading
import time

import FreeCADGui as Gui

from freecad.seamwright.gui.qt import QtCore, QtWidgets

STEPS = 1000
SHOW_AFTER_MS = 700
UPDATE_EVERY_S = 0.05


@contextlib.contextmanager
def progress_dialog(text):
    """Yield a callable(fraction 0..1) that returns False once the user has cancelled."""
    dialog = QtWidgets.QProgressDialog(text, "Cancel", 0, STEPS, Gui.getMainWindow())
    dialog.setWindowTitle("Seamwright")
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(SHOW_AFTER_MS)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    try:
        yield _Reporter(dialog)
    finally:
        dialog.close()
        dialog.deleteLater()


class _Reporter:
    """Moves the bar; from a worker thread it only passes on whether to go on."""

    def __init__(self, dialog):
        self._dialog = dialog
        self._thread = threading.get_ident()
        self._next = 0.0
        self._go_on = True

    def __call__(self, fraction):
        now = time.monotonic()
        if threading.get_ident() == self._thread and now >= self._next:
            self._next = now + UPDATE_EVERY_S
            self._dialog.setValue(min(STEPS - 1, int(fraction * STEPS)))
            QtWidgets.QApplication.processEvents()
            self._go_on = not self._dialog.wasCanceled()
        return self._go_on
