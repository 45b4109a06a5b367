# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviation: the distance of faces from those of another shape, in colours.

It is sampled at the points of the display mesh: between them it may be larger. The class path is
written into documents: neither rename nor move it.
"""

import numpy
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.maps.curvature import RANGE, given_range
from freecad.seamwright.document.maps.distance import distances
from freecad.seamwright.document.maps.surface_map import (
    SurfaceMap,
    Values,
    check_elements,
    check_faces,
    joined,
    mesh_works,
    run_meshes,
)
from freecad.seamwright.plain import curvature, map_text, ramps
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import FLAG, Option
from freecad.seamwright.plain.summary import counted

#: The part of the progress after which the meshes are there.
MESHED = 0.4

#: Distances that are kept.
KEPT = 8


class Deviation(SurfaceMap):
    """Proxy of a map of distances, positive on the side of the normals of the other shape."""

    Type = "Deviation"
    LABEL = "Deviation"
    ICON = "seamwright-deviation"
    TIP = (
        "Colour the first of two selected objects by its distance from the second: blue inside, "
        "orange outside, with the largest value and its place. Sampled, so not a proven figure."
    )
    NEEDS = "select two objects with faces: first the one to colour"
    UNDEFINED = mark("left out"), mark("beyond the edges of the other shape")
    TAKES_ALL = False
    LINKS = (
        ("Sources", "Coloured", "The objects whose points are measured and coloured"),
        ("Reference", "Compared with", "The objects from which distances are measured"),
    )
    OPTIONS = (
        *RANGE,
        Option("BeyondEdges", "beyond_edges", FLAG, False, "Beyond edges too",
               "Also measure points that lie beyond a free edge of the other shape: their distance "
               "is that to the edge, and has no sign"),
    )  # fmt: skip
    INPUTS = ("Sources", "Reference", *(option.name for option in OPTIONS))

    @classmethod
    def arranged(cls, chosen):
        """Return the first object of a selection as Sources, the others as Reference."""
        check_elements(chosen)
        whole = list(dict.fromkeys(obj for obj, _ in chosen))
        if len(whole) != 2:
            raise ValueError(
                tr("{objects} selected: {needs}").format(
                    objects=counted(len(whole), "object"), needs=tr(cls.NEEDS)
                )
            )
        found = {"Sources": [(whole[0], "")], "Reference": [(whole[1], "")]}
        for name, links in found.items():
            cls.check(name, links)
        return found

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError where an object has no faces."""
        check_faces(chosen, tr("select objects with faces"))

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> [Values]."""
        works, others = mesh_works(inputs["Sources"]), mesh_works(inputs["Reference"])
        faces = []  # of copies, since FreeCAD may draw or change the shapes meanwhile
        for given in inputs["Reference"]:
            placed = given.shape.copy()
            placed.Placement = given.parent * given.shape.Placement
            faces += placed.Faces
        if not faces:
            raise sources.SourceError(tr(
                "the shape to compare with has no faces: choose another one"
            ))
        return lambda progress: _run(works, others, faces, values, progress)

    @classmethod
    def look(cls, found, values):
        """Return the Look of a list of Values."""
        deviations, given = joined(found), given_range(values)
        if given is not None:
            stops = ramps.stops_between(*given)
            return ramps.range_look(
                deviations, *given, tr("Deviation"), "mm", lambda value: "", stops, ramps.BEYOND
            )
        known = deviations[numpy.isfinite(deviations)]
        limit = curvature.round_up(float(abs(known).max())) if known.any() else 0.0
        meanings = tr("outside"), tr("inside")
        return ramps.signed_look(
            deviations,
            limit,
            tr("Deviation"),
            "mm",
            meanings,
            tr("sampled at the points of the mesh"),
        )

    @classmethod
    def report(cls, found, values):
        """Return the extremes, the largest absolute value with its place, and mean values."""
        given_range(values)
        report, deviations = super().report(found, values), joined(found)
        known = numpy.isfinite(deviations)
        report.update(beyond=int((~known).sum()), furthest_mm=0.0, furthest_at=None, mean_mm=0.0)
        if known.any():
            points = numpy.concatenate([each.mesh.points for each in found])
            furthest = numpy.where(known, abs(deviations), -1.0).argmax()
            report["furthest_mm"] = float(abs(deviations[furthest]))
            report["furthest_at"] = points[furthest].tolist()
            report["mean_mm"] = float(abs(deviations[known]).mean())
        return report

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return map_text.deviation_text(report)

    @classmethod
    def marks(cls, report):
        """Return [(point, text)]: the largest deviation, if it is more than rounding."""
        if not report.get("furthest_mm"):
            return []
        return [(report["furthest_at"], "%s mm" % ramps.figure(report["furthest_mm"]))]


class _Kept:
    """The last distances, so that other colours need no other computation."""

    def __init__(self):
        self._entries = []  # (([mesh, *meshes compared with], flag), distances)

    def find(self, wanted):
        """Return the distances for the same meshes at the same placements, or None."""
        return next((found for known, found in self._entries if _same(known, wanted)), None)

    def keep(self, key, found):
        """Keep distances."""
        self._entries = [*self._entries, (key, found)][-KEPT:]


def _same(one, other):
    (placed, flag), (other_placed, other_flag) = one, other
    return (
        flag == other_flag
        and len(placed) == len(other_placed)
        and all(
            mesh.unplaced is known.unplaced and numpy.array_equal(mesh.points, known.points)
            for mesh, known in zip(placed, other_placed)
        )
    )


_kept = _Kept()


def _run(works, others, faces, values, progress):
    def part(begin, end):
        if progress is None:
            return None
        return lambda share: progress(begin + share * (end - begin))

    drawn = run_meshes(works, part(0, MESHED / 2))
    other = run_meshes(others, part(MESHED / 2, MESHED)) if drawn is not None else None
    if other is None:
        return None
    found = []
    for index, (name, mesh) in enumerate(drawn):
        key = [mesh, *(each for _, each in other)], values["beyond_edges"]
        measured = _kept.find(key)
        if measured is not None:
            found.append(Values(name, mesh, measured))
            continue
        shares = (MESHED + (1 - MESHED) * (index + k) / len(drawn) for k in (0, 1))
        measured = distances(
            mesh.points, [each for _, each in other], faces, values["beyond_edges"], part(*shares)
        )
        if measured is None:
            return None
        _kept.keep(key, measured)
        found.append(Values(name, mesh, measured))
    return found


def measure(shape, other, **given):
    """Return the Made of one shape compared with another one."""
    if not isinstance(other, Part.Shape):
        raise TypeError("a Part.Shape is needed to compare with, not %s" % type(other).__name__)
    return Deviation.make({"Sources": shape, "Reference": other}, **given)
