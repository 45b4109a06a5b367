# SPDX-License-Identifier: LGPL-2.1-or-later
"""Umbrella: faces around a point, one between each two neighbouring edges that end there.

The class path is written into documents: neither rename nor move it.
"""

import math
import re
from typing import Any, List, NamedTuple

import numpy

from freecad.seamwright.document.curves import inputs
from freecad.seamwright.document.surfaces import outer
from freecad.seamwright.document.surfaces.free import SOURCES, FreeSurface
from freecad.seamwright.document.surfaces.spoke import fitted
from freecad.seamwright.document.surfaces.surface import TOLERANCES
from freecad.seamwright.plain import surface_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import ANGLE, CHOICE, COUNT, FLAG, LENGTH, Option
from freecad.seamwright.plain.summary import counted

PATCHES, TRIANGLES = mark("Four-sided"), mark("Three-sided")
KINDS = {PATCHES: "patch", TRIANGLES: "triangle"}
ORDERS = ("G1", "G2")

BOUNDARY = "Boundary"

#: A sector from which on edges are suggested to be an open fan: faces need less than 180 degrees.
LARGEST_SECTOR_DEG = 179.0

#: Ends of edges that faces share are sewn within this, in mm; they are equal up to rounding.
SEW_MM = 1e-6


#: Parameters of a spoke in the middle of the edges that may lie on it: halves, or all of it.
PLACES = 0.25, 0.5, 0.75


class Spokes(NamedTuple):
    """Curves from one point, in their order around it.

    ``curves``: BezierCurves. ``numbers``: their places in the selection, from 1. ``after_deg``: the
    sector behind each. ``fit_mm``: the largest distance of a curve from its edge. ``bounds``: the
    given outer edges of the sector behind each, none, one or two, as the kernel takes them.
    """

    curves: List[Any]
    numbers: List[int]
    after_deg: List[float]
    fit_mm: float
    bounds: List[Any]


class Found(NamedTuple):
    """The spokes in the order of the members, and the Umbrella."""

    spokes: Spokes
    umbrella: Any


def _is_g1(values):
    """Return whether the {argument: value} are of faces that join G1."""
    return values["order"] == ORDERS[0]


class Umbrella(FreeSurface):
    """Proxy of a Part::FeaturePython that holds faces around a point."""

    Type = "Umbrella"
    LABEL = "Umbrella"
    ICON = "seamwright-umbrella"
    TIP = (
        "Make faces around a point from three or more selected edges that end there with tangents "
        "in one plane: a face between each two neighbouring edges. All of them have common tangent "
        "planes along the edges, or with G2 common curvature, too."
    )
    NEEDS = "select three or more edges that end in one point"
    LINKS = (
        *FreeSurface.LINKS,
        (BOUNDARY, "Outer boundary (may be empty)",
         "Edges at which the faces end: one or two from the end of an edge to that of the next"),
    )  # fmt: skip
    OPTIONS = (
        Option("Order", "order", CHOICE, ORDERS[0], "Faces join with",
               "The continuity of the faces across the edges: tangent planes (G1) or curvature, "
               "too (G2)", choices=ORDERS),
        Option("Members", "members", CHOICE, PATCHES, "Faces", "Four-sided faces, or three-sided "
               "ones, which are three faces each", choices=tuple(KINDS), used=_is_g1),
        Option("Open", "open", FLAG, False, "Leave the largest sector open",
               "Make no face in the largest sector between two edges"),
        Option("Degree", "degree", COUNT, 0, "Degree", "Of all faces; 0: the lowest that suffices",
               least=0.0, zero=mark("automatic")),
        Option("Fit", "fit_mm", LENGTH, 1e-3, "Curves within",
               "Largest distance of the curves that take the place of edges which are no single "
               "polynomial curve, such as arcs, in mm", least=1e-9),
        Option("Rational", "rational", FLAG, False, "Keep arcs exactly",
               "Arcs and other rational edges stay as they are, and the faces are rational",
               used=_is_g1),
        Option("MaxMove", "max_move_mm", LENGTH, 0.0, "Largest move",
               "No pole may move further than this, in mm; 0: no limit", least=0.0,
               zero=mark("no limit")),
        Option("Meet", "meet_mm", LENGTH, 1e-4, "Edges meet within",
               "Largest distance of the ends of the edges from their mean, in mm", least=0.0),
        Option("Flat", "flat_deg", ANGLE, 0.01, "Tangents in one plane within",
               "Largest angle of a tangent with the plane of all tangents, in degrees; the edges "
               "are turned into that plane", least=0.0),
        *TOLERANCES[:2],
        TOLERANCES[2]._replace(used=lambda values: not _is_g1(values)),
    )  # fmt: skip
    RESULTS = (
        *FreeSurface.RESULTS,
        ("MaxCurvature", "App::PropertyFloat",
         "Upper bound of the relative differences of curvature of the seams; 0 for G1",
         "curvature_rel"),
        ("Moved", "App::PropertyLength", "No pole of an edge moved further, in mm", "moved_mm"),
    )  # fmt: skip
    INPUTS = (SOURCES, BOUNDARY, *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values, boundary=()):
        """Return the Spokes; ``boundary``: the shapes of the outer edges."""
        edges = inputs.edges_of(shapes)
        if len(edges) < 3:
            raise ValueError(tr("{edges} chosen: choose three or more").format(
                edges=counted(len(edges), "edge")
            ))
        _check_kinds(values, boundary)
        rational = values["rational"] and _is_g1(values)
        at_lasts = _common_ends(edges, values["meet_mm"])
        found = [
            fitted(module, edge, _name(number), at_last, values["fit_mm"], rational)
            for number, (edge, at_last) in enumerate(zip(edges, at_lasts), 1)
        ]
        spokes = _around([curve for curve, _ in found], max(distance for _, distance in found))
        if not boundary:
            return spokes
        bounds, fit_mm = outer.edges_between(module, spokes, inputs.edges_of(boundary), values)
        return spokes._replace(bounds=bounds, fit_mm=max(spokes.fit_mm, fit_mm))

    @classmethod
    def gather_all(cls, module, shapes, values):
        """Return what ``gather`` returns, for the {property: shapes} of LINKS."""
        return cls.gather(module, shapes[SOURCES], values, shapes[BOUNDARY])

    @classmethod
    def check(cls, name, chosen):
        """Raise SourceError or ValueError where a property cannot have these links."""
        if name == SOURCES:
            super().check(name, chosen)
        elif chosen and not inputs.edges_of(inputs.shapes_of(chosen)):
            raise ValueError(tr("choose edges, or nothing"))

    @classmethod
    def suggested(cls, gathered):
        """Return that a sector for which a face is impossible stays open."""
        return {"open": True} if max(gathered.after_deg) > LARGEST_SECTOR_DEG else {}

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Found."""
        spokes = gathered
        if values["open"]:
            spokes = _turned(spokes, 1 + int(numpy.argmax(spokes.after_deg)))
            if spokes.bounds[-1]:
                raise ValueError(
                    tr(
                        "the outer boundary has edges in the sector that stays open: choose edges "
                        "of the other sectors"
                    )
                )
        if values["flat_deg"] > 90:
            raise ValueError(
                tr("\u201c{label}\u201d is {angle:g}\u00b0: at most 90\u00b0 is needed").format(
                    label=tr("Tangents in one plane within"), angle=values["flat_deg"]
                )
            )
        given = {
            "closed": not values["open"],
            "degree": values["degree"] or None,
            "gap_mm": values["meet_mm"],
            "flat_rad": math.radians(values["flat_deg"]),
        }
        try:
            if _is_g1(values):
                umbrella = module.umbrella(spokes.curves, **given, **_members(spokes, values))
            else:
                umbrella = module.g2_umbrella(spokes.curves, **given)
        except ValueError as error:
            raise ValueError(_with_edges(str(error), spokes.numbers)) from None
        _check_moves(spokes, umbrella, values)
        return Found(spokes, umbrella)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, faces)."""
        umbrella, numbers = found.umbrella, found.spokes.numbers
        model = module.Model.from_patches(umbrella.members, sew_mm=SEW_MM)
        shape = model.to_freecad()
        spokes = [numpy.asarray(spoke.point(numpy.array(PLACES))) for spoke in umbrella.spokes]
        seams = [
            {**_named(seam, shape, spokes, numbers), "target": values["order"]}
            for seam in model.analyze().to_dict()["seams"]
        ]
        report = {
            **cls.judged(seams, values),
            "members": len(umbrella.members),
            "faces": len(shape.Faces),
            "moved_mm": umbrella.spoke_move_mm,
            "moved_most": _moved_most(found.spokes, umbrella),
            "fit_mm": found.spokes.fit_mm,
            "order": values["order"],
            "outer_edges": sum(map(len, found.spokes.bounds)),
            "marks": [
                (points[1].tolist(), tr("Edge {number}").format(number=number))
                for points, number in zip(spokes, numbers)
            ],
        }
        return report, shape

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return surface_text.umbrella_summary(report)


def _name(number):
    """Return the name of an edge of the selection within a sentence."""
    return tr("edge {number}").format(number=number)


def _check_kinds(values, boundary):
    """Raise ValueError for what only faces that join G1 can have."""
    if _is_g1(values):
        return
    if values["members"] != PATCHES:
        raise ValueError(
            tr("three-sided faces join with G1 only: choose four-sided faces, or G1")
        )
    if boundary:
        raise ValueError(
            tr(
                "with G2 the outer boundary is found, and cannot be given: choose G1, or take the "
                "edges out of the outer boundary"
            )
        )


def _members(spokes, values):
    """Return the arguments of the kernel for the kinds of faces and their outer edges."""
    bounds = spokes.bounds[: len(spokes.curves) - bool(values["open"])]
    own = {0: KINDS[values["members"]], 1: "triangle", 2: "patch"}
    pairs = [(*bound, None, None)[:2] if bound else None for bound in bounds]
    return {
        "kinds": [own[len(bound)] for bound in bounds],
        "boundary": pairs if any(bounds) else None,
    }


def _check_moves(spokes, umbrella, values):
    """Raise ValueError where a pole of an edge moved further than is allowed."""
    moved, most = umbrella.spoke_move_mm, values["max_move_mm"]
    if not 0 < most < moved:
        return
    need = tr("that the faces close around the point")
    if not _is_g1(values):
        need = tr("that all edges have the curvature of one surface at the point")
    raise ValueError(
        tr(
            "{order} needs {need}: poles would move by {moved} mm, edge {number} most, and "
            "{most} mm are allowed: change the edges, or allow more"
        ).format(
            order=values["order"],
            need=need,
            moved="%.3g" % moved,
            number=_moved_most(spokes, umbrella),
            most="%g" % most,
        )
    )


def _moved_most(spokes, umbrella):
    """Return the number of the edge that moved most."""
    places = numpy.array(PLACES)
    moves = [
        numpy.linalg.norm(numpy.subtract(old.point(places), new.point(places)), axis=1).max()
        for old, new in zip(spokes.curves, umbrella.spokes)
    ]
    return spokes.numbers[int(numpy.argmax(moves))]


def _with_edges(text, numbers):
    """Return a sentence of the kernel with the numbers of edges in place of those of spokes."""

    def edge(found):
        numbered = [str(numbers[int(each) % len(numbers)]) for each in found.groups() if each]
        return "edge " + " to ".join(numbered)

    text = re.sub(r"sector \d+, from spoke (\d+) to (\d+)", r"the sector from spoke \1 to \2", text)
    text = re.sub(r"\bspoke (\d+)(?: to (\d+))?", edge, text)
    return re.sub(r"\bspoke(s?)\b", r"edge\1", text)


def _common_ends(edges, gap_mm):
    """Return for each edge whether the point in which all of them end is its last one."""
    ends = [inputs.ends_of(edge) for edge in edges]
    for point in ends[0]:
        distances = [[point.distanceToPoint(each) for each in own] for own in ends]
        if max(map(min, distances)) <= 2 * max(gap_mm, inputs.GAP_MM):
            return [own[1] < own[0] for own in distances]
    raise ValueError(
        tr("the {edges} edges do not end in one point: choose edges that meet in a vertex").format(
            edges=len(edges)
        )
    )


def _around(curves, fit_mm):
    """Return the Spokes of curves from one point in any order."""
    tangents = numpy.array([numpy.asarray(curve.derivatives(0.0, 1))[1] for curve in curves])
    sizes = numpy.linalg.norm(tangents, axis=1)
    if sizes.min() == 0:
        raise ValueError(tr("an edge has no tangent at the point: choose other edges"))
    tangents = tangents / sizes[:, None]
    axes = numpy.linalg.svd(tangents)[2][:2]
    angles = numpy.arctan2(tangents @ axes[1], tangents @ axes[0]) % (2 * math.pi)
    order = numpy.argsort(angles)
    after = numpy.diff(angles[order], append=angles[order[0]] + 2 * math.pi)
    spokes = Spokes(
        [curves[place] for place in order],
        [int(place) + 1 for place in order],
        numpy.degrees(after).tolist(),
        fit_mm,
        [[] for _ in order],
    )
    return _turned(spokes, spokes.numbers.index(1))


def _turned(spokes, first):
    """Return the Spokes that begin with another one."""
    first = first % len(spokes.curves)
    return spokes._replace(
        **{
            name: getattr(spokes, name)[first:] + getattr(spokes, name)[:first]
            for name in ("curves", "numbers", "after_deg", "bounds")
        }
    )


def _named(seam, shape, spokes, numbers):
    """Return a seam with the edge of the selection along which it runs.

    Seams within a three-sided face run along no edge. The sides of such a face have two seams each.
    ``spokes``: their points at PLACES.
    """
    edge = shape.Edges[seam["edges"][0] - 1]
    middle = numpy.array(edge.valueAt(sum(edge.ParameterRange) / 2))
    distances = numpy.linalg.norm(numpy.array(spokes) - middle, axis=2).min(axis=1)
    place = int(numpy.argmin(distances))
    along = distances[place] <= 1e-6 * max(1.0, edge.Length)
    name = "Edge %d" % numbers[place] if along else mark("inside a face")
    return {**seam, "side": mark("Edge") if along else mark("Face"), "name": name}
