# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of work for which FreeCAD waits, such as a recompute, with a button to cancel it.

Meanwhile only the dialog gets keys and clicks, since others could change or delete the objects that
are computed. Panels compute in threads instead, see computation.py.
"""

import contextlib
import threading
import time

import FreeCADGui as Gui

from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain.language import tr

STEPS = 1000
SHOW_AFTER_MS = 700
UPDATE_EVERY_S = 0.05

INPUT = tuple(
    getattr(QtCore.QEvent, name)
    for name in (
        "Close", "ContextMenu", "DragEnter", "Drop", "InputMethod", "KeyPress", "KeyRelease",
        "MouseButtonDblClick", "MouseButtonPress", "MouseButtonRelease", "MouseMove", "Shortcut",
        "ShortcutOverride", "TabletPress", "TouchBegin", "Wheel",
    )
)  # fmt: skip


@contextlib.contextmanager
def progress_dialog(text):
    """Yield a callable(fraction 0..1) that returns False once the user has cancelled."""
    dialog = QtWidgets.QProgressDialog(text, tr("Cancel"), 0, STEPS, Gui.getMainWindow())
    dialog.setWindowTitle("Seamwright")
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(SHOW_AFTER_MS)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    guard = _Guard(dialog)
    QtWidgets.QApplication.instance().installEventFilter(guard)
    try:
        with tasks.hold():
            yield _Reporter(dialog)
    finally:
        QtWidgets.QApplication.instance().removeEventFilter(guard)
        dialog.close()
        dialog.deleteLater()


class _Guard(QtCore.QObject):
    """Blocks input for all windows except the dialog, even before the dialog is shown.

    Esc cancels wherever it is pressed.
    """

    def __init__(self, dialog):
        super().__init__()
        self._dialog = dialog

    def eventFilter(self, receiver, event):
        """Return whether the event ends here."""
        if event.type() not in INPUT or self._is_for_dialog(receiver):
            return False
        if event.type() == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            self._dialog.cancel()
        if event.type() == QtCore.QEvent.Close:
            event.ignore()
        return True

    def _is_for_dialog(self, receiver):
        if isinstance(receiver, QtWidgets.QWidget):
            return receiver.window() == self._dialog
        return receiver == self._dialog.windowHandle()


class _Reporter:
    """Moves the progress bar; in a worker thread it only returns whether to go on."""

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
