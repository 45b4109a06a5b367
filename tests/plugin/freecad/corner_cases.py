# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corner Fillet, on FreeCAD's console; run by run_freecad.py."""

import contextlib
import math
from unittest import mock

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase
from match_cases import text_of

from freecad.seamwright.document import corner, elements
from freecad.seamwright.document.hooks import hooks


class CornerCase(DocumentCase):
    def cube(self, size=10.0):
        return models.add(self.doc, Part.makeBox(size, size, size), "Cube")

    def assertNotRounded(self, obj, text):
        self.assertWithout(obj, text)
        self.assertEqual((obj.Met, obj.Patches, obj.MaxAngle.Value), (False, 0, 0.0))
        self.assertTrue(obj.Shape.isNull())
        self.assertTrue(obj.Summary.startswith("Not rounded: "), obj.Summary)
        self.assertIn(text, obj.Summary)


def radii_by_axis(shape):
    """[(radius, axis)] of the cylinders of a shape."""
    surfaces = [face.Surface for face in shape.Faces if face.Surface.TypeId == "Part::GeomCylinder"]
    return [(surface.Radius, surface.Axis) for surface in surfaces]


class Results(CornerCase):
    def test_each_edge_gets_its_radius_and_the_seams_are_smooth(self):
        cube = self.cube()
        names, lengths, text = corner.corner_of(corner.prepare(cube, "Vertex1"))
        self.assertEqual((sorted(lengths), text), ([10.0] * 3, ""))
        obj = corner.create(cube, "Vertex1", [1.0, 2.0, 3.0])
        self.assertEqual((corner.error_text(obj), obj.Met, obj.CornerEdges), ("", True, names))
        self.assertEqual(
            (obj.Shape.ShapeType, obj.Shape.isValid(), obj.Shape.isClosed()), ("Solid", True, True)
        )
        self.assertEqual((obj.Patches, len(obj.Shape.Faces)), (6, 6 + 3 + 6))
        self.assertLess(obj.MaxAngle.Value, 0.001)
        found = radii_by_axis(obj.Shape)
        self.assertEqual(len(found), 3)
        for name, wanted in zip(names, (1.0, 2.0, 3.0)):
            along = cube.Shape.getElement(name).tangentAt(0)
            (radius,) = (radius for radius, axis in found if abs(axis.dot(along)) > 0.5)
            self.assertAlmostEqual(radius, wanted, delta=1e-12)
        self.assertRegex(
            obj.Summary,
            r"^Corner of 3 edges rounded with radii 1, 2, 3 mm; 24 seams, .*; G1 is met\.$",
        )

    def test_figures_hold_what_opencascade_evaluates(self):
        obj = corner.create(self.cube(), "Vertex3", [1.0, 2.5, 2.0])
        for seam in corner.report_of(obj)["seams"]:
            edge = obj.Shape.Edges[seam["edges"][0] - 1]
            faces = [obj.Shape.Faces[number - 1] for number in seam["faces"]]
            self.assertTrue(all(any(edge.isSame(other) for other in face.Edges) for face in faces))
            low, high = edge.ParameterRange
            for place in range(1, 20):
                point = edge.valueAt(low + (high - low) * place / 20)
                one, other = (face.normalAt(*face.Surface.parameter(point)) for face in faces)
                angle = math.degrees(math.asin(min(1.0, one.cross(other).Length)))
                self.assertLess(angle, seam["angle_deg"]["upper"] + 1e-5)

    def test_a_vertex_may_be_named_by_its_number(self):
        obj = corner.create(self.cube(), 1, 1.0)
        self.assertEqual(corner.error_text(obj), "")
        self.assertEqual(elements.names(obj, "Vertex"), ["Vertex1"])

    def test_one_radius_for_all_and_setbacks(self):
        cube = self.cube()
        obj = corner.create(cube, "Vertex1", 1.5)
        self.assertEqual((list(obj.Radii), obj.Met), ([1.5], True))
        chosen = [edge["setback_mm"] for edge in corner.report_of(obj)["edges"]]
        obj.Setbacks = [4.0, 0.0, 3.0]
        self.doc.recompute()
        given = [edge["setback_mm"] for edge in corner.report_of(obj)["edges"]]
        self.assertEqual((given[0], given[2]), (4.0, 3.0))
        self.assertAlmostEqual(given[1], chosen[1], delta=1e-9)

    def test_a_corner_at_a_curved_face(self):
        quarter = Part.makeCylinder(10, 20, App.Vector(), App.Vector(0, 0, 1), 90)
        obj = corner.create(models.add(self.doc, quarter, "Quarter"), "Vertex1", 1.0)
        self.assertEqual((corner.error_text(obj), obj.Met, obj.Patches), ("", True, 6))
        self.assertTrue(obj.Shape.isValid() and obj.Shape.isClosed())

    def test_a_suggested_radius_has_room(self):
        for size, radius in ((10.0, 1.0), (0.37, 0.03), (2500.0, 200.0)):
            obj = corner.create(self.cube(size), "Vertex2")
            self.assertEqual(list(obj.Radii), [radius])
            self.assertTrue(obj.Met, obj.Summary)

    def test_a_placed_solid_is_rounded_where_it_stands(self):
        cube = self.cube()
        plain = corner.create(cube, "Vertex1", 1.0)
        cube.Placement = App.Placement(App.Vector(5, 6, 7), App.Rotation(App.Vector(1, 2, 3), 50))
        volume = plain.Shape.Volume
        centre = plain.Shape.CenterOfMass
        self.doc.recompute()
        self.assertAlmostEqual(plain.Shape.Volume, volume, delta=1e-6)
        self.assertLess((plain.Shape.CenterOfMass - cube.Placement.multVec(centre)).Length, 1e-6)

    def test_the_source_is_left_as_it_was(self):
        cube = self.cube()
        self.doc.recompute()
        before = text_of(cube.Shape)
        corner.create(cube, "Vertex1")
        self.assertEqual(text_of(cube.Shape), before)


class Following(CornerCase):
    def test_each_change_asks_for_a_recompute(self):
        cube = self.cube()
        obj = corner.create(cube, "Vertex1")
        changes = {name: 0.05 for name, *_ in corner.TOLERANCES}
        changes.update(Radii=[2.0], Setbacks=[4.0], Vertex=(cube, ["Vertex2"]), Source=None)
        for name, value in changes.items():
            with self.subTest(name):
                obj.purgeTouched()
                setattr(obj, name, value)
                self.assertIn("Touched", obj.State)

    def test_a_changed_source_is_followed(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = corner.create(box, "Vertex1", 2.0)
        missing = 1000 - obj.Shape.Volume
        box.Length = 30
        self.doc.recompute()
        self.assertTrue(obj.Met)
        self.assertAlmostEqual(obj.Shape.Volume, 3000 - missing - 20 * (4 - math.pi), delta=1e-3)
        box.Length = 2
        self.doc.recompute()
        self.assertNotRounded(obj, "2 mm long")
        box.Length = 10
        self.doc.recompute()
        self.assertEqual((corner.error_text(obj), obj.Met), ("", True))

    def test_cancelling_keeps_the_results_and_progress_rises(self):
        obj, seen = corner.create(self.cube(), "Vertex1"), []
        report = obj.Report
        for answer in (lambda share: False, seen.append):
            with mock.patch.object(
                hooks, "progress", lambda text, answer=answer: contextlib.nullcontext(answer)
            ):
                obj.touch()
                self.doc.recompute()
            if not seen:
                self.assertOutdated(obj)
                self.assertEqual((obj.Report, len(obj.Shape.Faces)), (report, 15))
        self.assertEqual((corner.error_text(obj), seen), ("", sorted(seen)))
        self.assertTrue(len(seen) > 1 and 0 <= seen[0] and seen[-1] <= 1, seen)


class Errors(CornerCase):
    def test_corners_that_cannot_be_rounded_say_why(self):
        cube = self.cube()
        self.assertNotRounded(corner.create(cube, "Vertex1", 11.0), "a fillet of radius 11 mm")
        near = corner.create(cube, "Vertex1", 1.0, setbacks_mm=0.5)
        self.assertNotRounded(near, "a setback of 0.5 mm leaves no room")
        self.assertNotRounded(corner.create(cube, "Vertex1", 0.0), "radius of Edge1 is 0 mm")
        self.assertNotRounded(corner.create(cube, "Vertex99", 1.0), "Cube has no Vertex99")
        self.assertNotRounded(
            corner.create(cube, "Edge1", 1.0), "Edge1 is not a vertex: name one, such as Vertex1"
        )
        block = models.add(self.doc, models.rounded_block(), "Block")
        self.assertNotRounded(corner.create(block, "Vertex1"), "Not rounded: Edge")
        can = models.add(self.doc, Part.makeCylinder(3, 10), "Can")
        self.assertNotRounded(
            corner.create(can, "Vertex1"), "2 edges meet at the vertex: 3 to 6 are needed"
        )
        self.assertEqual(corner.corner_of(corner.prepare(can, "Vertex1"))[:2], ([], []))

    def test_numbers_that_do_not_fit_the_edges(self):
        cube = self.cube()
        text = (
            r"Radii has 2 numbers for the 3 edges of the corner (Edge1, Edge10, Edge2): "
            "give one for each"
        )
        self.assertNotRounded(corner.create(cube, "Vertex1", [1.0, 2.0]), text)
        self.assertNotRounded(
            corner.create(cube, "Vertex1", 1.0, setbacks_mm=[3.0] * 4), "Setbacks has 4 numbers"
        )

    def test_tolerances_that_are_missed_make_nothing(self):
        obj = corner.create(self.cube(), "Vertex1", [1.0, 2.0, 3.0], gap_mm=1e-9, angle_deg=1e-9)
        self.assertWithout(obj, "Not rounded: ")
        self.assertTrue(obj.Shape.isNull() and not obj.Met)
        seams = corner.report_of(obj)["seams"]
        self.assertTrue(seams and all(seam["edges"] == [] for seam in seams))
        self.assertGreater(max(seam["angle_deg"]["upper"] for seam in seams), 1e-9)

    def test_a_deleted_source_and_another_object(self):
        cube, other = self.cube(), self.cube()
        obj = corner.create(cube, "Vertex1")
        obj.Vertex = (other, ["Vertex1"])
        self.doc.recompute()
        self.assertNotRounded(obj, "Vertex names Cube001, which is not the source Cube")
        obj.Vertex = (cube, ["Vertex1", "Vertex2"])
        self.doc.recompute()
        self.assertNotRounded(obj, "Vertex names 2 vertices: name exactly one")
        self.doc.removeObject("Cube")
        obj.touch()
        self.doc.recompute()
        self.assertNotRounded(obj, "The source was deleted")

    def test_bad_arguments_leave_nothing_behind(self):
        cube = self.cube()
        for wrong, text in (
            ({"radii_mm": -1.0}, r"radii_mm\[0\] = -1.0"),
            ({"radii_mm": "x"}, r"radii_mm\[0\] = 'x' is no number"),
            ({"gap_mm": None}, "gap_mm = None is no number"),
            ({"radii_mm": [1.0, math.nan]}, r"radii_mm\[1\] = nan"),
            ({"setbacks_mm": [1.0, 1.0, math.inf]}, r"setbacks_mm\[2\] = inf"),
            ({"section_mm": -1.0}, "section_mm = -1.0"),
            ({"profile": "class-b"}, "profile 'class-b'"),
        ):
            with self.assertRaisesRegex(ValueError, text):
                corner.create(cube, "Vertex1", **wrong)
        with self.assertRaisesRegex(TypeError, "'target'"):
            corner.create(cube, "Vertex1", target="G1")
        for wrong in (None, 1.0, True, ["Vertex1"], ""):
            with self.assertRaisesRegex(
                TypeError, r"vertex = .*: a name is needed, \"Vertex1\", or a number from 1"
            ):
                corner.create(cube, wrong, 1.0)
        for wrong in (None, "Cube"):
            with self.assertRaisesRegex(TypeError, "source = .*: an object of a document"):
                corner.create(wrong, "Vertex1", 1.0)
        self.assertEqual(self.doc.Objects, [cube])


class Saving(CornerCase):
    def test_results_survive_without_the_compiled_module_and_undo_is_one_step(self):
        cube, radii, setbacks = self.cube(), [1.0, 2.0, 3.0], [0.0, 5.0, 0.0]
        self.assertOneStep(
            lambda: corner.create(cube, "Vertex1", radii, setbacks_mm=setbacks, profile="class-a"),
            [cube],
        )
        obj = self.doc.CornerFillet
        names = (
            "Report",
            "Summary",
            "Met",
            "Radii",
            "Setbacks",
            "CornerEdges",
            "Patches",
            "SeamwrightVersion",
        )
        obj.removeProperty("SectionTolerance")
        with self.opened_without_kernel(
            obj, names, lambda: corner.create(self.doc.Cube, "Vertex1")
        ) as again:
            self.assertTrue(corner.is_corner(again))
            self.assertEqual(
                (again.GapTolerance.Value, again.SectionTolerance.Value), (0.001, 1e-6)
            )
            self.assertEqual(len(again.Shape.Faces), 15)
        self.doc.Cube.Shape = Part.makeBox(20, 20, 20)
        self.doc.recompute()
        self.assertEqual((corner.error_text(again), again.Met), ("", True))
        self.assertAlmostEqual(again.Shape.BoundBox.XMax, 20, delta=1e-6)
