# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that have one source, the property ``Source``, and name elements of it."""

import operator

import FreeCAD as App

from freecad.seamwright.document import sources
from freecad.seamwright.plain.language import mark, tr

KINDS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}
WORDS = {"Face": mark("a face"), "Edge": mark("an edge"), "Vertex": mark("a vertex")}


def source_objects(obj):
    """Return the source as a list of one object; an empty list where it was deleted."""
    return [] if obj.Source is None else [obj.Source]


def source_shape(obj):
    """Return the shape of the source at its position in the model. Raises SourceError."""
    if obj.Source is None:
        raise sources.SourceError(
            tr("The source was deleted: choose another one")
        )
    return sources.world_shape(obj.Source)


def names(obj, name):
    """Return the elements that a property names: ["Face3", ...]."""
    link = getattr(obj, name)
    return [element for element in link[1] if element] if link else []


def set_names(obj, name, chosen):
    """Let a property name elements of the source, ["Face3", ...]; no names empty it."""
    setattr(obj, name, link_to(obj, chosen))


def link_to(obj, chosen):
    """Return the value of a property that names elements of the source, ["Face3", ...].

    Without elements this is None.
    """
    return (obj.Source, list(chosen)) if chosen else None


def checked_names(argument, given, kind):
    """Return ["Face3", ...] for a sequence of names or of numbers from 1.

    Raises TypeError for anything else. Whether the source has these elements is checked when the
    object is computed.
    """
    if isinstance(given, str) or not hasattr(given, "__iter__"):
        raise TypeError(
            '%s = %r: a list is needed, of names, "%s1", or of numbers from 1'
            % (argument, given, kind)
        )
    return [
        checked_name("%s[%d]" % (argument, index), each, kind) for index, each in enumerate(given)
    ]


def checked_object(argument, given):
    """Return a document object that is given. Raises TypeError for anything else."""
    if not isinstance(given, App.DocumentObject):
        raise TypeError("%s = %r: an object of a document is needed" % (argument, given))
    return given


def checked_link(argument, given, kind):
    """Return (object, "Face3") for (object, "Face3") or (object, 3).

    Raises TypeError for anything else.
    """
    if not isinstance(given, (list, tuple)) or len(given) != 2:
        raise TypeError('%s = %r: (object, "%s1") is needed' % (argument, given, kind))
    obj, name = given
    return checked_object(argument, obj), checked_name(argument, name, kind)


def checked_name(argument, given, kind):
    """Return "Face3" for "Face3" or for 3. Raises TypeError for anything else."""
    try:
        name = given if isinstance(given, str) else "%s%d" % (kind, operator.index(given))
    except TypeError:
        name = ""
    if isinstance(given, bool) or not name:
        raise TypeError(
            '%s = %r: a name is needed, "%s1", or a number from 1' % (argument, given, kind)
        )
    return name


def numbers(obj, shape, name, kind):
    """Return the numbers of the elements that a property names.

    All of them must be of one kind of ``KINDS`` and exist in the source; else SourceError is
    raised.
    """
    link = getattr(obj, name)
    if not link or link[0] is None:
        return []
    if link[0] != obj.Source:
        raise sources.SourceError(
            tr("{name} names {label}, which is not the source {source}").format(
                name=name, label=link[0].Label, source=obj.Source.Label
            )
        )
    return [checked_number(obj.Source, shape, element, kind) for element in names(obj, name)]


def checked_number(source, shape, element, kind):
    """Return 3 for "Face3" of an object with this shape. Raises SourceError for anything else."""
    count = len(getattr(shape, KINDS[kind]))
    digits = element[len(kind) :] if element.startswith(kind) else ""
    if any(element.startswith(other) for other in KINDS if other != kind):
        raise sources.SourceError(
            tr("{element} is not {what}: name one, such as {kind}1.").format(
                element=element, what=tr(WORDS[kind]), kind=kind
            )
        )
    if not digits.isdecimal() or not 0 < int(digits) <= count:
        raise sources.SourceError(tr("{label} has no {element}: choose another one.").format(
            label=source.Label, element=element
        ))
    return int(digits)
