# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all curves: that of objects with options, with a curvature comb."""

from freecad.seamwright.document.curves import arcs, curve
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.option_panel import OptionPanel, sentence
from freecad.seamwright.gui.base.source_box import SourceBox
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.boxes import SpinBox
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.forms import LEAST_WIDTH, make_box, make_summary, make_text
from freecad.seamwright.gui.widgets.number_field import LENGTH, PLAIN, NumberField
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.gui.widgets.steps import remove
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.preferences import COMB_LINES
from freecad.seamwright.plain.summary import counted


class CurvePanel(OptionPanel):
    """Shows and changes one curve; ``created``: Cancel removes it."""

    def release(self):
        """Stop computing; remove handles, the numbers of points and the comb of the input."""
        super().release()
        self.numbers.setChecked(False)
        self.compare.setChecked(False)

    # The window.

    def _build(self):
        self._sketches = []
        super()._build()

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        needs = self.obj.Proxy.NEEDS
        return SourceBox(title, tr("Make the curve from what is selected now: {needs}").format(
            needs=tr(needs)
        ))

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box, layout = make_box(tr("Result"))
        self.summary = make_summary()
        layout.addWidget(self.summary)
        self.comb = QtWidgets.QCheckBox(tr("Curvature comb"))
        self.comb.setToolTip(tr("Draw lines across the curve, as long as its curvature is large"))
        self.compare = QtWidgets.QCheckBox(tr("of the input too"))
        self.compare.setToolTip(tr("Also draw the comb of the edges from which the curve is made"))
        self.comb_scale = NumberField(PLAIN, 100.0, 0.01, refer_to=self.obj)
        self.comb_scale.setMinimumWidth(LEAST_WIDTH // 2)
        self.comb_scale.setToolTip(tr("Length of the lines of the comb"))
        self.comb_lines = SpinBox()
        self.comb_lines.setRange(int(COMB_LINES.least), int(COMB_LINES.largest))
        self.comb_lines.setSuffix(" " + tr("lines"))
        self.comb_lines.setToolTip(tr("Number of lines of the comb"))
        self.numbers = QtWidgets.QCheckBox(tr("Number the points"))
        self.numbers.setToolTip(tr("Show which number of a list belongs to which point"))
        self.numbers.setVisible(bool(self._points()))
        layout.addWidget(self.numbers)
        look = (self.comb_lines, QtWidgets.QLabel(tr("Length")), self.comb_scale)
        for widgets in ((self.comb, self.compare), look):
            line = FlowLayout()
            for widget in widgets:
                line.add(widget)
            layout.addLayout(line)
        layout.addLayout(self._sketch_line())
        return box

    def _sketch_line(self):
        line = FlowLayout()
        self.sketch = QtWidgets.QPushButton(tr("To Sketch"))
        self.sketch.setToolTip(
            tr(
                "Add a sketch of arcs and lines near the planar curve as it is now; the sketch "
                "does not follow the sources"
            )
        )
        self.sketch_mm = NumberField(LENGTH, 1e3, 1e-5, refer_to=self.obj)
        self.sketch_mm.show_number(arcs.SKETCH_MM)
        self.sketch_mm.setToolTip(tr("Largest distance of the arcs from the curve"))
        self.sketch_text = make_text()
        label = QtWidgets.QLabel(tr("Tolerance"))
        for widget in (self.sketch, label, self.sketch_mm):
            line.add(widget)
        line.add(self.sketch_text, 1)
        for widget in (label, self.sketch_mm):
            widget.setVisible(not isinstance(self.obj.Proxy, arcs.Arcs))
        return line

    def _connect(self):
        super()._connect()
        self.comb.toggled.connect(self._show_comb)
        self.compare.toggled.connect(self.obj.ViewObject.Proxy.compare)
        self.comb_scale.valueChanged.connect(self._show_comb)
        self.comb_lines.valueChanged.connect(self._show_comb)
        self.numbers.toggled.connect(self._show_numbers)
        self.sketch.clicked.connect(lambda *_: self.to_sketch())

    def read_fields(self):
        """Show the values of the object."""
        self.comb.setChecked(self.obj.ViewObject.ShowComb)
        self.comb_scale.show_number(self.obj.ViewObject.CombScale)
        self.comb_lines.setValue(self.obj.ViewObject.CombLines)
        super().read_fields()

    # Actions.

    def check(self, name, chosen):
        """Raise SourceError or ValueError where the curve cannot be made from these links."""
        curve.suggested(self.obj.Proxy, chosen)

    def refresh(self):
        """Show the results as they are stored now."""
        super().refresh()
        self.numbers.setVisible(bool(self._points()))
        self._show_numbers()

    def _show_comb(self, *_):
        self.obj.ViewObject.CombScale = self.comb_scale.number()
        self.obj.ViewObject.CombLines = self.comb_lines.value()
        self.obj.ViewObject.ShowComb = self.comb.isChecked()

    def _points(self):
        return self.obj.Proxy.points(report_of(self.obj))

    def _show_numbers(self, *_):
        points = self._points() if self.numbers.isChecked() else []
        labels = [(point, str(number)) for number, point in enumerate(points, 1)]
        self.obj.ViewObject.Proxy.mark([], [], labels)

    def to_sketch(self):
        """Add a sketch of the curve, or say why there is none. Cancel takes it back."""
        if self.computation.busy or self.is_due():
            self.preview(then=self._add_sketch)
        else:
            self._add_sketch()

    def _add_sketch(self):
        if error_text(self.obj):
            messages.show_notice(error_text(self.obj))
            return
        try:
            sketch = arcs.add_sketch(self.obj, self.sketch_mm.number())
        except ValueError as error:
            messages.show_error(sentence(error))
            return
        self._sketches.append(sketch.Name)
        self._doc.recompute()
        self.sketch_text.setText(
            tr("{label} has {curves}").format(
                label=sketch.Label, curves=counted(sketch.GeometryCount, "curve")
            )
        )

    def reject(self):
        """Stop a running computation; without one, take back all changes made in the panel."""
        if not super().reject():
            return False
        for name in self._sketches:  # those that no transaction has removed
            remove(self._doc, name)
        return True
