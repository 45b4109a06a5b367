# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles of a spline in the view: points, tangents of the ends and tensions are dragged.

The document is changed when a drag ends.
"""

from typing import Any, NamedTuple

import FreeCADGui as Gui
import numpy

from freecad.seamwright.document import sources
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.curves.spline import NU
from freecad.seamwright.gui.curves.point_picker import PointPicker
from freecad.seamwright.gui.curves.spline_drawing import SplineDrawing
from freecad.seamwright.gui.scene.live_curve import POINT, TANGENT, TENSION
from freecad.seamwright.gui.scene.preselection import Preselection
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.scene.snap import Snapper
from freecad.seamwright.gui.scene.view_events import ViewEvents
from freecad.seamwright.plain import spline_handles

#: Pixels within which a handle is taken.
REACH_PX = 9

#: The order in which handles that lie on each other are taken.
KINDS = (POINT, TANGENT, TENSION)

TANGENTS = ("start_tangent_mm", "end_tangent_mm")


class _Drag(NamedTuple):
    """The handle that is held; ``offset``: from the mouse to it, in pixels."""

    kind: str
    place: int
    offset: Any
    before: dict
    snapper: Snapper


class SplineEditor:
    """The handles of a spline while its panel is open.

    ``panel`` is the SplinePanel. ``given`` (count, 3): the points of the values, whether or not
    they make a spline; None without any.
    """

    def __init__(self, panel, obj):
        self.panel, self.obj = panel, obj
        self.drawing = SplineDrawing(obj)
        self.picker = self.view = self.given = None
        self.shown = True
        self._drag = self._values = self._events = None
        self._base, self._closed = None, False
        self._preselection = Preselection(obj.Document.Name)

    def start(self):
        """Take the mouse and keys of the active view, if it is a 3D view."""
        self.view = Gui.getDocument(self.obj.Document.Name).activeView()
        if self._events is None and hasattr(self.view, "graphicsView"):
            self._events = ViewEvents(self.view, self)

    def end(self):
        """Remove the handles, and let FreeCAD have the mouse and keys."""
        if self._events is not None:
            self._events.point_with(None)
            self._events.end()
            self._events = None
        self._preselection.resume()
        self.drawing.end()

    @property
    def points(self):
        """The points of the spline that is shown, (count, 3); None without one."""
        return self.drawing.points

    # Values.

    def load(self):
        """Show the handles of the values that the fields have now."""
        if self._drag is not None or self.picker is not None:
            return
        values = self._read()
        if values is None or not self.panel.is_due():
            self.drawing.hide_spline()
        values = None if values is None else self._usable(values)
        if values is None or not self._compute(values):
            self.drawing.forget()
        elif self.shown:
            self.drawing.show_handles(values)
        else:
            self.drawing.hide_handles()

    def _read(self):
        """Find the points of the sources; return the values, None where they make no points."""
        self.given = None
        try:
            values = self.panel.spline_values()
            shapes = inputs.shapes_of(self.panel.links("Sources"))
            self._base, self._closed = self.obj.Proxy.points_before(shapes, values)
        except (ValueError, sources.SourceError):
            return None
        self.given = self._points_of(values)
        return values

    def _usable(self, values):
        """Return the values; without numbers for points where these make no spline.

        Then there are handles of the points all the same.
        """
        if self._compute(values):
            return values
        return {**values, "tension": [0.0], "bias": [1.0]}

    def _compute(self, values):
        return self.drawing.compute(self._points_of(values), self._closed, values)

    def _points_of(self, values):
        if values["points_mm"]:
            return numpy.array(values["points_mm"], float)
        moves = values["moves_mm"]
        return self._base + numpy.array(moves) if len(moves) == len(self._base) else self._base

    def update(self, values):
        """Compute and draw the spline of values; one update of a drag. Return whether it exists."""
        if not self._compute(values):
            return False
        self.drawing.show_spline()
        self.drawing.show_handles(values)
        return True

    # Mouse and keys; see ViewEvents.

    def press(self, pixel):
        """Take the handle at a pixel."""
        if self.picker is not None:
            return self.picker.press(pixel)
        if self.points is None:
            return False
        projection = Projection(self.view)
        for kind in KINDS:
            pixels = projection.pixels(self.drawing.places.get(kind, ()))
            place = spline_handles.nearest(pixels, pixel, REACH_PX)
            if place is not None:
                self._values = self._usable(self.panel.spline_values())
                snapper = Snapper(self.obj.Document, self.obj)
                self._drag = _Drag(kind, place, pixels[place] - pixel, self._values, snapper)
                self.drawing.begin()
                self._preselection.pause()
                return True
        return False

    def move(self, pixel, held):
        """Drag the handle that is held."""
        if self.picker is not None:
            return self.picker.move(pixel, held)
        if self._drag is None:
            return False
        values = self._dragged(Projection(self.view), numpy.add(pixel, self._drag.offset))
        if values is not None and self.update(values):
            self._values = values
        return True

    def release(self, pixel):
        """Keep the values to which the handle was dragged."""
        if self.picker is not None:
            self.picker.release(pixel)
        elif self._drag is not None:
            drag = self._drag
            self._end_drag()
            changed = {
                name: value for name, value in self._values.items() if value != drag.before[name]
            }
            if changed:
                self.panel.keep_values({**self.panel.spline_values(), **changed})
            self.load()

    def wants(self, name):
        """Return whether a key is for the handles."""
        if self.picker is not None:
            return True
        return name in ("undo", "redo") or (name == "escape" and self._drag is not None)

    def key(self, name):
        """Esc takes a drag back; undo and redo are those of the drags."""
        if not self.wants(name):
            return False
        if self.picker is not None:
            self.picker.key(name)
        elif name == "escape":
            self._end_drag()
            self.load()
        elif self._drag is None:
            self.panel.step(back=name == "undo")
        return True

    def _end_drag(self):
        self._drag = None
        self.drawing.show_snap(None)
        self._preselection.resume()

    def _dragged(self, projection, pixel):
        """Return the values when the handle that is held is at a pixel; None where it cannot be."""
        kind, place, _, before, snapper = self._drag
        if kind == POINT:
            start = self._points_of(before)[place]
            point = snapper.find(projection, pixel, start, self.panel.box.grid_mm()).point
            self.drawing.show_snap(point)
            return None if point is None else self.with_point(before, place, point)
        if kind == TANGENT:
            return self._with_tangent(before, place, projection, pixel)
        slides = self.drawing.slides
        along = projection.along_line(pixel, slides.origins[place], slides.directions[place])
        if along is None:
            return None
        tension = self.drawing.tension(before).tolist()
        value = float("%.4g" % slides.tension(place, along))
        tension[place] = max(value, 0.0) if before["family"] == NU else value
        return {**before, "tension": tension}

    def with_point(self, values, place, point):
        """Return the values when one point is moved to another place."""
        if values["points_mm"]:
            points = list(values["points_mm"])
            points[place] = tuple(map(float, point))
            return {**values, "points_mm": points}
        moves = numpy.array(self._points_of(values) - self._base)
        moves[place] = numpy.subtract(point, self._base[place])
        return {**values, "moves_mm": [tuple(each) for each in moves.tolist()]}

    def _with_tangent(self, values, place, projection, pixel):
        """Drag in the plane across the axis nearest to the direction of view."""
        start = self.drawing.places[TANGENT][place]
        point = projection.on_plane(pixel, start, projection.facing_axis())
        if point is None:
            return None
        tangent = (point - self.points[[0, -1]][place]) * (1 if place == 0 else -1)
        if not tangent.any():
            return None
        return {**values, TANGENTS[place]: tuple(map(float, tangent))}

    # Picking.

    def pick(self, ended):
        """Let clicks in the view add points; ``ended`` is that of PointPicker.

        Returns False where there is no 3D view.
        """
        if self._events is None:
            return False
        values = self.panel.spline_values()
        self.load()
        points = [] if self.points is None else self.points.tolist()
        self.picker = PointPicker(self, points, self._vertices(values, len(points)), ended)
        self._events.point_with(PointPicker.CURSOR)
        self.view.graphicsView().viewport().setFocus()
        return True

    def _vertices(self, values, count):
        """Return the links of the vertices that are the points now; None for each other point."""
        chosen = self.panel.links("Sources")
        own = values["points_mm"] or values["moves_mm"] or len(chosen) != count
        if own or not all(name.startswith("Vertex") for _, name in chosen):
            return [None] * count
        return chosen

    def end_pick(self):
        """Show the handles again."""
        self.picker = None
        self.drawing.show_snap(None)
        if self._events is not None:
            self._events.point_with(None)
