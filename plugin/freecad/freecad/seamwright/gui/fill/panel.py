# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Umbrella Fill: an option panel with the holes to fill."""

from freecad.seamwright.document import elements, fill
from freecad.seamwright.document.plan import Values
from freecad.seamwright.gui.base.new_seams_panel import SOURCE, NewSeamsPanel
from freecad.seamwright.gui.base.picked import picked_on
from freecad.seamwright.gui.fill.hole_list import HoleList
from freecad.seamwright.gui.scene import seam_view
from freecad.seamwright.gui.widgets.forms import make_box
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import fill_misses, fill_text
from freecad.seamwright.plain.language import tr

FACE = "Face"


class FillPanel(NewSeamsPanel):
    """Shows and changes one Umbrella Fill; ``created``: Cancel removes it.

    Fills that are not kept are drawn while the panel is open and shows the model after.
    """

    def release(self):
        """Stop computing, and draw the new faces like the others."""
        super().release()
        self.obj.ViewObject.Proxy.show_missed(False)

    def has_after(self):
        """Return whether there are fills to show, kept or not."""
        return self.has_result() or not self.obj.Rejected.isNull()

    # The window.

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box = super().build_result()
        self.allow = QtWidgets.QPushButton(tr("Take these tolerances"))
        self.allow.setToolTip(
            tr(
                "Allow what the best fill needs, so that it can be kept as one that meets the "
                "target"
            )
        )
        self.allow.hide()
        box.layout().insertWidget(1, self.allow)
        return box

    def build_options(self):
        """Return the boxes of the holes and of the options."""
        box, layout = make_box(tr("Holes"))
        self.which = QtWidgets.QLabel()
        self.holes = HoleList()
        self.pick = QtWidgets.QPushButton(tr("Only selected"))
        self.pick.setToolTip(tr("Fill only the holes whose edges are selected in the view"))
        for widget in (self.which, self.holes, self.pick):
            layout.addWidget(widget)
        return [box, *super().build_options()]

    def _connect(self):
        super()._connect()
        self.tolerances.level.setToolTip(
            tr("G0: position only; G1: without a kink; G2: with the same curvature")
        )
        self.allow.clicked.connect(lambda *_: self._allow())
        self.holes.changed.connect(self.changed)
        self.holes.clicked_edges.connect(self._show_hole)
        self.pick.clicked.connect(lambda *_: self.holes.choose_by(self._picked()))

    def _show_hole(self, names):
        """Select the edges of a hole if the source is shown, and turn the view to them."""
        self.select_in_source(names)
        seam_view.look_at_edges(self.links(SOURCE)[0][0], names)

    def list_parts(self):
        """List the holes, with a tick at those that are filled."""
        seen = Values(self.obj, self._link_values())
        face = ", ".join(elements.names(seen, FACE))
        holes, self._ticked, self._problem = ([], [], "") if face else fill.holes_of(seen)
        self.holes.set_holes(holes, self._ticked)
        self.which.setText(tr("{face} will be replaced").format(face=face))
        self.which.setVisible(bool(face))
        for widget in (self.holes, self.pick):
            widget.setVisible(not face)

    def field_values(self):
        """Return the values of the fields as ``show_field_values`` takes them."""
        return {**super().field_values(), "holes": self.holes.chosen()}

    def show_field_values(self, values):
        """Show the values of fields, for the holes of the model that is chosen."""
        super().show_field_values(values)
        self.holes.set_holes(self.holes.holes, values["holes"])

    def listed(self, name):
        """Return the links that the box of a property lists: the face to replace, or the model."""
        return self.links(FACE) or self.links(SOURCE)

    def waiting_text(self):
        """Return which holes would be filled."""
        return self._problem or fill_text.waiting_text(
            elements.names(self.obj, FACE), self.holes.chosen()
        )

    def wanted(self):
        """Return the {property: value} of the fields."""
        values = super().wanted()
        holes, chosen = self.holes.holes, self.holes.chosen()
        if holes and chosen != self._ticked:
            every = [hole["id"] for hole in fill_text.default_holes(holes)]
            wanted = [] if chosen == every else [hole for hole in holes if hole["id"] in chosen]
            names = ["Edge%d" % min(fill_text.edges_of(hole)) for hole in wanted]
            source = Values(self.obj, values)
            values["Edges"] = elements.link_to(source, names)
        return values

    # Actions.

    def refresh(self):
        """Show the results as they are stored now, and the tolerances that a fill would need."""
        super().refresh()
        self.allow.setVisible(bool(fill_misses.allowed(fill.report_of(self.obj))))

    def show(self, after):
        """Show the result or its source, and after also the fills that are not kept."""
        super().show(after)
        if not self._ended:
            self.obj.ViewObject.Proxy.show_missed(after)

    def mark_chosen(self):
        """Mark the seams of the chosen rows; those of fills that are not kept where they are drawn.
        """
        super().mark_chosen()
        if not self.after.isChecked():
            return
        seams = [self.seams()[0][row.index] for row in self.table.chosen()]
        left = [seam for seam in seams if seam.get("along")]
        if left and len(left) == len(seams):
            lines = [along["points"] for seam in left for along in seam["along"]]
            classes = [seam["class"] for seam in left for _ in seam["along"]]
            marks = [fill_misses.worst(seam) for seam in left]
            self.obj.ViewObject.Proxy.mark(lines, classes, marks)
            size = self.obj.Rejected.BoundBox.DiagonalLength
            seam_view.look_at(self.obj, {}, left, size, lines)

    def _allow(self):
        """Give the fields the tolerances that the fills need; compute."""
        for name, argument, *_ in fill.TOLERANCES:
            value = fill_misses.allowed(fill.report_of(self.obj)).get(argument)
            if value is not None:
                self.tolerances.fields[name].suggest(value)
        self.preview()

    def check(self, name, chosen):
        """Raise SourceError or ValueError where these links are nothing to fill."""
        fill.check(chosen)

    def elements_of(self, chosen):
        """Return {property: links} for elements of one object."""
        return {
            name: [(obj, element) for obj, element in chosen if element.startswith(kind)]
            for name, kind, _ in fill.ELEMENTS
        }

    def seams(self):
        """Return (seams, tolerances, target) as they are stored now."""
        report = fill.report_of(self.obj)
        return fill_text.every_seam(report), report["tolerance"], report["target"]

    def note(self, chosen):
        """Return why holes miss the target.

        Where no hole was filled, the text above the table gives the reasons.
        """
        report = fill.report_of(self.obj)
        return "\n".join(fill_text.reasons(report)) if fill_text.kept(report) else ""

    def _picked(self):
        """Return the names of the selected elements of the source."""
        return set(picked_on(self.sources()))
