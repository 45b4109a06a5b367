# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extend Surface: a surface that continues a side of faces over a length, or up to a face.

The class path is written into documents: neither rename nor move it.
"""

import numpy

from freecad.seamwright.document.surfaces import sides
from freecad.seamwright.document.surfaces.surface import ORDERS, TOLERANCES, Surface
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, LENGTH, Option

SIDE, UP_TO = mark("Side"), "UpTo"
BY_LENGTH, BY_FACE = mark("Length"), mark("Face")


class ExtendSurface(Surface):
    """Proxy of a Part::FeaturePython that holds a surface beyond a side."""

    Type = "ExtendSurface"
    LABEL = "Extend Surface"
    ICON = "seamwright-extend-surface"
    TIP = (
        "Continue faces beyond an edge or a chain of edges, over a length or up to a face, with "
        "their tangent planes (G1), curvatures (G2) or the change of these (G3)."
    )
    NEEDS = (
        "select the edges of a side; where an edge lies between two faces, also the face to "
        "continue"
    )
    LINKS = (
        (SIDE, "Side", "Edges of the side, and faces to continue"),
        (UP_TO, "Up to (may be empty)", "The face at which the surface ends"),
    )
    REQUIRED = (SIDE,)
    OPTIONS = (
        Option("Order", "order", CHOICE, "G2", "Continues with",
               "The continuity with the faces of the side; G1 is ruled", choices=ORDERS[1:]),
        Option("Until", "until", CHOICE, BY_LENGTH, "Ends by",
               "The surface ends after a length, or at a face", choices=(BY_LENGTH, BY_FACE)),
        Option("Length", "length_mm", LENGTH, 10.0, "Length", "Length of the surface, in mm",
               least=1e-3, used=lambda values: values["until"] == BY_LENGTH),
        *TOLERANCES,
    )  # fmt: skip
    INPUTS = (*(entry[0] for entry in LINKS), *(option.name for option in OPTIONS))

    @classmethod
    def sides(cls, parts, chosen, values):
        """Return {property: Side} of {property: links}; raises SourceError or ValueError."""
        found = {SIDE: parts.side(chosen[SIDE])}
        if values["until"] == BY_FACE:
            if not chosen[UP_TO]:
                raise ValueError(tr("there is no face at which the surface ends: choose one"))
            found[UP_TO] = sides.Side([], [parts.face(chosen[UP_TO])])
        return found

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        parts = sides.Parts([obj for obj, _ in chosen])
        if name == SIDE:
            parts.side(chosen)
        elif chosen:
            parts.face(chosen)

    @classmethod
    def arranged(cls, chosen):
        """Return ({property: links}, {argument: value}) for the links of a selection.

        A face that bounds none of the edges is the one at which the surface ends.
        """
        parts = sides.Parts([obj for obj, _ in chosen])
        found = [(link, each.shape) for link in chosen for each in parts.elements(*link)]
        edges = [shape for _, shape in found if shape.ShapeType == "Edge"]
        up_to = [
            link
            for link, shape in found
            if shape.ShapeType == "Face"
            and not any(each.isSame(edge) for each in shape.Edges for edge in edges)
        ]
        side = [link for link in chosen if link not in up_to]
        parts.side(side)
        if up_to:
            parts.face(up_to)
        return {SIDE: side, UP_TO: up_to}, {"until": BY_FACE if up_to else BY_LENGTH}

    @classmethod
    def compute(cls, model, numbers, values, progress):
        """Return the BlendedSurface; ``numbers``: of the Gathered. Any thread may call it."""
        given = {name: value for name, value in values.items() if name != "until"}
        if values["until"] == BY_FACE:
            given["length_mm"], given["to"] = None, numbers[UP_TO][1][0]
        edges, faces = numbers[SIDE]
        return model.extend_surface(edges, faces=faces, progress=progress, **given)

    @classmethod
    def levels(cls, values):
        """Return {property: (its name in texts, level that its seams must have)}."""
        return {SIDE: (SIDE, values["order"])}

    @classmethod
    def handles_of(cls, surface, values):
        """Return what ``handles`` returns: the length, along the middle of the surface."""
        if values["until"] == BY_FACE:
            return {}
        jet = surface.jet(0.5, 0.0)
        return {"length_mm": (jet.p.tolist(), (jet.v / numpy.linalg.norm(jet.v)).tolist())}

    @classmethod
    def ends(cls, found):
        """Return [(parameter across, text), ...] of the marks of a BlendedSurface."""
        return [(0.0, SIDE)]
