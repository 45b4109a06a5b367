# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all curves: that of objects with options, with a curvature comb."""

from freecad.seamwright.document.curves import arcs, curve
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.option_panel import OptionPanel, SourceBox
from freecad.seamwright.gui.widgets.forms import make_box, make_text
from freecad.seamwright.gui.widgets.qt import QtWidgets


class CurvePanel(OptionPanel):
    """Shows and changes one curve; ``created``: Cancel removes it."""

    def release(self):
        """Stop computing; remove handles, the numbers of points and the comb of the input."""
        super().release()
        self.numbers.setChecked(False)
        self.compare.setChecked(False)

    # The window.

    def build_sources(self, name, title, tip):
        """Return the SourceBox of a property."""
        needs = self.obj.Proxy.NEEDS
        return SourceBox(title, "Make the curve from what is selected now: %s" % needs)

    def build_result(self):
        """Return the box of the result; it has ``summary``."""
        box, layout = make_box("Result")
        self.summary = make_text()
        layout.addWidget(self.summary)
        self.comb = QtWidgets.QCheckBox("Curvature comb")
        self.comb.setToolTip("Draw lines across the curve, as long as its curvature is large")
        self.compare = QtWidgets.QCheckBox("of the input too")
        self.compare.setToolTip("Also draw the comb of the edges from which the curve is made")
        self.comb_scale = QtWidgets.QDoubleSpinBox()
        self.comb_scale.setRange(0.01, 100.0)
        self.comb_scale.setStepType(QtWidgets.QAbstractSpinBox.AdaptiveDecimalStepType)
        self.comb_scale.setToolTip("Length of the lines of the comb")
        self.numbers = QtWidgets.QCheckBox("Number the points")
        self.numbers.setToolTip("Show which number of a list belongs to which point")
        self.numbers.setVisible(bool(self._points()))
        layout.addWidget(self.numbers)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.comb)
        line.addWidget(self.compare, 1)
        line.addWidget(self.comb_scale)
        layout.addLayout(line)
        self.sketch = QtWidgets.QCheckBox("Also make a sketch")
        self.sketch.setToolTip(
            "With OK, add a sketch of the arcs and lines as they are then; it does not follow the "
            "sources"
        )
        self.sketch.setVisible(isinstance(self.obj.Proxy, arcs.Arcs))
        layout.addWidget(self.sketch)
        return box

    def _connect(self):
        super()._connect()
        self.comb.toggled.connect(self._show_comb)
        self.compare.toggled.connect(self.obj.ViewObject.Proxy.compare)
        self.comb_scale.valueChanged.connect(self._show_comb)
        self.numbers.toggled.connect(self._show_numbers)

    def read_fields(self):
        """Show the values of the object."""
        self.comb.setChecked(self.obj.ViewObject.ShowComb)
        self.comb_scale.setValue(self.obj.ViewObject.CombScale)
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
        self.obj.ViewObject.CombScale = self.comb_scale.value()
        self.obj.ViewObject.ShowComb = self.comb.isChecked()

    def _points(self):
        return self.obj.Proxy.points(report_of(self.obj))

    def _show_numbers(self, *_):
        points = self._points() if self.numbers.isChecked() else []
        labels = [(point, str(number)) for number, point in enumerate(points, 1)]
        self.obj.ViewObject.Proxy.mark([], [], labels)

    def _keep(self):
        if self.sketch.isChecked() and not error_text(self.obj):
            arcs.add_sketch(self.obj)
            self._doc.recompute()
        super()._keep()
