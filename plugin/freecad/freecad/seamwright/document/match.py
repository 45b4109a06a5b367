# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Match Surfaces: two faces that join along their common boundary.

The shape is a shell of the two faces; one or both of them are moved. The objects of the faces are
only read. The class path is written into documents: neither rename nor move it.
"""

import Part

from freecad.seamwright.document import feature, properties, sources
from freecad.seamwright.document.feature import report_of, tolerances
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import kernel, match_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, FLAG, LENGTH, Option

__all__ = ["MatchSurfaces", "create", "error_text", "is_match", "report_of"]

#: property, argument of the kernel, property type, default, help
TOLERANCES = properties.TOLERANCES + (
    ("MatchDistance", "match_mm", "App::PropertyLength", 0.1,
     "Free edges no further apart than this may be the common boundary, in mm"),
)  # fmt: skip

TARGETS = ["G1", "G2"]
MOVES = [mark("First"), mark("Second"), mark("Both")]
DEFAULT_MOVES = "Second"

FACES = ("FirstFace", "SecondFace")
LINKS = (
    ("FirstFace", "First face", "The first face"),
    ("SecondFace", "Second face", "The second face"),
    ("CommonEdge", "Common edge (may be empty)",
     "The common edge along which the faces are matched; empty: the longest one"),
)  # fmt: skip

OPTIONS = (
    Option("Moves", "moves", CHOICE, DEFAULT_MOVES, "Moves",
           "The face that moves; away from the seam it keeps its shape", choices=MOVES),
    Option("MaxMove", "max_move_mm", LENGTH, 0.0, "Largest move",
           "No pole may move further than this, in mm; 0: no limit", least=0.0,
           zero=mark("no limit")),
    Option("HoldSides", "hold_sides", FLAG, False, "Hold side boundaries",
           "Keep the two other boundaries that end at the seam"),
)  # fmt: skip

RESULTS = (
    ("Summary", "App::PropertyString", "The result in one line, or why there is none"),
    ("Matched", "App::PropertyBool", "Whether the faces certainly meet the target"),
    (
        "Exact",
        "App::PropertyBool",
        "Whether the poles meet the target exactly up to rounding, not only within the tolerance",
    ),
    ("Certain", "App::PropertyBool", "Whether the verdict about the new seam is certain"),
    ("LargestMove", "App::PropertyLength", "Largest move of a pole, in mm"),
    ("GapBefore", "App::PropertyLength", "Gap of the seam before the match, in mm"),
    ("GapAfter", "App::PropertyLength", "Gap of the seam after the match, in mm"),
    ("AngleBefore", "App::PropertyAngle", "Angle of the seam before the match, in degrees"),
    ("AngleAfter", "App::PropertyAngle", "Angle of the seam after the match, in degrees"),
    ("CurvatureBefore", "App::PropertyFloat", "Relative difference of curvature before the match"),
    ("CurvatureAfter", "App::PropertyFloat", "Relative difference of curvature after the match"),
    ("LevelBefore", "App::PropertyString", "Level of continuity before the match"),
    ("LevelAfter", "App::PropertyString", "Level of continuity after the match"),
)


class MatchSurfaces(feature.Feature):
    """Proxy of a Part::FeaturePython that holds two matched faces."""

    Type = "MatchSurfaces"
    LABEL, ICON = mark("Match Surfaces"), "seamwright-match"
    LINKS, OPTIONS = LINKS, OPTIONS
    LEVEL = ("Target", TARGETS)
    TOLERANCES = TOLERANCES
    EMPTY_REPORT = match_text.EMPTY_REPORT
    INPUTS = (*(name for name, *_ in LINKS), "Target", "Moves", "MaxMove", "HoldSides")

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        for name, _, tip in LINKS:
            adder.add("App::PropertyLinkSubGlobal", name, "Faces", tip)
        adder.add_choice("Target", "Match", "Level of continuity to reach", TARGETS, TARGETS[0])
        adder.add_options(OPTIONS, "Match")
        adder.add_tolerances(TOLERANCES)
        adder.add_results(RESULTS, feature.INTERNAL)
        obj.setEditorMode("Placement", ["Hidden"])

    @staticmethod
    def source_objects(obj):
        """Return the objects to which the faces belong."""
        return source_objects(obj)

    @staticmethod
    def job(module, obj, private=False):
        """Return the Job that finds (report, shape)."""
        return match_job(module, obj, private)

    @staticmethod
    def has_result(report):
        """Return whether the faces match."""
        return report["matched"]

    @staticmethod
    def store(obj, report, shape):
        """Put the results into the read-only properties; the Summary is written last."""
        before, after = report["before"], report["after"] if report["matched"] else None
        feature.keep_report(obj, report)
        obj.Matched = report["matched"]
        obj.Exact = report["exact"]
        obj.Certain = after is not None and after["certified"]
        obj.LargestMove = report["largest_move_mm"] if report["matched"] else 0.0
        for when, seam in (("Before", before), ("After", after)):
            for word, name in (
                ("Gap", "gap_mm"),
                ("Angle", "angle_deg"),
                ("Curvature", "curvature_rel"),
            ):
                setattr(obj, word + when, match_text.value(seam, name))
            setattr(obj, "Level" + when, "" if seam is None else seam["level"])
        obj.Shape = shape
        obj.Summary = match_text.summary(report)

    @staticmethod
    def store_failure(obj, reason):
        """Store an empty report with the reason."""
        report = {**match_text.EMPTY_REPORT, "reason": reason, "tolerance": tolerances(obj)}
        MatchSurfaces.store(obj, report, Part.Shape())
        return obj.Summary


def is_match(obj):
    """Return whether a document object is a Match Surfaces."""
    return feature.is_of(obj, MatchSurfaces)


def link(obj, name):
    """Return (object, "Face3") of one of ``LINKS``.

    Returns None where the link is empty or its object was deleted.
    """
    target = getattr(obj, name)
    if not target or target[0] is None:
        return None
    return target[0], (list(target[1]) or [""])[0]


def completed(chosen):
    """Return links in which an object as a whole stands for its face, if it has just one."""
    return [
        (obj, name or ("Face1" if len(Part.getShape(obj).Faces) == 1 else ""))
        for obj, name in chosen
    ]


def check(name, chosen):
    """Raise ValueError where a property cannot have these links."""
    if name in FACES and [element[:4] for _, element in chosen] != ["Face"]:
        raise ValueError(tr("choose one face"))
    if name not in FACES and [element[:4] for _, element in chosen] not in ([], ["Edge"]):
        raise ValueError(tr("choose one edge of both faces, or nothing"))


def link_text(obj, name):
    """Return a link as the user reads it: "Plate.Face3"."""
    target = link(obj, name)
    return tr("not chosen") if target is None else "%s.%s" % (target[0].Label, target[1])


def source_objects(obj):
    """Return the objects to which the two faces belong, without repeats."""
    links = [link(obj, name) for name in FACES]
    return list(dict.fromkeys(target[0] for target in links if target is not None))


def match_job(module, obj, private=False):
    """Return the Job that finds (report, shape).

    Raises SourceError for broken links; ``run`` of the Job raises ValueError for bad values.
    """
    found = sources.Elements(_links(obj))
    if any(face.ShapeType != "Face" for face in found.shapes[:2]):
        raise sources.SourceError(tr("FirstFace and SecondFace must be faces"))
    shape = Part.Compound(found.shapes[:2])
    faces = [link_text(obj, name) for name in FACES]

    names = [found.edge_text(edge) for edge in shape.Edges]
    target, limits, make = obj.Target, tolerances(obj), feature.model_maker(module, shape, private)
    given = {
        "target": target, "moves": obj.Moves.lower(), "hold_sides": bool(obj.HoldSides),
        "max_move_mm": properties.number(obj, "MaxMove") or None,
        "edge": _edge_number(obj, shape, found.shapes[2:]), **limits
    }  # fmt: skip

    def named(text):
        return match_text.named(text, faces, lambda number: names[number - 1])

    def run(progress):
        try:
            return make().match_faces(1, 2, progress=progress, **given)
        except ValueError as error:
            raise ValueError(named(str(error))) from None

    def finish(result):
        report = {**result.to_dict(), "target": target, "tolerance": limits, "faces": faces}
        report["reason"] = named(report["reason"])
        made = result.model.to_freecad() if result.matched else Part.Shape()
        pairs = zip(shape.Faces, made.Faces)
        report["poles"] = [[_poles(face.Surface) for face in pair] for pair in pairs]
        return report, made

    return feature.Job(tr("Matching surfaces\u2026"), run, finish)


def _poles(surface):
    """Return the numbers of poles of a surface in both directions; None for one without poles."""
    has_poles = hasattr(surface, "NbUPoles")
    return [surface.NbUPoles, surface.NbVPoles] if has_poles else None


def _links(obj):
    """Return the links to the two faces and, where one is chosen, to the common edge."""
    links = [link(obj, name) for name, *_ in LINKS]
    if links[0] is None:
        raise sources.SourceError(
            tr("The first face was deleted: choose another one in the property FirstFace")
        )
    if links[1] is None:
        raise sources.SourceError(
            tr("The second face was deleted: choose another one in the property SecondFace")
        )
    if links[0] == links[1]:
        raise sources.SourceError(
            tr("{link} is chosen twice: choose two different faces").format(
                link=link_text(obj, "FirstFace")
            )
        )
    return [target for target in links if target is not None]


def _edge_number(obj, shape, chosen):
    """Return the number of the chosen edge in the shape; 0 where no edge is chosen.

    ``chosen``: a list of no edge or one edge.
    """
    for edge in chosen:
        for number, other in enumerate(shape.Edges, 1):
            if other.isSame(edge):
                return number
        raise sources.SourceError(
            tr("{link} is not an edge of the two faces").format(link=link_text(obj, "CommonEdge"))
        )
    return 0


def create(
    first,
    second,
    *,
    edge=None,
    target="G1",
    moves="second",
    max_move_mm=0.0,
    hold_sides=False,
    **tolerances
):
    """Match two faces: add a Match Surfaces to their document, compute it and return it.

    ``first``, ``second``: (object, "Face3"). ``edge``: (object, "Edge5"), where the faces have
    several common edges. ``target``: "G1" or "G2". ``moves``: "first", "second" or "both".
    ``max_move_mm``: no pole may move further; 0 means no limit. ``hold_sides``: the two other
    boundaries that end at the seam stay. ``tolerances``: gap_mm, angle_deg, curvature_rel,
    flat_radius_mm, crease_deg, match_mm, profile, as for an analysis. Raises TypeError and
    ValueError for bad arguments, kernel.KernelUnavailable when the compiled part is missing. When
    the faces do not match, the object has no shape and ``error_text`` says why.
    """
    obj = prepare(
        first,
        second,
        edge=edge,
        target=target,
        moves=moves,
        max_move_mm=max_move_mm,
        hold_sides=hold_sides,
        **tolerances
    )
    obj.Document.recompute()
    return obj


def prepare(
    first,
    second,
    *,
    edge=None,
    target="G1",
    moves="second",
    max_move_mm=0.0,
    hold_sides=False,
    **tolerances
):
    """Add a Match Surfaces as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    table = TOLERANCES + (("MaxMove", "max_move_mm"),)
    choices = {"target": ("Target", TARGETS), "moves": ("Moves", [name.lower() for name in MOVES])}
    values = properties.checked(
        {**tolerances, "max_move_mm": max_move_mm, "target": target, "moves": moves}, table, choices
    )
    values["Moves"] = values["Moves"].capitalize()
    doc = first[0].Document
    obj = feature.add(doc, MatchSurfaces, MatchSurfaces.LABEL)
    for name, target_link in (("FirstFace", first), ("SecondFace", second), ("CommonEdge", edge)):
        if target_link is not None:
            setattr(obj, name, (target_link[0], [target_link[1]]))
    obj.HoldSides = bool(hold_sides)
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
