# SPDX-License-Identifier: LGPL-2.1-or-later
"""From shapes to points and curves of the kernel. The shapes are only read."""

from typing import Any, List, NamedTuple, Tuple

import FreeCAD as App
import numpy
import Part

from freecad.seamwright.document import sources
from freecad.seamwright.document.elements import KINDS
from freecad.seamwright.plain.language import tr
from freecad.seamwright.plain.summary import counted

#: Ends of edges no further apart than this are one point: the tolerance of FreeCAD's wires.
GAP_MM = 1e-7

#: Coordinates of points are smaller: OpenCASCADE takes larger ones for infinite.
MOST_MM = 1e15


class Chain(NamedTuple):
    """Edges end to end; ``edges``: [(edge, whether it runs backwards), ...]."""

    edges: List[Tuple[Any, bool]]
    closed: bool


def shapes_of(links):
    """Return the shapes that links name, [(object, "Edge3" or ""), ...], as they lie in the model.

    Raises SourceError for objects and elements that do not exist, or that are no curves.
    """
    return [_shape_of(obj, name) for obj, name in links]


def _shape_of(obj, name):
    if not sources.has_shape(obj):
        is_mesh = obj.isDerivedFrom("Mesh::Feature")
        what = tr("is a mesh") if is_mesh else tr("has no points or edges")
        raise sources.SourceError(
            tr("{label} {what}: choose points, edges, wires or sketches.").format(
                label=obj.Label, what=what
            )
        )
    shape = _points_of_sketch(obj) or sources.placed_shape(obj)
    if not name:
        if len(shape.Faces) > 1:
            raise sources.SourceError(
                tr("{label} has {faces} faces: choose some of its edges, or one face.").format(
                    label=obj.Label, faces=len(shape.Faces)
                )
            )
        return shape
    kind = name.rstrip("0123456789")
    found, digits = getattr(shape, KINDS[kind]) if kind in KINDS else [], name[len(kind) :]
    if not digits or not 0 < int(digits) <= len(found):
        raise sources.SourceError(tr("{label} has no {name}: choose another one.").format(
            label=obj.Label, name=name
        ))
    return found[int(digits) - 1]


def _points_of_sketch(obj):
    """Return the points of a sketch that has nothing else; None for other objects.

    Before FreeCAD 1.0 its shape is null, and all points are construction geometry.
    """
    if not obj.isDerivedFrom("Sketcher::SketchObject") or obj.Shape.Edges:
        return None
    points = [part for part in obj.Geometry if isinstance(part, Part.Point)]
    placement = sources.parent_placement(obj) * obj.Placement
    places = [placement.multVec(App.Vector(point.X, point.Y, point.Z)) for point in points]
    return Part.Compound([Part.Vertex(place) for place in places]) if points else None


def edges_of(shapes):
    """Return the edges of the shapes without repeats; an edge without length does not count."""
    found, known = [], {}
    for shape in shapes:
        for edge in shape.Edges:
            alike = known.setdefault(edge.hashCode(), [])
            if not edge.Degenerated and not any(edge.isSame(other) for other in alike):
                alike.append(edge)
                found.append(edge)
    return found


def chains_of(shapes):
    """Return the Chains of the edges of shapes: edges are joined where their ends meet."""
    return [_chain(edges) for edges in Part.sortEdges(edges_of(shapes))]


def _chain(edges):
    ends = [ends_of(edge) for edge in edges]
    check_places([tuple(point) for pair in ends for point in pair])
    at = ends[0][1]
    if len(edges) > 1 and not any(_meet(at, point) for point in ends[1]):
        at = ends[0][0]
    runs = [(edges[0], not _meet(at, ends[0][1]))]
    start = ends[0][1] if runs[0][1] else ends[0][0]
    for edge, (first, last) in zip(edges[1:], ends[1:]):
        backwards = not _meet(at, first)
        runs.append((edge, backwards))
        at = first if backwards else last
    return Chain(runs, _meet(at, start))


def _meet(one, other):
    return one.distanceToPoint(other) <= GAP_MM


def is_straight(edge):
    """Return whether an edge is a line."""
    return edge.Curve.TypeId in ("Part::GeomLine", "Part::GeomLineSegment")


def curve_of(module, edge):
    """Return the BSplineCurve of an edge, exactly, from its first to its last parameter."""
    return kernel_curve(module, nurbs_of(edge))


def nurbs_of(edge):
    """Return the curve of an edge as one of FreeCAD, from its first to its last parameter."""
    # FreeCAD 1.0 loses the curve of an edge that was drawn; a copy has no polygon.
    nurbs = edge.copy().toNurbs().Edges[0]
    curve = nurbs.Curve
    if nurbs.ParameterRange != (curve.FirstParameter, curve.LastParameter):
        curve.segment(*nurbs.ParameterRange)
    return curve


def kernel_curve(module, curve):
    """Return the BSplineCurve of a Bezier or B-spline curve of FreeCAD."""
    found = module.curve_from_freecad(curve)
    if isinstance(found, module.BezierCurve):
        return module.BSplineCurve.from_bezier(found)
    return found


def nearest_ends(edges):
    """Return for two edges whether their last points are the ends nearest to each other.

    Raises ValueError for another number of edges.
    """
    if len(edges) != 2:
        raise ValueError(tr("{edges} chosen: choose two").format(
            edges=counted(len(edges), "edge")
        ))
    return min(
        ((one, other) for one in (False, True) for other in (False, True)),
        key=lambda pair: _distance(edges, pair),
    )


def ends_to_bridge(edges, flips):
    """Return for two edges whether a curve between them is at their last points.

    It is between their nearest ends; where these meet, between the other ones. ``flips``: which
    edge takes its other end instead. Raises ValueError for another number of edges, and where the
    ends meet.
    """
    nearest = nearest_ends(edges)
    meet = _distance(edges, nearest) <= GAP_MM
    ends = tuple(end != (flip != meet) for end, flip in zip(nearest, flips))
    if _distance(edges, ends) <= GAP_MM:
        raise ValueError(
            tr("the edges meet where the curve would be: choose other ends, or other edges")
        )
    return ends


def _distance(edges, at_last):
    first, second = (ends_of(edge)[end] for edge, end in zip(edges, at_last))
    return first.distanceToPoint(second)


def ends_of(edge):
    """Return the first and the last point of an edge."""
    return edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)


def spline_of(module, chain):
    """Return the BezierSpline of a Chain; each edge has its length in the parameter.

    A single edge keeps its own parameter.
    """
    segments, knots = [], []
    for edge, backwards in chain.edges:
        spline = curve_of(module, edge).bezier_spline()
        own = numpy.asarray(spline.knots) - spline.knots[0]
        pieces = [spline.segment(place) for place in range(spline.segments)]
        if backwards:
            own = own[-1] - own[::-1]
            pieces = [piece.reversed() for piece in reversed(pieces)]
        if len(chain.edges) > 1:
            own = own * (edge.Length / own[-1])
        start = knots.pop() if knots else 0.0
        knots += [start + float(each) for each in own]
        segments += pieces
    return module.BezierSpline.from_segments(segments, knots, chain.closed, 2 * GAP_MM)


def points_of(shapes, samples):
    """Return (points (count, 3), whether they are closed) of vertices, or of edges end to end.

    Straight edges give their ends; others also ``samples`` points between. Raises ValueError for
    anything else, for one point, and for neighbours that are the same point.
    """
    chains = chains_of(shapes)
    alone = [shape for shape in shapes if not shape.Edges]
    if not chains:
        points = [tuple(vertex.Point) for shape in alone for vertex in shape.Vertexes]
        return checked_points(points, closed=False)
    if alone:
        raise ValueError(tr("points and edges are chosen: choose either"))
    if len(chains) > 1:
        raise ValueError(tr("the edges are {chains} separate curves: choose one").format(
            chains=len(chains)
        ))
    points = []
    for edge, backwards in chains[0].edges:
        points += _points_on(edge, backwards, samples)
    first, last = chains[0].edges[-1][0].ParameterRange
    at = first if chains[0].edges[-1][1] else last
    if not chains[0].closed:
        points.append(tuple(chains[0].edges[-1][0].valueAt(at)))
    return checked_points(points, chains[0].closed)


def _points_on(edge, backwards, samples):
    """Return the points of an edge without its end."""
    count = 1 if is_straight(edge) else samples + 1
    first, last = edge.ParameterRange
    if backwards:
        first, last = last, first
    return [tuple(edge.valueAt(first + (last - first) * k / count)) for k in range(count)]


def check_places(points):
    """Raise ValueError for a point that is not finite or too far away."""
    for point in points:
        if not all(abs(coordinate) < MOST_MM for coordinate in point):
            raise ValueError(
                tr("a point is ({point}): coordinates must be finite and below {most:g} mm").format(
                    point="%g, %g, %g" % tuple(point), most=MOST_MM
                )
            )


def checked_points(points, closed):
    """Return (points (count, 3), whether they are closed); they are where the ends are the same.

    Raises ValueError for one point, for neighbours that are the same point, and for points that are
    not finite or too far away.
    """
    points = [tuple(point) for point in points]
    check_places(points)
    if len(points) > 2 and numpy.abs(numpy.subtract(points[0], points[-1])).max() <= GAP_MM:
        points, closed = points[:-1], True
    if len(points) < 2:
        raise ValueError(
            tr("there is only one point: choose two or more")
            if points
            else tr("there are no points")
        )
    for place, (one, other) in enumerate(zip(points, points[1:]), 1):
        if numpy.abs(numpy.subtract(one, other)).max() <= GAP_MM:
            raise ValueError(
                tr(
                    "points {first} and {second} are the same, ({point}): leave one of them out"
                ).format(first=place, second=place + 1, point="%g, %g, %g" % tuple(one))
            )
    return numpy.array(points, float), closed
