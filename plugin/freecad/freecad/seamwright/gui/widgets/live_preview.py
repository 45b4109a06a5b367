# SPDX-License-Identifier: LGPL-2.1-or-later
"""When a panel computes: shortly after each change, or only when its button is pressed.

The user chooses it in the preferences.
"""

from freecad.seamwright.document import preferences
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain.language import tr


class PreviewTimer(QtCore.QTimer):
    """Calls ``compute`` once, ``after_ms`` after ``start``.

    ``button`` computes too. It is shown where the user wants no computation after each change; then
    ``start`` does nothing, except for a retry.
    """

    def __init__(self, after_ms, compute):
        super().__init__()
        self.live = preferences.live_preview()
        self.button = QtWidgets.QPushButton(tr("Preview"))
        self.button.setToolTip(tr("Compute with the values of the fields"))
        self.button.setVisible(False)
        self.button.clicked.connect(lambda *_: compute())
        self.setSingleShot(True)
        self.setInterval(after_ms)
        self.timeout.connect(compute)

    def start_if_live(self):
        """Start, if the user wants a computation after each change."""
        if self.live:
            self.start()
