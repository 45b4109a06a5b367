# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that are curves made from other curves or points.

Each is a wire, a compound of wires or a surface, at its position in the model. It follows its
sources, which are only read.
"""

import FreeCAD as App
import Part

from freecad.seamwright.document import feature
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.option_feature import links, links_of, set_values
from freecad.seamwright.document.shape_feature import ShapeFeature
from freecad.seamwright.plain import kernel, options
from freecad.seamwright.plain.language import tr


class Curve(ShapeFeature):
    """Proxy of a Part::FeaturePython that holds a curve."""

    GROUP = "Curve"
    LINKS = (
        ("Sources", "Made from", "Points, edges, wires or sketches from which the curve is made"),
    )

    REQUIRED = ("Sources",)

    #: Whether the panel of a new curve without sources lets the user pick points in the view.
    PICKS = False

    @classmethod
    def points(cls, report):
        """Return the points to which numbers in lists of options belong, in their order."""
        return report.get("points_mm", [])


def share_of(progress, place, count):
    """Return the progress of one of several computations; None without one."""
    if progress is None:
        return None
    return lambda fraction: progress((place + fraction) / count)


def each_asked(module, progress, items):
    """Yield the items of a list. Raises Cancelled where the progress says that it is stopped."""
    for place, item in enumerate(items):
        if progress is not None and not progress(place / len(items)):
            raise module.Cancelled
        yield item


def is_curve(obj):
    """Return whether a document object is one of these curves."""
    return isinstance(getattr(obj, "Proxy", None), Curve)


def suggested(kind, chosen):
    """Return the {argument: value} of options that suit ``chosen``, for ``prepare``.

    Raises SourceError or ValueError where such a curve cannot be made from ``chosen``,
    KernelUnavailable where the compiled part is missing.
    """
    module = kernel.load(Part.OCC_VERSION)
    shapes = inputs.shapes_of(_some(kind, chosen))
    return kind.suggested(kind.gather(module, shapes, options.defaults(kind.OPTIONS)))


def _some(kind, chosen):
    found = links(chosen)
    if not found:
        raise ValueError(tr("nothing is selected: {needs}").format(needs=tr(kind.NEEDS)))
    return found


def prepare(kind, chosen, **given):
    """Add a curve as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    values = options.checked(kind.OPTIONS, given)
    found = links(chosen) if kind.PICKS else _some(kind, chosen)
    document = found[0][0].Document if found else App.ActiveDocument
    if document is None:
        raise ValueError(tr("no document is open: make or open one first"))
    obj = feature.add(document, kind, kind.LABEL)
    obj.Sources = found
    set_values(obj, values)
    hooks.attach_view(obj)
    return obj
