# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that compare a surface with its result: mean curvature on one scale, or zebra stripes."""

from typing import Any, NamedTuple

import FreeCAD as App
import numpy
import Part
from pivy import coin

from freecad.seamwright.document.curvature_map import align, curvature_map_later
from freecad.seamwright.document.display_mesh import fault_lines
from freecad.seamwright.gui.scene import coloured, stripes
from freecad.seamwright.gui.scene.legend import Legend
from freecad.seamwright.gui.scene.substitutes import Substitutes, local_shape
from freecad.seamwright.gui.widgets.later import find, later
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain import curvature, kernel
from freecad.seamwright.plain.language import mark, tr

CURVATURE, ZEBRA = mark("Mean curvature"), mark("Zebra stripes")

LEGEND_TEXT_PX = 13


class Surface(NamedTuple):
    """What is drawn of one object: ShownMesh, colours of its points, and lines of its edges."""

    mesh: Any
    colours: Any
    lines: list


class Found(NamedTuple):
    """The results of a computation.

    ``surfaces``: {name of an object: Surface}. ``limit``: the curvature with the end colour, in
    1/mm.
    """

    surfaces: dict
    limit: float


class SurfaceColours:
    """Draws on a source and on a result that has its faces.

    ``computation``: of the panel, which shows the progress. ``surfaces()`` returns the existing
    ones of these objects, the source first. Results are kept until the objects have other shapes;
    ``changed()`` is called when an object that is drawn gets another shape. ``abandoned()`` is
    called where nothing can be drawn: the user stopped the computation, or the compiled part is
    missing.
    """

    def __init__(self, obj, computation, surfaces, abandoned, changed):
        self._names = obj.Document.Name, obj.Name
        self._computation, self._surfaces = computation, surfaces
        self._tell_abandoned, self._tell_changed = abandoned, changed
        self._substitutes, self._legend = Substitutes(self._drop), Legend(obj)
        self._root = obj.ViewObject.RootNode
        self._root.insertChild(self._legend.node, 0)
        self._kind = self._found = None
        self._of = {}  # the shapes of the current or the last computation
        self._task, self._in_panel = None, False
        self._nodes = {}  # {(kind, name): node}

    def show(self, kind):
        """Draw CURVATURE or ZEBRA as soon as it is computed.

        None: the objects are drawn as usual.
        """
        if not self._is_current():
            self._found = None
            self._cancel()
        if kind != self._kind or self._found is None:
            self._clear()
        self._kind = kind
        if kind is None:
            self._cancel()
        elif self._found is not None:
            self._draw()
        elif self._task is None or not self._task.wanted:
            self._compute()

    def end(self):
        """Remove all that was added to the views."""
        self._cancel()
        self._clear()
        self._root.removeChild(self._legend.node)

    def _shapes(self):
        return {obj.Name: Part.getShape(obj) for obj in self._surfaces()}

    def _is_current(self):
        """Return whether the objects have the shapes that were computed, at any position."""
        now = self._shapes()
        return now.keys() == self._of.keys() and all(
            shape.isPartner(self._of[name]) for name, shape in now.items()
        )

    def _clear(self):
        self._substitutes.clear()
        self._legend.show(False)

    def _drop(self, obj):
        """An object that is drawn has another shape."""
        self._found = None
        later(obj, lambda _: self._tell_changed())

    def _cancel(self):
        """Stop the computation, unless another computation of the panel has replaced it."""
        if self._task is not None and self._task.wanted:
            (self._computation.drop if self._in_panel else self._task.cancel)()
        self._task = None

    def _compute(self):
        self._of, self._nodes = self._shapes(), {}
        try:
            work = work_on(self._surfaces())
        except kernel.KernelUnavailable as error:
            App.Console.PrintWarning(tr("Seamwright: the colours are not shown: {error}\n").format(
                error=error
            ))
            self._tell_abandoned()
            return

        def done(found, error):
            self._task = None
            if error is not None:
                raise error
            if found is not None and find(*self._names) is not None:
                self._found = found
                self._warn()
                self._draw()

        self._start(work, done)

    def _start(self, run, done):
        """Let the panel show the progress, where it has nothing else to show."""
        self._in_panel = not self._computation.busy
        if self._in_panel:
            self._task = self._computation.start(
                tr("Computing colours\u2026"), run, done, self._tell_abandoned, locks=False
            )
        else:
            self._task = tasks.start(run, done)

    def _drawn(self):
        """Return [(object, its Surface)] of the objects that were computed."""
        return [
            (obj, self._found.surfaces[obj.Name])
            for obj in self._surfaces()
            if obj.Name in self._found.surfaces
        ]

    def _warn(self):
        for obj, surface in self._drawn():
            for line in fault_lines(obj.Label, surface.mesh.faults):
                App.Console.PrintWarning("Seamwright: %s\n" % line)

    def _draw(self):
        """Put substitutes on all objects.

        A hidden object gets one too, so that it has its colours as soon as it is shown.
        """
        for obj, surface in self._drawn():
            if not self._substitutes.has(obj):
                self._substitutes.put(obj, self._node(obj.Name, surface))
        if self._kind == CURVATURE:
            self._legend.update(*curvature.legend(self._found.limit), LEGEND_TEXT_PX)
        self._legend.show(self._kind == CURVATURE)

    def _node(self, name, surface):
        if (self._kind, name) not in self._nodes:
            self._nodes[self._kind, name] = draw(self._kind, surface)
        return self._nodes[self._kind, name]


def work_on(objects):
    """Return a callable(progress) -> Found of objects as they are now, which any thread may call.

    The objects after the first have its faces, moved or joined. ``progress`` is a
    callable(fraction) that returns False to stop; then the result is None. Raises KernelUnavailable
    when the compiled part is missing.
    """
    works = {obj.Name: _work(local_shape(obj)) for obj in objects}
    return lambda progress: _run(works, progress)


def _work(shape):
    """Return a callable(progress) -> (ShownMesh, lines) of a shape as it is now, for any thread.

    Its result is None where it was stopped.
    """
    mesh_of, edges = curvature_map_later(shape), shape.copy().Edges if shape.Faces else []

    def run(progress):
        mesh = mesh_of(progress)
        return None if mesh is None else (mesh, coloured.polylines(edges))

    return run


def _run(works, progress):
    drawn = {}
    for index, (name, work) in enumerate(works.items()):
        drawn[name] = work(lambda part, index=index: progress((index + part) / len(works)))
        if drawn[name] is None:
            return None
    meshes = [mesh for mesh, _ in drawn.values()]
    for mesh in meshes[1:]:
        align(mesh, meshes[0])
    values = numpy.concatenate([mesh.mean_per_mm for mesh in meshes])
    limit = curvature.limit(
        values, numpy.concatenate([curvature.areas(mesh.points, mesh.triangles) for mesh in meshes])
    )
    surfaces = {
        name: Surface(mesh, curvature.colours(mesh.mean_per_mm, limit), lines)
        for name, (mesh, lines) in drawn.items()
    }
    return Found(surfaces, limit)


def draw(kind, surface):
    """Return a node that draws a Surface with CURVATURE or as ZEBRA."""
    if kind == ZEBRA:
        return stripes.node(surface.mesh)
    group = coin.SoSeparator()
    for node in (
        coloured.unpickable(),
        coloured.faces(surface.mesh, surface.colours, lit=False),
        coloured.lines(surface.lines),
    ):
        group.addChild(node)
    return group
