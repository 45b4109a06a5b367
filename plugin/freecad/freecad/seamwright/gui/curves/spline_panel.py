# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a spline: also its points, with handles in the view."""

from freecad.seamwright.document.curves.spline import BETA, FREE, NU
from freecad.seamwright.gui.curves.panel import CurvePanel
from freecad.seamwright.gui.curves.point_box import PointBox
from freecad.seamwright.gui.curves.spline_editor import SplineEditor
from freecad.seamwright.plain.language import mark, tr

NO_POINTS = mark(
    "There are no points: pick some, or select points or edges and press Use selection."
)


class SplinePanel(CurvePanel):
    """Shows and changes one spline; ``created``: Cancel removes it."""

    def __init__(self, obj, created):
        self.editor = None
        super().__init__(obj, created)
        self.editor = SplineEditor(self, obj)
        self.box.enable(self.steps, self.options.fields)

    # The window.

    def _build(self):
        super()._build()
        self.box = PointBox(self.obj)
        self.table, self.pick = self.box.table, self.box.pick
        layout = self.form.layout()
        layout.insertWidget(layout.indexOf(self.boxes["Sources"]) + 1, self.box)

    def _connect(self):
        super()._connect()
        self.pick.toggled.connect(self._toggle_pick)
        self.box.undo.clicked.connect(lambda *_: self.step(back=True))
        self.box.redo.clicked.connect(lambda *_: self.step(back=False))
        free = {"start_tangent_mm": FREE, "end_tangent_mm": FREE}
        self.box.free.clicked.connect(lambda *_: self._change(free))
        self.box.back.clicked.connect(lambda *_: self._change({"moves_mm": []}))
        self.box.handles.toggled.connect(self._toggle_handles)
        self.box.snaps.toggled.connect(lambda *_: self.box.suit_grid(self.editor.view))
        self.comb.toggled.connect(lambda *_: self._load())
        self.table.edited.connect(lambda name, numbers: self._change({name: numbers}))
        self.table.moved.connect(self._move)

    def open(self):
        """Take the mouse in the view; without any points, pick some."""
        super().open()
        self.editor.start()
        self.box.suit_grid(self.editor.view)
        self._load()
        if self._created and not self._has_points():
            self.box.snaps.setChecked(True)
            self.pick.setChecked(True)

    def release(self):
        """Stop computing; remove handles, the numbers of points and the comb of the input."""
        super().release()
        if self.editor is not None:
            self.editor.end()

    def accept(self):
        """Keep the result; points that are being picked are used."""
        self._end_pick()
        return super().accept()

    def refresh(self):
        """Show the results as they are stored now."""
        super().refresh()
        self._load()

    def preview(self, then=None):
        """Compute as the fields say; without any points there is nothing to compute."""
        if self._has_points() or then is not None:
            super().preview(then)
        else:
            self._timer.stop()
            self.say(tr(NO_POINTS))

    def changed(self, *_):
        """Show the handles of the fields, and compute after a short delay."""
        super().changed()
        self._load()

    def take(self, name, chosen):
        """Let the spline be made from these links, without points of its own and moves; compute."""
        self._end_pick()
        for argument in ("points_mm", "moves_mm"):
            self.options.fields[argument].show_value([])
        super().take(name, chosen)
        self._load()

    # What the editor asks for.

    def spline_values(self):
        """Return the {argument: value} of the fields; the last numbers where a text is bad."""
        values = {}
        for argument, field in self.options.fields.items():
            used = field.option.used
            if used is None or used({"family": self.options.fields["family"].value()}):
                values[argument] = field.last_value()
            else:
                values[argument] = field.option.default
        return values

    def values_with(self, points):
        """Return the values for own points; points that are added have no tension, and bias 1."""
        values = {**self.spline_values(), "points_mm": points, "moves_mm": []}
        for name, default in (("tension", 0.0), ("bias", 1.0)):
            numbers = values[name]
            if len(numbers) > 1:
                more = len(points) - len(numbers)
                values[name] = (numbers + [default] * more)[: max(len(points), 1)]
        return values

    def keep_values(self, values, sources=None):
        """Compute with these values of fields, as one step that can be taken back.

        ``sources``: links instead of those that there are.
        """
        before, chosen = self.spline_values(), self.links("Sources")
        changed = {name: value for name, value in values.items() if value != before[name]}
        if changed or sources not in (None, chosen):
            self._links["Sources"] = chosen if sources is None else sources
            self._list_sources()
            for name, value in changed.items():
                self.options.fields[name].show_value(value)
            self.preview()
            self.box.enable(self.steps, self.options.fields)

    def put(self, values, names):
        """Show these values of fields and sources, as PanelSteps has them; compute."""
        super().put(values, names)
        self._load()

    # Actions.

    def _has_points(self):
        return bool(self.options.fields["points_mm"].value() or self.links("Sources"))

    def _load(self):
        if self.editor is None or self._ended:
            return
        self.editor.load()
        self.box.enable(self.steps, self.options.fields)
        self._show_table()

    def _show_table(self):
        self.table.setVisible(self.editor.given is not None)
        if self.editor.given is not None:
            values = self.spline_values()
            names = {NU: ("tension",), BETA: ("tension", "bias")}.get(values["family"], ())
            self.table.show_points(self.editor.given, [values[name] for name in names])

    def _change(self, values):
        self.keep_values({**self.spline_values(), **values})

    def _move(self, place, point):
        self.keep_values(self.editor.with_point(self.spline_values(), place, point))

    def _toggle_handles(self, shown):
        self.editor.shown = shown
        self._load()

    def _toggle_pick(self, picks):
        if not picks:
            self._end_pick()
            return
        started = self.editor.pick(self._picked)
        self.box.picked.setVisible(started)
        if started and not self._has_points():
            self.say("")  # there is nothing but what is picked
        self._check_pick(started)

    def _check_pick(self, picks):
        self.pick.blockSignals(True)
        self.pick.setChecked(picks)
        self.pick.blockSignals(False)

    def _end_pick(self):
        if self.editor.picker is not None:
            self.editor.picker.end(True)

    def _picked(self, kept, points, links, closed):
        """Keep picked points; the spline follows them if all are vertices."""
        self.box.picked.hide()
        self._check_pick(False)
        if kept and points:
            values = self.values_with(points)
            values["closed"] = values["closed"] or closed
            follows = all(links)
            if follows:
                values["points_mm"] = []
            self.keep_values(values, sources=links if follows else [])
        elif not self._has_points():
            self.say(tr(NO_POINTS))
        self._load()
