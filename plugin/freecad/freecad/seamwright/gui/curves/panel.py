# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all curves: their sources, a field for each of their options, the result.

The document follows the fields: each change is computed at once.
"""

from freecad.seamwright.document import sources
from freecad.seamwright.document.curves import arcs, curve
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.gui.base.result_panel import ResultPanel
from freecad.seamwright.gui.curves.fields import OptionForm
from freecad.seamwright.gui.curves.picked import picked
from freecad.seamwright.gui.scene.handle import Handle
from freecad.seamwright.gui.widgets import messages
from freecad.seamwright.gui.widgets.computation import Computation
from freecad.seamwright.gui.widgets.forms import make_box, make_form, make_text
from freecad.seamwright.gui.widgets.qt import QtCore, QtWidgets
from freecad.seamwright.gui.widgets.tasks import documents_rest
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.summary import counted

#: Delay between the last change and the computation of the preview.
PREVIEW_AFTER_MS = 300

#: Interval at which handles are asked for their numbers.
READ_HANDLES_MS = 60

#: Names of sources that are listed; of more the number is told.
LISTED = 6


class CurvePanel(ResultPanel):
    """Shows and changes one curve; ``created``: Cancel removes it."""

    DOCK_WIDTH = 430

    def __init__(self, obj, created):
        kind = obj.Proxy
        names = ["Sources", *(option.name for option in kind.OPTIONS)]
        super().__init__(obj, created, "Edit %s" % kind.LABEL.lower(), names)
        self._links = None
        self._handles, self._handle_timer = {}, QtCore.QTimer()
        self._handle_timer.setInterval(READ_HANDLES_MS)
        self._handle_timer.timeout.connect(self._read_handles)
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.setInterval(PREVIEW_AFTER_MS)
        self._timer.timeout.connect(self._preview_in_time)
        self._build()
        self.computation = Computation(self.form)
        self.read_fields()
        self._connect()
        self.refresh()
        if created:
            self.preview()

    def sources(self):
        """Return the objects to which the points and edges belong."""
        return curve.Curve.source_objects(self.obj)

    def replaced(self):
        """Return no objects: a curve does not take the place of its sources."""
        return []

    def has_result(self):
        """Return whether there is a curve."""
        return not self.obj.Shape.isNull()

    def is_due(self):
        """Return whether a change has not been computed yet."""
        return self._timer.isActive() or super().is_due()

    def release(self):
        """Stop computing; remove handles, the numbers of points and the comb of the input."""
        self._timer.stop()
        self.numbers.setChecked(False)
        self._show_handles()
        self.compare.setChecked(False)

    # The window.

    def _build(self):
        kind = self.obj.Proxy
        self.form, layout = make_form(kind.LABEL, kind.ICON)
        self.chosen = make_text()
        self.use = QtWidgets.QPushButton("Use selection")
        self.use.setToolTip("Make the curve from what is selected now: %s" % kind.NEEDS)
        line = QtWidgets.QHBoxLayout()
        line.addWidget(self.chosen, 1)
        line.addWidget(self.use)
        box, inner = make_box("Made from")
        inner.addLayout(line)
        layout.addWidget(box)
        self.options = OptionForm(self.obj, kind.OPTIONS)
        layout.addWidget(make_box("Options", self.options)[0])
        layout.addWidget(self._build_result())
        layout.addStretch(1)

    def _build_result(self):
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
        self.options.changed.connect(self.changed)
        self.use.clicked.connect(lambda *_: self._use_selection())
        self.comb.toggled.connect(self._show_comb)
        self.compare.toggled.connect(self.obj.ViewObject.Proxy.compare)
        self.comb_scale.valueChanged.connect(self._show_comb)
        self.numbers.toggled.connect(self._show_numbers)

    def read_fields(self):
        """Show the values of the object."""
        self._links = None
        self.options.show_values(curve.values_of(self.obj))
        self.comb.setChecked(self.obj.ViewObject.ShowComb)
        self.comb_scale.setValue(self.obj.ViewObject.CombScale)
        self._list_sources()
        self._timer.stop()

    def _list_sources(self):
        links = curve.links_of(self.obj) if self._links is None else self._links
        names = [".".join(filter(None, (obj.Label, name))) for obj, name in links]
        text = ", ".join(names[:LISTED]) or "nothing"
        more = len(names) - LISTED
        self.chosen.setText(text + (" and %d more" % more if more > 0 else ""))
        self.chosen.setToolTip("%s: %s" % (counted(len(names), "source"), ", ".join(names)))

    # Actions.

    def refresh(self):
        """Show the results as they are stored now."""
        self._list_sources()
        self.say(error_text(self.obj) or self.obj.Summary)
        self.show(True)
        self.numbers.setVisible(bool(self._points()))
        self._show_numbers()
        self._show_handles()

    def say(self, text):
        """Show this text as the result."""
        self.summary.setText(text)

    def wanted(self):
        """Return the {property: value} of the fields. Raises ValueError for a bad text."""
        values = self.options.values()
        if self._links is not None:
            values["Sources"] = _grouped(self._links)
        return values

    def show(self, after):
        """Show the curve where there is one."""
        self.obj.ViewObject.Visibility = self.has_result()

    def _show_comb(self, *_):
        self.obj.ViewObject.CombScale = self.comb_scale.value()
        self.obj.ViewObject.ShowComb = self.comb.isChecked()

    def _points(self):
        return self.obj.Proxy.points(report_of(self.obj))

    def _show_numbers(self, *_):
        points = self._points() if self.numbers.isChecked() else []
        labels = [(point, str(number)) for number, point in enumerate(points, 1)]
        self.obj.ViewObject.Proxy.mark([], [], labels)

    def _show_handles(self):
        """Put the handles to the values of their fields; make those that are missing."""
        places = self.obj.Proxy.handles(report_of(self.obj)) if not self._ended else {}
        root = self.obj.ViewObject.RootNode
        for argument, (origin, step) in places.items():
            field = self.options.fields[argument]
            if argument not in self._handles:
                self._handles[argument] = Handle()
                root.addChild(self._handles[argument].node)
            size = self.obj.Shape.BoundBox.DiagonalLength
            self._handles[argument].show(origin, step, field.value(), size)
        for argument in [each for each in self._handles if each not in places]:
            root.removeChild(self._handles.pop(argument).node)
        if self._handles:
            self._handle_timer.start()
        else:
            self._handle_timer.stop()

    def _read_handles(self):
        """Give the fields the numbers to which their handles were dragged."""
        for argument, handle in self._handles.items():
            value = handle.dragged_to()
            if value is not None:
                self.options.fields[argument].drag(value)

    def _preview_in_time(self):
        """Compute now, or retry while FreeCAD changes documents."""
        if documents_rest():
            self.preview()
        else:
            self._timer.start()

    def preview(self, then=None):
        """Compute as the fields say; a bad text is named in place of a result."""
        self._timer.stop()
        try:
            self.wanted()
        except ValueError as error:
            self.say(str(error))
            if then is not None:
                messages.show_notice(str(error))
            return
        super().preview(then)

    def computed(self):
        """Show new results."""
        self._links = None
        super().computed()

    def changed(self, *_):
        """Compute after a short delay."""
        super().changed()
        self._timer.start()

    def _use_selection(self):
        chosen = [link for link in picked() if link[0] != self.obj]
        try:
            curve.suggested(self.obj.Proxy, chosen)
            loops = [each for each, _ in chosen if self.obj in each.OutListRecursive]
            if loops:
                raise ValueError("%s is made from this curve: choose others" % loops[0].Label)
        except (sources.SourceError, ValueError, kernel.KernelUnavailable) as error:
            messages.show_error(sentence(error))
            return
        self._links = chosen
        self._list_sources()
        self._edits += 1
        self.preview()

    def _keep(self):
        if self.sketch.isChecked() and not error_text(self.obj):
            arcs.add_sketch(self.obj)
            self._doc.recompute()
        super()._keep()


def _grouped(links):
    """Return links as a property returns them: names of one object in a row are together."""
    found = []
    for obj, name in links:
        if found and found[-1][0] == obj:
            found[-1] = (obj, (*found[-1][1], name))
        else:
            found.append((obj, (name,)))
    return found


def sentence(error):
    """Return the text of an error as a sentence."""
    text = str(error).rstrip(".")
    return "%s%s." % (text[:1].upper(), text[1:])
