# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that are curves made from other curves or points.

Each is a wire, a compound of wires or a surface, at its position in the model. It follows its
sources, which are only read.
"""

from typing import Any, NamedTuple

import FreeCAD as App
import Part

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.option_feature import (
    OptionFeature,
    links,
    links_of,
    set_values,
    values_of,
)
from freecad.seamwright.plain import kernel, options


class Made(NamedTuple):
    """A curve: ``shape``, ``report`` (a dict of figures) and ``summary`` (one line)."""

    shape: Any
    report: dict
    summary: str


class Curve(OptionFeature):
    """Proxy of a Part::FeaturePython that holds a curve."""

    GROUP = "Curve"
    LINKS = (
        ("Sources", "Made from", "Points, edges, wires or sketches from which the curve is made"),
    )

    #: Whether the panel of a new curve without sources lets the user pick points in the view.
    PICKS = False

    # Methods that a subclass defines.

    @classmethod
    def needs_sources(cls, values):
        """Return whether there is no curve without sources."""
        return True

    @classmethod
    def gather(cls, module, shapes, values):
        """Return what ``compute`` needs of shapes; the {argument: value} are of OPTIONS.

        Raises ValueError where the shapes are not what is needed.
        """
        raise NotImplementedError

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the curves of the kernel. Any thread may call it."""
        raise NotImplementedError

    @classmethod
    def build(cls, module, found, values):
        """Return (report, shape) of what ``compute`` returned."""
        raise NotImplementedError

    @classmethod
    def suggested(cls, gathered):
        """Return the {argument: value} that suit what was gathered; others have their defaults."""
        return {}

    @classmethod
    def points(cls, report):
        """Return the points to which numbers in lists of options belong, in their order."""
        return report.get("points_mm", [])

    # The function.

    @classmethod
    def make(cls, shapes, **given):
        """Return the Made of shapes. Raises ValueError where there is none."""
        module = kernel.load(Part.OCC_VERSION)
        values = {**options.defaults(cls.OPTIONS), **options.checked(cls.OPTIONS, given)}
        found = cls.compute(module, cls.gather(module, shapes, values), values, None)
        report, shape = cls.build(module, found, values)
        return Made(shape, report, cls.text(report))

    # The document object.

    @classmethod
    def job(cls, module, obj, private=False):
        """Return the Job that finds (report, shape)."""
        chosen, values = links_of(obj), values_of(obj)
        if not chosen and cls.needs_sources(values):
            raise sources.SourceError(
                "The sources were deleted: choose others in the property Sources"
            )
        cls.check_links(obj, {name: chosen for name, *_ in cls.LINKS})
        options.checked(cls.OPTIONS, values)
        gathered = cls.gather(module, inputs.shapes_of(chosen), values)
        return feature.Job(
            "Making the curve\u2026",
            lambda progress: cls.compute(module, gathered, values, progress),
            lambda found: cls.build(module, found, values),
        )


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
        raise ValueError("nothing is selected: %s" % kind.NEEDS)
    return found


def prepare(kind, chosen, **given):
    """Add a curve as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    values = options.checked(kind.OPTIONS, given)
    found = links(chosen) if kind.PICKS else _some(kind, chosen)
    obj = feature.add(found[0][0].Document if found else App.ActiveDocument, kind, kind.LABEL)
    obj.Sources = found
    set_values(obj, values)
    hooks.attach_view(obj)
    return obj
