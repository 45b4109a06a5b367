# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an analysis takes in FreeCAD's window: loose faces with a match distance, the selection."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from window import OUT, WindowCase, analyses, click, messages, settle, whole_window

from freecad.seamwright.document import analysis

GAP_MM = 0.004


class LooseFaces(WindowCase):
    """Faces that share no edge are matched within a distance that the panel proposes."""

    def faces(self):
        left = Part.makePlane(20, 20)
        right = Part.makePlane(20, 20, App.Vector(20 + GAP_MM, 0, 0))
        return [left, right]

    def check(self, obj, panel):
        self.assertEqual((obj.Seams, obj.Matched), (1, 1))
        self.assertGreater(obj.MatchDistance.Value, GAP_MM)
        self.assertLess(obj.MatchDistance.Value, 0.1)
        self.assertIn("as proposed", panel.summary.text())
        self.assertEqual(panel.tolerances.fields["MatchDistance"].value(), obj.MatchDistance.Value)

    def test_faces_of_one_compound(self):
        models.add(self.doc, Part.Compound(self.faces()), "Loose")
        self.doc.UndoMode = 1
        self.doc.recompute()
        self.fit()
        obj, panel = self.analyse()
        self.check(obj, panel)
        whole_window("window-loose")
        panel.reject()
        settle()
        self.doc.undo()
        settle()
        self.assertEqual(analyses(self.doc), [])

    def test_faces_of_separate_objects(self):
        for place, face in enumerate(self.faces()):
            models.add(self.doc, face, "Face%d" % place)
        self.doc.recompute()
        obj, panel = self.analyse()
        self.check(obj, panel)
        self.assertEqual(len(obj.Analysed), 2)

    def test_a_distance_of_zero_is_left_alone_later_but_proposed(self):
        models.add(self.doc, Part.Compound(self.faces()), "Loose")
        self.doc.recompute()
        obj = analysis.create()
        self.assertIn("match them within", obj.Summary)
        Gui.getDocument(self.doc.Name).setEdit(obj.Name)
        settle()
        panel = obj.ViewObject.Proxy.panel
        self.assertEqual(obj.MatchDistance.Value, 0)
        self.assertTrue(panel.match_button.isVisible())
        click(panel.match_button, panel.match_button.rect().center())
        self.check(obj, panel)
        self.assertFalse(panel.match_button.isVisible())

    def test_faces_far_apart_have_no_proposal(self):
        models.add(
            self.doc,
            Part.Compound([Part.makePlane(5, 5), Part.makePlane(5, 5, App.Vector(30, 0, 0))]),
            "Apart",
        )
        self.doc.recompute()
        obj, panel = self.analyse()
        self.assertEqual((obj.Seams, obj.MatchDistance.Value), (0, 0))
        self.assertIn("none lie side by side", panel.summary.text())
        self.assertFalse(panel.match_button.isVisible())


class Selection(WindowCase):
    """What each command says to a selection that does not suit it."""

    COMMANDS = (
        "Seamwright_AnalyzeSeams", "Seamwright_MatchSurfaces", "Seamwright_RepairSeams",
        "Seamwright_UmbrellaFill", "Seamwright_CornerFillet", "Seamwright_ZebraStripes",
    )  # fmt: skip
    OF_CURVES = ("Seamwright_Spline", "Seamwright_BlendSurface")

    def refuse(self, obj, expected, names):
        self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        before = len(self.doc.Objects)
        for name in names:
            with self.subTest(name):
                Gui.Selection.clearSelection()
                Gui.Selection.addSelection(obj)
                Gui.runCommand(name)
                settle()
                texts = messages()
                self.assertEqual(len(texts), 1)
                self.assertIn(expected, texts[0])
                self.assertEqual(len(self.doc.Objects), before)

    def test_a_mesh(self):
        import Mesh

        obj = self.doc.addObject("Mesh::Feature", "Scan")
        obj.Mesh = Mesh.createBox(1, 1, 1)
        self.refuse(obj, "Scan is a mesh", self.COMMANDS + self.OF_CURVES)

    def test_a_sketch(self):
        obj = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        obj.addGeometry(Part.LineSegment(App.Vector(), App.Vector(1, 0, 0)))
        self.refuse(obj, "Sketch is a sketch and has no faces", self.COMMANDS)

    def test_another_kind_of_object(self):
        obj = self.doc.addObject("App::TextDocument", "Text")
        self.refuse(obj, "Text has no shape", self.COMMANDS + self.OF_CURVES)

    def test_an_analysis_counts_as_what_it_analysed(self):
        models.add(self.doc, models.three_classes(), "Prism")
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        obj = analysis.create([box])
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        again, panel = self.analyse()
        self.assertNotEqual(again, obj)
        self.assertEqual(again.Sources, [box])
        panel.reject()


os.makedirs(OUT, exist_ok=True)
