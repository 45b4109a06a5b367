# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysis tools against closed forms, on FreeCAD's console; run by run_freecad.py."""

import itertools
import math
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD as App
import models
import numpy
import Part
from document_cases import ABSENT, DocumentCase
from surface_cases import at_x, sheet

from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.maps import combs, deviation, distance, kinds, meshes, tool
from freecad.seamwright.document.sources import SourceError
from freecad.seamwright.document.surfaces import kinds as surfaces
from freecad.seamwright.plain import maps, nearest, options
from freecad.seamwright.plain.kernel import KernelUnavailable


def saddle(size=10.0, bend=0.05):
    """The surface z = bend x y over a square, as a bilinear patch: exact."""
    surface = Part.BezierSurface()
    for i, j in itertools.product((0, 1), (0, 1)):
        x, y = size * (2 * i - 1), size * (2 * j - 1)
        surface.setPole(i + 1, j + 1, App.Vector(x, y, bend * x * y))
    return surface.toShape()


def saddle_curvatures(points, bend=0.05):
    """Gaussian and mean curvature of z = bend x y, from the formulas of a graph."""
    x, y = points[:, 0], points[:, 1]
    p, q, s = bend * y, bend * x, bend
    w = 1 + p * p + q * q
    return -s * s / w**2, -2 * p * q * s / (2 * w**1.5)


def values(kind, shape, **options):
    (found,) = kinds.make(kind, shape, **options).found
    return found.mesh, found.values


class Curvatures(unittest.TestCase):
    def check(self, shape, exact):
        """``exact(points)``: (Gaussian, mean up to the side of the normals)."""
        for quantity in maps.QUANTITIES:
            mesh, found = values("CurvatureMap", shape, quantity=quantity)
            gaussian, mean = exact(mesh.points)
            root = numpy.sqrt(numpy.maximum(mean**2 - gaussian, 0))
            largest = numpy.maximum(abs(mean + root), abs(mean - root))
            wanted = {
                maps.GAUSSIAN: gaussian, maps.LARGEST: largest, maps.RADIUS: 1 / largest
            }  # fmt: skip
            self.assertGreater(len(found), 50)
            if quantity == maps.MEAN:
                numpy.testing.assert_allclose(abs(found), abs(mean), atol=1e-6)
            else:
                # Rounding of equal principal curvatures is that of a root.
                numpy.testing.assert_allclose(found, wanted[quantity], rtol=2e-5, atol=1e-9)

    def test_sphere(self):
        self.check(
            Part.makeSphere(8), lambda p: (0 * p[:, 0] + 1 / 64, 0 * p[:, 0] - 1 / 8)
        )

    def test_cylinder(self):
        face = Part.makeCylinder(5, 20).Faces[0]
        self.check(face, lambda p: (0 * p[:, 0], 0 * p[:, 0] - 0.1))
        made = kinds.make("CurvatureMap", face, quantity="Smallest radius")
        self.assertAlmostEqual(made.report["least"], 5)
        self.assertTrue(made.summary.startswith("Smallest radius 5 mm at ("), made.summary)

    def test_torus(self):
        def exact(points):
            across = numpy.hypot(points[:, 0], points[:, 1])
            cosine = (across - 20) / 5
            other = cosine / across
            return other / 5, -(0.2 + other) / 2

        self.check(Part.makeTorus(20, 5), exact)

    def test_saddle(self):
        self.check(saddle(), saddle_curvatures)

    def test_a_position_changes_points_and_no_curvature(self):
        shape = saddle()
        before, found = values("CurvatureMap", shape)
        turn = App.Placement(App.Vector(100, 2, 3), App.Rotation(App.Vector(1, 1, 1), 33))
        shape.Placement = turn
        after, again = values("CurvatureMap", shape)
        self.assertIs(before.unplaced, after.unplaced, "the mesh is made once")
        numpy.testing.assert_array_equal(found, again)
        moved = turn.multVec(App.Vector(*before.points[7]))
        numpy.testing.assert_allclose(after.points[7], tuple(moved), atol=1e-12)

    def test_normals_of_separate_sheets_point_to_one_side(self):
        left, right = models.sheet(-1), models.sheet(1)
        right.reverse()
        made = kinds.make("CurvatureMap", [left, right])
        near = [abs(each.mesh.points[:, 0]) < 1e-9 for each in made.found]
        one, other = (each.values[at] for each, at in zip(made.found, near))
        self.assertGreater(one.mean() * other.mean(), 0)


class DraftAndLines(unittest.TestCase):
    def test_draft_of_a_cone_is_its_half_angle(self):
        cone = Part.makeCone(10, 6, 20)
        angle = math.degrees(math.atan(4 / 20))
        made = kinds.make("DraftAngle", cone, towards_deg=angle - 0.01)
        mesh, found = made.found[0].mesh, made.found[0].values
        side = slice(mesh.first_nodes[0], mesh.first_nodes[1])
        numpy.testing.assert_allclose(found[side], angle, atol=1e-9)
        self.assertAlmostEqual(made.report["shares"]["steep"], 0)
        self.assertEqual((made.report["least"], made.report["largest"]), (-90, 90))
        steep = kinds.make("DraftAngle", cone, towards_deg=angle + 0.01).report["shares"]["steep"]
        self.assertAlmostEqual(steep, cone.Faces[0].Area / cone.Area, delta=2e-3)
        _, found = values("DraftAngle", cone, pull=[1, 0, 0])
        self.assertAlmostEqual(abs(found[side]).max(), 90 - angle, delta=1)

    def test_shares_of_a_ball_and_a_torus_are_those_of_the_area(self):
        for limit in (3, 30):
            shares = kinds.make(
                "DraftAngle", Part.makeSphere(8), towards_deg=limit, away_deg=limit
            ).report["shares"]
            self.assertAlmostEqual(shares["steep"], math.sin(math.radians(limit)), delta=2e-3)
            self.assertAlmostEqual(shares["towards"], shares["away"], delta=2e-3)
        shares = kinds.make("DraftAngle", Part.makeTorus(20, 5)).report["shares"]
        self.assertAlmostEqual(shares["steep"], 6 / 180, delta=4e-3)

    def test_isophotes_of_a_sphere_are_its_latitudes(self):
        mesh, found = values("ReflectionLines", Part.makeSphere(8), lines="Isophotes")
        latitudes = numpy.degrees(numpy.arccos(numpy.clip(mesh.points[:, 2] / 8, -1, 1)))
        numpy.testing.assert_allclose(found, latitudes, atol=1e-5)

    def test_highlight_lines_of_a_sphere(self):
        """Normals run through the middle: the height h is reached at h y / z."""
        mesh, found = values(
            "ReflectionLines", Part.makeSphere(8), lines="Highlight lines",
            distance_mm=30.0, spacing_mm=5.0,
        )  # fmt: skip
        high = mesh.points[:, 2] > 1
        wanted = 30 * mesh.points[high, 1] / mesh.points[high, 2] / 5
        numpy.testing.assert_allclose(abs(found[high]), abs(wanted), rtol=1e-6, atol=1e-9)

    def test_bad_options_are_named(self):
        for kind, given, text in (
            ("DraftAngle", {"pull": [0, 0, 0]}, "Direction of pull = "),
            ("DraftAngle", {"towards_deg": -1}, "towards_deg = -1"),
            ("ReflectionLines", {"width": 1.0}, "Width = 1"),
            ("ReflectionLines", {"lines": "Isophotes", "direction": [1, 2]}, "Direction = "),
            ("CurvatureMap", {"range": "Given", "low": 2, "high": 1}, "from 2 to 1"),
            ("CurvatureMap", {"quantity": "Middle"}, "choose one of"),
        ):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                kinds.make(kind, Part.makeBox(1, 1, 1), **given)
        with self.assertRaises(TypeError):
            kinds.make("DraftAngle", Part.makeBox(1, 1, 1), colour=3)


class Deviations(unittest.TestCase):
    def test_concentric_spheres(self):
        for radius, other in ((10.5, 10), (10, 10.5)):
            made = deviation.measure(Part.makeSphere(radius), Part.makeSphere(other))
            numpy.testing.assert_allclose(made.found[0].values, radius - other, atol=1e-9)
            self.assertAlmostEqual(made.report["furthest_mm"], 0.5, delta=1e-9)
            self.assertIn("Sampled", made.summary)

    def test_a_saddle_and_its_offset(self):
        base = saddle()
        found = deviation.measure(base.makeOffsetShape(0.2, 1e-6), base).found[0].values
        known = found[numpy.isfinite(found)]
        self.assertGreater(len(known), 50)
        numpy.testing.assert_allclose(abs(known), 0.2, atol=2e-5)
        self.assertEqual(len({each > 0 for each in known}), 1, "one side")

    def test_a_shape_and_itself(self):
        block = models.rounded_block()
        report = deviation.measure(block, block).report
        self.assertLess(report["furthest_mm"], 1e-9)
        self.assertEqual(report["beyond"], 0)

    def test_of_a_part_of_a_surface_there_is_nothing_but_rounding(self):
        surface = saddle().Surface
        made = deviation.measure(surface.toShape(0.13, 0.71, 0.17, 0.83), surface.toShape())
        self.assertGreater(made.report["points"], 50)
        self.assertEqual(made.report["furthest_mm"], 0)
        self.assertIn("No deviation above rounding", made.summary)
        self.assertEqual(deviation.Deviation.marks(made.report), [])

    def test_corners_of_a_box_outside_of_a_ball(self):
        ball, box = Part.makeSphere(10), Part.makeBox(20, 20, 20, App.Vector(-10, -10, -10))
        made = deviation.measure(box, ball)
        self.assertAlmostEqual(made.report["furthest_mm"], 10 * (math.sqrt(3) - 1), delta=1e-6)
        numpy.testing.assert_allclose(numpy.abs(made.report["furthest_at"]), 10, atol=1e-9)
        self.assertAlmostEqual(made.report["least"], 0, delta=0.2)
        back = deviation.measure(ball, box).report
        self.assertLessEqual(back["largest"], 1e-9)
        exact = -(10 - 10 / math.sqrt(3))  # on the diagonal
        self.assertAlmostEqual(back["least"], exact, delta=0.2)  # between the points
        self.assertGreaterEqual(back["least"], exact - 1e-9)

    def test_an_edge_that_two_faces_share_is_not_free_though_their_triangles_lie_apart(self):
        box = Part.makeBox(10, 10, 10)
        mesh = meshes.mesh_later(box)(None)
        for place, face in enumerate(box.Faces):
            first, last = mesh.first_nodes[place : place + 2]
            mesh.points[first:last] -= 1e-4 * numpy.array(face.CenterOfMass - App.Vector(5, 5, 5))
        points = numpy.array([[10.3, 10.3, 5.0], [-0.3, -0.3, 2.0], [5.0, 10.3, 10.3]])
        found = distance.distances(points, [mesh], box.Faces, False)
        self.assertLess(abs(found - 0.3 * math.sqrt(2)).max(), 1e-3)
        self.assertTrue(numpy.isnan(distance.distances(points, [mesh], [
            face.copy() for face in box.Faces
        ], False)).all())

    def test_of_a_sheet_beside_another_one_no_foot_is_on_a_free_edge(self):
        surface = Part.BSplineSurface()
        surface.interpolate(
            [
                [App.Vector(10 * i, 10 * j, 0.5 * (i - 1.5) ** 2 * (1 + j)) for j in range(5)]
                for i in range(5)
            ]
        )
        face, beyond = surface.toShape(), 0
        for move in (App.Vector(41, 3, 1), App.Vector(-44, -7, 2), App.Vector(60, 50, -3)):
            other = face.copy()
            other.translate(move)
            made = deviation.measure(other, face)
            beyond += made.report["beyond"]
            for place in numpy.flatnonzero(numpy.isfinite(made.found[0].values)):
                point = App.Vector(*made.found[0].mesh.points[place])
                distance, _, (support, *_) = face.distToShape(Part.Vertex(point))
                self.assertEqual(support[0], "Face")
                self.assertAlmostEqual(abs(made.found[0].values[place]), distance, delta=1e-9)
        self.assertGreater(beyond, 3000)

    def test_points_beyond_a_free_edge(self):
        large, small = Part.makePlane(30, 10), Part.makePlane(10, 10)
        large.Placement.Base.z = 2
        made = deviation.measure(large, small)
        mesh, found = made.found[0].mesh, made.found[0].values
        over = mesh.points[:, 0] < 10 - 1e-6
        inside = over & (mesh.points[:, 0] > 1e-6) & (abs(mesh.points[:, 1] - 5) < 5 - 1e-6)
        numpy.testing.assert_allclose(found[inside], 2, atol=1e-9)
        self.assertTrue(numpy.isnan(found[~over & (mesh.points[:, 0] > 10 + 1e-6)]).all())
        self.assertGreater(made.report["beyond"], 0)
        self.assertIn("left out", made.summary)
        whole = deviation.measure(large, small, beyond_edges=True)
        self.assertAlmostEqual(whole.report["furthest_mm"], math.hypot(20, 2), delta=1e-6)
        self.assertEqual(whole.report["beyond"], 0)

    def test_what_two_shapes_share_takes_no_time(self):
        box = Part.makeBox(20, 20, 20)
        other = box.cut(Part.makeSphere(5, App.Vector(10, 10, 21)))
        compared = []

        def count(points, *others):
            compared.append(len(points))
            return nearest.nearest(points, *others)

        with mock.patch.object(distance, "nearest", count):
            made = deviation.measure(other, box)
            ((found,), number) = made.found, compared.pop()
            self.assertLess(number, 0.8 * len(found.values))
            self.assertGreater(number, 20)
            with mock.patch.object(distance, "_apart", lambda points, _: range(len(points))):
                slow = deviation.measure(Part.makeCompound([other]), box).found[0].values
        self.assertEqual(compared, [len(slow)])
        numpy.testing.assert_allclose(found.values, slow, atol=1e-9)
        self.assertAlmostEqual(made.report["least"], -4, delta=0.1)

    def test_it_can_be_stopped(self):
        work = deviation.Deviation.work(
            {
                name: [tool.Input("A", shape, App.Placement(), "")]
                for name, shape in (
                    ("Sources", Part.makeSphere(3)), ("Reference", Part.makeSphere(3.3))
                )
            },
            options.defaults(deviation.Deviation.OPTIONS),
        )  # fmt: skip
        for share in (0.0, 0.3, 0.6, 0.9):
            self.assertIsNone(work(lambda part, share=share: part < share))


class CombCases(unittest.TestCase):
    def comb(self, shape, **options):
        return kinds.make("CurvatureComb", shape, **options)

    def test_circle_and_line(self):
        made = self.comb(Part.makeCircle(10).Edges[0], density=24)
        (found,) = made.found
        self.assertEqual(found.points.shape, (24, 3))
        numpy.testing.assert_allclose(found.curvatures, -found.points / 100, atol=1e-12)
        self.assertAlmostEqual(made.report["largest_per_mm"], 0.1)
        ((points, ends),) = combs.segments(made.found, 2.0)
        size = numpy.linalg.norm(numpy.ptp(points, axis=0))
        lengths = numpy.linalg.norm(ends - points, axis=1)
        numpy.testing.assert_allclose(lengths, 2 * combs.LONGEST * size)
        self.assertGreater(((ends - points) * points).sum(axis=1).min(), 0, "outwards")
        line = self.comb(Part.makeLine(App.Vector(), App.Vector(3, 4, 5)))
        self.assertEqual(line.report["largest_per_mm"], 0)
        self.assertIn("straight", line.summary)

    def test_iso_curves_of_a_torus(self):
        torus = Part.makeTorus(20, 5)
        for lines, curvature in (("V lines", 0.2), ("U lines", None)):
            made = self.comb(torus, lines=lines, count=3, density=30)
            self.assertEqual(len(made.found), 3)
            for each in made.found:
                sizes = numpy.linalg.norm(each.curvatures, axis=1)
                across = numpy.hypot(each.points[:, 0], each.points[:, 1])
                wanted = curvature if curvature else 1 / across
                numpy.testing.assert_allclose(sizes, wanted, rtol=1e-9)
        self.assertEqual(len(self.comb(torus, count=4).found), 8)
        edges = sum(not edge.Degenerated for edge in torus.Edges)
        self.assertEqual(len(self.comb(torus, lines="Edges").found), edges)

    def test_iso_curves_end_at_the_edges_of_a_trimmed_face(self):
        plate = Part.makePlane(20, 20).cut(Part.makeCylinder(4, 2, App.Vector(10, 10, -1)))
        made = self.comb(plate, lines="U lines", count=1)
        self.assertEqual(len(made.found), 2)
        ends = sorted(each.points[k, 0] for each in made.found for k in (0, -1))
        numpy.testing.assert_allclose(ends, [0, 6, 14, 20], atol=1e-4)


class SeamPlots(unittest.TestCase):
    def seams(self, shape, *names):
        doc = App.newDocument("Plot", hidden=True)
        self.addCleanup(App.closeDocument, doc.Name)
        source = models.add(doc, shape, "Part")
        doc.recompute()
        obj = kinds.create("SeamPlot", [(source, list(names))], samples=101)
        return obj, report_of(obj).get("seams")

    def test_seams_have_the_label_of_their_object(self):
        doc = App.newDocument("Labels", hidden=True)
        self.addCleanup(App.closeDocument, doc.Name)
        block = models.add(doc, models.rounded_block(), "Block")
        block.Label = "Geh\u00e4use"
        doc.recompute()
        (seam,) = report_of(kinds.create("SeamPlot", [(block, ["Edge3"])]))["seams"]
        self.assertEqual(seam["name"], "Geh\u00e4use.Edge3")

    def test_samples_lie_within_the_proven_bounds(self):
        block = models.rounded_block()
        names = ["Edge%d" % number for number in range(1, len(block.Edges) + 1)]
        obj, seams = self.seams(block, *names[:12])
        self.assertEqual((kinds.error_text(obj), obj.Seams), ("", 12))
        for seam in seams:
            self.assertEqual(len(seam["points"]), 101)
            for key, values_there in seam["figures"].items():
                bounds = seam["bounds"][key]
                known = [each for each in values_there if each is not None]
                if bounds is not None and bounds["upper"] is not None:
                    # Rounding of the samples, whose arithmetic is not padded.
                    self.assertLessEqual(max(known), bounds["upper"] + 1e-9, key)

    def test_a_kink_of_known_size(self):
        obj, (seam,) = self.seams(*self.sheets())
        angles = seam["figures"]["angle_deg"]
        self.assertAlmostEqual(max(angles), models.SHEETS_DEG, delta=1e-3)
        bounds = seam["bounds"]["angle_deg"]
        self.assertLessEqual(bounds["lower"] - 1e-6, max(angles) + 1e-3)
        self.assertGreaterEqual(bounds["upper"], max(angles) - 1e-9)
        self.assertAlmostEqual(obj.MaxAngle.Value, max(angles))
        lengths = seam["lengths_mm"]
        self.assertEqual((lengths[0], sorted(lengths)), (0, lengths))

    def sheets(self):
        shell = Part.Compound(models.two_sheets())
        shell.sewShape(1e-5)
        middle = [
            "Edge%d" % number
            for number, edge in enumerate(shell.Edges, 1)
            if all(abs(vertex.X) < 1e-9 for vertex in edge.Vertexes)
        ]
        self.assertEqual(len(middle), 1)
        return (shell, *middle)

    def test_where_a_face_closes_upon_itself(self):
        cylinder = Part.makeCylinder(5, 20)
        (number,) = [
            n for n, edge in enumerate(cylinder.Edges, 1) if edge.isSeam(cylinder.Faces[0])
        ]
        _, (seam,) = self.seams(cylinder, "Edge%d" % number)
        self.assertEqual(seam["level"], "G2")
        for key in ("gap_mm", "angle_deg", "curvature_rel"):
            self.assertLess(max(seam["figures"][key]), 1e-9)

    def test_without_a_document(self):
        shape, name = self.sheets()
        made = kinds.make("SeamPlot", (shape, name), samples=11)
        (seam,) = made.found
        self.assertEqual((seam.points.shape, seam.name), ((11, 3), "Shape1." + name))
        self.assertAlmostEqual(seam.figures["angle_deg"].max(), models.SHEETS_DEG, delta=0.01)
        self.assertIn("Angle 3\u00b0", made.summary)
        with self.assertRaisesRegex(TypeError, "a Part.Shape is needed"):
            kinds.make("SeamPlot", ["Edge3"])

    def test_edges_of_two_objects_that_lie_side_by_side(self):
        doc = App.newDocument("Beside", hidden=True)
        self.addCleanup(App.closeDocument, doc.Name)
        sheets = [models.add(doc, shape, "Sheet") for shape in models.two_sheets()]
        doc.recompute()
        chosen = [
            (sheet, "Edge%d" % number)
            for sheet in sheets
            for number, edge in enumerate(sheet.Shape.Edges, 1)
            if all(abs(vertex.X) < 1e-9 for vertex in edge.Vertexes)
        ]
        obj = kinds.create("SeamPlot", chosen, samples=101)
        (seam,) = report_of(obj)["seams"]
        self.assertEqual((kinds.error_text(obj), len(seam["points"])), ("", 101))
        _, (sewn,) = self.seams(*self.sheets())
        for key in ("angle_deg", "curvature_rel"):
            self.assertAlmostEqual(max(seam["figures"][key]), max(sewn["figures"][key]), delta=1e-4)
        self.assertAlmostEqual(obj.MaxAngle.Value, models.SHEETS_DEG, delta=1e-3)
        sheets[1].Placement.Base.z = 0.05
        doc.recompute()
        (seam,) = report_of(obj)["seams"]
        self.assertGreater(min(seam["figures"]["gap_mm"]), 0.04)  # where the edge is oblique
        self.assertAlmostEqual(max(seam["figures"]["gap_mm"]), 0.05, delta=1e-4)
        sheets[1].Placement.Base.z = 0.5
        doc.recompute()
        self.assertIn("beside it within 0.1 mm", kinds.error_text(obj))

    def test_the_edge_of_a_blend_knows_the_edge_beside_it(self):
        doc = App.newDocument("Beside", hidden=True)
        self.addCleanup(App.closeDocument, doc.Name)
        low = models.add(doc, sheet(0, 0, 0.3), "Low")
        high = models.add(doc, sheet(60, 8, -0.2), "High")
        doc.recompute()
        ends = {"Start": (low, at_x(low, 30)), "End": (high, at_x(high, 60))}
        surface = surfaces.create("BlendSurface", {name: [link] for name, link in ends.items()})
        for start, beside in (((surface, at_x(surface, 30)), ends["Start"]),
                              (ends["End"], (surface, at_x(surface, 60)))):  # fmt: skip
            obj = kinds.create("SeamPlot", [start])
            self.assertEqual(tool.links_of(obj), [start, beside])
            (seam,) = report_of(obj)["seams"]
            self.assertEqual((seam["level"], len(seam["points"])), ("G2", 201))
            self.assertLess(max(seam["figures"]["angle_deg"]), 1e-4)
        with self.assertRaisesRegex(SourceError, "Blend Surface.Edge2 bounds 1 face"):
            kinds.create("SeamPlot", [(surface, "Edge2")])

    def test_an_edge_of_one_face_is_no_seam(self):
        with self.assertRaisesRegex(SourceError, "Part.Edge1 bounds 1 face: select edges"):
            self.seams(Part.makePlane(3, 3), "Edge1")


class Objects(DocumentCase):
    def test_a_tool_follows_its_source_and_has_no_shape(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        ball.Radius = 10
        self.doc.recompute()
        obj = kinds.create("CurvatureMap", ball)
        self.assertAlmostEqual(obj.Least, -0.1)
        self.assertTrue(obj.Shape.isNull())
        ball.Radius = 4
        self.doc.recompute()
        self.assertAlmostEqual(obj.Least, -0.25)
        obj.Quantity = "Gaussian"
        self.doc.recompute()
        self.assertAlmostEqual(obj.Largest, 1 / 16)
        ((point, text),) = obj.Proxy.marks(report_of(obj))
        self.assertAlmostEqual(App.Vector(*point).Length, 4, delta=1e-6)
        self.assertEqual(text, "0.0625 1/mm\u00b2")

    def test_saved_and_opened_again(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        self.doc.recompute()
        given = {
            "CurvatureMap": ball, "ReflectionLines": ball, "DraftAngle": ball,
            "CurvatureComb": ball, "SeamPlot": [(ball, "Edge2")],
        }  # fmt: skip
        found = {kind: kinds.create(kind, chosen) for kind, chosen in given.items()}
        summaries = {kind: obj.Summary for kind, obj in found.items()}
        self.assertEqual({obj.Outcome for obj in found.values()}, {"done"})
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            for kind, summary in summaries.items():
                again = self.doc.getObject(kind)
                self.assertEqual((again.Summary, again.Proxy.Type), (summary, kind))
                self.assertNotIn("Touched", again.State)

    def test_a_deleted_source_is_an_error_of_the_object(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        self.doc.recompute()
        obj = kinds.create("DraftAngle", ball)
        self.doc.removeObject("Ball")
        obj.touch()
        self.doc.recompute()
        self.assertIn("Invalid", obj.State)
        self.assertIn("were deleted", kinds.error_text(obj))

    def test_bad_values_have_a_reason_and_no_error_state(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        self.doc.recompute()
        obj = kinds.create("DraftAngle", ball, pull=[0, 0, 0])
        self.assertNotIn("Invalid", obj.State)
        self.assertIn("three numbers are needed", kinds.error_text(obj))
        self.assertEqual(obj.Outcome, "without result")

    def test_elements_that_do_not_exist_or_are_no_edges_are_refused(self):
        box = models.add(self.doc, Part.makeBox(1, 2, 3), "Crate")
        for kind, name, text in (
            ("CurvatureMap", "Face99", "Crate has no Face99"),
            ("SeamPlot", "Face1", "Crate.Face1 is no edge"),
        ):
            with self.assertRaisesRegex(Exception, text):
                kinds.create(kind, [(box, name)])

    def test_sources_that_do_not_fit_are_refused(self):
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(1, 0, 0)), "Line")
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        for kind, chosen, text in (
            ("CurvatureMap", line, "Line has no faces"),
            ("Deviation", box, "1 object selected"),
            ("SeamPlot", box, "Box is no edge"),
            ("CurvatureComb", [(box, "Vertex1")], "Box.Vertex1 is a point"),
            ("CurvatureMap", [], "nothing is selected"),
        ):
            with self.subTest(text), self.assertRaisesRegex((ValueError, SourceError), text):
                kinds.create(kind, chosen)
        with self.assertRaisesRegex(ValueError, "choose one of"):
            kinds.create("Nothing", box)

    def test_without_the_compiled_part(self):
        ball = self.doc.addObject("Part::Sphere", "Ball")
        self.doc.recompute()
        with ABSENT, self.assertRaises(KernelUnavailable):
            kinds.create("CurvatureMap", ball)

    def test_meshes_are_kept_for_the_last_shapes_only(self):
        meshes.kept.clear()
        shapes = [Part.makeBox(1, 1, 1 + k) for k in range(meshes.KEPT + 1)]
        for shape in shapes:
            kinds.make("DraftAngle", shape)
        self.assertIsNone(meshes.kept.find(shapes[0]))
        self.assertIsNotNone(meshes.kept.find(shapes[-1]))
        self.assertIsNone(meshes.kept.find(shapes[-1].reversed()))
