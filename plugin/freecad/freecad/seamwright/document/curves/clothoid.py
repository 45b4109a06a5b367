# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoid: curves whose curvature is linear in their length, through points or near edges.

The class path is written into documents: neither rename nor move it.
"""

import math
from typing import Any, NamedTuple

from freecad.seamwright.document.curves import results
from freecad.seamwright.document.curves.arcs import FLATNESS, gather_planar
from freecad.seamwright.document.curves.curve import Curve
from freecad.seamwright.document.curves.plane import Plane
from freecad.seamwright.plain import curve_text
from freecad.seamwright.plain.options import ANGLE, CHOICE, LENGTH, Option

NO_CURVATURE, DIRECTIONS = "No curvature", "Given directions"

#: The part of the tolerance that is left to the splines that hold the clothoids.
SPLINE_SHARE = 0.1


def _directed(values):
    return values["ends"] == DIRECTIONS


class Clothoids(NamedTuple):
    """Chains of clothoids in a plane: [(ClothoidChain, distance from the input in mm), ...]."""

    plane: Plane
    chains: list
    splines: Any


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
        Option("Ends", "ends", CHOICE, NO_CURVATURE, "Ends of points",
               "What is given at the ends of an open sequence of points",
               choices=(NO_CURVATURE, DIRECTIONS)),
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
            raise ValueError("the tolerance is 0: splines hold clothoids within a tolerance only")
        spline_mm = SPLINE_SHARE * tolerance
        if gathered.splines:
            fits = [
                module.fit_clothoids(each, tolerance - spline_mm) for each in gathered.splines
            ]
            chains = [(fit.chain, fit.distance_mm) for fit in fits]
        else:
            ends = {}
            if _directed(values) and not gathered.closed:
                ends = {
                    "start_direction_rad": math.radians(values["start_deg"]),
                    "end_direction_rad": math.radians(values["end_deg"]),
                }
            found = module.clothoid_spline(gathered.points, closed=gathered.closed, **ends)
            chains = [(found.chain, 0.0)]
        splines = [chain.bezier_spline(spline_mm) for chain, _ in chains]
        return Clothoids(gathered.plane, chains, splines)

    @classmethod
    def build(cls, module, found, values):
        """Return (report, wires)."""
        wires = [
            results.wire_of(
                results.spline_edges(module, results.raised(module, near.curve, found.plane))
            )
            for near in found.splines
        ]
        pieces = [piece for chain, _ in found.chains for piece in chain.pieces]
        sharpest = max(
            max(abs(piece.curvature_at_per_mm(at)) for at in (0.0, piece.length_mm))
            for piece in pieces
        )
        radius = 1 / sharpest if sharpest > 0 else None
        report = {
            "pieces": len(pieces),
            "length_mm": sum(chain.length_mm for chain, _ in found.chains),
            "least_radius_mm": radius,
            "radius_mm": radius or 0.0,
            "distance_mm": max(
                distance + near.distance_mm
                for (_, distance), near in zip(found.chains, found.splines)
            ),
        }
        return report, results.together(wires)

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return curve_text.clothoid_text(report)
