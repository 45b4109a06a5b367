# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of maps: values at the points of a display mesh, drawn on faces."""

from typing import Any, NamedTuple

import numpy
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.maps import meshes
from freecad.seamwright.document.maps.tool import Tool
from freecad.seamwright.plain import maps, orientation
from freecad.seamwright.plain.language import mark, tr


class Values(NamedTuple):
    """The map of one object: ``mesh`` (a ShownMesh in the model), and a value for each point."""

    name: str
    mesh: Any
    values: Any


class SurfaceMap(Tool):
    """Proxy of a map on faces; ``found`` is a list of Values."""

    NEEDS = "select objects with faces"

    #: Name and meaning of grey in the legend.
    UNDEFINED = mark("undefined"), ""
    TAKES_ALL = True
    RESULTS = (
        ("Least", "App::PropertyFloat", "The least value at the points of the mesh", "least"),
        ("Largest", "App::PropertyFloat", "The largest value at the points of the mesh", "largest"),
    )

    # Methods that a subclass defines.

    @classmethod
    def measured(cls, mesh, values):
        """Return the value of each point of a ShownMesh, for {argument: value}."""
        raise NotImplementedError

    @classmethod
    def look(cls, found, values):
        """Return the Look of a list of Values, with the places of all their points in a row."""
        raise NotImplementedError

    @classmethod
    def mirrors(cls, values):
        """Return whether the stripes move with the view, so that they are no values."""
        return False

    # What the base asks for.

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError where an object has no faces."""
        check_faces(chosen, tr(cls.NEEDS))

    @classmethod
    def arranged(cls, chosen):
        """Return the objects of a selection, as a whole and without repeats."""
        check_elements(chosen)
        whole = [(obj, "") for obj in dict.fromkeys(obj for obj, _ in chosen)]
        cls.check("Sources", whole)
        return {"Sources": whole}

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Values]."""
        works = mesh_works(inputs["Sources"])

        def run(progress):
            drawn = run_meshes(works, progress)
            if drawn is None:
                return None
            return [Values(name, mesh, cls.measured(mesh, values)) for name, mesh in drawn]

        return run

    @classmethod
    def report(cls, found, values):
        """Return the extremes with their places, and the numbers of points and faces."""
        all_values = numpy.concatenate([each.values for each in found])
        points = numpy.concatenate([each.mesh.points for each in found])
        if not len(points):
            raise ValueError(tr(
                "no face could be divided into triangles: see Check geometry in the workbench Part"
            ))
        report = maps.extremes(all_values, points)
        report["undefined"] = report["least"] is None
        for key in ("least", "largest"):
            report[key] = 0.0 if report["undefined"] else report[key]
        return {
            **report,
            "points": len(points),
            "faces": sum(len(each.mesh.first_nodes) - 1 for each in found),
            "faults": [
                {"object": each.name, **fault} for each in found for fault in each.mesh.faults
            ],
        }


def check_elements(chosen):
    """Raise SourceError for a link to an element that its object does not have."""
    for obj, name in chosen:
        if name and "." not in name and sources.has_shape(obj):  # a link has names with dots
            try:
                sources.placed_shape(obj).getElement(name)
            except (Part.OCCError, ValueError, IndexError):  # depends on the version of FreeCAD
                raise sources.SourceError(tr("{label} has no {name}: choose another one.").format(
                    label=obj.Label, name=name
                )) from None


def check_faces(chosen, needs):
    """Raise SourceError or ValueError where links do not name objects with faces."""
    if not chosen:
        raise ValueError(tr("nothing is selected: {needs}").format(needs=needs))
    for obj, _ in chosen:
        if not sources.has_shape(obj):
            raise sources.SourceError(tr("{label} has no shape: {needs}").format(
                label=obj.Label, needs=needs
            ))
        if not sources.placed_shape(obj).Faces:
            raise sources.SourceError(tr("{label} has no faces: {needs}").format(
                label=obj.Label, needs=needs
            ))


class MeshWork(NamedTuple):
    """How to make the mesh of an Input: ``make(progress)``, then its ``placement``.

    ``solid``: whether its normals point out of a solid, so that they are never reversed.
    """

    name: str
    make: Any
    placement: Any
    solid: bool


def mesh_works(inputs):
    """Return the MeshWorks of Inputs."""
    return [
        MeshWork(
            given.name,
            meshes.mesh_later(given.shape),
            given.parent * given.shape.Placement,
            bool(given.shape.Solids),
        )
        for given in inputs
    ]


def run_meshes(works, progress):
    """Return [(name, ShownMesh in the model)] of ``mesh_works``; None where it was stopped."""
    found = []
    for index, work in enumerate(works):
        part = None
        if progress is not None:
            part = lambda share, index=index: progress((index + share) / len(works))  # noqa: E731
        mesh = work.make(part)
        if mesh is None:
            return None
        found.append((work.name, mesh.placed(work.placement)))
    _align([mesh for work, (_, mesh) in zip(works, found) if not work.solid])
    return found


def _align(sheets):
    """Let the normals of separate sheets that meet smoothly point to one side."""
    if len(sheets) < 2:
        return
    first_nodes = numpy.concatenate([[0], numpy.cumsum([len(sheet.points) for sheet in sheets])])
    signs = orientation.signs(
        numpy.concatenate([sheet.points for sheet in sheets]),
        numpy.concatenate([sheet.normals for sheet in sheets]),
        first_nodes,
        numpy.arange(len(sheets)),
    )
    for sheet, sign in zip(sheets, signs):
        sheet.turn(numpy.full(len(sheet.first_nodes) - 1, sign))


def weights(found):
    """Return the areas of the points of a list of Values, in a row."""
    return numpy.concatenate([each.mesh.unplaced.areas for each in found])


def joined(found):
    """Return the values of a list of Values in a row."""
    return numpy.concatenate([each.values for each in found])
