# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document objects of the workbench have in common: a Part::FeaturePython that keeps the kernel's report."""

import json

import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import properties, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.plain import kernel

#: property, property type, help; not shown to the user
INTERNAL = (
    ("Report", "App::PropertyString", "What the kernel found, as JSON"),
    ("SeamwrightVersion", "App::PropertyString", "The version that wrote this object"),
)

CANCELLED = "Cancelled; the results are those of the last complete run."


class Feature:
    """Proxy of a document object. A subclass has a ``Type`` and computes; nothing is kept beside the properties.

    ``TOLERANCES``: a table as properties.TOLERANCES; ``EMPTY_REPORT``: what a report of nothing has beside target and tolerances.
    """

    Type = ""
    TOLERANCES = ()
    EMPTY_REPORT = {}

    # What a subclass says.

    @staticmethod
    def add_properties(obj):
        """Add the properties an object lacks, with their defaults."""
        raise NotImplementedError

    @staticmethod
    def compute(module, obj):
        """Run the kernel ``module``: the arguments of ``store`` behind the object.

        Raises SourceError, ModelError or ValueError where there is nothing to store.
        """
        raise NotImplementedError

    @staticmethod
    def store(obj, *results):
        """Put the results into the properties; the Summary last."""
        raise NotImplementedError

    @staticmethod
    def store_failure(obj, reason):
        """Store that there is no result and why; the reason as it is told to the user."""
        raise NotImplementedError

    # What FreeCAD asks of a proxy.

    def __init__(self, obj):
        self.add_properties(obj)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        """Complete an object written by an older version; nothing is recomputed."""
        obj.Proxy = self
        self.add_properties(obj)
        hooks.attach_view(obj)

    def execute(self, obj):
        """Compute. On failure the object is marked, has no shape, and its Summary says why."""
        module = kernel.load(Part.OCC_VERSION)
        try:
            results = self.compute(module, obj)
        except module.Cancelled:
            raise RuntimeError(CANCELLED) from None
        except (sources.SourceError, module.ModelError, ValueError) as error:
            raise RuntimeError(self.store_failure(obj, str(error))) from None
        self.store(obj, *results)

    def dumps(self):
        """Nothing is kept beside the properties."""
        return None

    def loads(self, state):
        """Nothing is kept beside the properties."""

    # FreeCAD before 0.21.2 asks by these names.
    __getstate__ = dumps
    __setstate__ = loads


def is_of(obj, feature):
    """Whether a document object has a proxy of that subclass of Feature."""
    return getattr(getattr(obj, "Proxy", None), "Type", None) == feature.Type


def add(doc, feature, label):
    """A new document object of that kind, not computed yet."""
    obj = doc.addObject("Part::FeaturePython", feature.Type)
    obj.Label = label
    feature(obj)
    return obj


def tolerances(obj):
    """The tolerances of an object as arguments of the kernel, in mm and degrees."""
    return properties.arguments(obj, obj.Proxy.TOLERANCES)


def empty_report(obj):
    """A report of nothing, with the tolerances of the object and its target, if it has one."""
    target = {"target": obj.Target} if "Target" in obj.PropertiesList else {}
    return {**obj.Proxy.EMPTY_REPORT, **target, "tolerance": tolerances(obj)}


def report_of(obj):
    """The stored report as a dict; an empty report when nothing was computed yet."""
    return json.loads(obj.Report) if obj.Report else empty_report(obj)


def keep_report(obj, report):
    """Store what the kernel found."""
    obj.Report = json.dumps(report)
    obj.SeamwrightVersion = __version__


def put_shape(obj, shape):
    """Give the object the shape, where it stands: while it recomputes, FreeCAD moves a shape to the object's Placement."""
    obj.Placement = shape.Placement
    obj.Shape = shape
