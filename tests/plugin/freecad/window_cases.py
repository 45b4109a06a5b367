# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands, task panel and picture, in FreeCAD's window; run by run_freecad.py --window."""

import csv
import os
import sys
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import ImportGui
import models
import Part
from PySide import QtCore, QtGui

from window import (
    OUT, WindowCase, analyses, camera, click, click_row, count, messages, mouse, picture,
    press_escape, settle, whole_window
)  # fmt: skip

from freecad.seamwright.document import analysis
from freecad.seamwright.gui import commands
from freecad.seamwright.gui.analysis import export_dialog
from freecad.seamwright.gui.analysis.panel import AnalysisPanel
from freecad.seamwright.gui.scene import marker
from freecad.seamwright.gui.widgets import progress
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import palette, rows

STEP = "/usr/share/opencascade/data/step/linkrods.step"
LEGEND = QtCore.QRect(0, 0, 420, 140)
MODEL = QtCore.QRect(0, 145, 1200, 655)
FEW = 60  # pixels of a short line


class Picture(WindowCase):
    def setUp(self):
        super().setUp()
        ImportGui.insert(STEP, self.doc.Name)
        self.fit()

    def test_the_command_colours_the_seams_and_shows_a_legend(self):
        obj, panel = self.analyse()
        self.assertIsNotNone(panel)
        self.fit()
        view = picture("view")
        whole_window("window")
        for seam_class in palette.CLASSES:
            with self.subTest(seam_class.name):
                self.assertGreater(count(view, seam_class.rgb, LEGEND), FEW)
                self.assertGreater(count(view, seam_class.rgb, MODEL), FEW)
        self.assertEqual(panel.seam_table.model.rowCount(), obj.Seams)
        self.assertEqual(panel.summary.text(), obj.Summary)

    def test_a_click_on_a_row_selects_the_edge_and_moves_the_camera(self):
        obj, panel = self.analyse()
        source = obj.Analysed[0].Name
        for place in (0, 3):
            before = camera()
            click_row(panel.seam_table.table, place)
            seam = panel.results.seams[panel.seam_table.model.row(place).seam]
            chosen = [
                (one.ObjectName, one.SubElementNames) for one in Gui.Selection.getSelectionEx()
            ]
            self.assertEqual(chosen, [(source, ("Edge%d" % seam["edges"][0],))])
            self.assertNotEqual(camera(), before)
        whole_window("window-row")
        self.assertGreater(count(picture("view-row"), (255, 217, 0)), FEW)

    def test_filter_and_sorting(self):
        obj, panel = self.analyse()
        panel.seam_table.filter.setCurrentIndex(panel.seam_table.filter.findData("crease"))
        self.assertEqual(panel.seam_table.model.rowCount(), obj.Creases)
        panel.seam_table.filter.setCurrentIndex(0)
        header = panel.seam_table.table.horizontalHeader()
        for _ in range(2):
            click(header.viewport(), QtCore.QPoint(header.sectionViewportPosition(2) + 20, 8))
        model = panel.seam_table.model
        angles = [model.row(place).angle_deg for place in range(model.rowCount())]
        self.assertIn(angles, (sorted(angles), sorted(angles, reverse=True)))
        panel.seam_table.sort_worst_first()
        self.assertEqual(panel.seam_table.model.row(0).seam_class, "defect")


class Panel(WindowCase):
    def setUp(self):
        super().setUp()
        models.add(self.doc, models.three_classes(), "Prism")
        self.fit()

    def test_new_tolerances_change_table_and_colours(self):
        obj, panel = self.analyse()
        self.assertGreater(count(picture("before"), palette.DEFECT.rgb, MODEL), FEW)
        panel.tolerances.fields["AngleTolerance"].setValue(2.0)
        click(panel.recompute_button, QtCore.QPoint(5, 5))
        self.assertEqual((obj.Defects, obj.AngleTolerance.Value), (0, 2.0))
        self.assertEqual(panel.summary.text(), obj.Summary)
        after = picture("after")
        self.assertEqual(count(after, palette.DEFECT.rgb, MODEL), 0)
        self.assertGreater(count(after, palette.SMOOTH.rgb, MODEL), FEW)
        self.doc.undo()
        settle()
        self.assertEqual(obj.AngleTolerance.Value, 0.1)

    def shown(self, panel):
        """All that a panel shows."""
        model, choice = panel.seam_table.model, panel.seam_table.filter
        columns = range(model.columnCount())
        cells = [
            [model.index(place, column).data() for column in columns]
            for place in range(model.rowCount())
        ]
        filters = [choice.itemText(place) for place in range(choice.count())]
        fields = [
            panel.tolerances.level.currentText(),
            *(each.text() for each in panel.tolerances.fields.values()),
        ]
        return panel.summary.text(), cells, filters, fields, panel.recompute_button.text()

    def test_undo_and_redo_show_one_state_and_not_parts_of_two(self):
        self.doc.UndoMode = 1
        obj, panel = self.analyse()
        states = []
        for angle, level in ((0.1, "G1"), (2.0, "G1"), (2.0, "G2")):
            panel.tolerances.level.setCurrentText(level)
            panel.tolerances.fields["AngleTolerance"].setValue(angle)
            click(panel.recompute_button, QtCore.QPoint(5, 5))
            states.append((self.shown(panel), obj.Report, obj.Summary))
        self.assertEqual(len({str(shown) for shown, *_ in states}), 3)
        for step, expected in (
            (self.doc.undo, (1, 0)),
            (self.doc.redo, (1, 2)),
            (self.doc.undo, (1,)),
        ):
            for place in expected:
                step()
                settle()
                self.assertEqual((self.shown(panel), obj.Report, obj.Summary), states[place])
                fresh = AnalysisPanel(obj, False)  # one that never saw another state
                self.assertEqual(self.shown(fresh), states[place][0])
                fresh.leave()

    def test_a_property_that_was_changed_elsewhere_is_shown(self):
        obj, panel = self.analyse()
        obj.AngleTolerance = 2.0
        settle()
        self.assertEqual(panel.tolerances.fields["AngleTolerance"].value(), 2.0)
        self.doc.recompute()
        settle()
        self.assertEqual((panel.summary.text(), obj.Defects), (obj.Summary, 0))

    def test_fields_show_small_numbers_in_full(self):
        _, panel = self.analyse()
        field = panel.tolerances.fields["GapTolerance"]
        for value in (0.01, 0.00025, 12.5):
            field.setValue(value)
            shown = App.Units.Quantity(field.text().replace(",", "."))
            self.assertAlmostEqual(shown.Value, value, delta=1e-9 * value)

    def test_a_profile_fills_in_the_fields_and_shows_custom_for_others(self):
        obj, panel = self.analyse()
        form = panel.tolerances
        self.assertEqual(form.profile.currentData(), "default")
        place = form.profile.findData("vda")
        form.profile.setCurrentIndex(place)
        form.profile.activated.emit(place)
        self.assertEqual(form.fields["GapTolerance"].value(), 0.02)
        self.assertEqual(form.fields["CurvatureTolerance"].value(), 0.1)
        self.assertIn("values were changed", panel.recompute_button.text())
        click(panel.recompute_button, QtCore.QPoint(5, 5))
        self.assertEqual((obj.GapTolerance.Value, obj.CurvatureTolerance), (0.02, 0.1))
        form.fields["GapTolerance"].setValue(0.03)
        self.assertIsNone(form.profile.currentData())
        self.assertEqual(form.profile.currentText(), "Custom")
        form.fields["GapTolerance"].setValue(0.02)
        self.assertEqual(form.profile.currentData(), "vda")
        self.assertEqual(form.fields["MatchDistance"].text(), "off")

    def test_the_worst_point_is_marked_while_its_row_is_chosen(self):
        obj, panel = self.analyse()
        click_row(panel.seam_table.table, 0)
        whole_window("window-marker")
        shown = picture("marker")
        self.assertGreater(count(shown, (255, 217, 0)), FEW)
        obj.ViewObject.Proxy.marker.show([])
        without = count(picture("no-marker"), marker.INK, MODEL)
        self.assertGreater(count(shown, marker.INK, MODEL), without + FEW)
        with mock.patch.object(obj.ViewObject.Proxy.marker, "show") as show:
            panel.seam_table.table.clearSelection()
            click_row(panel.seam_table.table, 0)
            (number,) = panel.seam_table.model.row(0).edges
            ((point, label),) = show.call_args.args[0]
            panel.reject()
            settle()
        self.assertEqual(label, "1°")
        edge = obj.Analysed[0].Shape.Edges[number - 1]
        self.assertLess(edge.distToShape(models.point(*point))[0], 1e-9)
        self.assertEqual(show.call_args.args[0], [])

    def test_the_mark_is_seen_through_the_model(self):
        obj, _ = self.analyse()
        view = Gui.activeDocument().activeView()
        view.viewTop()
        view.fitAll()
        settle()
        without = count(picture("below-without"), marker.INK, MODEL)
        obj.ViewObject.Proxy.mark([], [], [((10, 10, 0), "12.4\u00b0")])
        self.assertGreater(count(picture("below"), marker.INK, MODEL), without + FEW)

    def test_picking_an_edge_selects_its_row(self):
        obj, panel = self.analyse()
        before = camera()
        prism = obj.Analysed[0]
        for name, element, place in ((prism.Name, "Edge%d", 5), (obj.Name, "Edge%d", 0)):
            row = panel.seam_table.model.row(place)
            number = row.edges[0]
            if name == obj.Name:
                number = rows.edge_numbers(panel.results.report).index(number) + 1
            Gui.Selection.clearSelection()
            Gui.Selection.addSelection(self.doc.Name, name, element % number, 1.0, 2.0, 3.0)
            settle()
            selection = panel.seam_table.table.selectionModel()
            chosen = [index.row() for index in selection.selectedRows()]
            self.assertEqual(chosen, [place])
            self.assertEqual(camera(), before)
        self.assertGreater(count(picture("picked"), (255, 217, 0)), FEW)

    def test_a_row_selects_an_edge_in_a_link_to_a_part(self):
        part = self.doc.addObject("App::Part", "Part")
        inner = self.doc.addObject("App::Part", "Inner")
        inner.Placement = App.Placement(App.Vector(0, 40, 0), App.Rotation(App.Vector(1, 0, 0), 30))
        part.addObject(inner)
        for owner, name in ((part, "One"), (inner, "Two")):
            owner.addObject(models.add(self.doc, models.three_classes(), name))
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base.x = 100
        for each in (part, self.doc.getObject("Prism")):
            each.ViewObject.Visibility = False
        self.doc.recompute()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(link)
        obj, panel = self.analyse()
        self.assertEqual((obj.Analysed, obj.Seams), ([link], 36))
        seen = set()
        for place in (0, 1):
            click_row(panel.seam_table.table, place)
            whole_window("link-row-%d" % place)
            (chosen,) = Gui.Selection.getSelectionEx("", 0)
            (path,) = chosen.SubElementNames
            self.assertEqual(chosen.Object, link)
            seen.add(path.rsplit(".", 1)[0])
            number = panel.seam_table.chosen_rows()[0].edges[0]
            box = App.BoundBox()
            for point in panel.results.lines[number]:
                box.add(*point)
            edge = Part.getShape(link, path, needSubElement=True)
            self.assertLess((edge.BoundBox.Center - box.Center).Length, 1e-3)
            self.assertEqual(panel.results.elements(panel.seam_table.chosen_rows())[0][0], "Link")
        self.assertEqual(seen, {"One", "Inner.Two"})

    def test_picking_an_edge_of_a_filtered_class_shows_all(self):
        obj, panel = self.analyse()
        panel.seam_table.filter.setCurrentIndex(panel.seam_table.filter.findData("smooth"))
        crease = next(seam for seam in panel.results.report["seams"] if seam["class"] == "crease")
        Gui.Selection.addSelection(
            self.doc.Name, obj.Analysed[0].Name, "Edge%d" % crease["edges"][0]
        )
        settle()
        (index,) = panel.seam_table.table.selectionModel().selectedRows()
        self.assertEqual(panel.seam_table.model.row(index.row()).seam, crease["id"])
        panel.reject()
        Gui.Selection.addSelection(self.doc.Name, obj.Analysed[0].Name, "Edge1")
        settle()

    def test_an_error_is_shown_in_the_panel(self):
        obj, panel = self.analyse()
        obj.AngleTolerance = -1.0
        self.doc.recompute()
        panel.refresh()
        self.assertIn("-1", panel.summary.text())
        self.assertEqual(panel.seam_table.model.rowCount(), 0)

    def test_export_from_the_panel(self):
        obj, _ = self.analyse()
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue(export_dialog.export_to(obj, os.path.join(folder, "seams.csv")))
            self.assertEqual(os.listdir(folder), ["seams.csv"])
            self.assertFalse(export_dialog.export_to(obj, os.path.join(folder, "no", "seams.csv")))
        self.assertIn("does not exist", messages()[0])

    def test_a_table_is_written_as_it_is_shown(self):
        obj, panel = self.analyse()
        path = os.path.join(OUT, "shown.csv")

        def exported(kind, path):
            with mock.patch.object(QtWidgets.QFileDialog, "getSaveFileName") as dialog:
                dialog.return_value = (path, "")
                with mock.patch.object(export_dialog.messages, "say") as say:
                    panel._asked(kind)
            return say.call_args.args[0].replace(path, "PATH")

        def written():
            with open(path, encoding="utf-8") as file:
                return [int(line["id"]) for line in csv.DictReader(file)]

        self.assertEqual(exported("csv", path), "18 of 18 seams are written to PATH.")
        panel.seam_table.table.sortByColumn(0, QtCore.Qt.DescendingOrder)
        self.assertEqual(exported("csv", path), "18 of 18 seams are written to PATH.")
        self.assertEqual(written(), list(range(18, 0, -1)))
        shown = panel.seam_table.filter
        shown.setCurrentIndex(shown.findData("crease"))
        settle()
        seams = panel.results.report["seams"]
        creases = [seam["id"] for seam in seams if seam["class"] == "crease"]
        self.assertEqual(
            exported("csv", path), "%d of 18 seams (crease) are written to PATH." % len(creases)
        )
        self.assertEqual(written(), creases[::-1])
        whole = os.path.join(OUT, "shown.json")
        self.assertEqual(exported("json", whole), "18 of 18 seams are written to PATH.")

    def answer(self, text):
        """Press a button of the one question that is shown."""
        (box,) = [
            each
            for each in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(each, QtWidgets.QMessageBox) and each.isVisible()
        ]
        (button,) = [each for each in box.buttons() if each.text().strip("&") == text]
        button.click()
        settle()

    def test_close_asks_what_becomes_of_changed_values(self):
        for answer, angle, closed in (
            ("Cancel", 0.1, False), ("Discard the changes", 0.1, True),
            ("Recompute and close", 3.0, True),
        ):  # fmt: skip
            with self.subTest(answer):
                obj, panel = self.analyse()
                panel.tolerances.fields["AngleTolerance"].setValue(3.0)
                self.press(QtWidgets.QDialogButtonBox.Close)
                self.answer(answer)
                self.assertEqual(obj.AngleTolerance.Value, angle)
                self.assertEqual(obj.ViewObject.Proxy.panel is None, closed)
                Gui.getDocument(self.doc.Name).resetEdit()
        obj, panel = self.analyse()
        self.press(QtWidgets.QDialogButtonBox.Close)
        self.assertIsNone(obj.ViewObject.Proxy.panel)

    def test_widths_of_columns_are_those_of_the_user_only_after_a_drag(self):
        _, panel = self.analyse()
        table = panel.seam_table.table
        fitted = [table.columnWidth(column) for column in range(4)]
        buttons = mock.patch.object(QtWidgets.QApplication, "mouseButtons", lambda: 1)
        with buttons:  # the double click that opens a panel
            table.setColumnWidth(1, fitted[1] + 40)
        table.fit_columns()
        self.assertEqual([table.columnWidth(column) for column in range(4)], fitted)
        header = table.horizontalHeader()
        edge = QtCore.QPoint(header.sectionViewportPosition(1) - 1, header.height() // 2)
        for kind, place in (
            (QtCore.QEvent.MouseButtonPress, edge),
            (QtCore.QEvent.MouseMove, edge + QtCore.QPoint(20, 0)),
            (QtCore.QEvent.MouseButtonRelease, edge + QtCore.QPoint(20, 0)),
        ):
            event = QtGui.QMouseEvent(
                kind, place, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier
            )
            QtWidgets.QApplication.sendEvent(header.viewport(), event)
        table.fit_columns()
        self.assertEqual(table.columnWidth(0), fitted[0] + 20)
        panel.reject()

    def test_a_recompute_that_fails_does_not_close(self):
        obj, panel = self.analyse()
        panel.tolerances.fields["AngleTolerance"].setValue(10.0)  # above the crease angle
        self.press(QtWidgets.QDialogButtonBox.Close)
        self.answer("Recompute and close")
        self.assertIs(obj.ViewObject.Proxy.panel, panel)
        self.assertIn("crease", panel.summary.text())
        panel.tolerances.fields["AngleTolerance"].setValue(1.0)
        panel.recompute()
        settle()
        panel.reject()

    def test_escape_in_the_view_closes_and_asks_before(self):
        obj, panel = self.analyse()
        view = Gui.getMainWindow().findChild(QtWidgets.QGraphicsView)
        panel.tolerances.fields["AngleTolerance"].setValue(3.0)
        view.setFocus()
        press_escape()
        settle()
        self.assertIs(obj.ViewObject.Proxy.panel, panel)
        self.answer("Discard the changes")
        self.assertIsNone(obj.ViewObject.Proxy.panel)
        obj, panel = self.analyse()
        view.setFocus()
        press_escape()
        settle()
        self.assertIsNone(obj.ViewObject.Proxy.panel)

    def test_closing_the_panel_drops_selection_and_band(self):
        obj, panel = self.analyse()
        click_row(panel.seam_table.table, 0)
        panel.reject()
        settle()
        self.assertEqual(Gui.Selection.getSelection(), [])
        self.assertEqual(count(picture("closed"), (255, 217, 0)), 0)
        Gui.activeDocument().setEdit(obj.Name)
        settle()
        self.assertIsNotNone(obj.ViewObject.Proxy.panel)


class Commands(WindowCase):
    def test_each_tool_tip_says_what_the_command_does(self):
        for command in commands.COMMANDS:
            with self.subTest(command.name):
                texts = command().GetResources()
                self.assertRegex(texts["ToolTip"], r"^[A-Z].{60,}\.$")
                self.assertTrue(os.path.exists(texts["Pixmap"]))

    def test_the_menu_has_a_letter_of_its_own(self):
        texts = [action.text() for action in Gui.getMainWindow().menuBar().actions()]
        self.assertIn("&Seamwright", texts)
        letters = [text[text.index("&") + 1].upper() for text in texts if "&" in text]
        self.assertEqual(letters.count("S"), 1)

    def test_the_selected_object_alone_is_analysed(self):
        models.add(self.doc, models.three_classes(), "Prism")
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        Gui.Selection.addSelection(box)
        obj, _ = self.analyse()
        self.assertEqual((obj.Sources, obj.Seams), ([box], 12))

    def test_without_a_selection_the_objects_found_are_the_sources(self):
        prism = models.add(self.doc, models.three_classes(), "Prism")
        self.doc.recompute()
        obj, panel = self.analyse()
        self.assertEqual(obj.Sources, [prism])
        panel.reject()
        settle()
        self.doc.removeObject("Prism")
        self.doc.recompute()
        settle()
        self.assertEqual(obj.Outcome, "without result")
        self.assertIn("Prism was deleted", obj.Summary)
        self.assertEqual((obj.Seams, obj.Shape.isNull()), (0, True))

    def test_undo_takes_the_analysis_away(self):
        self.doc.UndoMode = 1
        models.add(self.doc, models.three_classes(), "Prism")
        obj, panel = self.analyse()
        panel.reject()
        settle()
        self.doc.undo()
        settle()
        self.assertEqual(analyses(self.doc), [])

    def test_nothing_to_analyse_is_one_message(self):
        Gui.runCommand("Seamwright_AnalyzeSeams")
        settle()
        texts = messages()
        self.assertEqual(len(texts), 1)
        self.assertIn("nothing to analyse", texts[0])
        self.assertEqual(self.doc.Objects, [])

    def test_a_missing_kernel_is_one_message(self):
        self.doc.addObject("Part::Box", "Box")
        with mock.patch.dict(sys.modules, seamwright=None):
            Gui.runCommand("Seamwright_AnalyzeSeams")
            settle()
        texts = messages()
        self.assertEqual(len(texts), 1)
        self.assertIn("It was built for Python", texts[0])
        self.assertNotIn("Traceback", texts[0])
        self.assertEqual(analyses(self.doc), [])

    def test_progress_keeps_keys_and_clicks_from_all_but_its_dialog(self):
        pressed = []
        button = QtWidgets.QPushButton("Button", Gui.getMainWindow())
        button.clicked.connect(lambda: pressed.append("button"))
        button.show()
        settle()
        with progress.progress_dialog("Recomputing") as report:
            QtCore.QTimer.singleShot(0, lambda: mouse(button, button.rect().center()))
            QtCore.QTimer.singleShot(0, Gui.getMainWindow().close)
            self.assertTrue(report(0.1))
            press_escape()
            report._next = 0.0
            self.assertFalse(report(0.2))
        self.assertTrue(Gui.getMainWindow().isVisible())
        self.assertEqual(pressed, [])
        click(button, button.rect().center())
        self.assertEqual(pressed, ["button"])
        button.deleteLater()

    def test_cancel_stops_an_analysis(self):
        with progress.progress_dialog("Analysing") as report:
            self.assertTrue(report(0.1))
            report._dialog.cancel()
            report._next = 0.0
            self.assertFalse(report(0.2))

    def test_only_the_newest_legend_is_shown(self):
        models.add(self.doc, models.three_classes(), "Prism")
        first, panel = self.analyse()
        panel.reject()
        second = analysis.create()
        self.assertFalse(first.ViewObject.ShowLegend)
        self.assertTrue(second.ViewObject.ShowLegend)


class Legend(WindowCase):
    def test_the_legend_leaves_fit_all_alone(self):
        prism = models.add(self.doc, models.three_classes(), "Prism")
        prism.Placement.Base.x = 5000
        self.doc.recompute()
        obj = analysis.create([prism])
        heights = []
        for shown in (True, False):
            obj.ViewObject.ShowLegend = shown
            settle()
            self.fit()
            heights.append(Gui.activeDocument().activeView().getCameraNode().height.getValue())
        self.assertAlmostEqual(heights[0], heights[1], delta=1e-3)
        self.assertLess(heights[0], 100)

    def test_hiding_hides_the_legend_and_showing_keeps_the_colours(self):
        models.add(self.doc, models.three_classes(), "Prism")
        obj = analysis.create()
        self.fit()
        obj.ViewObject.Visibility = False
        obj.touch()
        self.doc.recompute()
        settle()
        hidden = picture("hidden")
        obj.ViewObject.Visibility = True
        settle()
        shown = picture("shown")
        for seam_class in palette.CLASSES:
            self.assertEqual(count(hidden, seam_class.rgb), 0)
            self.assertGreater(count(shown, seam_class.rgb, LEGEND), FEW)
            self.assertGreater(count(shown, seam_class.rgb, MODEL), FEW)


os.makedirs(OUT, exist_ok=True)
