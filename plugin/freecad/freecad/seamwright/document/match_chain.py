# SPDX-License-Identifier: LGPL-2.1-or-later
"""One face that is matched to several: to a chain of faces along a side, or along several sides."""

from typing import Any, Dict, List, NamedTuple, Optional, Set, Tuple

import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.surfaces import chain
from freecad.seamwright.document.surfaces.sides import Element, Parts
from freecad.seamwright.plain import match_text
from freecad.seamwright.plain.language import tr

#: The property that names what the face joins besides the other face.
MORE = "MoreFaces"


class Neighbour(NamedTuple):
    """A face that is joined; ``edges``: those of its edges that are, None: all that meet.

    ``link``: (object, "Face3").
    """

    face: Element
    edges: Optional[List[Any]]
    link: Tuple[Any, str]


class Gathered(NamedTuple):
    """The face that moves and its neighbours as one shape.

    ``names``: of the faces. ``edges``: for each face the numbers of its edges that may be joined.
    """

    shape: Any
    names: List[str]
    edges: List[Set[int]]
    parts: Any

    def edge_name(self, number):
        """Return an edge of the shape as the user reads it: "Plate.Edge3"."""
        return self.parts.edge_name(self.shape.Edges[number - 1])


def gather(moving, joined):
    """Return the Gathered; ``moving``: (object, "Face3"), ``joined``: links to faces and edges.

    An edge stands for its face, which is joined along the chosen ones of its edges only. Raises
    SourceError or ValueError.
    """
    parts = Parts([obj for obj, _ in [moving, *joined]])
    face = parts.face([moving])
    found = _neighbours(parts, joined, face)
    shape = Part.Compound([face.shape, *(each.face.shape for each in found)])
    numbers = sources.Index(enumerate(shape.Edges, 1))
    chosen = [face.shape.Edges, *(each.edges or each.face.shape.Edges for each in found)]
    return Gathered(
        shape,
        [face.name, *(each.face.name for each in found)],
        [{numbers.find(edge) for edge in edges} for edges in chosen],
        parts,
    )


def first_face(moving, joined):
    """Return the first (object, "Face3") of links to faces and edges that a face is to join."""
    parts = Parts([obj for obj, _ in [moving, *joined]])
    found = _neighbours(parts, joined, parts.face([moving]))
    return found[0].link


def _neighbours(parts, joined, moving):
    elements = [(obj, one) for obj, name in joined for one in parts.elements(obj, name)]
    found = []
    for obj, element in elements:
        if element.shape.ShapeType == "Face":
            _add(found, obj, element, None, moving)
    for obj, element in elements:
        if element.shape.ShapeType == "Face":
            continue
        beside = [
            each
            for each in parts.faces_of(obj, element.shape)
            if not each.shape.isSame(moving.shape)
        ]
        chosen = [each for each in beside if any(each.shape.isSame(n.face.shape) for n in found)]
        meant = chosen or beside
        if len(meant) != 1:
            raise ValueError(
                tr("{name} does not bound one face alone: select the face to join, too").format(
                    name=element.name
                )
            )
        _add(found, obj, meant[0], element.shape, moving)
    return found


def _add(found, obj, face, edge, moving):
    """Add a face, or an edge of one, to the Neighbours."""
    if face.shape.isSame(moving.shape):
        raise ValueError(tr("{name} would join itself: choose other faces").format(name=face.name))
    for place, known in enumerate(found):
        if known.face.shape.isSame(face.shape):
            if edge is not None:
                found[place] = known._replace(edges=(known.edges or []) + [edge])
            return
    link = obj, face.name.rpartition(".")[2]
    found.append(Neighbour(face, None if edge is None else [edge], link))


def sides_of(model, gathered, match_mm):
    """Return the sides as match_sides() takes them: chains of edges, and the edges that they join.

    Raises ValueError for a face that meets the moving one nowhere.
    """
    meets: Dict[int, Set[int]] = {}
    own, met = gathered.edges[0], set()
    for seam in model.analyze(match_mm=match_mm).to_dict()["seams"]:
        if 1 not in seam["faces"] or len(set(seam["faces"])) != 2:
            continue
        (other,) = (number for number in seam["faces"] if number != 1)
        theirs = set(seam["edges"]) & gathered.edges[other - 1]
        if theirs:
            met.add(other)
            for edge in own & set(seam["edges"]):
                meets.setdefault(edge, set()).update(theirs)
    for number, name in enumerate(gathered.names[1:], 2):
        if number not in met:
            raise ValueError(_apart(gathered, number, name, match_mm))
    return [
        {"edges": group, "neighbours": sorted(set().union(*(meets[edge] for edge in group)))}
        for group in _chains(gathered.shape, sorted(meets))
    ]


def _apart(gathered, number, name, match_mm):
    faces = gathered.shape.Faces
    edges = [gathered.shape.Edges[each - 1] for each in gathered.edges[number - 1]]
    distance = faces[0].distToShape(Part.Compound(edges))[0]
    return tr(
        "{name} has no edge along {moving} within the match distance of {match_mm} mm (they are "
        "{distance} mm apart): allow a larger one, or leave it out"
    ).format(
        name=name,
        moving=gathered.names[0],
        match_mm="%g" % match_mm,
        distance="%.3g" % distance,
    )


def _chains(shape, numbers):
    """Return the edges as chains that have one tangent where they meet."""
    groups = [[number] for number in numbers]
    for one in numbers:
        for other in numbers:
            mine, theirs = (
                next(group for group in groups if number in group) for number in (one, other)
            )
            if mine is not theirs and _go_on(shape.Edges[one - 1], shape.Edges[other - 1]):
                groups.remove(theirs)
                mine += theirs
    return groups


def _go_on(edge, other):
    return any(
        vertex.isSame(each) and chain.goes_on(edge, other, vertex)
        for vertex in edge.Vertexes
        for each in other.Vertexes
    )


def report_of(result, gathered):
    """Return the entries of a report about the result of match_sides()."""
    seams = result.to_dict()["seams"]
    reason = result.reason
    if result.matched:
        reason = match_text.chain_reason(gathered.names, result.depth_mm)
    return {
        "matched": result.matched,
        "reason": match_text.advised(
            match_text.named(reason, gathered.names, gathered.edge_name), result.reason_code
        ),
        "exact": False,
        "largest_move_mm": max((each["largest_move_mm"] for each in result.moves), default=0.0),
        "before": match_text.worst([seam["before"] for seam in seams]),
        "after": match_text.worst([seam["after"] for seam in seams]),
        "seams": seams,
        "faces": gathered.names,
    }
