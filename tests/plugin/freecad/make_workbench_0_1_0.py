# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes tests/data/workbench_0_1_0.FCStd: one object of each kind, as version 0.1.0 saved them.

    python3 run_freecad.py --window --mod ADDON --out ../../data make_workbench_0_1_0

Documents name the modules of the objects' and of the views' classes. Later versions write other
names than 0.1.0 did, so the names are put back: saved_window_cases.py needs a document of 0.1.0.
"""

import os
import re
import tempfile
import unittest
import zipfile

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from window import settle

from freecad.seamwright.document import analysis, corner, fill, match, repair

NAME = "workbench_0_1_0.FCStd"

#: The modules that 0.1.0 wrote, by the name of the class.
MODULES = {
    "SeamAnalysis": "freecad.seamwright.document.analysis",
    "SeamRepair": "freecad.seamwright.document.repair",
    "MatchSurfaces": "freecad.seamwright.document.match",
    "UmbrellaFill": "freecad.seamwright.document.fill",
    "CornerFillet": "freecad.seamwright.document.corner",
    "SeamAnalysisView": "freecad.seamwright.gui.view_provider",
    "SeamRepairView": "freecad.seamwright.gui.repair_view",
    "MatchSurfacesView": "freecad.seamwright.gui.match_view",
    "UmbrellaFillView": "freecad.seamwright.gui.fill_view",
    "CornerFilletView": "freecad.seamwright.gui.corner_view",
}


def fill_document(doc):
    """Add the sources and one object of each kind, with results."""
    prism = models.add(doc, models.three_classes(), "Prism")
    panel = models.add(doc, models.broken_panel(across=2, along=1), "Panel")
    left, right = (
        models.add(doc, shape, name) for shape, name in zip(models.two_sheets(), ("Left", "Right"))
    )
    shell = models.add(doc, models.open_block(1), "Shell")
    cube = models.add(doc, Part.makeBox(10, 10, 10), "Cube")
    doc.recompute()
    analysis.create([prism], doc, level="G1", angle_deg=0.05)
    repair.create(panel, target="G1", max_move_mm=0.5)
    match.create((left, "Face1"), (right, "Face1"), target="G2", moves="both")
    fill.create(shell)
    corner.create(cube, "Vertex1", [1.0, 2.0, 3.0])


def as_written_by_0_1_0(name, content):
    """Return a member of the saved file with the names of the modules of 0.1.0."""
    if name not in ("Document.xml", "GuiDocument.xml"):
        return content
    text = re.sub(
        r'module="[^"]*" class="(\w+)"',
        lambda found: 'module="%s" class="%s"' % (MODULES[found.group(1)], found.group(1)),
        content.decode(),
    )
    return text.encode()


class Make(unittest.TestCase):
    def test_save(self):
        doc = App.newDocument("Saved")
        doc.License, doc.LicenseURL = "LGPL-2.1-or-later", ""
        fill_document(doc)
        settle()
        self.assertEqual([obj.Name for obj in doc.Objects if "Invalid" in obj.State], [])
        with tempfile.TemporaryDirectory() as folder:
            saved = os.path.join(folder, NAME)
            doc.saveAs(saved)
            target = os.path.join(os.environ["SEAMWRIGHT_TEST_OUT"], NAME)
            with zipfile.ZipFile(saved) as old, zipfile.ZipFile(
                target, "w", zipfile.ZIP_DEFLATED
            ) as new:
                for name in old.namelist():
                    if not name.startswith("thumbnails/"):
                        new.writestr(name, as_written_by_0_1_0(name, old.read(name)))
        Gui.getDocument(doc.Name).resetEdit()
        App.closeDocument(doc.Name)
