# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sides of a new surface: edges of document objects, and the faces that they bound."""

import re
from typing import Any, Dict, List, NamedTuple, Tuple

import Part

from freecad.seamwright.document import sources
from freecad.seamwright.plain.language import tr


class Element(NamedTuple):
    """An edge or a face, as it lies in the model, with its name such as "Plate.Edge3"."""

    shape: Any
    name: str


class Side(NamedTuple):
    """The edges of a side, and the faces that it continues."""

    edges: List[Element]
    faces: List[Element]


class Gathered(NamedTuple):
    """The faces and edges of several sides as one shape.

    ``numbers``: {side: (numbers of its edges, numbers of its faces)} in the shape. ``names``:
    {"edge": [name of the first edge, ...], "face": [...]}.
    """

    shape: Any
    numbers: Dict[str, Tuple[List[int], List[int]]]
    names: Dict[str, List[str]]

    def named(self, text):
        """Return a sentence of the kernel with the names of its edges and faces."""

        def name(found):
            names = self.names[found.group(1).lower()]
            numbers = [int(number) for number in found.group(2).split(", ")]
            return ", ".join(names[number - 1] for number in numbers if number <= len(names))

        return re.sub(r"(?i)\b(edge|face) ?(\d+(?:, \d+)*)\b", name, text)


class Parts:
    """The shapes of document objects, as they lie in the model; what they share stays shared."""

    def __init__(self, objects):
        """Raises SourceError for an object without a shape."""
        self._parts = {obj: _part(obj) for obj in dict.fromkeys(objects)}
        if len(self._parts) > 1:
            self._parts = {
                obj: sources.without_location(part) for obj, part in self._parts.items()
            }
        self._faces_of = {}

    def elements(self, obj, name):
        """Return the Elements that a link names: a face, an edge, or all edges of an object."""
        part = self._parts[obj]
        if not name and not part.Faces:
            return [self._element(obj, "Edge", place) for place in range(len(part.Edges))]
        kind = name.rstrip("0123456789")
        if kind not in ("Edge", "Face"):
            what = tr("is not an edge or a face") if name else tr("is chosen as a whole")
            raise sources.SourceError(
                tr("{name} {what}: choose edges").format(
                    name=".".join(filter(None, (obj.Label, name))), what=what
                )
            )
        count, digits = len(part.Edges if kind == "Edge" else part.Faces), name[len(kind) :]
        if not digits or not 0 < int(digits) <= count:
            raise sources.SourceError(tr("{label} has no {name}: choose another one").format(
                label=obj.Label, name=name
            ))
        return [self._element(obj, kind, int(digits) - 1)]

    def _element(self, obj, kind, place):
        part = self._parts[obj]
        found = part.Edges if kind == "Edge" else part.Faces
        return Element(found[place], "%s.%s%d" % (obj.Label, kind, place + 1))

    def faces_of(self, obj, edge):
        """Return the Elements of the faces of an object that an edge bounds."""
        if obj not in self._faces_of:
            found = {}
            for place, face in enumerate(self._parts[obj].Faces):
                for each in face.Edges:
                    found.setdefault(each.hashCode(), []).append((each, place))
            self._faces_of[obj] = found
        alike = self._faces_of[obj].get(edge.hashCode(), [])
        places = dict.fromkeys(place for each, place in alike if each.isSame(edge))
        return [self._element(obj, "Face", place) for place in places]

    def edge_name(self, edge):
        """Return the name of an edge of the objects, such as "Plate.Edge3"."""
        for obj, part in self._parts.items():
            for place, each in enumerate(part.Edges):
                if each.isSame(edge):
                    return self._element(obj, "Edge", place).name
        return "an edge"

    def edges_at(self, obj, vertex):
        """Return the Elements of the edges of an object that end at a vertex."""
        return [
            self._element(obj, "Edge", place)
            for place, edge in enumerate(self._parts[obj].Edges)
            if any(vertex.isSame(each) for each in edge.Vertexes)
        ]

    def side(self, chosen, bare=False):
        """Return the Side of links: edges, and faces where edges bound two of them.

        ``bare``: edges need no face, and only those count that are without doubt. Raises
        SourceError or ValueError.
        """
        edges, faces = [], []
        for obj, name in chosen:
            for element in self.elements(obj, name):
                is_face = element.shape.ShapeType == "Face"
                (faces if is_face else edges).append((obj, element))
        if not edges:
            raise ValueError(tr("no edge is chosen: choose the edges of a side"))
        continued = []
        for obj, edge in edges:
            beside = self.faces_of(obj, edge.shape)
            meant = [each for each in beside if _holds(faces, each)] or beside
            if len(meant) == 1:
                continued += meant
            elif not bare:
                raise ValueError(_doubt(edge, meant))
        for _, face in faces:
            if not any(face.shape.isSame(each.shape) for each in continued):
                raise ValueError(tr("{name} bounds none of the edges: leave it out").format(
                    name=face.name
                ))
        return Side([edge for _, edge in edges], _without_repeats(continued))

    def face(self, chosen):
        """Return the Element of the one face that links name. Raises SourceError or ValueError."""
        found = [each for obj, name in chosen for each in self.elements(obj, name)]
        if len(found) != 1 or found[0].shape.ShapeType != "Face":
            raise ValueError(tr("choose one face"))
        return found[0]


def _part(obj):
    if not sources.has_shape(obj):
        raise sources.SourceError(tr("{label} has no edges: choose edges of faces").format(
            label=obj.Label
        ))
    return sources.placed_shape(obj)


def _holds(faces, face):
    return any(face.shape.isSame(each.shape) for _, each in faces)


def _doubt(edge, faces):
    if not faces:
        return tr("{name} bounds no face: choose an edge of a face").format(name=edge.name)
    return tr("{name} lies between {faces}: select the face to continue, too").format(
        name=edge.name, faces=tr(" and ").join(face.name for face in faces)
    )


def _without_repeats(elements):
    found = []
    for element in elements:
        if not any(element.shape.isSame(each.shape) for each in found):
            found.append(element)
    return found


def gather(sides):
    """Return the Gathered of {name: Side}."""
    faces = _without_repeats([face for side in sides.values() for face in side.faces])
    inside = sources.Index(
        (place, edge) for place, edge in enumerate(e for f in faces for e in f.shape.Edges)
    )
    edges = _without_repeats([edge for side in sides.values() for edge in side.edges])
    bare = [edge.shape for edge in edges if inside.find(edge.shape) is None]
    shape = Part.Compound([face.shape for face in faces] + bare)
    numbers = sources.Index(enumerate(shape.Edges, 1))
    places = sources.Index((place, face.shape) for place, face in enumerate(faces, 1))
    names = {"edge": ["an edge"] * len(shape.Edges), "face": [face.name for face in faces]}
    for edge in edges:
        names["edge"][numbers.find(edge.shape) - 1] = edge.name
    return Gathered(
        shape,
        {
            name: (
                [numbers.find(edge.shape) for edge in side.edges],
                [places.find(face.shape) for face in side.faces],
            )
            for name, side in sides.items()
        },
        names,
    )
