# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handles of a spline in the view: points, tangents of the ends and tensions are dragged.

While the mouse moves, only the spline of the kernel is computed and drawn. The document is changed
when a drag ends.
"""

import FreeCADGui as Gui
import numpy
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.curves.spline import INTERPOLATING, NU
from freecad.seamwright.gui.curves.point_picker import PointPicker
from freecad.seamwright.gui.scene.comb import EVERY, LONGEST, QUILLS
from freecad.seamwright.gui.scene.live_curve import POINT, TANGENT, TENSION, LiveCurve
from freecad.seamwright.gui.scene.projection import Projection
from freecad.seamwright.gui.scene.snap import Snapper
from freecad.seamwright.gui.scene.view_events import ViewEvents
from freecad.seamwright.plain import kernel, spline_handles
from freecad.seamwright.plain.options import one_for_each

#: Pixels within which a handle is taken.
REACH_PX = 9

#: The order in which handles that lie on each other are taken.
KINDS = (POINT, TANGENT, TENSION)

TANGENTS = ("start_tangent_mm", "end_tangent_mm")


class _Drag:
    """The handle that is dragged: its kind and number, and the values before."""

    def __init__(self, kind, place, offset, values):
        self.kind, self.place, self.offset, self.before = kind, place, offset, values
        self.values = values


class SplineEditor:
    """The handles of a spline while its panel is open.

    ``panel`` has ``spline_values()`` -> {argument: value} of the fields, ``links(name)``,
    ``keep_values(values)``, ``undo_drag()``, ``redo_drag()``, ``say(text)`` and ``grid_mm()``.
    """

    def __init__(self, panel, obj):
        self.panel, self.obj = panel, obj
        self.picker = None
        self.shown = True
        self._module = kernel.load(Part.OCC_VERSION)
        self._live = LiveCurve()
        self._drag = self._events = self._snapper = None
        self._base = self._points = self._spline = None
        self._slides, self._factor, self._closed, self._ring = None, 0.0, False, False
        self._places = {}
        obj.ViewObject.RootNode.insertChild(self._live.node, 0)

    def start(self):
        """Take the mouse and keys of the active view, if it is a 3D view."""
        self.view = Gui.getDocument(self.obj.Document.Name).activeView()
        if self._events is None and hasattr(self.view, "graphicsView"):
            self._events = ViewEvents(self.view, self)

    def end(self):
        """Remove the handles, and let FreeCAD have the mouse and keys."""
        self.obj.ViewObject.Proxy.drag(False)
        if self._events is not None:
            self._events.point_with(None)
            self._events.end()
            self._events = None
        root = self.obj.ViewObject.RootNode
        if root.findChild(self._live.node) >= 0:
            root.removeChild(self._live.node)

    @property
    def points(self):
        """The points of the spline that is shown, (count, 3); None without one."""
        return self._points

    @property
    def dragging(self):
        """Whether a handle is held."""
        return self._drag is not None

    # Values.

    def base_points(self):
        """Return (points, whether they are closed) of the fields without moves; (None, False)."""
        try:
            shapes = inputs.shapes_of(self.panel.links("Sources"))
            return self.obj.Proxy.points_before(shapes, self.panel.spline_values())
        except (ValueError, sources.SourceError):
            return None, False

    def load(self):
        """Show the handles of the values that the fields have now."""
        if self.dragging or self.picker is not None:
            return
        self._base, self._closed = self.base_points()
        try:
            values = self.panel.spline_values()
        except ValueError:  # a text of the panel is no list of numbers
            self._base = None
        if self._base is None or not self.panel.is_due():
            self._hide_spline()
        self._spline = self._points = None
        if self._base is None or not self.shown or not self._compute(values):
            self._points = None
            self._live.show_handles({})
            return
        self._show_handles(values)

    def _hide_spline(self):
        """Show the curve of the document again; after a drag it is not computed at once."""
        self._live.show_curve(None)
        self._live.show_comb(None, None, EVERY)
        self.obj.ViewObject.Proxy.drag(False)

    def points_of(self, values):
        """Return the points of values, an array (count, 3)."""
        if values["points_mm"]:
            return numpy.array(values["points_mm"], float)
        moves = values["moves_mm"]
        return self._base + numpy.array(moves) if len(moves) == len(self._base) else self._base

    def _compute(self, values):
        """Compute the spline; return whether there is one."""
        try:
            points, closed = inputs.checked_points(self.points_of(values), self._closed)
            closed = closed or values["closed"]
            self._spline = self.obj.Proxy.curve(self._module, points, closed, values)
        except ValueError:
            return False
        self._points, self._ring = points, closed
        return True

    # Drawing.

    def update(self, values):
        """Compute and draw the spline of values; one update of a drag. Return whether it exists."""
        if not self._compute(values):
            return False
        self.obj.ViewObject.Proxy.drag(True)
        self._draw_spline()
        self._show_handles(values)
        return True

    def _draw_spline(self):
        knots = self._spline.knots
        at = numpy.linspace(knots[0], knots[-1], QUILLS + 1)
        jets = numpy.asarray(self._spline.derivatives(at, 2))
        points = jets[:, 0]
        self._live.show_curve(points)
        if not self.obj.ViewObject.ShowComb:
            self._live.show_comb(None, None, EVERY)
            return
        vectors = spline_handles.curvature_vectors(jets[:, 1], jets[:, 2])
        if not self._factor:
            scale = self.obj.ViewObject.CombScale
            self._factor = spline_handles.comb_factor(points, vectors, LONGEST, scale)
        self._live.show_comb(points, points - self._factor * vectors, EVERY)

    def draw_points(self, points, closed, values):
        """Draw the spline of other points as far as there is one, without handles but points."""
        self._base, self._closed = numpy.array(points, float).reshape(-1, 3), closed
        self._factor = 0.0
        if len(points) < 2 or not self._compute(values):
            self._live.show_curve(points if len(points) else None)
            self._live.show_comb(None, None, EVERY)
        else:
            self._draw_spline()
        self._live.show_handles({POINT: points})

    def show_snap(self, point):
        """Draw a ring around the point that the mouse would take."""
        self._live.show_snap(point)

    def _show_handles(self, values):
        self._places = {POINT: self._points}
        stalks = []
        if values["family"] in INTERPOLATING:
            self._slides = spline_handles.slides(
                self._points, self._ring, by_length=values["family"] == NU
            )
            self._places[TENSION] = self._slides.places(self._tension(values))
            stalks += list(zip(self._points, self._places[TENSION]))
            if not self._ring:
                poles = numpy.asarray(self._spline.poles)
                self._places[TANGENT] = poles[[1, -2]]
                stalks += list(zip(self._points[[0, -1]], poles[[1, -2]]))
        self._live.show_handles(self._places, stalks)

    def _tension(self, values):
        return numpy.array(one_for_each("Tension", values["tension"], len(self._points), "points"))

    # Mouse and keys; see ViewEvents.

    def press(self, pixel):
        """Take the handle at a pixel."""
        if self.picker is not None:
            return self.picker.press(pixel)
        if self._points is None:
            return False
        projection = Projection(self.view)
        for kind in KINDS:
            pixels = projection.pixels(self._places.get(kind, ()))
            place = spline_handles.nearest(pixels, pixel, REACH_PX)
            if place is not None:
                self._drag = _Drag(
                    kind, place, pixels[place] - pixel, self.panel.spline_values()
                )
                self._snapper = Snapper(self.obj.Document, self.obj)
                self._factor = 0.0
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
            self._drag.values = values
        return True

    def release(self, pixel):
        """Keep the values to which the handle was dragged."""
        if self.picker is not None:
            self.picker.release(pixel)
            return
        drag, self._drag = self._drag, None
        self.show_snap(None)
        if drag is not None and drag.values != drag.before:
            self.panel.keep_values(drag.values)
        if drag is not None:
            self.load()

    def wants(self, name):
        """Return whether a key is for the handles."""
        if self.picker is not None:
            return name in ("escape", "enter", "backspace", "undo", "redo")
        return name in ("undo", "redo") or (name == "escape" and self.dragging)

    def key(self, name):
        """Esc takes a drag back; undo and redo are those of the drags."""
        if not self.wants(name):
            return False
        if self.picker is not None:
            self.picker.key(name)
        elif name == "escape":
            self._drag = None
            self.show_snap(None)
            self.load()
        elif not self.dragging:
            (self.panel.undo_drag if name == "undo" else self.panel.redo_drag)()
        return True

    def _dragged(self, projection, pixel):
        """Return the values when the handle that is held is at a pixel; None where it cannot be."""
        drag = self._drag
        if drag.kind == POINT:
            start = self.points_of(drag.before)[drag.place]
            point, _ = self._snapper.find(projection, pixel, start, self.panel.grid_mm())
            if point is None:
                return None
            self.show_snap(point)
            return self._with_point(drag.before, drag.place, point)
        if drag.kind == TANGENT:
            return self._with_tangent(projection, pixel, drag)
        origin, direction = self._slides.origins[drag.place], self._slides.directions[drag.place]
        along = projection.along_line(pixel, origin, direction)
        if along is None:
            return None
        tension = self._tension(drag.before).tolist()
        value = self._slides.tension(drag.place, along)
        tension[drag.place] = max(value, 0.0) if drag.before["family"] == NU else value
        return {**drag.before, "tension": tension}

    def _with_point(self, values, place, point):
        if values["points_mm"]:
            points = list(values["points_mm"])
            points[place] = tuple(map(float, point))
            return {**values, "points_mm": points}
        moves = numpy.array(self.points_of(values) - self._base)
        moves[place] = point - self._base[place]
        return {**values, "moves_mm": [tuple(each) for each in moves.tolist()]}

    def _with_tangent(self, projection, pixel, drag):
        """The tangent is dragged in the plane across the axis nearest to the view."""
        ends = self._points[[0, -1]]
        start = self._places[TANGENT][drag.place]
        axis = projection.facing_axis()
        point = projection.on_plane(pixel, start, axis)
        if point is None:
            return None
        tangent = (point - ends[drag.place]) * (1 if drag.place == 0 else -1)
        if not tangent.any():
            return None
        return {**drag.before, TANGENTS[drag.place]: tuple(map(float, tangent))}

    # Picking.

    def pick(self, ended):
        """Let clicks in the view add points; ``ended(kept, points, closed)`` is called at the end."""
        if self._events is None:
            return False
        self.load()
        points = [] if self._points is None else self._points.tolist()
        self.picker = PointPicker(self, points, ended)
        self._events.point_with(PointPicker.CURSOR)
        self.view.graphicsView().viewport().setFocus()
        return True

    def end_pick(self):
        """Show the handles again."""
        self.picker = None
        self.show_snap(None)
        if self._events is not None:
            self._events.point_with(None)
