# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blend Surface: a surface between two sides, edges or chains of edges of faces.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document.surfaces import sides
from freecad.seamwright.document.surfaces.surface import HANDLE_SHARE, ORDERS, TOLERANCES, Surface
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, FLAG, FLOAT, Option
from freecad.seamwright.plain.summary import counted

START, END, LATERAL = mark("Start"), mark("End"), mark("Lateral")


class BlendSurface(Surface):
    """Proxy of a Part::FeaturePython that holds a surface between two sides."""

    Type = "BlendSurface"
    LABEL = "Blend Surface"
    ICON = "seamwright-blend-surface"
    TIP = (
        "Make a surface between two sides, edges or chains of edges of faces. It joins each with "
        "its own order: position (G0), tangent planes (G1), curvature (G2) or its change (G3)."
    )
    NEEDS = (
        "select the edges of two sides; where an edge lies between two faces, also the face to "
        "continue"
    )
    LINKS = (
        (START, "Start", "Edges of the first side, and faces to continue"),
        (END, "End", "Edges of the second side, and faces to continue"),
        (LATERAL, "Lateral boundaries (may be empty)",
         "Edges between the ends of the sides, along which the lateral boundaries run, and the "
         "faces beside them"),
    )  # fmt: skip
    REQUIRED = (START, END)
    OPTIONS = (
        Option("StartOrder", "start_order", CHOICE, "G2", "Start joins",
               "The continuity with the faces of the start", choices=ORDERS),
        Option("StartTension", "start_tension", FLOAT, 1.0, "Tension at the start",
               "How far the surface keeps its direction, by the distance of the sides",
               least=1e-3, used=lambda values: values["start_order"] != "G0"),
        Option("EndOrder", "end_order", CHOICE, "G2", "End joins",
               "The continuity with the faces of the end", choices=ORDERS),
        Option("EndTension", "end_tension", FLOAT, 1.0, "Tension at the end",
               "How far the surface keeps its direction, by the distance of the sides",
               least=1e-3, used=lambda values: values["end_order"] != "G0"),
        Option("Flip", "flip", FLAG, False, "End runs the other way",
               "Let the end run in the other direction than that in which the surface is less "
               "twisted; lateral boundaries say the direction"),
        Option("LateralOrder", "lateral_order", CHOICE, "G0", "Lateral boundaries join",
               "The continuity with the faces beside the lateral boundaries",
               choices=ORDERS[:3]),
        *TOLERANCES,
    )  # fmt: skip
    INPUTS = (*(entry[0] for entry in LINKS), *(option.name for option in OPTIONS))

    @classmethod
    def sides(cls, parts, chosen, values):
        """Return {property: Side} of {property: links}; raises SourceError or ValueError."""
        found = {name: parts.side(chosen[name]) for name in cls.REQUIRED}
        if chosen[LATERAL]:
            found[LATERAL] = parts.side(chosen[LATERAL], bare=True)
        return found

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        if chosen or name != LATERAL:
            sides.Parts([obj for obj, _ in chosen]).side(chosen, bare=name == LATERAL)

    @classmethod
    def arranged(cls, chosen):
        """Return ({property: links}, {argument: value}) for the links of a selection.

        Two chains of edges are the sides. Of four edges around a hole the first one, and the one
        that does not touch it, are the sides; the other two are lateral boundaries.
        """
        parts = sides.Parts([obj for obj, _ in chosen])
        edges, faces = [], []
        for link in chosen:
            for element in parts.elements(*link):
                is_face = element.shape.ShapeType == "Face"
                (faces if is_face else edges).append((link, element.shape))
        groups = _groups([edge for _, edge in edges])
        if len(groups) not in (2, 3):
            raise ValueError(
                tr("the selection has {edges}, in {groups}: {needs}").format(
                    edges=counted(len(edges), "edge"),
                    groups=counted(len(groups), "chain"),
                    needs=tr(cls.NEEDS),
                )
            )
        found = {}
        for name, group in zip((START, END, LATERAL), [*groups, []]):
            own = list(dict.fromkeys(edges[place][0] for place in group))
            beside = [
                link
                for link, face in faces
                if any(each.isSame(edges[place][1]) for place in group for each in face.Edges)
            ]
            found[name] = own + list(dict.fromkeys(beside))
        for name in cls.REQUIRED:
            parts.side(found[name])
        return found, {}

    @classmethod
    def compute(cls, model, numbers, values, progress):
        """Return the BlendedSurface; ``numbers``: of the Gathered. Any thread may call it."""
        lateral, beside = numbers.get(LATERAL, ([], []))
        given = {**values, **({"flip": False} if lateral else {"lateral_order": "G0"})}
        return model.blend_surface(
            numbers[START][0],
            numbers[END][0],
            start_faces=numbers[START][1],
            end_faces=numbers[END][1],
            lateral=lateral,
            lateral_faces=beside if given["lateral_order"] != "G0" else [],
            progress=progress,
            **given
        )

    @classmethod
    def levels(cls, values):
        """Return {property: (its name in texts, level that its seams must have)}."""
        orders = values["start_order"], values["end_order"], values["lateral_order"]
        return {name: (name, order) for name, order in zip((START, END, LATERAL), orders)}

    @classmethod
    def handles_of(cls, surface, values):
        """Return what ``handles`` returns: the tensions, along the middle of the surface."""
        found = {}
        for name, at, sign in (("start", 0.0, 1), ("end", 1.0, -1)):
            if values["%s_order" % name] != "G0":
                jet = surface.jet(0.5, at)
                share = sign * HANDLE_SHARE / values["%s_tension" % name]
                found["%s_tension" % name] = (jet.p.tolist(), (share * jet.v).tolist())
        return found

    @classmethod
    def ends(cls, found):
        """Return [(parameter across, text), ...] of the marks of a BlendedSurface."""
        return [(0.0, START), (1.0, END)]


def _groups(edges):
    """Return the places of the edges of each chain, in the order of picking.

    Two edges are two chains. Four around a hole are a side, the one across, and the two others.
    """
    touching = [[place for place, other in enumerate(edges) if _touch(one, other)] for one in edges]
    if len(edges) == 2:
        return [[0], [1]]
    if len(edges) == 4 and all(len(own) == 3 for own in touching):
        (across,) = set(range(4)) - set(touching[0])
        return [[0], [across], [place for place in touching[0] if place]]
    chains = []
    for place in range(len(edges)):
        own = [chain for chain in chains if set(chain) & set(touching[place])]
        chains = [chain for chain in chains if chain not in own]
        chains.append(sorted([place, *(each for chain in own for each in chain)]))
    return sorted(chains)


def _touch(one, other):
    """Return whether two edges end at one place; an edge touches itself.

    Edges of different objects have vertices of their own: these are within their tolerances.
    """
    return any(
        a.isSame(b) or a.Point.distanceToPoint(b.Point) <= a.Tolerance + b.Tolerance
        for a in one.Vertexes
        for b in other.Vertexes
    )
