# SPDX-License-Identifier: LGPL-2.1-or-later
"""A spline as it is drawn while it is dragged: computed by the kernel, without the document."""

import numpy
import Part

from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.curves.spline import INTERPOLATING, NU
from freecad.seamwright.gui.scene.comb import LONGEST
from freecad.seamwright.gui.scene.live_curve import POINT, TANGENT, TENSION, LiveCurve
from freecad.seamwright.plain import kernel, spline_handles
from freecad.seamwright.plain.language import mark
from freecad.seamwright.plain.options import one_for_each

#: Places at which a dragged spline is computed.
PLACES = 480


class SplineDrawing:
    """The spline of some values with its comb and its handles.

    ``points`` (count, 3): of the spline, None without one. ``places``: {kind of handle: points}.
    ``slides``: the lines along which tensions are dragged.
    """

    def __init__(self, obj):
        self.obj = obj
        self.points = self.slides = None
        self.places = {}
        self._ring, self._spline, self._factor = False, None, 0.0
        self._module = kernel.load(Part.OCC_VERSION)
        self._live = LiveCurve()
        obj.ViewObject.RootNode.insertChild(self._live.node, 0)

    def end(self):
        """Remove everything from the view."""
        self.obj.ViewObject.Proxy.drag(False)
        root = self.obj.ViewObject.RootNode
        if root.findChild(self._live.node) >= 0:
            root.removeChild(self._live.node)

    def compute(self, points, closed, values):
        """Compute the spline of points; return whether there is one, else keep the last."""
        try:
            points, closed = inputs.checked_points(points, closed)
            closed = closed or values["closed"]
            self._spline = self.obj.Proxy.curve(self._module, points, closed, values)
        except ValueError:
            return False
        self.points, self._ring = points, closed
        return True

    def begin(self):
        """Let the next spline that is drawn decide the scale of the comb."""
        self._factor = 0.0

    def show_spline(self):
        """Draw the spline, and its comb if the view has one."""
        self.obj.ViewObject.Proxy.drag(True)
        knots = self._spline.knots
        at = numpy.linspace(knots[0], knots[-1], PLACES + 1)
        jets = numpy.asarray(self._spline.derivatives(at, 2))
        points = jets[:, 0]
        self._live.show_curve(points)
        vobj = self.obj.ViewObject
        if not vobj.ShowComb:
            self._live.show_comb(None, None, 1)
            return
        vectors = spline_handles.curvature_vectors(jets[:, 1], jets[:, 2])
        if not self._factor:
            self._factor = spline_handles.comb_factor(points, vectors, LONGEST, vobj.CombScale)
        every = max(1, PLACES // vobj.CombLines)
        self._live.show_comb(points, points - self._factor * vectors, every)

    def hide_spline(self):
        """Show the curve and the comb of the document again."""
        self._live.show_curve(None)
        self._live.show_comb(None, None, 1)
        self.obj.ViewObject.Proxy.drag(False)

    def show_handles(self, values):
        """Draw the handles of the spline."""
        self.places, stalks = {POINT: self.points}, []
        if values["family"] in INTERPOLATING:
            by_length = values["family"] == NU
            self.slides = spline_handles.slides(self.points, self._ring, by_length)
            self.places[TENSION] = self.slides.places(self.tension(values))
            stalks += list(zip(self.points, self.places[TENSION]))
            if not self._ring:
                self.places[TANGENT] = numpy.asarray(self._spline.poles)[[1, -2]]
                stalks += list(zip(self.points[[0, -1]], self.places[TANGENT]))
        self._live.show_handles(self.places, stalks)

    def hide_handles(self):
        """Draw no handles."""
        self.places = {}
        self._live.show_handles({})

    def forget(self):
        """Draw no handles: there is no spline to drag."""
        self.points = None
        self.hide_handles()

    def show_picked(self, points, values):
        """Draw picked points, and the spline through them as far as there is one."""
        self.begin()
        if len(points) >= 2 and self.compute(points, False, values):
            self.show_spline()
        else:
            self._live.show_curve(points if len(points) else None)
            self._live.show_comb(None, None, 1)
        self._live.show_handles({POINT: points})

    def show_snap(self, point):
        """Draw a ring around the point that the mouse would take; None removes it."""
        self._live.show_snap(point)

    def tension(self, values):
        """Return the tensions of all points, an array. Raises ValueError for a wrong number."""
        numbers = one_for_each("Tension", values["tension"], len(self.points), mark("points"))
        return numpy.array(numbers)
