# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common parts of the workbench's document objects.

Each object is a Part::FeaturePython that keeps the kernel's report. A computation is a ``Job``. A
recompute runs it at once. A window runs it in a separate thread (see document/plan.py), and the
recompute that follows takes over the results.
"""

import json
import sys
from typing import Any, Callable, NamedTuple

import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import preferences, properties, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import CANCELLED, DONE, OUTCOMES, OUTDATED, WITHOUT
from freecad.seamwright.plain import kernel
from freecad.seamwright.plain.language import tr

#: property, property type, help; not shown to the user
INTERNAL = (
    ("Report", "App::PropertyString", "The report of the kernel, as JSON"),
    ("SeamwrightVersion", "App::PropertyString", "Version of Seamwright that wrote the results"),
    ("PlacedAt", "App::PropertyString", "Where the parts lie that contain the sources, as JSON"),
    ("Outcome", "App::PropertyString", "How the last computation ended: %s" % ", ".join(OUTCOMES)),
)


class Job(NamedTuple):
    """One computation, with all that it needs from the document.

    ``run(progress)`` does not access the document, so any thread may call it. ``finish(found)`` is
    called with the return value of ``run``, where the document may be read; it returns the
    arguments of ``store``. ``text`` tells the user what is computed.
    """

    text: str
    run: Callable[[Any], Any]
    finish: Callable[[Any], tuple]


class _Title(type):
    """The report view shows the text of an exception's class before its message."""

    def __str__(cls):
        return cls.__module__


class Unusable(RuntimeError, metaclass=_Title):
    """Tells FreeCAD that an object is in error; the report view shows the text alone.

    FreeCAD writes the text and then a traceback, which says nothing to the user: it is cut off from
    the moment when the text is asked for until FreeCAD forgets the error.
    """

    __module__ = "Seamwright"

    def __str__(self):
        sys.tracebacklimit = 0
        return super().__str__()

    def __del__(self):
        if getattr(sys, "tracebacklimit", None) == 0:
            del sys.tracebacklimit


class Feature:
    """Proxy of a document object; it keeps no state besides the properties.

    A subclass has a ``Type`` and computes. ``TOLERANCES``: a table like properties.TOLERANCES.
    ``EMPTY_REPORT``: the entries of an empty report besides target and tolerances. ``INPUTS``: the
    names of the other properties on which a computation depends.

    What an option panel shows: the texts of the command, LINKS: (property, its name in the panel,
    help) of the sources, the table OPTIONS, and LEVEL: (property, values) of the level of
    continuity that stands beside the tolerances.
    """

    Type = LABEL = ICON = GROUP = ""
    TOLERANCES = ()
    EMPTY_REPORT = {}
    INPUTS = ()
    LINKS = OPTIONS = ()
    LEVEL = None

    #: The results of a computation in another thread, for the next recompute; see plan.Plan.
    ready = None

    #: Whether the next recompute only tells FreeCAD that the object is as it should be.
    is_kept = False

    # Methods that a subclass defines.

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        raise NotImplementedError

    @staticmethod
    def source_objects(obj):
        """Return the objects on whose shapes a computation depends."""
        raise NotImplementedError

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job for the kernel ``module``.

        ``private``: the Job works on copies of the shapes, so that another thread may run it. This
        method and ``run`` of the Job raise SourceError, ModelError or ValueError where nothing can
        be computed.
        """
        raise NotImplementedError

    @classmethod
    def handles(cls, report):
        """Return {argument: (origin, step)} of numbers to drag, each at origin + number step."""
        return report.get("handles", {})

    @staticmethod
    def has_result(report):
        """Return whether a report has the wanted result, so that the object has a shape."""
        return True

    @staticmethod
    def store(obj, *results):
        """Put the results into the properties; the Summary is written last."""
        raise NotImplementedError

    @staticmethod
    def store_failure(obj, reason):
        """Store that there is no result and why; return the reason as the user reads it."""
        raise NotImplementedError

    # Methods that FreeCAD calls.

    def __init__(self, obj):
        self.add_properties(obj)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        """Add the properties that an object of an older version lacks; nothing is recomputed."""
        obj.Proxy = self
        self.add_properties(obj)
        hooks.attach_view(obj)

    def mustExecute(self, obj):
        """Return whether the last computation was cancelled, or a part with a source was moved.

        Then the object is computed although no property changed.
        """
        if getattr(obj, "Outcome", "") in (CANCELLED, OUTDATED):
            return True
        return getattr(obj, "PlacedAt", "") != self._placed_at(obj)

    @classmethod
    def placed_objects(cls, obj):
        """Return the objects whose places count."""
        return cls.source_objects(obj)

    @classmethod
    def _placed_at(cls, obj):
        """Return where the parts lie that contain sources; FreeCAD tells no one that they move."""
        places = {each.Name: sources.parent_placement(each) for each in cls.placed_objects(obj)}
        moved = {
            name: place.toMatrix().A for name, place in places.items() if not place.isIdentity()
        }
        return json.dumps(moved) if moved else ""

    def execute(self, obj):
        """Compute, or take over what was computed; ``Outcome`` and Summary tell how it ended.

        Where the source cannot be used or the kernel is missing, and after an unexpected error,
        FreeCAD also marks the object as invalid.
        """
        if self.is_kept:
            return
        module = kernel.load(Part.OCC_VERSION)
        try:
            report, *rest = self._results(module, obj)
        except module.Cancelled:
            self._store_cancelled(obj)
        except ValueError as error:
            self._store_none(obj, error)
        except (sources.SourceError, module.ModelError) as error:
            raise Unusable(self._store_none(obj, error)) from None
        except Exception as error:  # a fault of the program: no earlier result stays for a new one
            self._store_none(obj, tr("unexpected error: {error}").format(error=repr(error)))
            raise
        else:
            obj.Outcome = DONE if self.has_result(report) else WITHOUT
            self.store(obj, report, *rest)
        finally:
            obj.PlacedAt = self._placed_at(obj)

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
        """Keep the results of an earlier computation, if there are any."""
        obj.Outcome = OUTDATED if obj.Report else CANCELLED
        if not obj.Report:
            obj.Summary = tr(properties.OUTCOMES[CANCELLED])

    def dumps(self):
        """Return None: the properties keep all state."""
        return None

    def loads(self, state):
        """Do nothing: the properties keep all state."""

    # FreeCAD before 0.21.2 calls these names.
    __getstate__ = dumps
    __setstate__ = loads


def clear_error(obj):
    """Take FreeCAD's mark of an error away where an undo brought the results back.

    The undo restores properties, but not the mark. No property changes, so that redo stays.
    """
    if getattr(obj, "Outcome", "") != DONE or "Invalid" not in obj.State:
        return
    obj.Proxy.is_kept = True
    try:
        obj.touch()
        obj.recompute()
    finally:
        obj.Proxy.is_kept = False
    if "Invalid" not in obj.State:
        obj.purgeTouched()


def is_of(obj, feature):
    """Return whether the proxy of a document object belongs to that subclass of Feature."""
    return getattr(getattr(obj, "Proxy", None), "Type", None) == feature.Type


def add(doc, feature, label):
    """Return a new document object of that kind, not computed yet."""
    obj = doc.addObject("Part::FeaturePython", feature.Type)
    obj.Label = tr(label)
    feature(obj)
    preferences.apply(obj)
    return obj


def tolerances(obj):
    """Return the tolerances of an object as arguments of the kernel, in mm and degrees."""
    return properties.arguments(obj, obj.Proxy.TOLERANCES)


def empty_report(obj):
    """Return an empty report with the tolerances of the object and its target, if it has one."""
    target = {"target": obj.Target} if "Target" in obj.PropertiesList else {}
    return {**obj.Proxy.EMPTY_REPORT, **target, "tolerance": tolerances(obj)}


def report_of(obj):
    """Return the stored report as a dict; an empty report when nothing was computed yet."""
    return json.loads(obj.Report) if obj.Report else empty_report(obj)


def keep_report(obj, report):
    """Store the report of the kernel."""
    keep_text(obj, json.dumps(report))


def keep_text(obj, text):
    """Store the report of the kernel as the text that it is."""
    obj.Report = text
    obj.SeamwrightVersion = __version__


def model_maker(module, shape, private):
    """Return a callable() -> Model of a shape.

    ``private``: the Model is made of a copy of the shape as it is now, and any thread may call it.
    """
    if private:
        return module.bridge.model_later(shape)
    model = module.Model.from_freecad(shape)
    return lambda: model


def put_shape(obj, shape):
    """Give the object the shape at its position in the model.

    During a recompute, FreeCAD moves a shape to the object's Placement. So the Placement is set
    first.
    """
    obj.Placement = shape.Placement
    obj.Shape = shape
