# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that draw an analysis of shapes.

They have no shape. Their sources are only read. What is drawn is not stored: it is computed again
from the sources.
"""

from typing import Any, NamedTuple

import FreeCAD as App
import Part

from freecad.seamwright.document import feature, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.option_feature import (
    OptionFeature,
    links,
    links_of,
    set_values,
    values_of,
    without_sources,
)
from freecad.seamwright.plain import kernel, options
from freecad.seamwright.plain.language import tr


class Made(NamedTuple):
    """The result of a tool: ``found`` (arrays, see the tool), ``report`` (figures), ``summary``."""

    found: Any
    report: dict
    summary: str


class Input(NamedTuple):
    """A shape of a source: ``shape`` with its own placement, and the ``name`` of its object.

    ``parent``: the placement of the parts that contain the object. ``element``: "Edge3" or "".
    ``label``: of the object, as the user reads it.
    """

    name: str
    shape: Any
    parent: Any
    element: str
    label: str = ""


class Tool(OptionFeature):
    """Proxy of a Part::FeaturePython without a shape that draws something."""

    GROUP = "Analysis"
    LINKS = (("Sources", "Drawn on", "Objects with faces"),)

    #: Whether nothing selected stands for all visible objects.
    TAKES_ALL = False

    # Methods that a subclass defines.

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        raise NotImplementedError

    @classmethod
    def arranged(cls, chosen):
        """Return {property: links} for links of a selection. Raises as ``check``."""
        cls.check("Sources", chosen)
        return {"Sources": cls.completed(chosen)}

    @classmethod
    def completed(cls, chosen):
        """Return links with those that belong to them."""
        return chosen

    @classmethod
    def work(cls, inputs, values):
        """Return a callable(progress) -> found of {property: [Input]}, for any thread.

        ``found`` is None where ``progress`` stopped it.
        """
        raise NotImplementedError

    @classmethod
    def report(cls, found, values):
        """Return the report, a dict for JSON."""
        raise NotImplementedError

    @classmethod
    def marks(cls, report):
        """Return [(point, text), ...] that are shown in the view."""
        return []

    # The function.

    @classmethod
    def make(cls, shapes, **given):
        """Return the Made of {property: shapes}, or of the shapes of the first property.

        Instead of a shape, (shape, "Edge3") names an element of it.
        """
        kernel.load(Part.OCC_VERSION)
        values = {**options.defaults(cls.OPTIONS), **options.checked(cls.OPTIONS, given)}
        if not isinstance(shapes, dict):
            shapes = {cls.LINKS[0][0]: shapes}
        inputs = {name: _given_inputs(shapes.get(name, [])) for name, *_ in cls.LINKS}
        found = cls.work(inputs, values)(None)
        report = cls.report(found, values)
        return Made(found, report, cls.text(report))

    # The document object.

    @classmethod
    def job(cls, module, obj, private=False):
        """Return the Job that finds (report, no shape)."""
        work, values = cls.prepared(obj)

        def run(progress):
            found = work(progress)
            if found is None:
                raise module.Cancelled("cancelled")
            return found

        return feature.Job(
            tr("Analysing\u2026"), run, lambda found: (cls.report(found, values), Part.Shape())
        )

    @classmethod
    def prepared(cls, obj):
        """Return (``work`` of an object as it is now, its {argument: value})."""
        values = values_of(obj)
        options.checked(cls.OPTIONS, values)
        inputs = {name: [_input(*link) for link in links_of(obj, name)] for name, *_ in cls.LINKS}
        for name in inputs:
            if not inputs[name]:
                raise sources.SourceError(
                    without_sources(obj, name).format(advice=cls.advice(name))
                )
        return cls.work(inputs, values), values


def _given_inputs(shapes):
    """Return the Inputs of a shape, of (shape, element), or of a list of these."""
    every = shapes if isinstance(shapes, list) else [shapes]
    pairs = [each if isinstance(each, tuple) else (each, "") for each in every]
    for shape, _ in pairs:
        if not isinstance(shape, Part.Shape):
            raise TypeError("a Part.Shape is needed, not %s" % type(shape).__name__)
    return [
        Input("Shape%d" % number, shape, App.Placement(), element)
        for number, (shape, element) in enumerate(pairs, 1)
    ]


def _input(obj, element):
    if not sources.has_shape(obj) or Part.getShape(obj).isNull():
        raise sources.SourceError(tr("{label} has no shape: choose another object").format(
            label=obj.Label
        ))
    place = sources.parent_placement(obj)
    return Input(obj.Name, Part.getShape(obj), place, element, obj.Label)


def element_shape(given):
    """Return the shape or element of an Input at its position in the model."""
    shape = given.shape
    if not given.parent.isIdentity():
        shape = Part.Compound([shape])
        shape.Placement = given.parent
    if not given.element:
        return shape
    try:
        return shape.getElement(given.element)
    except (Part.OCCError, ValueError, IndexError):
        raise sources.SourceError(
            tr("{name} has no {element}: choose another one").format(
                name=given.label or given.name, element=given.element
            )
        ) from None


def is_tool(obj):
    """Return whether a document object is one of these tools."""
    return isinstance(getattr(obj, "Proxy", None), Tool)


def prepare(kind, chosen, **given):
    """Add a tool with {property: links}, but compute nothing yet.

    Raises TypeError for another property or option, ValueError for a bad value, KernelUnavailable
    when the compiled part is missing.
    """
    kernel.load(Part.OCC_VERSION)
    values = options.checked(kind.OPTIONS, given)
    known = [entry[0] for entry in kind.LINKS]
    for name in chosen:
        if name not in known:
            raise TypeError("unknown sources %r: choose from %s" % (name, ", ".join(known)))
    found = {name: links(each) for name, each in chosen.items()}
    for name, title, _ in kind.LINKS:
        if not found.get(name):
            raise ValueError(tr("nothing is chosen for \u201c{title}\u201d: {needs}").format(
                title=tr(title), needs=tr(kind.NEEDS)
            ))
    obj = feature.add(found[known[0]][0][0].Document, kind, kind.LABEL)
    for name, chosen_links in found.items():
        setattr(obj, name, chosen_links)
    set_values(obj, values)
    hooks.attach_view(obj)
    return obj
