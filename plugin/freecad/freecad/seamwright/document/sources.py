# SPDX-License-Identifier: LGPL-2.1-or-later
"""From document objects to one shape for the kernel, and from its numbers back to objects.

The shapes of the document are only read. Sharing is kept: the shape that is analysed has the same
faces and edges as the sources, not copies.
"""

import FreeCAD as App
import numpy
import Part

from freecad.seamwright.plain.language import tr

#: The plurals of kinds of elements that do not end with an s.
SEVERAL = {"Vertex": "Vertexes"}


class SourceError(Exception):
    """The sources cannot be analysed; the text names the object and says what is missing."""


def everything(doc, exclude=None):
    """Return all objects with a solid or a shell that are not part of another such object.

    In a document without solids and shells, these are all objects with faces. ``exclude`` and the
    objects that depend on it are left out.
    """
    candidates = [obj for obj in doc.Objects if _is_candidate(obj, exclude)]
    solid = [obj for obj in candidates if _has_shells(Part.getShape(obj))]
    found = solid or [obj for obj in candidates if Part.getShape(obj).Faces]
    inputs = {
        part.Name
        for obj in found
        if not obj.isDerivedFrom("App::Link")
        for part in obj.OutListRecursive
    }
    return [obj for obj in found if obj.Name not in inputs]


def _is_candidate(obj, exclude):
    if not has_shape(obj) or in_body(obj):
        return False
    if exclude is not None and (obj == exclude or exclude in obj.OutListRecursive):
        return False
    return not Part.getShape(obj).isNull()


def _has_shells(shape):
    return bool(shape.Solids or shape.Shells)


def in_body(obj):
    """Return whether an object is a step of a PartDesign body, which holds the shape itself."""
    group = obj.getParentGeoFeatureGroup()
    return group is not None and group.isDerivedFrom("PartDesign::Body")


def has_shape(obj):
    """Return whether an object is of a kind that can hold a shape."""
    return obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("App::Link")


def expand(objects):
    """Return the objects, with each group or part replaced by its contents, without repeats."""
    found = []
    for obj in objects:
        members = [obj] if has_shape(obj) else expand(getattr(obj, "Group", []))
        found += [member for member in members if member not in found]
    return found


def element_of_link(link, path):
    """Return the name that an element has in the shape of a link: "Face7" for "Box.Face1"."""
    # FreeCAD 1.0 puts names that stay through changes, which begin with a semicolon, between.
    *members, name = (each for each in path.split(".") if not each.startswith(";"))
    if not members:
        return name
    member = ".".join(members)
    kind = name.rstrip("0123456789")
    several = SEVERAL.get(kind, kind + "s")
    # FreeCAD's own element of a path may be a copy, so it is found by its number.
    element = getattr(Part.getShape(link, member + "."), several)[int(name[len(kind) :]) - 1]
    every = enumerate(getattr(Part.getShape(link), several), 1)
    centre = element.BoundBox.Center
    _, number = min(
        ((each.BoundBox.Center - centre).Length, number)
        for number, each in every
        if each.isPartner(element)
    )
    return "%s%d" % (kind, number)


def paths_in_link(link, names):
    """Return the paths by which FreeCAD selects elements of a link: "Box.Face1" for "Face7".

    It is the inverse of ``element_of_link``.
    """
    members = list(_members(link))
    if members == [""]:
        return names
    found = []
    every, whole = {}, Part.getShape(link)
    for name in names:
        kind = name.rstrip("0123456789")
        if kind not in every:
            every[kind] = _elements_by_path(link, members, kind)
        paths, shapes, centres = every[kind]
        element = whole.getElement(name)
        distances = numpy.linalg.norm(centres - tuple(element.BoundBox.Center), axis=1)
        places = (place for place in distances.argsort() if shapes[place].isPartner(element))
        found += [paths[place] for place in places][:1]
    return found


def _members(link, path=""):
    """Yield the paths of the objects in a link, such as "Part.Box."; "" for a link to one shape."""
    owner = link.getSubObject(path, 1) if path else link
    # The shape of a body is that of its last step, and no other step is seen.
    inner = () if owner.isDerivedFrom("Part::Feature") else owner.getSubObjects()
    for each in inner:
        yield from _members(link, path + each)
    if not inner:
        yield path


def _elements_by_path(link, members, kind):
    """Return (paths, shapes, centres) of the elements of a kind in the objects of a link."""
    several = SEVERAL.get(kind, kind + "s")
    found = [
        ("%s%s%d" % (path, kind, number), element)
        for path in members
        for number, element in enumerate(getattr(Part.getShape(link, path), several), 1)
    ]
    centres = [tuple(element.BoundBox.Center) for _, element in found]
    return (
        [path for path, _ in found],
        [element for _, element in found],
        numpy.array(centres, float).reshape(-1, 3),
    )


def parent_placement(obj):
    """Return the placement of the parts that contain an object.

    It is the identity at the top of the document.
    """
    placement = App.Placement()
    group = obj.getParentGeoFeatureGroup()
    while group is not None:
        placement = group.Placement * placement
        group = group.getParentGeoFeatureGroup()
    return placement


def world_shape(obj):
    """Return the shape of one object with faces at its position in the model.

    Raises SourceError.
    """
    check_kind(obj)
    shape = placed_shape(obj)
    if not shape.countElement("Face"):
        text = tr("{label} has no faces: choose an object with faces.")
        if obj.isDerivedFrom("Sketcher::SketchObject"):
            text = tr("{label} is a sketch and has no faces: choose an object with faces.")
        raise SourceError(text.format(label=obj.Label))
    return shape


def check_kind(obj):
    """Raise SourceError for an object of a kind that cannot hold a shape."""
    if obj.isDerivedFrom("Mesh::Feature"):
        raise SourceError(
            tr(
                "{label} is a mesh: make a shape of it first, with Create shape from mesh of the "
                "workbench Part."
            ).format(label=obj.Label)
        )
    if not has_shape(obj):
        text = tr("{label} has no shape: choose another object.")
        if hasattr(obj, "Group"):
            text = tr("{label} contains nothing with a shape: choose another object.")
        raise SourceError(text.format(label=obj.Label))


def placed_shape(obj):
    """Return the shape of one object at its position in the model. Raises SourceError."""
    shape = Part.getShape(obj)
    if shape.isNull():
        raise SourceError(tr("{label} has no shape: recompute it or choose another object.").format(
            label=obj.Label
        ))
    placement = parent_placement(obj)
    if placement.isIdentity():
        return shape
    placed = Part.Compound([shape])
    placed.Placement = placement
    return placed


class Elements:
    """The faces and edges that links name, at their positions in the model.

    Edges that faces share stay shared.
    """

    def __init__(self, links):
        """Find the elements of ``links``: [(object, "Face3"), ...].

        Raises SourceError for an element that does not exist.
        """
        self._parts = {obj: world_shape(obj) for obj, _ in links}
        if len(self._parts) > 1:
            self._parts = {obj: without_location(part) for obj, part in self._parts.items()}
        self.shapes = [self._find(obj, name) for obj, name in links]

    def _find(self, obj, name):
        kind = name.rstrip("0123456789")
        shape, digits = self._parts[obj], name[len(kind) :]
        found = {"Face": shape.Faces, "Edge": shape.Edges}.get(kind, [])
        if not digits or not 0 < int(digits) <= len(found):
            raise SourceError(
                tr("{label} has no {name}: choose another one.").format(
                    label=obj.Label, name=name or tr("such face")
                )
            )
        return found[int(digits) - 1]

    def edge_text(self, edge):
        """Return an edge of the ``shapes`` as the user reads it: "Plate.Edge3"."""
        for obj, part in self._parts.items():
            for number, other in enumerate(part.Edges, 1):
                if other.isSame(edge):
                    return "%s.Edge%d" % (obj.Label, number)
        return "an edge"


class Model:
    """The one shape that is analysed, with the owner of each of its faces and edges."""

    def __init__(self, objects):
        """Join the shapes of ``objects``.

        Raises SourceError without objects, or for an object without faces.
        """
        if not objects:
            raise SourceError(tr("There is nothing to analyse: the document has no faces."))
        self.objects = list(objects)
        self.parts = [world_shape(obj) for obj in self.objects]
        if len(self.parts) == 1:
            self.shape = self.parts[0]
        else:
            self.parts = [without_location(part) for part in self.parts]
            self.shape = Part.Compound(self.parts)

    def owners(self, kind, numbers, names):
        """Return {"7": [object name, "Edge3"]} for the wanted numbers.

        ``kind`` is "faces" or "edges"; ``names`` are those of the objects. Any thread may call it.
        """
        wanted = set(numbers)
        whole = _elements(self.shape, kind)
        index = Index((number, whole[number - 1]) for number in wanted)
        prefix = {"faces": "Face", "edges": "Edge"}[kind]
        owners = {}
        for name, part in zip(names, self.parts):
            for own_number, element in enumerate(_elements(part, kind), 1):
                number = index.find(element)
                if number is not None:
                    owners.setdefault(str(number), [name, "%s%d" % (prefix, own_number)])
        return owners


def without_location(shape):
    """Return the same faces and edges in the same order, without an identity location.

    FreeCAD gives the shape of each object a location of its own. With it, an edge that two objects
    share looks like two edges. The location of a single face or edge cannot be removed.
    """
    if shape.ShapeType in ("Face", "Edge") or not shape.Placement.isIdentity():
        return shape
    return Part.Compound(shape.childShapes(True, False))


def _elements(shape, kind):
    return shape.Faces if kind == "faces" else shape.Edges


class Index:
    """Numbers of shapes, which are found again by identity."""

    def __init__(self, numbered):
        self._buckets = {}
        for number, shape in numbered:
            self._buckets.setdefault(shape.hashCode(), []).append((number, shape))

    def find(self, shape):
        for number, known in self._buckets.get(shape.hashCode(), ()):
            if known.isSame(shape):
                return number
        return None
