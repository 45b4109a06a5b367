# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a spline: also its points, with handles in the view."""

from freecad.seamwright.document.curves.spline import BETA, FREE, INTERPOLATING
from freecad.seamwright.gui.curves.panel import CurvePanel
from freecad.seamwright.gui.curves.point_box import PointBox
from freecad.seamwright.gui.curves.spline_editor import SplineEditor
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.plain import spline_handles

NO_POINTS = "There are no points: pick some, or select points or edges and press Use selection."

#: Pixels between lines of the first grid.
GRID_PX = 12


class SplinePanel(CurvePanel):
    """Shows and changes one spline; ``created``: Cancel removes it."""

    def __init__(self, obj, created):
        self.editor = None
        self._undone, self._done = [], []
        super().__init__(obj, created)
        self.editor = SplineEditor(self, obj)
        self._enable()

    # The window.

    def _build(self):
        super()._build()
        self.box = PointBox()
        self.table, self.pick = self.box.table, self.box.pick
        layout = self.form.layout()
        layout.insertWidget(layout.indexOf(self.boxes["Sources"]) + 1, self.box)

    def _connect(self):
        super()._connect()
        self.pick.toggled.connect(self._toggle_pick)
        self.box.undo.clicked.connect(lambda *_: self.undo_drag())
        self.box.redo.clicked.connect(lambda *_: self.redo_drag())
        self.box.free.clicked.connect(lambda *_: self._free_ends())
        self.box.back.clicked.connect(lambda *_: self._move_back())
        self.box.handles.toggled.connect(self._toggle_handles)
        self.box.snaps.toggled.connect(self._suit_grid)
        self.comb.toggled.connect(lambda *_: self._load())
        self.table.edited.connect(self._edit)

    def open(self):
        """Take the mouse in the view; without any points, pick some."""
        super().open()
        self.editor.start()
        self._suit_grid()
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
            self.say(NO_POINTS)

    def changed(self, *_):
        """Show the handles of the fields, and compute after a short delay."""
        super().changed()
        self._load()

    def use(self, name, chosen):
        """Let the spline be made from these links, without points of its own and moves."""
        self._end_pick()
        before = self.links(name)
        super().use(name, chosen)
        if self.links(name) != before or self.options.fields["points_mm"].value():
            self._put({"points_mm": [], "moves_mm": []})
            self._done, self._undone = [], []
            self._enable()

    # What the editor asks for.

    def spline_values(self):
        """Return the {argument: value} of the fields. Raises ValueError for a bad text."""
        values = {}
        for argument, field in self.options.fields.items():
            used = field.option.used
            if used is None or used({"family": self.options.fields["family"].value()}):
                values[argument] = field.value()
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

    def grid_mm(self):
        """Return the step of the grid, 0 without one."""
        return self.box.grid.value() if self.box.snaps.isChecked() else 0.0

    def keep_values(self, values):
        """Compute with these values of fields, as one step that ``undo_drag`` takes back."""
        before = self.spline_values()
        changed = {name: value for name, value in values.items() if value != before[name]}
        if not changed:
            return
        self._done.append(self._kept_step(changed, before))
        self._undone = []
        self._put(changed)

    def undo_drag(self):
        """Take the last change of a point, tangent or tension back."""
        self._step(self._done, self._undone)

    def redo_drag(self):
        """Do the last change again that was taken back."""
        self._step(self._undone, self._done)

    def say_picked(self, count, point, what):
        """Say how many points are picked, and where the last one or the mouse is."""
        self.box.say_picked(count, point, what)

    # Actions.

    def _put(self, values):
        for name, value in values.items():
            self.options.fields[name].show_value(value)
        self._enable()
        self.preview()

    def _step(self, taken, kept):
        if not taken:
            return
        values, chosen = taken.pop()
        kept.append(self._kept_step(values, self.spline_values()))
        self._links["Sources"] = chosen
        self._list_sources()
        self._put(values)

    def _kept_step(self, changed, values):
        """Return what ``_step`` brings back: values of fields, and the sources."""
        return {name: values[name] for name in changed}, self.links("Sources")

    def _has_points(self):
        return bool(self.options.fields["points_mm"].value() or self.links("Sources"))

    def _load(self):
        if self.editor is None or self._ended:
            return
        self.editor.load()
        self._enable()
        self._show_table()

    def _enable(self):
        fields = self.options.fields
        self.box.undo.setEnabled(bool(self._done))
        self.box.redo.setEnabled(bool(self._undone))
        interpolates = fields["family"].value() in INTERPOLATING
        tangents = any(any(fields[name].value()) for name in ("start_tangent_mm", "end_tangent_mm"))
        self.box.free.setEnabled(interpolates and tangents)
        self.box.back.setEnabled(bool(fields["moves_mm"].value()))

    def _show_table(self):
        family = self.options.fields["family"].value()
        points = self.editor.points
        if points is None or family not in INTERPOLATING:
            self.table.hide()
            return
        values = self.spline_values()
        columns = [values["tension"]] + ([values["bias"]] if family == BETA else [])
        self.table.show_numbers(len(points), columns)
        self.table.show()

    def _edit(self, name, numbers):
        self.keep_values({**self.spline_values(), name: numbers})

    def _free_ends(self):
        values = self.spline_values()
        self.keep_values({**values, "start_tangent_mm": FREE, "end_tangent_mm": FREE})

    def _move_back(self):
        self.keep_values({**self.spline_values(), "moves_mm": []})

    def _suit_grid(self, *_):
        """Give the grid a step that is seen in the view as it is now."""
        if hasattr(self.editor.view, "graphicsView"):
            pixel_mm = Projection(self.editor.view).size_of_pixel_mm((0, 0, 0))
            self.box.grid.setValue(spline_handles.fair_step(GRID_PX * pixel_mm))

    def _toggle_handles(self, shown):
        self.editor.shown = shown
        self._load()

    def _toggle_pick(self, picks):
        if not picks:
            self._end_pick()
            return
        started = self.editor.pick(self._picked)
        self.box.picked.setVisible(started)
        self.pick.setChecked(started)

    def _end_pick(self):
        if self.editor.picker is not None:
            self.editor.picker.end(True)

    def _picked(self, kept, points, closed):
        self.box.picked.hide()
        self.pick.blockSignals(True)
        self.pick.setChecked(False)
        self.pick.blockSignals(False)
        if kept and points:
            values = self.values_with(points)
            chosen = self.links("Sources")
            self._links["Sources"] = []
            self._list_sources()
            self.keep_values({**values, "closed": values["closed"] or closed})
            if self._done:
                self._done[-1] = self._done[-1][0], chosen
        self._load()
