# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models made by FreeCAD itself, for the tests inside FreeCAD."""

import itertools
import math
import pathlib
import random
import runpy

import FreeCAD as App
import Part

#: Angle of the one seam of ``three_classes`` that is neither smooth nor a crease.
KINK_DEG = 1.0


def three_classes():
    """A prism with one kink of 1 degree (a defect), one rounded corner (smooth) and creases.

    Its 18 seams: the kink, 2 at the rounding, and 15 creases.
    """
    rise = 10 * math.tan(math.radians(KINK_DEG))
    outline = [(0, 0), (10, 0), (20, -rise), (20, 20), (0, 20), (0, 0)]
    face = Part.Face(Part.makePolygon([App.Vector(x, y, 0) for x, y in outline]))
    prism = face.extrude(App.Vector(0, 0, 10))
    corner = [
        edge
        for edge in prism.Edges
        if all(abs(vertex.X - 20) + abs(vertex.Y - 20) < 1e-6 for vertex in edge.Vertexes)
    ]
    return prism.makeFillet(3.0, corner)


#: Largest angle of ``two_sheets``, and how far each reaches.
SHEETS_DEG, SHEET_MM = 3.0, 20.0


def sheet(side, slope_deg=0.0, bend=-0.02):
    """A bicubic sheet z = slope |x| + bend x^2 / 2 + g(y), to the left (-1) or right (1) of the
    plane x = 0."""
    slope = math.tan(math.radians(slope_deg))
    heights = [0, slope / 3, 2 * slope / 3 + bend * SHEET_MM / 6, slope + bend * SHEET_MM / 2]
    across = [0, 4, 4, -1]
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for i in range(4):
        for j in range(4):
            z = SHEET_MM * heights[i] + across[j]
            surface.setPole(i + 1, j + 1, App.Vector(side * SHEET_MM * i / 3, 10 * j - 15, z))
    return surface.toShape()


def two_sheets():
    """Two sheets that meet at x = 0 with an angle of ``SHEETS_DEG`` where g is level, and less
    elsewhere."""
    return [sheet(-1), sheet(1, slope_deg=SHEETS_DEG)]


#: Size of ``broken_panel``, and the distance that poles beside its seams are moved by at most.
PANEL_MM, NOISE_MM = (240.0, 150.0), 0.3


def broken_panel(across=3, along=2, noise_mm=NOISE_MM, seed=7):
    """A curved panel, cut into patches whose poles in the row next to each seam are moved: its
    seams have kinks."""
    generator = random.Random(seed)
    whole = Part.BSplineSurface()
    whole.interpolate([[_on_panel(i / 9, j / 6) for j in range(7)] for i in range(10)])
    patches = [
        _patch(whole, (i / across, (i + 1) / across), (j / along, (j + 1) / along))
        for i, j in itertools.product(range(across), range(along))
    ]
    for place, patch in enumerate(patches):
        _disturb(patch, place // along, place % along, (across, along), noise_mm, generator)
    panel = Part.Compound([patch.toShape() for patch in patches])
    panel.sewShape(1e-4)
    return panel


def _on_panel(u, v):
    """A point of the panel as it was meant, for u and v in 0..1."""
    x, y = PANEL_MM[0] * (u - 0.5), PANEL_MM[1] * (v - 0.5)
    return App.Vector(
        x, y, 30 - x * x / 600 - y * y / 900 + 6 * math.sin(x / 40) * math.cos(y / 60)
    )


def _patch(whole, part_u, part_v):
    """The part of a surface between knots that lie at these shares of its knots."""
    ends = [
        knots[round(share * (len(knots) - 1))]
        for knots, part in ((whole.getUKnots(), part_u), (whole.getVKnots(), part_v))
        for share in part
    ]
    patch = whole.copy()
    patch.segment(*ends)
    return patch


def _disturb(patch, i, j, counts, noise_mm, generator):
    """Move the poles one row from the sides that are seams, and none that lie in a side."""
    rows, columns = patch.NbUPoles, patch.NbVPoles
    for k, m in itertools.product(range(2, rows), range(2, columns)):
        beside_u = (i > 0 and k == 2) or (i + 1 < counts[0] and k == rows - 1)
        beside_v = (j > 0 and m == 2) or (j + 1 < counts[1] and m == columns - 1)
        if beside_u or beside_v:
            patch.setPole(
                k, m, patch.getPole(k, m) + App.Vector(0, 0, generator.uniform(-noise_mm, noise_mm))
            )


#: The script that makes the models of the samples.
SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples" / "models" / "make_models.py"


def broken_block():
    """A solid with one seam of 2 degrees, at a Bezier face."""
    return runpy.run_path(str(SAMPLES))["broken_block"]()


def rounded_block(size=20.0, radius=4.0):
    """A cube whose edges are rounded; its corners are octants of a ball."""
    cube = Part.makeBox(size, size, size)
    return cube.makeFillet(radius, cube.Edges)


def corner_faces(shape):
    """The numbers of the faces that are pieces of a ball."""
    return [n for n, face in enumerate(shape.Faces, 1) if face.Surface.TypeId == "Part::GeomSphere"]


def open_block(corners, size=20.0):
    """A rounded block without the first few of its corners: a shell with as many holes of three
    sides."""
    block = rounded_block(size)
    gone = corner_faces(block)[:corners]
    return Part.makeShell([face for n, face in enumerate(block.Faces, 1) if n not in gone])


def panel_with_hole():
    """The panel of ``broken_panel`` as it was meant, without the patch in the middle of nine."""
    faces = broken_panel(across=3, along=3, noise_mm=0.0).Faces
    return Part.makeShell(faces[:4] + faces[5:])


def open_loops(shape):
    """The loops of edges that bound one face, as lists of names, by their first edge; no two of
    them touch."""
    uses = {}
    for face in shape.Faces:
        for edge in face.Edges:
            uses[edge.hashCode()] = uses.get(edge.hashCode(), 0) + 1
    loops = []  # of (edge name, edge)
    for number, edge in enumerate(shape.Edges, 1):
        if uses.get(edge.hashCode()) == 1 and not edge.Degenerated:
            near = [loop for loop in loops if any(_touch(edge, other) for _, other in loop)]
            loops = [loop for loop in loops if loop not in near]
            loops.append([pair for loop in near for pair in loop] + [("Edge%d" % number, edge)])
    named = [sorted((name for name, _ in loop), key=lambda name: int(name[4:])) for loop in loops]
    return sorted(named, key=lambda loop: int(loop[0][4:]))


def _touch(one, other):
    return any(a.isSame(b) for a in one.Vertexes for b in other.Vertexes)


def point(x, y, z):
    """A vertex."""
    return Part.Vertex(x, y, z)


def add(doc, shape, name):
    """A document object that holds the shape."""
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def height(x, y):
    return 0.004 * x**2 + 0.003 * y**2 - 0.002 * x * y


def around_a_hole():
    """A shell of the surface z = height(x, y) over eight of nine squares of 20 mm."""
    faces = []
    for i, j in itertools.product(range(3), range(3)):
        if (i, j) != (1, 1):
            surface = Part.BezierSurface()
            surface.increase(2, 2)
            for a, b in itertools.product(range(3), range(3)):
                x1, x2 = 20 * (i + a // 2), 20 * (i + (a + 1) // 2)
                y1, y2 = 20 * (j + b // 2), 20 * (j + (b + 1) // 2)
                x, y = (x1 + x2) / 2, (y1 + y2) / 2
                z = 0.004 * x1 * x2 + 0.003 * y1 * y2 - 0.002 * x * y
                surface.setPole(a + 1, b + 1, App.Vector(x, y, z))
            faces.append(surface.toShape())
    shell = Part.Shell(faces)
    shell.sewShape()
    return shell
