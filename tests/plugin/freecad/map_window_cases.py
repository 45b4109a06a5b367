# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis tools in FreeCAD's window; run by run_freecad.py --window."""

import FreeCAD as App
import FreeCADGui as Gui
import models
import Part
from window import PanelWindow, messages, picture, settle, whole_window

from freecad.seamwright.document.maps import tool


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

    def set_field(self, panel, argument, value):
        panel.options.fields[argument].show_value(value)
        settle(0.5)


class Look(MapWindow):
    def test_look(self):
        for kind in ("CurvatureMap", "ReflectionLines", "DraftAngle"):
            obj, panel = self.start(kind)
            print(obj.Summary)
            whole_window("look-" + kind)
            if kind == "ReflectionLines":
                for lines in ("Isophotes", "Highlight lines"):
                    self.set_field(panel, "lines", lines)
                    whole_window("look-" + lines)
            self.ok()
            picture("look-after-" + kind)
        obj, panel = self.start("CurvatureComb", (self.sheets[0], "Face1"), (self.block, "Edge3"))
        whole_window("look-comb")
        self.ok()
        obj, panel = self.start("Deviation", (self.sheets[0], ""), (self.sheets[1], ""))
        whole_window("look-deviation")
        self.ok()
        obj, panel = self.start("SeamPlot", (self.block, "Edge3"))
        whole_window("look-plot")
        self.ok()
