# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page Seamwright of FreeCAD's preferences."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.seamwright.document import analysis, preferences, properties
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets import ink, messages
from freecad.seamwright.gui.widgets.boxes import SpinBox
from freecad.seamwright.gui.widgets.forms import make_box
from freecad.seamwright.gui.widgets.qt import QtCore, QtGui, QtWidgets
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import palette
from freecad.seamwright.plain import preferences as table
from freecad.seamwright.plain.language import tr

#: The group of FreeCAD's preferences that has this page.
GROUP = "Seamwright"

#: The values that were refused last; the next page shows them.
_refused = {}

COLOURED = tuple(zip((*palette.CLASSES, *palette.LEVELS), table.COLOURS))


class ColourButton(QtWidgets.QPushButton):
    """A button in a colour; a click asks for another one."""

    def __init__(self, name):
        super().__init__()
        self._name = name
        self.rgb = (0, 0, 0)
        self.setToolTip(tr("Colour of {name}; click to choose another one").format(name=name))
        self.clicked.connect(lambda *_: self._ask())

    def show_rgb(self, rgb):
        """Show a colour."""
        self.rgb = rgb
        pixmap = QtGui.QPixmap(32, 14)
        pixmap.fill(QtGui.QColor(*rgb))
        self.setIcon(QtGui.QIcon(pixmap))
        self.setIconSize(pixmap.size())

    def _ask(self):
        colour = QtWidgets.QColorDialog.getColor(QtGui.QColor(*self.rgb), self, self._name)
        if colour.isValid():
            self.show_rgb((colour.red(), colour.green(), colour.blue()))


class PreferencesPage:
    """The page; FreeCAD calls ``loadSettings`` and, with OK or Apply, ``saveSettings``."""

    def __init__(self, parent=None):
        self.form = QtWidgets.QWidget()
        self.form.setWindowTitle(tr("General"))
        layout = QtWidgets.QVBoxLayout(self.form)
        for box in (self._tolerances(), self._colours(), self._computing()):
            layout.addWidget(box)
        self.reset_button = QtWidgets.QPushButton(tr("Defaults of this page"))
        self.reset_button.setToolTip(tr("Show the values that Seamwright has at first"))
        self.reset_button.clicked.connect(lambda *_: self._show(table.defaults()))
        line = QtWidgets.QHBoxLayout()
        line.addStretch(1)
        line.addWidget(self.reset_button)
        layout.addLayout(line)
        layout.addStretch(1)

    def _tolerances(self):
        self.tolerances = ToleranceForm(properties.TOLERANCES)
        box, layout = make_box(tr("Tolerances of new objects"), self.tolerances)
        note = QtWidgets.QLabel(
            tr(
                "Objects that exist keep theirs. The new faces of Umbrella Fill have tolerances of "
                "their own."
            )
        )
        note.setWordWrap(True)
        layout.addWidget(note)
        self.problem = QtWidgets.QLabel()
        self.problem.setWordWrap(True)
        layout.addWidget(self.problem)
        self.tolerances.changed.connect(self._check)
        return box

    def _colours(self):
        box = QtWidgets.QGroupBox(tr("Colours of seams"))
        grid = QtWidgets.QGridLayout(box)
        self.colours = {}
        rows = ((tr("By class"), palette.CLASSES), (tr("By level"), palette.LEVELS))
        names = {entry.key: preference.name for entry, preference in COLOURED}
        for row, (title, entries) in enumerate(rows):
            grid.addWidget(QtWidgets.QLabel(title), 2 * row, 0)
            for column, entry in enumerate(entries, 1):
                button = ColourButton(tr(entry.name))
                self.colours[names[entry.key]] = button
                grid.addWidget(QtWidgets.QLabel(tr(entry.name)), 2 * row, column)
                grid.addWidget(button, 2 * row + 1, column)
        return box

    def _computing(self):
        box = QtWidgets.QGroupBox(tr("Computing and drawing"))
        layout = QtWidgets.QFormLayout(box)
        self.threads = _whole_number(table.THREADS)
        self.threads.setSpecialValueText(tr("one for each processor"))
        self.threads.setToolTip(tr("How many threads a computation uses"))
        self.comb_lines = _whole_number(table.COMB_LINES)
        self.comb_lines.setToolTip(
            tr("How dense the lines of new curvature combs are on each curve")
        )
        self.stripes = _whole_number(table.ZEBRA_STRIPES)
        self.stripes.setToolTip(
            tr("How many light stripes zebra stripes have on a whole ball, in panels too")
        )
        self.live = QtWidgets.QCheckBox(tr(table.LIVE_PREVIEW.label))
        self.live.setToolTip(
            tr("Compute shortly after each change of a field; otherwise when Preview is pressed")
        )
        layout.addRow(tr(table.THREADS.label), self.threads)
        layout.addRow(tr(table.COMB_LINES.label), self.comb_lines)
        layout.addRow(tr(table.ZEBRA_STRIPES.label), self.stripes)
        layout.addRow(self.live)
        return box

    # Methods that FreeCAD calls.

    def loadSettings(self):
        """Show what is stored, or what was refused."""
        self._show({**preferences.values(), **_refused})
        _refused.clear()

    def saveSettings(self):
        """Store the fields, and draw seams in the new colours.

        Where that is refused, the page is shown again and says why: FreeCAD closes the dialog.
        """
        try:
            preferences.store(self.values())
        except ValueError as error:
            messages.say(tr("The preferences are not stored: {error}.").format(error=error))
            _refused.update(self.values())
            QtCore.QTimer.singleShot(0, _show_again)
            return
        preferences.use_colours()
        redraw()

    # Fields.

    def _check(self):
        """Say which of the fields are not allowed."""
        try:
            table.check(self.tolerances.values())
            problem = ""
        except ValueError as error:
            problem = str(error) + "."
        self.problem.setStyleSheet(ink.style(ink.WRONG, self.problem))
        self.problem.setText(problem)
        self.problem.setVisible(bool(problem))

    def values(self):
        """Return {name: value} of the fields."""
        return {
            **self.tolerances.values(),
            **{name: palette.packed(button.rgb) for name, button in self.colours.items()},
            table.THREADS.name: self.threads.value(),
            table.COMB_LINES.name: self.comb_lines.value(),
            table.ZEBRA_STRIPES.name: self.stripes.value(),
            table.LIVE_PREVIEW.name: self.live.isChecked(),
        }

    def _show(self, values):
        self.tolerances.show_values(values)
        for name, button in self.colours.items():
            button.show_rgb(palette.unpacked(values[name]))
        self.threads.setValue(values[table.THREADS.name])
        self.comb_lines.setValue(values[table.COMB_LINES.name])
        self.stripes.setValue(values[table.ZEBRA_STRIPES.name])
        self.live.setChecked(values[table.LIVE_PREVIEW.name])


def _show_again():
    """Open the preferences at this page, unless they are still open."""
    if QtWidgets.QApplication.activeModalWidget() is None:
        Gui.showPreferences(GROUP, 0)
    _refused.clear()


def _whole_number(preference):
    field = SpinBox()
    field.setRange(int(preference.least), int(preference.largest))
    return field


def redraw():
    """Draw seams and stripes of all documents that are open as the preferences are now."""
    for doc in App.listDocuments().values():
        zebra.redraw(doc)
        for obj in filter(analysis.is_analysis, doc.Objects):
            if obj.ViewObject is not None:
                obj.ViewObject.Proxy.refresh_later(obj)
