# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view and the table of an analysis show, in FreeCAD's window.

Run by run_freecad.py --window.
"""

import os
import tempfile
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from pivy import coin
from PySide import QtCore, QtGui
from window import (
    WindowCase, analyses, camera, click, click_row, count, picture, settle,
    whole_window
)  # fmt: skip

from freecad.seamwright.document import analysis, fill, repair
from freecad.seamwright.gui.analysis import view
from freecad.seamwright.gui.scene import marker, seam_view
from freecad.seamwright.gui.widgets import tasks
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import labels, palette, rows

MODEL = QtCore.QRect(0, 145, 1200, 655)
LEGEND = QtCore.QRect(0, 0, 420, 140)
FEW = 60  # pixels of a short line
BAND = (255, 217, 0)


class LookCase(WindowCase):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.prism = models.add(self.doc, models.three_classes(), "Prism")
        self.doc.recompute()
        self.fit()

    def pixels(self, entries, name="look", area=MODEL):
        image = picture(name)
        return {entry.key: count(image, entry.rgb, area) for entry in entries}

    def classes(self):
        return {key for key, number in self.pixels(palette.CLASSES).items() if number > FEW}


class Look(LookCase):
    def test_colours_by_level_have_a_legend_and_come_back(self):
        obj, panel = self.analyse()
        panel.look.colours.setCurrentText("Level")
        panel.look.colours.activated.emit(1)
        settle()
        self.assertEqual(obj.ViewObject.ColourBy, "Level")
        levels = {seam["level"] for seam in analysis.report_of(obj)["seams"]}
        shown = self.pixels(palette.LEVELS)
        self.assertEqual({key for key, number in shown.items() if number > FEW}, levels)
        in_legend = self.pixels(palette.LEVELS, area=LEGEND)
        self.assertTrue(all(number > FEW for number in in_legend.values()), in_legend)
        whole_window("window-levels")
        self.doc.undo()
        settle()
        self.assertEqual(obj.ViewObject.ColourBy, "Class")
        self.assertEqual(panel.look.colours.currentText(), "Class")
        self.assertEqual(self.classes(), {"defect", "crease", "smooth"})

    def test_show_filters_table_and_view(self):
        obj, panel = self.analyse()
        for name, expected, left in (
            ("Not smooth", {"defect", "crease"}, obj.Defects + obj.Creases),
            ("Smooth", {"smooth"}, 2),
            ("Uncertain", set(), 0),
            ("All seams", {"defect", "crease", "smooth"}, obj.Seams),
        ):
            panel.seam_table.filter.setCurrentText(
                next(
                    panel.seam_table.filter.itemText(place)
                    for place in range(panel.seam_table.filter.count())
                    if panel.seam_table.filter.itemText(place).startswith(name)
                )
            )
            settle()
            with self.subTest(name):
                self.assertEqual(obj.ViewObject.Show, name)
                self.assertEqual(self.classes(), expected)
                self.assertEqual(panel.seam_table.model.rowCount(), left)
        obj.ViewObject.Show = "Defect"
        settle()
        self.assertEqual(panel.seam_table.filter.currentData(), "defect")
        self.assertEqual(panel.seam_table.model.rowCount(), 1)

    def test_a_picked_line_has_the_number_of_its_edge_whatever_is_hidden(self):
        obj, _ = self.analyse()
        report = analysis.report_of(obj)
        defect = next(seam for seam in report["seams"] if seam["class"] == "defect")
        (number,) = defect["edges"]
        place = list(analysis.results_of(obj).lines).index(number)
        self.prism.ViewObject.Visibility = False
        self.fit()
        active = Gui.activeDocument().activeView()
        at = active.getPointOnScreen(*defect["worst"]["point"])
        for name in ("All seams", "Not smooth"):
            obj.ViewObject.Show = name
            settle()
            found = active.getObjectInfo(at)
            self.assertEqual(found["Component"], "Edge%d" % (place + 1))

    def test_a_line_leaves_the_mouse_to_the_edge_on_which_it_lies(self):
        obj, panel = self.analyse()
        self.fit()
        active, picked = Gui.activeDocument().activeView(), {}
        for seam in analysis.report_of(obj)["seams"]:
            points = analysis.results_of(obj).lines[seam["edges"][0]]
            middle = [(a + b) / 2 for a, b in zip(*points[:2])]
            if len(points) == 2:
                found = active.getObjectInfo(active.getPointOnScreen(*middle)) or {}
                picked[seam["id"]] = found.get("Object"), found.get("Component")
        seen = [each for each in picked.values() if each[0] == self.prism.Name]
        edges = [each for each in seen if each[1].startswith("Edge")]
        self.assertEqual({name for name, _ in picked.values()}, {self.prism.Name})
        self.assertGreater(len(edges), 5)
        name, edge = edges[0]
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.Name, name, edge)
        settle()
        (row,) = panel.seam_table.chosen_rows()
        self.assertEqual(row.edges[0], int(edge[4:]))

    def test_labels_at_the_worst_seams_and_at_the_chosen_ones(self):
        obj, panel = self.analyse()
        without = count(picture("unlabelled"), marker.INK, MODEL)
        panel.look.labels.setValue(3)
        settle()
        self.assertEqual(obj.ViewObject.WorstLabels, 3)
        self.assertGreater(count(picture("labelled"), marker.INK, MODEL), without + 3 * FEW)
        marks = _marks(obj.ViewObject.Proxy.labels)
        self.assertEqual(marks, 3)
        obj.ViewObject.Visibility = False
        settle()
        self.assertEqual(_marks(obj.ViewObject.Proxy.labels), 0)
        obj.ViewObject.Visibility = True
        settle()
        self.assertEqual(_marks(obj.ViewObject.Proxy.labels), 3)
        obj.ViewObject.Show = "Defect"
        settle()
        self.assertEqual(_marks(obj.ViewObject.Proxy.labels), 1)
        obj.ViewObject.Show = "All seams"
        settle()
        panel.seam_table.table.selectAll()
        settle()
        worst = sum(bool(seam["worst"]) for seam in panel.results.seams.values())
        self.assertEqual(_marks(obj.ViewObject.Proxy.marker), worst)
        whole_window("window-labels")

    def test_near_labels_stand_below_each_other_the_worst_on_top(self):
        obj, panel = self.analyse()
        shown = []
        with mock.patch.object(marker, "draw_label", _drawn_into(shown)):
            with mock.patch.object(labels, "NEAR", 2.0):
                panel.look.labels.setValue(3)
                settle()
        rows = panel.results.rows[:3]
        seams = [panel.results.seams[row.seam] for row in rows]
        texts = [text for _, text in seam_view.worst_marks(panel.results.report, seams)]
        # What is drawn last is on top.
        self.assertEqual(shown, list(zip(texts, (0, 1, 2)))[::-1])

    def test_the_look_is_saved(self):
        obj, panel = self.analyse()
        look = obj.ViewObject
        look.ColourBy, look.Show, look.WorstLabels = "Level", "Not smooth", 2
        panel.reject()
        settle()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "look.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            settle()
            (obj,) = analyses(self.doc)
            look = obj.ViewObject
            self.assertEqual(
                (look.ColourBy, look.Show, look.WorstLabels, look.DisplayMode),
                ("Level", "Not smooth", 2, view.SEAMS),
            )
            self.fit()
            self.assertEqual(_marks(look.Proxy.labels), 2)
            shown = self.pixels(palette.LEVELS)
            # The seams at the level G2 are the smooth ones.
            self.assertEqual({key for key, number in shown.items() if number > FEW}, {"G0"})
            Gui.getDocument(self.doc.Name).setEdit(obj.Name)
            settle()
            self.assertEqual(look.Proxy.panel.seam_table.model.rowCount(), 16)

    def test_a_hidden_analysis_keeps_its_table_when_it_is_opened_again(self):
        obj, panel = self.analyse()
        count = panel.seam_table.model.rowCount()
        self.assertFalse(panel.hidden.isVisible())
        obj.ViewObject.Visibility = False
        settle()
        self.assertTrue(panel.hidden.isVisible())
        panel.reject()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hidden.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            settle()
            (obj,) = analyses(self.doc)
            obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
            settle()
            panel = obj.ViewObject.Proxy.panel
            self.assertEqual(panel.seam_table.model.rowCount(), count)
            self.assertEqual(len(panel.results.seams), count)
            self.assertFalse(obj.ViewObject.Visibility)
            panel.reject()
            settle()


def _drawn_into(shown):
    draw = marker.draw_label

    def drawn(text, line):
        shown.append((text, line))
        return draw(text, line)

    return drawn


def _marks(shown):
    return shown._marks.getNumChildren()


class Beside(LookCase):
    """The lines stay when the panel closes, and beside the panels of other commands."""

    def test_other_panels_leave_the_lines_as_they_are(self):
        obj, panel = self.analyse()
        panel.reject()
        settle()
        self.assertEqual(self.classes(), {"defect", "crease", "smooth"})
        for command, is_made in (
            ("Seamwright_RepairSeams", repair.is_repair),
            ("Seamwright_UmbrellaFill", fill.is_fill),
        ):
            with self.subTest(command):
                Gui.Selection.addSelection(self.prism, "Face1")
                Gui.runCommand(command)
                settle()
                self.assertTrue(any(is_made(each) for each in self.doc.Objects))
                self.assertTrue(obj.ViewObject.Visibility)
                self.assertEqual(self.classes(), {"defect", "crease", "smooth"})
                self.cancel()
                self.assertEqual(self.classes(), {"defect", "crease", "smooth"})

    def test_a_second_analysis_beside_the_first(self):
        first, panel = self.analyse()
        panel.reject()
        settle()
        second, _ = self.analyse()
        self.assertNotEqual(first, second)
        self.assertTrue(first.ViewObject.Visibility and second.ViewObject.Visibility)


class Table(LookCase):
    def key(self, panel, key, modifiers=QtCore.Qt.NoModifier):
        table = panel.seam_table.table
        table.setFocus()
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, modifiers)
            QtWidgets.QApplication.sendEvent(table, event)
        settle()

    def chosen(self, panel):
        return [row.seam for row in panel.seam_table.chosen_rows()]

    def test_the_columns_fit_the_panel(self):
        _, panel = self.analyse()
        table = panel.seam_table.table
        header, room = table.horizontalHeader(), table.viewport().width()
        # The panel of FreeCAD 1.1 is narrower: there the figures fit, the rest is scrolled to.
        last = header.count() - 1 if room > 400 else 3
        self.assertLessEqual(header.sectionPosition(last) + header.sectionSize(last), room)
        index, row = panel.seam_table.model.index(0, 9), panel.seam_table.model.row(0)
        tip = index.data(QtCore.Qt.ToolTipRole)
        self.assertIn("%s, %s" % (row.edge_text, row.face_text), tip)
        whole_window("window-table")

    def test_wide_enclosures_leave_room_for_the_columns_behind_them(self):
        _, panel = self.analyse()
        table, shown = panel.seam_table.table, panel.seam_table.filter

        def text(row, _):
            return "0.00918..0.00952" if row.seam_class == "smooth" else "1"

        with mock.patch.object(rows.Row, "figure_text", text):
            panel.refresh()
            if table.viewport().width() > 400:
                self.assertEqual(table.horizontalScrollBar().maximum(), 0)
            whole_window("window-enclosures")
            wide = table.columnWidth(2)
            shown.setCurrentIndex(shown.findData("defect"))
            settle()
            self.assertLess(table.columnWidth(2), wide)

    def test_the_keys_move_zoom_and_copy(self):
        obj, panel = self.analyse()
        click_row(panel.seam_table.table, 0)
        first, before = self.chosen(panel), camera()
        self.key(panel, QtCore.Qt.Key_Down)
        self.assertEqual(camera(), before)
        self.assertNotEqual(self.chosen(panel), first)
        (seam,) = self.chosen(panel)
        (edge,) = panel.results.seams[seam]["edges"]
        (picked,) = Gui.Selection.getSelectionEx()
        self.assertEqual(picked.SubElementNames, ("Edge%d" % edge,))
        self.key(panel, QtCore.Qt.Key_Return)
        self.assertNotEqual(camera(), before)
        self.assertTrue(Gui.Control.activeDialog())
        self.key(panel, QtCore.Qt.Key_C, QtCore.Qt.ControlModifier)
        text = QtWidgets.QApplication.clipboard().text()
        self.assertEqual(len(text.split("\n")), 2)
        self.assertEqual(text.split("\n")[1].split("\t")[0], str(seam))
        self.key(panel, QtCore.Qt.Key_A, QtCore.Qt.ControlModifier)
        self.assertEqual(len(self.chosen(panel)), obj.Seams)

    def test_the_keys_of_the_table_are_kept_from_the_window(self):
        _, panel = self.analyse()
        for key in (QtCore.Qt.Key_C, QtCore.Qt.Key_A):
            event = QtGui.QKeyEvent(
                QtCore.QEvent.ShortcutOverride, key, QtCore.Qt.ControlModifier
            )
            event.ignore()
            QtWidgets.QApplication.sendEvent(panel.seam_table.table, event)
            self.assertTrue(event.isAccepted())

    def test_the_context_menu(self):
        obj, panel = self.analyse()
        table = panel.seam_table.table

        def ask(key):
            menu = table.build_menu()
            (action,) = [each for each in menu.actions() if each.objectName() == key]
            action.trigger()
            settle()

        menu = table.build_menu()
        able = {each.objectName(): each.isEnabled() for each in menu.actions() if each.text()}
        self.assertFalse(able["copy"] or able["zoom"] or able["repair"])
        self.assertTrue(able["all"] and able["csv"])
        click_row(table, 2)
        (seam,) = self.chosen(panel)
        before = camera()
        Gui.Selection.clearSelection()
        ask("select")
        self.assertEqual(camera(), before)
        self.assertEqual(len(Gui.Selection.getSelectionEx()), 1)
        ask("copy")
        self.assertIn("\n%d\t" % seam, QtWidgets.QApplication.clipboard().text())
        with mock.patch.object(QtWidgets.QFileDialog, "getSaveFileName") as dialog:
            dialog.return_value = ("", "")
            ask("csv")
            ask("json")
            self.assertEqual(dialog.call_count, 2)
        Gui.activeDocument().activeView().viewTop()
        settle()
        before = camera()
        ask("zoom")
        self.assertNotEqual(camera(), before)
        ask("repair")
        (made,) = [each for each in self.doc.Objects if repair.is_repair(each)]
        edge = "Edge%d" % panel.results.seams[seam]["edges"][0]
        self.assertEqual(made.Edges[1], [edge])
        self.cancel()

    def test_the_right_button_opens_the_context_menu(self):
        _, panel = self.analyse()
        viewport = panel.seam_table.table.viewport()
        where = viewport.rect().center()
        event = QtGui.QContextMenuEvent(
            QtGui.QContextMenuEvent.Mouse, where, viewport.mapToGlobal(where)
        )
        QtWidgets.QApplication.sendEvent(viewport, event)
        settle()
        menu = QtWidgets.QApplication.activePopupWidget()
        self.assertIn("Select all", [action.text() for action in menu.actions()])
        menu.close()
        settle()

    def test_a_new_order_keeps_the_chosen_rows(self):
        _, panel = self.analyse()
        click_row(panel.seam_table.table, 0)
        chosen = self.chosen(panel)
        panel.seam_table.table.sortByColumn(10, QtCore.Qt.DescendingOrder)
        self.assertEqual(self.chosen(panel), chosen)
        obj_filter = panel.seam_table.filter
        obj_filter.setCurrentIndex(obj_filter.findData("smooth"))
        settle()
        self.assertEqual(self.chosen(panel), [])
        self.assertEqual(Gui.Selection.getSelection(), [])
        self.assertEqual(count(picture("filtered"), BAND), 0)


    def test_a_new_analysis_keeps_the_chosen_rows(self):
        obj, panel = self.analyse()
        click_row(panel.seam_table.table, 3)
        chosen, before = self.chosen(panel), camera()
        panel.tolerances.fields["CreaseAngle"].setValue(0.5)
        panel.recompute()
        settle()
        self.assertEqual(obj.CreaseAngle.Value, 0.5)
        self.assertEqual(self.chosen(panel), chosen)
        self.assertEqual(camera(), before)
        (picked,) = Gui.Selection.getSelectionEx()
        (edge,) = panel.results.seams[chosen[0]]["edges"]
        self.assertEqual(picked.SubElementNames, ("Edge%d" % edge,))
        self.assertEqual(_marks(obj.ViewObject.Proxy.marker), 1)
        self.assertGreater(count(picture("kept"), BAND), FEW)


class Gone(LookCase):
    def test_the_rows_of_a_deleted_source(self):
        obj, panel = self.analyse()
        self.doc.removeObject(self.prism.Name)
        settle()
        click_row(panel.seam_table.table, 0)
        self.assertEqual(Gui.Selection.getSelection(), [])
        self.assertGreater(count(picture("gone"), BAND), FEW)
        click(panel.recompute_button, QtCore.QPoint(5, 5))
        self.assertIn("Prism was deleted", panel.summary.text())
        self.assertEqual(panel.seam_table.model.rowCount(), 0)
        self.assertEqual(count(picture("gone"), BAND), 0)
        self.assertEqual(self.classes(), set())

    def test_undo_of_a_look_and_of_an_analysis(self):
        obj, panel = self.analyse()
        panel.look.labels.setValue(2)
        settle()
        panel.seam_table.filter.setCurrentIndex(1)
        settle()
        self.doc.undo()
        settle()
        self.assertEqual((obj.ViewObject.Show, obj.ViewObject.WorstLabels), ("All seams", 2))
        self.assertEqual(panel.seam_table.filter.currentIndex(), 0)
        self.doc.undo()
        settle()
        self.assertEqual((obj.ViewObject.WorstLabels, panel.look.labels.value()), (0, 0))
        panel.reject()
        settle()
        self.doc.undo()
        settle()
        self.assertEqual(analyses(self.doc), [])


#: A gap between faces of ``LooseFaces``.
class Many(LookCase):
    """The work does not grow where it would make the window stand still."""

    def setUp(self):
        super().setUp()
        blocks = []
        for place in range(12):
            blocks.append(models.rounded_block(8.0, 1.5))
            blocks[-1].translate(App.Vector(10 * place, 0, 0))
        self.prism.Shape = Part.Compound(blocks)
        self.doc.recompute()
        self.fit()

    def nodes(self, obj):
        found = coin.SoSearchAction()
        found.setType(coin.SoNode.getClassTypeId())
        found.setInterest(coin.SoSearchAction.ALL)
        found.setSearchingAll(True)
        found.apply(obj.ViewObject.Proxy.lines.node)
        return found.getPaths().getLength()

    def test_the_number_of_nodes_does_not_depend_on_the_number_of_seams(self):
        obj, panel = self.analyse()
        many = self.nodes(obj)
        self.assertEqual(obj.Seams, 576)
        panel.reject()
        self.prism.Shape = Part.makeBox(1, 1, 1)
        self.doc.recompute()
        settle()
        self.assertEqual(obj.Seams, 12)
        self.assertEqual(self.nodes(obj), many)

    def test_many_rows_are_selected_in_one_call(self):
        obj, panel = self.analyse()
        with mock.patch.object(
            Gui.Selection, "addSelection", wraps=Gui.Selection.addSelection
        ) as add:
            panel.seam_table.table.selectAll()
            settle()
            self.assertEqual(add.call_count, 1)
        self.assertEqual(len(Gui.Selection.getSelectionEx()[0].SubElementNames), obj.Seams)
        self.assertLessEqual(_marks(obj.ViewObject.Proxy.marker), seam_view.LABELLED_MOST)

    def test_too_many_rows_are_marked_and_repaired_but_not_selected(self):
        obj, panel = self.analyse()
        with mock.patch.object(seam_view, "SELECTED_MOST", 100):
            before = camera()
            panel.seam_table.table.selectAll()
            settle()
            self.assertEqual(len(Gui.Selection.getSelectionEx()[0].SubElementNames), 100)
            self.assertEqual(camera(), before)
            self.assertGreater(count(picture("many"), BAND), 10 * FEW)
            self.assertEqual(len(panel.chosen_elements()), obj.Seams)
            Gui.runCommand("Seamwright_RepairSeams")
            settle()
        (made,) = [each for each in self.doc.Objects if repair.is_repair(each)]
        self.assertEqual(len(made.Edges[1]), obj.Seams)
        self.cancel()

    def test_texts_are_made_only_of_the_rows_that_are_seen(self):
        with mock.patch(
            "freecad.seamwright.plain.rows.figure_text", return_value="1"
        ) as text:
            obj, panel = self.analyse()
        self.assertLess(text.call_count, 3 * obj.Seams)

    def test_a_long_report_is_read_in_a_thread_when_it_is_opened(self):
        obj, panel = self.analyse()
        panel.reject()
        settle()
        with mock.patch.object(view, "AT_ONCE", 1000):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "many.FCStd")
                self.doc.saveAs(path)
                App.closeDocument(self.doc.Name)
                with mock.patch.object(
                    tasks.tasks, "start", wraps=tasks.tasks.start
                ) as start:
                    self.doc = App.openDocument(path)
                    (obj,) = analyses(self.doc)
                    Gui.getDocument(self.doc.Name).setEdit(obj.Name)
                    settle()
                    self.assertEqual(start.call_count, 1)
            panel = obj.ViewObject.Proxy.panel
            self.assertEqual(panel.seam_table.model.rowCount(), obj.Seams)
            self.fit()
            self.assertEqual(self.classes(), {"smooth"})
