# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table widget of the seams: widths of its columns, keys, context menu."""

from freecad.seamwright.gui.widgets.forms import show_seams_in
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.plain import lengths, rows
from freecad.seamwright.plain.language import mark, tr

HEIGHT = 260

#: Columns that become narrower than their texts where the panel has no room, and how narrow, in
#: pixels: figures as wide as most numbers, not as an enclosure "0.0918..0.0952". Of other columns
#: only the headings do.
ELASTIC = {"edge_text": 40, "face_text": 58, **dict.fromkeys(rows.SHOWN, 66)}

#: Headings of so few letters stay whole; the room beside a heading, in pixels.
SHORT, MARGIN = 5, 14

#: The least width of a column, in pixels.
SMALLEST = 34

#: The rows that decide how wide a column is.
MEASURED_ROWS = 50

#: key, text, keys that do the same; None: a line
MENU = (
    ("copy", mark("Copy rows"), QtGui.QKeySequence.Copy),
    ("all", mark("Select all"), QtGui.QKeySequence.SelectAll),
    None,
    ("zoom", mark("Zoom to seam"), QtCore.Qt.Key_Return),
    ("select", mark("Select edges"), None),
    ("repair", mark("Repair these\u2026"), None),
    None,
    ("csv", mark("Export CSV\u2026"), None),
    ("json", mark("Export JSON\u2026"), None),
)

#: The entries for which a row must be selected.
OF_ROWS = ("copy", "zoom", "select", "repair")


class SeamTableView(QtWidgets.QTableView):
    """``asked`` is emitted with the key of a chosen entry of MENU."""

    asked = QtCore.Signal(str)

    def __init__(self, model):
        super().__init__()
        self.by_keys = False  # whether the user just moved with the keys
        self._fitting, self._held, self._users_widths = True, False, False
        self._widths = {}
        self.setModel(model)
        show_seams_in(self, HEIGHT)
        self.setTextElideMode(QtCore.Qt.ElideRight)
        self.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
        self.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        header.setMinimumSectionSize(SMALLEST)
        header.setTextElideMode(QtCore.Qt.ElideRight)
        header.viewport().installEventFilter(self)
        header.sectionResized.connect(self._column_resized)
        self.setSortingEnabled(True)
        self._fitting = False

    # Columns.

    def fit_columns(self, new_texts=False):
        """Fit the columns to their texts and to the panel.

        Widths that the user chose stay. ``new_texts``: there are other texts.
        """
        if self._users_widths:
            return
        self._fitting = True
        if new_texts:
            self.horizontalHeader().setResizeContentsPrecision(MEASURED_ROWS)
            columns = [
                column
                for column in range(self.model().columnCount())
                if not self.isColumnHidden(column)
            ]
            self._widths = {column: self._widths_of(column) for column in columns}
        room = self.viewport().width()
        for column, width in zip(self._widths, _fitted(list(self._widths.values()), room)):
            self.setColumnWidth(column, width)
        self._fitting = False

    def _widths_of(self, column):
        """Return (least width, width of the texts, width of texts and heading) of a column."""
        texts, shown = self.sizeHintForColumn(column) + 1, rows.COLUMNS[column]
        title = lengths.titled(shown.title)
        heading = self.horizontalHeader().fontMetrics().boundingRect(title).width() + MARGIN
        whole = max(texts, heading)
        least = ELASTIC.get(shown.field, max(texts, SMALLEST))
        if len(title) <= SHORT and shown.field not in ELASTIC:
            least = max(least, heading)
        least = min(least, whole)
        return least, max(least, texts), whole

    def _column_resized(self, *_):
        # Hiding a column and the first layout resize columns too, also while a mouse button is held
        # elsewhere: the double click that opens the panel.
        self._users_widths = self._users_widths or (self._held and not self._fitting)

    def eventFilter(self, header, event):
        """Note whether a mouse button is held on the headings."""
        if event.type() in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._held = True
        elif event.type() == QtCore.QEvent.MouseButtonRelease:
            self._held = False
        return super().eventFilter(header, event)

    def resizeEvent(self, event):
        """Fit the columns to the new width."""
        super().resizeEvent(event)
        if self._widths:
            self.fit_columns()

    # Keys.

    def event(self, event):
        """Keep the keys of the table from the shortcuts of the window."""
        if event.type() == QtCore.QEvent.ShortcutOverride and (
            event.matches(QtGui.QKeySequence.Copy) or event.matches(QtGui.QKeySequence.SelectAll)
        ):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        """Enter zooms, Ctrl+C copies; the other keys move as in every table."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self._ask("zoom")
        elif event.matches(QtGui.QKeySequence.Copy):
            self._ask("copy")
        else:
            self.by_keys = True
            super().keyPressEvent(event)
            self.by_keys = False

    # Context menu.

    def contextMenuEvent(self, event):
        """Show the context menu."""
        menu = self.build_menu()
        menu.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        menu.popup(event.globalPos())

    def build_menu(self):
        """Return the context menu of the selected rows."""
        menu = QtWidgets.QMenu(self)
        has_rows = self.selectionModel().hasSelection()
        for entry in MENU:
            if entry is None:
                menu.addSeparator()
                continue
            key, text, keys = entry
            action = menu.addAction(tr(text))
            action.setObjectName(key)
            action.setEnabled(has_rows or key not in OF_ROWS)
            if keys is not None:
                action.setShortcut(QtGui.QKeySequence(keys))
            action.triggered.connect(lambda *_, key=key: self._ask(key))
        return menu

    def _ask(self, key):
        if key == "all":
            self.selectAll()
        elif key not in OF_ROWS or self.selectionModel().hasSelection():
            self.asked.emit(key)


def _fitted(widths, room):
    """Return widths that fit the room, from (least, that of the texts, whole) of each column.

    The texts get room before the headings. Where it is not enough, all columns get the same part
    of what they lack. The last one takes the room that is left.
    """
    fitted = [least for least, *_ in widths]
    for goals in zip(*(wanted for _, *wanted in widths)):
        lacking = sum(goals) - sum(fitted)
        part = min(1.0, max(0.0, (room - sum(fitted)) / lacking)) if lacking else 0.0
        fitted = [int(own + part * (goal - own)) for own, goal in zip(fitted, goals)]
    if fitted:
        fitted[-1] += max(0, room - sum(fitted))
    return fitted
