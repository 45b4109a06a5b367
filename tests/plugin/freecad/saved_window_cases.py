# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that version 0.1.0 saved, in FreeCAD's window; run by run_freecad.py --window."""

import pathlib
import re
import shutil
import tempfile
import zipfile

import FreeCAD as App
import FreeCADGui as Gui
from make_workbench_0_1_0 import MODULES, NAME
from window import WindowCase, settle

from freecad.seamwright.document import feature, fill
from freecad.seamwright.plain import palette

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"

#: For each kind of object, properties of the saved results that a recompute must find again.
RESULTS = {
    "SeamAnalysis": {"Seams": 18, "Defects": 1, "Creases": 15, "Uncertain": 0, "Passed": False},
    "SeamRepair": {"Wanted": 1, "Repaired": 1, "MovedFaces": 2, "DefectsAfter": 0},
    "MatchSurfaces": {"Matched": True, "Certain": True, "Exact": True, "LevelAfter": "G2"},
    "UmbrellaFill": {"Wanted": 1, "Filled": 1, "Reached": True, "NewFaces": 3},
    "CornerFillet": {"Met": True, "Patches": 6},
}

SOURCES = {
    "SeamAnalysis": ["Prism"],
    "SeamRepair": ["Panel"],
    "MatchSurfaces": ["Left", "Right"],
    "UmbrellaFill": ["Shell"],
    "CornerFillet": ["Cube"],
}


class Saved(WindowCase):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = str(shutil.copy(DATA / NAME, folder.name))
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        settle()
        self.objects = {kind: self.doc.getObject(kind) for kind in RESULTS}

    def found(self):
        return {
            kind: {name: getattr(obj, name) for name in RESULTS[kind]}
            for kind, obj in self.objects.items()
        }

    def test_the_file_names_the_modules_of_0_1_0(self):
        with zipfile.ZipFile(DATA / NAME) as file:
            text = "".join(file.read(name).decode() for name in ("Document.xml", "GuiDocument.xml"))
        found = re.findall(r'<Python [^>]*module="([^"]+)" class="([^"]+)"', text)
        self.assertEqual({name: module for module, name in found}, MODULES)

    def test_objects_and_views_have_their_classes_and_results(self):
        for kind, obj in self.objects.items():
            with self.subTest(kind):
                self.assertIsInstance(obj.Proxy, feature.Feature)
                self.assertEqual(obj.Proxy.Type, kind)
                view = obj.ViewObject.Proxy
                self.assertEqual(type(view).__name__, kind + "View")
                self.assertEqual(view.object, obj)
                self.assertIn(view.halo.node, _children(obj.ViewObject.RootNode))
                if App.Version()[0] == "0":  # later ones bring links of older files up to date
                    self.assertNotIn("Touched", obj.State)
                self.assertTrue(obj.Shape.Edges)
        self.assertEqual(self.found(), RESULTS)

    def test_views_look_and_behave_as_when_they_were_saved(self):
        shown = sorted(SOURCES["SeamAnalysis"] + list(RESULTS))
        self.assertEqual(sorted(self.visible()), shown)
        colours = {tuple(c[:3]) for c in self.objects["SeamAnalysis"].ViewObject.LineColorArray}
        self.assertEqual(len(colours), len(palette.CLASSES))
        for kind in ("SeamRepair", "MatchSurfaces", "UmbrellaFill", "CornerFillet"):
            with self.subTest(kind):
                children = self.objects[kind].ViewObject.Proxy.claimChildren()
                self.assertEqual([child.Name for child in children], SOURCES[kind])

    def test_a_choice_has_the_values_of_this_version(self):
        obj = self.objects["UmbrellaFill"]
        self.assertEqual(obj.Target, "G1")
        self.assertEqual(obj.getEnumerationsOfProperty("Target"), fill.TARGETS)
        obj.Target = "G2"
        self.doc.recompute()
        self.assertEqual((obj.Target, obj.Proxy.has_result(feature.report_of(obj))), ("G2", False))
        self.assertIn("G2", obj.Summary)

    def test_a_recompute_finds_the_results_again(self):
        for obj in self.objects.values():
            obj.touch()
        self.doc.recompute()
        settle()
        for kind, obj in self.objects.items():
            with self.subTest(kind):
                self.assertNotIn("Invalid", obj.State)
                self.assertEqual(obj.Outcome, "done")
        self.assertEqual(self.found(), RESULTS)

    def test_each_panel_opens_and_cancels(self):
        for kind, obj in self.objects.items():
            with self.subTest(kind):
                self.assertTrue(Gui.getDocument(self.doc.Name).setEdit(obj.Name))
                settle()
                panel = obj.ViewObject.Proxy.panel
                self.assertEqual(panel.summary.text(), obj.Summary)
                panel.reject()
                settle()
                self.assertIsNone(obj.ViewObject.Proxy.panel)
        self.assertEqual(self.found(), RESULTS)


def _children(node):
    return [node.getChild(place) for place in range(node.getNumChildren())]
