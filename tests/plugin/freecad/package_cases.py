# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD and its Addon Manager read in package.xml: of the repository, and of the addon."""

import datetime
import pathlib
import re
import unittest
from xml.etree import ElementTree

import FreeCAD as App

import freecad.seamwright

ROOT = pathlib.Path(__file__).resolve().parents[3]
ADDON = pathlib.Path(freecad.seamwright.__file__).resolve().parents[2]
SPACE = "{https://wiki.freecad.org/Package_Metadata}"

#: What the Addon Manager requires or shows.
REQUIRED = (
    "name", "description", "version", "date", "maintainer", "license", "url", "icon", "content"
)  # fmt: skip
URLS = {"repository", "readme", "documentation", "bugtracker"}
WORKBENCH = {"classname", "subdirectory", "icon", "freecadmin", "tag"}


class PackageCases(unittest.TestCase):
    def each(self):
        for folder in (ROOT, ADDON):
            with self.subTest(folder=str(folder)):
                yield folder, App.Metadata(str(folder / "package.xml"))

    def test_has_all_fields(self):
        for folder, _ in self.each():
            package = ElementTree.parse(folder / "package.xml").getroot()
            self.assertEqual(package.get("format"), "1")
            for name in REQUIRED:
                self.assertIsNotNone(package.find(SPACE + name), name)
            date = datetime.date.fromisoformat(package.find(SPACE + "date").text)
            self.assertLessEqual(datetime.date(2026, 11, 21), date)
            (workbench,) = package.find(SPACE + "content")
            self.assertLessEqual(WORKBENCH, {each.tag.removeprefix(SPACE) for each in workbench})

    def test_freecad_reads_it(self):
        for folder, package in self.each():
            self.assertEqual(package.Name, "Seamwright")
            self.assertTrue(package.Description)
            self.assertRegex(package.Maintainer[0]["email"], r"^\S+@\S+$")
            (licence,) = package.License
            self.assertEqual(licence["name"], "LGPL-2.1-or-later")
            self.assertTrue((folder / licence["file"]).is_file())
            self.assertTrue(package.supportsCurrentFreeCAD())
            urls = {each["type"]: each for each in package.Urls}
            self.assertEqual(set(urls), URLS)
            self.assertEqual(urls["repository"]["branch"], "main")

    def test_its_paths_exist(self):
        for folder, package in self.each():
            self.assertTrue((folder / package.Icon).is_file(), package.Icon)
            (workbench,) = package.Content["workbench"]
            below = folder / workbench.Subdirectory
            self.assertTrue((below / workbench.Icon).is_file(), workbench.Icon)
            start = below / "freecad" / "seamwright" / "init_gui.py"
            self.assertIn("class %s(" % workbench.Classname, start.read_text(encoding="utf-8"))
            self.assertTrue(workbench.supportsCurrentFreeCAD())

    def test_version_is_that_of_the_project(self):
        cmake = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        (version,) = re.findall(r"project\(Seamwright VERSION (\S+)", cmake)
        for _, package in self.each():
            self.assertEqual(package.Version, version)
            self.assertEqual(freecad.seamwright.__version__, version)

    def test_addon_differs_only_in_paths(self):
        texts = [(folder / "package.xml").read_text(encoding="utf-8") for folder in (ROOT, ADDON)]
        lines = [text.splitlines() for text in texts]
        self.assertEqual(len(lines[0]), len(lines[1]))
        changed = [here.strip() for here, there in zip(*lines) if here != there]
        names = [re.match(r"<(\w+)>", line)[1] for line in changed]
        self.assertEqual(names, ["icon", "subdirectory"])
