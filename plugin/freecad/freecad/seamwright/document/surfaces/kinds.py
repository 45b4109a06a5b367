# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of surfaces by name, with the functions that make their document objects."""

import Part

from freecad.seamwright.document import feature
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.option_feature import links, set_values
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.document.surfaces.blend import BlendSurface
from freecad.seamwright.document.surfaces.extend import ExtendSurface
from freecad.seamwright.document.surfaces.loft import FrameLoft
from freecad.seamwright.document.surfaces.umbrella import Umbrella
from freecad.seamwright.plain import kernel, options
from freecad.seamwright.plain.language import tr

__all__ = ["KINDS", "arranged", "create", "error_text", "prepare"]

KINDS = {kind.Type: kind for kind in (BlendSurface, ExtendSurface, Umbrella, FrameLoft)}


def arranged(kind, chosen):
    """Return ({property: links}, {argument: value}) for the objects and elements of a selection.

    ``kind``: a class of KINDS. Raises SourceError or ValueError where such a surface cannot be
    made from them, KernelUnavailable where the compiled part is missing.
    """
    kernel.load(Part.OCC_VERSION)
    found = links(chosen)
    if not found:
        raise ValueError(tr("nothing is selected: {needs}").format(needs=tr(kind.NEEDS)))
    return kind.arranged(found)


def create(name, sources, **given):
    """Add a surface to the document of its sources, compute it and return it.

    ``name``: of KINDS. ``sources``: a dict of the properties that name elements, such as {"Start":
    [(object, "Edge3")], "End": [(object, ["Edge7", "Face2"])]}; or a list of (object, "Edge1") and
    (object, ["Edge1", ...]), which is arranged as a selection is. ``given``: arguments of the
    kind's OPTIONS. Raises TypeError for another option, ValueError where the sources or values are
    not usable, KernelUnavailable when the compiled part is missing. Where the surface cannot be
    made, the object has no shape and ``error_text`` says why.
    """
    if name not in KINDS:
        raise ValueError("kind %r: choose one of %s" % (name, ", ".join(KINDS)))
    kind = KINDS[name]
    if not isinstance(sources, dict):
        sources, suggested = arranged(kind, sources)
        given = {**suggested, **given}
    obj = prepare(kind, sources, **given)
    obj.Document.recompute()
    return obj


def prepare(kind, sources, **given):
    """Add a surface of a class of KINDS, with {property: links}, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    values = options.checked(kind.OPTIONS, given)
    known = [entry[0] for entry in kind.LINKS]
    for name in sources:
        if name not in known:
            raise TypeError("unknown sources %r: choose from %s" % (name, ", ".join(known)))
    found = {name: links(chosen) for name, chosen in sources.items()}
    for name in kind.REQUIRED:
        if not found.get(name):
            raise ValueError(tr("{name} has no edge: {needs}").format(
                name=name, needs=tr(kind.NEEDS)
            ))
    obj = feature.add(found[known[0]][0][0].Document, kind, kind.LABEL)
    for name, chosen in found.items():
        setattr(obj, name, chosen)
    set_values(obj, values)
    hooks.attach_view(obj)
    return obj
