# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Corner Fillet: radius and setback of each edge, and a table of new seams."""

from freecad.seamwright.document import corner, elements
from freecad.seamwright.gui.base.new_seams_panel import NewSeamsPanel
from freecad.seamwright.gui.widgets.forms import make_box
from freecad.seamwright.gui.widgets.number_field import LENGTH, NumberField
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import corner_text
from freecad.seamwright.plain.language import mark, tr

HEADINGS = (
    mark("Edge"), mark("Length mm"), mark("Angle"), mark("Radius"), mark("Setback")
)  # fmt: skip
RADIUS, SETBACK = 3, 4

LINES = 4


class CornerPanel(NewSeamsPanel):
    """Shows and changes one Corner Fillet; ``created``: Cancel removes it."""

    TITLE, ICON = "Corner Fillet", "seamwright-corner"
    PREVIEW_TIP = "Round the corner with these values"

    def __init__(self, obj, created):
        self._edges, self._lengths, self._problem = corner.corner_of(obj)
        changeable = ["Vertex", "Radii", "Setbacks", *(name for name, *_ in corner.TOLERANCES)]
        super().__init__(obj, created, tr("Edit corner fillet"), changeable)

    # The window.

    def build_boxes(self):
        """Return the boxes of the edges and of the tolerances."""
        return self._build_edges(), self._build_limits()

    def _build_edges(self):
        box, layout = make_box(tr("Edges at {names}").format(
            names=", ".join(elements.names(self.obj, "Vertex"))
        ))
        self.edges = QtWidgets.QTableWidget(len(self._edges), len(HEADINGS))
        self.edges.setHorizontalHeaderLabels([tr(heading) for heading in HEADINGS])
        self.edges.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.edges.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self.edges.verticalHeader().hide()
        header = self.edges.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        for column in (RADIUS, SETBACK):
            header.setSectionResizeMode(column, QtWidgets.QHeaderView.Stretch)
        self.fields = {column: self._fields(column) for column in (RADIUS, SETBACK)}
        height = self.edges.verticalHeader().defaultSectionSize()
        self.edges.setFixedHeight((1 + min(LINES, max(1, len(self._edges)))) * height + 4)
        layout.addWidget(self.edges)
        self.same = QtWidgets.QPushButton(tr("Same radius for all"))
        self.same.setToolTip(tr("Give all edges the radius of the first one"))
        layout.addWidget(self.same)
        return box

    def _fields(self, column):
        """Return a field for a length in each line of a column."""
        fields = [NumberField(LENGTH, 1e6, refer_to=self.obj) for _ in self._edges]
        for line, field in enumerate(fields):
            if column == SETBACK:
                field.setSpecialValueText(tr("auto"))
                field.setToolTip(tr("Distance from the vertex at which the fillet ends"))
            self.edges.setCellWidget(line, column, field)
        return fields

    def _build_limits(self):
        self.tolerances = ToleranceForm(corner.TOLERANCES, obj=self.obj)
        return make_box(tr("Tolerances"), self.tolerances)[0]

    def connect_fields(self):
        """React to changes of the fields."""
        for field in self.fields[RADIUS] + self.fields[SETBACK]:
            field.valueChanged.connect(self.changed)
        self.tolerances.changed.connect(self.changed)
        self.edges.cellClicked.connect(lambda line, _: self.select_in_source([self._edges[line]]))
        self.same.clicked.connect(
            lambda *_: [each.show_number(self._values(RADIUS)[0]) for each in self.fields[RADIUS]]
        )

    def read_fields(self):
        """Show the values of the object."""
        self.tolerances.read_from(self.obj)
        for column, numbers in ((RADIUS, self.obj.Radii), (SETBACK, self.obj.Setbacks)):
            numbers = list(numbers) * len(self._edges) if len(numbers) == 1 else list(numbers)
            for field, value in zip(self.fields[column], numbers):
                field.show_number(value)
        self._describe_edges()

    def show_expressions(self):
        """Show the expressions of fields; return whether one is another than before."""
        return self.tolerances.show_expressions()

    def _describe_edges(self):
        """Write what is known about the edges.

        Angles and automatic setbacks are known only after the edges were rounded.
        """
        known = {"Edge%d" % edge["edge"]: edge for edge in corner.report_of(self.obj)["edges"]}
        for line, (name, length) in enumerate(zip(self._edges, self._lengths)):
            angle = corner_text.edge_text(known[name]) if name in known else ""
            for column, text in enumerate((name, "%.6g" % length, angle)):
                self.edges.setItem(line, column, QtWidgets.QTableWidgetItem(text))
            setback = known[name]["setback_mm"] if name in known else None
            automatic = tr("auto") if setback is None else tr("auto: {setback:.4g} mm").format(
                setback=setback
            )
            self.fields[SETBACK][line].setSpecialValueText(automatic)

    def wanted(self):
        """Return the {property: value} of the fields."""
        values = self.tolerances.values()
        if self._edges:
            radii, setbacks = self._values(RADIUS), self._values(SETBACK)
            values["Radii"] = radii[:1] if len(set(radii)) == 1 else radii
            values["Setbacks"] = setbacks if any(setbacks) else []
        return values

    def _values(self, column):
        return [field.number() for field in self.fields[column]]

    # Actions.

    def seams(self):
        """Return (seams, tolerances, target) as they are stored now."""
        report = corner.report_of(self.obj)
        return report["seams"], report["tolerance"], corner_text.TARGET

    def begin(self):
        """Say which edges would be rounded."""
        self.fill([], self._problem or corner_text.waiting_text(self._edges))
        self.show_before()

    def refresh(self):
        """Show the results as they are stored now."""
        super().refresh()
        self._describe_edges()
