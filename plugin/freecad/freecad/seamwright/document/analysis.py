# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Seam Analysis.

It keeps the report of the kernel. Its shape has the seam edges in the order of the report. The
class path is written into documents: neither rename nor move it.
"""

import json

import FreeCAD as App
import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import elements, feature, preferences, properties, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.document.seam_results import SeamResults
from freecad.seamwright.plain import kernel, match_distance, report_text, summary
from freecad.seamwright.plain.language import mark, tr

#: property, argument of the kernel, property type, default, help
TOLERANCES = properties.TOLERANCES + (
    ("MatchDistance", "match_mm", "App::PropertyLength", 0.0,
     "Free edges no further apart than this are measured as seams too, in mm; 0: off"),
)  # fmt: skip

LEVELS = ["G0", "G1", "G2", "G3"]
DEFAULT_LEVEL = "G1"

RESULTS = (
    ("Summary", "App::PropertyString", "The result in one line, or why there is none"),
    ("Passed", "App::PropertyBool", "Whether no seam is a defect"),
    ("Seams", "App::PropertyInteger", "Number of seams"),
    ("Defects", "App::PropertyInteger", "Number of seams that fall short of the level"),
    ("Creases", "App::PropertyInteger", "Number of seams sharper than the crease angle"),
    ("Uncertain", "App::PropertyInteger", "Number of seams whose verdict is not certain"),
    ("Matched", "App::PropertyInteger", "Number of seams of two free edges that lie side by side"),
    ("OpenEdges", "App::PropertyInteger", "Number of edges that bound one face and are in no seam"),
    ("MaxGap", "App::PropertyLength", "Largest gap that was seen, creases excluded, in mm"),
    ("MaxAngle", "App::PropertyAngle", "Largest angle that was seen, creases excluded, in degrees"),
)

INTERNAL = feature.INTERNAL + (
    ("Analysed", "App::PropertyLinkListGlobal", "The objects that were analysed"),
    ("SourceNames", "App::PropertyStringList", "Names of the Sources at the last analysis"),
)  # fmt: skip

__all__ = ["SeamAnalysis", "create", "error_text", "is_analysis", "report_of"]

EMPTY_REPORT = {"seams": [], "open": []}

WORKING = mark("Analysing seams\u2026")

#: Results of this many reports are kept, so that undo and redo show them at once.
KEPT = 3

#: The largest distance that is tried where no two faces share an edge, as a part of the size.
TRIED_PART = 0.005


class SeamAnalysis(feature.Feature):
    """Proxy of a Part::FeaturePython that measures the seams of its sources."""

    Type = "SeamAnalysis"
    TOLERANCES = TOLERANCES
    INPUTS = ("Sources", "Level")

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        tip = (
            "The objects to analyse; empty: all solids and shells of the document, or where it has "
            "none, all objects with faces"
        )
        adder.add("App::PropertyLinkListGlobal", "Sources", "Seams", tip)
        adder.add_tolerances(TOLERANCES)
        adder.add_choice(
            "Level", "Tolerances", "Level that every seam should meet", LEVELS, DEFAULT_LEVEL
        )
        adder.add_results(RESULTS, INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the objects to analyse."""
        return source_objects(obj)

    @staticmethod
    def placed_objects(obj):
        """Return the objects whose places count: those that were analysed."""
        return obj.Analysed

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job that finds (report, compound of the seam edges, objects, SeamResults)."""
        deleted = _deleted_sources(obj)
        if deleted:
            raise sources.SourceError(
                tr("{names} was deleted: choose others in the property Sources").format(
                    names=", ".join(deleted)
                )
            )
        model, level, given = sources.Model(source_objects(obj)), obj.Level, tolerances(obj)
        names = [source.Name for source in model.objects]
        make = feature.model_maker(module, model.shape, private)
        size, jobs = model.shape.BoundBox.DiagonalLength, preferences.threads()

        def run(progress):
            made = make()
            text = made.analyze(**given, jobs=jobs, progress=progress).to_json()
            report = report_text.read(text)
            facts = owners(model, names, level, report)
            if report["open"] and not report["seams"] and not given["match_mm"]:
                facts.update(proposal(made, {**given, "jobs": jobs}, size, progress))
            report["freecad"] = facts
            text = report_text.with_entry(text, "freecad", facts)
            # Edges of the model, which nothing else draws or changes if it is private.
            shape = seam_edges(made.to_freecad(), report)
            return SeamResults(text, shape.Edges, report).complete(), shape

        def finish(found):
            results, shape = found
            return results.report, shape, model.objects, results

        return feature.Job(tr(WORKING), run, finish)

    @staticmethod
    def store(obj, report, shape, objects, results=None):
        """Put the results into the read-only properties.

        The Report is written before the Shape, since it gives the colours of the Shape.
        """
        if results is None:
            results = SeamResults(json.dumps(report), [], report)
        keep_results(obj, results)
        feature.keep_text(obj, results.text)
        obj.Analysed = objects
        if not _deleted_sources(obj):
            obj.SourceNames = [each.Name for each in obj.Sources]
        facts = dict(results.facts)
        text = facts.pop("Summary")
        for name, value in facts.items():
            setattr(obj, name, value)
        obj.Shape = shape
        obj.Summary = text

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report and the reason."""
        SeamAnalysis.store(obj, EMPTY_REPORT, Part.Shape(), [])
        obj.Summary = tr("Not analysed: {reason}").format(reason=reason)
        return reason


def is_analysis(obj):
    """Return whether a document object is a Seam Analysis."""
    return feature.is_of(obj, SeamAnalysis)


def report_of(obj):
    """Return the stored report as a dict, not to be changed; an empty one before any analysis."""
    return results_of(obj).report


def results_of(obj):
    """Return the SeamResults of the stored report; they are read if they are not known yet."""
    known = known_results(obj)
    if known is None:
        known = SeamResults(obj.Report, obj.Shape.Edges)
        keep_results(obj, known)
    return known


def known_results(obj):
    """Return the SeamResults of the stored report if they have been read, else None."""
    text = obj.Report
    if not text:
        return SeamResults("", [], dict(EMPTY_REPORT))
    return next((each for each in _kept(obj) if each.text == text), None)


def reader(obj):
    """Return a callable that reads the stored report; any thread may call it."""
    text, edges = obj.Report, obj.Shape.copy().Edges
    return lambda: SeamResults(text, edges).complete()


def keep_results(obj, results):
    """Remember results for ``known_results``, and forget the oldest ones."""
    obj.Proxy.kept = [results, *(each for each in _kept(obj) if each.text != results.text)][:KEPT]


def _kept(obj):
    return getattr(obj.Proxy, "kept", [])


def source_objects(obj):
    """Return the objects to analyse: the Sources, or what ``sources.everything`` finds."""
    if obj.Sources:
        return sources.expand(obj.Sources)
    return sources.everything(obj.Document, exclude=obj.Document.getObject(obj.Name))


def _deleted_sources(obj):
    """Return the names of the Sources if all of them were deleted, which empties the property."""
    names = [] if obj.Sources else obj.SourceNames
    return [name for name in names if obj.Document.getObject(name) is None]


def tolerances(obj):
    """Return the tolerances as arguments of the kernel, in mm and degrees."""
    return {**properties.arguments(obj, TOLERANCES), "level": obj.Level}


def proposal(model, given, size, progress):
    """Return the entries of the report's key "freecad" about a distance to match free edges.

    ``model``: of the kernel, of ``size`` mm, with free edges and without seams.
    """
    tried = TRIED_PART * size
    found = model.analyze(**{**given, "match_mm": tried}, progress=progress).to_dict()
    proposed = match_distance.proposed(found["seams"], tried, given["gap_mm"])
    return {"tried_match_mm": tried, "proposed_match_mm": proposed}


def owners(model, names, level, report):
    """Return the value of the report's key "freecad": the objects to which its numbers belong.

    ``names``: of the model's objects. Any thread may call it.
    """
    seams = report["seams"]
    open_edges, shared = report.get("open", []), report.get("non_manifold", [])
    edges = {number for seam in seams for number in seam["edges"]}
    edges |= {entry["edge"] for entry in open_edges + shared}
    faces = {number for seam in seams for number in seam["faces"]}
    faces |= {entry["face"] for entry in open_edges}
    faces |= {number for entry in shared for number in entry["faces"]}
    return {
        "version": __version__,
        "level": level,
        "objects": names,
        "faces": model.owners("faces", faces, names),
        "edges": model.owners("edges", edges, names),
    }


def seam_edges(shape, report):
    """Return a compound of the seam edges in the order of ``summary.edge_classes``.

    Without seams it is a null shape.
    """
    numbers = summary.edge_classes(report)
    if not numbers:
        return Part.Shape()
    edges = shape.Edges
    return Part.Compound([_bare_edge(edges[number - 1]) for number in numbers])


def _bare_edge(edge):
    """Return only the curve of an edge, so that drawing and saving it do not include the faces."""
    try:
        return edge.Curve.toShape(*edge.ParameterRange)
    except (Part.OCCError, AttributeError, TypeError, ValueError):
        return edge.copy()


def create(sources=None, doc=None, **tolerances):
    """Add a Seam Analysis to a document, compute it and return it.

    ``sources``: objects to analyse; empty means all solids and shells of the document, or where it
    has none, all objects with faces. ``tolerances``: gap_mm, angle_deg, curvature_rel,
    flat_radius_mm, crease_deg, match_mm (finite numbers that are not negative), level ("G0" to
    "G3"), and profile (a name of profiles.PROFILES, for the tolerances that are not given). Raises
    TypeError for another name, ValueError for another value or where there is no document,
    kernel.KernelUnavailable when the compiled part is missing. When nothing can be analysed,
    ``error_text`` says why.
    """
    if sources is not None and not isinstance(sources, (list, tuple)):
        sources = [sources]
    for at, source in enumerate(sources or []):
        elements.checked_object("sources[%d]" % at, source)
    doc = doc or (sources[0].Document if sources else App.ActiveDocument)
    if doc is None:
        raise ValueError("There is no document to put the analysis into.")
    doc.recompute()  # without sources, objects are found by their shapes
    obj = prepare(sources, doc, **tolerances)
    doc.recompute()
    return obj


def prepare(sources, doc, **tolerances):
    """Add a Seam Analysis as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    values = properties.checked(tolerances, TOLERANCES, {"level": ("Level", LEVELS)})
    obj = feature.add(doc, SeamAnalysis, mark("Seam Analysis"))
    obj.Sources = list(sources or [])
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
