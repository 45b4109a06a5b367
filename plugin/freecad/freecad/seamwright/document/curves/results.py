# SPDX-License-Identifier: LGPL-2.1-or-later
"""From curves of the kernel to shapes, and figures of them."""

import math

import FreeCAD as App
import numpy
import Part

from freecad.seamwright.document.curves.inputs import GAP_MM
from freecad.seamwright.document.curves.plane import Plane
from freecad.seamwright.plain.language import tr

#: Arcs that turn by less than this are drawn as lines if these are within a tenth of the tolerance:
#: their centre is far away, and has few digits left.
LEAST_TURN_RAD = 1e-5

#: Derivatives on both sides of a knot that differ by less than this part of them are the same.
SAME_DERIVATIVE = 1e-9

#: Distances from a plane below this part of the coordinates are their rounding.
FLAT_SHARE = 1e-12


def wire_of(edges):
    """Return the wire of edges that are in order."""
    wire = Part.Wire(edges)
    if len(wire.Edges) != len(edges):
        raise ValueError(tr("the {edges} edges do not join to one curve").format(edges=len(edges)))
    return wire


def together(shapes):
    """Return the only shape, or a compound of several."""
    return shapes[0] if len(shapes) == 1 else Part.Compound(shapes)


def arc_edge(arc, plane, tolerance_mm):
    """Return the edge of a PlanarArc in a Plane."""
    start, end = numpy.asarray(arc.start), numpy.asarray(arc.end)
    turn = arc.curvature_per_mm * arc.length_mm
    sagitta = abs(turn) * arc.length_mm / 8
    if turn == 0 or (abs(turn) < LEAST_TURN_RAD and sagitta <= tolerance_mm / 10):
        return Part.makeLine(plane.vector(start), plane.vector(end))
    if arc.length_mm * abs(arc.curvature_per_mm) >= 2 * math.pi * (1 - 1e-12):
        radius = 1 / arc.curvature_per_mm
        left = numpy.array([-math.sin(arc.direction_rad), math.cos(arc.direction_rad)])
        normal = App.Vector(*plane.frame[2])
        return Part.makeCircle(abs(radius), plane.vector(start + radius * left), normal)
    middle = numpy.asarray(arc.point(arc.length_mm / 2))
    return Part.Arc(*(plane.vector(point) for point in (start, middle, end))).toShape()


def raised(module, spline, plane):
    """Return a BezierSpline of the plane z = 0 as it lies in a Plane."""
    poles = plane.space(numpy.asarray(spline.poles)[:, :2])
    weights = spline.weights if spline.is_rational else None
    return module.BezierSpline(spline.degree, spline.knots, poles, weights, spline.closed)


def flattened(module, spline, plane):
    """Return a BezierSpline of a Plane in the plane z = 0."""
    poles, _ = plane.coordinates(spline.poles)
    poles = numpy.column_stack([poles, numpy.zeros(len(poles))])
    weights = spline.weights if spline.is_rational else None
    return module.BezierSpline(spline.degree, spline.knots, poles, weights, spline.closed)


def spline_edges(module, spline):
    """Return the edges of a BezierSpline.

    It is divided where it is not C1: OpenCASCADE sweeps, offsets and meshes C1 curves only.
    """
    segments = [spline.segment(place) for place in range(spline.segments)]
    smooth = _smooth_joints(spline, segments)
    ends = [0, *(numpy.flatnonzero(~smooth) + 1), len(segments)]
    splines = [
        module.BezierSpline.from_segments(
            segments[first:last], spline.knots[first : last + 1], False, GAP_MM
        )
        for first, last in zip(ends, ends[1:])
    ]
    return [module.curve_to_freecad(each).toShape() for each in splines]


def _smooth_joints(spline, segments):
    """Return for each inner joint whether the spline is C1 there."""
    widths = numpy.diff(spline.knots)[:, None]
    arriving, leaving = (
        numpy.array([each.derivatives(end, 1)[1] for each in segments]) / widths
        for end in (1.0, 0.0)
    )
    arriving, leaving = arriving[:-1], leaving[1:]
    size = numpy.maximum(*(numpy.linalg.norm(each, axis=1) for each in (arriving, leaving)))
    smooth = numpy.linalg.norm(arriving - leaving, axis=1) <= SAME_DERIVATIVE * size
    if not spline.is_rational:
        return smooth
    weights = numpy.asarray(spline.weights)
    at = numpy.arange(1, len(segments)) * spline.degree
    before = (weights[at] - weights[at - 1]) / widths[:-1, 0]
    after = (weights[at + 1] - weights[at]) / widths[1:, 0]
    largest = numpy.max([weights[at], abs(before), abs(after)], axis=0)
    return smooth & (abs(before - after) <= SAME_DERIVATIVE * largest)


def figures(module, curve, length_mm):
    """Return {length_mm, extrema, inflections} of a curve; at joints extrema count too.

    Inflections are those of curves in a plane, whatever its position.
    """
    found = module.curvature_variation(_level(module, curve))
    return {
        "length_mm": float(length_mm),
        "extrema": found.extrema + found.extrema_at_joints,
        "inflections": found.inflections,
    }


def _level(module, curve):
    """Return a curve of a plane in z = 0, where its curvature has a sign; another one as it is."""
    poles = numpy.asarray(curve.poles)
    plane = Plane.through(poles)
    _, distance = plane.coordinates(poles)
    if distance > FLAT_SHARE * abs(poles).max():
        return curve
    if isinstance(curve, module.BezierCurve):
        curve = module.BezierSpline.from_segments([curve], [0.0, 1.0], False, GAP_MM)
    return flattened(module, curve, plane)


def surface_shape(surfaces, gap_mm):
    """Return the shape of BSplineSurfaces side by side: a face, or a shell sewn within the gap."""
    faces = [_face(surface) for surface in surfaces]
    if len(faces) == 1:
        return faces[0]
    shell = Part.Compound(faces)
    shell.sewShape(max(gap_mm, GAP_MM))
    return shell


def _face(surface):
    knots_u, counts_u = numpy.unique(surface.knots_u, return_counts=True)
    knots_v, counts_v = numpy.unique(surface.knots_v, return_counts=True)
    poles = [[App.Vector(*map(float, pole)) for pole in row] for row in surface.poles]
    whole = Part.BSplineSurface()
    whole.buildFromPolesMultsKnots(
        poles,
        counts_u.tolist(),
        counts_v.tolist(),
        knots_u.tolist(),
        knots_v.tolist(),
        False,
        False,
        surface.degree_u,
        surface.degree_v,
    )
    return whole.toShape()
