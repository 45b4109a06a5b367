# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs: arcs and lines within a tolerance of points, edges, wires or a sketch of a plane.

The class path is written into documents: neither rename nor move it.
"""

from typing import Any, List, NamedTuple

import FreeCAD as App
import numpy
import Part
import Sketcher

from freecad.seamwright.document.curves import inputs, results
from freecad.seamwright.document.curves.curve import Curve, share_of
from freecad.seamwright.document.curves.plane import Plane, plane_of
from freecad.seamwright.document.curves.samples import end_directions, runs_of
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, LENGTH, Option

SMOOTH, POLYGON = mark("Smooth curve"), mark("Polygon")

#: The part of the tolerance that is left to a spline near clothoids.
SPLINE_SHARE = 0.1

FLATNESS = Option(
    "Flatness", "flatness_mm", LENGTH, 0.001, "Flat within",
    "Points and edges may be off their common plane by no more, in mm", least=0.0,
)  # fmt: skip


#: The tolerance of a sketch of a curve that is not of arcs and lines.
SKETCH_MM = 0.01


class Gathered(NamedTuple):
    """Curves in a plane: splines, or else points with whether they are closed."""

    plane: Plane
    splines: List[Any]
    points: Any
    closed: bool


class Fits(NamedTuple):
    """Chains of arcs in a plane.

    ``fits``: for each curve the chains end to end, [(ArcFit, distance of what it is near from the
    input in mm), ...].
    """

    plane: Plane
    fits: list


class Arcs(Curve):
    """Proxy of a Part::FeaturePython that holds arcs and lines near its sources."""

    Type = "Arcs"
    LABEL = "Arcs"
    ICON = "seamwright-arcs"
    TIP = (
        "Make arcs and lines within a tolerance of the selected edges, wires, sketch or points of "
        "a plane. The distance is proven; few arcs are searched for."
    )
    NEEDS = "select edges, a wire, a sketch or points that lie in a plane"
    OPTIONS = (
        Option("Tolerance", "tolerance_mm", LENGTH, 0.01, "Tolerance",
               "Largest distance of the arcs from the input, in both directions, in mm", least=0.0),
        Option("Through", "through", CHOICE, SMOOTH, "Points are of a",
               "Whether single points are samples of a smooth curve or corners of a polygon",
               choices=(SMOOTH, POLYGON)),
        FLATNESS,
    )  # fmt: skip
    RESULTS = (
        ("Arcs", "App::PropertyInteger", "Number of arcs", "arcs"),
        ("Lines", "App::PropertyInteger", "Number of lines", "lines"),
        ("Distance", "App::PropertyLength", "Proven bound of the distance, in mm", "distance_mm"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return the Gathered of shapes in one plane."""
        return gather_planar(module, shapes, values["flatness_mm"])

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Fits."""
        tolerance = values["tolerance_mm"]
        if gathered.splines:
            count = len(gathered.splines)
            fits = [
                [(module.fit_arcs(each, tolerance, progress=share_of(progress, k, count)), 0.0)]
                for k, each in enumerate(gathered.splines)
            ]
        elif values["through"] == POLYGON:
            polygon = _polygon(module, gathered.points, gathered.closed)
            fits = [[(module.fit_arcs(polygon, tolerance, progress=progress), 0.0)]]
        else:
            fits = [_near_points(module, gathered, tolerance, progress)]
        return Fits(gathered.plane, fits)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wires)."""
        tolerance = values["tolerance_mm"]
        wires = [
            results.wire_of(
                [
                    results.arc_edge(arc, found.plane, tolerance)
                    for fit, _ in parts
                    for arc in fit.chain.arcs
                ]
            )
            for parts in found.fits
        ]
        every = [pair for parts in found.fits for pair in parts]
        edges = [edge for wire in wires for edge in wire.Edges]
        lines = sum(inputs.is_straight(edge) for edge in edges)
        report = {
            "curves": len(wires),
            "arcs": len(edges) - lines,
            "lines": lines,
            "length_mm": sum(fit.chain.length_mm for fit, _ in every),
            "distance_mm": max(fit.distance_mm + more for fit, more in every),
            "least_arcs": sum(getattr(fit, "least_arcs", 0) for fit, _ in every),
            "plane": found.plane.to_dict(),
        }
        return report, results.together(wires)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.arcs_text(report)


def gather_planar(module, shapes, flatness_mm):
    """Return the Gathered of edges, or of points, in one plane."""
    chains = inputs.chains_of(shapes)
    if not chains:
        return gather_points(shapes, flatness_mm)
    if any(not shape.Edges for shape in shapes):
        raise ValueError(tr("points and edges are chosen: choose either"))
    splines = [inputs.spline_of(module, chain) for chain in chains]
    plane = plane_of(numpy.vstack([spline.poles for spline in splines]), flatness_mm)
    flat = [results.flattened(module, spline, plane) for spline in splines]
    return Gathered(plane, flat, None, False)


def gather_points(shapes, flatness_mm):
    """Return the Gathered of points, or of the ends of straight edges, in one plane."""
    points, closed = inputs.points_of(shapes, samples=0)
    plane = plane_of(points, flatness_mm)
    return Gathered(plane, [], plane.coordinates(points)[0], closed)


def _polygon(module, points, closed):
    if closed:
        points = numpy.vstack([points, points[:1]])
    poles = numpy.column_stack([points, numpy.zeros(len(points))])
    return module.BezierSpline(1, range(len(poles)), poles, None, closed)


def _near_points(module, gathered, tolerance_mm, progress):
    """Return the lines and arcs of which points are samples, or else arcs from corner to corner.

    Those with fewer arcs are taken.
    """
    points, closed = gathered.points, gathered.closed
    runs = runs_of(module, points, closed, tolerance_mm)
    found = [
        _through(module, *run, tolerance_mm, share_of(progress, place, len(runs)))
        for place, run in enumerate(runs)
    ]
    if tolerance_mm == 0:
        return found
    sampled = module.sampled_arcs(points, closed=closed, tolerance_mm=tolerance_mm)
    if sampled is None or len(sampled.chain) > sum(len(fit.chain) for fit, _ in found):
        return found
    return [(sampled, 0.0)]


def _through(module, points, closed, tolerance_mm, progress):
    """Return the arcs near the clothoids or the biarcs through points, whichever are fewer."""
    ends = end_directions(points, closed)
    biarcs = module.biarc_spline(points, closed=closed, **ends)
    if tolerance_mm == 0:
        return _Exactly(biarcs), 0.0
    found = [(module.fit_arcs(biarcs, tolerance_mm, progress=progress), 0.0)]
    try:
        chain = module.clothoid_spline(points, closed=closed, **ends).chain
    except ValueError:  # points that are too far apart for the turn between them
        return found[0]
    near = chain.bezier_spline(SPLINE_SHARE * tolerance_mm)
    fit = module.fit_arcs(near.curve, tolerance_mm - near.distance_mm, progress=progress)
    return min([*found, (fit, near.distance_mm)], key=lambda pair: len(pair[0].chain))


class _Exactly:
    """The biarcs through points, as an ArcFit."""

    distance_mm = 0.0

    def __init__(self, biarcs):
        self.chain = biarcs.chain
        self.least_arcs = len(biarcs.chain)


def add_sketch(obj, tolerance_mm=SKETCH_MM):
    """Add a sketch with the arcs and lines of a curve as they are now, and return it.

    A curve that has other edges is replaced by arcs and lines within ``tolerance_mm``. Ends that
    meet are constrained to be coincident. Raises ValueError where the curve has no shape, or is not
    planar.
    """
    if obj.Shape.isNull():
        raise ValueError(tr("{label} has no curve: {summary}").format(
            label=obj.Label, summary=obj.Summary
        ))
    if obj.Shape.Faces:
        raise ValueError(tr("{label} has faces: choose curves").format(label=obj.Label))
    shape, plane = _flat_arcs(obj, tolerance_mm)
    sketch = obj.Document.addObject("Sketcher::SketchObject", obj.Name + "Sketch")
    sketch.Label = tr("{label} sketch").format(label=obj.Label)
    sketch.Placement = plane.placement()
    inverse = sketch.Placement.inverse()
    for wire in shape.Wires:
        _add_wire(sketch, wire, inverse)
    return sketch


def _flat_arcs(obj, tolerance_mm):
    """Return (wires of arcs and lines, their Plane) of a curve."""
    shape = obj.Shape
    if isinstance(obj.Proxy, Arcs):
        return shape, Plane.from_dict(report_of(obj)["plane"])
    if all(inputs.is_straight(each) or _is_arc(each) for each in shape.Edges):
        points = [tuple(each.valueAt(at)) for each in shape.Edges for at in _run(each)]
        return shape, plane_of(numpy.array(points), FLATNESS.default)
    made = Arcs.make([shape], tolerance_mm=tolerance_mm)
    return made.shape, Plane.from_dict(made.report["plane"])


def _is_arc(edge):
    return edge.Curve.TypeId in ("Part::GeomCircle", "Part::GeomArcOfCircle")


def _add_wire(sketch, wire, to_sketch):
    geometry, ends = [], []
    for edge in wire.OrderedEdges:
        runs = [edge.valueAt(at) for at in _run(edge)]
        start, middle, end = (to_sketch.multVec(point) for point in runs)
        if inputs.is_straight(edge):
            geometry.append(Part.LineSegment(start, end))
            ends.append((1, 2))
        elif edge.isClosed():
            centre = to_sketch.multVec(edge.Curve.Center)
            geometry.append(Part.Circle(centre, App.Vector(0, 0, 1), edge.Curve.Radius))
        else:
            arc = Part.Arc(start, middle, end)
            geometry.append(arc)
            turns_left = (middle - start).cross(end - start).z > 0
            ends.append((1, 2) if turns_left else (2, 1))
    first = sketch.GeometryCount
    sketch.addGeometry(geometry, False)
    last = len(ends) if wire.isClosed() else len(ends) - 1
    sketch.addConstraint(
        [
            Sketcher.Constraint(
                "Coincident",
                first + k,
                ends[k][1],
                first + (k + 1) % len(ends),
                ends[(k + 1) % len(ends)][0],
            )
            for k in range(last)
            if len(ends) > 1
        ]
    )


def _run(edge):
    """Return the parameters of start, middle and end as the wire runs through an edge."""
    first, last = edge.ParameterRange
    if edge.Orientation == "Reversed":
        first, last = last, first
    return first, (first + last) / 2, last
