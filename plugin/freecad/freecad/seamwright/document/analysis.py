# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Seam Analysis.

It keeps the report of the kernel, and as its shape the seam edges in the order of the report.
The class path is written into documents: neither rename nor move it.
"""

import json
import math

import FreeCAD as App
import Part

from freecad.seamwright import __version__
from freecad.seamwright.document import sources
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.plain import kernel, profiles, summary

#: property, argument of the kernel, property type, default, help
TOLERANCES = (
    ("GapTolerance", "gap_mm", "App::PropertyLength", 0.01,
     "Largest distance between the two sides of a seam that meets G0, in mm"),
    ("AngleTolerance", "angle_deg", "App::PropertyAngle", 0.1,
     "Largest angle between tangent planes of a seam that meets G1, in degrees"),
    ("CurvatureTolerance", "curvature_rel", "App::PropertyFloat", 0.02,
     "Largest relative difference of curvature of a seam that meets G2, without unit"),
    ("FlatRadius", "flat_radius_mm", "App::PropertyLength", 1e5,
     "A side whose radii of curvature are all larger counts as flat, in mm"),
    ("CreaseAngle", "crease_deg", "App::PropertyAngle", 5.0,
     "A seam with a larger angle is an intended crease and no defect, in degrees"),
    ("MatchDistance", "match_mm", "App::PropertyLength", 0.0,
     "Measure also between open edges no further apart than this, in mm; 0: between none"),
)  # fmt: skip

LEVELS = ["G0", "G1", "G2", "G3"]
DEFAULT_LEVEL = "G1"

# Attributes of App::DocumentObject.addProperty.
READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8

RESULTS = (
    ("Summary", "App::PropertyString", "What was found, in one line"),
    ("Passed", "App::PropertyBool", "Whether no seam is a defect"),
    ("Seams", "App::PropertyInteger", "Number of seams"),
    ("Defects", "App::PropertyInteger", "Seams that fall short of the level"),
    ("Creases", "App::PropertyInteger", "Seams sharper than the crease angle"),
    ("Uncertain", "App::PropertyInteger", "Seams whose verdict is not certain"),
    ("Matched", "App::PropertyInteger", "Seams of two open edges that lie side by side"),
    ("OpenEdges", "App::PropertyInteger", "Edges that bound one face only"),
    ("MaxGap", "App::PropertyLength", "Largest gap seen apart from creases, in mm"),
    ("MaxAngle", "App::PropertyAngle", "Largest angle seen apart from creases, in degrees"),
)

INTERNAL = (
    ("Report", "App::PropertyString", "The report as JSON"),
    ("Analysed", "App::PropertyLinkListGlobal", "The objects that were analysed"),
    ("SeamwrightVersion", "App::PropertyString", "The version that wrote this object"),
)

EMPTY_REPORT = {"seams": [], "open": []}


class SeamAnalysis:
    """Proxy of a Part::FeaturePython that measures the seams of its sources."""

    Type = "SeamAnalysis"

    def __init__(self, obj):
        add_properties(obj)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        """Complete an object written by an older version; nothing is recomputed."""
        obj.Proxy = self
        add_properties(obj)
        hooks.attach_view(obj)

    def execute(self, obj):
        """Measure the sources. On failure the object is marked and its Summary says why."""
        module = kernel.load(Part.OCC_VERSION)
        try:
            model = sources.Model(source_objects(obj))
            report = measure(module, model, obj)
        except module.Cancelled:
            raise RuntimeError("Cancelled; the results are those of the last complete run.") from None
        except (sources.SourceError, module.ModelError, ValueError) as error:
            store(obj, EMPTY_REPORT, Part.Shape(), [])
            obj.Summary = "Not analysed: %s" % error
            raise RuntimeError(str(error)) from None
        store(obj, report, seam_edges(model.shape, report), model.objects)

    def dumps(self):
        """Nothing is kept beside the properties."""
        return None

    def loads(self, state):
        """Nothing is kept beside the properties."""

    # FreeCAD before 0.21.2 asks by these names.
    __getstate__ = dumps
    __setstate__ = loads


def add_properties(obj):
    """Add the properties an object lacks, with their defaults."""
    present = set(obj.PropertiesList)

    def add(kind, name, group, tip, attributes=0):
        if name in present:
            return False
        obj.addProperty(kind, name, group, tip, attributes)
        return True

    add("App::PropertyLinkListGlobal", "Sources", "Seams",
        "The objects to analyse; empty means all solids and shells of the document")  # fmt: skip
    for name, _, kind, default, tip in TOLERANCES:
        if add(kind, name, "Tolerances", tip):
            setattr(obj, name, default)
    if add("App::PropertyEnumeration", "Level", "Tolerances", "Level every seam should meet"):
        obj.Level = LEVELS
        obj.Level = DEFAULT_LEVEL
    for name, kind, tip in RESULTS:
        add(kind, name, "Result", tip, READ_ONLY | OUTPUT)
    for name, kind, tip in INTERNAL:
        add(kind, name, "Internal", tip, READ_ONLY | HIDDEN | OUTPUT)
    obj.setEditorMode("Placement", ["Hidden"])


def is_analysis(obj):
    """Whether a document object is a Seam Analysis."""
    return getattr(getattr(obj, "Proxy", None), "Type", None) == SeamAnalysis.Type


def report_of(obj):
    """The stored report as a dict; an empty report when nothing was analysed yet."""
    return json.loads(obj.Report) if obj.Report else dict(EMPTY_REPORT)


def source_objects(obj):
    """The objects to analyse: the Sources, or all solids and shells of the document."""
    if obj.Sources:
        return sources.expand(obj.Sources)
    return sources.solids_and_shells(obj.Document, exclude=obj)


def tolerances(obj):
    """The tolerances as arguments of the kernel, in mm and degrees."""
    values = {
        argument: float(getattr(getattr(obj, name), "Value", getattr(obj, name)))
        for name, argument, *_ in TOLERANCES
    }
    return {**values, "level": obj.Level}


def measure(module, model, obj):
    """Run the kernel; the report with the key "freecad" that says what the numbers stand for."""
    with hooks.progress("Analysing seams\u2026") as progress:
        result = module.Model.from_freecad(model.shape).analyze(**tolerances(obj), progress=progress)
    report = result.to_dict()
    seams = report["seams"]
    open_edges, shared = report.get("open", []), report.get("non_manifold", [])
    edges = {number for seam in seams for number in seam["edges"]}
    edges |= {entry["edge"] for entry in open_edges + shared}
    faces = {number for seam in seams for number in seam["faces"]}
    faces |= {entry["face"] for entry in open_edges}
    faces |= {number for entry in shared for number in entry["faces"]}
    report["freecad"] = {
        "version": __version__,
        "level": obj.Level,
        "objects": [source.Name for source in model.objects],
        "faces": model.owners("faces", faces),
        "edges": model.owners("edges", edges),
    }
    return report


def seam_edges(shape, report):
    """Compound of the seam edges in the order of ``summary.edge_classes``; null without seams."""
    numbers = summary.edge_classes(report)
    if not numbers:
        return Part.Shape()
    edges = shape.Edges
    return Part.Compound([_bare_edge(edges[number - 1]) for number in numbers])


def _bare_edge(edge):
    """The curve of an edge alone: drawing and saving it neither touches nor repeats the faces."""
    try:
        return edge.Curve.toShape(*edge.ParameterRange)
    except (Part.OCCError, AttributeError, TypeError, ValueError):
        return edge.copy()


def store(obj, report, shape, objects):
    """Put the results into the read-only properties; the Report before the Shape it colours."""
    counts = summary.class_counts(report)
    obj.Report = json.dumps(report)
    obj.Analysed = objects
    obj.SeamwrightVersion = __version__
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


def create(sources=None, doc=None, **tolerances):
    """Add a Seam Analysis to a document, compute it and return it.

    ``sources``: objects to analyse; none means all solids and shells of the document.
    ``tolerances``: gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg, match_mm (numbers
    that are neither negative nor NaN), level ("G0" to "G3"), and profile (a name of
    profiles.PROFILES, for the tolerances that are not given). Raises TypeError for another name,
    ValueError for another value, kernel.KernelUnavailable when the compiled part is missing.
    When the analysis itself fails the object is returned in its error state, see ``error_text``.
    """
    kernel.load(Part.OCC_VERSION)
    values = _checked(tolerances)
    doc = doc or (sources[0].Document if sources else App.ActiveDocument)
    if doc is None:
        raise ValueError("There is no document to put the analysis into.")
    doc.recompute()  # what is to be found by itself must have its shape
    obj = doc.addObject("Part::FeaturePython", "SeamAnalysis")
    obj.Label = "Seam Analysis"
    SeamAnalysis(obj)
    obj.Sources = list(sources or [])
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    doc.recompute()
    return obj


def _checked(tolerances):
    """Property values for the arguments of ``create``."""
    names = {argument: name for name, argument, *_ in TOLERANCES}
    values = {}
    profile = tolerances.pop("profile", "default")
    if profile not in profiles.PROFILES:
        raise ValueError("profile %r: choose one of %s" % (profile, ", ".join(profiles.PROFILES)))
    for argument, value in {**profiles.PROFILES[profile], **tolerances}.items():
        if argument == "level":
            if value not in LEVELS:
                raise ValueError("level %r: choose one of %s" % (value, ", ".join(LEVELS)))
            values["Level"] = value
        elif argument in names:
            if not (value >= 0 and math.isfinite(value)):
                raise ValueError("%s = %r: must be a finite number, not negative" % (argument, value))
            values[names[argument]] = value
        else:
            raise TypeError("there is no tolerance %r" % argument)
    return values


def error_text(obj):
    """Why the last computation failed, or "" when it succeeded."""
    return obj.getStatusString() if "Invalid" in obj.State else ""
