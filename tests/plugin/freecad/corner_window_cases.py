# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corner Fillet in FreeCAD's window; run by run_freecad.py --window."""

import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from fill_window_cases import BAND, FEW, MANY, RESULT, tinted

from window import (
    CANCELLED, PanelWindow, camera, click, click_row, count, messages, picture, settle, whole_window
)  # fmt: skip

from freecad.seamwright.document import corner, elements
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.corner.panel import RADIUS, SETBACK
from freecad.seamwright.plain import corner_text

CORNER = "Seamwright_CornerFillet"


class CornerWindow(PanelWindow):
    COMMAND = CORNER
    is_made = staticmethod(corner.is_corner)

    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.source = models.add(self.doc, Part.makeBox(10, 10, 10), "Cube")
        self.source.ViewObject.ShapeColor = (0.7, 0.7, 0.7)
        self.doc.recompute()
        self.fit()
        points = [vertex.Point for vertex in self.source.Shape.Vertexes]
        self.vertex = "Vertex%d" % (
            1 + points.index(App.Vector(10, 0, 10))
        )  # it is seen from the front

    def start(self, *names, source=None):
        return self.run_selected(
            [(source or self.source, name) for name in names or (self.vertex,)]
        )

    def set_fields(self, panel, column, values):
        for field, value in zip(panel.fields[column], values):
            field.setValue(value)


class Rounding(CornerWindow):
    def test_a_vertex_is_picked_previewed_accepted_and_undone(self):
        steps = self.doc.UndoCount
        obj, panel = self.start()
        names = [panel.edges.item(line, 0).text() for line in range(3)]
        self.assertEqual(names, corner.corner_of(obj)[0])
        self.assertEqual([field.value() for field in panel.fields[RADIUS]], [1.0] * 3)
        self.set_fields(panel, RADIUS, (1.0, 2.0, 3.0))
        self.preview(panel)
        self.assertEqual((self.visible(), panel.summary.text()), ([obj.Name], obj.Summary))
        self.assertEqual((list(obj.Radii), list(obj.Setbacks)), ([1.0, 2.0, 3.0], []))
        self.assertEqual(self.column(panel, RESULT), ["meets G1"] * 24)
        self.assertRegex(panel.fields[SETBACK][0].text(), r"^auto: \d")
        self.assertEqual(panel.edges.item(0, 2).text(), "convex, 90\u00b0")
        self.assertGreater(tinted(picture("corner-preview")), MANY)
        whole_window("corner-preview")
        panel.zebra.setChecked(True)
        settle()
        self.assertEqual(zebra.objects(self.doc), [obj])
        self.assertEqual(tinted(picture("corner-stripes")), 0)
        whole_window("corner-stripes-window")
        self.ok()
        self.assertEqual(zebra.objects(self.doc), [])
        self.assertIsNone(obj.ViewObject.Proxy.panel)
        self.assertEqual(
            (self.visible(), obj.ViewObject.Proxy.claimChildren()), ([obj.Name], [self.source])
        )
        self.assertEqual((tinted(picture("corner-after")), len(obj.Shape.Faces)), (0, 15))
        self.assertEqual(self.doc.UndoCount, steps + 1)
        self.doc.undo()
        settle()
        self.assertEqual((self.made(), self.visible()), ([], ["Cube"]))
        self.doc.redo()
        settle()
        (again,) = self.made()
        self.assertEqual((again.Met, self.visible()), (True, [again.Name]))

    def test_setbacks_and_one_radius_for_all(self):
        obj, panel = self.start()
        self.set_fields(panel, RADIUS, (1.5, 2.0, 3.0))
        click(panel.same, panel.same.rect().center())
        self.set_fields(panel, SETBACK, (0.0, 4.0, 0.0))
        self.ok()
        self.assertEqual((list(obj.Radii), list(obj.Setbacks)), ([1.5], [0.0, 4.0, 0.0]))
        self.assertEqual([edge["radius_mm"] for edge in corner.report_of(obj)["edges"]], [1.5] * 3)
        self.assertEqual(corner.report_of(obj)["edges"][1]["setback_mm"], 4.0)

    def test_a_click_on_a_row_marks_the_seam_and_on_an_edge_selects_it(self):
        self.without_live_preview()
        obj, panel = self.start()
        self.assertEqual((self.visible(), panel.summary.text()), (["Cube"], "3 edges to round."))
        self.assertEqual([field.text() for field in panel.fields[SETBACK]], ["auto"] * 3)
        name = panel.edges.item(1, 0).text()
        click_row(panel.edges, 1)
        (chosen,) = Gui.Selection.getSelectionEx()
        self.assertEqual((chosen.ObjectName, chosen.SubElementNames), ("Cube", (name,)))
        self.press_preview(panel)
        before = camera()
        click_row(panel.table, 0)
        (chosen,) = Gui.Selection.getSelectionEx()
        self.assertEqual(
            (chosen.ObjectName, chosen.SubElementNames), (obj.Name, (self.column(panel, 0)[0],))
        )
        self.assertNotEqual(camera(), before)
        self.assertGreater(count(picture("corner-row"), BAND), FEW)
        self.cancel()

    def test_what_is_refused_says_why_and_nothing_is_made(self):
        obj, panel = self.start()
        self.set_fields(panel, RADIUS, (11.0, 1.0, 1.0))
        self.preview(panel)
        self.assertEqual(self.visible(), ["Cube"])
        self.assertRegex(
            panel.summary.text(),
            r"^Not rounded: Edge\d+: with a radius of 11 mm there, the fillet of Edge",
        )
        self.ok()
        (text,) = messages()
        self.assertIn("with a radius of 11 mm there", text)
        whole_window("corner-refused")
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)
        with CANCELLED:
            self.set_fields(panel, RADIUS, (1.0, 1.0, 1.0))
            self.preview(panel)
        self.assertIn("Cancelled", panel.summary.text())
        self.cancel()
        self.assertEqual((self.made(), self.visible()), ([], ["Cube"]))

    def test_a_corner_that_is_not_supported_says_why(self):
        can = models.add(self.doc, Part.makeCylinder(3, 10), "Can")
        self.doc.recompute()
        obj, _ = self.start("Vertex1", source=can)
        self.assertIsNone(obj)
        self.assertEqual(messages(), ["2 edges meet at the vertex: 3 to 6 are needed."])
        obj, panel = self.start()
        self.use(panel, "Vertex", (can, "Vertex1"))
        self.assertIn("2 edges meet at the vertex", panel.summary.text())
        self.assertEqual(panel.edges.rowCount(), 0)
        self.ok()
        (text,) = messages()
        self.assertIn("2 edges meet at the vertex", text)
        self.cancel()
        self.assertEqual(self.made(), [])

    def test_cancel_of_a_later_change_restores_the_values(self):
        obj, _ = self.start()
        self.ok()
        for undo in (1, 0):
            self.doc.UndoMode = undo
            Gui.activeDocument().setEdit(obj.Name)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.assertEqual(panel.table.rowCount(), 24)
            self.set_fields(panel, RADIUS, (2.0, 2.5, 2.0))
            self.preview(panel)
            self.assertEqual(list(obj.Radii), [2.0, 2.5, 2.0])
            self.cancel()
            self.assertEqual((list(obj.Radii), obj.Met, self.visible()), ([1.0], True, [obj.Name]))
            self.assertEqual(
                [edge["radius_mm"] for edge in corner.report_of(obj)["edges"]], [1.0] * 3
            )

    def test_faces_keep_their_colours_where_they_keep_their_order(self):
        quarter = Part.makeCylinder(10, 20, App.Vector(), App.Vector(0, 0, 1), 90)
        for name, shape in (("Plain", Part.makeBox(10, 10, 10)), ("Quarter", quarter)):
            source = models.add(self.doc, shape, name)
            self.doc.recompute()
            colours = [(0.1, 0.1 * n, 0.5) for n in range(len(shape.Faces))]
            source.ViewObject.DiffuseColor = colours
            obj, _ = self.start("Vertex1", source=source)
            self.ok()
            shown = [colour[:3] for colour in obj.ViewObject.DiffuseColor]
            self.assertEqual(len(shown), len(obj.Shape.Faces))
            # The colour of the whole model: since FreeCAD 1.0 it is the one of the first face.
            whole = [round(each, 2) for each in source.ViewObject.ShapeColor[:3]]
            new = corner_text.new_faces(corner.report_of(obj))
            kept = []
            for number, (face, colour) in enumerate(zip(obj.Shape.Faces, shown), 1):
                colour = [round(each, 2) for each in colour]
                if number in new:
                    self.assertEqual(colour, whole)
                else:
                    kept.append((face, colour))
            if all(colour == whole for _, colour in kept):
                self.assertEqual(name, "Quarter")  # the order is another one
                continue
            for face, colour in kept:
                surface = shape.Faces[round(10 * colour[1])].Surface
                for vertex in face.Vertexes:
                    foot = surface.value(*surface.parameter(vertex.Point))
                    self.assertLess((foot - vertex.Point).Length, 1e-6)
            if name == "Plain":
                self.assertEqual([round(10 * colour[1]) for colour in shown[:6]], list(range(6)))

    def test_another_vertex_is_picked_and_its_fields_follow(self):
        line = models.add(self.doc, Part.makePolygon([(0, 0, 0), (1, 0, 0)]), "Line")
        self.doc.recompute()
        obj, panel = self.start()
        self.set_fields(panel, RADIUS, (1.0, 2.0, 3.0))
        self.preview(panel)
        self.assertEqual(list(obj.Radii), [1.0, 2.0, 3.0])
        for chosen in ((self.source, "Edge1"), (line, "")):
            panel.before.setChecked(True)
            self.use(panel, "Vertex", chosen)
            (text,) = messages()
            self.assertIn("Choose one vertex", text)
        other = "Vertex1" if self.vertex != "Vertex1" else "Vertex2"
        self.use(panel, "Vertex", (self.source, other))
        self.assertEqual(panel.boxes["Vertex"].chosen.text(), "Cube." + other)
        names = [panel.edges.item(line, 0).text() for line in range(3)]
        self.assertEqual((names, list(obj.Radii)), (corner.corner_of(obj)[0], [1.0]))
        self.assertEqual((obj.Met, self.visible()), (True, ["Line", obj.Name]))
        field = panel.fields[RADIUS][0]
        field.setFocus()
        field.lineEdit().setText("1/16 in")
        settle(0.8)
        self.assertAlmostEqual(obj.Radii[0], 1.5875, delta=1e-9)
        self.assertIs(panel.fields[RADIUS][0], field)  # typing goes on
        self.press_undo()
        self.assertEqual((list(obj.Radii), elements.names(obj, "Vertex")), ([1.0], [other]))
        self.press_undo()
        self.assertEqual(elements.names(obj, "Vertex"), [self.vertex])
        self.assertEqual(list(obj.Radii), [1.0, 2.0, 3.0])
        self.press_undo()
        self.assertEqual((list(obj.Radii), obj.ViewObject.Proxy.panel), ([1.0], panel))
        self.cancel()
        self.assertEqual(self.made(), [])

    def test_other_selections_and_a_missing_kernel_are_one_message(self):
        for names, found in (
            (("Edge1",), "Selected: no vertex."),
            (("Vertex1", "Vertex2"), "Selected: Cube.Vertex1, Cube.Vertex2."),
        ):
            self.start(*names)
            (text,) = messages()
            self.assertIn(found, text)
        sheet = models.add(self.doc, Part.makePlane(9, 9), "Sheet")
        self.doc.recompute()
        self.run_selected([(sheet, "Vertex1")])
        self.assertEqual(messages(), ["Vertex1 is in no shell of a solid: one is needed."])
        with mock.patch.dict(sys.modules, seamwright=None):
            self.start()
        (text,) = messages()
        self.assertIn("It was built for Python", text)
        self.assertEqual(self.made(), [])

    def test_a_saved_fillet_opens_with_its_view(self):
        self.start()
        self.ok()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            with mock.patch.dict(sys.modules, seamwright=None):
                self.doc = App.openDocument(path)
                settle()
                (again,) = self.made()
                self.assertNotIn("Touched", again.State)
                self.assertEqual(self.visible(), [again.Name])
            again.ViewObject.Proxy.doubleClicked(again.ViewObject)
            settle()
            self.assertEqual(again.ViewObject.Proxy.panel.summary.text(), again.Summary)
            self.cancel()
