# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document objects of the workbench have in common: a Part::FeaturePython that keeps the
kernel's report.

A computation is a ``Job``. A recompute runs it at once. A window runs it in a thread of its own,
see document/plan.py, and the recompute that follows takes over what was found.
"""

import json
from typing import Any, Callable, NamedTuple

import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import properties, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import CANCELLED, DONE, OUTCOMES, OUTDATED, WITHOUT
from freecad.seamwright.plain import kernel

#: property, property type, help; not shown to the user
INTERNAL = (
    ("Report", "App::PropertyString", "What the kernel found, as JSON"),
    ("SeamwrightVersion", "App::PropertyString", "The version that wrote this object"),
    ("Outcome", "App::PropertyString", "How the last computation ended: %s" % ", ".join(OUTCOMES)),
)


class Job(NamedTuple):
    """One computation, with all that it needs from the document.

    ``run(progress)`` touches no document: any thread may call it. ``finish(found)`` is called where
    the document may be read, with what ``run`` returned; it returns the arguments of ``store``.
    ``text`` says what is going on.
    """

    text: str
    run: Callable[[Any], Any]
    finish: Callable[[Any], tuple]


class Feature:
    """Proxy of a document object. A subclass has a ``Type`` and computes; nothing is kept beside
    the properties.

    ``TOLERANCES``: a table as properties.TOLERANCES; ``EMPTY_REPORT``: what a report of nothing has
    beside target and tolerances. ``INPUTS``: the names of the other properties that a computation
    depends on.
    """

    Type = ""
    TOLERANCES = ()
    EMPTY_REPORT = {}
    INPUTS = ()

    #: What was computed apart from the document, for the next recompute; see plan.Plan.
    ready = None

    # What a subclass says.

    @staticmethod
    def add_properties(obj):
        """Add the properties an object lacks, with their defaults."""
        raise NotImplementedError

    @staticmethod
    def source_objects(obj):
        """The objects whose shapes a computation depends on."""
        raise NotImplementedError

    @staticmethod
    def job(module, obj, private=False):
        """The Job for the kernel ``module``. ``private``: it works on copies of the shapes, so that
        another thread may run it.

        Raises SourceError, ModelError or ValueError where there is nothing to compute; its ``run``
        does likewise.
        """
        raise NotImplementedError

    @staticmethod
    def has_result(report):
        """Whether a report is of what was asked for, so that the object has a shape of its own."""
        return True

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

    def mustExecute(self, obj):
        """Whether to compute though no property was changed: the last time it was cancelled."""
        return getattr(obj, "Outcome", "") in (CANCELLED, OUTDATED)

    def execute(self, obj):
        """Compute, or take over what was computed; ``Outcome`` and Summary say what came of it.

        Where the source is of no use, or the kernel is missing, the object is marked as in error
        too.
        """
        module = kernel.load(Part.OCC_VERSION)
        try:
            report, *rest = self._results(module, obj)
        except module.Cancelled:
            self._store_cancelled(obj)
        except ValueError as error:
            self._store_none(obj, error)
        except (sources.SourceError, module.ModelError) as error:
            raise RuntimeError(self._store_none(obj, error)) from None
        else:
            obj.Outcome = DONE if self.has_result(report) else WITHOUT
            self.store(obj, report, *rest)

    def _results(self, module, obj):
        ready, self.ready = self.ready, None
        if ready is not None and ready.is_current():
            return ready.results()
        job = self.job(module, obj)
        with hooks.progress(job.text) as progress:
            found = job.run(progress)
        return job.finish(found)

    def _store_none(self, obj, error):
        obj.Outcome = WITHOUT
        return self.store_failure(obj, str(error))

    @staticmethod
    def _store_cancelled(obj):
        """The results of an earlier run stay, if there was one."""
        obj.Outcome = OUTDATED if obj.Report else CANCELLED
        if not obj.Report:
            obj.Summary = properties.OUTCOMES[CANCELLED]

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


def model_maker(module, shape, private):
    """callable() -> Model of a shape; ``private``: of a copy, as it is now, which any thread may
    make."""
    if private:
        return module.bridge.model_later(shape)
    model = module.Model.from_freecad(shape)
    return lambda: model


def put_shape(obj, shape):
    """Give the object the shape, where it stands: while it recomputes, FreeCAD moves a shape to the
    object's Placement."""
    obj.Placement = shape.Placement
    obj.Shape = shape
