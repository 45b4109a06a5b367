# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects have in common, on FreeCAD's console; run by run_freecad.py."""

import os
import re
import tempfile
import zipfile
from unittest import mock

import FreeCAD as App
from document_cases import ABSENT, DocumentCase

from freecad.seamwright.document import analysis, corner, feature, fill, match, repair
from freecad.seamwright.document.curves import curve, kinds
from freecad.seamwright.document.curves.kinds import KINDS
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.document.surfaces.kinds import KINDS as SURFACES

FEATURES = (
    analysis.SeamAnalysis,
    corner.CornerFillet,
    fill.UmbrellaFill,
    match.MatchSurfaces,
    repair.SeamRepair,
    *KINDS.values(),
    *SURFACES.values(),
)

#: Written into documents; it must never change.
PATHS = {
    "SeamAnalysis": "freecad.seamwright.document.analysis",
    "Arcs": "freecad.seamwright.document.curves.arcs",
    "BlendCurves": "freecad.seamwright.document.curves.blend",
    "BlendSurface": "freecad.seamwright.document.surfaces.blend",
    "BridgeCurve": "freecad.seamwright.document.curves.bridge",
    "Clothoid": "freecad.seamwright.document.curves.clothoid",
    "Conic": "freecad.seamwright.document.curves.conic",
    "CornerFillet": "freecad.seamwright.document.corner",
    "ExtendSurface": "freecad.seamwright.document.surfaces.extend",
    "FairCurve": "freecad.seamwright.document.curves.fair",
    "FrameLoft": "freecad.seamwright.document.surfaces.loft",
    "LogSpiral": "freecad.seamwright.document.curves.log_spiral",
    "Spline": "freecad.seamwright.document.curves.spline",
    "Umbrella": "freecad.seamwright.document.surfaces.umbrella",
    "UmbrellaFill": "freecad.seamwright.document.fill",
    "JoinCurves": "freecad.seamwright.document.curves.join",
    "MatchSurfaces": "freecad.seamwright.document.match",
    "SeamRepair": "freecad.seamwright.document.repair",
}


class Computing(DocumentCase):
    def test_an_unexpected_error_leaves_no_earlier_result(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        made = kinds.create("BridgeCurve", [(box, "Edge1"), (box, "Edge7")])
        self.assertEqual((made.Outcome, made.Shape.isNull()), (feature.DONE, False))
        with mock.patch.object(type(made.Proxy), "compute", side_effect=KeyError("lost")):
            made.touch()
            self.doc.recompute()
        self.assertEqual((made.Outcome, made.Shape.isNull()), (feature.WITHOUT, True))
        self.assertIn("nexpected error: KeyError('lost')", made.Summary)
        self.assertIn("Invalid", made.State)


class Proxies(DocumentCase):
    def test_saved_documents_find_their_classes(self):
        for each in FEATURES:
            feature.add(self.doc, each, "Some " + each.Type)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            with zipfile.ZipFile(path) as file:
                text = file.read("Document.xml").decode()
            found = re.findall(r'<Python [^>]*module="([^"]+)" class="([^"]+)"', text)
            self.assertEqual({name: module for module, name in found}, PATHS)
            App.closeDocument(self.doc.Name)
            with ABSENT:
                self.doc = App.openDocument(path)
        self.assertEqual({type(obj.Proxy) for obj in self.doc.Objects}, set(FEATURES))
        for obj in self.doc.Objects:
            self.assertEqual((obj.Proxy.Type, obj.Label), (obj.Name, "Some " + obj.Name))

    def test_each_object_is_known_for_what_it_is(self):
        objects = [feature.add(self.doc, each, each.Type) for each in FEATURES]
        objects.append(self.doc.addObject("Part::Box", "Box"))
        tests = (
            analysis.is_analysis,
            corner.is_corner,
            fill.is_fill,
            match.is_match,
            repair.is_repair,
        )
        for place, obj in enumerate(objects):
            self.assertEqual([test(obj) for test in tests], [place == k for k in range(len(tests))])
            self.assertEqual(curve.is_curve(obj), obj.Name in KINDS)
            self.assertEqual(surface.is_surface(obj), obj.Name in SURFACES)

    def test_an_object_that_lacks_all_properties_gets_them(self):
        for each in FEATURES:
            with self.subTest(each.Type):
                obj = feature.add(self.doc, each, each.Type)
                before = sorted(obj.PropertiesList)
                for name, *_ in feature.INTERNAL:
                    obj.removeProperty(name)
                obj.removeProperty("Summary")
                each.add_properties(obj)
                self.assertEqual(sorted(obj.PropertiesList), before)
