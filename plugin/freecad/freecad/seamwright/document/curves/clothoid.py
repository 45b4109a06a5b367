# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoid: curves whose curvature is linear in their length, through points or near edges.

The class path is written into documents: neither rename nor move it.
"""

import math
from typing import NamedTuple

from freecad.seamwright.document.curves import results
from freecad.seamwright.document.curves.arcs import FLATNESS, gather_planar
from freecad.seamwright.document.curves.curve import Curve, share_of
from freecad.seamwright.document.curves.plane import Plane
from freecad.seamwright.document.curves.samples import end_directions, runs_of
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import ANGLE, CHOICE, LENGTH, Option

ARC, NO_CURVATURE, DIRECTIONS = mark("Arc"), mark("No curvature"), mark("Given directions")

#: The part of the tolerance that is left to the splines that hold the clothoids.
SPLINE_SHARE = 0.1


def _directed(values):
    return values["ends"] == DIRECTIONS


class Clothoids(NamedTuple):
    """Chains of clothoids in a plane.

    ``parts``: for each curve the chains end to end, [(ClothoidChain, SplineWithin of it, distance
    of the chain from the input in mm), ...].
    """

    plane: Plane
    parts: list


class Clothoid(Curve):
    """Proxy of a Part::FeaturePython that holds clothoids."""

    Type = "Clothoid"
    LABEL = "Clothoid"
    ICON = "seamwright-clothoid"
    TIP = (
        "Lay clothoids through the selected points, or within a tolerance of the selected edges, "
        "wires or sketch of a plane: their curvature is continuous and linear in the length. Lines "
        "and arcs stay, with a clothoid between them."
    )
    NEEDS = "select points, edges, a wire or a sketch that lie in a plane"
    OPTIONS = (
        Option("Tolerance", "tolerance_mm", LENGTH, 0.01, "Tolerance",
               "Largest distance of the clothoids from edges, in mm; points are passed through",
               least=0.0),
        Option("Ends", "ends", CHOICE, ARC, "Ends of points",
               "What is given at the ends of open points: the directions of the circles through "
               "the three outer points, the curvature 0, or directions",
               choices=(ARC, NO_CURVATURE, DIRECTIONS)),
        Option("StartDirection", "start_deg", ANGLE, 0.0, "First direction",
               "Direction at the first point, against the first axis of the plane, in degrees",
               used=_directed),
        Option("EndDirection", "end_deg", ANGLE, 0.0, "Last direction",
               "Direction at the last point, against the first axis of the plane, in degrees",
               used=_directed),
        FLATNESS,
    )  # fmt: skip
    RESULTS = (
        ("Pieces", "App::PropertyInteger", "Number of clothoids, arcs and lines", "pieces"),
        ("LeastRadius", "App::PropertyLength", "Smallest radius, in mm; 0: straight", "radius_mm"),
        ("Distance", "App::PropertyLength", "Proven bound of the distance, in mm", "distance_mm"),
    )
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def gather(cls, module, shapes, values):
        """Return the Gathered of shapes in one plane."""
        return gather_planar(module, shapes, values["flatness_mm"])

    @classmethod
    def compute(cls, module, gathered, values, progress):
        """Return the Clothoids."""
        tolerance = values["tolerance_mm"]
        if tolerance <= 0:
            raise ValueError(tr(
                "the tolerance is 0: splines hold clothoids within a tolerance only"
            ))
        spline_mm = SPLINE_SHARE * tolerance
        if gathered.splines:
            count = len(gathered.splines)
            fits = [
                module.fit_clothoids(
                    each, tolerance - spline_mm, progress=share_of(progress, place, count)
                )
                for place, each in enumerate(gathered.splines)
            ]
            chains = [[(fit.chain, fit.distance_mm)] for fit in fits]
        else:
            chains = [[(chain, 0.0) for chain in _through(module, gathered, values)]]
        return Clothoids(
            gathered.plane,
            [
                [(chain, chain.bezier_spline(spline_mm), distance) for chain, distance in parts]
                for parts in chains
            ],
        )

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wires)."""
        wires = [
            results.wire_of(
                [
                    edge
                    for _, near, _ in parts
                    for edge in results.spline_edges(
                        module, results.raised(module, near.curve, found.plane)
                    )
                ]
            )
            for parts in found.parts
        ]
        every = [part for parts in found.parts for part in parts]
        pieces = [piece for chain, *_ in every for piece in chain.pieces]
        sharpest = max(
            max(abs(piece.curvature_at_per_mm(at)) for at in (0.0, piece.length_mm))
            for piece in pieces
        )
        radius = 1 / sharpest if sharpest > 0 else None
        report = {
            "pieces": len(pieces),
            "curves": len(found.parts),
            "length_mm": sum(chain.length_mm for chain, *_ in every),
            "least_radius_mm": radius,
            "radius_mm": radius or 0.0,
            "distance_mm": max(distance + near.distance_mm for _, near, distance in every),
        }
        return report, results.together(wires)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.clothoid_text(report)


def _through(module, gathered, values):
    """Return the ClothoidChains through points, one for each run between corners."""
    runs = runs_of(module, gathered.points, gathered.closed)
    ends = [{} for _ in runs]
    if values["ends"] != NO_CURVATURE:
        ends = [end_directions(*run) for run in runs]
    if _directed(values) and not gathered.closed:
        ends[0]["start_direction_rad"] = math.radians(values["start_deg"])
        ends[-1]["end_direction_rad"] = math.radians(values["end_deg"])
    return [
        module.clothoid_spline(points, closed=closed, **given).chain
        for (points, closed), given in zip(runs, ends)
    ]
