# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an analysis tool draws in the view: coloured faces with a legend, or combs.

It is drawn while the object of the tool is visible, whatever panel is open, and removed with it.
"""

import math
import traceback

import FreeCAD as App
import FreeCADGui as Gui
import Part

from freecad.seamwright.document.display_mesh import fault_lines
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.maps import combs
from freecad.seamwright.document.maps.surface_map import SurfaceMap
from freecad.seamwright.gui.scene import coloured, mapped, shaders
from freecad.seamwright.gui.scene.comb import Comb
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.scene.stripes import Stripes
from freecad.seamwright.gui.scene.substitutes import Substitutes, key
from freecad.seamwright.gui.widgets.later import find
from freecad.seamwright.gui.widgets.qt import QtCore
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain import ramps
from freecad.seamwright.plain.language import tr

LEGEND_TEXT_PX = 13

#: The interval at which stripes without a shader follow the view. Callbacks of the scene in Python
#: may end FreeCAD, see handle.
FOLLOW_MS = 60


class Drawing:
    """Draws what an object finds. A subclass draws ``found``; ``names``: (document, object)."""

    def __init__(self, obj):
        self.names = key(obj)
        self._task = None
        _owners.add(self)

    def refresh(self, obj):
        """Draw the object as it is now, once that is computed."""
        self.cancel()
        work, values = obj.Proxy.prepared(obj)

        def done(found, error):
            self._task = None
            if error is not None:
                self.clear()
                App.Console.PrintError(
                    "".join(traceback.format_exception(type(error), error, error.__traceback__))
                )
            elif found is not None and find(*self.names) is not None:
                self.draw(find(*self.names), found, values)

        self._task = tasks.start(work, done)

    def cancel(self):
        """Stop computing."""
        if self._task is not None:
            self._task.cancel()
        self._task = None

    def draw(self, obj, found, values):
        """Draw what ``work`` of the object found."""
        raise NotImplementedError

    def clear(self):
        """Draw nothing."""
        raise NotImplementedError


class FaceColours(Drawing):
    """Coloured faces in place of those of the sources, and a legend."""

    def __init__(self, obj):
        super().__init__(obj)
        self._substitutes = Substitutes(lambda _: None, self._show_beside)
        self._has_legend = False
        self.legend = Legend(obj)
        obj.ViewObject.RootNode.insertChild(self.legend.node, 0)
        self._groups = {}  # {name of a source: (ShownMesh, Placement, groups)}
        self._told = set()
        self._turning, self._seen = [], None  # TurningStripes, and the orientation of the view
        self._timer = QtCore.QTimer()
        self._timer.setInterval(FOLLOW_MS)
        self._timer.timeout.connect(self._turn)

    def draw(self, obj, found, values):
        """Draw a list of Values."""
        kind, begin, kept = obj.Proxy, 0, set()
        self._stop_turning()
        look = None if kind.mirrors(values) else _look(kind, found, values)
        for each in found:
            source = obj.Document.getObject(each.name)
            count = len(each.mesh.points)
            part, begin = slice(begin, begin + count), begin + count
            if source is None:
                continue
            self._tell(source, each.mesh)
            groups = self._mesh(source, each.mesh.unplaced)
            if look is None:
                node = self._mirror(groups, each.mesh.normals, _stripes(values))
            else:
                node = mapped.node(groups, look, part)
            self._substitutes.put(source, node)
            kept.add(source)
        self._substitutes.remove(set(self._substitutes.objects(obj.Document)) - kept)
        legend = None if look is None else look.legend
        if legend is not None:
            continuous = look.smooth and sum(not sample.apart for sample, *_ in legend[1]) > 1
            self.legend.update(*legend, LEGEND_TEXT_PX, look.row[::-1] if continuous else ())
        self._has_legend = legend is not None
        self._show_beside()

    def _show_beside(self):
        """Show the legend and the marks while something is seen that has the colours."""
        drawn = self._substitutes.objects(App.getDocument(self.names[0]))
        seen = any(each.ViewObject.Visibility for each in drawn)
        self.legend.show(seen and self._has_legend)
        obj = find(*self.names)
        if obj is not None and drawn:
            marks = obj.Proxy.marks(report_of(obj)) if seen else []
            obj.ViewObject.Proxy.mark([], [], marks)

    def _mesh(self, source, mesh):
        """Return the groups of a mesh; they are made once."""
        shape = Part.getShape(source)
        own = getattr(source, "Placement", App.Placement())
        placement = own.inverse() * shape.Placement
        known = self._groups.get(source.Name)
        if known is None or known[0] is not mesh or known[1].Matrix.A != placement.Matrix.A:
            lines = coloured.polylines(_bare(shape).Edges)
            known = mesh, placement, mapped.mesh_group(mesh, lines, placement)
            self._groups[source.Name] = known
        return known[2]

    def _mirror(self, groups, normals, look):
        """Return a node with zebra stripes; without shaders, a timer lets them follow the view."""
        if shaders.work():
            return mapped.mirror(groups, look)
        turning = mapped.TurningStripes(groups, normals, look)
        self._turning.append(turning)
        self._timer.start()
        return turning.node

    def _turn(self):
        view = Gui.getDocument(self.names[0]).activeView()
        if not hasattr(view, "getCameraNode"):
            return
        seen = view.getCameraNode().orientation.getValue().getValue()
        if seen != self._seen:
            self._seen = seen
            for each in self._turning:
                each.turn(seen)

    def _stop_turning(self):
        self._timer.stop()
        self._turning, self._seen = [], None

    def cancel(self):
        """Stop computing, and following the view."""
        super().cancel()
        self._stop_turning()

    def _tell(self, source, mesh):
        if id(mesh.unplaced) not in self._told:
            self._told.add(id(mesh.unplaced))
            for line in fault_lines(source.Label, mesh.faults):
                App.Console.PrintWarning("Seamwright: %s\n" % line)

    def clear(self):
        """Draw nothing."""
        self._has_legend = False
        self.legend.show(False)
        doc = self.names[0]
        if doc in App.listDocuments():
            self._substitutes.remove(self._substitutes.objects(App.getDocument(doc)))


def _look(kind, found, values):
    name, meaning = kind.UNDEFINED
    return ramps.with_undefined(kind.look(found, values), tr(name), meaning and tr(meaning))


def _bare(shape):
    bare = shape.copy(False, False)
    bare.Placement = App.Placement()
    return bare


def _stripes(values):
    return Stripes(values["stripes"], math.radians(values["lean_deg"]), values["width"])


class Combs(Drawing):
    """Curvature combs."""

    def __init__(self, obj):
        super().__init__(obj)
        self._comb = Comb()
        obj.ViewObject.RootNode.insertChild(self._comb.node, 0)

    def draw(self, obj, found, values):
        """Draw a list of combs.Comb."""
        lines = combs.segments(found, values["scale"])
        self._comb.draw(
            [
                list(zip(map(tuple, points.tolist()), map(tuple, ends.tolist())))
                for points, ends in lines
            ],
            1,
        )

    def clear(self):
        """Draw nothing."""
        self._comb.draw([], 1)


def drawing_of(obj):
    """Return a new Drawing for an object; None for one that draws nothing of its own."""
    if isinstance(obj.Proxy, SurfaceMap):
        return FaceColours(obj)
    return Combs(obj) if isinstance(obj.Proxy, combs.CurvatureComb) else None


class _Owners:
    """Clears what deleted objects draw. It observes objects only, see substitutes."""

    def __init__(self):
        self._drawings = {}
        self._observes = False

    def add(self, drawing):
        if not self._observes:
            App.addDocumentObserver(self)
            self._observes = True
        self._drawings[drawing.names] = drawing

    def slotDeletedObject(self, obj):
        """An object is deleted."""
        drawing = self._drawings.get(key(obj))
        if drawing is not None:
            drawing.cancel()
            drawing.clear()

    def slotCreatedObject(self, obj):
        """A deleted object is there again after an undo: its view draws again."""
        if key(obj) in self._drawings and getattr(obj.ViewObject, "Proxy", None) is not None:
            obj.ViewObject.Proxy.schedule()

    def slotDeletedDocument(self, doc):
        """A document is closed."""
        for names in [each for each in self._drawings if each[0] == doc.Name]:
            self._drawings.pop(names).cancel()


_owners = _Owners()
