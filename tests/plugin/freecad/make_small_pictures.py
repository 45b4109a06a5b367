# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the small pictures of docs/comparison.md, one for each row of its tables.

    SEAMWRIGHT=build/dev/bin/seamwright python3 run_freecad.py --window --mod ADDON --out FOLDER
        --timeout 900 make_small_pictures

writes small_NAME.png, 200 pixels wide, and compare_NAME.png, 640 pixels wide, to be looked at. All
small ones are moved to docs/images, of the others those to which the page links. It needs
ImageMagick and jq.
"""

import os
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import ImportGui
import models
import numpy
import Part
from curve_cases import slot, wavy
from language_window_cases import language
from make_pictures import SAMPLES, airfoil, open_block
from PySide import QtCore, QtGui
from surface_cases import at_x, sheet
from window import OUT, PanelWindow, settle
from window_cases import STEP

from freecad.seamwright.document import analysis, corner, fill, match, repair
from freecad.seamwright.document.curves import kinds as curves
from freecad.seamwright.document.curves.conic import CHAIN
from freecad.seamwright.document.maps import kinds as maps
from freecad.seamwright.document.maps import tool
from freecad.seamwright.document.surfaces import kinds as surfaces
from freecad.seamwright.document.surfaces import surface

GREY, STEEL, BLUE, WARM = (0.55, 0.55, 0.55), (0.8, 0.82, 0.85), (0.1, 0.35, 0.75), (0.9, 0.6, 0.2)
DRAWN = 960, 624
FULL, SMALL = (640, 416), (200, 130)
MARGIN = 14
PALETTE = 255
FONT_PX = 19


def content(image):
    """The part of an image on white that is not white, with a margin, and the image as RGB."""
    image = image.convertToFormat(QtGui.QImage.Format_RGB32)
    width, height = image.width(), image.height()
    pixels = numpy.frombuffer(bytes(image.constBits()), numpy.uint8).reshape(height, width, 4)
    rows, columns = numpy.nonzero((pixels[:, :, :3] < 250).any(axis=2))
    first = QtCore.QPoint(columns.min() - MARGIN, rows.min() - MARGIN)
    last = QtCore.QPoint(columns.max() + MARGIN, rows.max() + MARGIN)
    return QtCore.QRect(first, last), image


def painted(size, *placed):
    """An image on white of (image, its left upper corner) each."""
    white = QtGui.QImage(size, QtGui.QImage.Format_RGB32)
    white.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(white)
    for image, place in placed:
        painter.drawImage(place, image)
    painter.end()
    return white


def trimmed(image):
    """What is not white, in the proportions of FULL."""
    part, image = content(image)
    scale = max(part.width() / FULL[0], part.height() / FULL[1])
    room = QtCore.QRect(0, 0, round(scale * FULL[0]), round(scale * FULL[1]))
    room.moveCenter(part.center())
    return painted(room.size(), (image, -room.topLeft()))


def beside(one, other):
    """What is not white of two images, side by side."""
    parts = [image.copy(part) for part, image in (content(one), content(other))]
    gap = parts[0].width() // 2
    at = QtCore.QPoint(parts[0].width() + gap, 0)
    size = QtCore.QSize(at.x() + parts[1].width(), max(part.height() for part in parts))
    return painted(size, (parts[0], QtCore.QPoint(0, 0)), (parts[1], at))


def save(name, image):
    """Save an image, full and small, with few colours."""
    image = trimmed(image)
    for prefix, size in (("compare_", FULL), ("small_", SMALL)):
        path = os.path.join(OUT, prefix + name + ".png")
        image.scaled(*size, QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation).save(path)
        few = ["+dither", "-colors", str(PALETTE)]
        subprocess.run(["mogrify", "-strip", *few, path], check=True)


def drawn(view_from="viewIsometric"):
    """The image of what the view shows."""
    view = Gui.activeDocument().activeView()
    getattr(view, view_from)()
    view.fitAll()
    settle(1.5)
    path = os.path.join(OUT, "drawn.png")
    view.saveImage(path, *DRAWN, "White")
    return QtGui.QImage(path)


def take(name, view_from="viewIsometric"):
    """Save what the view shows."""
    save(name, drawn(view_from))


def written(name, text):
    """Save a text as a terminal shows it."""
    font = QtGui.QFont("DejaVu Sans Mono")
    font.setPixelSize(FONT_PX)
    area = QtGui.QFontMetrics(font).boundingRect(QtCore.QRect(0, 0, 4000, 4000), 0, text)
    image = painted(area.size() + QtCore.QSize(8, 8))
    painter = QtGui.QPainter(image)
    painter.setFont(font)
    painter.drawText(area, 0, text)
    painter.end()
    save(name, image)


def line_of(obj, width=5, colour=BLUE):
    """Draw an object with thick lines; return it."""
    obj.ViewObject.LineWidth, obj.ViewObject.LineColor = width, colour
    return obj


def combed(obj, scale=1.0):
    """Draw a curve with thick lines and its comb; return it."""
    obj.ViewObject.ShowComb, obj.ViewObject.CombScale = True, scale
    return line_of(obj)


def face_of(obj, colour):
    """Draw an object in a colour; return it."""
    obj.ViewObject.ShapeColor, obj.ViewObject.LineWidth = colour, 3
    obj.ViewObject.Deviation = 0.05
    return obj


class Pictures(PanelWindow):
    def add(self, shape, name="Given", colour=STEEL):
        return face_of(models.add(self.doc, shape, name), colour)

    def points(self, places, size=12):
        shape = Part.Compound([Part.Vertex(App.Vector(*place)) for place in places])
        obj = self.add(shape, "Points")
        obj.ViewObject.PointSize = size
        return obj

    def bezier(self, *poles):
        curve = Part.BezierCurve()
        curve.setPoles([App.Vector(*pole) for pole in poles])
        return line_of(self.add(curve.toShape(), "Curve"), 4, GREY)

    def hide(self, *objects):
        for obj in objects:
            obj.ViewObject.Visibility = False

    def zebra(self, *objects, **given):
        return maps.create("ReflectionLines", list(objects), **given)

    def sample(self, name):
        """Open what a sample makes in place of the document."""
        App.closeDocument(self.doc.Name)
        exec((SAMPLES / (name + ".FCMacro")).read_text(), {"__name__": "__main__"})
        self.doc = App.ActiveDocument
        settle()

    def show_only(self, *names):
        for obj in self.doc.Objects:
            obj.ViewObject.Visibility = obj.Name in names


class CurvePictures(Pictures):
    def test_spline(self):
        places = ((0, 0, 0), (10, 22, 0), (26, 18, 0), (34, 2, 0), (52, 6, 0), (70, 26, 0))
        combed(curves.create("Spline", self.points(places), tension=[0, 0, 0, 0.5, 0, 0]))
        take("spline", "viewTop")

    def test_bridge(self):
        one = self.bezier((0, 0, 0), (12, 14, 0), (24, 16, 0), (32, 12, 0))
        other = self.bezier((54, 30, 0), (66, 34, 0), (78, 26, 0), (84, 10, 0))
        combed(curves.create("BridgeCurve", [one, other], first_order="G3", second_order="G3"), 2.0)
        take("bridge", "viewTop")

    def test_join(self):
        one = self.bezier((0, 0, 0), (10, 16, 0), (24, 22, 0), (36, 16, 0))
        other = self.bezier((37, 17, 0), (52, 16, 0), (64, 22, 0), (76, 6, 0))
        combed(curves.create("JoinCurves", [one, other], order="G2"))
        take("join", "viewTop")

    def test_arcs(self):
        places = ((0, 0, 0), (10, 22, 0), (26, 28, 0), (44, 20, 0), (52, -6, 0))
        spline = curves.create("Spline", self.points(places, 1), closed=True)
        few = line_of(curves.create("Arcs", spline, tolerance_mm=0.5))
        self.hide(*(obj for obj in self.doc.Objects if obj is not few))
        few.ViewObject.PointSize, few.ViewObject.PointColor = 14, WARM
        take("arcs", "viewTop")

    def test_conic(self):
        places = ((0, 0, 0), (8, 16, 0), (24, 24, 0), (42, 18, 0), (54, 2, 0), (70, -4, 0))
        combed(curves.create("Conic", self.points(places), points=CHAIN))
        take("conic", "viewTop")

    def test_clothoid(self):
        track = line_of(self.add(slot(), "Track"), 4, GREY)
        clothoid = combed(curves.create("Clothoid", track, tolerance_mm=1.0))
        take("clothoid", "viewTop")
        self.assertFalse(clothoid.Shape.isNull())

    def test_log_spiral(self):
        combed(curves.create("LogSpiral", self.points(((0, 0, 0), (40, 42, 0), (58, 8, 0)))))
        take("log_spiral", "viewTop")

    def test_fair(self):
        given = line_of(self.add(wavy(), "Wavy"), 4, GREY)
        fair = combed(curves.create("FairCurve", given, tolerance_mm=0.1))
        comb = maps.create("CurvatureComb", given, density=300)
        take("fair", "viewTop")
        self.assertFalse(fair.Shape.isNull() or comb.Outcome != "done")

    def test_blend_curves(self):
        sections = [
            curves.create("Spline", self.points(airfoil(*figures), 1), closed=True)
            for figures in ((0.18, 0.05, 100, 0), (0.12, 0.02, 60, 60))
        ]
        self.hide(*self.doc.Objects)
        for each in (*sections, curves.create("BlendCurves", sections, frames=7)):
            line_of(each, 4).ViewObject.Visibility = True
        take("blend_curves")


    def test_handles(self):
        self.sample("33_curves")
        self.show_only("Spline001")
        view = self.doc.getObject("Spline001").ViewObject
        view.Proxy.doubleClicked(view)
        settle(1.0)
        view.Proxy.panel.comb.setChecked(True)
        take("handles", "viewTop")
        self.cancel()

    def test_sketch(self):
        self.sample("33_curves")
        pad = self.doc.getObject("Pad")
        sketch = pad.Profile[0]
        self.show_only("Body", "Pad", sketch.Name)
        face_of(pad, STEEL).ViewObject.Transparency = 60
        line_of(sketch, 6)
        take("sketch")


class SurfacePictures(Pictures):
    COMMAND = "Seamwright_BlendSurface"
    is_made = staticmethod(surface.is_surface)

    def test_blend(self):
        low, high = self.add(sheet(0, 0, 0.3), "Low"), self.add(sheet(60, 8, -0.2), "High")
        sides = {"Start": [(low, at_x(low, 30))], "End": [(high, at_x(high, 60))]}
        made = surfaces.create("BlendSurface", sides, start_tension=1.6, end_tension=1.6)
        self.zebra(low, made, high)
        take("blend")

    def test_extend(self):
        given = self.add(sheet(0, 0, -0.4), "Given")
        made = surfaces.create("ExtendSurface", [(given, at_x(given, 30))], length_mm=20)
        face_of(made, WARM)
        take("extend")

    def test_match(self):
        shapes = models.sheet(-1), models.sheet(1, slope_deg=3.0, bend=0.002)
        one, other = (self.add(shape) for shape in shapes)
        self.zebra(match.create((one, "Face1"), (other, "Face1"), target="G2"), stripes=48)
        take("match_g2")

    def test_fill(self):
        block = self.add(open_block())
        App.setActiveDocument(self.doc.Name)
        made = fill.create(block)
        face_of(made, STEEL)
        settle(1.0)
        new = len(made.Shape.Faces) - len(block.Shape.Faces)
        made.ViewObject.DiffuseColor = [STEEL] * len(block.Shape.Faces) + [WARM] * new
        take("fill")

    def test_umbrella_and_loft(self):
        self.sample("34_surfaces")
        for kind, sources in (("Umbrella", "Spoke"), ("FrameLoft", "Section")):
            shown = [obj for obj in self.doc.Objects if obj.Name.startswith(sources)]
            stripes = self.zebra(self.doc.getObject(kind))
            self.show_only(kind, stripes.Name, *(line_of(obj, 6).Name for obj in shown))
            take({"Umbrella": "umbrella", "FrameLoft": "loft"}[kind])

    def test_parametric(self):
        self.sample("34_surfaces")
        colours = {"Wide": STEEL, "Thin": STEEL, "BlendSurface": WARM, "ExtendSurface": BLUE}
        self.show_only(*colours)
        for name, colour in colours.items():
            face_of(self.doc.getObject(name), colour)
        images = []
        for radius in (5, 10):
            self.doc.getObject("Thin").Radius = radius
            self.doc.recompute()
            images.append(drawn("viewFront"))
        save("parametric", beside(*images))

    def test_corner(self):
        cube = self.add(Part.makeBox(10, 10, 10), "Cube")
        near = App.Vector(10, 0, 10)
        (number,) = [
            n for n, v in enumerate(cube.Shape.Vertexes, 1) if v.Point.isEqual(near, 1e-9)
        ]
        face_of(corner.create(cube, number, [1.0, 2.0, 3.0]), STEEL)
        self.hide(cube)
        take("corner")

    def test_repair(self):
        made = repair.create(self.add(models.broken_panel(), "Panel"))
        made.ViewObject.ShowMoves = True
        take("repair_moves")


class AnalysisPictures(Pictures):
    COMMAND = "Seamwright_SeamPlot"
    is_made = staticmethod(tool.is_tool)

    def block(self):
        block = self.add(models.broken_block(), "Block")
        self.doc.recompute()
        return block

    def test_seams(self):
        ImportGui.insert(STEP, self.doc.Name)
        self.doc.recompute()
        made = analysis.create(doc=self.doc)
        made.ViewObject.LineWidth, made.ViewObject.ShowLegend = 6, False
        take("seams")

    def test_matched(self):
        shapes = models.sheet(-1), models.sheet(1, slope_deg=1.0)
        one, other = (self.add(shape) for shape in shapes)
        other.Placement.Base.x = 0.3
        self.doc.recompute()
        made = analysis.create([one, other], match_mm=1.0, gap_mm=0.1)
        made.ViewObject.LineWidth, made.ViewObject.ShowLegend = 10, False
        self.assertEqual(made.Matched, 1)
        take("matched")

    def test_maps(self):
        block = self.block()
        mended = repair.create(block, target="G1", max_move_mm=1.0)
        top = max(
            range(len(block.Shape.Faces)), key=lambda n: block.Shape.Faces[n].CenterOfMass.z
        )
        for name, kind, sources, given in (
            ("comb", "CurvatureComb", [(block, "Face%d" % (top + 1))], {"count": 7, "scale": 1.5}),
            ("curvature", "CurvatureMap", block, {}),
            ("draft", "DraftAngle", block, {"towards_deg": 5, "away_deg": 5}),
            ("deviation", "Deviation", [block, mended], {}),
        ):
            made = maps.create(kind, sources, **given)
            for obj in self.doc.Objects:
                obj.ViewObject.Visibility = obj in (block, made)
            take(name)

    def test_reflections(self):
        panel = self.add(models.broken_panel(), "Panel")
        self.zebra(panel, lines="Highlight lines", spacing_mm=14)
        take("highlights")

    def test_plot(self):
        shell = Part.Compound(models.two_sheets())
        shell.sewShape(1e-5)
        source = self.add(shell, "Sheets")
        self.doc.recompute()
        _, panel = self.run_selected([(source, at_x(source, 0))])
        panel.plot.resize(560, 364)
        settle()
        save("plot", panel.plot.grab().toImage())
        self.cancel()


class Texts(Pictures):
    def block_file(self):
        path = os.path.join(OUT, "part.step")
        models.broken_block().exportStep(path)
        return path

    def test_command_and_report(self):
        name = os.path.basename(self.block_file())
        for picture, line, lines in (
            ("command", "seamwright analyze %s | cut -c 1-44" % name, 9),
            ("report", "seamwright analyze %s --format json | jq .summary" % name, 14),
        ):
            run = ["bash", "-c", line.replace("seamwright", os.environ["SEAMWRIGHT"], 1)]
            shown = subprocess.run(run, cwd=OUT, capture_output=True, text=True, check=False)
            text = "\n".join(shown.stdout.splitlines()[:lines])
            written(picture, "$ %s\n%s" % (line, text))

    def test_python(self):
        code = "import seamwright\n\nmodel = seamwright.read('part.step')\n"
        code += "for seam in model.analyze().seams:\n    if seam['class'] == 'defect':\n"
        code += "        print(seam['faces'], seam['level'])"
        written("python", code)

    def test_languages(self):
        self.add(models.three_classes(), "Prism")
        self.doc.recompute()
        with language("Chinese Simplified"):
            _, panel = self.analyse()
            form = panel.form.grab().toImage()
            save("languages", form.copy(0, 0, form.width(), round(form.width() * 0.65)))
            panel.reject()
