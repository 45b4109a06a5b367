# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature Map: curvature of faces, or their smallest radius, in colours.

The class path is written into documents: neither rename nor move it.
"""

from freecad.seamwright.document.maps.surface_map import SurfaceMap, joined, weights
from freecad.seamwright.plain import map_text, maps, ramps
from freecad.seamwright.plain.language import mark, tr
from freecad.seamwright.plain.options import CHOICE, FLOAT, Option

AUTOMATIC, GIVEN = mark("Automatic"), mark("Given")


def given_range(values):
    """Return (low, high) of {argument: value}, or None where it is automatic. Raises ValueError."""
    if values["range"] != GIVEN:
        return None
    low, high = values["low"], values["high"]
    if not low < high:
        raise ValueError(tr(
            "the range goes from {low:g} to {high:g}: give a larger upper end"
        ).format(low=low, high=high))
    return low, high


RANGE = (
    Option("Range", "range", CHOICE, AUTOMATIC, "Range",
           "Automatic: the colours cover all values but the outermost 2 % of the area",
           choices=(AUTOMATIC, GIVEN)),
    Option("Low", "low", FLOAT, 0.0, "Lowest", "The value that has the first colour",
           used=lambda values: values["range"] == GIVEN),
    Option("High", "high", FLOAT, 1.0, "Highest", "The value that has the last colour",
           used=lambda values: values["range"] == GIVEN),
)  # fmt: skip


class CurvatureMap(SurfaceMap):
    """Proxy of a map of curvature."""

    Type = "CurvatureMap"
    LABEL = "Curvature Map"
    ICON = "seamwright-curvature-map"
    TIP = (
        "Colour the faces of the selected objects by their curvature: mean, Gaussian or largest "
        "curvature, or smallest radius. With nothing selected, all visible objects are coloured."
    )
    OPTIONS = (
        Option("Quantity", "quantity", CHOICE, maps.MEAN, "Quantity",
               "Mean: half the sum of the principal curvatures. Gaussian: their product. Largest: "
               "the larger one without its sign. Smallest radius: 1 by the largest curvature",
               choices=maps.QUANTITIES),
        *RANGE,
    )  # fmt: skip
    INPUTS = ("Sources", *(option.name for option in OPTIONS))

    @classmethod
    def measured(cls, mesh, values):
        """Return the curvature of each point."""
        return maps.curvature_values(values["quantity"], mesh.principal_per_mm)

    @classmethod
    def look(cls, found, values):
        """Return the Look of a list of Values."""
        return ramps.curvature_look(
            values["quantity"], joined(found), weights(found), given_range(values)
        )

    @classmethod
    def report(cls, found, values):
        """Return the extremes and their unit."""
        given_range(values)
        report = super().report(found, values)
        return {**report, "quantity": values["quantity"], "unit": maps.UNITS[values["quantity"]]}

    @classmethod
    def marks(cls, report):
        """Return [(point, text)]: the strongest curvature."""
        if report.get("undefined", True):
            return []
        names = ("least",) if report["quantity"] == maps.RADIUS else ("least", "largest")
        strongest = max(names, key=lambda name: abs(report[name]))
        if not report[strongest]:
            return []
        text = "%s %s" % (ramps.figure(report[strongest]), report["unit"])
        return [(report["%s_at" % strongest], text)]

    @classmethod
    def text(cls, report):
        """Return the summary of a report."""
        return map_text.curvature_text(report)
