# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is analysed, and which object a number belongs to; run by run_freecad.py."""

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase

from freecad.seamwright.document import analysis, repair, sources
from freecad.seamwright.document.maps import kinds as maps


class Errors(DocumentCase):
    def test_an_empty_document(self):
        self.assertFailed(analysis.create(doc=self.doc), "nothing to analyse")

    def test_a_source_without_shape(self):
        empty = self.doc.addObject("Part::Feature", "Empty")
        self.assertFailed(analysis.create([empty]), "Empty has no shape")

    def test_a_source_without_faces(self):
        line = models.add(self.doc, Part.makeLine((0, 0, 0), (1, 0, 0)), "Line")
        self.assertFailed(analysis.create([line]), "Line has no faces")

    def test_an_error_clears_the_results_and_passes_away(self):
        prism = self.prism()
        obj = analysis.create([prism])
        prism.Shape = Part.Shape()
        self.doc.recompute()
        self.assertFailed(obj, "Prism has no shape")
        self.assertEqual((obj.Seams, obj.Report and analysis.report_of(obj)["seams"]), (0, []))
        prism.Shape = models.three_classes()
        self.doc.recompute()
        self.assertEqual((obj.Seams, analysis.error_text(obj)), (18, ""))

    def test_a_single_face_has_no_seams_and_does_not_pass(self):
        face = models.add(self.doc, Part.makePlane(1, 1), "Face")
        obj = analysis.create([face])
        self.assertEqual(analysis.error_text(obj), "")
        self.assertEqual((obj.Seams, obj.OpenEdges, obj.Passed), (0, 4, False))


class Choosing(DocumentCase):
    def names(self, obj):
        return [each.Name for each in obj.Analysed]

    def test_nothing_chosen_means_all_solids_and_shells(self):
        self.doc.addObject("Part::Box", "Box")
        models.add(self.doc, Part.makeShell(Part.makeBox(1, 1, 1).Faces[2:5]), "Shell")
        models.add(self.doc, Part.makeLine((0, 0, 0), (1, 0, 0)), "Line")
        self.doc.recompute()
        self.assertEqual(self.names(analysis.create()), ["Box", "Shell"])

    def test_what_went_into_another_object_is_left_out(self):
        box = self.doc.addObject("Part::Box", "Box")
        ball = self.doc.addObject("Part::Sphere", "Ball")
        cut = self.doc.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, ball
        self.doc.recompute()
        self.assertEqual(self.names(analysis.create()), ["Cut"])

    def test_a_body_counts_once(self):
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.addObject(self.doc.addObject("PartDesign::AdditiveBox", "Block"))
        self.doc.recompute()
        self.assertEqual(self.names(analysis.create()), ["Body"])

    def test_a_new_object_is_found_by_the_next_recompute(self):
        self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = analysis.create()
        self.doc.addObject("Part::Box", "Other")
        self.doc.recompute()
        obj.touch()
        self.doc.recompute()
        self.assertEqual(self.names(obj), ["Box", "Other"])

    def test_a_changed_object_is_followed_though_none_was_chosen(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = analysis.create()
        box.Height = 42
        self.doc.recompute()
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, 42, delta=1e-6)

    def test_two_analyses_do_not_analyse_each_other(self):
        self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        first, second = analysis.create(), analysis.create()
        self.assertEqual(self.names(first), self.names(second))


class Mapping(DocumentCase):
    def owners(self, obj, kind):
        return analysis.report_of(obj)["freecad"][kind]

    def test_numbers_go_back_to_their_objects(self):
        box = self.doc.addObject("Part::Box", "Box")
        ball = self.doc.addObject("Part::Cylinder", "Tube")
        self.doc.recompute()
        obj = analysis.create([box, ball])
        faces = self.owners(obj, "faces")
        self.assertEqual(faces["6"], ["Box", "Face6"])
        self.assertEqual(faces["7"], ["Tube", "Face1"])
        self.assertEqual(self.owners(obj, "edges")["13"], ["Tube", "Edge1"])

    def test_what_two_objects_share_stays_shared(self):
        second = Part.makeBox(1, 1, 1, App.Vector(1, 0, 0))
        pieces, _ = Part.makeBox(1, 1, 1).generalFuse([second])
        left = models.add(self.doc, pieces.Solids[0], "Left")
        right = models.add(self.doc, pieces.Solids[1], "Right")
        self.doc.recompute()
        obj = analysis.create([left, right])
        report = analysis.report_of(obj)
        self.assertEqual((report["model"]["faces"], report["model"]["edges"]), (11, 20))
        self.assertEqual(len(report["non_manifold"]), 4)
        owners = self.owners(obj, "faces")
        self.assertEqual({name for name, _ in owners.values()}, {"Left", "Right"})
        for number, (name, element) in owners.items():
            source = self.doc.getObject(name).Shape.getElement(element)
            found = sources.Model([left, right]).shape.Faces[int(number) - 1]
            self.assertTrue(found.isPartner(source))

    def test_parts_are_analysed_where_they_stand(self):
        part = self.doc.addObject("App::Part", "Part")
        part.Placement.Base = App.Vector(100, 0, 0)
        box = self.doc.addObject("Part::Box", "Box")
        box.Placement.Base = App.Vector(0, 50, 0)
        part.addObject(box)
        other = self.doc.addObject("Part::Box", "Other")
        self.doc.recompute()
        obj = analysis.create([part, other])
        self.assertEqual([each.Name for each in obj.Analysed], ["Box", "Other"])
        bounds = obj.Shape.BoundBox
        self.assertAlmostEqual(bounds.XMax, 110, delta=1e-6)
        self.assertAlmostEqual(bounds.YMax, 60, delta=1e-6)
        self.assertEqual(self.owners(obj, "edges")["12"], ["Box", "Edge12"])

    def test_results_follow_a_part_that_is_moved(self):
        outer, part = (self.doc.addObject("App::Part", name) for name in ("Outer", "Part"))
        outer.addObject(part)
        block = models.add(self.doc, models.broken_block(), "Block")
        part.addObject(block)
        self.doc.recompute()
        made = [
            analysis.create([block]),
            repair.create(block),
            maps.create("DraftAngle", block),
        ]
        before = [(obj.Report, obj.Shape.BoundBox.XMin) for obj in made]
        self.doc.recompute()
        self.assertEqual([obj.Proxy.mustExecute(obj) for obj in made], [False] * 3)
        outer.Placement = App.Placement(App.Vector(300, 0, 0), App.Rotation())
        self.doc.recompute()
        for obj, (_, left) in zip(made[:2], before):
            self.assertAlmostEqual(obj.Shape.BoundBox.XMin, left + 300, delta=1e-6)
        part.Placement.Rotation = App.Rotation(App.Vector(1, 0, 0), 40)
        self.doc.recompute()
        self.assertNotEqual(made[2].Report, before[2][0])
        self.assertEqual([obj.Proxy.mustExecute(obj) for obj in made], [False] * 3)

    def test_the_same_shape_in_two_places(self):
        box = self.doc.addObject("Part::Box", "Box")
        twin = self.doc.addObject("App::Link", "Twin")
        twin.LinkedObject = box
        twin.Placement = App.Placement(App.Vector(30, 0, 0), App.Rotation())
        self.doc.recompute()
        obj = analysis.create()
        self.assertEqual([each.Name for each in obj.Analysed], ["Box", "Twin"])
        self.assertEqual(obj.Seams, 24)
        self.assertEqual(self.owners(obj, "edges")["13"], ["Twin", "Edge1"])

    def test_elements_of_links_have_paths_and_paths_have_elements(self):
        part, inner = (self.doc.addObject("App::Part", name) for name in ("Part", "Inner"))
        part.addObject(self.doc.addObject("Part::Box", "Box"))
        inner.addObject(self.doc.addObject("Part::Cylinder", "Cylinder"))
        inner.Placement = App.Placement(App.Vector(0, 0, 30), App.Rotation(App.Vector(1, 0, 0), 20))
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.newObject("PartDesign::AdditiveBox", "First")
        second = body.newObject("PartDesign::AdditiveBox", "Second")
        second.Placement.Base.z = 5
        body.Placement.Base.x = 40
        twin = self.doc.addObject("App::Link", "Twin")
        twin.LinkedObject = inner
        twin.Placement.Base.y = 60
        for each in (inner, body, twin):
            part.addObject(each)
        whole, single, array = (self.doc.addObject("App::Link", "Link%d" % n) for n in range(3))
        whole.LinkedObject, single.LinkedObject, array.LinkedObject = part, body, part.Group[0]
        array.ElementCount = 3
        whole.Placement.Base.x = 200
        self.doc.recompute()
        for link in (whole, single, array):
            shape = Part.getShape(link)
            for kind, count in (("Edge", len(shape.Edges)), ("Face", len(shape.Faces))):
                names = ["%s%d" % (kind, number) for number in range(1, count + 1)]
                paths = sources.paths_in_link(link, names)
                self.assertEqual(len(set(paths)), count)
                found = [sources.element_of_link(link, path) for path in paths]
                self.assertEqual(found, names, link.Name)
        self.assertTrue(any(path.startswith("Twin.Cylinder.Face") for path in sources.paths_in_link(
            whole, ["Face%d" % number for number in range(1, len(Part.getShape(whole).Faces) + 1)]
        )))
