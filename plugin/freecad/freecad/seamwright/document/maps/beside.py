# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free edges that lie side by side, of one object or of several.

The kernel finds the seams between them (docs/seams.md, matched seams). A point of one edge
corresponds to the nearest point of the other.
"""

from typing import Any, NamedTuple

import numpy
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.option_feature import links_of
from freecad.seamwright.document.surfaces.surface import is_surface
from freecad.seamwright.plain.language import tr

#: Edges no further apart than this lie side by side, in mm.
MATCH_MM = 0.1


class Free(NamedTuple):
    """An edge that bounds one face, with its ``face`` and its ``name`` such as "Plate.Edge3".

    ``place``: its place among the chosen edges.
    """

    name: str
    edge: Any
    face: Any
    place: int


def lie_side_by_side(one, other, within_mm=MATCH_MM):
    """Return whether the middle of one of two edges is near the other edge."""
    return any(
        Part.Vertex(a.valueAt(sum(a.ParameterRange) / 2)).distToShape(b)[0] <= within_mm
        for a, b in ((one, other), (other, one))
    )


def known_neighbours(obj):
    """Return the links, (object, "Edge3"), that may lie beside edges of an object.

    A surface that was made beside faces has those of its sources; a source has those of the
    surface.
    """
    found = []
    if is_surface(obj):
        for name, *_ in obj.Proxy.LINKS:
            found += links_of(obj, name)
    for other in obj.InList:
        if is_surface(other) and sources.has_shape(other):
            found += [(other, "Edge%d" % k) for k in range(1, len(other.Shape.Edges) + 1)]
    return [link for link in dict.fromkeys(found) if link[1]]


def seams_of(module, free, match_mm):
    """Return a callable(progress) -> ([(seam of a report, Free, Free)], left), for any thread.

    The edges of each seam are among the given ones. ``left``: the Free that are in no seam.
    """
    faces = []
    for each in free:
        if not any(each.face.isSame(face) for face in faces):
            faces.append(each.face)
    part = Part.Compound(faces)
    numbers = [
        next(n for n, edge in enumerate(part.Edges, 1) if edge.isSame(each.edge)) for each in free
    ]
    places = [next(k for k, face in enumerate(faces) if face.isSame(each.face)) for each in free]
    make = module.bridge.model_later(part)
    # A copy, since FreeCAD may draw or change the shape meanwhile.
    part = part.copy()

    def run(progress):
        model = make()
        report = model.analyze(
            level="G2", match_mm=match_mm, jobs=1, progress=progress
        ).to_dict()
        copies = {
            number: each._replace(edge=part.Edges[number - 1], face=part.Faces[place])
            for each, number, place in zip(free, numbers, places)
        }
        found = [
            (seam, *(copies[number] for number in seam["edges"]))
            for seam in report["seams"]
            if seam["kind"] == "matched" and set(seam["edges"]) <= set(copies)
        ]
        seen = {number for seam, *_ in found for number in seam["edges"]}
        return found, [copies[number] for number in copies if number not in seen]

    return run


def corresponding(one, other, samples):
    """Return (parameters on an edge, parameters of the nearest points on another edge).

    Points of the first edge that lie beyond an end of the other are left out.
    """
    places = numpy.linspace(*one.ParameterRange, samples)
    step = one.Length / (samples - 1)
    first, last = other.ParameterRange
    curve = other.Curve
    period = curve.period() if curve.isPeriodic() else None
    found = []
    for place in places:
        point = one.valueAt(float(place))
        at = curve.parameter(point)
        if period:
            at = first + (at - first) % period
        at = min(max(at, first), last)
        off = point - other.valueAt(at)
        beyond = at in (first, last) and abs(off.dot(other.tangentAt(at))) > step / 2
        if not beyond:
            found.append((float(place), at))
    if len(found) < 3:
        raise ValueError(tr("the edges lie side by side only in a short part"))
    return tuple(numpy.array(each) for each in zip(*found))
