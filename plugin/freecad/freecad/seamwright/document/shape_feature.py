# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects with options that are made from the shapes of their sources alone."""

from typing import Any, NamedTuple

import Part

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.option_feature import (
    OptionFeature,
    links_of,
    values_of,
    without_sources,
)
from freecad.seamwright.plain import kernel, options
from freecad.seamwright.plain.language import inside, tr


class Made(NamedTuple):
    """A result: ``shape``, ``report`` (a dict of figures) and ``summary`` (one line)."""

    shape: Any
    report: dict
    summary: str


class ShapeFeature(OptionFeature):
    """Proxy of a Part::FeaturePython that is made from shapes."""

    # Methods that a subclass defines.

    @classmethod
    def needs_sources(cls, values):
        """Return whether there is nothing to make without sources."""
        return True

    @classmethod
    def gather(cls, module, shapes, values):
        """Return what ``compute`` needs of shapes; the {argument: value} are of OPTIONS.

        Raises ValueError where the shapes are not what is needed.
        """
        raise NotImplementedError

    @classmethod
    def gather_all(cls, module, shapes, values):
        """Return what ``compute`` needs of the {property: shapes} of LINKS."""
        return cls.gather(module, shapes[cls.LINKS[0][0]], values)

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return what the kernel made. Any thread may call it."""
        raise NotImplementedError

    @classmethod
    def build(cls, module, found, values):
        """Return (report, shape) of what ``compute`` returned."""
        raise NotImplementedError

    @classmethod
    def suggested(cls, gathered):
        """Return the {argument: value} that suit what was gathered; others have their defaults."""
        return {}

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
        chosen = {name: links_of(obj, name) for name, *_ in cls.LINKS}
        values = values_of(obj)
        if not chosen[cls.LINKS[0][0]] and cls.needs_sources(values):
            raise sources.SourceError(without_sources(obj, "Sources").format(
                advice=cls.advice("Sources")
            ))
        cls.check_links(obj, chosen)
        options.checked(cls.OPTIONS, values)
        shapes = {name: inputs.shapes_of(each) for name, each in chosen.items()}
        gathered = cls.gather_all(module, shapes, values)
        return feature.Job(
            tr("Making the {group}\u2026").format(group=inside(cls.GROUP)),
            lambda progress: cls.compute(module, gathered, values, progress),
            lambda found: cls.build(module, found, values),
        )
