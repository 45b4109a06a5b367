# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis tools in FreeCAD's window; run by run_freecad.py --window."""

import os
import sys
import tempfile
import time
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from PySide import QtCore
from window import (
    PanelWindow,
    click,
    count,
    held,
    messages,
    pause,
    picture,
    report_view,
    settle,
    whole_window,
)

from freecad.seamwright.document import analysis, repair
from freecad.seamwright.document.feature import report_of
from freecad.seamwright.document.maps import kinds, tool
from freecad.seamwright.gui import selected
from freecad.seamwright.gui.maps.panel import DRAW_AFTER_MS
from freecad.seamwright.gui.scene import shaders
from freecad.seamwright.gui.scene.comb import COLOURS
from freecad.seamwright.gui.scene.legend import BORDER
from freecad.seamwright.gui.scene.marker import INK
from freecad.seamwright.gui.scene.substitutes import NAME
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import ramps

LEGEND = QtCore.QRect(0, 0, 420, 140)
FEW, MANY = 20, 300

#: The longest that the window may work on a switch of a map of 1,000 faces: processor time of its
#: thread, which other programs do not lengthen; what the graphics card draws does not count.
SWITCH_S = 0.2

SURFACE_MAPS = "CurvatureMap", "ReflectionLines", "DraftAngle", "Deviation"


class MapWindow(PanelWindow):
    is_made = staticmethod(tool.is_tool)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.sheets = [
            models.add(self.doc, shape, name)
            for shape, name in zip(models.two_sheets(), ("Left", "Right"))
        ]
        self.block = models.add(self.doc, models.rounded_block(), "Block")
        self.block.Placement.Base.x = 40
        self.doc.recompute()
        self.doc.clearUndos()

    def start(self, kind, *chosen):
        self.COMMAND = "Seamwright_" + kind
        found = self.run_selected(chosen)
        settle(0.3)
        if found[0] is not None:
            self.fit()
        return found

    def chosen(self, kind):
        return {
            "SeamPlot": [(self.block, "Edge3")],
            "Deviation": [(self.sheets[0], ""), (self.sheets[1], "")],
            "CurvatureComb": [(self.sheets[0], "Face1"), (self.block, "Edge3")],
        }.get(kind, [(self.block, "")])

    def select(self, *chosen):
        Gui.Selection.clearSelection()
        for obj, name in chosen:
            Gui.Selection.addSelection(self.doc.Name, obj.Name, name)

    def set_field(self, panel, argument, value):
        panel.options.fields[argument].show_value(value)
        settle(0.4 + DRAW_AFTER_MS / 1000)

    def drawn(self, obj):
        """Whether something is drawn in place of an object."""
        root = obj.ViewObject.RootNode
        return any(
            root.getChild(k).getName().getString() == NAME for k in range(root.getNumChildren())
        )

    def legend(self, name):
        """Pixels of the white of a legend in its corner, on the dark background of the picture."""
        return count(picture(name), ramps.TOWARDS, LEGEND)


class Panel(MapWindow):
    def test_each_kind_is_made_accepted_undone_and_done_again(self):
        for kind in kinds.KINDS:
            with self.subTest(kind):
                steps, before = self.doc.UndoCount, self.doc.Objects
                obj, panel = self.start(kind, *self.chosen(kind))
                self.assertEqual(panel.summary.text(), obj.Summary)
                self.assertEqual(obj.Outcome, "done", obj.Summary)
                whole_window("map-" + kind)
                sources = obj.Proxy.source_objects(obj)[:1] if kind in SURFACE_MAPS else []
                self.assertTrue(all(map(self.drawn, sources)))
                self.ok()
                settle(0.3)
                self.assertTrue(all(map(self.drawn, sources)), "it stays without the panel")
                self.assertEqual(self.doc.UndoCount, steps + 1)
                self.doc.undo()
                settle(0.3)
                self.assertEqual(self.doc.Objects, before)
                self.assertFalse(any(map(self.drawn, sources)))
                self.doc.redo()
                settle(0.5)
                (again,) = [each for each in self.doc.Objects if each not in before]
                self.assertTrue(all(map(self.drawn, sources)))
                self.doc.removeObject(again.Name)
                settle(0.3)
                self.assertFalse(any(map(self.drawn, sources)))

    def test_cancel_removes_a_new_tool_and_restores_a_changed_one(self):
        for kind in kinds.KINDS:
            with self.subTest(kind):
                self.start(kind, *self.chosen(kind))
                self.cancel()
                settle(0.3)
                self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))
                self.assertFalse(self.drawn(self.block) or self.drawn(self.sheets[0]))
        obj, _ = self.start("CurvatureMap", (self.block, ""))
        self.ok()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        panel = obj.ViewObject.Proxy.panel
        self.set_field(panel, "quantity", "Gaussian")
        self.assertAlmostEqual(obj.Largest, 1 / 16)
        self.cancel()
        self.assertEqual(obj.Quantity, "Mean")
        self.assertAlmostEqual(obj.Least, -0.25)

    def test_a_given_range_begins_with_the_values_found(self):
        obj, panel = self.start("CurvatureMap", (self.block, ""))
        self.set_field(panel, "range", "Given")
        self.assertEqual((obj.Range, obj.Low, obj.High), ("Given", -0.25, 0.0))
        self.set_field(panel, "high", 0.5)
        self.set_field(panel, "range", "Automatic")
        self.set_field(panel, "range", "Given")
        self.assertEqual((obj.Low, obj.High), (-0.25, 0.5))
        self.cancel()

    def test_undo_restores_values_and_colours(self):
        obj, _ = self.start("DraftAngle", (self.block, ""))
        self.ok()
        before = count(picture("undo-before"), ramps.TOWARDS)
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        self.set_field(obj.ViewObject.Proxy.panel, "towards_deg", 89.9)
        self.ok()
        settle(0.5)
        changed = count(picture("undo-changed"), ramps.TOWARDS)
        self.assertLess(changed, 0.9 * before)
        self.doc.undo()
        settle(0.5)
        self.assertEqual(obj.Towards.Value, 3)
        self.assertEqual(count(picture("undo-after"), ramps.TOWARDS), before)

    def test_a_stopped_computation_keeps_nothing(self):
        with held():
            self.COMMAND = "Seamwright_CurvatureMap"
            self.select((self.block, ""))
            Gui.runCommand(self.COMMAND)
            (obj,) = self.made()
            panel = obj.ViewObject.Proxy.panel
            self.assertTrue(panel.computation.busy)
            panel.computation.stop()
        self.assertIn("there are no results yet", panel.summary.text())
        self.assertFalse(self.drawn(self.block))
        self.cancel()
        self.assertEqual(self.made(), [])

    def test_the_progress_of_a_large_model_is_seen_at_once(self):
        blocks = [models.rounded_block() for _ in range(2)]
        blocks[1].translate(App.Vector(30, 0, 0))
        models.add(self.doc, Part.Compound(blocks), "Blocks")
        with held():
            self.COMMAND = "Seamwright_CurvatureMap"
            self.select((self.doc.Blocks, ""))
            Gui.runCommand(self.COMMAND)
            computation = self.made()[0].ViewObject.Proxy.panel.computation
            self.assertFalse(computation.line.isHidden())
            pause(0.7)
            self.assertTrue(computation.stop_button.isVisible())
            self.assertFalse(self.button(QtWidgets.QDialogButtonBox.Ok).isEnabled())
            self.cancel()
        self.assertEqual(self.made(), [])

    def test_cancel_stops_a_computation_and_closes_the_panel(self):
        with held():
            self.COMMAND = "Seamwright_CurvatureMap"
            self.select((self.block, ""))
            Gui.runCommand(self.COMMAND)
            (obj,) = self.made()
            pause(0.3)
            self.assertTrue(obj.ViewObject.Proxy.panel.computation.busy)
            self.cancel()
            self.assertEqual(self.made(), [])
        settle(0.3)
        self.assertFalse(Gui.Control.activeDialog())
        self.assertEqual(self.doc.UndoCount, 0)

    def test_a_bad_selection_is_one_sentence_and_changes_nothing(self):
        line = models.add(self.doc, Part.makeLine(App.Vector(), App.Vector(1, 0, 0)), "Line")
        group = self.doc.addObject("App::DocumentObjectGroup", "Group")
        self.sheets[1].Label = "the other sheet"
        self.doc.recompute()
        self.doc.clearUndos()
        for kind, chosen, text in (
            ("CurvatureComb", [], "Nothing is selected: select edges, wires or faces."),
            ("CurvatureMap", [(line, "")], "Line has no faces: "),
            ("DraftAngle", [(group, "")], "Group contains nothing with a shape: "),
            ("Deviation", [(self.block, "")], "1 object selected: select two objects"),
            ("SeamPlot", [(self.sheets[0], "Edge1")], "Left.Edge1 bounds 1 face: "),
            ("SeamPlot", [(self.sheets[1], "Edge1")], "the other sheet.Edge1 bounds 1 face: "),
            ("SeamPlot", [(self.block, "")], "Block is no edge: "),
        ):
            with self.subTest(text):
                self.start(kind, *chosen)
                (found,) = messages()
                self.assertTrue(found.startswith(text), found)
                self.assertEqual((self.made(), self.doc.UndoCount), ([], 0))
                self.assertFalse(self.doc.HasPendingTransaction)

    def test_a_part_and_a_group_count_as_their_contents_and_a_link_has_its_own_place(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.block)
        part.Placement.Base.z = 100
        group = self.doc.addObject("App::DocumentObjectGroup", "Group")
        for sheet in self.sheets:
            group.addObject(sheet)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base.z = 300
        self.doc.recompute()
        for kind in ("CurvatureMap", "ReflectionLines", "DraftAngle"):
            obj, _ = self.start(kind, (part, ""))
            self.assertEqual(tool.links_of(obj), [(self.block, "")])
            self.cancel()
        obj, _ = self.start("Deviation", (group, ""))
        self.assertEqual(obj.Proxy.source_objects(obj), self.sheets)
        self.cancel()
        self.select((group, ""))
        faces = [(sheet, "Face1") for sheet in self.sheets]
        self.assertEqual(selected.selected_elements("Face"), faces)
        self.select((part, "Block.Vertex2"))
        self.assertEqual(selected.selected_elements("Vertex"), [(self.block, "Vertex2")])
        body = self.doc.addObject("PartDesign::Body", "Body")
        first, last = (body.newObject("PartDesign::Additive" + kind) for kind in ("Box", "Sphere"))
        self.doc.recompute()
        self.select((body, last.Name + ".Face1"), (body, first.Name + ".Face2"))
        self.assertEqual(selected.selected_elements("Face"), [(body, "Face1"), (first, "Face2")])
        obj, _ = self.start("CurvatureComb", (link, "Block.Edge3"))
        ((source, name),) = tool.links_of(obj)
        self.assertEqual(source, link)
        meant = self.block.Shape.Edges[2].CenterOfMass + App.Vector(0, 0, 300)
        found = Part.getShape(link).Edges[int(name[4:]) - 1].CenterOfMass
        self.assertLess((found - meant).Length, 1e-9)
        self.cancel()

    def test_an_analysis_of_a_picked_copy_and_of_a_body_is_of_what_was_picked(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.block)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base.z = 300
        body = self.doc.addObject("PartDesign::Body", "Body")
        first, last = (
            body.newObject("PartDesign::%s" % kind) for kind in ("AdditiveBox", "SubtractiveBox")
        )
        last.Length = last.Width = last.Height = 3
        self.doc.recompute()
        self.fit()
        for top, path, meant in (
            (link, "Block.Edge3", link),
            (link, "Block.", link),
            (body, last.Name + ".Edge2", body),
            (body, last.Name + ".", body),
            (body, first.Name + ".Edge2", first),
        ):
            with self.subTest(path):
                self.select((top, path))
                said = report_view()
                obj, panel = self.analyse()
                self.assertEqual(obj.Sources, [meant])
                told = "%s is a step of Body" % first.Label in report_view()[len(said) :]
                self.assertEqual(told, meant == first)
                if path[-1] != ".":
                    self.select((top, path))
                    settle()
                    self.assertEqual(len(panel.seam_table.chosen_rows()), 1)
                panel.reject()
                settle()
        self.select((body, last.Name + ".Edge2"))
        Gui.runCommand("Seamwright_RepairSeams")
        settle()
        (obj,) = [each for each in self.doc.Objects if repair.is_repair(each)]
        self.assertEqual((obj.Source, obj.Edges), (body, (body, ["Edge2"])))
        panel = obj.ViewObject.Proxy.panel
        self.select((body, last.Name + ".Face1"))
        self.assertEqual(panel._picked("Face"), ["Face1"])
        self.cancel()

    def test_objects_of_two_documents_are_refused(self):
        other = App.newDocument("Other")
        self.addCleanup(App.closeDocument, other.Name)
        ball = other.addObject("Part::Sphere", "Ball")
        other.recompute()
        App.setActiveDocument(self.doc.Name)
        for command in ("AnalyzeSeams", "CurvatureMap"):
            self.select((self.block, ""))
            Gui.Selection.addSelection(other.Name, ball.Name)
            Gui.runCommand("Seamwright_" + command)
            settle()
            (text,) = messages()
            self.assertIn("is in another document, Other", text)
        self.assertEqual(self.made(), [])
        Gui.Selection.removeSelection(self.doc.Name, self.block.Name)
        obj, panel = self.analyse()  # of all that is in this document
        self.assertIn(self.block, obj.Analysed)
        panel.reject()
        Gui.Selection.clearSelection()

    def test_a_mesh_beside_an_object_is_one_sentence(self):
        mesh = self.doc.addObject("Mesh::Feature", "Scan")
        self.doc.recompute()
        for command in ("AnalyzeSeams", "RepairSeams", "ZebraStripes", "CurvatureMap"):
            self.select((self.block, ""), (mesh, ""))
            before = self.doc.Objects
            Gui.runCommand("Seamwright_" + command)
            settle()
            (text,) = messages()
            self.assertTrue(text.startswith("Scan is a mesh: "), text)
            self.assertEqual(self.doc.Objects, before)

    def test_other_sources_are_taken_or_refused(self):
        obj, panel = self.start("CurvatureMap", (self.block, ""))
        self.select((self.sheets[0], ""))
        click(panel.boxes["Sources"].use, panel.boxes["Sources"].use.rect().center())
        settle(0.5)
        self.assertEqual(obj.Proxy.source_objects(obj), [self.sheets[0]])
        self.assertEqual((self.drawn(self.block), self.drawn(self.sheets[0])), (False, True))
        self.select()
        click(panel.boxes["Sources"].use, panel.boxes["Sources"].use.rect().center())
        self.assertIn("Nothing is selected", messages()[0])
        self.ok()

    def test_with_nothing_selected_all_visible_objects_are_taken(self):
        self.sheets[1].ViewObject.Visibility = False
        obj, _ = self.start("DraftAngle")
        self.assertEqual(obj.Proxy.source_objects(obj), [self.sheets[0], self.block])
        self.cancel()


class Drawing(MapWindow):
    def test_options_change_what_is_drawn(self):
        obj, panel = self.start("DraftAngle", (self.block, ""))
        first = picture("draft-z")
        for colour in (ramps.TOWARDS, ramps.STEEP):
            self.assertGreater(count(first, colour), MANY)
        self.set_field(panel, "pull", [0, 0, -1])
        self.assertLess(
            count(picture("draft-down"), ramps.TOWARDS, QtCore.QRect(430, 0, 770, 800)),
            count(first, ramps.TOWARDS, QtCore.QRect(430, 0, 770, 800)) / 2,
        )
        self.set_field(panel, "pull", [0, 0, 0])
        self.assertIn("three numbers are needed", panel.summary.text())
        self.assertFalse(self.drawn(self.block))
        self.set_field(panel, "pull", [0, 0, 1])
        self.assertTrue(self.drawn(self.block))
        panel.options.fields["pull"].widget.setText("up")
        settle(0.4)
        self.assertIn("is not a list of numbers", panel.summary.text())
        panel.options.fields["pull"].show_value([0, 0, 1])
        settle(0.4)
        self.ok()

    def test_only_the_options_of_the_chosen_lines_are_seen(self):
        _, panel = self.start("ReflectionLines", (self.block, ""))
        stripes = picture("lines-zebra")
        fields = panel.options.fields
        for lines, seen, unseen in (
            ("Zebra stripes", "stripes", "step_deg"),
            ("Isophotes", "step_deg", "along"),
            ("Highlight lines", "along", "stripes"),
        ):
            self.set_field(panel, "lines", lines)
            self.assertTrue(fields[seen].widget.isVisible(), seen)
            self.assertFalse(fields[unseen].widget.isVisible(), unseen)
            whole_window("lines-" + lines)
            view = picture("lines-now")
            self.assertGreater(count(view, ramps.DARK), MANY)
            self.assertEqual(view == stripes, lines == "Zebra stripes")
        self.ok()

    def test_stripes_without_a_shader_follow_the_view(self):
        with mock.patch.object(shaders, "work", lambda: False):
            self.start("ReflectionLines", (self.block, ""))
            self.ok()
            settle(0.5)
            one = picture("texture-iso")
            Gui.activeDocument().activeView().viewFront()
            settle(0.5)
            other = picture("texture-front")
        for view in (one, other):
            self.assertGreater(count(view, ramps.DARK), MANY)
            self.assertGreater(count(view, ramps.LIGHT), MANY)
        self.assertNotEqual(one, other)

    def test_a_comb_is_drawn_beside_other_panels_and_maps(self):
        obj, panel = self.start("CurvatureComb", (self.sheets[0], "Face1"))
        rgb = [round(255 * each) for each in COLOURS[0]]
        self.assertGreater(count(picture("comb-panel"), rgb), MANY)
        self.set_field(panel, "scale", 3.0)
        larger = count(picture("comb-larger"), rgb)
        self.ok()
        self.start("CurvatureMap", (self.sheets[0], ""))
        self.assertGreater(count(picture("comb-and-map"), rgb), larger / 2)
        self.ok()
        obj.ViewObject.Visibility = False
        settle(0.4)
        self.assertLess(count(picture("comb-hidden"), rgb), FEW)

    def test_a_new_map_hides_the_one_before_and_cancel_shows_it_again(self):
        first, _ = self.start("CurvatureMap", (self.block, ""))
        self.ok()
        second, _ = self.start("DraftAngle", (self.block, ""))
        self.assertFalse(first.ViewObject.Visibility)
        self.cancel()
        settle(0.4)
        self.assertTrue(first.ViewObject.Visibility)
        self.assertTrue(self.drawn(self.block))
        first.ViewObject.Visibility = False
        settle(0.4)
        self.assertFalse(self.drawn(self.block))

    def test_maps_follow_their_sources(self):
        obj, _ = self.start("DraftAngle", (self.block, ""))
        self.ok()
        before = obj.Largest, obj.Summary
        self.block.Placement.Rotation = App.Rotation(App.Vector(1, 0, 0), 45)
        self.doc.recompute()
        settle(0.5)
        self.assertNotEqual(obj.Summary, before[1])
        self.assertTrue(self.drawn(self.block))
        self.doc.removeObject("Block")
        obj.touch()
        said = report_view()
        self.doc.recompute()
        settle(0.5)
        self.assertIn("Invalid", obj.State)
        self.assertIn("the sources were deleted: select others", report_view()[len(said) :])
        self.assertNotIn("Traceback", report_view()[len(said) :])
        self.assertFalse(hasattr(sys, "tracebacklimit"))
        self.assertLess(self.legend("draft-deleted"), FEW)

    def test_what_is_hidden_has_no_legend_and_the_panel_says_it(self):
        self.block.ViewObject.Visibility = False
        obj, panel = self.start("DraftAngle", (self.block, ""))
        self.assertTrue(panel.summary.text().endswith(" since they are hidden: Block."))
        corner = QtCore.QRect(0, 0, 420, 400)
        hidden = count(picture("draft-hidden"), BORDER, corner, reach=2)
        self.block.ViewObject.Visibility = True
        settle(0.3)
        self.assertGreater(count(picture("draft-seen"), BORDER, corner, reach=2), hidden + MANY)
        self.cancel()

    def test_the_mark_of_what_is_hidden_is_hidden(self):
        obj, _ = self.start("Deviation", (self.sheets[0], ""), (self.block, ""))
        self.ok()
        settle(0.5)
        marker = obj.ViewObject.Proxy.marker
        for seen in (True, False, True):
            self.sheets[0].ViewObject.Visibility = seen
            settle(0.3)
            self.assertEqual(marker.count > 0, seen)

    def test_two_legends_stand_below_each_other(self):
        found = analysis.create([self.block])
        obj, _ = self.start("DraftAngle", (self.block, ""))
        self.ok()
        corner = QtCore.QRect(0, 0, 420, 400)

        def borders(name):
            return count(picture(name), BORDER, corner, reach=2)

        both = borders("legends-both")
        found.ViewObject.Visibility = False
        settle(0.3)
        lower = borders("legends-map")
        found.ViewObject.Visibility, obj.ViewObject.Visibility = True, False
        settle(0.3)
        upper = borders("legends-analysis")
        found.ViewObject.Visibility = False
        settle(0.3)
        none = borders("legends-none")
        self.assertGreater(min(lower, upper), none + MANY)
        self.assertAlmostEqual(both - none, lower - none + upper - none, delta=FEW)

    def test_a_document_opens_with_what_was_drawn(self):
        for kind in ("CurvatureComb", "DraftAngle"):
            self.start(kind, *self.chosen(kind))
            self.ok()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            settle(1.0)
        self.fit()
        view = picture("opened")
        self.assertTrue(self.drawn(self.doc.Block))
        self.assertGreater(count(view, [round(255 * each) for each in COLOURS[0]]), MANY)
        self.assertGreater(count(view, ramps.TOWARDS, LEGEND), FEW)
        again = self.doc.DraftAngle
        again.ViewObject.Proxy.doubleClicked(again.ViewObject)
        settle()
        self.set_field(again.ViewObject.Proxy.panel, "towards_deg", 50)
        self.ok()
        self.assertEqual(again.Towards.Value, 50)

    def test_the_largest_deviation_is_marked(self):
        ball = models.add(self.doc, Part.makeSphere(9), "Ball")
        other = models.add(self.doc, Part.makeSphere(10), "Other")
        self.doc.recompute()
        obj, panel = self.start("Deviation", (ball, ""), (other, ""))
        other.ViewObject.Visibility = False
        self.ok()
        settle(0.5)
        report = report_of(obj)
        self.assertAlmostEqual(report["furthest_mm"], 1, delta=1e-9)
        (mark,) = obj.Proxy.marks(report)
        self.assertEqual(mark[1], "1 mm")
        self.assertGreater(count(picture("deviation-mark"), INK), FEW)
        self.assertIn("Sampled", obj.Summary)


    def test_the_legend_says_what_is_left_out(self):
        plate = models.add(self.doc, Part.makePlane(30, 10), "Plate")
        small = models.add(self.doc, Part.makePlane(10, 10), "Small")
        small.Placement.Base.z = 1
        self.doc.recompute()
        _, panel = self.start("Deviation", (plate, ""), (small, ""))
        settle(0.5)
        place = QtCore.QRect(30, 150, 50, 18)  # of the sample
        self.assertGreater(count(picture("left-out"), ramps.UNDEFINED, place, reach=2), MANY // 2)
        self.set_field(panel, "beyond_edges", True)
        self.assertEqual(count(picture("none-left-out"), ramps.UNDEFINED, place, reach=2), 0)
        self.ok()


    def test_edges_under_colours_are_whole_lines(self):
        self.block.ViewObject.Visibility = False
        self.start("CurvatureMap", *((sheet, "") for sheet in self.sheets))
        (edge,) = (e for e in self.sheets[0].Shape.Edges if abs(e.CenterOfMass.x) < 1e-6)
        middle = edge.valueAt(edge.getParameterByLength(edge.Length / 2))
        node = Gui.activeDocument().activeView().getCameraNode()
        back = App.Rotation(*node.orientation.getValue().getValue()).multVec(App.Vector(0, 0, 1))
        node.position.setValue(*(middle + back * node.focalDistance.getValue()))
        node.height.setValue(edge.Length / 4)
        settle()
        image = picture("whole-edge")
        columns = [QtCore.QRect(x, 0, 1, 800) for x in range(430, 1200, 10)]
        dark = [26, 26, 26]  # coloured.EDGE_COLOUR
        self.assertTrue(all(count(image, dark, column, reach=40) for column in columns))
        self.ok()


class Large(MapWindow):
    def test_a_switch_takes_less_than_a_fifth_of_a_second_for_a_thousand_faces(self):
        blocks = []
        for k in range(39):
            block = models.rounded_block()
            block.translate(App.Vector(25 * (k % 7), 25 * (k // 7), 0))
            blocks.append(block)
        source = models.add(self.doc, Part.Compound(blocks), "Blocks")
        self.doc.recompute()
        self.assertGreater(len(source.Shape.Faces), 1000)
        obj = kinds.create("CurvatureMap", source)
        settle(1.0)
        for quantity in ("Gaussian", "Largest", "Smallest radius", "Mean"):
            begin, wall = time.thread_time(), time.perf_counter()
            obj.Quantity = quantity
            self.doc.recompute()
            work, values = obj.Proxy.prepared(obj)
            obj.ViewObject.Proxy.drawing.draw(obj, work(None), values)
            spent, wall = time.thread_time() - begin, time.perf_counter() - wall
            print("%s: %.3f s of the processor, %.3f s" % (quantity, spent, wall))
            self.assertLess(spent, SWITCH_S)
            settle(0.2)
