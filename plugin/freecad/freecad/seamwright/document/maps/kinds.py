# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis tools by name, with the functions that use them."""

from freecad.seamwright.document.maps import tool
from freecad.seamwright.document.maps.combs import CurvatureComb
from freecad.seamwright.document.maps.curvature import CurvatureMap
from freecad.seamwright.document.maps.deviation import Deviation
from freecad.seamwright.document.maps.draft import DraftAngle
from freecad.seamwright.document.maps.reflection import ReflectionLines
from freecad.seamwright.document.maps.seam_plot import SeamPlot
from freecad.seamwright.document.properties import error_text

__all__ = ["KINDS", "create", "error_text", "make"]

KINDS = {
    kind.Type: kind
    for kind in (CurvatureComb, CurvatureMap, ReflectionLines, DraftAngle, Deviation, SeamPlot)
}


def make(kind, shapes, **options):
    """Return ``found`` (arrays), ``report`` (figures) and ``summary`` of shapes.

    ``kind``: a name of KINDS. ``shapes``: a Part.Shape, a (shape, "Edge3"), or a list of these; for
    Deviation a dict {"Sources": shapes, "Reference": shapes}. ``options``: the arguments of the
    kind's OPTIONS. Nothing is added to a document. Raises TypeError for another option, ValueError
    or SourceError where the shapes or values are not usable, kernel.KernelUnavailable when the
    compiled part is missing.
    """
    return _kind(kind).make(shapes, **options)


def create(kind, sources, **options):
    """Add a tool to the document of its sources, compute it and return it.

    ``sources``: an object, or a list of objects, (object, "Edge1") and (object, ["Edge1", ...]);
    or a dict of these by property. ``kind`` and ``options`` as in ``make``. Where there is nothing
    to show, ``error_text`` says why.
    """
    if not isinstance(sources, dict):
        sources = _kind(kind).arranged(tool.links(sources))
    obj = tool.prepare(_kind(kind), sources, **options)
    obj.Document.recompute()
    return obj


def _kind(name):
    if name not in KINDS:
        raise ValueError("kind %r: choose one of %s" % (name, ", ".join(KINDS)))
    return KINDS[name]
