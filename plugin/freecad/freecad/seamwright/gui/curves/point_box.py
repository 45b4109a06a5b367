# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel of a spline that is about its points."""

from freecad.seamwright.document.curves.spline import INTERPOLATING
from freecad.seamwright.gui.curves.point_table import PointTable
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.widgets.flow import FlowLayout
from freecad.seamwright.gui.widgets.forms import make_text
from freecad.seamwright.gui.widgets.number_field import LENGTH, NumberField
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import spline_handles
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.summary import capital, counted

HOW_TO_PICK = mark(
    "Click adds a point, at a vertex or on the grid; Ctrl: free. Backspace removes the last point, "
    "a click on the first one closes, Enter ends, Esc cancels."
)

#: Pixels between lines of the grid that is suggested.
GRID_PX = 12


class PointBox(QtWidgets.QGroupBox):
    """Buttons ``pick``, ``undo``, ``redo``, ``free`` and ``back``, the text ``picked``, the
    ``table``, and the fields ``handles``, ``snaps`` and ``grid``."""

    def __init__(self, obj):
        """``obj``: the spline."""
        super().__init__(tr("Points"))
        self.pick = _button(
            tr("Pick points"),
            tr(HOW_TO_PICK)
            + tr(
                " If all points are vertices, the spline follows them; else the points are its "
                "own, and it follows no sources."
            ),
        )
        self.pick.setCheckable(True)
        self.undo = _button(tr("Undo"), tr("Take the last drag or change of a point back (Ctrl+Z)"))
        self.redo = _button(tr("Redo"), tr("Do it again (Ctrl+Shift+Z)"))
        self.free = _button(tr("Free ends"), tr("Remove the tangents that were given to the ends"))
        self.back = _button(tr("As in sources"), tr("Move all points back to those of the sources"))
        buttons = FlowLayout()
        for each in (self.pick, self.undo, self.redo, self.free, self.back):
            buttons.add(each, 1)
        self.picked = make_text()
        self.picked.hide()
        self.table = PointTable(obj)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addLayout(buttons)
        layout.addWidget(self.picked)
        layout.addWidget(self.table)
        layout.addLayout(self._fields(obj))

    def _fields(self, obj):
        line = FlowLayout()
        self.handles = QtWidgets.QCheckBox(tr("Handles"))
        self.handles.setChecked(True)
        self.handles.setToolTip(
            tr(
                "Show handles in the view: circles are points, squares the tangents of the ends, "
                "diamonds the tensions. Drag them; Esc takes a drag back."
            )
        )
        self.snaps = QtWidgets.QCheckBox(tr("Grid"))
        self.snaps.setToolTip(tr("Points that are picked or dragged snap to a grid; Ctrl: free"))
        self.grid = NumberField(LENGTH, 1e6, 1e-4, refer_to=obj)
        for each in (self.handles, self.snaps, self.grid):
            line.add(each)
        return line

    def enable(self, steps, fields):
        """Enable the buttons that have an effect; ``fields``: {argument: field} of the spline."""
        tangents = (fields[name].value() for name in ("start_tangent_mm", "end_tangent_mm"))
        interpolates = fields["family"].value() in INTERPOLATING
        self.undo.setEnabled(bool(steps.done))
        self.redo.setEnabled(bool(steps.undone))
        self.free.setEnabled(interpolates and any(map(any, tangents)))
        self.back.setEnabled(bool(fields["moves_mm"].value()))

    def suit_grid(self, view):
        """Give the grid a step that is seen in a 3D view as it is now."""
        if hasattr(view, "graphicsView"):
            pixel_mm = Projection(view).size_of_pixel_mm((0, 0, 0))
            self.grid.show_number(spline_handles.fair_step(GRID_PX * pixel_mm))

    def grid_mm(self):
        """Return the step of the grid, 0 without one."""
        return self.grid.number() if self.snaps.isChecked() else 0.0

    def say_picked(self, count, point, what):
        """Say how many points are picked, and where the last one or the mouse is."""
        place = ""
        if point is not None:
            place = ": (%s)" % ", ".join("%.6g" % each for each in point)
            place += {"grid": tr(", on the grid"), "free": "", "": ""}.get(what, ", " + what)
        self.picked.setText(tr("{points}{place}. {how}").format(
            points=capital(counted(count, "point")), place=place, how=tr(HOW_TO_PICK)
        ))


def _button(text, tip):
    button = QtWidgets.QPushButton(text)
    button.setToolTip(tip)
    return button
