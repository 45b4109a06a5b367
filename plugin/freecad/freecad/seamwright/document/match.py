# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object Match Surfaces: two faces that join along their common boundary.

The shape is a shell of the two faces; one or both of them are moved. The objects of the faces are
only read. The class path is written into documents: neither rename nor move it.
"""

import Part

from freecad.seamwright.document import elements, feature, match_chain, properties, sources
from freecad.seamwright.document.feature import report_of, tolerances
from freecad.seamwright.document.hooks import hooks
from freecad.seamwright.document.match_chain import MORE
from freecad.seamwright.document.option_feature import (
    LINKED,
    check_not_deleted,
    links,
    links_of,
    remember_chosen,
)
from freecad.seamwright.document.properties import error_text
from freecad.seamwright.plain import kernel, match_text, summary
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, FLAG, FLOAT, LENGTH, Option

__all__ = ["MatchSurfaces", "create", "error_text", "is_match", "report_of"]

#: property, argument of the kernel, property type, default, help
TOLERANCES = properties.TOLERANCES + (
    ("MatchDistance", "match_mm", "App::PropertyLength", 0.1,
     "Free edges no further apart than this may be the common boundary, in mm"),
)  # fmt: skip

TARGETS = ["G1", "G2"]
MOVES = [mark("First"), mark("Second"), mark("Both")]
DEFAULT_MOVES = "Second"

FACES, EDGE = ("FirstFace", "SecondFace"), "CommonEdge"
LINKS = (
    ("FirstFace", "First face", "The first face"),
    ("SecondFace", "Second face", "The second face"),
    ("CommonEdge", "Common edge (may be empty)",
     "The common edge along which the faces are matched; empty: the longest one"),
    (MORE, "More faces (may be empty)",
     "Further faces that the moving face joins as the other face, or edges of them"),
)  # fmt: skip

OPTIONS = (
    Option("Moves", "moves", CHOICE, DEFAULT_MOVES, "Moves",
           "The face that moves; away from the seam it keeps its shape", choices=MOVES),
    Option("MaxMove", "max_move_mm", LENGTH, 0.0, "Largest move",
           "No pole may move further than this, in mm; 0: no limit", least=0.0,
           zero=mark("no limit")),
    Option("HoldSides", "hold_sides", FLAG, False, "Hold side boundaries",
           "Keep the two other boundaries that end at the seam"),
    Option("Depth", "depth_mm", LENGTH, 0.0, "Depth",
           "How far from the seam the moved face may change, in mm; 0: as little as needed",
           least=0.0, zero=mark("as little as needed")),
    Option("Fairness", "fairness", FLOAT, 1.5, "Fairness",
           "Factor by which the variation of the curvature of a face may grow", least=1.0),
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
    INPUTS = (*(name for name, *_ in LINKS), "Target", *(option.name for option in OPTIONS))

    @staticmethod
    def add_properties(obj):
        """Add the properties that an object lacks, with their defaults."""
        adder = properties.Adder(obj)
        for name, _, tip in LINKS:
            kind = "App::PropertyLinkSub%sGlobal" % ("List" if name == MORE else "")
            adder.add(kind, name, "Faces", tip)
        adder.add_choice("Target", "Match", "Level of continuity to reach", TARGETS, TARGETS[0])
        adder.add_options(OPTIONS, "Match")
        adder.add_tolerances(TOLERANCES)
        adder.add_results(RESULTS, (*feature.INTERNAL, LINKED))
        obj.setEditorMode("Placement", ["Hidden"])

    def onChanged(self, obj, prop):
        """Remember the further faces that are chosen: FreeCAD drops those that are deleted."""
        if prop == MORE:
            remember_chosen(obj, MORE)

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
    if name == MORE and not {element[:4] for _, element in chosen} <= {"Face", "Edge"}:
        raise ValueError(tr("choose faces or edges of faces, or nothing"))
    if name == EDGE and [element[:4] for _, element in chosen] not in ([], ["Edge"]):
        raise ValueError(tr("choose one edge of both faces, or nothing"))


def link_text(obj, name):
    """Return a link as the user reads it: "Plate.Face3"."""
    target = link(obj, name)
    return tr("not chosen") if target is None else "%s.%s" % (target[0].Label, target[1])


def source_objects(obj):
    """Return the objects to which the faces belong, without repeats."""
    chosen = [link(obj, name) for name in FACES]
    chosen = [target for target in chosen if target is not None] + links_of(obj, MORE)
    return list(dict.fromkeys(target[0] for target in chosen))


def match_job(module, obj, private=False):
    """Return the Job that finds (report, shape).

    Raises SourceError for broken links; ``run`` of the Job raises ValueError for bad values.
    """
    chosen = _links(obj)
    check_not_deleted(obj, MORE, required=False)
    if links_of(obj, MORE):
        return _chain_job(module, obj, chosen, private)
    found = sources.Elements(chosen)
    if any(face.ShapeType != "Face" for face in found.shapes[:2]):
        raise sources.SourceError(tr("FirstFace and SecondFace must be faces"))
    shape = Part.Compound(found.shapes[:2])
    faces = [link_text(obj, name) for name in FACES]

    names = [found.edge_text(edge) for edge in shape.Edges]
    target, limits, make = obj.Target, tolerances(obj), feature.model_maker(module, shape, private)
    given = {
        "target": target, "moves": obj.Moves.lower(), "hold_sides": bool(obj.HoldSides),
        "max_move_mm": properties.number(obj, "MaxMove") or None, **_changes(obj),
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
        report["reason"] = match_text.advised(named(report["reason"]), result.reason_code)
        made = result.model.to_freecad() if result.matched else Part.Shape()
        report["poles"] = _poles_of(shape, made)
        return report, made

    return feature.Job(tr("Matching surfaces\u2026"), run, finish)


def _poles_of(before, after):
    """Return [(numbers of poles before, after) of each face] of a shape and of its match."""
    pairs = zip(before.Faces, after.Faces)
    return [[_poles(face.Surface) for face in pair] for pair in pairs]


def _poles(surface):
    """Return the numbers of poles of a surface in both directions; None for one without poles."""
    has_poles = hasattr(surface, "NbUPoles")
    return [surface.NbUPoles, surface.NbVPoles] if has_poles else None


def _chain_job(module, obj, chosen, private):
    """Return the Job that matches one face to the other one and to MoreFaces.

    ``chosen``: the links to the two faces and, where one is chosen, to the common edge.
    """
    moves = obj.Moves.lower()
    other, moving = chosen[:2] if moves != "first" else chosen[1::-1]
    joined = [other, *chosen[2:], *links_of(obj, MORE)]
    gathered = match_chain.gather(moving, joined)
    limits = tolerances(obj)
    make, target = feature.model_maker(module, gathered.shape, private), obj.Target
    given = {
        "target": target, "average": moves == "both",
        "hold": "position" if obj.HoldSides else "none",
        "max_move_mm": properties.number(obj, "MaxMove") or None, **_changes(obj), **limits
    }  # fmt: skip

    def run(progress):
        model = make()
        sides = match_chain.sides_of(model, gathered, limits["match_mm"])
        return model.match_sides(1, sides, progress=progress, **given)

    def finish(result):
        report = {**match_chain.report_of(result, gathered), "target": target, "tolerance": limits}
        made = result.model.to_freecad() if result.matched else Part.Shape()
        report["poles"] = _poles_of(gathered.shape, made)
        return report, made

    return feature.Job(tr("Matching surfaces\u2026"), run, finish)


def _changes(obj):
    """Return the {argument: value} of how far the moved face may change."""
    depth, fairness = (properties.number(obj, name) for name in ("Depth", "Fairness"))
    return {"depth_mm": depth or None, "fairness": fairness}


def _links(obj):
    """Return the links to the two faces and, where one is chosen, to the common edge."""
    chosen = [link(obj, name) for name in (*FACES, EDGE)]
    if chosen[0] is None:
        raise sources.SourceError(
            tr("The first face was deleted: choose another one in the property FirstFace")
        )
    if chosen[1] is None:
        raise sources.SourceError(
            tr("The second face was deleted: choose another one in the property SecondFace")
        )
    if chosen[0] == chosen[1]:
        raise sources.SourceError(
            tr("{link} is chosen twice: choose two different faces").format(
                link=link_text(obj, "FirstFace")
            )
        )
    return [target for target in chosen if target is not None]


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


def arranged(chosen):
    """Return (first, second, {argument: value} of ``create``) for [(object, "Face3"), ...].

    The last face moves. The others stay, and the faces of edges, too. Raises SourceError or
    ValueError where these are not what is needed.
    """
    faces = [each for each in chosen if each[1].startswith("Face")]
    edges = [each for each in chosen if each[1].startswith("Edge")]
    if len(faces) == 2 and len(edges) <= 1:
        return faces[0], faces[1], {"edge": edges[0] if edges else None}
    if not faces or len(faces) + len(edges) < 2:
        raise ValueError(
            tr(
                "Select two faces: first the one that stays, then the one that moves. You may "
                "also select one common edge, or more faces that stay, or edges of them. "
                "Selected: {faces}, {edges}."
            ).format(
                faces=summary.counted(len(faces), "face"), edges=summary.counted(len(edges), "edge")
            )
        )
    joined = [*faces[:-1], *edges]
    first = match_chain.first_face(faces[-1], joined)
    if len(joined) == 1:
        return first, faces[-1], {"edge": joined[0]}
    return first, faces[-1], {"more": [each for each in joined if each != first]}


def create(
    first,
    second,
    *,
    edge=None,
    more=(),
    target="G1",
    moves="second",
    max_move_mm=0.0,
    hold_sides=False,
    depth_mm=0.0,
    fairness=1.5,
    **tolerances
):
    """Match two faces: add a Match Surfaces to their document, compute it and return it.

    ``first``, ``second``: (object, "Face3"). ``edge``: (object, "Edge5"), where the faces have
    several common edges. ``more``: further faces that the moving one joins, or edges of them:
    [(object, "Face2"), (object, ["Edge3", ...]), ...]. ``target``: "G1" or "G2". ``moves``:
    "first", "second" or "both".
    ``max_move_mm``: no pole may move further; 0 means no limit. ``hold_sides``: the two other
    boundaries that end at the seam stay. ``depth_mm``: how far from the seam the face may change; 0
    means as little as needed. ``fairness``: by what factor the variation of its curvature may grow.
    ``tolerances``: gap_mm, angle_deg, curvature_rel,
    flat_radius_mm, crease_deg, match_mm, profile, as for an analysis. Raises TypeError and
    ValueError for bad arguments, kernel.KernelUnavailable when the compiled part is missing. When
    the faces do not match, the object has no shape and ``error_text`` says why.
    """
    obj = prepare(
        first,
        second,
        edge=edge,
        more=more,
        target=target,
        moves=moves,
        max_move_mm=max_move_mm,
        hold_sides=hold_sides,
        depth_mm=depth_mm,
        fairness=fairness,
        **tolerances
    )
    obj.Document.recompute()
    return obj


def prepare(
    first,
    second,
    *,
    edge=None,
    more=(),
    target="G1",
    moves="second",
    max_move_mm=0.0,
    hold_sides=False,
    depth_mm=0.0,
    fairness=1.5,
    **tolerances
):
    """Add a Match Surfaces as ``create`` does, but compute nothing yet."""
    kernel.load(Part.OCC_VERSION)
    numbers = ("MaxMove", "max_move_mm"), ("Depth", "depth_mm"), ("Fairness", "fairness")
    table = (*TOLERANCES, *numbers)
    choices = {"target": ("Target", TARGETS), "moves": ("Moves", [name.lower() for name in MOVES])}
    values = properties.checked(
        {
            **tolerances,
            "max_move_mm": max_move_mm,
            "depth_mm": depth_mm,
            "fairness": fairness,
            "target": target,
            "moves": moves,
        },
        table,
        choices,
    )
    values["Moves"] = values["Moves"].capitalize()
    chosen = {
        "FirstFace": elements.checked_link("first", first, "Face"),
        "SecondFace": elements.checked_link("second", second, "Face"),
    }
    if edge is not None:
        chosen[EDGE] = elements.checked_link("edge", edge, "Edge")
    chosen[MORE] = links(more)
    obj = feature.add(chosen["FirstFace"][0].Document, MatchSurfaces, MatchSurfaces.LABEL)
    for name, each in chosen.items():
        setattr(obj, name, each)
    obj.HoldSides = bool(hold_sides)
    for name, value in values.items():
        setattr(obj, name, value)
    hooks.attach_view(obj)
    return obj
