# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature and zebra stripes in the panel of Repair Seams, in FreeCAD's window; run by
run_freecad.py --window."""

import sys
import threading
import time
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import numpy
import Part
from PySide import QtCore, QtGui
from repair_window_cases import FEW, MANY, MODEL, RepairWindow, coloured
from window import (
    COMPUTED_S,
    count,
    pause,
    picture,
    press_escape,
    report_view,
    settle,
    whole_window,
)

from freecad.seamwright.document import analysis
from freecad.seamwright.gui.scene import surface_colours
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets import computation
from freecad.seamwright.gui.widgets.tasks import tasks
from freecad.seamwright.plain import curvature

NONE, MOVES, CURVATURE, ZEBRA = "None", "Moves", "Mean curvature", "Zebra stripes"
LEGEND = QtCore.QRect(0, 0, 420, 330)
SHOWN_S = 2 * computation.LOCK_AFTER_MS / 1000
BLUES = [rgb for share, rgb in curvature.RAMP if -0.9 < share < -0.3]


def pixels(image, area=None):
    part = image.copy(area or image.rect()).convertToFormat(QtGui.QImage.Format_RGBA8888)
    return numpy.frombuffer(bytes(part.constBits()), numpy.uint8).reshape(-1, 4)[:, :3].astype(int)


def differing(one, other, area=None):
    """How many pixels of two pictures differ clearly."""
    return int((abs(pixels(one, area) - pixels(other, area)).max(axis=1) > 30).sum())


def bent(image):
    """Pixels in some of the colours of a surface that bulges, which nothing else has."""
    return sum(count(image, rgb, MODEL) for rgb in BLUES)


def dark(image):
    """Pixels of dark stripes."""
    return int((pixels(image, MODEL).max(axis=1) < 40).sum())


def nodes(*objects):
    return [obj.ViewObject.RootNode.getNumChildren() for obj in objects]


class Colours(RepairWindow):
    def colour(self, panel, name):
        panel.colours.setCurrentText(name)
        settle()

    def shown(self, panel, which, name):
        """A picture of before or after."""
        (panel.after if which == "after" else panel.before).setChecked(True)
        settle()
        return picture("colours-%s-%s" % (name, which))


class Curvature(Colours):
    def test_before_and_after_have_one_scale_and_cancel_leaves_nothing(self):
        self.fit()
        plain, bare = picture("colours-plain"), nodes(self.source)
        obj, panel = self.start()
        self.assertEqual(
            [panel.colours.itemText(place) for place in range(4)], [NONE, MOVES, CURVATURE, ZEBRA]
        )
        self.assertEqual(panel.colours.currentText(), MOVES)
        self.assertLess(bent(plain), FEW)
        self.colour(panel, CURVATURE)
        self.assertEqual(self.visible(), ["Panel"])
        self.assertGreater(bent(picture("colours-curvature-waiting")), MANY)
        self.preview(panel)
        after, before = (self.shown(panel, which, "curvature") for which in ("after", "before"))
        whole_window("colours-curvature-window")
        for image in (before, after):
            self.assertGreater(bent(image), MANY)
        self.assertEqual(differing(before, after, LEGEND.adjusted(0, 0, -60, -80)), 0)
        self.assertGreater(differing(before, after), FEW)
        self.assertEqual(set(panel.surface._found.surfaces), {"Panel", obj.Name})
        self.cancel()
        self.assertEqual((self.made(), self.visible(), nodes(self.source)), ([], ["Panel"], bare))
        self.assertEqual(differing(picture("colours-cancelled"), plain), 0)

    def test_ok_leaves_nothing(self):
        bare = nodes(self.source)
        for name in (CURVATURE, ZEBRA):
            obj, panel = self.start()
            self.colour(panel, NONE)
            self.preview(panel)
            self.fit()
            plain, own = picture("colours-none"), nodes(obj)
            self.colour(panel, name)
            self.assertGreater(differing(picture("colours-shown"), plain), MANY)
            self.ok()
            self.assertEqual((self.visible(), obj.ViewObject.ShowMoves), ([obj.Name], False))
            self.assertEqual(
                (nodes(self.source), nodes(obj)), (bare, [own[0] - 1])
            )  # the legend of the panel
            self.assertEqual(differing(picture("colours-kept"), plain), 0)
            self.doc.undo()
            settle()
            self.assertEqual(self.visible(), ["Panel"])

    def test_balls_and_pipes_have_one_colour_and_the_legend_its_radius(self):
        shapes = {
            "pipe": (Part.makeCylinder(25, 80).Faces[0].toNurbs(), -1 / 50),
            "ball": (Part.makeSphere(40), -1 / 40),
        }
        for name, (shape, expected) in shapes.items():
            with self.subTest(name):
                self.source.Shape = shape
                self.doc.recompute()
                self.fit()
                white = count(picture("colours-%s-plain" % name), (255, 255, 255), MODEL)
                _, panel = self.start()
                self.colour(panel, CURVATURE)
                self.fit()
                found = panel.surface._found
                self.assertAlmostEqual(found.limit, -expected, delta=1e-9)
                rgb = curvature.legend_entries(found.limit)[-1][0].rgb
                shown = picture("colours-" + name)
                model = MODEL.width() * MODEL.height() - white
                self.assertGreater(count(shown, rgb, QtCore.QRect(420, 0, 780, 800)), 0.5 * model)
                meanings = [text for *_, text in curvature.legend_entries(found.limit)]
                self.assertEqual(meanings[-1], "as a sphere of radius %g mm" % (-1 / expected))
                surface = found.surfaces["Panel"]
                u, v = shape.Faces[0].Surface.parameter(
                    App.Vector(*surface.mesh.points[len(surface.mesh.points) // 2])
                )
                told = abs(sum(shape.Faces[0].curvatureAt(u, v))) / 2
                self.assertLess(abs(abs(surface.mesh.mean_per_mm) - told).max(), 1e-9)
                self.cancel()

    def test_what_was_computed_is_kept_for_the_report(self):
        _, panel = self.start()
        self.preview(panel)
        self.colour(panel, CURVATURE)
        found = panel.surface._found
        with mock.patch.object(
            surface_colours, "curvature_map_later", side_effect=AssertionError("computed again")
        ):
            for name in (ZEBRA, NONE, CURVATURE, MOVES, ZEBRA, CURVATURE):
                self.colour(panel, name)
                for which in ("before", "after"):
                    self.shown(panel, which, "again")
        self.assertIs(panel.surface._found, found)
        panel.max_move.setValue(0.05)
        self.preview(panel)
        self.assertIsNot(panel.surface._found, found)
        self.assertGreater(bent(picture("colours-other-result")), MANY)
        self.cancel()

    def test_a_source_that_changes_is_drawn_anew(self):
        _, panel = self.start()
        self.colour(panel, CURVATURE)
        found = panel.surface._found
        self.source.Shape = models.broken_panel(noise_mm=0.0)
        settle()
        self.assertIsNot(panel.surface._found, found)
        self.assertGreater(bent(picture("colours-other-source")), MANY)
        self.colour(panel, NONE)
        self.source.Shape = Part.makeSphere(40)
        self.colour(panel, CURVATURE)
        self.assertAlmostEqual(panel.surface._found.limit, 1 / 40, delta=1e-9)
        self.cancel()

    def test_a_placed_model_is_coloured_where_it_stands(self):
        self.source.Placement = App.Placement(
            App.Vector(500, 0, 90), App.Rotation(App.Vector(0, 0, 1), 30)
        )
        self.doc.recompute()
        self.fit()
        obj, panel = self.start()
        self.preview(panel)
        for which in ("before", "after"):
            self.colour(panel, NONE)
            plain = self.shown(panel, which, "placed-plain")
            for name in (CURVATURE, ZEBRA):
                self.colour(panel, name)
                shown = self.shown(panel, which, "placed-" + name.split()[0].lower())
                white = [
                    count(image, (255, 255, 255), QtCore.QRect(0, 340, 1200, 460), 2)
                    for image in (shown, plain)
                ]
                self.assertLess(abs(white[0] - white[1]), 0.01 * white[1])
        self.cancel()

    def test_a_link_is_coloured(self):
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = self.source
        link.Placement.Base.z = 100
        self.doc.recompute()
        self.source.ViewObject.Visibility = False
        self.fit()
        _, panel = self.start((link, ""))
        self.colour(panel, CURVATURE)
        self.assertGreater(bent(picture("colours-link")), MANY)
        self.cancel()
        self.assertLess(bent(picture("colours-link-after")), FEW)

    def test_loose_faces_bulge_to_one_side_before_and_after(self):
        faces = models.broken_panel().Faces
        self.source.Shape = Part.Compound(
            [face.reversed() if place % 2 else face for place, face in enumerate(faces)]
        )
        self.doc.recompute()
        obj, panel = self.start()
        panel.tolerances.fields["MatchDistance"].setValue(0.1)
        self.colour(panel, CURVATURE)
        self.preview(panel)
        found = panel.surface._found.surfaces
        shares = [(found[name].mesh.mean_per_mm < 0).mean() for name in ("Panel", obj.Name)]
        self.assertLess(abs(shares[0] - shares[1]), 0.1)
        self.assertGreater(abs(shares[0] - 0.5), 0.3)
        self.cancel()

    def test_analyses_give_way_and_come_back(self):
        found = analysis.create([self.source])
        settle()
        _, panel = self.start()
        self.colour(panel, CURVATURE)
        self.assertEqual(self.visible(), ["Panel"])
        self.colour(panel, NONE)
        self.assertEqual(self.visible(), ["Panel", found.Name])
        self.preview(panel)
        self.colour(panel, ZEBRA)
        self.shown(panel, "before", "over-analysis")
        self.assertEqual(self.visible(), ["Panel"])
        Gui.activeDocument().resetEdit()
        settle()
        self.assertEqual(self.visible(), ["Panel", found.Name])

    def test_moves_are_of_after_alone(self):
        obj, panel = self.start()
        self.preview(panel)
        for name, shows in (
            (MOVES, True),
            (CURVATURE, False),
            (MOVES, True),
            (ZEBRA, False),
            (NONE, False),
        ):
            self.colour(panel, name)
            panel.after.setChecked(True)
            settle()
            self.assertEqual(obj.ViewObject.ShowMoves, shows)
            self.assertLess(
                bent(self.shown(panel, "before", "moves")), FEW if name in (MOVES, NONE) else 1e9
            )
            self.assertFalse(obj.ViewObject.ShowMoves)
        self.cancel()

    def test_hasty_choices_end_with_the_last_one(self):
        _, panel = self.start()
        self.preview(panel)
        self.colour(panel, NONE)
        for name in (MOVES, CURVATURE, ZEBRA, NONE, CURVATURE, MOVES, ZEBRA, CURVATURE):
            panel.colours.setCurrentText(name)
            panel.before.setChecked(name != ZEBRA)
            pause(0.02)
        settle()
        self.assertGreater(bent(picture("colours-hasty")), MANY)
        panel.colours.setCurrentText(MOVES)
        panel.after.setChecked(True)
        settle()
        self.assertGreater(coloured(picture("colours-hasty-moves")), MANY)
        self.cancel()

    def test_undo_and_closing_with_colours(self):
        obj, panel = self.start()
        self.preview(panel)
        self.ok()
        for name in (CURVATURE, ZEBRA):
            Gui.activeDocument().setEdit(obj.Name)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.colour(panel, name)
            panel.max_move.setValue(0.05)
            self.preview(panel)
            self.cancel()
            self.assertEqual((obj.Repaired, self.visible()), (7, [obj.Name]))
        self.doc.undo()
        settle()
        self.assertEqual(self.visible(), ["Panel"])
        _, panel = self.start()
        self.preview(panel)
        self.colour(panel, CURVATURE)
        panel.before.setChecked(True)
        App.closeDocument(self.doc.Name)
        settle()
        self.assertFalse(Gui.Control.activeDialog())
        self.doc = App.newDocument("Again")

    def test_a_deleted_source(self):
        _, panel = self.start()
        self.preview(panel)
        self.colour(panel, CURVATURE)
        self.doc.removeObject("Panel")
        settle()
        self.assertGreater(bent(picture("colours-no-source")), MANY)
        self.cancel()

    def test_without_the_compiled_part_none_is_chosen(self):
        _, panel = self.start()
        before = report_view()
        with mock.patch.dict(sys.modules, seamwright=None):
            self.colour(panel, CURVATURE)
        written = report_view()[len(before) :]
        self.assertIn("the colours are not shown: The compiled part of Seamwright", written)
        self.assertNotIn("Traceback", written)
        self.assertEqual(panel.colours.currentText(), NONE)
        self.colour(panel, CURVATURE)
        self.assertGreater(bent(picture("colours-found-again")), MANY)
        self.cancel()


class Zebra(Colours):
    def test_stripes_before_and_after(self):
        obj, panel = self.start()
        self.preview(panel)
        self.colour(panel, NONE)
        plain = dark(picture("colours-zebra-none"))
        self.colour(panel, ZEBRA)
        after, before = (self.shown(panel, which, "zebra") for which in ("after", "before"))
        for image in (before, after):
            self.assertGreater(dark(image), plain + MANY)
        self.assertGreater(differing(before, after), MANY)
        self.assertEqual(zebra.objects(self.doc), [])
        self.cancel()
        self.assertLess(dark(picture("colours-zebra-cancelled")), plain + FEW)

    def test_stripes_of_the_command_stay(self):
        Gui.runCommand("Seamwright_ZebraStripes")
        settle()
        striped, bare = picture("colours-striped"), nodes(self.source)
        _, panel = self.start()
        Gui.Selection.clearSelection()
        self.colour(panel, CURVATURE)
        self.assertGreater(bent(picture("colours-over-stripes")), MANY)
        self.colour(panel, NONE)
        self.assertEqual(differing(picture("colours-striped-again"), striped), 0)
        self.colour(panel, CURVATURE)
        self.cancel()
        self.assertEqual(zebra.objects(self.doc), [self.source])
        self.assertEqual(
            (nodes(self.source), differing(picture("colours-striped-last"), striped)), (bare, 0)
        )
        zebra.hide([self.source])


class Stopping(Colours):
    def hold(self):
        """What computes the curvature goes on until it is stopped; set once it has begun."""
        begun = threading.Event()

        def later(_):
            def run(go_on):
                begun.set()
                while go_on(0.5):
                    time.sleep(0.002)

            return run

        return begun, mock.patch.object(surface_colours, "curvature_map_later", later)

    def wait(self, begun):
        end = time.monotonic() + COMPUTED_S
        while not begun.is_set() and time.monotonic() < end:
            pause(0.02)
        pause(SHOWN_S)

    def test_escape_stops_it_and_the_panel_stays_free_meanwhile(self):
        obj, panel = self.start()
        self.preview(panel)
        begun, held = self.hold()
        with held:
            panel.colours.setCurrentText(CURVATURE)
            self.wait(begun)
            whole_window("colours-computing")
            self.assertTrue(panel.computation.line.isVisible())
            self.assertTrue(panel.table.isEnabled() and panel.preview_button.isEnabled())
            panel.before.setChecked(True)
            pause()
            self.assertEqual(self.visible(), ["Panel"])
            press_escape()
            pause()
            self.assertTrue(tasks.idle)
        self.assertEqual(
            (panel.colours.currentText(), panel.computation.line.isVisible()), (NONE, False)
        )
        self.assertLess(bent(picture("colours-stopped")), FEW)
        self.colour(panel, CURVATURE)
        self.assertGreater(bent(picture("colours-after-stop")), MANY)
        self.ok()

    def test_other_colours_and_ok_end_it(self):
        _, panel = self.start()
        self.preview(panel)
        for end in (lambda: panel.colours.setCurrentText(NONE), self.ok):
            begun, held = self.hold()
            with held:
                panel.colours.setCurrentText(CURVATURE)
                self.wait(begun)
                end()
                pause()
                self.assertTrue(tasks.idle)
            self.assertFalse(panel.computation.runs)

    def test_a_preview_goes_before_and_the_colours_come_after(self):
        obj, panel = self.start()
        begun, held = self.hold()
        with held:
            panel.colours.setCurrentText(CURVATURE)
            self.wait(begun)
        self.preview(panel)
        self.assertEqual(
            (obj.Repaired, self.visible(), panel.colours.currentText()), (7, [obj.Name], CURVATURE)
        )
        self.assertGreater(bent(picture("colours-after-preview")), MANY)
        self.cancel()
