# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a shape with the normals of its surfaces, fine enough for reflections.

FreeCAD's own triangles are made for shading: between their corners the true normal may turn by many degrees. Here
a face is split, in its parameters, until its normals between two corners are nearly what a graphics card makes
of those at the corners. Nothing is shared between faces, so that a break at a seam stays a break.
"""

import math

import FreeCAD as App
import MeshPart

#: Angle between neighbours of the first triangles, in radians. Shape.tessellate has one of its own, which falls with the deviation in
#: mm: small models get hundreds of thousands of triangles.
TURN = 0.1

#: Deviation of the first triangles from the shape, as a part of the shape's size.
DEFLECTION = 5e-3

#: Largest distance between a unit normal and the mean of its neighbours'; at ten times that stripes look jagged.
BEND = 2e-4

#: Largest height of a surface over the middle of an edge, as a part of the face's size.
SAG = 3e-4

#: Edges shorter than this part of their face's size are not split: where a surface has a kink the normal jumps
#: however near the corners are.
SHORTEST = 0.01

#: Each pass halves what is too long; a face that has so many triangles is split no more.
MAX_PASSES, MAX_TRIANGLES = 7, 30000

#: How far towards the middle of the face a normal is taken where a surface has none, as a part of the way.
INWARDS = 1e-3


class Facets:
    """Corners, their unit normals and triangles (three places in these lists each) of one shape."""

    def __init__(self):
        self.points, self.normals, self.triangles = [], [], []

    def append(self, points, normals, triangles):
        """Add the facets of one more face."""
        first = len(self.points)
        self.points += points
        self.normals += normals
        self.triangles += [tuple(first + place for place in triangle) for triangle in triangles]


def facets(shape, progress=None):
    """The Facets of all faces of a Part.Shape, which is left as it is.

    ``progress`` is a callable(fraction) that returns False to stop; then None is returned.
    """
    result = Facets()
    if shape.isNull() or not shape.Faces:
        return result
    deflection = DEFLECTION * shape.BoundBox.DiagonalLength
    faces = triangulated_faces(shape, deflection)
    for place, face in enumerate(faces):
        if progress is not None and progress(place / len(faces)) is False:
            return None
        result.append(*Sheet(face, deflection).refined())
    return result


def triangulated_faces(shape, deflection):
    """The faces of a copy of a shape that shares its geometry, with triangles; the shape keeps its own."""
    twin = shape.copy(False, False)
    MeshPart.meshFromShape(Shape=twin, LinearDeflection=deflection, AngularDeflection=TURN)
    return twin.Faces


class Sheet:
    """The triangles of one face, as corners in its parameters; split where they are too coarse for reflections."""

    def __init__(self, face, deflection):
        self._surface = face.Surface
        self._sign = -1.0 if face.Orientation == "Reversed" else 1.0
        low_u, high_u, low_v, high_v = face.ParameterRange
        self._middle = ((low_u + high_u) / 2, (low_v + high_v) / 2)
        size = face.BoundBox.DiagonalLength
        self._shortest, self._sag = SHORTEST * size, SAG * size
        self._uv, self.points, self.normals = [], [], []
        self._fine = set()  # edges found to be short or straight enough
        self.triangles = self._start(face, deflection)

    def refined(self):
        """(points, normals, triangles) of the face, fine enough."""
        for _ in range(MAX_PASSES):
            split = self._bent_edges()
            if not split or len(self.triangles) > MAX_TRIANGLES:
                break
            self.triangles = [
                part for triangle in self.triangles for part in _parts(triangle, split)
            ]
        return self.points, self.normals, self.triangles

    def _start(self, face, deflection):
        """FreeCAD's triangles, with corners in parameters; it gives the two separately."""
        try:
            nodes = face.getUVNodes()
        except RuntimeError:  # the face could not be triangulated
            return []
        for node in nodes:
            self.add(node)
        corners, triangles = face.tessellate(deflection)
        places = _nearest(corners, self.points)
        found = [self._closest([places[corner] for corner in triangle]) for triangle in triangles]
        return [triangle for triangle in found if len(set(triangle)) == 3]

    def _closest(self, choices):
        """One place for each corner, so that they lie together.

        A corner has several places where a face meets itself: on the seam of a cylinder, at the pole of a sphere.
        """
        sure = [places[0] for places in choices if len(places) == 1]
        anchor = sure[0] if sure else choices[0][0]
        return tuple(min(places, key=lambda place: math.dist(self._uv[place], self._uv[anchor])) for places in choices)

    def add(self, uv):
        """Add a corner at (u, v); its place."""
        self._uv.append(uv)
        self.points.append(tuple(self._surface.value(*uv)))
        self.normals.append(self._normal(uv))
        return len(self._uv) - 1

    def _normal(self, uv):
        inside = tuple(a + INWARDS * (b - a) for a, b in zip(uv, self._middle))
        for place in (uv, inside):
            try:
                return tuple(self._surface.normal(*place) * self._sign)
            except (RuntimeError, App.Base.FreeCADError):  # a pole, where the surface has no normal
                continue
        return (0.0, 0.0, 1.0)

    def is_coarse(self, uv, one, other):
        """Whether normal or surface bend too much between two corners, whose middle in the parameters is ``uv``."""
        bend = math.dist(self._normal(uv), mean(self.normals[one], self.normals[other]))
        height = math.dist(self._surface.value(*uv), mean(self.points[one], self.points[other]))
        return bend > BEND or height > self._sag

    def _bent_edges(self):
        """{edge: place of its new middle} for the edges that are too coarse."""
        edges = {edge for triangle in self.triangles for edge in _edges(triangle)} - self._fine
        split = {}
        for edge in edges:
            one, other = edge
            if math.dist(self.points[one], self.points[other]) < self._shortest:
                continue
            uv = mean(self._uv[one], self._uv[other])
            if self.is_coarse(uv, one, other):
                split[edge] = self.add(uv)
        self._fine |= edges - split.keys()
        return split


def mean(one, other):
    """The point halfway between two."""
    return tuple((a + b) / 2 for a, b in zip(one, other))


def _edges(triangle):
    a, b, c = triangle
    return tuple((i, j) if i < j else (j, i) for i, j in ((a, b), (b, c), (c, a)))


def _parts(triangle, split):
    """The triangles that one falls into when those of its edges that are in ``split`` are halved."""
    a, b, c = triangle
    ab, bc, ca = (split.get(edge) for edge in _edges(triangle))
    known = sum(middle is not None for middle in (ab, bc, ca))
    if known == 0:
        return [triangle]
    if known == 3:
        return [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    while (ab is None) or (known == 2 and bc is None):  # turn until the first edges are the halved ones
        a, b, c, ab, bc, ca = b, c, a, bc, ca, ab
    if known == 1:
        return [(a, ab, c), (ab, b, c)]
    return [(ab, b, bc), (a, ab, bc), (a, bc, c)]


def _nearest(corners, points):
    """For each corner the places of the points that are nearest to it, all of them where they coincide."""
    cells = {}
    size = _cell_size(points)
    for place, point in enumerate(points):
        cells.setdefault(_cell(point, size), []).append(place)
    return [_near(tuple(corner), points, cells, size) for corner in corners]


def _near(corner, points, cells, size):
    i, j, k = _cell(corner, size)
    around = [
        place
        for a in (i - 1, i, i + 1)
        for b in (j - 1, j, j + 1)
        for c in (k - 1, k, k + 1)
        for place in cells.get((a, b, c), ())
    ]
    reached = sorted((math.dist(points[place], corner), place) for place in around or range(len(points)))
    closest = reached[0][0]
    return [place for distance, place in reached if distance <= closest + 1e-6 * size]


def _cell_size(points):
    lows, highs = zip(*((min(axis), max(axis)) for axis in zip(*points)))
    return max(math.dist(lows, highs) / max(1.0, math.sqrt(len(points))), 1e-9)


def _cell(point, size):
    return tuple(math.floor(value / size) for value in point)
