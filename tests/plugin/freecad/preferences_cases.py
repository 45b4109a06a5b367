# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences as FreeCAD stores them, and new objects that use them; run by run_freecad.py."""

import math
from unittest import mock

import FreeCAD as App
import models
import Part
from document_cases import DocumentCase

from freecad.seamwright.document import (
    analysis,
    corner,
    feature,
    fill,
    preferences,
    properties,
    repair,
)
from freecad.seamwright.document.maps import kinds as maps
from freecad.seamwright.plain import kernel, palette, profiles
from freecad.seamwright.plain import preferences as table


def group():
    return App.ParamGet("User parameter:BaseApp/Preferences/Mod/Seamwright")


class PreferenceCase(DocumentCase):
    def setUp(self):
        super().setUp()
        preferences.reset()
        self.addCleanup(preferences.reset)
        self.addCleanup(palette.use, {})

    def store(self, **changed):
        preferences.store({**table.defaults(), **changed})


class Stored(PreferenceCase):
    def test_nothing_is_stored_at_first(self):
        self.assertEqual(preferences.values(), table.defaults())
        self.assertFalse(group().GetContents())

    def test_what_is_stored_is_read(self):
        wanted = {
            "GapTolerance": 0.5, "AngleTolerance": 0.25, "CurvatureTolerance": 0.125,
            "FlatRadius": 2048.0, "CreaseAngle": 7.0, "Threads": 3, "CombLines": 11,
            "ZebraStripes": 8,
            "LivePreview": False, "ColourDefect": 0x11223300, "ColourG3": 0xffeedd00
        }  # fmt: skip
        self.store(**wanted)
        self.assertEqual(preferences.values(), {**table.defaults(), **wanted})
        self.assertEqual(group().GetFloat("GapTolerance"), 0.5)
        self.assertEqual(preferences.threads(), 3)
        preferences.use_colours()
        self.assertEqual(palette.DEFECT.rgb, (0x11, 0x22, 0x33))
        self.assertEqual(palette.SMOOTH.rgb, palette.SMOOTH.standard_rgb)

    def test_a_bad_value_is_refused_and_nothing_is_stored(self):
        self.store(GapTolerance=0.5)
        for name, value in (
            ("GapTolerance", 0.0), ("GapTolerance", math.nan), ("GapTolerance", -1.0),
            ("AngleTolerance", 91.0), ("CurvatureTolerance", math.inf), ("Threads", -1),
            ("Threads", 1.5), ("CombLines", 1), ("CreaseAngle", 0.1), ("AngleTolerance", 5.0),
            ("Threads", math.inf), ("Threads", "x"), ("GapTolerance", None), ("LivePreview", 2.0),
        ):  # fmt: skip
            with self.subTest(name=name, value=value), self.assertRaises(ValueError) as raised:
                self.store(**{name: value})
            self.assertTrue(str(raised.exception))
            self.assertEqual(preferences.values()["GapTolerance"], 0.5)

    def test_all_preferences_are_given_and_no_others(self):
        with self.assertRaisesRegex(TypeError, "unknown preference .Gap.: choose from"):
            self.store(Gap=0.5)
        with self.assertRaisesRegex(TypeError, "missing preference 'CombLines'"):
            preferences.store({
                name: value for name, value in table.defaults().items() if name != "CombLines"
            })
        self.assertFalse(group().GetContents())

    def test_bad_values_of_the_file_are_ignored(self):
        group().SetFloat("GapTolerance", -3.0)
        group().SetInt("Threads", -2)
        group().SetFloat("FlatRadius", 500.0)
        found = preferences.values()
        self.assertEqual(found, {**table.defaults(), "FlatRadius": 500.0})

    def test_tolerances_that_contradict_each_other_are_ignored(self):
        group().SetFloat("AngleTolerance", 9.0)
        group().SetFloat("GapTolerance", 0.5)
        group().SetInt("Threads", 2)
        self.assertEqual(preferences.values(), {**table.defaults(), "Threads": 2})

    def test_reset(self):
        self.store(Threads=2, LivePreview=False)
        preferences.reset()
        self.assertEqual(preferences.values(), table.defaults())

    def test_defaults_are_those_of_the_properties(self):
        self.assertEqual(
            [(each.name, each.argument, each.default) for each in table.TOLERANCES],
            [(name, argument, default) for name, argument, _, default, _ in properties.TOLERANCES],
        )


class Used(PreferenceCase):
    def prepared(self):
        box = models.add(self.doc, models.broken_panel(), "Panel")
        self.doc.recompute()
        return box

    def test_new_objects_have_the_tolerances(self):
        source = self.prepared()
        before = analysis.prepare([source], self.doc)
        self.store(GapTolerance=0.5, CreaseAngle=7.0)
        made = [
            analysis.prepare([source], self.doc),
            repair.prepare(source),
            feature.add(self.doc, corner.CornerFillet, "Corner"),
        ]
        for obj in made:
            self.assertEqual(properties.number(obj, "GapTolerance"), 0.5)
            self.assertEqual(properties.number(obj, "AngleTolerance"), 0.1)
        self.assertEqual(properties.number(made[0], "CreaseAngle"), 7.0)
        self.assertEqual(properties.number(before, "GapTolerance"), 0.01)
        filled = feature.add(self.doc, fill.UmbrellaFill, "Fill")
        self.assertEqual(properties.number(filled, "GapTolerance"), 0.001)

    def test_what_is_given_counts_more(self):
        source = self.prepared()
        self.store(GapTolerance=0.5, CreaseAngle=7.0)
        obj = analysis.prepare([source], self.doc, gap_mm=0.25)
        self.assertEqual(properties.number(obj, "GapTolerance"), 0.25)
        self.assertEqual(properties.number(obj, "CreaseAngle"), 7.0)
        named = analysis.prepare([source], self.doc, profile="vda")
        self.assertEqual(
            properties.number(named, "GapTolerance"), profiles.PROFILES["vda"]["gap_mm"]
        )

    def test_combs_and_zebra_stripes_have_so_many_lines(self):
        source = self.prepared()
        self.store(CombLines=13, ZebraStripes=9)
        obj = maps.create("CurvatureComb", [(source, "Edge1")])
        self.assertEqual(obj.Density, 13)
        self.assertEqual(maps.create("ReflectionLines", source).Stripes, 9)
        self.assertEqual(preferences.zebra_stripes(), 9)

    def test_a_computation_has_so_many_threads(self):
        source = self.prepared()
        self.store(Threads=1)
        model, seen = kernel.load(Part.OCC_VERSION).Model, ValueError("seen")
        with mock.patch.object(model, "analyze", autospec=True, side_effect=seen) as run:
            analysis.create([source], self.doc)
        self.assertEqual(run.call_args.kwargs["jobs"], 1)
        self.assertEqual(analysis.create([source], self.doc).Outcome, "done")
