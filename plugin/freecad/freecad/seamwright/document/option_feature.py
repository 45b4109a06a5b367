# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects that are made from sources and a table of options: curves and surfaces.

The table has their properties, the arguments of functions and the fields of their panel.
"""

import json

import Part

from freecad.seamwright.document import feature, properties, sources
from freecad.seamwright.plain import curve_text, kernel_words, options
from freecad.seamwright.plain.language import mark, tr

LINKED = (
    "Linked", "App::PropertyStringList", "The sources as they were chosen: property, object, name"
)  # fmt: skip
SUMMARY = ("Summary", "App::PropertyString", "The result in one line, or why there is none")

#: What the summary says of a shape that OpenCASCADE refuses.
INVALID = mark(" The shape is not valid: it may cross itself; try smaller numbers.")


class OptionFeature(feature.Feature):
    """Proxy of a Part::FeaturePython that has options.

    A subclass has the texts of its command, NEEDS (what to select), GROUP (of its properties), the
    tables of Feature, and RESULTS: (property, its type, help, key of the report).
    """

    TIP = NEEDS = ""
    REQUIRED = ()  # the properties of LINKS that must name something
    RESULTS = ()

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        raise NotImplementedError

    @classmethod
    def in_words(cls, text):
        """Return a sentence of the kernel in the words of the panel."""
        return kernel_words.in_words(text, {each.argument: each.label for each in cls.OPTIONS})

    @classmethod
    def add_properties(cls, obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        for name, _, tip in cls.LINKS:
            adder.add("App::PropertyLinkSubListGlobal", name, cls.GROUP, tip)
        adder.add_options(cls.OPTIONS, cls.GROUP)
        shown = [SUMMARY, *(result[:3] for result in cls.RESULTS)]
        adder.add_results(shown, (*feature.INTERNAL, LINKED))
        obj.setEditorMode("Placement", ["Hidden"])

    @classmethod
    def source_objects(cls, obj):
        """Return the objects to which the sources belong, without repeats."""
        return list(
            dict.fromkeys(each for name, *_ in cls.LINKS for each, _ in links_of(obj, name))
        )

    def onDocumentRestored(self, obj):
        """Remember the sources of an object of an older version, too."""
        super().onDocumentRestored(obj)
        if not obj.Linked:
            for name, *_ in self.LINKS:
                _remember(obj, name)

    def onChanged(self, obj, prop):
        """Remember the sources that are chosen.

        FreeCAD removes an object that is deleted from the links: then they are as remembered.
        """
        if prop in [name for name, *_ in self.LINKS]:
            remember_chosen(obj, prop)

    @classmethod
    def check_links(cls, obj, chosen):
        """Raise SourceError where an object of {property: links} was deleted.

        A property whose links were chosen otherwise since then does not count.
        """
        for name, *_ in cls.LINKS:
            if chosen[name] != links_of(obj.Document.getObject(obj.Name), name):
                continue
            check_not_deleted(obj, name, not cls.REQUIRED or name in cls.REQUIRED)

    @classmethod
    def advice(cls, name):
        """Return how the user chooses other links for a property."""
        return advice(cls, name, not cls.REQUIRED or name in cls.REQUIRED)

    @classmethod
    def store(cls, obj, report, shape):
        """Put the results into the read-only properties; the Summary is written last."""
        feature.keep_report(obj, report)
        for name, _, _, key in cls.RESULTS:
            setattr(obj, name, report[key])
        feature.put_shape(obj, shape)
        text = cls.text(report)
        obj.Summary = text if shape.isNull() or shape.isValid() else text + tr(INVALID)

    @classmethod
    def store_failure(cls, obj, reason):
        """Store that there is no result and why; return the reason."""
        reason = cls.in_words(reason)
        obj.Report = json.dumps({"reason": reason})
        for name, *_ in cls.RESULTS:
            setattr(obj, name, 0)
        feature.put_shape(obj, Part.Shape())
        obj.Summary = curve_text.failure_text(reason)
        return obj.Summary


def remember_chosen(obj, prop):
    """Remember the objects that a property links to, unless one of them is being deleted."""
    if "Linked" not in obj.PropertiesList or "Restore" in obj.State:
        return
    if not any(_is_going(obj, each) for each in _linked(obj, prop)):
        _remember(obj, prop)


def _remember(obj, prop):
    others = [each for each in obj.Linked if each.split("\t")[0] != prop]
    names = ["\t".join((prop, each.Name, each.Label)) for each, _ in links_of(obj, prop)]
    obj.Linked = others + list(dict.fromkeys(names))


def check_not_deleted(obj, prop, required):
    """Raise SourceError where an object was deleted that a property linked to."""
    for _, label in _lost(obj, prop):
        raise sources.SourceError(tr("{label} was deleted: {advice}").format(
            label=label, advice=advice(obj.Proxy, prop, required)
        ))


def without_sources(obj, prop):
    """Return the sentence, with a place for the advice, about a property that has no links."""
    if _linked(obj, prop):
        return tr("the sources were deleted: {advice}")
    return tr("there are no sources: {advice}")


def advice(kind, prop, required):
    """Return how the user chooses other links for a property."""
    (title,) = [title for own, title, _ in kind.LINKS if own == prop]
    text = tr(
        "select others and press \u201cUse selection\u201d at \u201c{title}\u201d in the panel"
    ).format(title=tr(title))
    return text if required else text + tr(", or select nothing")


def _linked(obj, prop):
    """Return [(name, label), ...] of the objects that a property linked to when it was chosen."""
    found = (each.split("\t", 2) for each in getattr(obj, "Linked", ()))
    return [(name, label) for own, name, label in found if own == prop]


def _is_going(obj, linked):
    """Return whether an object of a link is being deleted."""
    found = obj.Document.getObject(linked[0])
    return found is not None and found.Removing


def _lost(obj, prop):
    return [each for each in _linked(obj, prop) if obj.Document.getObject(each[0]) is None]


def links_of(obj, name="Sources"):
    """Return [(object, "Edge3" or ""), ...] that a property links to."""
    found = getattr(obj, name) or ()
    if hasattr(found, "Name"):  # an object as a whole
        found = [(found, ("",))]
    elif found and not isinstance(found[0], (list, tuple)):  # elements of one object
        found = [found]
    return [
        (source, element)
        for source, elements in found
        if source is not None
        for element in elements
    ]


def link_value(obj, name, chosen):
    """Return [(object, "Edge3" or ""), ...] as a property holds them."""
    found = []
    for source, element in chosen:
        if found and found[-1][0] == source:
            found[-1] = (source, (*found[-1][1], element))
        else:
            found.append((source, (element,)))
    kind = obj.getTypeIdOfProperty(name)
    if "SubList" in kind:
        return found
    if not found:
        return None
    return found[0] if "Sub" in kind else found[0][0]


def value_of(obj, option):
    """Return the value of an option of an object."""
    value = getattr(obj, option.name)
    if option.kind in (options.LENGTH, options.ANGLE, options.FLOAT):
        return properties.number(obj, option.name)
    if option.kind == options.VECTOR:
        return tuple(value)
    if option.kind == options.VECTORS:
        return [tuple(each) for each in value]
    return [float(each) for each in value] if option.kind == options.NUMBERS else value


def values_of(obj):
    """Return the {argument: value} of the options of an object."""
    return {option.argument: value_of(obj, option) for option in obj.Proxy.OPTIONS}


def set_values(obj, values):
    """Give an object the {argument: value} of some of its options."""
    names = {option.argument: option.name for option in obj.Proxy.OPTIONS}
    for argument, value in values.items():
        setattr(obj, names[argument], value)


def links(chosen):
    """Return [(object, "Edge3" or ""), ...] of objects, (object, name) or (object, names)."""
    found = []
    for each in chosen if isinstance(chosen, (list, tuple)) else [chosen]:
        obj, names = each if isinstance(each, (list, tuple)) and len(each) == 2 else (each, "")
        if not hasattr(obj, "Document"):
            raise TypeError(
                "sources has %r: an object, (object, \"Edge1\") or (object, [\"Edge1\", ...]) is "
                "needed" % (obj,)
            )
        names = [names] if isinstance(names, str) else list(names)
        found += [(obj, name) for name in names or [""]]
    return found
