# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of shapes, on FreeCAD's console; run by run_freecad.py."""

import math
import re
import time

import FreeCAD as App
import models
import numpy
import Part
from document_cases import DocumentCase

from freecad.seamwright.document.curves import arcs, clothoid
from freecad.seamwright.document.curves import kinds as curves
from freecad.seamwright.document.curves.conic import CHAIN
from freecad.seamwright.document.curves.samples import end_directions, runs_of
from freecad.seamwright.document.curves.spline import ALPHA, BETA, DIRECT, GAMMA, NU
from freecad.seamwright.plain import kernel

#: Points of a wave.
WAVE = [(0, 0, 0), (10, 22, 0), (26, 18, 0), (34, 2, 0), (52, 6, 0)]
#: Points around an area.
RING = [(0, 0, 0), (10, 22, 0), (26, 28, 0), (44, 20, 0), (52, -6, 0)]
#: A placement whose plane is parallel to no axis.
TURNED = App.Placement(App.Vector(5, -3, 8), App.Rotation(App.Vector(1, 2, 3), 40))


def vertices(points):
    return [Part.Vertex(*point) for point in points]


def slot(placement=App.Placement()):
    """A slot of 30 mm between the centres of its two half circles of 5 mm."""

    def at(x, y):
        return placement.multVec(App.Vector(x, y, 0))

    return Part.Wire(
        [
            Part.makeLine(at(0, -5), at(30, -5)),
            Part.Arc(at(30, -5), at(35, 0), at(30, 5)).toShape(),
            Part.makeLine(at(30, 5), at(0, 5)),
            Part.Arc(at(0, 5), at(-5, 0), at(0, -5)).toShape(),
        ]
    )


def ellipse():
    return Part.Ellipse(App.Vector(), 20, 8).toShape()


def wavy(count=21, noise_mm=0.05):
    """A cubic spline of a spiral, whose poles were moved to and fro."""
    points = [
        App.Vector(math.cos(at), math.sin(at), 0) * (40 + 20 * at)
        for at in numpy.linspace(0, 2, count)
    ]
    spline = Part.BSplineCurve()
    spline.interpolate(points)
    for place in range(3, spline.NbPoles - 2):
        pole = spline.getPole(place)
        spline.setPole(place, pole * (1 + (-1) ** place * noise_mm / 50))
    return spline.toShape()


def farthest(shape, other, count=400):
    """The largest distance of points of the edges of a shape from another shape."""
    return max(
        Part.Vertex(edge.valueAt(at)).distToShape(other)[0]
        for edge in shape.Edges
        for at in numpy.linspace(*edge.ParameterRange, count // len(shape.Edges))
    )


def area_inside(wire, count=2000):
    """The area of a closed wire of one edge in the plane z = 0, by the shoelace formula."""
    points = wire.Edges[0].discretize(count)
    return abs(sum(a.x * b.y - a.y * b.x for a, b in zip(points, points[1:]))) / 2


def kinks(wire):
    """The angles in degrees at which neighbouring edges of a wire meet."""
    ends = []
    for edge in wire.OrderedEdges:
        first, last = edge.ParameterRange
        if edge.Orientation == "Reversed":
            ends.append((-edge.tangentAt(last), -edge.tangentAt(first)))
        else:
            ends.append((edge.tangentAt(first), edge.tangentAt(last)))
    return [math.degrees(one[1].getAngle(other[0])) for one, other in zip(ends, ends[1:])]


class ArcsOfShapes(DocumentCase):
    def test_arcs_are_within_the_tolerance_of_an_ellipse_and_close(self):
        for tolerance in (0.1, 0.01):
            made = curves.make("Arcs", ellipse(), tolerance_mm=tolerance)
            self.assertLessEqual(made.report["distance_mm"], tolerance)
            self.assertLessEqual(farthest(made.shape, ellipse()), tolerance)
            self.assertLessEqual(farthest(ellipse(), made.shape), tolerance)
            self.assertTrue(made.shape.isClosed() and made.shape.isValid())
            self.assertLess(max(kinks(made.shape)), 1e-5)
            kinds = {edge.Curve.TypeId for edge in made.shape.Edges}
            self.assertEqual(kinds, {"Part::GeomCircle"})
            self.assertEqual(made.report["arcs"], len(made.shape.Edges))
            self.assertRegex(made.summary, r"^\d+ arcs and no lines, 92\.\d mm long, at most 0\.")

    def test_lines_and_arcs_stay_in_any_plane(self):
        for placement in (App.Placement(), TURNED):
            shape = slot(placement)
            made = curves.make("Arcs", shape)
            self.assertEqual((made.report["arcs"], made.report["lines"]), (2, 2))
            self.assertAlmostEqual(made.shape.Length, 60 + 10 * math.pi, delta=1e-9)
            self.assertLess(farthest(made.shape, shape), 1e-9)
        made = curves.make("Arcs", Part.makeCircle(7))
        self.assertEqual(len(made.shape.Edges), 1)
        self.assertAlmostEqual(made.shape.Edges[0].Curve.Radius, 7, delta=1e-9)

    def test_points_are_samples_of_a_curve_or_corners(self):
        smooth = curves.make("Arcs", vertices(WAVE))
        self.assertGreater(smooth.report["arcs"], 4)
        for point in vertices(WAVE):
            self.assertLess(point.distToShape(smooth.shape)[0], 0.01)
        polygon = curves.make("Arcs", vertices(WAVE), through=arcs.POLYGON)
        self.assertEqual((polygon.report["arcs"], polygon.report["lines"]), (0, 4))
        exact = curves.make("Arcs", vertices(WAVE), tolerance_mm=0)
        self.assertEqual(exact.report["distance_mm"], 0)
        for point in vertices(WAVE):
            self.assertLess(point.distToShape(exact.shape)[0], 1e-9)

    def test_several_curves_become_several_wires(self):
        made = curves.make("Arcs", [slot(), Part.makeCircle(2, App.Vector(15, 0, 0))])
        self.assertEqual((made.report["curves"], len(made.shape.Wires)), (2, 2))

    def test_a_sketch_has_the_arcs_and_closes(self):
        source = models.add(self.doc, slot(TURNED), "Slot")
        obj = curves.create("Arcs", source)
        sketch = arcs.add_sketch(obj)
        self.doc.recompute()
        self.assertEqual(sketch.GeometryCount, 4)
        self.assertEqual(sum(each.Type == "Coincident" for each in sketch.Constraints), 4)
        self.assertTrue(sketch.Shape.Wires[0].isClosed())
        self.assertLess(farthest(sketch.Shape, source.Shape), 1e-6)


def variation_per_mm3(edge, count=20000):
    """The integral of the squared change of curvature of a planar edge by its length, sampled."""
    at = numpy.linspace(*edge.ParameterRange, count + 1)
    points = numpy.array([tuple(edge.valueAt(float(each))) for each in at])
    curvatures = numpy.array([edge.curvatureAt(float(each)) for each in at])
    steps = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
    return float((numpy.diff(curvatures) ** 2 / steps).sum())


class FairShapes(DocumentCase):
    def test_the_variation_of_the_curvature_is_told(self):
        source = wavy()
        made = curves.make("FairCurve", source, tolerance_mm=0.2)
        found = [made.report["variation_%s_per_mm3" % when] for when in ("before", "after")]
        for value, shape in zip(found, (source, made.shape)):
            whole = sum(map(variation_per_mm3, shape.Edges))
            self.assertAlmostEqual(value, whole, delta=0.01 * whole)
        self.assertLess(found[1], found[0])
        self.assertIn(" % less); moved at most", made.summary)

    def test_a_wavy_spiral_becomes_fair_within_the_tolerance(self):
        source = wavy()
        made = curves.make("FairCurve", source, tolerance_mm=0.2)
        self.assertEqual((made.report["extrema_before"], made.report["extrema_after"]), (19, 1))
        self.assertLessEqual(made.report["moved_mm"], 0.2)
        self.assertLessEqual(farthest(made.shape, source), 0.2)
        for place in (0, -1):
            one, other = (shape.Vertexes[place].Point for shape in (source, made.shape))
            self.assertLess((one - other).Length, 1e-12)
        self.assertRegex(made.summary, r"^Curvature extrema \d+ \u2192 \d+, inflections ")

    def test_what_stays_at_the_ends(self):
        source = wavy()
        made = curves.make("FairCurve", source, tolerance_mm=0.2, ends="Tangent")
        first = source.FirstParameter
        angle = made.shape.Edges[0].tangentAt(first).getAngle(source.tangentAt(first))
        self.assertLess(angle, 1e-12)

    def test_lines_and_arcs_of_a_wire_stay(self):
        source = wavy()
        end, along = source.valueAt(source.LastParameter), source.tangentAt(source.LastParameter)
        wire = Part.Wire([source, Part.makeLine(end, end + along * 30)])
        made = curves.make("FairCurve", wire, tolerance_mm=0.2)
        self.assertEqual((made.report["kept"], len(made.shape.Edges)), (1, 2))
        self.assertLess(max(kinks(made.shape)), 1e-6)
        with self.assertRaisesRegex(ValueError, "no edge is a polynomial spline"):
            curves.make("FairCurve", slot())

    def test_an_edge_that_would_get_more_extrema_stays(self):
        source = Part.BSplineCurve()
        source.interpolate([App.Vector(t * math.cos(t), t * math.sin(t), 0) for t in range(1, 12)])
        source = source.toShape()
        for tolerance in (0.01, 0.1, 1.0):
            made = curves.make("FairCurve", source, tolerance_mm=tolerance)
            self.assertLessEqual(made.report["extrema_after"], made.report["extrema_before"])
            self.assertLessEqual(farthest(made.shape, source), tolerance)
            if made.report["kept"]:
                self.assertEqual((made.report["moved_mm"], farthest(made.shape, source)), (0, 0))

    def test_points_are_moved_within_the_tolerance(self):
        points = [(x, 0.002 * x * x + 0.03 * (-1) ** x, 4.0) for x in range(0, 40, 3)]
        made = curves.make("FairCurve", vertices(points), tolerance_mm=0.05)
        self.assertLess(made.report["extrema_after"], made.report["extrema_before"])
        for point in vertices(points):
            self.assertLess(point.distToShape(made.shape)[0], 0.06)
        wire = Part.makePolygon([App.Vector(*point) for point in points])
        self.assertEqual(curves.make("FairCurve", wire, tolerance_mm=0.05).report, made.report)


class Splines(DocumentCase):
    def test_families_pass_through_points_or_stay_in_their_hull(self):
        for family in (NU, BETA, GAMMA, DIRECT, ALPHA):
            for closed in (False, True):
                with self.subTest(family, closed=closed):
                    made = curves.make("Spline", vertices(WAVE), family=family, closed=closed)
                    self.assertTrue(made.shape.isValid())
                    self.assertEqual(made.shape.isClosed(), closed)
                    self.assertLess(max(kinks(made.shape), default=0), 1e-6)
                    distances = [v.distToShape(made.shape)[0] for v in vertices(WAVE)]
                    if family in (NU, BETA):
                        self.assertLess(max(distances), 1e-9)
                    else:
                        self.assertGreater(max(distances), 1)

    def test_tension_tightens_at_its_point_alone(self):
        free = curves.make("Spline", vertices(WAVE))
        tight = curves.make("Spline", vertices(WAVE), tension=[0, 0, 1e6, 0, 0])
        all_tight = curves.make("Spline", vertices(WAVE), tension=1e6)
        polygon = Part.makePolygon([App.Vector(*point) for point in WAVE])
        self.assertAlmostEqual(all_tight.shape.Length, polygon.Length, delta=1e-2)
        self.assertNotAlmostEqual(tight.shape.Length, free.shape.Length, delta=1e-2)
        self.assertNotAlmostEqual(tight.shape.Length, polygon.Length, delta=1e-2)
        with self.assertRaisesRegex(ValueError, "Tension has 2 numbers for 5 points"):
            curves.make("Spline", vertices(WAVE), tension=[0, 1])

    def test_inflections_and_extrema_do_not_depend_on_the_plane(self):
        for place in (TURNED, App.Placement(App.Vector(0, 7, 0), App.Rotation(0, 0, 90))):
            turned = [place.multVec(App.Vector(*point)) for point in WAVE]
            for family in (NU, BETA, GAMMA):
                level, other = (
                    curves.make("Spline", vertices(points), family=family).report
                    for points in (WAVE, turned)
                )
                self.assertGreater(level["inflections"], 0)
                for name in ("inflections", "extrema"):
                    self.assertEqual(other[name], level[name], (family, name))
        bent = [(x, y, 0.1 * x * y) for x, y, _ in WAVE]
        self.assertEqual(curves.make("Spline", vertices(bent)).report["inflections"], 0)

    def test_a_closed_spline_of_equal_points_is_symmetric(self):
        """Tension at the first point of a ring counts once, as at all others."""
        ring = vertices([(math.cos(k), math.sin(k), 0) for k in numpy.arange(6) * math.pi / 3])
        for options in ({"tension": 4.0}, {"family": BETA, "tension": -4.0}):
            wire = curves.make("Spline", ring, closed=True, **options).shape
            radii = [point.Length for edge in wire.Edges for point in edge.discretize(601)]
            by_sixth = [max(radii[k * 100 : k * 100 + 101]) for k in range(6)]
            self.assertLess(max(by_sixth) - min(by_sixth), 1e-3)

    def test_samples_of_curved_edges(self):
        edge = Part.makeCircle(10)
        few, many = (curves.make("Spline", edge, samples=k) for k in (3, 40))
        self.assertEqual((few.report["points"], many.report["points"]), (4, 41))
        self.assertAlmostEqual(many.shape.Length, 20 * math.pi, delta=1e-3)


class Clothoids(DocumentCase):
    def test_curvature_is_linear_between_points(self):
        made = curves.make("Clothoid", vertices(WAVE))
        self.assertEqual(made.report["pieces"], 4)
        for point in vertices(WAVE):
            self.assertLess(point.distToShape(made.shape)[0], 0.01)
        with self.assertRaisesRegex(ValueError, "splines hold clothoids within a tolerance"):
            curves.make("Clothoid", vertices(WAVE), tolerance_mm=0)

    def test_directions_at_the_ends(self):
        made = curves.make(
            "Clothoid", vertices(WAVE), ends="Given directions", start_deg=30, end_deg=-20
        )
        edge = made.shape.Edges[0]
        for at, angle in zip(edge.ParameterRange, (30, -20)):
            tangent = edge.tangentAt(at)
            found = math.degrees(math.atan2(tangent.y, tangent.x))
            self.assertAlmostEqual(found, angle, delta=1e-2)

    def test_a_slot_keeps_its_lines(self):
        made = curves.make("Clothoid", slot(TURNED), tolerance_mm=0.05)
        self.assertEqual(made.report["pieces"], 8)
        self.assertLessEqual(farthest(made.shape, slot(TURNED)), 0.05)
        self.assertLess(abs(made.report["radius_mm"] - 5), 0.1)
        self.assertNotIn("separate", clothoid.Clothoid.text(made.report))

    def test_edges_that_do_not_touch_are_told_to_stay_apart(self):
        arc = Part.Arc(App.Vector(20, 10, 0), App.Vector(27, 7, 0), App.Vector(30, 0, 0)).toShape()
        line = Part.makeLine(App.Vector(), App.Vector(10, 0, 0))
        made = curves.make("Clothoid", [line, arc])
        self.assertIn("2 separate curves", clothoid.Clothoid.text(made.report))


class Stopping(DocumentCase):
    def test_long_fits_stop_when_they_are_asked_to(self):
        module = kernel.load(Part.OCC_VERSION)
        curve = Part.BSplineCurve()
        curve.interpolate([App.Vector(*point) for point in WAVE])
        for kind in (arcs.Arcs, clothoid.Clothoid):
            values = {option.argument: option.default for option in kind.OPTIONS}
            values["tolerance_mm"] = 1e-9  # some ten seconds
            asked = []

            def progress(fraction, asked=asked):
                asked.append(fraction)
                return len(asked) < 20

            gathered = kind.gather(module, [curve.toShape()], values)
            began = time.monotonic()
            with self.assertRaises(module.Cancelled):
                kind.compute(module, gathered, values, progress)
            self.assertEqual(len(asked), 20)
            self.assertLess(time.monotonic() - began, 5)

    def test_bad_shapes_are_refused_with_a_reason(self):
        with self.assertRaisesRegex(TypeError, "a Part.Shape or a list of them is needed"):
            curves.make("Arcs", "abc")
        far = Part.makeLine(App.Vector(), App.Vector(1e99, 0, 0))
        for kind in ("Arcs", "Clothoid", "Spline"):
            with self.assertRaisesRegex(ValueError, "must be finite and below 1e.15 mm|infinite"):
                curves.make(kind, far)
        with self.assertRaisesRegex(ValueError, "must be finite and below"):
            curves.make("Spline", [], points_mm=[(1e300, 0, 0), (-1e300, 0, 0), (0, 0, 0)])
        with self.assertRaisesRegex(ValueError, "at most 10000"):
            curves.make("Spline", slot(), samples=100000)
        with self.assertRaisesRegex(ValueError, "tolerance_mm = None is no number"):
            curves.make("Arcs", slot(), tolerance_mm=None)
        with self.assertRaisesRegex(TypeError, "sources has None: an object"):
            curves.create("Arcs", None)

    def test_a_curve_that_is_not_valid_is_told(self):
        lines = [
            models.add(self.doc, Part.makeLine(App.Vector(x, y, 0), App.Vector(x + 1, y, 0)), "L")
            for x, y in ((0, 0), (2, 1))
        ]
        for tension, valid in ((1.0, True), (1e12, False)):
            obj = curves.create("BridgeCurve", lines, first_tension=tension)
            self.assertEqual((obj.Shape.isValid(), "not valid" in obj.Summary), (valid, not valid))

    def test_a_line_needs_no_arc(self):
        text = curves.make("Arcs", Part.makeLine(App.Vector(), App.Vector(9, 1, 0))).summary
        self.assertTrue(text.startswith("No arcs and 1 line, "), text)
        self.assertTrue(text.endswith("(proven)."), text)


class Conics(DocumentCase):
    def test_the_weight_makes_a_quarter_of_a_circle(self):
        corner = vertices([(10, 0, 3), (10, 10, 3), (0, 10, 3)])
        made = curves.make("Conic", corner, weight=math.sqrt(0.5))
        radii = [math.hypot(p.x, p.y) for p in made.shape.Edges[0].discretize(50)]
        self.assertLess(max(abs(radius - 10) for radius in radii), 1e-12)
        with self.assertRaisesRegex(ValueError, "on a line"):
            curves.make("Conic", vertices([(0, 0, 0), (1, 1, 0), (2, 2, 0)]))

    def test_a_spline_of_conics_passes_through_points(self):
        made = curves.make("Conic", vertices(WAVE), points=CHAIN)
        for point in vertices(WAVE):
            self.assertLess(point.distToShape(made.shape)[0], 1e-9)
        self.assertLess(max(kinks(made.shape)), 1e-5)
        self.assertEqual(len(made.shape.Edges), made.report["conics"])

    def test_how_far_a_spline_of_conics_is_from_an_edge_is_told(self):
        ellipse = Part.Ellipse(App.Vector(), 30, 12).toShape()
        made = curves.make("Conic", ellipse, points=CHAIN)
        found = re.search(r"seen up to (\S+) mm from the edges\.$", made.summary)
        off = max(
            abs((p.x / 30) ** 2 + (p.y / 12) ** 2 - 1) / math.hypot(2 * p.x / 900, 2 * p.y / 144)
            for p in made.shape.discretize(2000)
        )  # the distance from the ellipse, to first order
        self.assertAlmostEqual(float(found.group(1)), off, delta=0.1 * off)
        made = curves.make("Conic", vertices(WAVE), points=CHAIN)
        self.assertNotIn("seen up to", made.summary)


class Blends(DocumentCase):
    def test_frames_begin_and_end_with_the_curves(self):
        low, high = slot(), slot(App.Placement(App.Vector(0, 0, 20), App.Rotation()))
        made = curves.make("BlendCurves", [low, high], frames=3, exact=True)
        self.assertEqual(len(made.shape.Wires), 3)
        for wire, height in zip(made.shape.Wires, (0, 10, 20)):
            self.assertTrue(wire.isClosed())
            self.assertAlmostEqual(wire.BoundBox.ZMin, height, delta=1e-9)
            self.assertAlmostEqual(wire.Length, low.Length, delta=1e-3)

    def test_a_surface_has_corners_where_a_curve_has_some(self):
        square = Part.makePolygon(
            [App.Vector(*p) for p in ((-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0), (-9, -9, 0))]
        )
        circle = Part.makeCircle(5, App.Vector(0, 0, 20))
        made = curves.make("BlendCurves", [square, circle], result="Surface")
        self.assertEqual((made.shape.ShapeType, len(made.shape.Faces)), ("Shell", 4))
        self.assertTrue(made.shape.isValid())
        self.assertLess(farthest(square, made.shape, 40), 2e-3)
        self.assertLess(farthest(circle, made.shape, 40), 2e-3)

    def test_open_curves_make_one_face(self):
        low = curves.make("Spline", vertices(WAVE)).shape
        high = low.copy()
        high.Placement = App.Placement(App.Vector(0, 5, 30), App.Rotation(App.Vector(0, 0, 1), 10))
        made = curves.make("BlendCurves", [low, high], result="Surface")
        self.assertEqual(made.shape.ShapeType, "Face")
        with self.assertRaisesRegex(ValueError, "only one curve"):
            curves.make("BlendCurves", low)
        with self.assertRaisesRegex(ValueError, "some curves are closed"):
            curves.make("BlendCurves", [low, slot()])


class Bridges(DocumentCase):
    def test_tangent_and_curvature_are_continued(self):
        arc = Part.Arc(App.Vector(0, 0, 0), App.Vector(7, 3, 0), App.Vector(10, 10, 0)).toShape()
        spline = curves.make("Spline", vertices([(30, 40, 5), (45, 40, 9), (60, 20, 0)])).shape
        made = curves.make("BridgeCurve", [arc, spline.Edges[0]], first_tension=1.3)
        edge = made.shape.Edges[0]
        self.assertLess(made.shape.distToShape(arc)[0], 1e-9)
        start, end = edge.ParameterRange
        self.assertLess(edge.tangentAt(start).getAngle(arc.tangentAt(arc.LastParameter)), 1e-9)
        self.assertAlmostEqual(
            edge.curvatureAt(start), arc.curvatureAt(arc.LastParameter), delta=1e-9
        )
        other = spline.Edges[0]
        self.assertLess(edge.tangentAt(end).getAngle(other.tangentAt(other.FirstParameter)), 1e-9)
        self.assertAlmostEqual(
            edge.curvatureAt(end), other.curvatureAt(other.FirstParameter), delta=1e-9
        )

    def test_an_s_between_lines_has_one_inflection_in_every_plane(self):
        lines = [
            Part.makeLine(App.Vector(), App.Vector(10, 0, 0)),
            Part.makeLine(App.Vector(20, 5, 0), App.Vector(30, 5, 0)),
        ]
        for place in (App.Placement(), TURNED):
            turned = [Part.makeLine(*(place.multVec(v.Point) for v in each.Vertexes))
                      for each in lines]
            made = curves.make("BridgeCurve", turned, first_order="G1", second_order="G1")
            self.assertEqual(made.report["inflections"], 1)

    def test_other_ends(self):
        one = Part.makeLine(App.Vector(), App.Vector(10, 0, 0))
        other = Part.makeLine(App.Vector(20, 5, 0), App.Vector(30, 5, 0))
        made = curves.make("BridgeCurve", [one, other], flip_first=True)
        self.assertLess(made.shape.Vertexes[0].Point.Length, 1e-12)
        with self.assertRaisesRegex(ValueError, "1 edge chosen: choose two"):
            curves.make("BridgeCurve", one)

    def test_edges_with_a_common_end_are_bridged_at_their_other_ends(self):
        corner = App.Vector(10, 0, 0)
        lines = [Part.makeLine(App.Vector(), corner), Part.makeLine(corner, App.Vector(10, 8, 0))]
        wire = curves.make("BridgeCurve", lines).shape
        ends = [each.Point for each in wire.Vertexes]
        self.assertLess((ends[0] - App.Vector()).Length, 1e-12)
        self.assertLess((ends[1] - App.Vector(10, 8, 0)).Length, 1e-12)
        with self.assertRaisesRegex(ValueError, "the edges meet where the curve would be"):
            curves.make("BridgeCurve", lines, flip_first=True, flip_second=True)
        arcs = [
            Part.Arc(App.Vector(), App.Vector(5, side, 0), corner).toShape() for side in (3, -3)
        ]
        with self.assertRaisesRegex(ValueError, "the edges meet where the curve would be"):
            curves.make("BridgeCurve", arcs)

    def test_each_end_has_its_own_order(self):
        one = Part.Arc(App.Vector(0, 0, 0), App.Vector(7, 3, 0), App.Vector(10, 10, 0)).toShape()
        other = Part.Arc(App.Vector(30, 30, 4), App.Vector(40, 35, 2), App.Vector(50, 30, 0))
        other = other.toShape()
        for first in range(4):
            for second in range(4):
                orders = {"first_order": "G%d" % first, "second_order": "G%d" % second}
                made = curves.make("BridgeCurve", [one, other], **orders)
                edge = made.shape.Edges[0]
                self.assertEqual(edge.Curve.Degree, first + second + 1)
                start, end = edge.ParameterRange
                for order, at, arc, arc_at in (
                    (first, start, one, one.LastParameter),
                    (second, end, other, other.FirstParameter),
                ):
                    with self.subTest(orders, at=at):
                        gap = (edge.valueAt(at) - arc.valueAt(arc_at)).Length
                        angle = edge.tangentAt(at).cross(arc.tangentAt(arc_at)).Length
                        jump = abs(edge.curvatureAt(at) - arc.curvatureAt(arc_at))
                        self.assertLess(gap, 1e-9)
                        self.assertEqual((angle < 1e-9, jump < 1e-9), (order > 0, order > 1))
                self.assertIn("first edge G%d and the second G%d" % (first, second), made.summary)
                tensions = ["first_tension"] * (first > 0) + ["second_tension"] * (second > 0)
                self.assertEqual(list(made.report["handles"]), tensions)


class Joins(DocumentCase):
    def test_edges_of_any_direction_join_and_their_other_ends_stay(self):
        one = Part.makeLine(App.Vector(20, 0, 0), App.Vector(0, 0, 0))
        arc = Part.Arc(App.Vector(40, 12, 3), App.Vector(33, 4, 0), App.Vector(20.1, 0.3, 0))
        for moves in ("Both", "First", "Second"):
            for order, name in enumerate(("G1", "G2", "G3"), 1):
                with self.subTest(name, moves=moves):
                    made = curves.make("JoinCurves", [one, arc.toShape()], order=name, moves=moves)
                    self.assertEqual(len(made.shape.Edges), 2)
                    ends = [vertex.Point for vertex in made.shape.OrderedVertexes]
                    self.assertLess((ends[0] - App.Vector()).Length, 1e-12)
                    self.assertLess((ends[-1] - App.Vector(40, 12, 3)).Length, 1e-12)
                    self.assertLess(max(kinks(made.shape)), 1e-6)
                    if order > 1:
                        first, second = made.shape.OrderedEdges
                        self.assertAlmostEqual(
                            first.curvatureAt(first.LastParameter),
                            second.curvatureAt(second.FirstParameter),
                            delta=1e-9,
                        )
                    self.assertAlmostEqual(made.report["gap_mm"], math.hypot(0.1, 0.3), delta=1e-9)
        with self.assertRaisesRegex(ValueError, "a pole would move by .* mm, further than"):
            curves.make("JoinCurves", [one, arc.toShape()], most_mm=0.01)

    def test_an_edge_that_stays_is_the_same(self):
        one = wavy()
        end = one.valueAt(one.LastParameter)
        other = Part.makeLine(end + App.Vector(0, 0, 0.2), end + App.Vector(-30, -5, 0.2))
        made = curves.make("JoinCurves", [one, other], moves="Second")
        self.assertLess(farthest(made.shape.Edges[0], one), 1e-12)


#: Samples of a half circle and of the two lines that close it with corners.
BOW = [(20 * math.cos(at), 20 * math.sin(at), 1) for at in numpy.linspace(0, math.pi, 25)]
BOW += [(x, 0, 1) for x in range(-15, 20, 5)]


class Corners(DocumentCase):
    def test_corners_of_points_stay(self):
        points = numpy.array(BOW)[:, :2]
        runs = runs_of(kernel.load(Part.OCC_VERSION), points, True)
        self.assertEqual([len(run) for run, _ in runs], [25, 9])
        ring = Part.Compound(vertices([*BOW, BOW[0]]))
        for kind, options in (
            ("Arcs", {}), ("Clothoid", {}), ("Conic", {"points": CHAIN}), ("FairCurve", {})
        ):  # fmt: skip
            with self.subTest(kind):
                shape = curves.make(kind, ring, **options).shape
                self.assertTrue(shape.isClosed() and shape.isValid())
                self.assertAlmostEqual(shape.Length, 40 + 20 * math.pi, delta=0.2)
                self.assertEqual(sum(angle > 80 for angle in kinks(shape)), 1)
        bow = Part.Compound(vertices([*BOW[:25], BOW[0]]))
        faired = curves.make("FairCurve", bow)
        self.assertAlmostEqual(faired.shape.Length, 40 + 20 * math.pi, delta=0.2)
        made = curves.make("Arcs", ring)
        self.assertEqual((made.report["arcs"], made.report["lines"]), (1, 1))

    def test_directions_at_the_ends_are_those_of_circles(self):
        at = numpy.array([2.0, 2.5, 3.5, 4.1])
        for turn in (1, -1):
            circle = numpy.column_stack([numpy.cos(turn * at), numpy.sin(turn * at)])
            ends = end_directions(circle, False)
            for name, place in (("start_direction_rad", 2.0), ("end_direction_rad", 4.1)):
                true = turn * (place + math.pi / 2)
                self.assertAlmostEqual(math.remainder(ends[name] - true, 2 * math.pi), 0)

    def test_points_of_a_circle_have_none(self):
        for count in (3, 5, 12, 100):
            at = numpy.arange(count) * 2 * math.pi / count
            circle = numpy.column_stack([numpy.cos(at), numpy.sin(at)])
            ((run, closed),) = runs_of(kernel.load(Part.OCC_VERSION), circle, True)
            self.assertTrue(closed)
            self.assertEqual(len(run), count)

    def test_corners_between_points_are_found_by_arcs(self):
        sides = numpy.repeat([[1, 0], [0, 1], [-1, 0], [0, -1]], (60, 40, 60, 40), axis=0)
        points = numpy.cumsum(sides, axis=0) - 0.4 * sides
        ring = Part.Compound(vertices([(*point, 2) for point in [*points, points[0]]]))
        made = curves.make("Arcs", ring)
        self.assertEqual((made.report["arcs"], made.report["lines"]), (0, 4))
        self.assertAlmostEqual(made.shape.Length, 200)
        self.assertIn("the points are samples of these", made.summary)
