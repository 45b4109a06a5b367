# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the document objects that are curves made from other curves or points.

Each is a wire, a compound of wires or a surface, at its position in the model. It follows its
sources, which are only read.
"""

import json
from typing import Any, NamedTuple

import Part

from freecad.seamwright.document import feature, properties, sources
from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.plain import curve_text, kernel, options

SUMMARY = ("Summary", "App::PropertyString", "The result in one line, or why there is none")


class Made(NamedTuple):
    """A curve: ``shape``, ``report`` (a dict of figures) and ``summary`` (one line)."""

    shape: Any
    report: dict
    summary: str


class Curve(feature.Feature):
    """Proxy of a Part::FeaturePython that holds a curve.

    A subclass also has the texts of its command, NEEDS (what to select), the table OPTIONS, and
    RESULTS: (property, its type, help, key of the report).
    """

    LABEL = ICON = TIP = NEEDS = ""
    OPTIONS = ()
    RESULTS = ()

    # Methods that a subclass defines.

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
    def text(cls, report):
        """Return the summary of a report."""
        raise NotImplementedError

    @classmethod
    def suggested(cls, gathered):
        """Return the {argument: value} that suit what was gathered; others have their defaults."""
        return {}

    @classmethod
    def points(cls, report):
        """Return the points to which numbers in lists of options belong, in their order."""
        return report.get("points_mm", [])

    @classmethod
    def handles(cls, report):
        """Return {argument: (origin, step)} of numbers to drag, each at origin + number step."""
        return report.get("handles", {})

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
    def add_properties(cls, obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        tip = "Points, edges, wires or sketches from which the curve is made"
        adder.add("App::PropertyLinkSubListGlobal", "Sources", "Curve", tip)
        for option in cls.OPTIONS:
            if option.kind == options.CHOICE:
                adder.add_choice(option.name, "Curve", option.tip, option.choices, option.default)
            else:
                adder.add_with(option.kind, option.name, "Curve", option.tip, option.default)
        shown = [SUMMARY, *(result[:3] for result in cls.RESULTS)]
        adder.add_results(shown, feature.INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the objects to which the points and edges belong, without repeats."""
        return list(dict.fromkeys(each for each, _ in links_of(obj)))

    @classmethod
    def job(cls, module, obj, private=False):
        """Return the Job that finds (report, shape)."""
        links = links_of(obj)
        if not links:
            raise sources.SourceError(
                "The sources were deleted: choose others in the property Sources"
            )
        values = values_of(obj)
        options.checked(cls.OPTIONS, values)
        gathered = cls.gather(module, inputs.shapes_of(links), values)
        return feature.Job(
            "Making the curve\u2026",
            lambda progress: cls.compute(module, gathered, values, progress),
            lambda found: cls.build(module, found, values),
        )

    @classmethod
    def store(cls, obj, report, shape):
        """Put the results into the read-only properties; the Summary is written last."""
        feature.keep_report(obj, report)
        for name, _, _, key in cls.RESULTS:
            setattr(obj, name, report[key])
        feature.put_shape(obj, shape)
        obj.Summary = cls.text(report)

    @classmethod
    def store_failure(cls, obj, reason):
        """Store that there is no curve and why; return the reason."""
        obj.Report = json.dumps({"reason": reason})
        for name, *_ in cls.RESULTS:
            setattr(obj, name, 0)
        feature.put_shape(obj, Part.Shape())
        obj.Summary = curve_text.failure_text(reason)
        return obj.Summary


def links_of(obj):
    """Return [(object, "Edge3" or ""), ...] of the sources of a curve."""
    return [
        (source, name) for source, names in obj.Sources if source is not None for name in names
    ]


def value_of(obj, option):
    """Return the value of an option of an object."""
    value = getattr(obj, option.name)
    if option.kind in (options.LENGTH, options.ANGLE, options.FLOAT):
        return properties.number(obj, option.name)
    return [float(each) for each in value] if option.kind == options.NUMBERS else value


def values_of(obj):
    """Return the {argument: value} of the options of an object."""
    return {option.argument: value_of(obj, option) for option in obj.Proxy.OPTIONS}


def is_curve(obj):
    """Return whether a document object is one of these curves."""
    return isinstance(getattr(obj, "Proxy", None), Curve)


def links(chosen):
    """Return [(object, "Edge3" or ""), ...] of objects, (object, name) or (object, names)."""
    found = []
    for each in chosen if isinstance(chosen, (list, tuple)) else [chosen]:
        obj, names = each if isinstance(each, (list, tuple)) else (each, "")
        names = [names] if isinstance(names, str) else list(names)
        found += [(obj, name) for name in names or [""]]
    return found


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
    found, values = _some(kind, chosen), options.checked(kind.OPTIONS, given)
    obj = feature.add(found[0][0].Document, kind, kind.LABEL)
    obj.Sources = found
    names = {option.argument: option.name for option in kind.OPTIONS}
    for argument, value in values.items():
        setattr(obj, names[argument], value)
    hooks.attach_view(obj)
    return obj
