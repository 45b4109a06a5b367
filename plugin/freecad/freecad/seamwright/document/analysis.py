# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Seam Analysis.

It keeps the report of the kernel. Its shape has the seam edges in the order of the report. The
class path is written into documents: neither rename nor move it.
"""

import json

import FreeCAD as App
import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import feature, properties, sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import kernel, summary

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
)  # fmt: skip

__all__ = ["SeamAnalysis", "create", "error_text", "is_analysis", "report_of"]

EMPTY_REPORT = {"seams": [], "open": []}

WORKING = "Analysing seams\u2026"


class SeamAnalysis(feature.Feature):
    """Proxy of a Part::FeaturePython that measures the seams of its sources."""

    Type = "SeamAnalysis"
    TOLERANCES = TOLERANCES
    INPUTS = ("Sources", "Level")

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        tip = "The objects to analyse; empty: all solids and shells of the document"
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
    def job(module, obj, private=False):
        """Return the Job that finds (report, compound of the seam edges, objects)."""
        model, level, given = sources.Model(source_objects(obj)), obj.Level, tolerances(obj)
        make = feature.model_maker(module, model.shape, private)

        def finish(report):
            report["freecad"] = owners(model, level, report)
            return report, seam_edges(model.shape, report), model.objects

        return feature.Job(
            WORKING, lambda progress: make().analyze(**given, progress=progress).to_dict(), finish
        )

    @staticmethod
    def store(obj, report, shape, objects):
        """Put the results into the read-only properties.

        The Report is written before the Shape, since it gives the colours of the Shape.
        """
        counts = summary.class_counts(report)
        feature.keep_report(obj, report)
        obj.Analysed = objects
        obj.Seams = sum(counts.values())
        obj.Defects = counts["defect"]
        obj.Creases = counts["crease"]
        obj.Uncertain = summary.uncertain(report)
        obj.Matched = summary.matched(report)
        obj.OpenEdges = len(report.get("open", ()))
        obj.MaxGap = summary.largest(report, "gap_mm") or 0.0
        obj.MaxAngle = summary.largest(report, "angle_deg") or 0.0
        obj.Passed = summary.passed(report)
        obj.Shape = shape
        obj.Summary = summary.summary_text(report)

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report and the reason."""
        SeamAnalysis.store(obj, EMPTY_REPORT, Part.Shape(), [])
        obj.Summary = "Not analysed: %s" % reason
        return reason


def is_analysis(obj):
    """Return whether a document object is a Seam Analysis."""
    return feature.is_of(obj, SeamAnalysis)


def report_of(obj):
    """Return the stored report as a dict; an empty report when nothing was analysed yet."""
    return json.loads(obj.Report) if obj.Report else dict(EMPTY_REPORT)


def source_objects(obj):
    """Return the objects to analyse: the Sources, or all solids and shells of the document."""
    if obj.Sources:
        return sources.expand(obj.Sources)
    return sources.solids_and_shells(obj.Document, exclude=obj.Document.getObject(obj.Name))


def tolerances(obj):
    """Return the tolerances as arguments of the kernel, in mm and degrees."""
    return {**properties.arguments(obj, TOLERANCES), "level": obj.Level}


def owners(model, level, report):
    """Return the value of the report's key "freecad": the objects to which its numbers belong."""
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
        "objects": [source.Name for source in model.objects],
        "faces": model.owners("faces", faces),
        "edges": model.owners("edges", edges),
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

    ``sources``: objects to analyse; empty means all solids and shells of the document.
    ``tolerances``: gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg, match_mm (finite
    numbers that are not negative), level ("G0" to "G3"), and profile (a name of profiles.PROFILES,
    for the tolerances that are not given). Raises TypeError for another name, ValueError for
    another value or where there is no document, kernel.KernelUnavailable when the compiled part is
    missing. When nothing can be analysed, ``error_text`` says why.
    """
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
    obj = feature.add(doc, SeamAnalysis, "Seam Analysis")
    obj.Sources = list(sources or [])
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
