# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Umbrella Fill: the holes to fill, the target, and a table of new seams."""

from freecad.seamwright.document import elements, fill
from freecad.seamwright.gui.base.new_seams_panel import NewSeamsPanel
from freecad.seamwright.gui.base.picked import picked_on
from freecad.seamwright.gui.fill.hole_list import HoleList
from freecad.seamwright.gui.widgets.forms import make_box
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.tolerance_form import ToleranceForm
from freecad.seamwright.plain import fill_text
from freecad.seamwright.plain.language import tr


class FillPanel(NewSeamsPanel):
    """Shows and changes one Umbrella Fill; ``created``: Cancel removes it."""

    TITLE, ICON = "Umbrella Fill", "seamwright-fill"
    PREVIEW_TIP = "Fill the holes with these values"

    def __init__(self, obj, created):
        changeable = [
            "Target",
            "KeepAnyway",
            *(name for name, *_ in fill.ELEMENTS + fill.TOLERANCES),
        ]
        super().__init__(obj, created, tr("Edit umbrella fill"), changeable)

    # The window.

    def build_boxes(self):
        """Return the boxes of the holes and of target and limits."""
        return self._build_holes(), self._build_limits()

    def _build_holes(self):
        box, layout = make_box(tr("Holes"))
        self.which = QtWidgets.QLabel()
        self.holes = HoleList()
        self.pick = QtWidgets.QPushButton(tr("Only selected"))
        self.pick.setToolTip(tr("Fill only the holes whose edges are selected in the view"))
        for widget in (self.which, self.holes, self.pick):
            layout.addWidget(widget)
        return box

    def _build_limits(self):
        self.tolerances = ToleranceForm(fill.TOLERANCES, ("Target", fill.TARGETS))
        self.tolerances.level.setToolTip(
            tr("G0: position only; G1: without a kink; G2: with the same curvature")
        )
        self.keep_anyway = QtWidgets.QCheckBox(tr("Keep anyway"))
        self.keep_anyway.setToolTip(
            tr("Keep a fill even if it misses the target; otherwise the hole stays open")
        )
        self.tolerances.layout().addRow("", self.keep_anyway)
        return make_box(tr("Target and tolerances"), self.tolerances)[0]

    def connect_fields(self):
        """React to changes of the fields."""
        self.holes.changed.connect(self.changed)
        self.holes.clicked_edges.connect(self.select_in_source)
        self.pick.clicked.connect(lambda *_: self.holes.choose_by(self._picked()))
        self.tolerances.changed.connect(self.changed)
        self.keep_anyway.toggled.connect(self.changed)

    def read_fields(self):
        """Show the values of the object."""
        self.tolerances.read_from(self.obj)
        self.keep_anyway.setChecked(self.obj.KeepAnyway)
        self._list_holes()

    def _list_holes(self):
        """List the holes, with a tick at those that are filled; return why there are none."""
        face = ", ".join(elements.names(self.obj, "Face"))
        holes, wanted, text = ([], [], "") if face else fill.holes_of(self.obj)
        self.holes.set_holes(holes, wanted)
        self.which.setText(tr("{face} will be replaced").format(face=face))
        self.which.setVisible(bool(face))
        for widget in (self.holes, self.pick):
            widget.setVisible(not face)
        return text

    def wanted(self):
        """Return the {property: value} of the fields."""
        values = {**self.tolerances.values(), "KeepAnyway": self.keep_anyway.isChecked()}
        holes, chosen = self.holes.holes, self.holes.chosen()
        if holes and chosen != fill.holes_of(self.obj)[1]:
            every = [hole["id"] for hole in fill_text.default_holes(holes)]
            wanted = [] if chosen == every else [hole for hole in holes if hole["id"] in chosen]
            names = ["Edge%d" % min(fill_text.edges_of(hole)) for hole in wanted]
            values["Edges"] = elements.link_to(self.obj, names)
        return values

    def computed(self):
        """Show the results and the holes as they are found now."""
        self._list_holes()
        super().computed()

    # Actions.

    def seams(self):
        """Return (seams, tolerances, target) as they are stored now."""
        report = fill.report_of(self.obj)
        return fill_text.every_seam(report), report["tolerance"], report["target"]

    def begin(self):
        """Say which holes would be filled."""
        text = self._list_holes() or fill_text.waiting_text(
            elements.names(self.obj, "Face"), self.holes.chosen()
        )
        self.fill([], text)
        self.show_before()

    def note(self, chosen):
        """Return why holes miss the target.

        Where no hole was filled, the text above the table gives the reasons.
        """
        report = fill.report_of(self.obj)
        return "\n".join(fill_text.reasons(report)) if fill_text.kept(report) else ""

    def _picked(self):
        """Return the names of the selected elements of the source."""
        return set(picked_on(self.sources()))
