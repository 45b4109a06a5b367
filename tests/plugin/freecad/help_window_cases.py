# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts and help pages of all commands, in FreeCAD's window; run by run_freecad.py --window."""

import os
import pathlib
import re
from unittest import mock

import FreeCADGui as Gui
import models
from PySide import QtCore, QtGui
from window import WindowCase, click, settle, whole_window

from freecad.seamwright.document import analysis
from freecad.seamwright.gui import (
    analysis_commands,
    commands,
    curve_commands,
    help_window,
    surface_commands,
)
from freecad.seamwright.gui.widgets.qt import QtWidgets
from freecad.seamwright.plain import help_pages

ROOT = pathlib.Path(__file__).resolve().parents[3]


def all_names():
    """The names of all commands."""
    modules = (commands, curve_commands, surface_commands, analysis_commands, help_window)
    return [name for module in modules for name in module.register()]


class HelpCase(WindowCase):
    def windows(self):
        return Gui.getMainWindow().findChildren(help_window.HelpWindow)

    def tearDown(self):
        for window in self.windows():
            window.close()
        super().tearDown()

    def heading(self):
        """The first heading that the window shows."""
        (window,) = [each for each in self.windows() if each.isVisible()]
        block = window.pages.cursorForPosition(QtCore.QPoint(20, 20)).block()
        return block.text()

    def test_each_command_has_all_texts(self):
        names = all_names()
        self.assertGreater(len(names), 25)
        for name in names:
            with self.subTest(name):
                info = Gui.Command.get(name).getInfo()
                for key in ("menuText", "toolTip", "statusTip", "whatsThis", "pixmap"):
                    self.assertTrue(info[key], key)
                self.assertTrue(info["toolTip"].startswith(info["statusTip"]))
                self.assertRegex(info["statusTip"], r"^[A-Z][^.]+\.$")
                self.assertIn(help_pages.section_of(name), info["whatsThis"])

    def test_each_command_has_a_section(self):
        self.assertEqual(
            {"Seamwright_" + name for name in help_pages.SECTIONS}, set(all_names())
        )
        for folder in (ROOT / "docs", pathlib.Path(help_pages.folder())):
            for section in help_pages.SECTIONS.values():
                page, _, anchor = section.partition("#")
                text = (folder / page).read_text(encoding="utf-8")
                anchors = map(help_pages.anchor, re.findall(r"^#+ (.+)$", text, re.M))
                self.assertIn(anchor, ["", *anchors], section)

    def test_online_pages_are_those_of_the_package(self):
        package = (ROOT / "package.xml").read_text(encoding="utf-8")
        self.assertIn('"documentation">%sworkbench.md<' % help_pages.ONLINE, package)

    def test_help_opens_the_section_of_the_selected_object(self):
        source = models.add(self.doc, models.rounded_block(), "Block")
        self.doc.recompute()
        Gui.runCommand("Seamwright_Help")
        settle()
        self.assertEqual(self.heading(), "The FreeCAD workbench")
        obj = analysis.create([source], self.doc)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand("Seamwright_Help")
        settle()
        self.assertEqual(self.heading(), "Use")
        whole_window("help")
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle()
        self.assertTrue(Gui.Command.get("Seamwright_Help").isActive())
        obj.ViewObject.Proxy.panel.reject()
        settle()

    def test_links_and_back(self):
        Gui.runCommand("Seamwright_Help")
        settle()
        (window,) = [each for each in self.windows() if each.isVisible()]
        window.pages.go(QtCore.QUrl("seams.md#enclosures"))
        settle()
        self.assertEqual(self.heading(), "Enclosures")
        window.back.click()
        settle()
        self.assertTrue(window.pages.source().toLocalFile().endswith("workbench.md"))
        with mock.patch.object(QtGui.QDesktopServices, "openUrl") as opened:
            window.pages.go(QtCore.QUrl("https://example.org/"))
        opened.assert_called_once()

    def test_the_contents_lead_to_sections_and_the_window_can_be_closed(self):
        Gui.runCommand("Seamwright_Help")
        settle()
        (window,) = [each for each in self.windows() if each.isVisible()]
        tree = window.contents
        top = [tree.topLevelItem(place) for place in range(tree.topLevelItemCount())]
        opened = [item.text(0) for item in top if item.isExpanded()]
        self.assertEqual(opened, ["The FreeCAD workbench"])
        self.assertEqual(top[0].text(0), "The FreeCAD workbench")
        files = [each for each in os.listdir(help_pages.folder()) if each.endswith(".md")]
        self.assertEqual(len(top), len(files))
        (item,) = [each for each in top if each.text(0) == "Analysis tools in FreeCAD"]
        below = [item.child(place) for place in range(item.childCount())]
        (section,) = [each for each in below if each.text(0) == "Deviation"]
        tree.expandItem(item)
        tree.scrollToItem(section)
        click(tree.viewport(), tree.visualItemRect(section).center())
        self.assertEqual(self.heading(), "Deviation")
        self.assertTrue(item.isExpanded())
        self.assertIs(tree.currentItem(), section)
        whole_window("help-contents")
        (box,) = window.findChildren(QtWidgets.QDialogButtonBox)
        box.button(QtWidgets.QDialogButtonBox.Close).click()
        self.assertFalse(window.isVisible())

    def test_the_contents_mark_the_section_that_is_shown(self):
        Gui.runCommand("Seamwright_Help")
        settle()
        (window,) = [each for each in self.windows() if each.isVisible()]
        pages, marked = window.pages, window.contents.currentItem
        for address, text in (
            ("freecad_analysis.md#deviation", "Deviation"),
            ("freecad_analysis.md", "Analysis tools in FreeCAD"),
            ("workbench.md#repair-seams", "Repair Seams"),
        ):
            pages.go(QtCore.QUrl(address))
            settle()
            self.assertEqual(marked().text(0), text)
        item = marked().parent()
        last = item.child(item.childCount() - 1)
        pages.go(QtCore.QUrl(help_pages.address(last.data(0, QtCore.Qt.UserRole))))
        settle()
        self.assertIs(marked(), last, "though the page ends before it is at the top")
        pages.verticalScrollBar().setValue(pages.verticalScrollBar().value() // 2)
        settle()
        self.assertNotIn(marked(), (last, item))
        whole_window("help-section")
        pages.verticalScrollBar().setValue(0)
        settle()
        self.assertIs(marked(), item)

    def test_every_section_of_the_contents_exists(self):
        for page, _, sections in help_pages.contents():
            text = (pathlib.Path(help_pages.folder()) / page).read_text(encoding="utf-8")
            anchors = list(map(help_pages.anchor, re.findall(r"^#+ (.+)$", text, re.M)))
            for _, anchor in sections:
                self.assertIn(anchor, anchors, page)

    def test_without_pages_the_repository_is_opened(self):
        with mock.patch.object(help_pages, "folder", return_value=None):
            with mock.patch.object(QtGui.QDesktopServices, "openUrl") as opened:
                Gui.runCommand("Seamwright_Help")
        (url,) = opened.call_args.args
        self.assertEqual(url.toString(), help_pages.ONLINE + "workbench.md")

    def test_pictures_fit(self):
        Gui.runCommand("Seamwright_Help")
        settle()
        (window,) = [each for each in self.windows() if each.isVisible()]
        self.assertEqual(window.pages.horizontalScrollBar().maximum(), 0)
        self.assertTrue(os.path.isdir(os.path.join(help_pages.folder(), "images")))
        self.assertIsInstance(window, QtWidgets.QDialog)
