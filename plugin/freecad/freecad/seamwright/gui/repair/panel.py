# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Repair Seams: the seams to repair, the target, and each seam's figures."""

import FreeCADGui as Gui

from freecad.seamwright.document import analysis, elements, properties, repair
from freecad.seamwright.document.plan import Plan
from freecad.seamwright.gui.base.picked import picked_on
from freecad.seamwright.gui.base.preview_panel import PreviewPanel
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.scene.surface_colours import CURVATURE, ZEBRA, SurfaceColours
from freecad.seamwright.gui.widgets.boxes import ComboBox
from freecad.seamwright.gui.widgets.element_list import ElementList
from freecad.seamwright.gui.widgets.forms import make_box, make_text
from freecad.seamwright.gui.widgets.number_field import LENGTH, NumberField
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import repair_text, rows
from freecad.seamwright.plain.language import mark, tr

CHOSEN = mark("The seams at these edges:")
NONE, MOVES = mark("None"), mark("Moves")
COLOURS = (
    (NONE, mark("The faces as they look in the document")),
    (MOVES, mark("After: each point coloured by how far it moved")),
    (
        CURVATURE,
        mark(
            "Before and after: each point coloured by its mean curvature, both with the same scale"
        ),
    ),
    (
        ZEBRA,
        mark(
            "Before and after: stripes break where faces meet at an angle, and bend where the "
            "curvature jumps"
        ),
    ),
)
ALL_DEFECTS = mark("All defects. To choose, select rows or edges and add them:")


class RepairPanel(PreviewPanel):
    """Shows and changes one Seam Repair; ``created``: Cancel removes it."""

    TITLE, ICON, COLUMNS = "Repair Seams", "seamwright-repair", repair_text.COLUMNS
    PREVIEW_TIP = "Repair the seams with these values"

    def __init__(self, obj, created):
        self._report = repair.empty_report(obj)
        self._lines = [each.Name for each in _analyses(obj) if each.ViewObject.Visibility]
        changeable = [
            "Target",
            "MaxMove",
            *(name for name, *_ in repair.ELEMENTS + repair.TOLERANCES),
        ]
        super().__init__(obj, created, tr("Edit seam repair"), changeable)

    def sources(self):
        """Return the object whose seams are repaired."""
        return elements.source_objects(self.obj)

    def replaced(self):
        """Return the source and its analyses that were visible when the panel was opened."""
        return self.sources() + [each for each in _analyses(self.obj) if each.Name in self._lines]

    def release(self):
        """Clear the selection, and draw result and source as they were."""
        super().release()
        Gui.Selection.clearSelection()
        self.obj.ViewObject.ShowMoves = False
        self.surface.end()
        self._show_lines(not self.obj.ViewObject.Visibility)

    # The window.

    def build_boxes(self):
        """Return the boxes of the seams and of target and limits."""
        self.colours = ComboBox()
        for index, (name, tip) in enumerate(COLOURS):
            self.colours.addItem(tr(name), name)
            self.colours.setItemData(index, tr(tip), QtCore.Qt.ToolTipRole)
        self._choose(MOVES)
        self.colours.setToolTip(tr("What the colours of the faces show"))
        line = QtWidgets.QHBoxLayout()
        line.addWidget(QtWidgets.QLabel(tr("Colours")))
        line.addWidget(self.colours, 1)
        self.form.layout().addLayout(line)
        return self._build_seams(), self._build_limits()

    def _build_seams(self):
        box = QtWidgets.QGroupBox(tr("Seams"))
        layout = QtWidgets.QFormLayout(box)
        self.lists = {}
        for name, kind, tip in repair.ELEMENTS:
            self.lists[name] = ElementList(lambda kind=kind: self._picked(kind), self._select, tip)
        self.which = make_text()
        layout.addRow(tr("Repair"), self.which)
        layout.addRow("", self.lists["Edges"])
        layout.addRow(tr("Fixed faces"), self.lists["FixedFaces"])
        return box

    def _build_limits(self):
        self.tolerances = ToleranceForm(repair.TOLERANCES, ("Target", repair.TARGETS), self.obj)
        self.max_move = NumberField(LENGTH, 1e6)
        self.max_move.setSpecialValueText(tr("by size of face"))
        self.max_move.setToolTip(
            tr(
                "No point of a face may move further than this. By size of face: a hundredth of "
                "the size of the face plus twice the largest gap of its seams"
            )
        )
        self.max_move.bind(self.obj, "MaxMove")
        self.tolerances.layout().insertRow(1, tr("Largest move"), self.max_move)
        return make_box(tr("Target and limits"), self.tolerances)[0]

    def _choose(self, colours):
        self.colours.setCurrentIndex(self.colours.findData(colours))

    def connect_fields(self):
        """React to changes of the fields, and draw on the surfaces what they ask for."""
        self.surface = SurfaceColours(
            self.obj,
            self.computation,
            surfaces=lambda: self.sources() + ([self.obj] if self.has_result() else []),
            abandoned=lambda: self._choose(NONE),
            changed=lambda: None if self._ended else self.show(self.after.isChecked()),
        )
        for each in self.lists.values():
            each.changed.connect(self.changed)
        self.max_move.valueChanged.connect(self.changed)
        self.tolerances.changed.connect(self.changed)
        self.colours.currentIndexChanged.connect(lambda *_: self.show(self.after.isChecked()))

    def read_fields(self):
        """Show the values of the object."""
        for name, each in self.lists.items():
            each.set_names(elements.names(self.obj, name))
        self.max_move.show_number(properties.number(self.obj, "MaxMove"))
        self.max_move.show_expression()
        self.tolerances.read_from(self.obj)
        self._name_seams()
        self.steps.start()

    def shown(self):
        """Return the values of the fields as ``show_values`` takes them."""
        return {
            "names": {name: each.names() for name, each in self.lists.items()},
            "max_move": self.max_move.number(),
            "tolerances": self.tolerances.values(),
        }

    def show_values(self, values):
        """Show the values of fields."""
        for name, each in self.lists.items():
            each.set_names(values["names"][name])
        self.max_move.suggest(values["max_move"])
        self.tolerances.show_values(values["tolerances"])

    def wanted(self):
        """Return the {property: value} of the fields."""
        chosen = {
            name: elements.link_to(self.obj, each.names()) for name, each in self.lists.items()
        }
        return {**chosen, "MaxMove": self.max_move.number(), **self.tolerances.values()}

    def show_expressions(self):
        """Show the expressions of fields; return whether one is another than before."""
        return any([self.max_move.show_expression(), self.tolerances.show_expressions()])

    # Actions.

    def begin(self):
        """Show the seams that would be treated."""
        self.fill([], "")
        self.show_before()
        plan = Plan(self.obj, {}, repair.candidates_job)

        def keep(found, error):
            plan.end(found, error)
            try:
                self._report, text = plan.results()
            except plan.failures as failure:
                text = repair_text.named(str(failure))
            self.fill(repair_text.build_rows(self._report), text)
            self.show_before()

        self.computation.follow(
            plan,
            keep,
            lambda why: self.say(tr("{why}; press Preview to analyse and repair the seams.").format(
                why=why
            )),
        )

    def stored(self):
        """Return (rows, text) of the results as they are stored now."""
        self._report = repair.report_of(self.obj)
        return repair_text.build_rows(self._report), repair.error_text(self.obj) or self.obj.Summary

    def show(self, after):
        """Show the result or the source, in the wanted colours."""
        wanted = None if self._ended else self.colours.currentData()
        self.obj.ViewObject.ShowMoves = after and self.has_result() and wanted == MOVES
        super().show(after)
        if self._ended:
            return
        on_surface = wanted in (CURVATURE, ZEBRA)
        self._show_lines(not self.obj.ViewObject.Visibility and not on_surface)
        self.surface.show(wanted if on_surface else None)

    def _show_lines(self, visible):
        """Show or hide the analyses of the source."""
        for each in self.replaced():
            if each.Name in self._lines:
                each.ViewObject.Visibility = visible

    def abandoned(self, why):
        """Say why a repair has no result, and show again the colours that it interrupted."""
        super().abandoned(why)
        self.show(self.after.isChecked())

    def fill(self, built, text):
        """Show these rows, and the text above them."""
        super().fill(built, text)
        self.table.setColumnHidden(repair_text.CURVATURE_COLUMN, self._report["target"] != "G2")
        self.table.fit_columns()

    def changed(self, *_):
        """A field differs from what was computed."""
        super().changed()
        self._name_seams()

    def _name_seams(self):
        self.which.setText(tr(CHOSEN if self.lists["Edges"].names() else ALL_DEFECTS))

    def _picked(self, kind):
        """Return the selected elements of a kind, on the source or on the result.

        Both have the same names.
        """
        own = (self.obj, *self.sources())
        return [name for name in picked_on(own) if name.startswith(kind)]

    def _select(self, name):
        if self.sources():
            Gui.Selection.clearSelection()
            seam_view.select(self._doc, self.shown_object().Name, name)

    def marked(self, chosen, shown):
        """Return (report, seams) of rows as they are in the shown object."""
        which = "after" if shown == self.obj and repair_text.is_done(self._report) else "before"
        by_number = {seam["before"]["id"]: seam[which] for seam in self._report["seams"]}
        report = rows.located(by_number.values(), self._report["tolerance"], shown.Name)
        return report, [by_number[row.seam] for row in chosen]

    def note(self, chosen):
        """Return the full reasons why the seams of the chosen rows were not repaired.

        The column is too narrow for them.
        """
        return "\n".join(
            "%s: %s" % (row.cells[0], row.cells[-1])
            for row in chosen
            if row.state == repair_text.NOT_REPAIRED
        )


def _analyses(obj):
    """Return the analyses of the source of a repair; their lines show it before the repair."""
    return [
        each
        for each in obj.Document.Objects
        if analysis.is_analysis(each) and obj.Source in each.Analysed
    ]
