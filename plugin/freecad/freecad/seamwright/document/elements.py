# SPDX-License-Identifier: LGPL-2.1-or-later
"""An object that is made from one source, the property ``Source``, and from faces, edges or vertices of it."""

from freecad.seamwright.document import sources

KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}


def source_objects(obj):
    """The source, as a list of one object, or of none where it was deleted."""
    return [] if obj.Source is None else [obj.Source]


def source_shape(obj):
    """The shape of the source where it stands in the model. Raises SourceError."""
    if obj.Source is None:
        raise sources.SourceError("The source is gone: choose another one in the property Source")
    return sources.world_shape(obj.Source)


def names(obj, name):
    """The elements that a property names: ["Face3", ...]."""
    link = getattr(obj, name)
    return [element for element in link[1] if element] if link else []


def set_names(obj, name, chosen):
    """Let a property name elements of the source, ["Face3", ...]; none empties it."""
    setattr(obj, name, (obj.Source, list(chosen)) if chosen else None)


def numbers(obj, shape, name, kind):
    """The numbers of the elements that a property names, all of one of ``KINDS``. Raises SourceError for others."""
    link = getattr(obj, name)
    if not link or link[0] is None:
        return []
    if link[0] != obj.Source:
        raise sources.SourceError("%s names %s, which is not the source %s" % (name, link[0].Label, obj.Source.Label))
    count = len(getattr(shape, KINDS[kind]))
    return [_number(obj.Source, element, kind, count) for element in names(obj, name)]


def _number(source, element, kind, count):
    digits = element[len(kind) :] if element.startswith(kind) else ""
    if not digits.isdecimal() or not 0 < int(digits) <= count:
        raise sources.SourceError("%s has no %s: choose another one." % (source.Label, element))
    return int(digits)
