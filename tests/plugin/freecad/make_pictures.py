# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the task panels for the documentation, on a screen of 1600 x 1000.

    python3 run_freecad.py --window --mod ADDON --out FOLDER make_pictures

writes workbench.png, repair.png, match.png, fill_freecad.png, corner_fillet_freecad.png,
spline_freecad.png, blend_freecad.png, blend_surface_freecad.png, umbrella_g2_freecad.png,
seam_plot.png, and of the samples 33 and 34 handles_freecad.png, umbrella_freecad.png and
loft_freecad.png, to be looked at and moved
to docs/images. For repair_curvature.png it writes the models:

    seam-picture --pair FOLDER/before.brep FOLDER/after.brep repair_curvature.png --curvature ...

For analysis_tools.png samples/35_analysis.FCMacro writes six pictures, which ImageMagick joins:

    montage CurvatureComb.png CurvatureMap.png ReflectionLines.png DraftAngle.png Deviation.png
        HighlightLines.png -depth 8 -tile 3x2 -geometry 520x+4+4 analysis_tools.png
"""

import math
import os
import pathlib

import FreeCAD as App
import FreeCADGui as Gui
import ImportGui
import models
import Part
from free_surface_cases import bowl
from PySide import QtCore
from surface_cases import at_x, sheet
from window import OUT, PanelWindow, click_row, settle, whole_window
from window_cases import STEP

from freecad.seamwright.document import corner, fill, match, repair
from freecad.seamwright.document.curves import curve, kinds
from freecad.seamwright.document.maps import tool
from freecad.seamwright.document.surfaces import kinds as surface_kinds
from freecad.seamwright.document.surfaces import surface
from freecad.seamwright.gui.corner.panel import RADIUS
from freecad.seamwright.gui.scene.zebra import zebra
from freecad.seamwright.gui.widgets.dock import dock_of

GREY = (0.7, 0.7, 0.7)
SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"


def take(name):
    """Save the whole window once everything is drawn."""
    settle(1.0)
    whole_window(name)


def open_block():
    """A block with a hole between three fillets of different radii."""
    box = Part.makeBox(30, 24, 20)
    corner_point = App.Vector(30, 0, 20)
    edges = [
        edge
        for edge in box.Edges
        if any(vertex.Point.isEqual(corner_point, 1e-9) for vertex in edge.Vertexes)
    ]
    doc = App.newDocument("Fillet", hidden=True)
    source = models.add(doc, box, "Box")
    rounded = doc.addObject("Part::Fillet", "Rounded")
    rounded.Base = source
    numbers = [n for n, edge in enumerate(box.Edges, 1) if any(edge.isSame(e) for e in edges)]
    rounded.Edges = [(n, radius, radius) for n, radius in zip(numbers, (4.0, 6.0, 9.0))]
    doc.recompute()
    kinds = ("Part::GeomPlane", "Part::GeomCylinder")
    shell = Part.makeShell([f for f in rounded.Shape.Faces if f.Surface.TypeId in kinds])
    App.closeDocument(doc.Name)
    return shell


class AnalysisPicture(PanelWindow):
    def test_workbench(self):
        ImportGui.insert(STEP, self.doc.Name)
        self.doc.recompute()
        self.fit()
        _, panel = self.analyse()
        click_row(panel.seam_table.table, 3)
        take("workbench")
        panel.reject()


class RepairPicture(PanelWindow):
    COMMAND = "Seamwright_RepairSeams"
    is_made = staticmethod(repair.is_repair)

    def test_repair(self):
        source = models.add(self.doc, models.broken_panel(), "Panel")
        source.ViewObject.ShapeColor = GREY
        self.doc.recompute()
        self.fit()
        obj, panel = self.run_selected([(source, "")])
        Gui.getMainWindow().resizeDocks([dock_of(panel.form)], [820], QtCore.Qt.Horizontal)
        self.fit()
        self.preview(panel)
        take("repair")
        for shape, name in ((source.Shape, "before.brep"), (obj.Shape, "after.brep")):
            shape.exportBrep(os.path.join(OUT, name))
        self.cancel()


class MatchPicture(PanelWindow):
    COMMAND = "Seamwright_MatchSurfaces"
    is_made = staticmethod(match.is_match)

    def test_match(self):
        shapes = models.sheet(-1), models.sheet(1, slope_deg=3.0, bend=0.002)
        sheets = [
            models.add(self.doc, shape, name) for shape, name in zip(shapes, ("Left", "Right"))
        ]
        self.doc.recompute()
        self.fit()
        _, panel = self.run_selected([(sheet, "Face1") for sheet in sheets])
        panel.tolerances.level.setCurrentText("G2")
        settle(1.0)
        panel.zebra.setChecked(True)
        take("match")
        self.cancel()


class FillPicture(PanelWindow):
    COMMAND = "Seamwright_UmbrellaFill"
    is_made = staticmethod(fill.is_fill)

    def test_fill(self):
        shell = open_block()
        App.setActiveDocument(self.doc.Name)
        source = models.add(self.doc, shell, "Block")
        source.ViewObject.ShapeColor = GREY
        self.doc.recompute()
        self.fit()
        _, panel = self.run_selected([(source, "")])
        self.preview(panel)
        take("fill_freecad")
        self.cancel()


class CornerPicture(PanelWindow):
    COMMAND = "Seamwright_CornerFillet"
    is_made = staticmethod(corner.is_corner)

    def test_corner(self):
        source = models.add(self.doc, Part.makeBox(10, 10, 10), "Cube")
        source.ViewObject.ShapeColor = GREY
        self.doc.recompute()
        self.fit()
        near = App.Vector(10, 0, 10)
        (number,) = [
            n for n, v in enumerate(source.Shape.Vertexes, 1) if v.Point.isEqual(near, 1e-9)
        ]
        _, panel = self.run_selected([(source, "Vertex%d" % number)])
        for field, radius in zip(panel.fields[RADIUS], (1.0, 2.0, 3.0)):
            field.setValue(radius)
        self.preview(panel)
        take("corner_fillet_freecad")
        self.cancel()


def airfoil(thickness, camber, chord, height, count=30):
    """Points of an airfoil of the NACA series of four digits, with a sharp trailing edge."""
    points = []
    for k in range(2 * count):
        x = (1 + math.cos(math.pi * k / count)) / 2
        half = 5 * thickness * (0.2969 * x**0.5 - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3)
        half -= 5 * thickness * 0.1036 * x**4
        ramp = 0.8 * x - x * x if x < 0.4 else (0.2 + 0.8 * x - x * x) / 2.25
        y = camber / 0.16 * ramp + (half if k < count else -half)
        points.append(App.Vector(chord * x, chord * y, height))
    return points


class CurvePicture(PanelWindow):
    is_made = staticmethod(curve.is_curve)

    def points(self, places, name):
        points = Part.Compound([Part.Vertex(place) for place in places])
        return models.add(self.doc, points, name)

    def test_spline(self):
        self.COMMAND = "Seamwright_Spline"
        places = ((0, 0), (10, 22), (26, 18), (34, 2), (52, 6), (70, 26), (88, 10))
        source = self.points([App.Vector(x, y, 0) for x, y in places], "Points")
        source.ViewObject.PointSize = 7
        self.doc.recompute()
        _, panel = self.run_selected([(source, "")])
        Gui.activeDocument().activeView().viewTop()
        panel.options.fields["tension"].show_value([0, 0, 0, 0.5, 0, 0, 0])
        settle(1.0)
        panel.comb.setChecked(True)
        panel.numbers.setChecked(True)
        Gui.activeDocument().activeView().fitAll()
        take("spline_freecad")
        self.cancel()

    def test_blend(self):
        self.COMMAND = "Seamwright_BlendCurves"
        sections = [
            self.points(airfoil(*figures), name)
            for *figures, name in ((0.15, 0.04, 100, 0, "Root"), (0.1, 0.02, 60, 150, "Tip"))
        ]
        sections = [kinds.create("Spline", each, closed=True) for each in sections]
        self.doc.recompute()
        _, panel = self.run_selected([(each, "") for each in sections])
        panel.options.fields["result"].show_value("Surface")
        settle(1.0)
        self.fit()
        take("blend_freecad")
        self.cancel()


class SurfacePicture(PanelWindow):
    COMMAND = "Seamwright_BlendSurface"
    is_made = staticmethod(surface.is_surface)

    def test_blend(self):
        low = models.add(self.doc, sheet(0, 0, 0.3), "Low")
        high = models.add(self.doc, sheet(60, 8, -0.2), "High")
        self.doc.recompute()
        _, panel = self.run_selected([(low, at_x(low, 30)), (high, at_x(high, 60))])
        self.fit()
        for argument in ("start_tension", "end_tension"):
            panel.options.fields[argument].show_value(1.6)
        settle(1.0)
        panel.zebra.setChecked(True)
        click_row(panel.table, 1)
        take("blend_surface_freecad")
        self.cancel()


class SamplePicture(PanelWindow):
    def open(self, sample):
        App.closeDocument(self.doc.Name)
        exec((SAMPLES / (sample + ".FCMacro")).read_text(), {"__name__": "__main__"})
        self.doc = App.ActiveDocument
        settle()

    def edit(self, name):
        obj = self.doc.getObject(name)
        Gui.Selection.clearSelection()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle(1.0)
        return obj.ViewObject.Proxy.panel

    def show_only(self, *names):
        for obj in self.doc.Objects:
            obj.ViewObject.Visibility = obj.Name in names

    def test_handles(self):
        self.open("33_curves")
        self.show_only("Spline001", "LogSpiral", "Line")
        panel = self.edit("Spline001")
        panel.comb.setChecked(True)
        Gui.activeDocument().activeView().viewTop()
        Gui.activeDocument().activeView().fitAll()
        take("handles_freecad")
        self.cancel()

    def test_umbrella_and_loft(self):
        self.open("34_surfaces")
        for kind, sources in (("Umbrella", "Spoke"), ("FrameLoft", "Section")):
            shown = [obj.Name for obj in self.doc.Objects if obj.Name.startswith(sources)]
            self.show_only(kind, *shown)
            panel = self.edit(kind)
            self.fit()
            panel.zebra.setChecked(True)
            if kind == "Umbrella":
                click_row(panel.table, 1)
            take({"Umbrella": "umbrella_freecad", "FrameLoft": "loft_freecad"}[kind])
            self.cancel()


    def test_umbrella_g2(self):
        """The same spokes with G1 on the left, with G2 on the right."""
        self.doc = App.newDocument("Umbrellas")
        made = []
        for order, x in (("G1", 0), ("G2", 23)):
            shape = Part.Compound([bowl(number) for number in range(5)])
            shape.translate(App.Vector(x, 0, 0))
            spokes = models.add(self.doc, shape, "Spokes" + order)
            self.doc.recompute()
            made.append(surface_kinds.create("Umbrella", [(spokes, "")], order=order))
            made[-1].ViewObject.DisplayMode = "Shaded"
            spokes.ViewObject.hide()
        panel = self.edit(made[1].Name)
        Gui.activeDocument().activeView().viewTop()
        Gui.activeDocument().activeView().fitAll()
        zebra.show(made[:1])
        panel.zebra.setChecked(True)
        take("umbrella_g2_freecad")
        self.cancel()


class PlotPicture(PanelWindow):
    COMMAND = "Seamwright_SeamPlot"
    is_made = staticmethod(tool.is_tool)

    def test_seam_plot(self):
        shell = Part.Compound(models.two_sheets())
        shell.sewShape(1e-5)
        source = models.add(self.doc, shell, "Sheets")
        self.doc.recompute()
        _, panel = self.run_selected([(source, at_x(source, 0))])
        self.fit()
        area = panel.plot._area()
        panel.plot._at = panel.plot.point_at(area.left() + 0.3 * area.width())
        panel.plot.pointed.emit(*panel.plot._at)
        panel.plot.update()
        take("seam_plot")
        self.cancel()
