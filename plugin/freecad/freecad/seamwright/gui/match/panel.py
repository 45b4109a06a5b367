# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Match Surfaces.

It has the faces and the target, the seam before and after, and what the view shows. The document
follows the fields: each change is computed at once.
"""

import FreeCADGui as Gui

from freecad.seamwright.document import match, properties
from freecad.seamwright.gui.base.result_panel import ResultPanel
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.forms import make_box, make_form, make_text
from freecad.seamwright.gui.widgets.live_preview import PreviewTimer
from freecad.seamwright.gui.widgets.number_field import LENGTH, NumberField
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.tasks import documents_rest
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import match_text
from freecad.seamwright.plain.language import tr

#: Delay between the last change and the computation of the preview.
PREVIEW_AFTER_MS = 400

KEPT = ("FirstFace", "SecondFace", "CommonEdge", "Target", "Moves", "MaxMove", "HoldSides")


class MatchPanel(ResultPanel):
    """Shows and changes one Match Surfaces; ``created``: Cancel removes it."""

    def __init__(self, obj, created):
        super().__init__(
            obj,
            created,
            tr("Edit match surfaces"),
            KEPT + tuple(name for name, *_ in match.TOLERANCES),
        )
        self._swapped = False
        self._striped = []
        self._timer = PreviewTimer(PREVIEW_AFTER_MS, self._preview_in_time)
        self._build()
        self.computation = Computation(self.form)
        self.read_fields()
        self._connect()
        self.refresh()
        if created and self._timer.live:
            self.preview()

    def sources(self):
        """Return the objects to which the faces belong."""
        return match.source_objects(self.obj)

    def has_result(self):
        """Return whether the faces match."""
        return bool(self.obj.Matched)

    def is_due(self):
        """Return whether a change has not been computed yet."""
        return self._timer.isActive() or super().is_due()

    def release(self):
        """Stop computing, and remove the stripes."""
        self._timer.stop()
        self._unstripe()

    def _unstripe(self):
        zebra.hide([obj for obj in map(self._doc.getObject, self._striped) if obj is not None])
        self._striped = []

    # The window.

    def _build(self):
        self.form, layout = make_form(tr("Match Surfaces"), "seamwright-match")
        for box in (self._build_faces(), self._build_result(), self._build_tolerances()):
            layout.addWidget(box)
        layout.insertWidget(1, self._timer.button)
        self._timer.button.setVisible(not self._timer.live)

    def _build_faces(self):
        box = QtWidgets.QGroupBox(tr("Faces"))
        layout = QtWidgets.QFormLayout(box)
        self.first, self.second = QtWidgets.QPushButton(), QtWidgets.QPushButton()
        for button, word in ((self.first, tr("First")), (self.second, tr("Second"))):
            button.setToolTip(tr("Select this face in the view"))
            layout.addRow(word, button)
        line = QtWidgets.QHBoxLayout()
        self.moves = QtWidgets.QComboBox()
        for name in match.MOVES:
            self.moves.addItem(tr(name), name)
        self.moves.setToolTip(tr("The face that moves; away from the seam it keeps its shape"))
        self.swap = QtWidgets.QPushButton(tr("Swap"))
        self.swap.setToolTip(tr(
            "Exchange the first and the second face, so that the other one moves"
        ))
        line.addWidget(self.moves, 1)
        line.addWidget(self.swap)
        layout.addRow(tr("Moves"), line)
        self.max_move = NumberField(LENGTH, 1e6)
        self.max_move.setSpecialValueText(tr("no limit"))
        self.max_move.setToolTip(tr("No pole of a surface may move further than this"))
        self.max_move.bind(self.obj, "MaxMove")
        layout.addRow(tr("Largest move"), self.max_move)
        self.hold_sides = QtWidgets.QCheckBox(tr("Hold the boundaries that end at the seam"))
        self.hold_sides.setToolTip(
            tr("Do not move the poles of the two other boundaries that end at the seam")
        )
        layout.addRow(self.hold_sides)
        return box

    def _build_tolerances(self):
        self.tolerances = ToleranceForm(match.TOLERANCES, ("Target", match.TARGETS), self.obj)
        return make_box(tr("Target and tolerances"), self.tolerances)[0]

    def _build_result(self):
        box, layout = make_box(tr("Result"))
        self.summary = make_text()
        layout.addWidget(self.summary)
        headings = [heading for heading, *_ in match_text.table(match.report_of(self.obj))]
        self.table = QtWidgets.QTableWidget(len(headings), 2)
        self.table.setHorizontalHeaderLabels([tr("Before"), tr("After")])
        self.table.setVerticalHeaderLabels(headings)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self.table.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        height = self.table.fontMetrics().height() + 8
        self.table.verticalHeader().setDefaultSectionSize(height)
        self.table.setFixedHeight((len(headings) + 1) * height + 8)
        layout.addWidget(self.table)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(QtWidgets.QLabel(tr("Show")))
        self.before = QtWidgets.QRadioButton(tr("Before"))
        self.after = QtWidgets.QRadioButton(tr("After"))
        self.zebra = QtWidgets.QCheckBox(tr("Zebra stripes"))
        for widget in (self.before, self.after, self.zebra):
            line.addWidget(widget)
        layout.addLayout(line)
        return box

    def _connect(self):
        self.first.clicked.connect(lambda *_: self._select("FirstFace"))
        self.second.clicked.connect(lambda *_: self._select("SecondFace"))
        self.moves.currentIndexChanged.connect(self.changed)
        self.max_move.valueChanged.connect(self.changed)
        self.hold_sides.toggled.connect(self.changed)
        self.tolerances.changed.connect(self.changed)
        self.swap.clicked.connect(self._swap)
        self.after.toggled.connect(lambda *_: self.show(self.after.isChecked()))
        self.zebra.toggled.connect(lambda *_: self.show(self.after.isChecked()))

    def read_fields(self):
        """Show the values of the object."""
        self._swapped = False
        self.moves.setCurrentIndex(self.moves.findData(self.obj.Moves))
        self.max_move.show_number(properties.number(self.obj, "MaxMove"))
        self.max_move.show_expression()
        self.hold_sides.setChecked(self.obj.HoldSides)
        self.tolerances.read_from(self.obj)
        self._timer.stop()
        self.after.setChecked(True)

    def show_expressions(self):
        """Show the expressions of fields; return whether one is another than before."""
        return any([self.max_move.show_expression(), self.tolerances.show_expressions()])

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        self.first.setText(match.link_text(self.obj, "FirstFace"))
        self.second.setText(match.link_text(self.obj, "SecondFace"))
        self.summary.setText(match.error_text(self.obj) or self.obj.Summary)
        for line, (_, *cells) in enumerate(match_text.table(match.report_of(self.obj))):
            for column, text in enumerate(cells):
                self.table.setItem(line, column, QtWidgets.QTableWidgetItem(text))
        self.after.setEnabled(self.obj.Matched)
        self.show(self.after.isChecked())

    def say(self, text):
        """Show this text above the figures."""
        self.summary.setText(text)

    def wanted(self):
        """Return the {property: value} of the fields."""
        names = ["FirstFace", "SecondFace"]
        faces = [getattr(self.obj, name) for name in names]
        return {
            **dict(zip(names, reversed(faces) if self._swapped else faces)),
            "Moves": self.moves.currentData(), "MaxMove": self.max_move.number(),
            "HoldSides": self.hold_sides.isChecked(), **self.tolerances.values()
        }  # fmt: skip

    def _preview_in_time(self):
        """Match now, or retry while FreeCAD changes documents."""
        if documents_rest():
            self.preview()
        else:
            self._timer.start()

    def preview(self, then=None):
        """Match as the fields say."""
        self._timer.stop()
        super().preview(then)

    def computed(self):
        """Show the results; a wanted swap of the faces is done now."""
        self._swapped = False
        super().computed()

    def changed(self, *_):
        """Compute after a short delay."""
        super().changed()
        self._timer.start_if_live()

    def _swap(self, *_):
        self._swapped = not self._swapped
        self._edits += 1
        self.preview()

    def _select(self, name):
        target = match.link(self.obj, name)
        Gui.Selection.clearSelection()
        if target is not None:
            seam_view.select(self._doc, target[0].Name, target[1])

    def show(self, after):
        """Show the match or its sources, with stripes if they are wanted."""
        after = after and self.obj.Matched
        self.obj.ViewObject.Visibility = after
        for source in self.sources():
            source.ViewObject.Visibility = not after
        seen = [self.obj] if after else self.sources()
        if not self.zebra.isChecked():
            self._unstripe()
            return
        fresh = [each for each in seen if each not in zebra.objects(self._doc)]
        if fresh and zebra.show(fresh):
            self._striped += [each.Name for each in fresh]
