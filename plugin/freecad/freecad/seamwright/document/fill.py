# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Umbrella Fill: a model with holes closed by tangent faces.

The shape is the model of the source with the new faces sewn in. The source is only read. The class
path is written into documents: neither rename nor move it.
"""

from collections import Counter
from typing import Any, NamedTuple

import Part

from freecad.seamwright.document import elements, feature, preferences, properties, sources
from freecad.seamwright.document.feature import empty_report, report_of, tolerances
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.maps.seam_plot import sampled
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import fill_misses, fill_text, kernel, new_seams, repair_text, summary
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import FLAG, Option

__all__ = ["UmbrellaFill", "create", "error_text", "holes_of", "is_fill", "report_of"]

#: property, argument of the kernel, property type, default, help
TOLERANCES = (
    ("GapTolerance", "gap_mm", "App::PropertyLength", 0.001,
     "Largest distance between the two sides of each new seam, in mm"),
    ("AngleTolerance", "angle_deg", "App::PropertyAngle", 0.01,
     "Largest angle between the tangent planes of each new seam for G1 and G2, in degrees"),
    ("CurvatureTolerance", "curvature_rel", "App::PropertyFloat", 0.02,
     "Largest relative difference of curvature of each new seam for G2; 0.02 is 2 %"),
    ("CornerAngle", "corner_deg", "App::PropertyAngle", 15.0,
     "A side of a hole ends where its tangent turns by more than this, in degrees"),
)  # fmt: skip

#: For G0 the new faces only have to meet in position.
TARGETS = ["G0", "G1", "G2"]
DEFAULT_TARGET = "G1"

LINKS = (("Source", "Model", "The object whose holes are filled, or one of its faces"),)

OPTIONS = (
    Option("KeepAnyway", "keep_anyway", FLAG, False, "Keep anyway",
           "Keep a fill even if it misses the target"),
)  # fmt: skip

#: Points at which a seam of a fill that was not kept is measured to be drawn.
SAMPLES = 49

#: Points no further apart than this are the same, up to rounding.
POINT_MM = 1e-6

#: property, kind of element, help
ELEMENTS = (
    ("Edges", "Edge", "One edge of each hole to fill; empty: all holes except outer boundaries"),
    ("Face", "Face", "The face to replace; empty: holes are filled"),
)

RESULTS = (
    ("Summary", "App::PropertyString", "The result in one line, or why there is none"),
    ("Filled", "App::PropertyInteger", "Number of holes that were filled"),
    ("Wanted", "App::PropertyInteger", "Number of holes that were to be filled"),
    ("Reached", "App::PropertyBool", "Whether every new seam certainly meets the target"),
    ("NewFaces", "App::PropertyInteger", "Number of new faces"),
    ("MaxGap", "App::PropertyLength", "Upper bound of the gaps of the new seams, in mm"),
    ("MaxAngle", "App::PropertyAngle", "Upper bound of the angles of the new seams, in degrees"),
    (
        "MaxCurvature",
        "App::PropertyFloat",
        "Upper bound of the relative differences of curvature at the new seams",
    ),
)

INTERNAL = feature.INTERNAL + (
    ("Rejected", "Part::PropertyPartShape", "The faces of fills that were not kept"),
)


class UmbrellaFill(feature.Feature):
    """Proxy of a Part::FeaturePython that holds its source with holes filled."""

    Type = "UmbrellaFill"
    LABEL, ICON = mark("Umbrella Fill"), "seamwright-fill"
    LINKS, OPTIONS = LINKS, OPTIONS
    LEVEL = ("Target", TARGETS)
    TOLERANCES = TOLERANCES
    EMPTY_REPORT = fill_text.EMPTY_REPORT
    INPUTS = ("Source", "Target", "KeepAnyway", *(name for name, *_ in ELEMENTS))

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        adder.add("App::PropertyLinkGlobal", "Source", "Holes", "The object whose holes are filled")
        for name, _, tip in ELEMENTS:
            adder.add("App::PropertyLinkSubGlobal", name, "Holes", tip)
        adder.add_choice(
            "Target",
            "Fill",
            "Level that every new seam must meet; G0: position only",
            TARGETS,
            DEFAULT_TARGET,
        )
        adder.add_options(OPTIONS, "Fill")
        adder.add_tolerances(TOLERANCES)
        adder.add_results(RESULTS, INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the object whose holes are filled."""
        return elements.source_objects(obj)

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job that finds (report, shape, faces of fills that were not kept)."""
        return fill_job(module, obj, private)

    @staticmethod
    def has_result(report):
        """Return whether a hole was filled."""
        return bool(fill_text.kept(report))

    @staticmethod
    def store(obj, report, shape, rejected=Part.Shape()):
        """Put the results into the read-only properties; the Summary is written last."""
        done = fill_text.kept(report)
        seams = [seam for each in done for seam in each["seams"]]
        feature.keep_report(obj, report)
        obj.Filled = len(done)
        obj.Wanted = len(report["fills"])
        obj.Reached = bool(done) and not fill_text.missed(report)
        obj.NewFaces = sum(len(each["faces"]) for each in done)
        obj.MaxGap = new_seams.bound(seams, "gap_mm")
        obj.MaxAngle = new_seams.bound(seams, "angle_deg")
        obj.MaxCurvature = new_seams.bound(seams, "curvature_rel")
        obj.Rejected = rejected
        feature.put_shape(obj, shape)
        obj.Summary = fill_text.summary_text(report)

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report and the reason."""
        reason = repair_text.named(reason)
        UmbrellaFill.store(obj, empty_report(obj), Part.Shape())
        obj.Summary = tr("Not filled: {reason}").format(reason=reason)
        return reason


def check(chosen):
    """Raise SourceError or ValueError unless links are of one object: it, edges, or one face."""
    objects = list(dict.fromkeys(obj for obj, _ in chosen))
    if len(objects) != 1:
        raise ValueError(
            tr(
                "To fill holes, select one object or some of its edges. To replace a face, "
                "select it. Found: {chosen}."
            ).format(chosen=", ".join(obj.Label for obj in objects) or tr("none"))
        )
    sources.world_shape(objects[0])
    edges, faces = (
        sum(name.startswith(kind) for _, name in chosen) for kind in ("Edge", "Face")
    )
    if faces > 1 or (faces and edges):
        raise ValueError(
            tr(
                "Select either edges of holes or one face to replace. Selected: {faces}, {edges}."
            ).format(faces=summary.counted(faces, "face"), edges=summary.counted(edges, "edge"))
        )


def is_fill(obj):
    """Return whether a document object is an Umbrella Fill."""
    return feature.is_of(obj, UmbrellaFill)


def fill_job(module, obj, private=False):
    """Return the Job that finds (report, shape, faces of fills that were not kept).

    This function and ``run`` of the Job raise SourceError for broken links and ValueError for bad
    values.
    """
    shape = elements.source_shape(obj)
    edges, faces = (elements.numbers(obj, shape, *entry[:2]) for entry in ELEMENTS)
    if len(faces) > 1:
        raise sources.SourceError(
            tr("{faces} faces are chosen: only one can be replaced at a time").format(
                faces=len(faces)
            )
        )
    limits, label, make = (
        tolerances(obj),
        obj.Source.Label,
        feature.model_maker(module, shape, private),
    )
    given = {"target": obj.Target, **limits, "jobs": preferences.threads()}
    report, keep_anyway = empty_report(obj), bool(obj.KeepAnyway)

    def run(progress):
        model = make()
        holes = [] if faces else _holes(model, shape, limits, label, edges)[1]
        wanted = [{"face": number} for number in faces] or [{"hole": hole["id"]} for hole in holes]
        outlines = {hole["id"]: fill_text.edges_of(hole) for hole in holes}
        return _fill_each(model, given, wanted, keep_anyway, progress), outlines

    def finish(found):
        fills, outlines = found
        entries = [each.entry for each in fills]
        shapes = [each.model.to_freecad() if each.kept else None for each in fills]
        rejected = [face for each in fills for face in _rejected(each)]
        entries, last = _joined(entries, shapes)
        for entry in entries:
            _name_source_edges(entry, shape, outlines.get(entry["hole"], ()))
        faces = Part.Compound(rejected) if rejected else Part.Shape()
        return {**report, "fills": entries}, last, faces

    return feature.Job(tr("Filling holes\u2026"), run, finish)


class Fill(NamedTuple):
    """One fill: its entry in the report, and what the kernel found, a FillReport.

    ``kept``: whether it becomes part of the result.
    """

    entry: dict
    found: Any
    kept: bool

    @property
    def model(self):
        """The model with the fill, or without one where nothing was built."""
        return self.found.model


def _fill_each(model, given, wanted, keep_anyway, progress):
    """Return a Fill for each of the wanted holes or faces.

    The last of the wanted holes comes first, so that the numbers of the others stay valid. The
    best fill of each is built, whether it is kept or not.
    """
    fills = []
    for index, which in enumerate(reversed(wanted)):  # the numbers of the others stay valid
        share = _part(progress, index, len(wanted))
        found = model.fill(**which, keep_anyway=True, progress=share, **given)
        kept = found.filled and (found.reached or keep_anyway)
        entry = fill_text.entry({**found.to_dict(), "filled": kept}, **which)
        fills.append(Fill(entry, found, kept))
        if kept:
            model = found.model
    return fills


def _rejected(fill):
    """Return the new faces of a fill that was not kept; its seams are measured to be drawn."""
    if fill.kept or not fill.found.filled:
        return []
    shape, found = fill.model.to_freecad(), fill.found.to_dict()
    edges, faces = shape.Edges, shape.Faces
    limits = {name: found[name] for name in ("gap_mm", "angle_deg", "curvature_rel")}
    for seam, own in zip(found["outer"] + found["inner"], fill.entry["seams"]):
        beside = [faces[number - 1] for number in seam["faces"]]
        its = [edges[number - 1] for number in seam["edges"]]
        along = (_along(edge, beside, limits, found["target"]) for edge in its)
        own["along"] = [each for each in along if each is not None]
        if its:  # the worst point may be a corner, where two edges of the hole meet
            own["point"] = tuple(its[0].valueAt((its[0].FirstParameter + its[0].LastParameter) / 2))
    return [faces[number - 1] for number in found["faces"]]


def _along(edge, faces, limits, target):
    """Return {points, shares} of an edge: how much of the tolerances each point takes.

    Returns None where a face cannot be evaluated along the edge.
    """
    try:
        _, points, figures = sampled(edge, faces, SAMPLES)
    except (ValueError, Part.OCCError):
        return None
    return {"points": points.tolist(), "shares": fill_misses.shares(figures, limits, target)}


def _name_source_edges(entry, shape, outline):
    """Let the seams of a fill name the face of the source that is beside them.

    If the fill was not kept, they also name the edges of the hole along which they run. Near a
    point where two of these meet they are both of them. ``outline``: the numbers of the edges of
    the hole; none where a face is replaced.
    """
    replaced = None if entry["face"] is None else shape.Faces[entry["face"] - 1]
    edges = [shape.Edges[number - 1] for number in outline] if outline else replaced.Edges
    for seam in entry["seams"]:
        beside, at = fill_text.face_beside(seam), seam.pop("point", None)
        if beside is None or at is None:
            continue
        distances = [edge.distToShape(Part.Vertex(*at))[0] for edge in edges]
        within = min(distances) + new_seams.bound([seam], "gap_mm") + POINT_MM
        near = [edge for edge, distance in zip(edges, distances) if distance <= within]
        owners = [
            number
            for number, face in enumerate(shape.Faces, 1)
            if (replaced is None or not face.isSame(replaced)) and _has_any(face, near)
        ]
        if beside not in owners and len(owners) == 1:
            (beside,) = owners
            seam["between"] = fill_text.beside("Face%d" % beside)
        if not entry["filled"]:
            numbers = sources.Index(enumerate(shape.Edges, 1))
            near = [e for e in near if len(near) == 1 or _has_any(shape.Faces[beside - 1], [e])]
            seam["source_edges"] = [numbers.find(edge) for edge in near]


def _has_any(face, edges):
    return any(edge.isSame(own) for own in face.Edges for edge in edges)


def _joined(entries, shapes):
    """Return (the entries in the order of the wanted holes or faces, the shape with all fills).

    The shape is null where nothing was filled.
    """
    done = [(entry, shape) for entry, shape in zip(entries, shapes) if shape is not None]
    last = done[-1][1] if done else Part.Shape()
    for entry, shape in done[:-1]:
        _renumber(entry, shape, last)
    return entries[::-1], last


def _holes(model, shape, limits, label, edges):
    """Return (all holes, the holes that are to be filled).

    Raises ValueError where the model has no hole, or only outlines of separate faces, and for edges
    that belong to no hole.
    """
    holes = model.holes(corner_deg=limits["corner_deg"], gap_mm=limits["gap_mm"])
    if not holes:
        raise ValueError(no_hole_text(label))
    if edges:
        return holes, fill_text.chosen_holes(holes, edges)
    around = {number for hole in holes for number in fill_text.edges_of(hole)}
    if 1 < len(shape.Faces) == len(holes) and len(around) == len(shape.Edges):
        raise ValueError(
            tr(
                "The {faces} faces of {label} share no edges, so that their outlines are no holes: "
                "sew them first, with Repair Seams for example, or select the edges of a hole."
            ).format(faces=len(shape.Faces), label=label)
        )
    return holes, fill_text.default_holes(holes)


def no_hole_text(label):
    """Return the sentence about an object without a hole."""
    return tr("{label} has no hole: no free edges form a closed loop.").format(label=label)


def is_closed(obj):
    """Return whether no edge of an object with faces is free, so that it has no hole."""
    sides = Counter()
    for face in sources.world_shape(obj).Faces:
        for edge in face.Edges:
            if not edge.Degenerated:
                sides[edge.hashCode()] += 2 if edge.isSeam(face) else 1
    return 1 not in sides.values()


def _part(progress, index, count):
    """Return the progress of one of several steps."""
    return None if progress is None else lambda share: progress((index + share) / count)


def _renumber(entry, shape, last):
    """Give the faces and edges of a fill the numbers that they have in the last shape.

    The numbers changed when more holes were filled.
    """
    middles = [_middle(edge) for edge in last.Edges]
    faces = {}  # the numbers of the faces of an edge, by the hash code of the edge
    for number, face in enumerate(last.Faces, 1):
        for edge in face.Edges:
            faces.setdefault(edge.hashCode(), []).append(number)
    for seam in entry["seams"]:
        middle = _middle(shape.Edges[seam["edges"][0] - 1])
        index = min(
            range(len(middles)), key=lambda k, middle=middle: middles[k].distanceToPoint(middle)
        )
        seam["edges"] = [index + 1]
        seam["faces"] = faces[last.Edges[index].hashCode()]
    centres = [face.CenterOfMass for face in last.Faces]
    for place, number in enumerate(entry["faces"]):
        centre = shape.Faces[number - 1].CenterOfMass
        ways = [each.distanceToPoint(centre) for each in centres]
        entry["faces"][place] = 1 + ways.index(min(ways))


def _middle(edge):
    return edge.valueAt(sum(edge.ParameterRange) / 2)


def holes_of(obj):
    """Return (holes of the source as the kernel describes them, numbers of those to fill, "").

    Where the holes cannot be found, the lists are empty and the text says why.
    """
    module = kernel.load(Part.OCC_VERSION)
    try:
        shape = elements.source_shape(obj)
        edges = elements.numbers(obj, shape, "Edges", "Edge")
        model = module.Model.from_freecad(shape)
        holes, wanted = _holes(model, shape, tolerances(obj), obj.Source.Label, edges)
    except (sources.SourceError, module.ModelError, ValueError) as error:
        return [], [], repair_text.named(str(error))
    return holes, [hole["id"] for hole in wanted], ""


def create(source, *, edges=(), face=None, target="G1", keep_anyway=False, **tolerances):
    """Fill holes of an object: add an Umbrella Fill to its document, compute it and return it.

    ``edges``: ["Edge5", ...] or [5, ...]; the holes of these edges are filled. One edge of each
    hole is enough. Without edges, all holes except the outer boundaries are filled. ``face``:
    "Face3" or 3; this face is taken out and replaced instead. ``target``: "G0" (position only),
    "G1" or "G2". ``keep_anyway``: also keep fills that miss the target. ``tolerances``: gap_mm,
    angle_deg, curvature_rel, corner_deg, and profile, a name of profiles.PROFILES, for the first
    three. Raises TypeError and ValueError for bad arguments, kernel.KernelUnavailable when the
    compiled part is missing. Where no hole could be filled, the object has no shape and
    ``error_text`` says why.
    """
    obj = prepare(
        source, edges=edges, face=face, target=target, keep_anyway=keep_anyway, **tolerances
    )
    obj.Document.recompute()
    return obj


def prepare(source, *, edges=(), face=None, target="G1", keep_anyway=False, **tolerances):
    """Add an Umbrella Fill as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    edges = elements.checked_names("edges", edges, "Edge")
    faces = [] if face is None else [elements.checked_name("face", face, "Face")]
    if edges and faces:
        raise ValueError(
            "edges %s and face %r: give edges of holes to fill, or a face to replace"
            % (edges, face)
        )
    values = properties.checked(
        {**tolerances, "target": target}, TOLERANCES, {"target": ("Target", TARGETS)}
    )
    doc = elements.checked_object("source", source).Document
    obj = feature.add(doc, UmbrellaFill, UmbrellaFill.LABEL)
    obj.Source = source
    elements.set_names(obj, "Edges", edges)
    elements.set_names(obj, "Face", faces)
    obj.KeepAnyway = bool(keep_anyway)
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
