# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Corner Fillet: a solid with the edges at one vertex rounded.

Each edge has its own radius. The shape is the model of the source with fillets and with patches
between them; the fillets end in sections that are set back from the vertex. The source is only
read. The class path is written into documents: neither rename nor move it.
"""

import Part

from freecad.seamwright.document import elements, feature, preferences, properties, sources
from freecad.seamwright.document.feature import empty_report, report_of, tolerances
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import corner_text, kernel, new_seams, repair_text
from freecad.seamwright.plain.language import mark, tr

__all__ = ["CornerFillet", "corner_of", "create", "error_text", "is_corner", "report_of"]

#: property, argument of the kernel, property type, default, help
TOLERANCES = (
    ("GapTolerance", "gap_mm", "App::PropertyLength", 0.01,
     "Largest distance between the two sides of each new seam, in mm"),
    ("AngleTolerance", "angle_deg", "App::PropertyAngle", 0.1,
     "Largest angle between the tangent planes of each new seam, in degrees"),
    ("SectionTolerance", "section_mm", "App::PropertyLength", 1e-6,
     "Largest distance between the sides of the patches and the fillets, in mm"),
)  # fmt: skip

LINKS = (("Vertex", "Vertex", "The vertex whose edges are rounded"),)

RESULTS = (
    ("Summary", "App::PropertyString", "The result in one line, or why there is none"),
    (
        "Met",
        "App::PropertyBool",
        "Whether the solid is valid and every new seam certainly meets the tolerances",
    ),
    (
        "CornerEdges",
        "App::PropertyStringList",
        "The edges at the vertex, in the order of Radii and Setbacks",
    ),
    ("Patches", "App::PropertyInteger", "Number of patches of the corner"),
    ("MaxGap", "App::PropertyLength", "Upper bound of the gaps of the new seams, in mm"),
    ("MaxAngle", "App::PropertyAngle", "Upper bound of the angles of the new seams, in degrees"),
)


class CornerFillet(feature.Feature):
    """Proxy of a Part::FeaturePython that holds its source with one corner rounded."""

    Type = "CornerFillet"
    LABEL, ICON = mark("Corner Fillet"), "seamwright-corner"
    LINKS = LINKS
    TOLERANCES = TOLERANCES
    EMPTY_REPORT = corner_text.EMPTY_REPORT
    INPUTS = ("Source", "Vertex", "Radii", "Setbacks")

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        adder.add("App::PropertyLinkGlobal", "Source", "Corner", "The object with the corner")
        adder.add(
            "App::PropertyLinkSubGlobal", "Vertex", "Corner", "The vertex whose edges are rounded"
        )
        tip = "Radii in mm, in the order of CornerEdges, or one radius for all edges"
        adder.add("App::PropertyFloatList", "Radii", "Corner", tip)
        tip = (
            "Distances from the vertex at which the fillets end, in mm, in the order of "
            "CornerEdges, or one distance for all edges; 0 or empty: automatic"
        )
        adder.add("App::PropertyFloatList", "Setbacks", "Corner", tip)
        adder.add_tolerances(TOLERANCES)
        adder.add_results(RESULTS, feature.INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the object with the corner."""
        return elements.source_objects(obj)

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job that finds (report, shape, names of the edges)."""
        return fillet_job(module, obj, private)

    @staticmethod
    def has_result(report):
        """Return whether the solid is valid and its seams meet the tolerances."""
        return report["met"]

    @staticmethod
    def store(obj, report, shape, edges):
        """Put the results into the read-only properties; the Summary is written last."""
        seams = report["seams"] if report["met"] else []
        feature.keep_report(obj, report)
        obj.Met = report["met"]
        obj.CornerEdges = edges
        obj.Patches = len(corner_text.patches(report))
        obj.MaxGap = new_seams.bound(seams, "gap_mm")
        obj.MaxAngle = new_seams.bound(seams, "angle_deg")
        feature.put_shape(obj, shape)
        obj.Summary = corner_text.summary_text(report)

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report with the reason."""
        report = {**empty_report(obj), "reason": repair_text.named(reason)}
        CornerFillet.store(obj, report, Part.Shape(), [])
        return obj.Summary


def check(chosen):
    """Raise ValueError unless links are one vertex."""
    if [name[:6] for _, name in chosen] != ["Vertex"]:
        raise ValueError(tr("choose one vertex"))


def is_corner(obj):
    """Return whether a document object is a Corner Fillet."""
    return feature.is_of(obj, CornerFillet)


def fillet_job(module, obj, private=False):
    """Return the Job that finds (report, shape, names of the edges).

    This function and ``run`` of the Job raise SourceError for broken links and ValueError for bad
    values or corners that cannot be rounded.
    """
    shape = elements.source_shape(obj)
    _, vertex, edges, _ = _corner(module, obj)
    radii = corner_text.by_edge(obj.Radii, edges, "Radii")
    setbacks = corner_text.by_edge(obj.Setbacks, edges, "Setbacks") if obj.Setbacks else {}
    setbacks = {edge: value for edge, value in setbacks.items() if value}
    given, make = tolerances(obj), feature.model_maker(module, shape, private)
    more = {"setbacks_mm": setbacks, "jobs": preferences.threads(), **given}

    def finish(result):
        report = corner_text.build_report(result.to_dict(), given)
        return report, result.model.to_freecad() if result.met else Part.Shape(), _names(edges)

    def run(progress):
        return make().corner_fillet(vertex, radii, progress=progress, **more)

    return feature.Job(tr("Rounding the corner\u2026"), run, finish)


def _corner(module, obj):
    """Return (model, number of the vertex, numbers of its edges, their lengths in mm)."""
    shape = elements.source_shape(obj)
    vertices = elements.numbers(obj, shape, "Vertex", "Vertex")
    if len(vertices) != 1:
        raise sources.SourceError(
            tr("The property Vertex names {vertices} vertices: name exactly one").format(
                vertices=len(vertices)
            )
        )
    model = module.Model.from_freecad(shape)
    edges = model.corner_edges(vertices[0])
    return model, vertices[0], edges, [shape.Edges[number - 1].Length for number in edges]


def _names(edges):
    return ["Edge%d" % number for number in edges]


def corner_of(obj):
    """Return (names of the edges at the vertex, their lengths in mm, "").

    The edges are in the order of Radii. Where they cannot be found or rounded, the lists are empty
    and the text says why.
    """
    module = kernel.load(Part.OCC_VERSION)
    try:
        _, _, edges, lengths = _corner(module, obj)
    except (sources.SourceError, module.ModelError, ValueError) as error:
        return [], [], tr("Not rounded: {error}.").format(
            error=repair_text.named(str(error)).rstrip(".")
        )
    return _names(edges), lengths, ""


def refusal(source, vertex):
    """Return why no radii can round the corner at a vertex of an object, "Vertex6"; "" where some
    may.

    Raises SourceError for an object without faces and for a vertex that it does not have.
    """
    module = kernel.load(Part.OCC_VERSION)
    shape = sources.world_shape(source)
    number = elements.checked_number(source, shape, vertex, "Vertex")
    try:
        module.Model.from_freecad(shape).corner_edges(number)
    except (module.ModelError, ValueError) as error:
        return repair_text.named(str(error))
    return ""


def create(source, vertex, radii_mm=None, *, setbacks_mm=None, **tolerances):
    """Round the edges at a vertex: add a Corner Fillet, compute it and return it.

    The Corner Fillet is added to the document of ``source``. ``vertex``: "Vertex6" or 6.
    ``radii_mm``, ``setbacks_mm``: one number for all edges, or a list of numbers in the order of
    ``corner_of``. Without radii, the radius is a tenth of the shortest edge, rounded down to one
    digit. Without setbacks, and for a setback of 0, the kernel chooses the setback. ``tolerances``:
    gap_mm, angle_deg, section_mm, and profile, a name of profiles.PROFILES. Raises TypeError and
    ValueError for bad arguments, kernel.KernelUnavailable when the compiled part is missing. Where
    the corner cannot be rounded, the object has no shape and ``error_text`` says why.
    """
    obj = prepare(source, vertex, radii_mm, setbacks_mm=setbacks_mm, **tolerances)
    obj.Document.recompute()
    return obj


def prepare(source, vertex, radii_mm=None, *, setbacks_mm=None, **tolerances):
    """Add a Corner Fillet as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    values = properties.checked(tolerances, TOLERANCES, {})
    values["Radii"] = properties.checked_numbers("radii_mm", radii_mm)
    values["Setbacks"] = properties.checked_numbers("setbacks_mm", setbacks_mm)
    name = elements.checked_name("vertex", vertex, "Vertex")
    doc = elements.checked_object("source", source).Document
    obj = feature.add(doc, CornerFillet, CornerFillet.LABEL)
    obj.Source = source
    elements.set_names(obj, "Vertex", [name])
    for name, value in values.items():
        setattr(obj, name, value)
    if not obj.Radii:
        lengths = corner_of(obj)[1]
        obj.Radii = [corner_text.suggested_radius_mm(lengths)] if lengths else [1.0]
    hooks.attach_view(obj)
    return obj
