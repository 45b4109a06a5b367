# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Corner Fillet: an option panel with radius and setback of each edge."""

from freecad.seamwright.document import corner
from freecad.seamwright.document.plan import Values
from freecad.seamwright.gui.base.new_seams_panel import NewSeamsPanel
from freecad.seamwright.gui.widgets.forms import make_box
from freecad.seamwright.gui.widgets.number_field import LENGTH, NumberField
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.plain import corner_text, lengths
from freecad.seamwright.plain.language import mark, tr

HEADINGS = (
    mark("Edge"), mark("Length {unit}"), mark("Angle"), mark("Radius"), mark("Setback")
)  # fmt: skip
RADIUS, SETBACK = 3, 4

LINES = 4


class CornerPanel(NewSeamsPanel):
    """Shows and changes one Corner Fillet; ``created``: Cancel removes it."""

    _edges = None  # the names of those that are listed

    # The window.

    def build_options(self):
        """Return the box of the edges."""
        box, layout = make_box(tr("Edges"))
        self.edges = QtWidgets.QTableWidget(0, len(HEADINGS))
        self.edges.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.edges.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self.edges.setFocusPolicy(QtCore.Qt.NoFocus)  # its fields have it, and so the keys
        self.edges.setTabKeyNavigation(False)
        self.edges.verticalHeader().hide()
        header = self.edges.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        for column in (RADIUS, SETBACK):
            header.setSectionResizeMode(column, QtWidgets.QHeaderView.Stretch)
        layout.addWidget(self.edges)
        self.same = QtWidgets.QPushButton(tr("Same radius for all"))
        self.same.setToolTip(tr("Give all edges the radius of the first one"))
        layout.addWidget(self.same)
        layout.addWidget(self.options)  # empty; a widget without a parent would be a window
        return [box]

    def _connect(self):
        super()._connect()
        self.edges.cellClicked.connect(lambda line, _: self.select_in_source([self._edges[line]]))
        self.same.clicked.connect(
            lambda *_: [each.show_number(self._values(RADIUS)[0]) for each in self.fields[RADIUS]]
        )

    def read_fields(self):
        """Show the values of the object."""
        super().read_fields()
        self._show_numbers(list(self.obj.Radii), list(self.obj.Setbacks))
        self._timer.stop()
        self.steps.start()

    def field_values(self):
        """Return the values of the fields as ``show_field_values`` takes them."""
        numbers = [self._values(column) for column in (RADIUS, SETBACK)] if self._edges else []
        return {**super().field_values(), "numbers": numbers}

    def show_field_values(self, values):
        """Show the values of fields, for the edges at the vertex that is chosen."""
        super().show_field_values(values)
        if values["numbers"]:
            self._show_numbers(*values["numbers"])

    def list_parts(self):
        """List the edges at the vertex; their fields stay where the edges are the same."""
        seen = Values(self.obj, self._link_values())
        edges, self._lengths, self._problem = corner.corner_of(seen)
        if edges != self._edges:
            self._edges = edges
            self.edges.setRowCount(len(edges))
            height = self.edges.verticalHeader().defaultSectionSize()
            self.edges.setFixedHeight((1 + min(LINES, max(1, len(edges)))) * height + 4)
            self.fields = {column: self._fields(column) for column in (RADIUS, SETBACK)}
            self._order_fields()
        self._describe_edges()

    def suit_parts(self):
        """Show the radius that is suggested for other edges, and no setbacks."""
        if self._edges:
            self._show_numbers([corner_text.suggested_radius_mm(self._lengths)], [0.0])

    def _show_numbers(self, radii, setbacks):
        for column, numbers in ((RADIUS, radii), (SETBACK, setbacks)):
            numbers = numbers * len(self._edges) if len(numbers) == 1 else numbers
            for field, value in zip(self.fields[column], numbers):
                field.show_number(value)

    def _fields(self, column):
        """Return a field for a length in each line of a column."""
        fields = [NumberField(LENGTH, 1e6, refer_to=self.obj) for _ in self._edges]
        for line, field in enumerate(fields):
            if column == SETBACK:
                field.setSpecialValueText(tr("auto"))
                field.setToolTip(tr("Distance from the vertex at which the fillet ends"))
            field.valueChanged.connect(self.changed)
            self.edges.setCellWidget(line, column, field)
        return fields

    def _order_fields(self):
        """Let Tab go through the fields line by line."""
        order = [field for line in zip(*self.fields.values()) for field in line]
        for field, following in zip(order, order[1:]):
            QtWidgets.QWidget.setTabOrder(field, following)

    def _describe_edges(self):
        """Write what is known about the edges.

        Angles and automatic setbacks are known only after the edges were rounded.
        """
        known = {"Edge%d" % edge["edge"]: edge for edge in corner.report_of(self.obj)["edges"]}
        known = {} if self._links else known
        self.edges.setHorizontalHeaderLabels([lengths.titled(heading) for heading in HEADINGS])
        unit = lengths.unit()
        for line, (name, length) in enumerate(zip(self._edges, self._lengths)):
            angle = corner_text.edge_text(known[name]) if name in known else ""
            for column, text in enumerate((name, "%.6g" % (length / unit.mm), angle)):
                self.edges.setItem(line, column, QtWidgets.QTableWidgetItem(text))
            setback = known[name]["setback_mm"] if name in known else None
            automatic = tr("auto") if setback is None else tr("auto: {setback:.4g} {unit}").format(
                setback=setback / unit.mm, unit=unit.name
            )
            self.fields[SETBACK][line].setSpecialValueText(automatic)

    def waiting_text(self):
        """Return which edges would be rounded."""
        return self._problem or corner_text.waiting_text(self._edges)

    def wanted(self):
        """Return the {property: value} of the fields."""
        values = super().wanted()
        if self._edges:
            radii, setbacks = self._values(RADIUS), self._values(SETBACK)
            values["Radii"] = radii[:1] if len(set(radii)) == 1 else radii
            values["Setbacks"] = setbacks if any(setbacks) else []
        return values

    def _values(self, column):
        return [field.number() for field in self.fields[column]]

    # Actions.

    def check(self, name, chosen):
        """Raise ValueError where these links are no corner."""
        corner.check(chosen)

    def elements_of(self, chosen):
        """Return {property: links} for elements of one object."""
        return {"Vertex": chosen}

    def seams(self):
        """Return (seams, tolerances, target) as they are stored now."""
        report = corner.report_of(self.obj)
        return report["seams"], report["tolerance"], corner_text.TARGET
