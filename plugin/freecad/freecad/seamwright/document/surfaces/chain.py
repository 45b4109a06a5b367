# SPDX-License-Identifier: LGPL-2.1-or-later
"""A side goes on along the edges that continue it with its tangent."""

import math

from freecad.seamwright.document.surfaces import sides

#: Edges that turn by more than this where they meet have a corner there: more is refused by a side.
LARGEST_TURN_DEG = 1.0


def tangent_chain(chosen):
    """Return the links of a side, [(object, "Edge3"), ...], with the edges that continue it.

    At each end it goes on while exactly one other edge continues it there with its tangent: a free
    edge where the edge is free, else one with a face beside the face that is continued. Faces that
    edges between two faces need are added, too. Raises SourceError or ValueError.
    """
    parts = sides.Parts([obj for obj, _ in chosen])
    parts.side(chosen)
    found = list(chosen)
    waiting = [link for link in chosen if link[1].startswith("Edge")]
    while waiting:
        obj, name = waiting.pop()
        for link in _next(parts, obj, name, found):
            if link not in found:
                found.append(link)
                waiting += [link] if link[1].startswith("Edge") else []
    edges = [link for link in found if link[1].startswith("Edge")]
    return edges + [link for link in found if link not in edges]


def _next(parts, obj, name, found):
    """Return the links of the edges that go on at both ends of an edge, and of their faces."""
    (edge,) = parts.elements(obj, name)
    chosen = [parts.elements(*link)[0] for link in found if link[1].startswith("Face")]
    beside = parts.faces_of(obj, edge.shape)
    own = next((f for f in beside if any(f.shape.isSame(c.shape) for c in chosen)), beside[0])
    for point in edge.shape.Vertexes:
        ways = [
            (other, face)
            for other in parts.edges_at(obj, point)
            if not other.shape.isSame(edge.shape) and goes_on(edge.shape, other.shape, point)
            for face in parts.faces_of(obj, other.shape)
            if len(parts.faces_of(obj, other.shape)) == len(beside)
            and _is_on_the_side_of(face.shape, own.shape, (edge.shape, other.shape), point)
        ]
        if len(ways) == 1:
            for each in ways[0] if len(beside) > 1 else ways[0][:1]:
                yield obj, each.name.rpartition(".")[2]


def goes_on(edge, other, point):
    """Return whether another edge leaves a vertex in the direction in which an edge arrives."""
    arriving, leaving = _out_of(edge, point), _out_of(other, point)
    return math.degrees(arriving.getAngle(-leaving)) <= LARGEST_TURN_DEG


def _out_of(edge, point):
    """Return the direction in which an edge leaves one of its vertices."""
    first, last = edge.ParameterRange
    at_first = edge.valueAt(first).distanceToPoint(point.Point)
    if at_first <= edge.valueAt(last).distanceToPoint(point.Point):
        return edge.tangentAt(first)
    return -edge.tangentAt(last)


def _is_on_the_side_of(face, own, side, point):
    """Return whether a face is the own one, or beside it at a vertex along an edge across the side.

    ``side``: the edges of the side that meet at the vertex.
    """
    if face.isSame(own):
        return True
    return any(
        one.isSame(other)
        and not any(one.isSame(edge) for edge in side)
        and any(vertex.isSame(point) for vertex in one.Vertexes)
        for one in face.Edges
        for other in own.Edges
    )
