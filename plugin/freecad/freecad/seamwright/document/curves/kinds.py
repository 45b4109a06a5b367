# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of curves by name, with the functions that make them."""

import Part

from freecad.seamwright.document.curves import curve
from freecad.seamwright.document.curves.arcs import Arcs
from freecad.seamwright.document.curves.blend import BlendCurves
from freecad.seamwright.document.curves.bridge import BridgeCurve
from freecad.seamwright.document.curves.clothoid import Clothoid
from freecad.seamwright.document.curves.conic import Conic
from freecad.seamwright.document.curves.fair import FairCurve
from freecad.seamwright.document.curves.join import JoinCurves
from freecad.seamwright.document.curves.log_spiral import LogSpiral
from freecad.seamwright.document.curves.spline import Spline
from freecad.seamwright.document.properties import error_text

__all__ = ["KINDS", "create", "error_text", "make"]

KINDS = {
    kind.Type: kind
    for kind in (
        Spline,
        Arcs,
        FairCurve,
        Clothoid,
        LogSpiral,
        Conic,
        BlendCurves,
        BridgeCurve,
        JoinCurves,
    )
}


def make(kind, shapes, **options):
    """Return the ``shape``, ``report`` and ``summary`` of a curve of that kind.

    ``kind``: a name of KINDS. ``shapes``: a Part.Shape or a list of them. ``options``: the
    arguments of the kind's OPTIONS. Nothing is added to a document. Raises TypeError for another
    option, ValueError where the shapes or values are not usable, kernel.KernelUnavailable when the
    compiled part is missing.
    """
    shapes = list(shapes) if isinstance(shapes, (list, tuple)) else [shapes]
    for shape in shapes:
        if not isinstance(shape, Part.Shape):
            raise TypeError("shapes has %r: a Part.Shape or a list of them is needed" % (shape,))
    return _kind(kind).make(shapes, **options)


def create(kind, sources, **options):
    """Add a curve to the document of its sources, compute it and return it.

    ``sources``: an object, or a list of objects, (object, "Edge1") and (object, ["Edge1", ...]). A
    Spline of ``points_mm`` needs none: it is added to the active document.
    ``kind`` and ``options`` as in ``make``. Where the curve cannot be made, the object has no shape
    and ``error_text`` says why.
    """
    obj = curve.prepare(_kind(kind), sources, **options)
    obj.Document.recompute()
    return obj


def _kind(name):
    if name not in KINDS:
        raise ValueError("kind %r: choose one of %s" % (name, ", ".join(KINDS)))
    return KINDS[name]
